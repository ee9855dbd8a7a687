//! The coupler point of a dwell six-bar against roots of its polynomial with 80 digits (`tests/reference/dwell_polynomial.py`), and
//! polynomials with roots that are hard.

use std::f64::consts::PI;

use super::{Fit, chebyshev, roots};
use crate::shape::{Solved, Term};

const DEGREE: f64 = PI / 180.0;

/// Coupler point, rod and rocker: `|E|^2 + 2 c.f - 2 r h - 2 r c.g + c.c + r^2 - l^2`.
const SOLVED: Solved = Solved {
    text: "",
    unknowns: &[0, 1, 2, 3],
    terms: &[
        Term::new(0, true, &[0, 0, 0, 0]),
        Term::new(1, true, &[1, 0, 0, 0]),
        Term::new(2, true, &[0, 1, 0, 0]),
        Term::new(3, true, &[0, 0, 0, 1]),
        Term::new(4, true, &[1, 0, 0, 1]),
        Term::new(5, true, &[0, 1, 0, 1]),
        Term::new(6, false, &[2, 0, 0, 0]),
        Term::new(6, false, &[0, 2, 0, 0]),
        Term::new(6, false, &[0, 0, 0, 2]),
        Term::new(7, false, &[0, 0, 2, 0]),
    ],
    scanned: Some(3),
    free: Some(2),
    groups: &[],
};

fn turned(angle: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y]
}

fn add([a, b]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [a + x, b + y]
}

fn arg([x, y]: [f64; 2]) -> f64 {
    y.atan2(x)
}

/// The point at a distance from each of two others, to the left of the way from one to the other or to its right.
fn across(p: [f64; 2], r: f64, q: [f64; 2], other: f64, side: f64) -> [f64; 2] {
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0].hypot(d[1]);
    let along = (r * r - other * other + length * length) / (2.0 * length);
    let beside = side * (r * r - along * along).sqrt();
    add(p, turned(arg(d), [along, beside]))
}

/// What the lift rocker has to swing: the rack unit inverted along its path, for a dwell of 60 deg, 0.2 mm and 3 mm. Lengths in mm.
fn swing(phi: f64) -> f64 {
    let (working, still, rise, drop) = (120.0 * DEGREE, 60.0 * DEGREE, 0.2, 3.0);
    let (d1, d2, p) = ((working - still) / 2.0, PI - working / 2.0, phi.abs());
    let g1 = 2.0 * rise * d2 / (drop * d1);
    let a5 = 8.0 * (1.0 - g1) / 3.0 + g1;
    let a4 = -(1.0 - g1) / 3.0 - 3.0 * a5;
    let a3 = -4.0 * a4 - 10.0 * a5;
    let (u, w) = ((p - still / 2.0) / d1, (p - working / 2.0) / d2);
    let y = match p {
        p if p <= still / 2.0 => rise,
        p if p <= working / 2.0 => rise * (1.0 - 2.0 * u.powi(3) + u.powi(4)),
        _ => -drop * (g1 * w + a3 * w.powi(3) + a4 * w.powi(4) + a5 * w.powi(5)),
    };
    let q = [36.0 + 4.0 / (2.0 * (working / 2.0).sin()) * phi.sin(), 37.0 - rise + y];
    let a = across([0.0, 0.0], 32.0, q, 36.0_f64.hypot(5.0), 1.0);
    let gamma = arg([q[0] - a[0], q[1] - a[1]]) - arg([36.0, 5.0]);
    let b = add(a, turned(gamma, [84.0, -24.0]));
    let c = across([112.0, 32.0], 28.0, b, 24.0, -1.0);
    PI - arg([c[0] - 112.0, c[1] - 32.0]).rem_euclid(2.0 * PI)
}

