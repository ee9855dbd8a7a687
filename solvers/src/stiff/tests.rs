//! Tests of the stiff methods: orders, published solutions, and the choice on the way.

mod automatic;
mod bounce;
mod failures;
mod orders;
mod problems;
mod published;
mod springs;

use super::Implicit;
use super::march::record;
use crate::model::hand::Hand;
use crate::model::{Flow, Model};
use crate::ode::{AbsoluteTolerance, OdeError, Options, Trajectory};

/// Both stiff methods.
const STIFF: [Implicit; 2] = [Implicit::Radau, Implicit::Rosenbrock];

/// A motion by a method.
fn march<const N: usize>(
    model: &dyn Model,
    method: Implicit,
    times: (f64, f64),
    start: [f64; N],
    options: &Options,
) -> Result<Trajectory, OdeError> {
    record(&Flow::new(model, 0), times, &start, options, method)
}

/// Options with these tolerances.
fn tolerances(rtol: f64, atol: f64) -> Options {
    Options { rtol, atol: AbsoluteTolerance::Same(atol), ..Options::default() }
}

/// Options with fixed steps.
fn fixed(step: f64) -> Options {
    Options { fixed_step: Some(step), ..tolerances(1e-13, 1e-13) }
}

/// Largest error of a state beside the values that are expected, relative to them.
fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    let pairs = found.iter().zip(expected);
    pairs.map(|(found, expected)| ((found - expected) / expected).abs()).fold(0.0, f64::max)
}
