//! Other libraries on the same equations, at equal achieved error.
//!
//! Every library gets the hand-written right-hand side, the fastest one for plain numbers, so that the steppers are
//! compared; only the state at the end is asked for. Assur's stepper runs on that right-hand side too, and on the
//! emitted code as a program runs it.

mod differential_equations;
mod diffsol;
pub mod foot;
mod foot_diffsol;
mod foot_scipy;
mod ode_solvers;

use std::hint::black_box;
use std::time::Instant;

use assur::ode::Explicit;

use crate::hand_loop::Run;
use crate::hand_system;
use crate::revolutions::{emitted, error, reference};
use crate::table::{Table, number, power, ratio};

/// Relative tolerances that every method runs with; the absolute ones are `revolutions::SCALE` times as
/// large.
const RTOLS: [f64; 9] = [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];
/// Achieved errors at which times are compared, in metres.
const ERRORS: [f64; 2] = [1e-11, 1e-13];
/// Times that every run is repeated at most, and seconds after which it is not.
const ROUNDS: usize = 30;
const BUDGET: f64 = 0.6;

/// A method of a library.
struct Peer<R> {
    library: &'static str,
    method: &'static str,
    /// The motion at a relative tolerance, if the library gets through.
    run: fn(f64) -> Option<R>,
}

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

const fn peer<R>(
    library: &'static str,
    method: &'static str,
    run: fn(f64) -> Option<R>,
) -> Peer<R> {
    Peer { library, method, run }
}

/// A run of Assur, which counts no evaluations when it fails.
fn finished(run: Run) -> Option<Run> {
    (run.evaluations > 0).then_some(run)
}

/// One run of a peer and its shortest time in seconds.
struct Point {
    rtol: f64,
    error: f64,
    evaluations: usize,
    seconds: f64,
}

/// Runs everything in turn and keeps the shortest times. `said` gives the error of a run and its evaluations.
fn points<R>(peers: &[Peer<R>], said: impl Fn(&R) -> (f64, usize)) -> Vec<Vec<Option<Point>>> {
    let first = |peer: &Peer<R>, rtol| {
        let (error, evaluations) = said(&(peer.run)(rtol)?);
        error.is_finite().then_some(Point { rtol, error, evaluations, seconds: f64::INFINITY })
    };
    let mut points: Vec<Vec<Option<Point>>> =
        peers.iter().map(|peer| RTOLS.iter().map(|rtol| first(peer, *rtol)).collect()).collect();
    let mut spent = vec![[0.0; RTOLS.len()]; peers.len()];
    for _ in 0..ROUNDS {
        for ((peer, points), spent) in peers.iter().zip(&mut points).zip(&mut spent) {
            for (point, spent) in points.iter_mut().zip(spent) {
                let Some(point) = point.as_mut().filter(|_| *spent < BUDGET) else {
                    continue;
                };
                let start = Instant::now();
                black_box((peer.run)(black_box(point.rtol)));
                let seconds = start.elapsed().as_secs_f64();
                point.seconds = point.seconds.min(seconds);
                *spent += seconds;
            }
        }
    }
    points
}

/// Time in which an error is achieved, in seconds, by straight lines between the logarithms, or that of a run that is
/// more accurate and faster. None where all runs are less accurate.
fn time_at(error: f64, points: &[Option<Point>]) -> Option<f64> {
    let points: Vec<&Point> = points.iter().flatten().collect();
    let pairs = points.windows(2).filter_map(|pair| {
        let (coarse, fine) = (pair[0], pair[1]);
        if !(fine.error..=coarse.error).contains(&error) || fine.error == coarse.error {
            return None;
        }
        let share = (coarse.error / error).ln() / (coarse.error / fine.error).ln();
        Some((coarse.seconds.ln() + share * (fine.seconds / coarse.seconds).ln()).exp())
    });
    let better = points.iter().filter(|point| point.error <= error);
    pairs.chain(better.map(|point| point.seconds)).reduce(f64::min)
}

/// Measures and prints.
pub fn report() {
    let reference = reference();
    let points = points(&PEERS, |run| (error(&run.end, &reference), run.evaluations));
    let names = PEERS.map(|peer| [peer.library, peer.method]);
    all_runs("Ten revolutions, all runs", &names, &points);
    for error in ERRORS {
        let columns = ["library", "method", "time, us", "/ Assur", "/ Assur, same equations"];
        let title = format!("Ten revolutions, time for an error of {error:e} m");
        let mut table = Table::new(&title, &columns);
        let times: Vec<Option<f64>> = points.iter().map(|all| time_at(error, all)).collect();
        for (peer, time) in PEERS.iter().zip(&times) {
            table.row([
                peer.library.to_owned(),
                peer.method.to_owned(),
                number(time.map(|time| time * 1e6)),
                ratio(*time, times[0]),
                ratio(*time, times[2]),
            ]);
        }
        table.print();
    }
}

/// The table of all runs.
fn all_runs(title: &str, names: &[[&str; 2]], points: &[Vec<Option<Point>>]) {
    let columns =
        ["library", "method", "rtol", "evaluations", "error, m", "time, us", "ns / evaluation"];
    let mut table = Table::new(title, &columns);
    for (names, points) in names.iter().zip(points) {
        for (point, rtol) in points.iter().zip(RTOLS) {
            let mut row = names.map(str::to_owned).to_vec();
            row.push(format!("{rtol:e}"));
            match point {
                None => row.push("fails".to_owned()),
                Some(point) => row.extend([
                    point.evaluations.to_string(),
                    power(point.error),
                    number(Some(point.seconds * 1e6)),
                    number(Some(point.seconds * 1e9 / point.evaluations as f64)),
                ]),
            }
            table.row(row);
        }
    }
    table.print();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_interpolated() {
        let point = |error, seconds| Some(Point { rtol: 0.0, error, evaluations: 1, seconds });
        let points = [point(1e-8, 1.0), None, point(1e-10, 4.0), point(1e-9, 5.0)];
        assert!((time_at(1e-9, &points).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(time_at(1e-12, &points), None);
    }

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
