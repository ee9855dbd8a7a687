//! What rounding makes of a step.

use super::here::{Here, scaled_size};
use crate::dense::Lu;
use crate::ode::Options;

/// Roundings of the states that rates may be wrong by.
const ROUNDINGS: f64 = 4.0;

/// Judges errors by it.
#[derive(Clone, Debug)]
pub(super) struct Rounding {
    /// Whether the error of the last attempt is that of rounding, and above the tolerance.
    pub limits: bool,
    /// Room for what one state makes of it, and all of them.
    right: Vec<f64>,
    sum: Vec<f64>,
}

impl Rounding {
    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        Self { limits: false, right: vec![0.0; states], sum: vec![0.0; states] }
    }

    /// What rounding makes of a step, in tolerances: the states of which the rates are made are known to a rounding each,
    /// and what the rates make of that goes through the same linear system as the error does, `I / (γh) - J` with its
    /// pivots.
    #[cold]
    pub fn of(&mut self, here: &Here, options: &Options, system: (&[f64], &[usize])) -> f64 {
        let n = here.state.len();
        self.sum.fill(0.0);
        for (column, value) in here.state.iter().enumerate() {
            let slopes = &here.jacobian[column * n..(column + 1) * n];
            for (target, slope) in self.right.iter_mut().zip(slopes) {
                *target = slope * f64::EPSILON * value;
            }
            Lu::substitute(system.0, system.1, &mut self.right);
            for (sum, one) in self.sum.iter_mut().zip(&self.right) {
                *sum += one.abs();
            }
        }
        ROUNDINGS * scaled_size(options, (&here.state, &here.state), &self.sum)
    }

    /// An error in tolerances. One that is that of rounding does not fall with the step: the tolerance is what rounding
    /// permits.
    pub fn judge(
        &mut self,
        error: f64,
        here: &Here,
        options: &Options,
        system: (&[f64], &[usize]),
    ) -> f64 {
        self.limits = false;
        if error <= 1.0 || error.is_nan() {
            return error;
        }
        let rounding = self.of(here, options, system);
        self.limits = error <= rounding;
        error / rounding.max(1.0)
    }
}
