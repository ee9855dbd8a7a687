//! Closes a motion that nearly repeats.
//!
//! Where nothing but the motion itself states the time after which it repeats, that is one more unknown: the motion `x`
//! may be begun in any of its phases, so that `(I - M) δ - f δT = change` has a solution for each; the one across the
//! motion is taken, `f · δ = 0`, in states over their sizes.

use nalgebra::{DMatrix, DVector};

use super::super::Motion;
use super::error::CycleError;
use super::{Cycle, follow, variation};
use crate::floquet::{Closing, Multiplier, multipliers};
use crate::model::{Flow, Model};
use crate::settings::Settings;

/// Steps of Newton's method at most.
const ITERATIONS: usize = 30;
/// How often a step is halved.
const HALVINGS: usize = 8;
/// Error of the matrix, in tolerances.
const UNCERTAINTY: f64 = 10.0;
/// Largest factor by which a step changes the time.
const LONGER: f64 = 1.5;
/// Change after the period, in tolerances, that counts as none.
const CLOSED: f64 = 30.0;

/// What is closed: from where, after what time.
pub(super) struct Gap<'a> {
    /// The scene.
    pub(super) model: &'a dyn Model,
    /// Mode at the begin and at the end.
    pub(super) mode: usize,
    /// The period.
    pub(super) period: f64,
    /// After how many periods.
    pub(super) multiple: usize,
    /// Whether the period is an unknown, of which there is a guess.
    pub(super) is_free: bool,
    /// Sizes of the states.
    pub(super) sizes: &'a [f64],
    /// The method and its accuracy.
    pub(super) settings: &'a Settings,
}

