//! Times at equal achieved error: each method runs at many tolerances, and what it takes is read where it is as accurate as the
//! others.

use std::hint::black_box;
use std::time::Instant;

use crate::spread::Spread;
use crate::table::{Table, number, power, ratio};

/// Relative tolerances that every method runs with.
pub const RTOLS: [f64; 9] = [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];
/// Times that every run is repeated at most, and seconds after which it is not.
const ROUNDS: usize = 30;
const BUDGET: f64 = 0.6;

/// A method of a library.
pub struct Peer<R> {
    pub library: &'static str,
    pub method: &'static str,
    /// The motion at a relative tolerance, if the library gets through.
    pub run: fn(f64) -> Option<R>,
}

/// A method of a library.
pub const fn peer<R>(
    library: &'static str,
    method: &'static str,
    run: fn(f64) -> Option<R>,
) -> Peer<R> {
    Peer { library, method, run }
}

/// One run of a peer and its shortest time in seconds.
pub struct Point {
    pub rtol: f64,
    pub error: f64,
    pub evaluations: usize,
    pub seconds: f64,
    /// Seconds of each round, where they are known.
    pub rounds: Vec<f64>,
}

/// Runs everything in turn and keeps the shortest times. `said` gives the error of a run and its evaluations.
pub fn points<R>(peers: &[Peer<R>], said: impl Fn(&R) -> (f64, usize)) -> Vec<Vec<Option<Point>>> {
    let first = |peer: &Peer<R>, rtol| {
        let (error, evaluations) = said(&(peer.run)(rtol)?);
        error.is_finite().then(|| Point {
            rtol,
            error,
            evaluations,
            seconds: f64::INFINITY,
            rounds: Vec::new(),
        })
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
                point.rounds.push(seconds);
                *spent += seconds;
            }
        }
    }
    points
}

/// Time in which an error is achieved, in seconds, by straight lines between the logarithms, or that of a run that is
/// more accurate and faster. None where all runs are less accurate.
pub fn time_at(error: f64, points: &[Option<Point>]) -> Option<f64> {
    time_of(error, points, |point| point.seconds)
}

fn time_of(error: f64, points: &[Option<Point>], seconds: impl Fn(&Point) -> f64) -> Option<f64> {
    let points: Vec<&Point> = points.iter().flatten().collect();
    let pairs = points.windows(2).filter_map(|pair| {
        let (coarse, fine) = (pair[0], pair[1]);
        if !(fine.error..=coarse.error).contains(&error) || fine.error == coarse.error {
            return None;
        }
        let share = (coarse.error / error).ln() / (coarse.error / fine.error).ln();
        let (slow, fast) = (seconds(fine), seconds(coarse));
        Some((fast.ln() + share * (slow / fast).ln()).exp())
    });
    let better = points.iter().filter(|point| point.error <= error);
    pairs.chain(better.map(|point| seconds(point))).reduce(f64::min)
}

/// What [`time_at`] gives in each round. Runs that take too long for so many rounds count with their shortest time.
fn times_at(error: f64, points: &[Option<Point>]) -> Vec<f64> {
    let rounds = points.iter().flatten().map(|point| point.rounds.len()).max().unwrap_or(0);
    let seconds = |point: &Point, round: usize| match point.rounds.get(round) {
        Some(seconds) => *seconds,
        None => point.seconds,
    };
    (0..rounds).filter_map(|round| time_of(error, points, |point| seconds(point, round))).collect()
}

/// The time for an error over that of another method: with its spread, where both ran in turn.
pub fn over(error: f64, points: &[Option<Point>], reference: &[Option<Point>]) -> String {
    let pair = [points, reference].map(|points| times_at(error, points));
    match Spread::of(&pair[0], &pair[1]) {
        Some(spread) => Spread::text(Some(&spread)),
        None => ratio(time_at(error, points), time_at(error, reference)),
    }
}

/// The table of times at an error, over those of two of the methods.
pub fn at_error(
    title: &str,
    error: f64,
    names: &[[&str; 2]],
    points: &[Vec<Option<Point>>],
    yardsticks: [(&str, usize); 2],
) {
    let heads = yardsticks.map(|(name, _)| format!("/ {name}"));
    let columns = ["library", "method", "time, us", &heads[0], &heads[1]];
    let mut table = Table::new(title, &columns);
    let times: Vec<Option<f64>> = points.iter().map(|all| time_at(error, all)).collect();
    for ((names, time), one) in names.iter().zip(&times).zip(points) {
        let ratios = yardsticks.map(|(_, index)| over(error, one, &points[index]));
        let row = names.map(str::to_owned).into_iter();
        table.row(row.chain([number(time.map(|time| time * 1e6))]).chain(ratios));
    }
    table.print();
}

/// The table of all runs; `error` says in what errors are.
pub fn all_runs(title: &str, error: &str, names: &[[&str; 2]], points: &[Vec<Option<Point>>]) {
    let columns =
        ["library", "method", "rtol", "evaluations", error, "time, us", "ns / evaluation"];
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
        let point = |error, seconds| {
            Some(Point { rtol: 0.0, error, evaluations: 1, seconds, rounds: vec![seconds] })
        };
        let points = [point(1e-8, 1.0), None, point(1e-10, 4.0), point(1e-9, 5.0)];
        assert!((time_at(1e-9, &points).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(time_at(1e-12, &points), None);
        assert_eq!(over(1e-9, &points, &points), "1.00 (1.00–1.00)");
    }

    #[test]
    fn a_run_that_is_too_long_for_many_rounds_does_not_end_those_of_others() {
        let point = |error, rounds: &[f64]| {
            let (seconds, rounds) =
                (rounds.iter().copied().fold(f64::MAX, f64::min), rounds.to_vec());
            Some(Point { rtol: 0.0, error, evaluations: 1, seconds, rounds })
        };
        let points = [point(1e-5, &[9.0, 1.0, 1.0]), point(1e-9, &[50.0])];
        assert_eq!(times_at(1e-5, &points), [9.0, 1.0, 1.0]);
    }
}
