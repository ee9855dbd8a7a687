//! Ten thousand six-bars made at random, at 36 positions each: the solvers against a loop written for this six-bar alone.
//!
//! Both draw twelve uniform errors for each, close both dyads in closed form, and keep moments, extremes and classes of the
//! output's error at every position. The loop closes eight linkages side by side, turns the crank from position to position by
//! constant rotations, so that no sine is left there, and takes the error from a series for small angles.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use assur::dispatch::{Task, dispatch, dispatch_packs};
use assur::scalar::{Pack, Scalar, WIDTH};
use assur::shape::Distribution;
use assur::tolerance::{Sampling, Source, Study, monte_carlo};

use crate::hand_linkage::{DIMENSIONS, SixBar as Hand, inner, turned};
use crate::hand_random::{Blocks, Draw, Sums, drawn};
use crate::linkage::{SixBar, nominal};
use crate::spread::Spread;
use crate::table::{Table, at_least, number, verdict};

const SAMPLES: u64 = 10_000;
const PLACES: usize = 36;
/// Samples of a block: both threads have as many.
const BLOCK: u64 = 256;
const ROUNDS: usize = 101;
/// Classes of errors reach so far from zero, in radians.
const REACH: f64 = 0.03;
/// Largest ratio of the solvers to the loop, and least of one thread to two.
const GOAL: f64 = 1.1;
const TWO: f64 = 1.9;

/// Half-widths of the errors, in metres and radians.
fn tolerances() -> [f64; DIMENSIONS] {
    let (length, angle) = (5e-5, 0.1f64.to_radians());
    std::array::from_fn(|index| if index == 4 || index == 11 { angle } else { length })
}

/// A position: the turn of the crank, and the unit vector of the nominal output.
#[derive(Clone, Copy)]
struct Place {
    turn: [f64; 2],
    output: [f64; 2],
}

fn places() -> [Place; PLACES] {
    let (dimensions, modes) = nominal();
    let bar = Hand::new(dimensions, modes);
    std::array::from_fn(|index| {
        let (sine, cosine) = (TAU * index as f64 / PLACES as f64 + dimensions[11]).sin_cos();
        let output = bar.closed([cosine, sine]).output();
        let (sine, cosine) = (TAU * index as f64 / PLACES as f64).sin_cos();
        Place { turn: [cosine, sine], output }
    })
}

/// The angle of a small tangent.
#[inline(always)]
fn small_angle<S: Scalar>(tangent: S) -> S {
    let square = tangent * tangent;
    let mut sum = S::from_f64(-1.0 / 11.0);
    for (factor, sign) in [(9.0, 1.0), (7.0, -1.0), (5.0, 1.0), (3.0, -1.0), (1.0, 1.0)] {
        sum = sum.mul_add(square, S::from_f64(sign / factor));
    }
    tangent * sum
}

/// The samples of a block.
struct Drawn<'a> {
    samples: (u64, u64),
    places: &'a [Place; PLACES],
    sums: &'a mut [Sums],
}

impl Task for Drawn<'_> {
    type Output = ();

    /// Draws as many side by side as a pack holds.
    #[inline(always)]
    fn run<P: Pack>(self) {
        let ((dimensions, modes), tolerances) = (nominal(), tolerances());
        for first in (self.samples.0..self.samples.1).step_by(P::WIDTH) {
            let mut made = [[0.0; WIDTH]; DIMENSIONS];
            let mut draw = Draw::from(first * DIMENSIONS as u64);
            for lane in 0..P::WIDTH {
                for (k, made) in made.iter_mut().enumerate() {
                    made[lane] = dimensions[k] + draw.error(tolerances[k]);
                }
            }
            let mut numbers = [P::ZERO; DIMENSIONS];
            for (number, made) in numbers.iter_mut().zip(made) {
                *number = P::load(&made);
            }
            let bar = Hand::new(numbers, modes);
            let (sine, cosine) = numbers[11].sin_cos();
            let count = P::WIDTH.min((self.samples.1 - first) as usize);
            for (place, sums) in self.places.iter().zip(&mut *self.sums) {
                let turn = place.turn.map(P::from_f64);
                let crank = [
                    turn[0].mul_add(cosine, -(turn[1] * sine)),
                    turn[0].mul_add(sine, turn[1] * cosine),
                ];
                let (made, output) = (bar.closed(crank).output(), place.output.map(P::from_f64));
                let mut errors = [0.0; WIDTH];
                small_angle(turned(made, output) / inner(made, output)).store(&mut errors);
                for error in &errors[..count] {
                    sums.add(*error);
                }
            }
        }
    }
}

