//! Crossings of functions that are known.

use super::*;
use crate::tolerance::Random;
use std::cell::Cell;

/// What a search finds of a function on the way from 0 to 1, the samples at both ends.
fn search<T>(
    (direction, sign, armed): (Direction, f64, bool),
    value: impl Fn(f64) -> f64,
    slope: impl Fn(f64) -> f64,
    find: impl FnOnce(&mut Search<'_>, Reading, Reading) -> T,
) -> T {
    let mut sample = |part: f64| Reading { part, value: value(part), slope: slope(part) };
    let (from, to) = (sample(0.0), sample(1.0));
    let mut search = Search {
        direction,
        noise: 1e-15,
        sign,
        armed,
        slope: from.slope.abs().max(to.slope.abs()),
        instants: Instants::new(0.0, 1.0),
        sample: &mut sample,
        permits: &|_| true,
    };
    find(&mut search, from, to)
}

/// Where a function first passes zero.
fn crossing(
    direction: Direction,
    sign: f64,
    armed: bool,
    value: impl Fn(f64) -> f64,
    slope: impl Fn(f64) -> f64,
) -> Option<Crossing> {
    let kind = (direction, sign, armed);
    search(kind, value, slope, |search, from, to| search.run(from, to))
}

#[test]
fn a_crossing_is_enclosed_to_the_last_bits() {
    let root = crossing(Direction::Rises, -1.0, true, |x| x.exp() - 2.0, f64::exp).unwrap();
    let (before, after) = (root.before, root.at.part);
    assert!(root.rising && (after - 2.0f64.ln()).abs() < 4e-16, "{root:?}");
    assert!(after.exp() > 2.0 && before.exp() < 2.0);
    assert!(after - before <= 8.0 * f64::EPSILON, "{root:?}");
    assert_eq!(crossing(Direction::Falls, -1.0, true, |x| x.exp() - 2.0, f64::exp), None);
}

/// Two crossings 2e-4 apart, of which the signs at the ends say nothing.
#[test]
fn a_pair_of_crossings_within_a_step_is_found() {
    let value = |x: f64| (x - 0.3).powi(2) * (1.0 + x) - 1e-8;
    let slope = |x: f64| 2.0 * (x - 0.3) * (1.0 + x) + (x - 0.3).powi(2);
    assert!(value(0.0) > 0.0 && value(1.0) > 0.0);
    let fall = crossing(Direction::Falls, 1.0, true, value, slope).unwrap();
    assert!((fall.at.part - 0.299_912).abs() < 1e-6 && !fall.rising, "{fall:?}");
    let rise = crossing(Direction::Rises, 1.0, true, value, slope).unwrap();
    assert!((rise.at.part - 0.300_088).abs() < 1e-6 && rise.rising, "{rise:?}");
}

#[test]
fn a_touch_is_no_crossing() {
    let value = |x: f64| (x - 0.3).powi(2);
    assert_eq!(crossing(Direction::Crosses, 1.0, true, value, |x| 2.0 * (x - 0.3)), None);
}

/// The continuous solution begins downwards and the motion upwards, `2 x`: it is never below zero.
#[test]
fn an_error_of_the_continuous_solution_is_no_crossing() {
    let (value, slope) = (|x: f64| x * x - 1e-3 * x, |x: f64| 2.0 * x);
    let found = crossing(Direction::Falls, 0.0, true, value, slope).unwrap();
    assert!(!found.rising, "{found:?}");
    let kept = |value: fn(f64) -> f64, slope: fn(f64) -> f64| {
        let kind = (Direction::Falls, -1.0, true);
        search(kind, value, slope, |search, _, to| {
            (search.unless_taken_back(found, to, 0.0), search.sign)
        })
    };
    assert_eq!(kept(value, slope), (None, 1.0));
    // A motion that goes down says so, and one that does not come back is believed to.
    let down = kept(value, |x| 2.0 * x - 1e-3);
    assert_eq!(down, (Some(found), -1.0));
    let stays = kept(|x| -1e-3 * x, slope);
    assert_eq!(stays, (Some(found), -1.0));
}

/// At time 0 in a step of more than 2 s the smallest part is no number above zero.
#[test]
fn a_guard_is_followed_out_of_time_zero() {
    let kind = (Direction::Falls, -1.0, true);
    let (value, slope) = (|x: f64| x * x - 1e-3 * x, |x: f64| 2.0 * x);
    let found = search(kind, value, slope, |search, from, to| {
        search.instants = Instants::new(0.0, 10.0);
        let (at, rising) = (from, false);
        let before = at.part;
        let crossing = Crossing { at, before, rising };
        (search.unless_taken_back(crossing, to, 0.0), search.sign)
    });
    assert_eq!(found, (None, 1.0));
}

/// `x⁴` leaves zero with neither rate nor curvature.
#[test]
fn a_guard_that_leaves_zero_passes_it_at_the_start() {
    let (value, slope) = (|x: f64| x.powi(4), |x: f64| 4.0 * x.powi(3));
    let found = crossing(Direction::Rises, 0.0, true, value, slope).unwrap();
    assert!(found.at.part < 2e-4, "{found:?}");
    assert_eq!(crossing(Direction::Falls, 0.0, true, value, slope), None);
    assert_eq!(crossing(Direction::Rises, 0.0, false, value, slope), None);
}

#[test]
fn a_guard_that_stays_zero_passes_nothing() {
    assert_eq!(crossing(Direction::Crosses, 0.0, true, |_| 0.0, |_| 0.0), None);
}

/// Beside a pole a guard is steeper by any factor than elsewhere, where it is an easy curve all the same.
#[test]
fn a_guard_beside_a_pole_is_not_looked_at_everywhere() {
    let looks = Cell::new(0);
    let value = |x: f64| {
        looks.set(looks.get() + 1);
        1.0 / (x + 1e-9).powi(2) - 0.5
    };
    let slope = |x: f64| -2.0 / (x + 1e-9).powi(3);
    let found = crossing(Direction::Crosses, 1.0, true, value, slope);
    assert_eq!(found, None);
    assert!(looks.get() < 5_000, "{looks:?}");
}

/// Lines with swings on them, up to ten in a step: a crossing is where 4000 samples say that the first one is.
#[test]
fn crossings_of_random_guards_are_not_missed() {
    let mut random = Random::new(1, 0);
    let (mut crossed, mut missed) = (0, 0);
    for _ in 0..20_000 {
        let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
        let (start, tilt) = (between(-1.0, 1.0), between(-2.0, 2.0));
        let (height, phase) = (between(0.0, 1.0), between(0.0, 6.3));
        let pace = (60.0_f64 / 0.1).powf(between(0.0, 1.0)) * 0.1;
        let value = |x: f64| start + tilt * x + height * (pace * x + phase).sin();
        let slope = |x: f64| tilt + height * pace * (pace * x + phase).cos();
        let sign = value(0.0).signum();
        let first = (1..=4000).find(|k| value(f64::from(*k) / 4000.0).signum() != sign);
        let Some(first) = first else { continue };
        crossed += 1;
        let kind = (Direction::Crosses, sign, true);
        let found = search(kind, value, slope, |search, from, to| search.run_warily(from, to).0);
        // Between two samples it may have passed twice before.
        let found = found.map(|found| found.at.part).filter(|at| value(*at).signum() != sign);
        missed += usize::from(found.is_none_or(|at| at > f64::from(first) / 4000.0));
    }
    assert!(crossed > 9_000, "{crossed}");
    assert_eq!(missed, 0);
}
