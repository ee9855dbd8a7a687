//! Other libraries on the same equations, at equal achieved error.
//!
//! Libraries of Rust get the hand-written right-hand side, the fastest one for plain numbers, so that the steppers are
//! compared; only the state at the end is asked for. Assur's stepper runs on that right-hand side too, and on the
//! emitted code as a program runs it. SciPy and CasADi, whose integrators are those of SUNDIALS, get the equations in
//! Python (`peers.py`).

mod differential_equations;
mod diffsol;
pub mod foot;
mod foot_diffsol;
mod linkage;
mod ode_solvers;
mod scripts;
mod search;
pub mod squeezer;
pub mod stiff;

use assur::ode::Explicit;

use crate::equal::{Peer, all_runs, at_error, peer, points};
use crate::hand_loop::Run;
use crate::hand_system;
use crate::revolutions::{emitted, error, reference};

/// Achieved errors at which times are compared, in metres.
const ERRORS: [f64; 2] = [1e-11, 1e-13];

/// All that are compared, ours first.
const PEERS: [Peer<Run>; 11] = [
    peer("Assur, emitted", "dop853", |rtol| finished(emitted(Explicit::Dop853, rtol))),
    peer("Assur, emitted", "tsit5", |rtol| finished(emitted(Explicit::Tsit5, rtol))),
    peer("Assur, hand-written equations", "dop853", |rtol| {
        finished(hand_system::run(Explicit::Dop853, rtol))
    }),
    peer("Assur, hand-written equations", "tsit5", |rtol| {
        finished(hand_system::run(Explicit::Tsit5, rtol))
    }),
    peer("differential-equations", "dop853", differential_equations::dop853),
    peer("differential-equations", "dopri5", differential_equations::dopri5),
    peer("differential-equations", "rkv988e", differential_equations::verner),
    peer("ode_solvers, time as a state", "dop853", ode_solvers::dop853),
    peer("ode_solvers", "dopri5", ode_solvers::dopri5),
    peer("diffsol", "tsit45", diffsol::tsit45),
    peer("diffsol", "bdf", diffsol::bdf),
];

/// A run of Assur, which counts no evaluations when it fails.
fn finished(run: Run) -> Option<Run> {
    (run.evaluations > 0).then_some(run)
}

/// Where a workload is compared, by its name.
const WORKLOADS: [(&str, fn()); 7] = [
    ("linkage", linkage::positions),
    ("revolutions", report),
    ("stiff", stiff::report),
    ("squeezer", squeezer::report),
    ("monte-carlo", linkage::random),
    ("foot", foot::report),
    ("search", search::report),
];

/// Compares on a workload, or on all; false if there is none of that name.
pub fn compare(workload: Option<&str>) -> bool {
    let chosen = WORKLOADS.iter().filter(|(name, _)| workload.is_none_or(|one| one == *name));
    chosen.map(|(_, report)| report()).count() > 0
}

/// Measures and prints.
fn report() {
    let reference = reference();
    let mut points = points(&PEERS, |run| (error(&run.end, &reference), run.evaluations));
    let mut names = PEERS.map(|peer| [peer.library, peer.method]).to_vec();
    scripts::add("batten", &mut names, &mut points);
    all_runs("Ten revolutions, all runs", "error, m", &names, &points);
    for error in ERRORS {
        let title = format!("Ten revolutions, time for an error of {error:e} m");
        let yardsticks = [("Assur", 0), ("Assur, same equations", 2)];
        at_error(&title, error, &names, &points, yardsticks);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_library_finds_the_motion() {
        let reference = reference();
        for peer in PEERS {
            let run = (peer.run)(1e-8).expect(peer.library);
            let error = error(&run.end, &reference);
            assert!(error < 1e-7, "{}, {}: {error}", peer.library, peer.method);
            assert!(run.evaluations > 1000);
        }
    }
}
