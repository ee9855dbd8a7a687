//! Where an integration stands, and the sizes of its errors.

use crate::model::Flow;
use crate::ode::{OdeError, Options, Statistics, first_bad};

/// Where an integration stands: the memory that all methods share, taken once.
#[derive(Clone, Debug)]
pub(super) struct Here {
    /// The time.
    pub time: f64,
    /// The state, and its rate.
    pub state: Vec<f64>,
    pub rate: Vec<f64>,
    /// The Jacobian, column after column; at this state or an earlier one.
    pub jacobian: Vec<f64>,
    /// The state at the end of the step, and its rate.
    pub trial: Vec<f64>,
    pub next: Vec<f64>,
    /// The error estimate of the step.
    pub error: Vec<f64>,
    /// The coefficients of the continuous solution.
    pub polynomial: Vec<f64>,
    /// What it took so far.
    pub statistics: Statistics,
    /// The component that was not finite in the last attempt.
    pub bad: Option<usize>,
}

impl Here {
    /// Room for so many states and so many coefficients of the continuous solution.
    pub fn new(states: usize, degree: usize) -> Self {
        let zeros = vec![0.0; states];
        Self {
            time: 0.0,
            state: zeros.clone(),
            rate: zeros.clone(),
            jacobian: vec![0.0; states * states],
            trial: zeros.clone(),
            next: zeros.clone(),
            error: zeros.clone(),
            polynomial: vec![0.0; degree * states],
            statistics: Statistics::default(),
            bad: None,
        }
    }

    /// Evaluates the Jacobian at the state.
    pub fn differentiate(&mut self, flow: &Flow<'_>) -> Result<(), OdeError> {
        flow.jacobian(self.time, &self.state, &mut self.jacobian);
        self.statistics.jacobians += 1;
        match first_bad(&self.jacobian, self.jacobian.len()) {
            None => Ok(()),
            Some(place) => Err(OdeError::NotDifferentiable {
                time: self.time,
                component: place % self.state.len(),
                by: place / self.state.len(),
            }),
        }
    }

    /// The error of the step in tolerances.
    pub fn scaled_error(&self, options: &Options) -> f64 {
        scaled_size(options, (&self.state, &self.trial), &self.error)
    }

    /// Why no step is short enough.
    #[cold]
    pub fn failure(&self, options: &Options, step: f64) -> OdeError {
        let time = self.time;
        if let Some(component) = self.bad {
            return OdeError::NotFinite { time, component };
        }
        let mut worst = (0, 0.0);
        for (index, error) in self.error.iter().enumerate() {
            let ratio = error.abs() / tolerance(options, index, self.state[index].abs());
            if ratio > worst.1 {
                worst = (index, ratio);
            }
        }
        OdeError::StepTooSmall { time, step, component: worst.0 }
    }
}

/// The error that is permitted of a component of this size. It is never zero, so that nothing over it is zero too.
#[inline]
pub(super) fn tolerance(options: &Options, index: usize, size: f64) -> f64 {
    (options.atol.of(index) + options.rtol * size).max(f64::MIN_POSITIVE)
}

/// Root mean square of `values` over the tolerances at two states. NaN as soon as one value is NaN.
pub(super) fn scaled_size(
    options: &Options,
    (before, after): (&[f64], &[f64]),
    values: &[f64],
) -> f64 {
    let mut sum = 0.0;
    for (index, value) in values.iter().enumerate() {
        let size = before[index].abs().max(after[index].abs());
        let ratio = value / tolerance(options, index, size);
        sum += ratio * ratio;
    }
    match values.len() {
        0 => 0.0,
        count => (sum / count as f64).sqrt(),
    }
}