/// The coefficients at 36 positions of the crank-rocker of the specification, on an assembly mode.
fn coefficients(mode: f64) -> Vec<Vec<f64>> {
    let (phi0, psi0, l1, l2, l3, l4, eta) = (0.6, 2.9, 8.0, 60.0, 50.0, 70.0, 0.9);
    let at = |index: usize| {
        let phi = (10.0 * index as f64 * DEGREE + PI).rem_euclid(2.0 * PI) - PI;
        let a = turned(phi0 + phi, [l1, 0.0]);
        let b = across(a, l2, turned(eta, [l4, 0.0]), l3, mode);
        let theta = arg([b[0] - a[0], b[1] - a[1]]);
        let e = turned(psi0 - swing(phi), [1.0, 0.0]);
        let from = [a[0] - 36.0, a[1] - 96.0];
        let (f, g) = (turned(-theta, from), turned(-theta, e));
        let h = e[0] * from[0] + e[1] * from[1];
        let square = from[0] * from[0] + from[1] * from[1];
        vec![square, 2.0 * f[0], 2.0 * f[1], -2.0 * h, -2.0 * g[0], -2.0 * g[1], 1.0, -1.0]
    };
    let all = (0..36).map(at);
    // One coefficient for each term.
    all.map(|own| SOLVED.terms.iter().map(|term| own[term.quantity]).collect()).collect()
}

const WIDE: [(f64, f64); 4] = [(-200.0, 200.0), (-200.0, 200.0), (1.0, 200.0), (-100.0, 100.0)];

#[test]
fn coupler_points_of_the_dwell_six_bar() {
    // Value of the rocker, and the slope of the slope of the sum of squares there.
    let known = [
        (1.0, vec![(16.990_544_159_587_46, 82.256_587_177_665_4)]),
        (
            -1.0,
            vec![
                (-62.451_319_004_602_77, f64::NAN),
                (-8.920_580_555_455_177, f64::NAN),
                (3.009_824_431_450_947, 21_940.627_820_904_01),
                (20.642_001_025_005_61, -120.322_221_630_753_5),
                (63.713_032_939_852_07, 85.637_183_181_953_7),
            ],
        ),
    ];
    for (mode, roots) in known {
        let coefficients = coefficients(mode);
        let fit = Fit::of(&SOLVED, &WIDE, &coefficients).expect("all are numbers");
        let found = fit.stationary();
        assert_eq!(found.len(), roots.len(), "{found:?}");
        for ((at, rise), (root, slope)) in found.iter().zip(roots) {
            // The slope is a difference of terms that are larger by five digits.
            assert!((at - root).abs() < 1e-10 * root.abs(), "{at} {root}");
            // Half of the sum of squares is differentiated.
            assert!(slope.is_nan() || (2.0 * rise / slope - 1.0).abs() < 1e-5, "{rise} {slope}");
        }
    }
    let bounds = [(-120.0, 120.0), (-120.0, 120.0), (1.0, 120.0), (1.0, 100.0)];
    let coefficients = coefficients(-1.0);
    let fit = Fit::of(&SOLVED, &bounds, &coefficients).expect("all are numbers");
    let expected = [
        [
            57.235_472_533_955_69,
            10.476_037_161_726_87,
            81.959_081_927_885_74,
            3.009_824_431_450_947,
        ],
        [-12.586_849_001_036_28, 108.666_128_117_381, 12.096_215_113_206_83, 63.713_032_939_852_07],
    ];
    let found = fit.candidates();
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        for (a, b) in found.iter().zip(expected) {
            // To a tenth of a nanometre: a short rod is a difference of squares of long ones.
            assert!((a - b).abs() < 1e-7, "{found:?} {expected:?}");
        }
    }
}

