//! Tests of the stiff methods: orders, published solutions, and the choice on the way.

mod automatic;
mod bounce;
mod failures;
mod orders;
mod problems;
mod published;
mod springs;

use super::march::record;
use super::{Method, Rates};
use crate::ode::{AbsoluteTolerance, OdeError, Options, Trajectory};

/// Both stiff methods.
const STIFF: [Method; 2] = [Method::Radau, Method::Rosenbrock];

/// Right-hand sides and their Jacobian as functions; the Jacobian by rows.
#[derive(Clone, Copy)]
struct Problem<const N: usize> {
    rate: fn(f64, &[f64], &mut [f64]),
    rows: fn(f64, &[f64]) -> [[f64; N]; N],
}

impl<const N: usize> Rates for Problem<N> {
    fn states(&self) -> usize {
        N
    }

    fn rate(&mut self, time: f64, state: &[f64], rate: &mut [f64]) {
        (self.rate)(time, state, rate);
    }

    fn jacobian(&mut self, time: f64, state: &[f64], columns: &mut [f64]) {
        for (row, entries) in (self.rows)(time, state).iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                columns[column * N + row] = *entry;
            }
        }
    }
}

impl<const N: usize> Problem<N> {
    fn march(
        mut self,
        method: Method,
        times: (f64, f64),
        start: [f64; N],
        options: &Options,
    ) -> Result<Trajectory, OdeError> {
        record(&mut self, times, &start, options, method)
    }
}

/// Options with these tolerances.
fn tolerances(rtol: f64, atol: f64) -> Options {
    Options {
        rtol,
        atol: AbsoluteTolerance::Same(atol),
        ..Options::default()
    }
}

/// Options with fixed steps.
fn fixed(step: f64) -> Options {
    Options {
        fixed_step: Some(step),
        ..tolerances(1e-13, 1e-13)
    }
}

/// Largest error of a state beside the values that are expected, relative to them.
fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    let pairs = found.iter().zip(expected);
    pairs
        .map(|(found, expected)| ((found - expected) / expected).abs())
        .fold(0.0, f64::max)
}
