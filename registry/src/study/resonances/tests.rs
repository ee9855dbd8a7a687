//! Multipliers that formulas give.

use super::*;
use std::f64::consts::{PI, TAU};

fn pair(re: f64, im: f64) -> [Multiplier; 2] {
    [im, -im].map(|im| Multiplier { re, im, error: 1e-12 })
}

/// Multipliers on a circle.
fn turning(modulus: f64, angle: f64) -> [Multiplier; 2] {
    pair(modulus * angle.cos(), modulus * angle.sin())
}

fn spectrum_of(value: f64, pairs: &[[Multiplier; 2]]) -> Result<Spectrum, String> {
    Ok(Spectrum { value, multipliers: pairs.concat(), periods: 1 })
}

fn grid(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|place| from + (to - from) * place as f64 / (count - 1) as f64).collect()
}

#[test]
fn every_turn_passes_1_and_minus_1() {
    let angles = |value: f64| [40.0 * value, 17.0 * value * value + 1.0];
    let at = |value: f64| {
        let [one, other] = angles(value).map(|angle| turning(1.0, angle));
        spectrum_of(value, &[one, other])
    };
    let found = resonances(&at, &grid(1.0, 3.0, 31), 2, &|_| {});
    assert!(found.gaps.is_empty() && found.lost.is_empty() && found.unstable.is_empty());
    let mut expected: Vec<(f64, Meets)> = Vec::new();
    for half in 0..60 {
        let angle = PI * f64::from(half);
        let meets = if half % 2 == 0 { Meets::One } else { Meets::MinusOne };
        expected.push((angle / 40.0, meets));
        expected.push((((angle - 1.0) / 17.0).max(0.0).sqrt(), meets));
    }
    expected.retain(|(value, _)| (1.0..3.0).contains(value));
    expected.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!(found.all.len(), expected.len());
    for (one, (value, meets)) in found.all.iter().zip(expected) {
        assert_eq!(one.meets, meets);
        assert!((one.value - value).abs() < 1e-9, "{value}: {one:?}");
        assert!((one.value - value).abs() <= 10.0 * one.error, "{value}: {one:?}");
    }
}

#[test]
fn what_is_damped_passes_at_a_distance() {
    let at = |value: f64| spectrum_of(value, &[turning(0.97, value), turning(0.5, 2.0 * value)]);
    let found = resonances(&at, &grid(1.0, 8.0, 8), 1, &|_| {});
    let [minus, one] = found.all[..] else { panic!("{:?}", found.all) };
    assert!((minus.value - PI).abs() < 1e-8 && minus.meets == Meets::MinusOne);
    assert!((one.value - TAU).abs() < 1e-8 && (one.distance - 0.03).abs() < 1e-12);
    assert!((one.growth - 0.97).abs() < 1e-12);
    assert!((found.nearest.0 - 0.03).abs() < 1e-12 && (found.nearest.1 - TAU).abs() < 1e-8);
}

/// `u'' = -(a + b s) u` with `s` = 1 for the first half of a period and -1 for the second (E. Meissner, 1918): half of the sum
/// of both multipliers, whose product is 1.
fn meissner(a: f64, b: f64) -> f64 {
    let [p, q] = [a + b, a - b].map(f64::sqrt);
    (p / 2.0).cos() * (q / 2.0).cos() - (p / q + q / p) / 2.0 * (p / 2.0).sin() * (q / 2.0).sin()
}

#[test]
fn ranges_of_growth_are_found_that_are_narrower_than_the_steps() {
    const B: f64 = 0.05;
    let at = |a: f64| {
        let half = meissner(a, B);
        let off = (1.0 - half * half).abs().sqrt();
        let both = match half.abs() > 1.0 {
            true => [half + off, half - off].map(|re| Multiplier { re, im: 0.0, error: 1e-13 }),
            false => pair(half, off),
        };
        spectrum_of(a, &[both])
    };
    let found = resonances(&at, &grid(5.0, 130.0, 26), 1, &|_| {});
    // Near a = (k pi)^2; for even k both halves have whole turns at once, and only by two millionths a period motions grow.
    assert_eq!(found.unstable.len(), 3, "{:?}", found.unstable);
    for (range, turns) in found.unstable.iter().zip([1.0, 2.0, 3.0]) {
        let (from, to) = range.range;
        assert!((0.5 * (from + to) - (turns * PI).powi(2)).abs() < 1e-2 && to - from < 0.1);
        for (end, outwards) in [(from, -1.0), (to, 1.0)] {
            let edge = |by: f64| meissner(end + outwards * by, B).abs() - 1.0;
            assert!(edge(-1e-6) > 0.0 && edge(1e-5) < 0.0, "{range:?}");
        }
        let largest = meissner(range.at, B).abs();
        assert!((range.growth - (largest + (largest * largest - 1.0).sqrt())).abs() < 1e-12);
    }
    let ones: Vec<_> = found.all.iter().filter(|one| one.meets == Meets::One).collect();
    assert!(ones.iter().any(|one| (one.value - (2.0 * PI).powi(2)).abs() < 1e-3), "{ones:?}");
}

#[test]
fn two_that_meet_may_leave_the_circle() {
    // Angles 1 -+ sqrt(w), w below zero for a hundredth of the range.
    let at = |value: f64| {
        let w = 0.05 * ((value - 2.0).powi(2) - 1e-4);
        let root = w.abs().sqrt();
        let pairs = match w > 0.0 {
            true => [turning(1.0, 1.0 + root), turning(1.0, 1.0 - root)],
            false => [turning(root.exp(), 1.0), turning((-root).exp(), 1.0)],
        };
        spectrum_of(value, &pairs)
    };
    let found = resonances(&at, &grid(1.0, 3.0, 14), 1, &|_| {});
    let [one] = found.all[..] else { panic!("{:?}", found.all) };
    assert!(one.meets == Meets::Another && (one.value - 2.0).abs() < 1e-5, "{one:?}");
    let [range] = found.unstable[..] else { panic!("{:?}", found.unstable) };
    assert!((range.range.0 - 1.99).abs() < 1e-6 && (range.range.1 - 2.01).abs() < 1e-6);
}

#[test]
fn values_without_a_motion_are_told() {
    let at = |value: f64| match (2.0..2.5).contains(&value) {
        true => Err("none".to_owned()),
        false => spectrum_of(value, &[turning(1.0, 9.0 * value)]),
    };
    let found = resonances(&at, &grid(1.0, 3.0, 21), 1, &|_| {});
    assert!(!found.lost.is_empty());
    assert!(found.gaps.iter().any(|(from, to)| *from < 2.0 && *to >= 2.5), "{:?}", found.gaps);
    assert!(found.all.iter().all(|one| !(1.95..2.55).contains(&one.value)));
}
