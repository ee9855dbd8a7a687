//! Closes a motion that nearly repeats.

use nalgebra::{DMatrix, DVector};

use super::super::Motion;
use super::error::CycleError;
use super::flow::Flow;
use super::{Cycle, variation};
use crate::periodic::closing::Closing;
use crate::periodic::multipliers;
use crate::registry::Settings;

/// Steps of Newton's method at most.
const ITERATIONS: usize = 30;
/// How often a step is halved.
const HALVINGS: usize = 8;
/// Change after the period, in tolerances, that counts as none.
const CLOSED: f64 = 30.0;

/// What is closed: from where, after what time.
pub(super) struct Gap<'a> {
    /// The scene.
    pub(super) flow: &'a dyn Flow,
    /// Mode at the begin and at the end.
    pub(super) mode: usize,
    /// The period.
    pub(super) period: f64,
    /// After how many periods.
    pub(super) multiple: usize,
    /// Sizes of the states.
    pub(super) sizes: &'a [f64],
    /// The method and its accuracy.
    pub(super) settings: &'a Settings,
}

impl Gap<'_> {
    /// The motion from a start, and its change after the time.
    fn follow(&self, start: &DVector<f64>) -> Result<(Motion, DVector<f64>), CycleError> {
        let times = (0.0, self.period * self.multiple as f64);
        let motion = self
            .flow
            .follow(self.mode, times, start.as_slice(), self.settings)
            .map_err(|error| CycleError::Motion(Box::new(error)))?;
        let change = DVector::from_column_slice(&motion.end) - start;
        Ok((motion, change))
    }

    /// A change over the sizes of the states.
    fn size(&self, change: &DVector<f64>) -> f64 {
        let parts = change.iter().zip(self.sizes);
        parts
            .map(|(one, size)| one.abs() / size)
            .fold(0.0, f64::max)
    }

    /// The motion that repeats near a start; none if Newton's method does not come to one.
    pub(super) fn close(
        &self,
        start: &[f64],
        followed: usize,
    ) -> Result<Option<Cycle>, CycleError> {
        let mut start = DVector::from_column_slice(start);
        let (mut motion, mut change) = self.follow(&start)?;
        let tolerance = CLOSED * self.settings.rtol;
        for iteration in 1..=ITERATIONS {
            if motion.mode != self.mode {
                return Ok(None);
            }
            let matrix = variation::of(self.flow, &motion, self.settings)?;
            let residual = self.size(&change);
            let Some(step) = self.step(&matrix, &change) else {
                return Ok(None);
            };
            // Once closed, the step that was computed anyway is taken as well: it costs a motion and gains digits.
            let last = residual <= tolerance;
            let mut part = 1.0;
            let better = loop {
                let tried = &start + &step * part;
                match self.follow(&tried) {
                    Ok((next, gap)) if next.mode == self.mode && (self.size(&gap) < residual) => {
                        break Some((tried, next, gap));
                    }
                    _ if part < 0.5_f64.powi(HALVINGS as i32) || last => break None,
                    _ => part *= 0.5,
                }
            };
            if let Some(better) = better {
                (start, motion, change) = better;
            } else if !last {
                return Ok(None);
            }
            if last {
                return self.cycle(motion, &change, iteration, followed).map(Some);
            }
        }
        Ok(None)
    }

    /// `(I - M) δ = change`.
    fn step(&self, matrix: &DMatrix<f64>, change: &DVector<f64>) -> Option<DVector<f64>> {
        let states = matrix.nrows();
        let system = DMatrix::identity(states, states) - self.scaled(matrix);
        let right = change.component_div(&DVector::from_column_slice(self.sizes));
        let solved = system.lu().solve(&right)?;
        let step = solved.component_mul(&DVector::from_column_slice(self.sizes));
        step.iter().all(|one| one.is_finite()).then_some(step)
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
        let matrix = variation::of(self.flow, &motion, self.settings)?;
        let scales = change.iter().zip(self.flow.scales());
        Ok(Cycle {
            multipliers: multipliers::of(&self.scaled(&matrix)),
            condition: Closing::new(&matrix).condition(),
            residual: scales
                .map(|(one, scale)| one.abs() / scale)
                .fold(0.0, f64::max),
            multiple: self.multiple,
            motion,
            iterations,
            followed,
        })
    }
}
