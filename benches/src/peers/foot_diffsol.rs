//! The presser foot by the steppers of `diffsol` with its root finding.
//!
//! The solver is kept from event to event: the state is moved back to the root, which the library says is how one goes
//! on. The instants at which the rack passes the plate are stop times, or, with `FIND`, roots as the other events are. A
//! stop time shortens the last step before it, and the length that was wanted is put back afterwards.

use std::cell::Cell;

use diffsol::{
    DiffsolError, NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations,
    OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem, OdeSolverStopReason, Op, Vector,
};

use crate::foot::{PERIOD, Run, START};
use crate::hand_foot::{FLIGHT, Foot, PLATE, RACK, SCALE};

type Matrix = NalgebraMat<f64>;

/// The hand-written equations in the phase that is set from outside.
fn problem<'p, const FIND: bool>(
    rtol: f64,
    phase: &'p Cell<u8>,
) -> Result<
    OdeSolverProblem<
        impl OdeEquationsImplicit<
            T = f64,
            V = NalgebraVec<f64>,
            M = Matrix,
            C = diffsol::NalgebraContext,
        > + 'p,
    >,
    DiffsolError,
> {
    let foot = Foot::default();
    let pair = |y: &[f64]| [y[0], y[1]];
    let derivative = move |y: &[f64], _: &[f64], time: f64, rate: &mut [f64]| {
        rate.copy_from_slice(&foot.rate_in(phase.get(), time, &pair(y)));
    };
    let product = move |y: &[f64], _: &[f64], time: f64, v: &[f64], product: &mut [f64]| {
        let [by_place, by_speed] = foot.slopes_in(phase.get(), time, &pair(y));
        product.copy_from_slice(&[v[1], by_place * v[0] + by_speed * v[1]]);
    };
    let root = move |y: &[f64], _: &[f64], time: f64, values: &mut [f64]| {
        values[0] = foot.touch_in(phase.get(), time, &pair(y));
        if FIND {
            // In the air the rack is no matter of the equations.
            values[1] = match phase.get() {
                FLIGHT => 1.0,
                _ => foot.rack_at(time),
            };
        }
    };
    OdeBuilder::<Matrix>::new()
        .rtol(rtol)
        .atol([rtol * SCALE; 2])
        .rhs_implicit(derivative, product)
        .init(|_, _, y| y.copy_from_slice(&START), START.len())
        .root(root, 1 + usize::from(FIND))
        .build()
}

/// Follows the foot for so many turns.
fn run<'a, E, const FIND: bool>(
    mut solver: impl OdeSolverMethod<'a, E>,
    phase: &Cell<u8>,
    turns: f64,
) -> Result<Run, DiffsolError>
where
    E: OdeEquations<T = f64, V = NalgebraVec<f64>> + 'a,
{
    let foot = Foot::default();
    let (end, mut passed, mut events) = (turns * PERIOD, 0, 0);
    let stop = |solver: &mut _, passed: u32, phase: &Cell<u8>| {
        let stop = if FIND || phase.get() == FLIGHT { end } else { foot.pass(passed).min(end) };
        OdeSolverMethod::set_stop_time(solver, stop).map(|()| stop)
    };
    let mut until = stop(&mut solver, passed, phase)?;
    let mut longest: f64 = 0.0;
    loop {
        let before = solver.state().t;
        let reason = solver.step()?;
        match reason {
            OdeSolverStopReason::InternalTimestep => {
                longest = solver.state().t - before;
                continue;
            }
            OdeSolverStopReason::TstopReached if until == end => break,
            OdeSolverStopReason::TstopReached => {
                passed += 1;
                phase.set(if passed % 2 == 0 { PLATE } else { RACK });
                *solver.state_mut().t = until;
            }
            OdeSolverStopReason::RootFound(time, 1) => {
                solver.state_mut_back(time)?;
                passed += 1;
                phase.set(if phase.get() == RACK { PLATE } else { RACK });
            }
            OdeSolverStopReason::RootFound(time, _) => {
                solver.state_mut_back(time)?;
                while foot.pass(passed) <= time {
                    passed += 1;
                }
                phase.set(match (phase.get(), passed % 2) {
                    (FLIGHT, 0) => PLATE,
                    (FLIGHT, _) => RACK,
                    _ => FLIGHT,
                });
            }
        }
        events += 1;
        let state = solver.state_mut();
        let y = [state.y[0], state.y[1]];
        let rate = foot.rate_in(phase.get(), *state.t, &y);
        (state.dy[0], state.dy[1]) = (rate[0], rate[1]);
        *state.h = state.h.max(longest);
        until = stop(&mut solver, passed, phase)?;
    }
    let state = solver.state();
    let end = [state.y.get_index(0), state.y.get_index(1)];
    let statistics = solver.problem().eqn().rhs().statistics();
    Ok(Run { end, evaluations: statistics.number_of_calls, events })
}

/// Makes a function of a method.
macro_rules! method {
    ($(#[$text:meta])* $name:ident, $find:literal, $solver:ident $(::<$linear:ty>)?) => {
        $(#[$text])*
        pub fn $name(turns: f64, rtol: f64) -> Option<Run> {
            let phase = Cell::new(FLIGHT);
            let problem = problem::<$find>(rtol, &phase).ok()?;
            run::<_, $find>(problem.$solver$(::<$linear>)?().ok()?, &phase, turns).ok()
        }
    };
}

method! {
    /// Tsitouras, order 5.
    tsit45, false, tsit45
}
method! {
    /// The same, which finds all events.
    finding, true, tsit45
}
method! {
    /// Backward differences of variable order.
    bdf, false, bdf::<NalgebraLU<f64>>
}
method! {
    /// Diagonally implicit, order 4.
    esdirk34, false, esdirk34::<NalgebraLU<f64>>
}
