//! Lyapunov exponents of the foot.

use super::*;
use assur::hybrid::Periods;

/// Irregular motion at 800 1/s, over so few turns that two computations still agree on it.
#[test]
fn the_growth_of_disturbances_is_that_of_the_second_computation() {
    let case = &REFERENCE["irregular"];
    let foot = Elliptic::with(&[("omega", number(&case["omega"]))]);
    let periods = Periods {
        settling: case["settling"].as_u64().unwrap() as usize,
        counted: case["counted"].as_u64().unwrap() as usize,
    };
    let start = (CONTACT, &foot.start()[..]);
    let found = hybrid::lyapunov(&foot, start, foot.period(), periods, &FINE).unwrap();
    assert_eq!(
        Elliptic::shape().scales[0],
        Elliptic::shape().scales[1],
        "the second computation weighs them alike"
    );
    let end = numbers(&case["end"]);
    assert!((found.end[0] - end[0]).abs() < 1e-10, "{:?}", found.end);
    for (found, expected) in found.exponents.iter().zip(numbers(&case["exponents"])) {
        assert!((found / expected - 1.0).abs() < 1e-7, "{found} {expected}");
    }
    assert!(found.exponents[0] > 0.0, "the motion is irregular");
}

/// Areas of starts shrink by the damping alone: neither lifting off nor coming down changes them, and in flight only the
/// guide damps. That holds turn by turn, however irregular the motion is.
#[test]
fn the_exponents_sum_to_the_damping() {
    let turns = 300;
    for foot in [Elliptic::with(&[("omega", 800.0)]), Elliptic::with(&[("c2", 4e5), ("mu2", 40.0)])]
    {
        let periods = Periods { settling: 0, counted: turns };
        let start = foot.start();
        let found =
            hybrid::lyapunov(&foot, (CONTACT, &start), foot.period(), periods, &FINE).unwrap();
        let (mut mode, mut state, mut free) = (CONTACT, start.to_vec(), 0.0);
        for _ in 0..turns {
            let times = (0.0, foot.period());
            let motion = hybrid::march_in(&foot, mode, times, &state, &FINE).unwrap();
            free += Measured::of(&foot, &motion).free / turns as f64;
            (mode, state) = (motion.mode, motion.end);
        }
        assert_eq!((found.mode, &found.end), (mode, &state));
        let expected = -(foot.mu1 + foot.mu2 * (1.0 - free)) / foot.m;
        let sum: f64 = found.exponents.iter().sum();
        assert!((sum / expected - 1.0).abs() < 1e-8, "{sum} {expected}");
        assert!(found.exponents[0] > 10.0, "{:?}", found.exponents);
    }
}

/// Of a motion that repeats they are those of its multipliers.
#[test]
fn of_a_motion_that_repeats_they_follow_from_its_multipliers() {
    for omega in [300.0, 400.0] {
        let foot = Elliptic::with(&[("omega", omega)]);
        let cycle = foot.cycle().unwrap();
        let start = cycle.motion.pieces[0].trajectory.at(0.0);
        let periods = Periods { settling: 40, counted: 20 };
        let begin = (cycle.motion.pieces[0].mode, &start[..]);
        let found = hybrid::lyapunov(&foot, begin, foot.period(), periods, &FINE).unwrap();
        let length = cycle.multiple as f64 * foot.period();
        for (found, multiplier) in found.exponents.iter().zip(&cycle.multipliers) {
            let expected = multiplier.modulus().ln() / length;
            assert!((found / expected - 1.0).abs() < 1e-7, "{found} {expected}");
        }
    }
}
