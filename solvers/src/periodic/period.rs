//! The motion over one period, in states over their scales.

use super::error::PeriodicError;
use crate::hybrid::{Cycle, CycleError, Motion, cycle_of, variations};
use crate::model::{Flow, Model, Varied};
use crate::ode::{
    Explicit, Observer, OdeError, Options, Step, Trajectory, Workspace, bad_start, integrate,
};
use crate::settings::{Method, Settings};
use crate::smooth;
use nalgebra::{DMatrix, DVector};

/// A scene with its period.
#[derive(Clone, Copy)]
pub(super) struct Period<'a> {
    /// The scene.
    pub model: &'a dyn Model,
    /// The start values; none where there are none.
    pub start: &'a [f64],
    /// The period.
    pub period: f64,
    /// The method, and its accuracy where nothing else is asked for.
    pub settings: &'a Settings,
}

/// What one period makes of a start. All vectors in states over their scales.
pub(super) struct Return {
    /// The start.
    pub start: DVector<f64>,
    /// The state after one period.
    pub end: DVector<f64>,
    /// `Φ = ∂end/∂start`.
    pub matrix: DMatrix<f64>,
    /// Largest absolute value of each state on the way.
    pub peak: DVector<f64>,
}

impl Return {
    /// What is missing to a motion that repeats, `end - start`.
    pub fn gap(&self) -> DVector<f64> {
        &self.end - &self.start
    }

    /// Size of the motion: 1 or more, as tolerances are relative to the scales at least.
    pub fn size(&self) -> f64 {
        1.0 + self.peak.iter().copied().fold(0.0, f64::max)
    }
}

impl Period<'_> {
    /// Whether the equations are affine in the state.
    pub fn is_linear(&self) -> bool {
        self.model.shape().is_linear
    }

    /// Sizes of the states.
    pub fn scales(&self) -> &[f64] {
        self.model.shape().scales
    }

    /// The declared start values, or zeros if there are none.
    pub fn guess(&self) -> Result<DVector<f64>, PeriodicError> {
        let states = self.scales().len();
        match self.start.len() {
            0 => Ok(DVector::zeros(states)),
            count if count == states => Ok(self.over_scales(self.start)),
            count => Err(bad_start(count, states).into()),
        }
    }

    /// Integrates the motion and its variations over the period.
    pub fn turn(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError> {
        match self.settings.method {
            Method::Tsit5 => self.turn_beside(Explicit::Tsit5, start, rtol),
            // A steady state shows no transient that an automatic choice would have to look out for.
            Method::Dop853 | Method::Auto => self.turn_beside(Explicit::Dop853, start, rtol),
            Method::Radau | Method::Rosenbrock | Method::Taylor => self.turn_apart(start, rtol),
        }
    }

    /// Integrates the motion alone over the period.
    pub fn march(&self, start: &DVector<f64>, rtol: f64) -> Result<Trajectory, OdeError> {
        let times = (0.0, self.period);
        smooth::follow(self.model, times, &self.unscaled(start), &self.settings.at(rtol))
    }

    /// The motion that attracts the one from a start.
    pub fn attractor(&self, start: &DVector<f64>, rtol: f64) -> Result<Cycle, CycleError> {
        let start = self.unscaled(start);
        cycle_of(self.model, (0, &start), self.period, &self.settings.at(rtol))
    }

    /// The same scene over several periods.
    pub fn over(&self, periods: usize) -> Self {
        Self { period: self.period * periods as f64, ..*self }
    }

    /// [`Period::turn`] by a method that integrates no variations: they follow along the motion.
    fn turn_apart(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError> {
        let motion = Motion::of(self.march(start, rtol)?);
        let matrix = variations(self.model, &motion, &self.settings.at(rtol))?;
        let trajectory = motion.pieces.iter().map(|piece| &piece.trajectory);
        let mut peak = start.abs();
        for (trajectory, time) in
            trajectory.flat_map(|one| one.times().iter().map(move |t| (one, *t)))
        {
            let state = self.over_scales(&trajectory.at(time));
            peak.zip_apply(&state, |size, value| *size = size.max(value.abs()));
        }
        Ok(self.back(start, &motion.end, matrix.as_slice(), peak))
    }

    /// [`Period::turn`] by a method that integrates the variations beside the motion.
    fn turn_beside(
        &self,
        method: Explicit,
        start: &DVector<f64>,
        rtol: f64,
    ) -> Result<Return, OdeError> {
        let flow = &Flow::new(self.model, 0);
        let scales = self.scales();
        let varied = Varied { flow, scales };
        let options = Options::of(&self.settings.at(rtol), scales);
        let mut workspace = Workspace::new(method, &varied);
        let mut peak = Peak { scales, sizes: start.abs() };
        let (times, begin) = ((0.0, self.period), varied.start(&self.unscaled(start)));
        integrate(&varied, times, &begin, &options, &mut workspace, &mut peak)?;
        let (end, columns) = workspace.state().split_at(scales.len());
        Ok(self.back(start, end, columns, peak.sizes))
    }

    /// What has come of a start: the state at the end, SI units, and its derivatives by that at the begin.
    fn back(
        &self,
        start: &DVector<f64>,
        end: &[f64],
        columns: &[f64],
        peak: DVector<f64>,
    ) -> Return {
        let (scales, states) = (self.scales(), end.len());
        let scaled = |row: usize, column: usize| {
            columns[column * states + row] * (scales[column] / scales[row])
        };
        Return {
            start: start.clone(),
            end: self.over_scales(end),
            matrix: DMatrix::from_fn(states, states, scaled),
            peak,
        }
    }

    /// A state from a vector over its scales.
    fn unscaled(&self, scaled: &DVector<f64>) -> Vec<f64> {
        let states = scaled.iter().zip(self.scales());
        states.map(|(value, scale)| value * scale).collect()
    }

    /// A state over its scales.
    fn over_scales(&self, state: &[f64]) -> DVector<f64> {
        let scaled = state.iter().zip(self.scales()).map(|(value, scale)| value / scale);
        DVector::from_iterator(state.len(), scaled)
    }
}

/// Keeps the largest absolute value of each state of a motion, over its scale.
struct Peak<'a> {
    scales: &'a [f64],
    /// The largest so far.
    sizes: DVector<f64>,
}

impl Observer for Peak<'_> {
    fn step(&mut self, step: &Step<'_>) {
        let states = step.after.iter().zip(self.scales);
        for (size, (value, scale)) in self.sizes.iter_mut().zip(states) {
            *size = size.max(value.abs() / scale);
        }
    }
}
