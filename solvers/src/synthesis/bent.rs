//! A neighbourhood in which every value and condition is a quadratic: what is best there is sought without a look at a design.
//!
//! Slopes of all of them beside a design, one number after the other, say how each is bent. A step to the best of the quadratics
//! goes as far as third derivatives permit, where one of linear parts goes as far as second ones do.

use super::curve::dot;
use super::local::{Aim, Local, Look};
use super::polish::from_region;
use super::problem::Sought;
use super::programme::Step;

/// Looks at the quadratics at most.
const LOOKS: u64 = 60;
/// First step, as a part of the region.
const REGION: f64 = 0.25;

/// How values, then conditions, are bent about a design: for each a matrix, row by row, in units of the ranges.
#[derive(Clone, Debug)]
pub(super) struct Bends {
    count: usize,
    matrices: Vec<f64>,
}

impl Bends {
    /// From the slopes here, and beside it along each number, with how far.
    pub fn seen(here: &Look, beside: &[(f64, Look)]) -> Self {
        let count = beside.len();
        let slope = |row: usize, along: usize, by: usize| {
            let (way, there) = &beside[along];
            (there.slopes[row * count + by] - here.slopes[row * count + by]) / way
        };
        let rows = here.slopes.len() / count;
        let mut matrices = Vec::with_capacity(rows * count * count);
        for row in 0..rows {
            for a in 0..count {
                matrices.extend((0..count).map(|b| 0.5 * (slope(row, a, b) + slope(row, b, a))));
            }
        }
        Self { count, matrices }
    }

    /// Learns from the slopes at both ends of a step: the least change that explains them (M. J. D. Powell's symmetric form of
    /// Broyden's formula).
    pub fn learn(&mut self, way: &[f64], from: &Look, to: &Look) {
        let (count, length) = (self.count, dot(way, way));
        for row in 0..self.matrices.len() / (count * count) {
            let slopes = |look: &Look| look.slopes[row * count..][..count].to_vec();
            let changes = slopes(to).into_iter().zip(slopes(from)).map(|(to, from)| to - from);
            let left = changes.zip(self.along(row, way)).map(|(change, known)| change - known);
            let left: Vec<f64> = left.map(|one| one / length).collect();
            let along = dot(&left, way) / length;
            for a in 0..count {
                for b in 0..count {
                    let entry = &mut self.matrices[(row * count + a) * count + b];
                    *entry += left[a] * way[b] + way[a] * left[b] - along * way[a] * way[b];
                }
            }
        }
    }

    /// How one of them is bent.
    fn of(&self, row: usize) -> &[f64] {
        let size = self.count * self.count;
        &self.matrices[row * size..][..size]
    }

    /// How a slope changes along a way.
    fn along(&self, row: usize, way: &[f64]) -> impl Iterator<Item = f64> {
        self.of(row).chunks_exact(self.count).map(|entries| dot(entries, way))
    }
}

/// The neighbourhood of a design.
pub(super) struct Bent<'a> {
    pub here: &'a Look,
    pub bends: &'a Bends,
    sought: Vec<Sought>,
}

impl<'a> Bent<'a> {
    pub fn new(here: &'a Look, bends: &'a Bends, room: &[(f64, f64)]) -> Self {
        let sought = room.iter().map(|(down, up)| Sought::between(*down, *up)).collect();
        Self { here, bends, sought }
    }

    /// What the quadratics say.
    pub fn at(&self, way: &[f64]) -> Look {
        let count = way.len();
        let mut look =
            Look { slopes: Vec::with_capacity(self.here.slopes.len()), ..Look::default() };
        for (row, slopes) in self.here.slopes.chunks_exact(count).enumerate() {
            let first = look.slopes.len();
            look.slopes.extend(self.bends.along(row, way).zip(slopes).map(|(a, b)| a + b));
            // Of a quadratic the mean slope is that half-way.
            let mean = 0.5 * (dot(&look.slopes[first..], way) + dot(slopes, way));
            match row.checked_sub(self.here.values.len()) {
                None => look.values.push(self.here.values[row] + mean),
                Some(row) => look.conditions.push(self.here.conditions[row] + mean),
            }
        }
        look
    }

    /// The best step; none if there is none.
    pub fn step(&mut self, aim: Aim) -> Option<Step> {
        let start = vec![0.0; self.sought.len()];
        let found = from_region(self, aim, &start, (LOOKS, REGION, false)).ok()?;
        let bounds = found.bounds.iter().zip(&self.sought);
        Some(Step {
            multipliers: found.multipliers,
            bounds: bounds.map(|(bound, one)| bound / one.width()).collect(),
            missed: found.missed,
            way: found.design,
        })
    }
}

impl Local for Bent<'_> {
    fn sought(&self) -> &[Sought] {
        &self.sought
    }

    fn look(&mut self, way: &[f64]) -> Option<Look> {
        Some(self.at(way))
    }

    fn curvature(&mut self, multipliers: &[f64]) -> Option<Vec<f64>> {
        let mut sum = vec![0.0; self.bends.count * self.bends.count];
        for (row, multiplier) in multipliers.iter().enumerate().filter(|one| *one.1 != 0.0) {
            let sign = if row < self.here.values.len() { 1.0 } else { -1.0 };
            for (sum, entry) in sum.iter_mut().zip(self.bends.of(row)) {
                *sum += sign * multiplier * entry;
            }
        }
        Some(sum)
    }
}
