//! The quadratic programme of one step.

use super::curve::{Curve, dot};
use super::local::{Aim, Look};
use super::working::Working;
use crate::conic::{Rows, minimise};
use clarabel::solver::NonnegativeConeT;

/// What is expected around a design, in units of the ranges.
#[derive(Clone, Copy)]
pub(super) struct Model<'a> {
    pub aim: Aim,
    /// Values and conditions where the design stands, or as a correction shifts them, with their slopes.
    pub look: &'a Look,
    pub curve: &'a Curve,
    /// How far each number may go down and up.
    pub room: &'a [(f64, f64)],
    /// Largest step.
    pub region: f64,
    /// What a condition that is missed by one costs.
    pub weight: f64,
}

/// A step that a programme proposes.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub way: Vec<f64>,
    /// Of the values, then of the conditions.
    pub multipliers: Vec<f64>,
    /// Of the bounds: above zero where the number would rather be beyond its upper one.
    pub bounds: Vec<f64>,
    /// By how much a condition is still missed.
    pub missed: f64,
}

/// The sizes of what may change within the region.
struct Units {
    /// Of the objective.
    objective: f64,
    /// Of the conditions.
    condition: f64,
}

impl Model<'_> {
    /// What values and conditions together cost after a step.
    pub fn cost(&self, way: &[f64]) -> f64 {
        let there = self.look.along(way);
        let bent = 0.5 * dot(way, &self.curve.times(way));
        self.aim.of(&there.values) + bent + self.weight * there.missed()
    }

    /// Slopes of the values, and of the conditions.
    pub fn slopes(&self) -> (Vec<&[f64]>, Vec<&[f64]>) {
        let mut rows: Vec<&[f64]> = self.look.slopes.chunks_exact(self.room.len()).collect();
        let conditions = rows.split_off(self.look.values.len());
        (rows, conditions)
    }

    /// How much each of these may change within the region.
    pub fn reaches(&self, slopes: &[&[f64]]) -> Vec<f64> {
        let sums = slopes.iter().map(|row| row.iter().map(|slope| slope.abs()).sum::<f64>());
        sums.map(|sum| self.region * sum).collect()
    }

    /// How much one of them may change at most.
    fn reach(&self, slopes: &[&[f64]]) -> f64 {
        self.reaches(slopes).into_iter().fold(0.0, f64::max)
    }

    /// Linear and quadratic part of what is made small by a step over the region, besides the largest value.
    fn objective(&self, slopes: &[&[f64]]) -> (Vec<f64>, Vec<(usize, usize, f64)>) {
        let (n, area) = (self.room.len(), self.region * self.region);
        let (mut linear, mut quadratic) = (vec![0.0; n], Vec::new());
        let (_, values) = self.aim.parts(&self.look.values);
        let (_, squares) = self.aim.parts(slopes);
        for (value, slope) in values.iter().zip(squares) {
            for (linear, slope) in linear.iter_mut().zip(*slope) {
                *linear += value * slope * self.region;
            }
        }
        for row in 0..n {
            for column in row..n {
                let sum: f64 = squares.iter().map(|slope| slope[row] * slope[column]).sum();
                let entry = (self.curve.entry(row, column) + sum) * area;
                if entry != 0.0 {
                    quadratic.push((row, column, entry));
                }
            }
        }
        (linear, quadratic)
    }

    /// The step that makes this least; none if the programme has no solution.
    pub fn solve(&self) -> Option<Step> {
        let mut working = Working::new(self);
        loop {
            let (step, largest) = self.solved(&working)?;
            if !working.extend(self, &step, largest) {
                return Some(step);
            }
        }
    }

    /// The step for some of the rows, with what the largest value comes to by it.
    ///
    /// The unknowns are the step over the region, and the changes of the largest value and of what is missed over how much
    /// they may change.
    fn solved(&self, working: &Working) -> Option<(Step, f64)> {
        let (n, region) = (self.room.len(), self.region);
        let (values, conditions) = (&self.look.values, &self.look.conditions);
        let (slopes, others) = self.slopes();
        let (mut linear, mut quadratic) = self.objective(&slopes);
        let missed = conditions.iter().fold(0.0, |most, one| f64::max(most, -one));
        let units = self.units(&linear, &quadratic, (&slopes, &others), missed)?;
        linear.iter_mut().for_each(|one| *one /= units.objective);
        quadratic.iter_mut().for_each(|one| one.2 /= units.objective);
        let (largest, worst) = (n, n + 1);
        let (first, squares) = self.aim.parts(values);
        linear.push(f64::from(u8::from(!first.is_empty())));
        linear.push(self.weight * units.condition / units.objective);

        let mut rows = Rows::default();
        let now = first.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for &index in working.values() {
            let mut row = scaled(slopes[index], -region / units.objective);
            row.push((largest, 1.0));
            rows.row((now - values[index]) / units.objective, &row);
        }
        if first.is_empty() {
            rows.row(0.0, &[(largest, 1.0)]);
        }
        let held = rows.count();
        for &index in working.conditions() {
            let mut row = scaled(others[index], region / units.condition);
            row.push((worst, 1.0));
            rows.row((conditions[index] + missed) / units.condition, &row);
        }
        rows.row(missed / units.condition, &[(worst, 1.0)]);
        let bounds = rows.count();
        for (k, (down, up)) in self.room.iter().enumerate() {
            rows.row(up / region, &[(k, -1.0)]);
            rows.row(-down / region, &[(k, 1.0)]);
        }
        rows.cones.push(NonnegativeConeT(rows.count()));
        let (x, z) = minimise(&linear, &quadratic, rows).ok()?;

        let to = x[..n].iter().zip(self.room);
        let way: Vec<f64> = to.map(|(one, (down, up))| (one * region).clamp(*down, *up)).collect();
        let mut multipliers = vec![0.0; values.len() + conditions.len()];
        let of_squares = multipliers[first.len()..].iter_mut().zip(squares);
        for ((one, value), slope) in of_squares.zip(&slopes[first.len()..]) {
            *one = value + dot(slope, &way);
        }
        for (&index, z) in working.values().iter().zip(&z) {
            multipliers[index] = *z;
        }
        for (&index, z) in working.conditions().iter().zip(&z[held..]) {
            multipliers[values.len() + index] = z * units.objective / units.condition;
        }
        let at_bound = |k: usize| {
            let [up, down] = [z[bounds + 2 * k], z[bounds + 2 * k + 1]];
            (up - down) * units.objective / region
        };
        let step = Step {
            multipliers,
            bounds: (0..n).map(at_bound).collect(),
            missed: (x[worst] * units.condition + missed).max(0.0),
            way,
        };
        Some((step, now + x[largest] * units.objective))
    }

    /// The sizes of what may change; none where nothing does, or something is no number.
    fn units(
        &self,
        linear: &[f64],
        quadratic: &[(usize, usize, f64)],
        (slopes, others): (&[&[f64]], &[&[f64]]),
        missed: f64,
    ) -> Option<Units> {
        let condition = self.reach(others).max(missed).max(f64::MIN_POSITIVE);
        let of_squares: f64 = linear.iter().map(|one| one.abs()).sum();
        let first = self.reach(self.aim.parts(slopes).0) + of_squares;
        let second = quadratic.iter().fold(0.0, |most, one| f64::max(most, one.2.abs()));
        let objective = match first.max(second) {
            0.0 => self.weight * condition,
            size => size,
        };
        let is_known = objective > 0.0 && objective.is_finite() && condition.is_finite();
        is_known.then_some(Units { objective, condition })
    }
}

fn scaled(slope: &[f64], factor: f64) -> Vec<(usize, f64)> {
    slope.iter().map(|one| one * factor).enumerate().collect()
}
