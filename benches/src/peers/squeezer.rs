//! Andrews' squeezing mechanism by other libraries. Those of Rust get it as it is reduced by hand; SciPy and IDAS get its
//! seven bodies and six closures, which is what one writes for them.

use assur::ode::Explicit;
use assur_equations::andrews::Squeeze;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::ExplicitRungeKutta;
use diffsol::OdeEquations;
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason, Op};

use super::differential_equations::Silent;
use super::scripts;
use crate::equal::{Peer, all_runs, at_error, peer, points};
use crate::freedom::{emitted, error};
use crate::hand_freedom::Run;
use crate::hand_squeezer::{START, acceleration, run};
use crate::squeezer::{END, REFERENCE, SCALE};

/// Achieved errors at which times are compared.
const ERRORS: [f64; 2] = [1e-6, 1e-9];

/// All that are compared, ours first.
const PEERS: [Peer<Run>; 5] = [
    peer("Assur, emitted", "dop853", |rtol| {
        Some(emitted(&Squeeze::default(), Explicit::Dop853, (END, rtol)))
    }),
    peer("Assur, emitted", "tsit5", |rtol| {
        Some(emitted(&Squeeze::default(), Explicit::Tsit5, (END, rtol)))
    }),
    peer("reduced by hand, fused", "dop853", |rtol| Some(run(END, rtol, SCALE))),
    peer("differential-equations", "dop853", dop853),
    peer("diffsol", "tsit45", tsit45),
];

/// The mechanism reduced by hand.
struct Reduced;

impl ODE<f64, [f64; 2]> for Reduced {
    #[inline(always)]
    fn diff(&self, _time: f64, y: &[f64; 2], rate: &mut [f64; 2]) {
        *rate = [y[1], acceleration(y[0], y[1])];
    }
}

fn dop853(rtol: f64) -> Option<Run> {
    let method = ExplicitRungeKutta::dop853();
    let mut method = method.rtol(rtol).atol(rtol * SCALE).max_steps(1_000_000);
    let solution = solve_ode(&mut method, &Reduced, 0.0, END, &START, &mut Silent).ok()?;
    Some(Run { end: *method.y(), evaluations: solution.evals.function })
}

fn tsit45(rtol: f64) -> Option<Run> {
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(rtol)
        .atol([rtol * SCALE; 2])
        .rhs(|y: &[f64], _: &[f64], _: f64, rate: &mut [f64]| {
            (rate[0], rate[1]) = (y[1], acceleration(y[0], y[1]));
        })
        .init(|_, _, y| y.copy_from_slice(&START), START.len())
        .build()
        .ok()?;
    let mut solver = problem.tsit45().ok()?;
    solver.set_stop_time(END).ok()?;
    while !matches!(solver.step().ok()?, OdeSolverStopReason::TstopReached) {}
    let state = solver.state();
    let end = [state.y[0], state.y[1]];
    let statistics = solver.problem().eqn().rhs().statistics();
    Some(Run { end, evaluations: statistics.number_of_calls })
}

/// Measures and prints.
pub fn report() {
    let mut points = points(&PEERS, |run| (error(run, REFERENCE), run.evaluations));
    let mut names = PEERS.map(|peer| [peer.library, peer.method]).to_vec();
    scripts::add("squeezer", &mut names, &mut points);
    all_runs("Andrews' squeezing mechanism, all runs", "error", &names, &points);
    for error in ERRORS {
        let what = format!("Andrews' squeezing mechanism, time for a relative error of {error:e}");
        let yardsticks = [("Assur", 0), ("reduced by hand", 2)];
        at_error(&what, error, &names, &points, yardsticks);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_library_finds_the_end() {
        for peer in PEERS {
            let run = (peer.run)(1e-9).expect(peer.library);
            assert!(error(&run, REFERENCE) < 1e-6, "{}: {run:?}", peer.library);
        }
    }
}
