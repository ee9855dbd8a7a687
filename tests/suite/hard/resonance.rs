//! A free motion that repeats with the drive.

use crate::batten::bending_alone;
use crate::solved::{FINE, RPM, Solved, USUAL, bind, entry};
use crate::stability::{Row, told};
use assur::dense::Lu;
use assur::model::Model;
use assur::periodic::{Orbit, PeriodicError};
use assur::problem::Span;
use std::f64::consts::TAU;

fn elastic(speed: f64) -> Box<dyn Model> {
    bind(entry("batten", "elastic"), &[("n", speed * RPM)]).unwrap()
}

fn period(run: &dyn Model) -> f64 {
    match run.span() {
        Span::Periodic(period) => period,
        _ => panic!("the scene has another task"),
    }
}

fn solve(speed: f64) -> Result<Orbit, PeriodicError> {
    let run = elastic(speed);
    run.periodic(period(run.as_ref()), &USUAL)
}

/// Distance from 1 of the nearest multiplier.
fn distance(speed: f64) -> f64 {
    match solve(speed) {
        Ok(orbit) => {
            let distances = orbit.multipliers.iter().map(|it| it.distance());
            distances.fold(f64::INFINITY, f64::min)
        }
        Err(PeriodicError::Resonance { distance, .. }) => distance,
        Err(error) => panic!("{error}"),
    }
}

/// The speed in an interval at which a multiplier comes nearest to 1: a scan, then thirds.
fn nearest(from: f64, to: f64) -> f64 {
    let step = (to - from) / 20.0;
    let speeds = (0..=20).map(|index| from + step * index as f64);
    let coarse = speeds.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap();
    let (mut low, mut high) = (coarse - step, coarse + step);
    while high - low > 1e-11 {
        let third = (high - low) / 3.0;
        match distance(low + third) < distance(high - third) {
            true => high -= third,
            false => low += third,
        }
    }
    (low + high) / 2.0
}

/// The way of a textbook: one period from rest and from each unit vector, then a linear system, without any check.
fn naive(run: &dyn Model) -> Vec<f64> {
    let end = |start: &[f64]| {
        let motion = run.march((0.0, period(run)), start, &USUAL).unwrap();
        motion.end().to_vec()
    };
    let forced = end(&[0.0; 6]);
    let mut matrix = vec![0.0; 36];
    for column in 0..6 {
        let mut unit = [0.0; 6];
        unit[column] = 1e-3;
        for (row, value) in end(&unit).iter().enumerate() {
            let change = (value - forced[row]) / 1e-3;
            matrix[6 * row + column] = if row == column { 1.0 } else { 0.0 } - change;
        }
    }
    let mut start = forced;
    Lu::new(matrix, 6).unwrap().solve(&mut start);
    start
}

#[test]
fn a_driven_resonance_is_an_error_and_not_a_vector() {
    let speed = nearest(247.9, 248.5);
    assert!((speed - 248.168).abs() < 1e-3, "{speed}");
    for (off, amplification) in [(0.0, 1e10), (1e-8, 1e8), (1e-7, 1e7)] {
        let Err(PeriodicError::Resonance { distance, condition, state, .. }) = solve(speed + off)
        else {
            panic!("{off:e} rpm beside the resonance there is an answer");
        };
        assert!(distance < 0.4 * off + 1e-9, "{off:e}: distance {distance:e}");
        assert!(condition > amplification, "{off:e}: condition {condition:e}");
        assert!(state < 6);
    }
    // Farther off there is an answer: a pole at the resonance and the rest, `pole/off + rest`. Both follow from two
    // distant answers; the near ones lie on it within their own error estimates.
    let answer = |off: f64| {
        let orbit = solve(speed + off).unwrap();
        (orbit.start[3], orbit.estimated_error[3])
    };
    let ((near, _), (far, _)) = (answer(1e-4), answer(1e-3));
    let pole = (near - far) / (1e4 - 1e3);
    let rest = far - 1e3 * pole;
    for off in [1e-6, 1e-5] {
        let (value, error) = answer(off);
        let expected = pole / off + rest;
        // The speed of the resonance itself is known to about 1e-11 rpm.
        let known = 1e-11 / off * expected.abs();
        assert!(
            (value - expected).abs() < error + known,
            "{off:e}: {value} ± {error:e}, expected {expected} ± {known:e}"
        );
        assert!(error < 1e-2 * value.abs(), "{off:e}: {value} ± {error:e}");
    }
    // A lag of hundreds of radians, and nothing that tells.
    let vector = naive(elastic(speed).as_ref());
    assert!(vector.iter().all(|value| value.is_finite()));
    assert!(vector[0].abs() > 10.0, "{vector:?}");
    let Err(error) = solve(speed) else { panic!("an answer in the resonance") };
    told(&Row {
        case: "Resonance",
        tried: "the batten without losses at the speed of a resonance, 248.168 rpm",
        naive: format!(
            "`I - P` solved as it stands: a lag of {:.0} rad, and nothing that tells",
            vector[0].abs()
        ),
        ours: format!("an error: {}", error.to_string().replace('\n', " ")),
        cost: "none".to_owned(),
    });
}

#[test]
fn beside_a_resonance_both_ways_agree() {
    for speed in [248.0, 249.0] {
        let (ours, naive) = (solve(speed).unwrap().start, naive(elastic(speed).as_ref()));
        for (ours, naive) in ours.iter().zip(naive) {
            let off = (ours - naive).abs();
            assert!(off < 1e-6, "{speed} rpm: {off:e}");
        }
    }
}

/// The scene `bending` at the speed of which its free motion is the 12th harmonic, times a factor.
fn bending(factor: f64) -> Solved {
    let whole = entry("batten", "bending");
    let value = |name: &str| {
        let mut constants = whole.constants.iter();
        let constant = constants.find(|it| it.quantity.name == name);
        constant.unwrap().default
    };
    let stiffness = 1.0 / ((value("d33") + value("d34")) * value("m3"));
    let speed = stiffness.sqrt() / 12.0 * factor;
    Solved::of(whole, &[("n", speed)], &FINE).unwrap()
}

/// Differences from the forced motion at equal parts of a revolution.
fn excess(solved: &Solved, name: &str) -> Vec<f64> {
    let angles = (0..48).map(|index| TAU * f64::from(index) / 48.0);
    angles.map(|angle| solved.at(angle, name) - bending_alone(solved, angle)).collect()
}

#[test]
fn a_resonance_that_nothing_drives_is_tame() {
    for factor in [0.999, 1.0 - 1e-4, 1.0 - 1e-5, 1.0 + 1e-5, 1.001] {
        let solved = bending(factor);
        let largest = excess(&solved, "x3").into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        assert!(largest < 1e-9, "{factor}: {largest:e}");
    }
}

/// In the resonance itself every free motion may be added. What comes is the smallest motion, and the answer says how
/// many free motions are open.
#[test]
fn in_a_resonance_that_nothing_drives_the_smallest_motion_is_taken() {
    let solved = bending(1.0);
    // The free motion with any phase: a sine and a cosine.
    assert_eq!(solved.orbit.free, 2);
    assert!(solved.orbit.condition > 1e9, "{:e}", solved.orbit.condition);
    assert!(solved.orbit.residual < 1e-9, "{:e}", solved.orbit.residual);
    for name in ["x3", "x4"] {
        for value in excess(&solved, name) {
            assert!(value.abs() < 1e-10, "{name}: {value:e}");
        }
    }
}