/// The loop on so many threads: the standard deviation at every position.
fn by_hand(threads: u64, places: &[Place; PLACES], side: bool) -> Vec<f64> {
    let blocks = Blocks { samples: SAMPLES, size: BLOCK };
    let sums = drawn(threads, &blocks, &vec![Sums::new(REACH); PLACES], |samples, sums| {
        let drawn = Drawn { samples, places, sums };
        match side {
            true => dispatch_packs(drawn),
            false => dispatch(drawn),
        }
    });
    sums.iter().map(Sums::deviation).collect()
}

/// The solvers, as a program asks them.
fn solvers(threads: u64, study: &Study) -> Vec<f64> {
    let sampling = Sampling { samples: SAMPLES, threads: threads as usize, ..Sampling::default() };
    let found = monte_carlo(&SixBar::default(), study, &sampling, &|_| ());
    found.expect("it assembles").places.iter().map(|place| place.deviation.value).collect()
}

fn study() -> Study {
    let source = |(variable, half_width): (usize, f64)| Source {
        variable,
        half_width,
        distribution: Distribution::Uniform,
    };
    Study {
        output: 0,
        places: (0..PLACES).map(|index| vec![TAU * index as f64 / PLACES as f64]).collect(),
        sources: tolerances().into_iter().enumerate().map(source).collect(),
    }
}

/// Seconds of the solvers on one thread, the shortest of some rounds, and the standard deviation at the first position.
#[cfg(feature = "peers")]
pub fn asked() -> (f64, f64) {
    let study = study();
    let seconds = |()| {
        let clock = Instant::now();
        black_box(solvers(1, &study));
        clock.elapsed().as_secs_f64()
    };
    let least = [(); ROUNDS].map(seconds).into_iter().fold(f64::INFINITY, f64::min);
    (least, solvers(1, &study)[0])
}

/// Prints the times, each on one thread and on two.
pub fn report() {
    let (places, study) = (places(), study());
    let title = "Ten thousand six-bars made at random, at 36 positions";
    let columns =
        ["code", "1 thread, ms", "ratio", "2 threads, ms", "ratio", "deviation at 0 deg, mrad"];
    let mut table = Table::new(title, &columns);
    type Code<'a> = (&'a str, Box<dyn Fn(u64) -> Vec<f64> + 'a>);
    let codes: [Code<'_>; 3] = [
        ("hand, eight side by side", Box::new(|threads| by_hand(threads, &places, true))),
        ("hand, one at a time", Box::new(|threads| by_hand(threads, &places, false))),
        ("solvers", Box::new(|threads| solvers(threads, &study))),
    ];
    let mut all = [(); 3].map(|()| [(); 2].map(|()| Vec::new()));
    for _ in 0..ROUNDS {
        for (times, (_, code)) in all.iter_mut().zip(&codes) {
            for (threads, times) in [1, 2].into_iter().zip(times) {
                let clock = Instant::now();
                black_box(code(threads));
                times.push(1e3 * clock.elapsed().as_secs_f64());
            }
        }
    }
    let least = |times: &[f64]| times.iter().copied().reduce(f64::min);
    for ((name, code), [one, two]) in codes.iter().zip(&all) {
        table.row([
            (*name).to_owned(),
            number(least(one)),
            Spread::text(Spread::of(one, &all[0][0]).as_ref()),
            number(least(two)),
            Spread::text(Spread::of(two, &all[0][1]).as_ref()),
            format!("{:.5}", 1e3 * code(2)[0]),
        ]);
    }
    table.print();
    for (threads, (found, limit)) in (1..).zip(all[2].iter().zip(&all[0])) {
        let what = format!("W5, solvers / best hand-written loop, {threads} threads");
        verdict(&what, least(found), least(limit), GOAL);
    }
    at_least("W5, solvers, one thread / two", least(&all[2][0]), least(&all[2][1]), TWO);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_loop_finds_what_the_solvers_find() {
        let (places, study) = (places(), study());
        let expected = solvers(1, &study);
        for side in [true, false] {
            let found = by_hand(2, &places, side);
            assert_eq!(found.len(), expected.len());
            for (one, other) in found.iter().zip(&expected) {
                assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
            }
        }
    }
}
