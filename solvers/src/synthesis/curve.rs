//! The curvature of a Lagrangian, learnt from how its slope changes along steps.

use nalgebra::DMatrix;

/// A symmetric matrix that stays positive definite: Powell's damped formula (*A fast algorithm for nonlinearly constrained
/// optimization calculations*, 1978). It is zero until the first step.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    count: usize,
    /// Row by row.
    entries: Vec<f64>,
    is_known: bool,
}

impl Curve {
    pub fn new(count: usize) -> Self {
        Self { count, entries: vec![0.0; count * count], is_known: false }
    }

    /// That of a matrix, row by row. Directions in which it bends downwards count as straight.
    pub fn seen(count: usize, entries: &[f64]) -> Self {
        let mut factors = DMatrix::from_row_slice(count, count, entries).symmetric_eigen();
        factors.eigenvalues.iter_mut().for_each(|one| *one = one.max(0.0));
        let matrix = factors.recompose();
        Self { count, entries: matrix.transpose().as_slice().to_vec(), is_known: true }
    }

    /// An entry.
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.count + column]
    }

    /// Times a step.
    pub fn times(&self, step: &[f64]) -> Vec<f64> {
        self.entries.chunks_exact(self.count).map(|row| dot(row, step)).collect()
    }

    /// Learns that along a step the slope changed so.
    pub fn learn(&mut self, step: &[f64], change: &[f64]) {
        let (along, square) = (dot(step, change), dot(change, change));
        if !self.is_known {
            // What is not curved upwards says nothing of the size of a curvature.
            if along <= 1e-8 * (dot(step, step) * square).sqrt() {
                return;
            }
            for k in 0..self.count {
                self.entries[k * self.count + k] = square / along;
            }
            self.is_known = true;
        }
        let pulled = self.times(step);
        let known = dot(step, &pulled);
        if known <= 0.0 {
            return;
        }
        let share = match along < 0.2 * known {
            true => 0.8 * known / (known - along),
            false => 1.0,
        };
        let damped: Vec<f64> =
            change.iter().zip(&pulled).map(|(y, b)| share * y + (1.0 - share) * b).collect();
        let along = dot(step, &damped);
        for (row, entries) in self.entries.chunks_exact_mut(self.count).enumerate() {
            for (column, entry) in entries.iter_mut().enumerate() {
                *entry +=
                    damped[row] * damped[column] / along - pulled[row] * pulled[column] / known;
            }
        }
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