/// The way of the source: coefficients of the powers of a length in metres, and their companion matrix.
#[test]
fn powers_of_a_length_lose_the_roots() {
    let scaled: Vec<Vec<f64>> = coefficients(-1.0)
        .into_iter()
        .map(|own| {
            own.iter()
                .zip(SOLVED.terms)
                .map(|(one, term)| {
                    let power: u32 = term.powers.iter().sum();
                    one * 1e-3_f64.powi(2 - power as i32)
                })
                .collect()
        })
        .collect();
    let metres: Vec<(f64, f64)> = WIDE.iter().map(|(a, b)| (a * 1e-3, b * 1e-3)).collect();
    let fit = Fit::of(&SOLVED, &metres, &scaled).expect("all are numbers");
    let root = 3.009_824_431_450_947e-3;
    let ours = fit.stationary().into_iter().map(|one| (one.0 / root - 1.0).abs());
    let ours = ours.fold(f64::INFINITY, f64::min);
    let slope = |at: f64| {
        let there = fit.there(at).expect("it has a solution");
        there.slope * there.determinant * there.determinant
    };
    // Through ten places, by powers.
    let places: Vec<f64> = (0..10).map(|k| 0.01 * f64::from(k) - 0.045).collect();
    let matrix = nalgebra::DMatrix::from_fn(10, 10, |row, column| places[row].powi(column as i32));
    let values = nalgebra::DVector::from_iterator(10, places.iter().map(|at| slope(*at)));
    let powers = matrix.lu().solve(&values).expect("the places are distinct");
    let companion = nalgebra::DMatrix::from_fn(9, 9, |row, column| match column {
        8 => -powers[row] / powers[9],
        _ => f64::from(u8::from(row == column + 1)),
    });
    let naive = companion.complex_eigenvalues();
    let naive = naive.iter().map(|one| (one.re / root - 1.0).hypot(one.im / root));
    let naive = naive.fold(f64::INFINITY, f64::min);
    assert!(ours < 1e-11 && naive > 1e3 * ours, "{ours:e} {naive:e}");
}

#[test]
fn roots_that_are_hard() {
    let of = |roots_of: &'static [f64], degree: usize| {
        let product = move |x: f64| Some(roots_of.iter().map(|root| x - root).product());
        let series = chebyshev(degree, &product).expect("it has values");
        let mut found = roots(&series);
        found.sort_by(f64::total_cmp);
        found
    };
    // A leading coefficient that is none: roots at infinity are no roots.
    let found = of(&[-0.5, 0.25], 9);
    assert!(found.len() == 2 && (found[0] + 0.5).abs() < 1e-14 && (found[1] - 0.25).abs() < 1e-14);
    // A double root is there, to half the digits.
    let found = of(&[0.3, 0.3, -0.8], 3);
    assert!(found.len() == 3 && found[1..].iter().all(|one| (one - 0.3).abs() < 1e-7), "{found:?}");
    // At the ends, and none at all.
    assert_eq!(of(&[-1.0, 1.0], 2).len(), 2);
    assert!(roots(&[1.0, 0.0, 0.0]).is_empty() && roots(&[2.0, 0.5]).is_empty());
    assert!(roots(&[f64::NAN, 1.0]).is_empty() && roots(&[0.0, 0.0]).is_empty());
}

/// No length squared is below zero: the free unknown then stands at its bound.
#[test]
fn squares_below_zero() {
    let mut all = coefficients(1.0);
    let fit = Fit::of(&SOLVED, &WIDE, &all).expect("all are numbers");
    assert!(fit.candidates()[0][2] > 1.0);
    // All points at the same distance, less than nothing.
    for own in &mut all {
        own[0] -= 200.0;
    }
    let fit = Fit::of(&SOLVED, &WIDE, &all).expect("all are numbers");
    assert_eq!(fit.candidates()[0][2], WIDE[2].0);
    all[3][2] = f64::NAN;
    assert!(Fit::of(&SOLVED, &WIDE, &all).is_none());
}

/// The point of the coupler has no influence, or the same everywhere: nothing says where it is, and no number is made up that is
/// none.
#[test]
fn inner_problems_that_are_singular() {
    let all = coefficients(1.0);
    let bounds = [(-120.0, 120.0), (-120.0, 120.0), (1.0, 120.0), (1.0, 100.0)];
    for singular in 0..3 {
        let mut all = all.clone();
        for own in &mut all {
            match singular {
                // Without influence; the same at all places; both directions the same.
                0 => own[1..=2].copy_from_slice(&[0.0, 0.0]),
                1 => own[1..=2].copy_from_slice(&[3.0, -2.0]),
                _ => own[2] = own[1],
            }
            let same = if singular == 2 { own[4] } else { 0.0 };
            own[4..=5].copy_from_slice(&[same, same]);
        }
        let fit = Fit::of(&SOLVED, &bounds, &all).expect("all are numbers");
        for found in fit.candidates() {
            let mut within = found.iter().zip(bounds);
            assert!(within.all(|(one, (low, high))| (low..=high).contains(one)), "{found:?}");
        }
    }
}
