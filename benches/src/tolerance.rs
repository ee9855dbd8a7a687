//! Linkages made at random: the heald linkage by the solvers against a loop written for it alone.
//!
//! Both draw eight uniform errors by SplitMix64, predict the three angles from their derivatives, and correct them by
//! Newton's method to the same accuracy; both add up moments, extremes and classes. The loop knows that there is one group
//! of three equations, one output and one distribution.

use std::hint::black_box;
use std::time::Instant;

use assur::closure::{Assembly, Linkage};
use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;
use assur::shape::Distribution;
use assur::tolerance::{Sampling, Source, Study, monte_carlo};
use assur_equations::heald_linkage::Printed;

use crate::hand_random::{Blocks, Draw, Sums, drawn};
use crate::table::{Table, number, verdict};

const SAMPLES: u64 = 1_000_000;
const ROUNDS: usize = 9;
const BLOCK: u64 = 4096;
/// Classes of errors reach so far from zero, in radians.
const REACH: f64 = 2.5e-3;
/// Largest ratio of the solvers to the loop.
const GOAL: f64 = 1.2;
/// Constants `l4, l5, l6, l7, a, b, s` and the drive angle.
const NOMINAL: [f64; 8] = [0.09, 0.23, 0.18, 0.12, 0.08, 0.105, 0.04, std::f64::consts::FRAC_PI_2];

/// Half-widths of the errors.
fn tolerances() -> [f64; 8] {
    let angle = 0.1f64.to_radians();
    [5e-5, 5e-5, 5e-5, 5e-5, 1e-4, 1e-4, 1e-4, angle]
}

/// Residuals and Jacobian of the loops.
#[inline(always)]
fn loops<S: Scalar>(p: [S; 8], drive: (S, S), z: [S; 3]) -> ([S; 3], [S; 9]) {
    let [l4, l5, l6, l7, a, b, s, _] = p;
    let ([s5, s6, s7], [c5, c6, c7]) = S::sin_cos_all(z);
    let (x5, y5, x6, y6, x7, y7) = (l5 * c5, l5 * s5, l6 * c6, l6 * s6, l7 * c7, l7 * s7);
    (
        [l4.mul_add(drive.1, x5 - x6 - x7 - b), l4.mul_add(drive.0, y5 - y6 - y7 - a), x6 - s - x7],
        [-y5, y6, y7, x5, -x6, -x7, S::ZERO, -y6, y7],
    )
}

/// The Newton step, subtracted from the angles.
#[inline(always)]
fn step<S: Scalar>(f: [S; 3], m: [S; 9]) -> [S; 3] {
    let minor = |a: S, b: S, c: S, d: S| a.mul_add(d, -(b * c));
    let (a, b, c) = (
        minor(m[4], m[5], m[7], m[8]),
        minor(m[2], m[1], m[8], m[7]),
        minor(m[1], m[2], m[4], m[5]),
    );
    let inverse = S::ONE / a.mul_add(m[0], b * m[3]);
    [
        (a * f[0] + b * f[1] + c * f[2]) * inverse,
        (-(m[3] * m[8]) * f[0] + m[0] * m[8] * f[1] + minor(m[2], m[0], m[5], m[3]) * f[2])
            * inverse,
        (m[3] * m[7] * f[0] - m[0] * m[7] * f[1] + minor(m[0], m[1], m[3], m[4]) * f[2]) * inverse,
    ]
}

/// The loop over one block.
struct Hand<'a> {
    from: u64,
    to: u64,
    start: [f64; 3],
    tangents: &'a [[f64; 8]; 3],
    sums: &'a mut Sums,
}

impl Task for Hand<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Scalar>(self) {
        let tolerances = tolerances();
        let nominal = NOMINAL.map(S::from_f64);
        let start = self.start.map(S::from_f64);
        let mut draw = Draw::from(self.from * 8);
        for _ in self.from..self.to {
            let (mut p, mut errors) = (nominal, [S::ZERO; 8]);
            for k in 0..8 {
                errors[k] = S::from_f64(draw.error(tolerances[k]));
                p[k] = p[k] + errors[k];
            }
            let drive = p[7].sin_cos();
            let (mut z, mut before) = (start, 0.0);
            for (angle, tangent) in z.iter_mut().zip(self.tangents) {
                let mut moved = S::ZERO;
                for k in 0..8 {
                    moved = errors[k].mul_add(S::from_f64(tangent[k]), moved);
                }
                *angle = *angle + moved;
                before = f64::max(before, moved.abs().to_f64());
            }
            let enough = 1e-8 * before + 1e-11;
            loop {
                let (f, m) = loops(p, drive, z);
                let correction = step(f, m);
                let mut length = 0.0;
                for (angle, part) in z.iter_mut().zip(correction) {
                    *angle = *angle - part;
                    length = f64::max(length, part.abs().to_f64());
                }
                if length * length * length <= enough * (before * before) {
                    break;
                }
                before = length;
            }
            self.sums.add((z[2] - start[2]).to_f64());
        }
    }
}

