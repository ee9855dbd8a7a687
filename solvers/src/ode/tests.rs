//! Tests of the steppers: tableaus against the order conditions, motions against closed forms.

mod motions;
mod order;
mod taylor;

use super::{AbsoluteTolerance, Method, OdeError, Options, Plain, Trajectory};
use crate::problem::Equations;

/// Right-hand sides that are written as a function.
#[derive(Clone)]
pub(super) struct Rates<const N: usize>(pub fn(f64, &[f64; N], &mut [f64; N]));

impl<const N: usize> Equations<f64> for Rates<N> {
    type State = [f64; N];
    type Instant = f64;

    fn states(&self) -> usize {
        N
    }

    fn instant(&self, time: f64) -> f64 {
        time
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [f64; K] {
        times
    }

    fn derivative(&self, instant: &f64, state: &[f64; N], rate: &mut [f64; N]) {
        (self.0)(*instant, state, rate);
    }

    fn variation(
        &self,
        instant: &f64,
        state: &[f64; N],
        rate: &mut [f64; N],
        _columns: &[[f64; N]],
        products: &mut [[f64; N]],
    ) {
        // No test here integrates variations: NaN would show if one did.
        (self.0)(*instant, state, rate);
        products.fill([f64::NAN; N]);
    }

    fn jacobian(&self, _instant: &f64, _state: &[f64; N], columns: &mut [[f64; N]]) {
        columns.fill([f64::NAN; N]);
    }

    fn outputs(&self, _time: f64, _state: &[f64; N], _values: &mut [f64]) {}

    fn drivers(&self, _time: f64, _values: &mut [f64]) {}
}

/// Options with one tolerance.
pub(super) fn tolerance(tolerance: f64) -> Options {
    Options {
        rtol: tolerance,
        atol: AbsoluteTolerance::Same(tolerance),
        ..Options::default()
    }
}

/// A motion by a method.
pub(super) fn march<M: Method, const N: usize>(
    rates: fn(f64, &[f64; N], &mut [f64; N]),
    times: (f64, f64),
    start: [f64; N],
    options: &Options,
) -> Result<Trajectory, OdeError> {
    super::march::march_with::<f64, _, M>(&Rates(rates), times, &start, options)
}

/// The final state and number of evaluations without anything stored.
pub(super) fn end<M: Method, const N: usize>(
    rates: fn(f64, &[f64; N], &mut [f64; N]),
    times: (f64, f64),
    start: [f64; N],
    options: &Options,
) -> [f64; N] {
    let rates = Rates(rates);
    let system = Plain(&rates);
    let mut workspace = super::Workspace::<[f64; N], M>::new::<f64, _>(&system);
    super::integrate::<f64, _, M>(&system, times, &start, options, &mut workspace, &mut ())
        .unwrap();
    *workspace.state()
}
