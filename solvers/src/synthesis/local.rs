//! A design and its neighbours: values and conditions with their slopes.

use super::curve::dot;
use super::problem::Sought;

/// What is to be small: the largest of some values, and half the sum of the squares of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Aim {
    /// How many of the values, the last ones, count by their squares; all of them where there are not as many.
    pub squares: usize,
}

/// What a design says, with slopes by each of its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Look {
    /// What is to be small.
    pub values: Vec<f64>,
    /// What must not be below zero.
    pub conditions: Vec<f64>,
    /// Rows of slopes: of the values, then of the conditions.
    pub slopes: Vec<f64>,
}

/// What designs are polished by.
pub trait Local {
    /// The numbers that are sought.
    fn sought(&self) -> &[Sought];

    /// Looks at a design; none where it cannot be judged. Values and conditions are as many for all designs, and each
    /// means the same.
    fn look(&mut self, design: &[f64]) -> Option<Look>;

    /// How the Lagrangian of these multipliers is bent where was looked last, row by row; none where that is not known.
    fn curvature(&mut self, multipliers: &[f64]) -> Option<Vec<f64>> {
        let _ = multipliers;
        None
    }

    /// Whether nobody waits for a better design any more.
    fn is_stopped(&self) -> bool {
        false
    }
}

impl Aim {
    /// The largest of the values alone.
    pub const LARGEST: Self = Self { squares: 0 };

    /// The values of which the largest counts, and those that count by their squares. So it is with rows of slopes.
    pub(super) fn parts<T>(self, values: &[T]) -> (&[T], &[T]) {
        values.split_at(values.len().saturating_sub(self.squares))
    }

    /// What is made small.
    pub(super) fn of(self, values: &[f64]) -> f64 {
        let (first, squares) = self.parts(values);
        let largest = first.iter().copied().reduce(f64::max).unwrap_or(0.0);
        largest + 0.5 * squares.iter().map(|value| value * value).sum::<f64>()
    }
}

impl Look {
    /// What slopes alone say of values and conditions after a step.
    pub(super) fn along(&self, way: &[f64]) -> Self {
        let rows = self.slopes.chunks_exact(way.len());
        let all = self.values.iter().chain(&self.conditions).zip(rows);
        let mut values: Vec<f64> = all.map(|(one, row)| one + dot(row, way)).collect();
        let conditions = values.split_off(self.values.len());
        Self { values, conditions, slopes: self.slopes.clone() }
    }

    /// By how much the condition that is missed most is missed.
    pub(super) fn missed(&self) -> f64 {
        self.conditions.iter().fold(0.0, |most, one| f64::max(most, -one))
    }

    /// Whether it has values, rows of slopes for everything, and nothing that is no number.
    pub(super) fn is_sound(&self, count: usize) -> bool {
        let rows = self.values.len() + self.conditions.len();
        if self.values.is_empty() || self.slopes.len() != rows * count {
            return false;
        }
        let all = self.values.iter().chain(&self.conditions).chain(&self.slopes);
        all.into_iter().all(|one| one.is_finite())
    }

    /// The slopes in units of the ranges.
    pub(super) fn scaled(mut self, sought: &[Sought]) -> Self {
        for row in self.slopes.chunks_exact_mut(sought.len()) {
            for (slope, one) in row.iter_mut().zip(sought) {
                *slope *= one.width();
            }
        }
        self
    }

    /// How much a condition may change within a region.
    pub(super) fn reach(&self, count: usize, region: f64) -> f64 {
        let rows = self.slopes[self.values.len() * count..].chunks_exact(count);
        let sums = rows.map(|row| row.iter().map(|one| one.abs()).sum());
        region * sums.fold(0.0, f64::max)
    }

    /// How much steeper the values are than the conditions.
    pub(super) fn steepness(&self, count: usize) -> f64 {
        let steepest = |rows: &[f64]| {
            let sums = rows.chunks_exact(count).map(|row| row.iter().map(|one| one.abs()).sum());
            sums.fold(0.0, f64::max)
        };
        let (values, conditions) = self.slopes.split_at(self.values.len() * count);
        match (steepest(values), steepest(conditions)) {
            (values, conditions) if values > 0.0 && conditions > 0.0 => values / conditions,
            _ => 1.0,
        }
    }

    /// The sum of all rows of slopes, each times its multiplier: those of the values, less those of the conditions.
    pub(super) fn pull(&self, multipliers: &[f64], count: usize) -> Vec<f64> {
        let mut sum = vec![0.0; count];
        for (index, (row, multiplier)) in
            self.slopes.chunks_exact(count).zip(multipliers).enumerate()
        {
            let sign = if index < self.values.len() { 1.0 } else { -1.0 };
            for (sum, slope) in sum.iter_mut().zip(row) {
                *sum += sign * multiplier * slope;
            }
        }
        sum
    }
}