/// The loop on so many threads.
fn by_hand(threads: u64, start: [f64; 3], tangents: &[[f64; 8]; 3], fused: bool) -> Sums {
    let blocks = Blocks { samples: SAMPLES, size: BLOCK };
    let mut sums = drawn(threads, &blocks, &[Sums::new(REACH)], |(from, to), sums| {
        let task = Hand { from, to, start, tangents, sums: &mut sums[0] };
        match fused {
            true => dispatch(task),
            false => task.run::<f64>(),
        }
    });
    sums.remove(0)
}

/// The nominal angles and their derivatives by the errors.
fn nominal() -> ([f64; 3], [[f64; 8]; 3]) {
    let linkage = Printed::default();
    let closed = |p: [f64; 8]| {
        let made = Printed::default().with_values(&p[..7]);
        let mut assembly = Assembly::<Printed, f64>::new(&made);
        assembly.start().expect("it assembles");
        assembly.move_to(&p[7..]).expect("it moves there");
        [0, 1, 2].map(|k| assembly.position()[k])
    };
    assert_eq!(Linkage::values(&linkage), NOMINAL[..7]);
    let mut tangents = [[0.0; 8]; 3];
    for k in 0..8 {
        let moved = |sign: f64| {
            let mut p = NOMINAL;
            p[k] += sign * 1e-6;
            closed(p)
        };
        let (plus, minus) = (moved(1.0), moved(-1.0));
        for row in 0..3 {
            tangents[row][k] = (plus[row] - minus[row]) / 2e-6;
        }
    }
    (closed(NOMINAL), tangents)
}

/// Prints the times of a million linkages.
pub fn report() {
    let (start, tangents) = nominal();
    let study = study();
    let mut table = Table::new(
        "A million heald linkages made at random",
        &["code", "1 thread, ms", "2 threads, ms", "standard deviation, mrad"],
    );
    let solvers = |threads: u64| {
        let sampling =
            Sampling { samples: SAMPLES, threads: threads as usize, ..Sampling::default() };
        let found = monte_carlo(&Printed::default(), &study, &sampling, &|_| ());
        found.expect("it assembles").places[0].deviation.value
    };
    type Code<'a> = (&'a str, Box<dyn Fn(u64) -> f64 + 'a>);
    let codes: [Code<'_>; 3] = [
        ("hand, plain", Box::new(|n| by_hand(n, start, &tangents, false).deviation())),
        ("hand, dispatched", Box::new(|n| by_hand(n, start, &tangents, true).deviation())),
        ("solvers", Box::new(solvers)),
    ];
    let mut best = [[f64::INFINITY; 2]; 3];
    for _ in 0..ROUNDS {
        for (row, (_, code)) in best.iter_mut().zip(&codes) {
            for (threads, slot) in [1, 2].into_iter().zip(row) {
                let clock = Instant::now();
                black_box(code(threads));
                *slot = slot.min(1e3 * clock.elapsed().as_secs_f64());
            }
        }
    }
    for ((name, code), [one, two]) in codes.iter().zip(best) {
        let deviation = format!("{:.5}", 1e3 * code(2));
        table.row([name.to_string(), number(Some(one)), number(Some(two)), deviation]);
    }
    table.print();
    let [plain, dispatched, solved] = best;
    for (i, found) in solved.into_iter().enumerate() {
        let (threads, limit) = (i + 1, f64::min(plain[i], dispatched[i]));
        let what = format!("solvers / best hand-written loop, {threads} threads");
        verdict(&what, Some(found), Some(limit), GOAL);
    }
}

fn study() -> Study {
    let source = |(variable, half_width): (usize, f64)| Source {
        variable,
        half_width,
        distribution: Distribution::Uniform,
    };
    Study {
        output: 2,
        places: vec![vec![NOMINAL[7]]],
        sources: tolerances().into_iter().enumerate().map(source).collect(),
    }
}
