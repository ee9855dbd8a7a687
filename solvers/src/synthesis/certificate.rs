//! What holds a polished design where it is.
//!
//! At a best design the slopes of the values that are largest, of the conditions of which nothing is left and of the bounds that
//! are reached balance. Where they are as many as there are directions they hold the design alone. In directions that they leave
//! free, the Lagrangian must curve upwards (R. Fletcher: *Practical methods of optimization*, 2nd ed., 1987, sections 9.3
//! and 14.2).

use nalgebra::DMatrix;

use super::local::{Aim, Local, Look};
use super::polish::Polished;

/// What pulls by less than this part of what pulls most holds nothing.
const SLIGHT: f64 = 1e-6;
/// What is away from what is largest by more than this part, or from a condition by more, over the steepest one, holds nothing.
const NEAR: f64 = 1e-5;
/// Directions along which what holds changes by less than this part are free.
const FREE: f64 = 1e-6;
/// Part of the ranges over which a curvature is seen.
const BESIDE: f64 = 1e-4;

/// What holds a design, each with its multiplier.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Certificate {
    /// Values that are as large as the largest one. Of those that count by their squares none is: all of them pull.
    pub values: Vec<(usize, f64)>,
    /// Conditions of which nothing is left.
    pub conditions: Vec<(usize, f64)>,
    /// Numbers that are at a bound.
    pub bounds: Vec<(usize, f64)>,
    /// How many directions all these leave free.
    pub free: usize,
    /// The least curvature in these, per range squared: above zero if no neighbour is better. None where no direction is free,
    /// or a neighbour cannot be judged.
    pub curvature: Option<f64>,
    /// The direction of this curvature, of length one, in units of the ranges: where it is below zero, a better design lies farther
    /// along it, forth or back.
    pub direction: Vec<f64>,
}

/// Looks at what holds a polished design; none where it cannot be judged.
pub fn certify(local: &mut dyn Local, aim: Aim, polished: &Polished) -> Option<Certificate> {
    let sought = local.sought().to_vec();
    let n = sought.len();
    let mut look = |design: &[f64]| -> Option<Look> {
        let look = local.look(design)?;
        look.is_sound(n).then(|| look.scaled(&sought))
    };
    let here = look(&polished.design)?;
    let rows: Vec<&[f64]> = here.slopes.chunks_exact(n).collect();
    let size = |row: &[f64]| row.iter().map(|one| one.abs()).sum::<f64>();
    let pulls: Vec<f64> =
        polished.multipliers.iter().zip(&rows).map(|(one, row)| one.abs() * size(row)).collect();
    let bounds = polished.bounds.iter().map(|one| one.abs());
    let most = pulls.iter().copied().chain(bounds).fold(0.0, f64::max);
    let holds = |pull: f64| pull > SLIGHT * most;

    // Next to what is largest stand others, and how far away they are the multipliers do not say to the last digit.
    let count = here.values.len();
    let first = aim.parts(&here.values).0;
    let largest = first.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let is_near = |index: usize| match index.checked_sub(count) {
        None => largest - here.values[index] <= NEAR * largest.abs(),
        Some(condition) => here.conditions[condition] <= NEAR,
    };
    let held = |range: std::ops::Range<usize>| -> Vec<(usize, f64)> {
        let from = range.start;
        let held = range.filter(|index| holds(pulls[*index]) && is_near(*index));
        held.map(|index| (index - from, polished.multipliers[index])).collect()
    };
    let mut certificate = Certificate {
        values: held(0..first.len()),
        conditions: held(count..rows.len()),
        ..Certificate::default()
    };
    let at_bound = polished.bounds.iter().enumerate().filter(|(_, one)| holds(one.abs()));
    certificate.bounds = at_bound.map(|(index, one)| (index, *one)).collect();

    let free = certificate.free(&rows, count);
    certificate.free = free.len();
    let beside = |way: f64, direction: &[f64]| -> Vec<f64> {
        let shift = direction.iter().zip(&sought).map(|(one, range)| way * one * range.width());
        polished.design.iter().zip(shift).map(|(one, shift)| one + shift).collect()
    };
    let pull = |look: Option<Look>| -> Option<Vec<f64>> {
        let (look, mut multipliers) = (look?, polished.multipliers.clone());
        multipliers[first.len()..count].copy_from_slice(aim.parts(&look.values).1);
        Some(look.pull(&multipliers, n))
    };
    let mut columns = Vec::with_capacity(free.len());
    for direction in &free {
        let ends = [-BESIDE, BESIDE].map(|way| pull(look(&beside(way, direction))));
        let [Some(behind), Some(ahead)] = ends else { return Some(certificate) };
        columns.push(ahead.iter().zip(behind).map(|(a, b)| (a - b) / (2.0 * BESIDE)).collect());
    }
    if let Some((curvature, direction)) = least(&free, &columns) {
        (certificate.curvature, certificate.direction) = (Some(curvature), direction);
    }
    Some(certificate)
}

impl Certificate {
    /// The directions, of length one, in which nothing that holds changes.
    fn free(&self, rows: &[&[f64]], values: usize) -> Vec<Vec<f64>> {
        let n = rows.first().map_or(0, |row| row.len());
        let length = |row: &[f64]| row.iter().map(|one| one * one).sum::<f64>().sqrt();
        // Each with what its length compares with.
        let mut held: Vec<(Vec<f64>, f64)> = Vec::new();
        if let Some(((first, _), others)) = self.values.split_first() {
            // Values that fall together are no hold, nor is what rounding leaves between two places that are one.
            let difference = |(other, _): &(usize, f64)| {
                let row = rows[*other].iter().zip(rows[*first]).map(|(a, b)| a - b).collect();
                (row, f64::max(length(rows[*other]), length(rows[*first])))
            };
            held.extend(others.iter().map(difference));
        }
        let conditions = self.conditions.iter().map(|(index, _)| rows[values + index]);
        held.extend(conditions.map(|row| (row.to_vec(), length(row))));
        for (index, _) in &self.bounds {
            let mut row = vec![0.0; n];
            row[*index] = 1.0;
            held.push((row, 1.0));
        }
        // A square matrix has all directions among its singular vectors.
        let mut matrix = DMatrix::zeros(held.len().max(n), n);
        for (index, (row, length)) in held.iter().enumerate() {
            for (column, entry) in row.iter().enumerate() {
                matrix[(index, column)] = if *length > 0.0 { entry / length } else { 0.0 };
            }
        }
        let factors = matrix.svd(false, true);
        let Some(directions) = factors.v_t else { return Vec::new() };
        let free = (0..n).filter(|index| factors.singular_values[*index] <= FREE);
        free.map(|index| directions.row(index).iter().copied().collect()).collect()
    }
}

/// The least curvature in some directions, of which each changes the slope so, and its direction.
fn least(directions: &[Vec<f64>], columns: &[Vec<f64>]) -> Option<(f64, Vec<f64>)> {
    let count = directions.len();
    if count == 0 {
        return None;
    }
    let along = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let entry = |row: usize, column: usize| {
        let other = along(&directions[column], &columns[row]);
        0.5 * (along(&directions[row], &columns[column]) + other)
    };
    let factors = DMatrix::from_fn(count, count, entry).symmetric_eigen();
    let (place, curvature) = factors.eigenvalues.argmin();
    let mut sum = vec![0.0; directions[0].len()];
    for (direction, part) in directions.iter().zip(factors.eigenvectors.column(place).iter()) {
        for (sum, entry) in sum.iter_mut().zip(direction) {
            *sum += part * entry;
        }
    }
    Some((curvature, sum))
}
