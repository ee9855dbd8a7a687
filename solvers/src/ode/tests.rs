//! Tests of the steppers: tableaus against the order conditions, motions against closed forms.

mod motions;
mod order;

use super::{
    AbsoluteTolerance, Explicit, OdeError, Options, Recorder, Trajectory, Workspace, integrate,
};
use crate::model::Flow;
use crate::model::hand::Hand;

/// Right-hand sides that are written as a function.
pub(super) type Rates<const N: usize> = fn(f64, [f64; N]) -> [f64; N];

/// Options with one tolerance.
pub(super) fn tolerance(tolerance: f64) -> Options {
    Options { rtol: tolerance, atol: AbsoluteTolerance::Same(tolerance), ..Options::default() }
}

/// A motion by a method.
pub(super) fn march<const N: usize>(
    method: Explicit,
    rates: Rates<N>,
    times: (f64, f64),
    start: [f64; N],
    options: &Options,
) -> Result<Trajectory, OdeError> {
    let hand = Hand::without_jacobian(rates);
    let flow = Flow::new(&hand, 0);
    let mut workspace = Workspace::new(method, &flow);
    let mut recorder = Recorder::new(times.0, &start);
    let statistics = integrate(&flow, times, &start, options, &mut workspace, &mut recorder)?;
    Ok(recorder.finish(statistics))
}

/// The final state without anything stored.
pub(super) fn end<const N: usize>(
    method: Explicit,
    rates: Rates<N>,
    times: (f64, f64),
    start: [f64; N],
    options: &Options,
) -> [f64; N] {
    let hand = Hand::without_jacobian(rates);
    let flow = Flow::new(&hand, 0);
    let mut workspace = Workspace::new(method, &flow);
    integrate(&flow, times, &start, options, &mut workspace, &mut ()).unwrap();
    workspace.state().try_into().unwrap()
}