impl Gap<'_> {
    /// The motion from a start over a time, and its change.
    fn follow(
        &self,
        start: &DVector<f64>,
        time: f64,
    ) -> Result<(Motion, DVector<f64>), CycleError> {
        let motion = follow(self.model, self.mode, (0.0, time), start.as_slice(), self.settings)?;
        let change = DVector::from_column_slice(&motion.end) - start;
        Ok((motion, change))
    }

    /// A change over the sizes of the states.
    fn size(&self, change: &DVector<f64>) -> f64 {
        let parts = change.iter().zip(self.sizes);
        parts.map(|(one, size)| one.abs() / size).fold(0.0, f64::max)
    }

    /// The motion that repeats near a start; none if Newton's method does not come to one.
    pub(super) fn close(
        &self,
        start: &[f64],
        followed: usize,
    ) -> Result<Option<Cycle>, CycleError> {
        let mut start = DVector::from_column_slice(start);
        let mut time = self.period * self.multiple as f64;
        let (mut motion, mut change) = self.follow(&start, time)?;
        let tolerance = CLOSED * self.settings.rtol;
        for iteration in 1..=ITERATIONS {
            if motion.mode != self.mode {
                return Ok(None);
            }
            let matrix = variation::of(self.model, &motion, self.settings)?;
            let residual = self.size(&change);
            let Some((step, longer)) = self.step(&matrix, &motion, &change) else {
                return Ok(None);
            };
            // Once closed, the step that was computed anyway is taken as well: it costs a motion and gains digits.
            let last = residual <= tolerance;
            let mut part = 1.0;
            let better = loop {
                let mut tried = &start + &step * part;
                let local = Flow::on(self.model, self.mode, &[]);
                if local.correct(0.0, tried.as_mut_slice()).is_err() {
                    return Ok(None);
                }
                let until = (time + longer * part).clamp(time / LONGER, time * LONGER);
                match self.follow(&tried, until) {
                    Ok((next, gap)) if next.mode == self.mode && (self.size(&gap) < residual) => {
                        break Some((tried, until, next, gap));
                    }
                    _ if part < 0.5_f64.powi(HALVINGS as i32) || last => break None,
                    _ => part *= 0.5,
                }
            };
            if let Some(better) = better {
                (start, time, motion, change) = better;
            } else if !last {
                return Ok(None);
            }
            if last {
                return self.cycle(motion, &change, iteration, followed).map(Some);
            }
        }
        Ok(None)
    }

    /// `(I - M) δ = change`, and how much longer the time is to be.
    fn step(
        &self,
        matrix: &DMatrix<f64>,
        motion: &Motion,
        change: &DVector<f64>,
    ) -> Option<(DVector<f64>, f64)> {
        let states = matrix.nrows();
        let sizes = DVector::from_column_slice(self.sizes);
        let right = change.component_div(&sizes);
        let solved = match self.is_free {
            false => {
                let system = DMatrix::identity(states, states) - self.scaled(matrix);
                system.lu().solve(&right)?
            }
            true => {
                let right = right.insert_row(states, 0.0);
                self.bordered(matrix, motion).lu().solve(&right)?
            }
        };
        let longer = solved.get(states).map_or(0.0, |one| one * motion.time);
        let step = solved.rows(0, states).component_mul(&sizes);
        let is_finite = step.iter().all(|one| one.is_finite()) && longer.is_finite();
        is_finite.then_some((step, longer))
    }

    /// The system of a motion whose time is an unknown, in states over their sizes and times over its own.
    fn bordered(&self, matrix: &DMatrix<f64>, motion: &Motion) -> DMatrix<f64> {
        let states = matrix.nrows();
        let mut rate = vec![0.0; states];
        let local = Flow::on(self.model, motion.mode, &[]);
        local.rates(motion.time, &motion.end, &mut rate);
        let rates = rate.iter().zip(self.sizes);
        let rate = DVector::from_iterator(states, rates.map(|(one, size)| one / size));
        let mut system = DMatrix::identity(states + 1, states + 1);
        let mut inner = system.view_mut((0, 0), (states, states));
        inner -= self.scaled(matrix);
        let fastest = rate.amax().max(f64::MIN_POSITIVE);
        for (state, one) in rate.iter().enumerate() {
            system[(state, states)] = -one * motion.time;
            system[(states, state)] = one / fastest;
        }
        system[(states, states)] = 0.0;
        system
    }

    /// Amplification of relative errors of the matrix into the motion.
    fn condition(&self, matrix: &DMatrix<f64>, motion: &Motion) -> f64 {
        if !self.is_free {
            return Closing::new(matrix).condition();
        }
        let smallest = self.bordered(matrix, motion).singular_values().min();
        (1.0 + self.scaled(matrix).norm()) / smallest
    }

    /// The multipliers; without the one of the phase, which is 1, where nothing states the time.
    fn multipliers(&self, matrix: &DMatrix<f64>) -> Vec<Multiplier> {
        let error = UNCERTAINTY * self.settings.rtol;
        let mut all = multipliers(&self.scaled(matrix), None, error);
        // What closures do not allow dies out at once, and is no motion.
        let held = self.model.shape().held_in(self.mode);
        all.truncate(all.len() - held.map_or(0, |held| 2 * held.rank).min(all.len()));
        let distances = all.iter().map(Multiplier::distance).enumerate();
        let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((place, _)) = nearest.filter(|_| self.is_free) {
            all.remove(place);
        }
        all
    }

    /// A matrix in states over their sizes.
    fn scaled(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
            matrix[(row, column)] * self.sizes[column] / self.sizes[row]
        })
    }

    fn cycle(
        &self,
        motion: Motion,
        change: &DVector<f64>,
        iterations: usize,
        followed: usize,
    ) -> Result<Cycle, CycleError> {
        let matrix = variation::of(self.model, &motion, self.settings)?;
        let scales = change.iter().zip(self.model.shape().scales);
        Ok(Cycle {
            multipliers: self.multipliers(&matrix),
            condition: self.condition(&matrix, &motion),
            residual: scales.map(|(one, scale)| one.abs() / scale).fold(0.0, f64::max),
            multiple: self.multiple,
            motion,
            iterations,
            followed,
        })
    }
}
