//! The presser foot by other libraries, at equal achieved error.
//!
//! All start in the motion that repeats and end ten turns later, where they should be where they began. The libraries
//! get the hand-written equations and the instants at which the rack passes the plate, but "diffsol, all found", which
//! finds those as it finds the other events.

use assur::answer::Method;

use super::{foot_diffsol, scripts};
use crate::equal::{Peer, Point, all_runs, peer, points, time_at};
use crate::foot::{Run, START, assur_by, error, hand};
use crate::table::{Table, at_least, number, ratio};

/// Turns of the shaft.
pub const TURNS: f64 = 10.0;
/// Achieved errors at which times are compared, in metres.
const ERRORS: [f64; 3] = [1e-9, 1e-11, 1e-13];
/// How many times as fast Assur is to be.
const GOALS: [(&str, f64); 3] = [("diffsol", 3.0), ("diffsol, all found", 3.0), ("SciPy", 100.0)];

/// All that are compared, ours first.
const PEERS: [Peer<Run>; 8] = [
    peer("Assur, emitted", "dop853", |rtol| Some(assur_by(Method::Dop853, TURNS, rtol))),
    peer("Assur, emitted", "tsit5", |rtol| Some(assur_by(Method::Tsit5, TURNS, rtol))),
    peer("Assur, emitted", "taylor", |rtol| Some(assur_by(Method::Taylor, TURNS, rtol))),
    peer("hand, motion kept", "dop853", |rtol| Some(hand::<true, true>(TURNS, rtol))),
    peer("diffsol", "tsit45", |rtol| foot_diffsol::tsit45(TURNS, rtol)),
    peer("diffsol, all found", "tsit45", |rtol| foot_diffsol::finding(TURNS, rtol)),
    peer("diffsol", "bdf", |rtol| foot_diffsol::bdf(TURNS, rtol)),
    peer("diffsol", "esdirk34", |rtol| foot_diffsol::esdirk34(TURNS, rtol)),
];

/// Measures and prints.
pub fn report() {
    let mut names: Vec<[&str; 2]> = PEERS.map(|peer| [peer.library, peer.method]).to_vec();
    let said = |run: &Run| (error(&run.end, &START), run.evaluations);
    let mut all: Vec<Vec<Option<Point>>> = points(&PEERS, said);
    let scipy = scripts::points(&["foot.py"], &["DOP853", "RK45", "LSODA", "Radau"]);
    if scipy.is_empty() {
        println!("SciPy is not compared: `python3 foot.py` does not run.");
    }
    for (method, points) in scipy {
        names.push(["SciPy", method]);
        all.push(points);
    }
    all_runs("Ten turns of the presser foot, all runs", "error, m", &names, &all);
    for error in ERRORS {
        let columns = ["library", "method", "time, us", "/ Assur"];
        let title = format!("Ten turns of the presser foot, time for an error of {error:e} m");
        let mut table = Table::new(&title, &columns);
        let times: Vec<Option<f64>> = all.iter().map(|all| time_at(error, all)).collect();
        let pairs = || names.iter().zip(&times);
        let best = |library: &str| {
            let found = pairs().filter(|([name, _], _)| name.starts_with(library));
            found.filter_map(|(_, time)| *time).reduce(f64::min)
        };
        let ours = best("Assur");
        for ([library, method], time) in pairs() {
            table.row([
                (*library).to_owned(),
                (*method).to_owned(),
                number(time.map(|time| time * 1e6)),
                ratio(*time, ours),
            ]);
        }
        table.print();
        for (library, times) in GOALS {
            let what = format!("best of {library} / Assur, error {error:e} m");
            at_least(&what, best(library), ours, times);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_library_finds_the_motion() {
        for peer in PEERS {
            let run = (peer.run)(1e-8).expect(peer.library);
            let error = error(&run.end, &START);
            assert!(error < 1e-8, "{}, {}: {error}", peer.library, peer.method);
            assert_eq!(run.events, 50, "{}, {}", peer.library, peer.method);
        }
    }
}
