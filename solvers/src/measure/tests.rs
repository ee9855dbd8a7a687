//! Numbers of runs against closed forms.

mod ways;

use super::*;
use crate::hybrid::Piece;
use crate::hybrid::{Happened, Numbers};
use crate::ode::{Basis, Observer, Recorder, Step};
use crate::problem::Phase;
use std::f64::consts::PI;

/// A run through steps of this length, in which nothing moves: quantities are functions of the time.
fn run(from: f64, to: f64, steps: usize) -> Motion {
    let mut recorder = Recorder::new(from, &[0.0; 1]);
    let time = |index: usize| from + (to - from) * index as f64 / steps as f64;
    for index in 0..steps {
        recorder.step(&Step {
            from: time(index),
            to: time(index + 1),
            before: &[0.0; 1],
            after: &[0.0; 1],
            basis: Basis::Alternating,
            polynomial: &[0.0; 1],
        });
    }
    Motion::of(recorder.finish(Default::default()))
}

/// What is found of functions of the time.
fn found(
    motion: &Motion,
    primitive: Primitive,
    of: &[&dyn Fn(f64) -> f64],
) -> Result<f64, Missing> {
    let sample = |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| {
        for (value, of) in values.iter_mut().zip(of) {
            *value = of(time);
        }
    };
    find(motion, &[primitive], of.len(), &sample)[0]
}

fn of(kind: Kind) -> Primitive {
    Primitive { kind, argument: 0, window: None }
}

#[track_caller]
fn is(found: Result<f64, Missing>, expected: f64, error: f64) {
    let found = found.unwrap();
    assert!(
        (found - expected).abs() <= error,
        "{found} against {expected}, off by {:e}",
        found - expected
    );
}

#[test]
fn a_peak_between_the_steps_is_found_where_samples_miss_it() {
    let motion = run(0.0, 3.0, 2);
    let hill = |time: f64| 1.0 - 50.0 * (time - 1.234_567).powi(2);
    is(found(&motion, of(Kind::Peak), &[&hill]), 1.0, 1e-15);
    // The naive way: the largest at the ends of the steps.
    let naive = [0.0, 1.5, 3.0].map(hill).into_iter().fold(f64::MIN, f64::max);
    assert!(naive < -2.0, "{naive}");
    is(found(&motion, of(Kind::Lowest), &[&hill]), hill(3.0), 0.0);
}

/// In every place of a step, beside its ends as well, where all other points of the grid lie on one side.
#[test]
fn a_peak_is_found_wherever_it_lies_in_a_step() {
    let motion = run(0.0, 3.0, 3);
    for place in 0..=300 {
        let top = f64::from(place) / 100.0;
        let hill = |time: f64| 1.0 - 50.0 * (time - top).powi(2);
        is(found(&motion, of(Kind::Peak), &[&hill]), 1.0, 1e-15);
        let valley = |time: f64| -hill(time);
        is(found(&motion, of(Kind::Lowest), &[&valley]), -1.0, 1e-15);
    }
}

/// The largest value of a function of the time, with its time.
fn highest(motion: &Motion, of: &dyn Fn(f64) -> f64) -> Extreme {
    let sample = |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| values[0] = of(time);
    let found = extremes(motion, ALWAYS, 1, &sample)[0].clone();
    found.unwrap().highest
}

/// From values alone it has half of the digits: the quantity is flat there.
#[test]
fn the_time_of_an_extreme_has_nearly_all_digits() {
    let motion = run(0.0, 3.0, 7);
    for place in 1..300 {
        let top = f64::from(place) / 100.0 + 1.234e-5;
        let wave = |time: f64| 3.0 + (2.0 * (time - top)).cos() - 0.001 * (time - top).powi(3);
        let found = highest(&motion, &wave);
        let wrong = (found.time - top).abs();
        assert!(wrong < 1e-12 && wrong <= found.blur, "{top}: {wrong:e} {found:?}");
        assert!((found.value - 4.0).abs() < 2e-15 && found.blur < 1e-11, "{found:?}");
    }
}

#[test]
fn where_it_is_flat_the_time_of_an_extreme_says_so() {
    let motion = run(0.0, 3.0, 7);
    for power in [4, 6] {
        let flat = |time: f64| 1.0 - (time - 1.234_567).powi(power);
        let found = highest(&motion, &flat);
        let wrong = (found.time - 1.234_567).abs();
        assert!(wrong <= found.blur && found.blur < 0.1, "{wrong:e} {found:?}");
        assert!(found.blur > 1e-6, "{found:?}");
    }
}

/// Which of them is the largest is up to rounding, so all are told.
#[test]
fn places_at_which_a_quantity_is_as_large_are_rivals() {
    let motion = run(0.0, 3.0, 7);
    let wave = |time: f64| (2.0 * PI * (time - 0.3)).cos();
    let sample =
        |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| values[0] = wave(time);
    let found = extremes(&motion, ALWAYS, 1, &sample)[0].clone().unwrap();
    let mut rivals: Vec<f64> = found.high_rivals.iter().map(|one| one.time).collect();
    rivals.sort_by(f64::total_cmp);
    assert_eq!(rivals.len(), 3, "{rivals:?}");
    for (found, expected) in rivals.iter().zip([0.3, 1.3, 2.3]) {
        assert!((found - expected).abs() < 1e-12, "{rivals:?}");
    }
}

/// It lasts a fiftieth of a step, of which there are few: eight points of one see next to nothing of it.
#[test]
fn a_pulse_that_no_step_feels_is_found() {
    let motion = run(0.0, 5000.0, 10_000);
    for at in [0.007, 1234.567, 4999.9] {
        let pulse = |time: f64| (-((time - at) / 0.01).powi(2)).exp();
        let found = highest(&motion, &pulse);
        assert!((found.value - 1.0).abs() < 1e-12, "{at} {found:?}");
        assert!((found.time - at).abs() < 1e-9, "{at} {found:?}");
    }
}

/// Thirty swings of a step: every eighth part sees the same.
#[test]
fn swings_that_the_steps_do_not_resolve_are_counted_out() {
    let motion = run(0.0, 1.0, 1);
    let wave = |time: f64| (2.0 * PI * 30.0 * time).sin() * (1.0 + 0.1 * time);
    let found = highest(&motion, &wave);
    let top = 29.25 / 30.0;
    assert!((found.time - top).abs() < 1e-4 && found.value > 1.0 + 0.1 * top, "{found:?}");
}

/// Half of the digits of its time are not enough where a quantity is not flat.
#[test]
fn a_corner_is_found_to_the_last_digits() {
    let motion = run(0.0, 3.0, 2);
    for corner in [0.7, 1.0 / 3.0, 2.9] {
        let saw = |t: f64| 5.0 - 1e3 * (t - corner).abs();
        is(found(&motion, of(Kind::Peak), &[&saw]), 5.0, 1e-12);
    }
}

/// Between the last places in a step a quantity rises to a corner and falls again, and it is larger at the end than before:
/// nothing but the slope at the end would say so.
#[test]
fn a_corner_next_to_an_end_is_found() {
    let motion = run(0.0, 1.0, 1);
    for corner in [0.9757, 0.994, 0.9993, 0.99996] {
        let late = |time: f64| time - 1.5 * (time - corner).max(0.0);
        is(found(&motion, of(Kind::Peak), &[&late]), corner, 1e-15);
        let early = |time: f64| late(1.0 - time);
        is(found(&motion, of(Kind::Peak), &[&early]), corner, 1e-15);
    }
}

#[test]
fn means_are_integrals_and_not_means_of_samples() {
    let motion = run(0.0, 2.0 * PI, 7);
    let wave = |time: f64| (3.0 * time).sin().exp();
    // The modified Bessel function I0(1), and I0(2) for the square.
    is(found(&motion, of(Kind::Mean), &[&wave]), 1.266_065_877_752_008_4, 1e-14);
    let rms = 2.279_585_302_336_067_4_f64.sqrt();
    is(found(&motion, of(Kind::Rms), &[&wave]), rms, 1e-14);
    is(found(&motion, of(Kind::Integral), &[&wave]), 2.0 * PI * 1.266_065_877_752_008_4, 1e-13);
}

#[test]
fn a_kink_inside_a_step_is_integrated_as_well() {
    let motion = run(0.0, 1.0, 1);
    let kink = |time: f64| (time - 0.3).abs();
    is(found(&motion, of(Kind::Mean), &[&kink]), 0.045 + 0.245, 1e-13);
}

#[test]
fn a_condition_that_holds_twice_within_a_step_is_timed_to_the_last_digits() {
    let motion = run(0.0, 1.0, 1);
    let wave = |time: f64| (4.0 * PI * time).sin() - 0.5;
    is(found(&motion, of(Kind::Duration), &[&wave]), 1.0 / 3.0, 4e-16);
    // A grazing touch between two points of the grid.
    let touch = |time: f64| 1e-6 - (time - 0.312_345).powi(2);
    is(found(&motion, of(Kind::Duration), &[&touch]), 2e-3, 1e-12);
    let gap = |time: f64| -touch(time);
    is(found(&motion, of(Kind::Duration), &[&gap]), 1.0 - 2e-3, 1e-12);
}

#[test]
fn a_window_bounds_where_a_quantity_is_looked_at() {
    let motion = run(0.0, 1.0, 3);
    let (slope, early) = (|time: f64| time, |time: f64| 0.4 - time);
    let windowed = |kind| Primitive { kind, argument: 0, window: Some(1) };
    is(found(&motion, windowed(Kind::Peak), &[&slope, &early]), 0.4, 1e-15);
    is(found(&motion, windowed(Kind::Mean), &[&slope, &early]), 0.2, 1e-15);
    let never = |_: f64| -1.0;
    let missing = found(&motion, windowed(Kind::Mean), &[&slope, &never]);
    assert_eq!(missing, Err(Missing::NeverHolds));
}

#[test]
fn harmonics_over_an_angle_are_those_of_the_angle_and_not_of_the_time() {
    // The angle does not turn evenly.
    let angle = |time: f64| 2.0 * PI * time + 0.3 * (2.0 * PI * time).sin();
    let rate = |time: f64| 2.0 * PI * (1.0 + 0.3 * (2.0 * PI * time).cos());
    let force =
        |time: f64| 2.0 + 0.7 * (2.0 * angle(time)).cos() - 0.25 * (5.0 * angle(time)).sin();
    let motion = run(0.0, 3.0, 40);
    let functions: [&dyn Fn(f64) -> f64; 3] = [&force, &angle, &rate];
    let cosine = |order| of(Kind::Cosine { angle: (1, 2), order });
    let sine = |order| of(Kind::Sine { angle: (1, 2), order });
    is(found(&motion, cosine(0), &functions), 2.0, 1e-13);
    is(found(&motion, cosine(2), &functions), 0.7, 1e-13);
    is(found(&motion, sine(5), &functions), -0.25, 1e-13);
    is(found(&motion, cosine(1), &functions), 0.0, 1e-13);
    let part = run(0.0, 2.5, 40);
    let missing = found(&part, cosine(1), &functions);
    assert!(matches!(missing, Err(Missing::NotWhole(turns)) if (turns - 2.5).abs() < 1e-12));
}

/// From the mode 0 to the mode 1 at 1 s, where the state jumps from 2 to -3, and on to 3 s.
fn through_an_event() -> Motion {
    let (first, second) = (run(0.0, 1.0, 2), run(1.0, 3.0, 2));
    let piece = |mode: usize, motion: Motion| Piece {
        mode,
        sides: Numbers::default(),
        trajectory: motion.pieces[0].trajectory.clone(),
    };
    let event = Happened {
        time: 1.0,
        from: 0,
        event: 0,
        to: 1,
        before: Numbers::new(&[2.0]),
        after: Numbers::new(&[-3.0]),
        guard: 0.0,
    };
    Motion {
        pieces: vec![piece(0, first), piece(1, second)],
        events: vec![event],
        mode: 1,
        end: vec![7.0],
        time: 3.0,
        statistics: Default::default(),
        rest: None,
        multipliers: Vec::new(),
    }
}

/// The state, a hundred more in the mode 1.
fn state_and_mode(phase: Phase<'_, f64>, _: f64, state: &[f64], values: &mut [f64]) {
    values[0] = state[0] + 100.0 * phase.mode as f64;
}

#[test]
fn an_event_is_known_by_its_name_in_every_mode() {
    let hit = NamedEvent { name: "hit", places: &[(1, 0), (0, 0)] };
    let other = NamedEvent { name: "other", places: &[(1, 0), (0, 1)] };
    let (before, after) = (
        |event| Moment::Before { event, last: false },
        |event| Moment::After { event, last: true },
    );
    let primitives = [
        Kind::Count(after(hit)),
        Kind::Value(before(hit)),
        Kind::Value(after(hit)),
        Kind::Count(after(other)),
        Kind::Value(before(other)),
    ]
    .map(of);
    let found = find(&through_an_event(), &primitives, 1, &state_and_mode);
    assert_eq!(found[..4], [1.0, 2.0, 97.0, 0.0].map(Ok));
    assert_eq!(found[4], Err(Missing::NeverHappens("other")));
}

#[test]
fn values_at_events_are_those_before_and_after_them() {
    let (enter, leave) =
        (|mode| Moment::Enter { mode, last: false }, |mode| Moment::Leave { mode, last: true });
    let primitives = [
        Kind::Value(enter(1)),
        Kind::Value(leave(0)),
        Kind::Value(Moment::End),
        Kind::Value(Moment::Start),
        Kind::Count(enter(1)),
        Kind::Value(leave(1)),
        Kind::Count(leave(1)),
    ]
    .map(of);
    let found = find(&through_an_event(), &primitives, 1, &state_and_mode);
    let expected = [97.0, 2.0, 107.0, 0.0, 1.0].map(Ok);
    assert_eq!(found[..5], expected);
    assert_eq!(found[5..], [Err(Missing::NeverLeft(1)), Ok(0.0)]);
}

#[test]
fn a_value_that_is_no_number_is_missing_and_not_zero() {
    let motion = run(0.0, 1.0, 2);
    let root = |time: f64| (0.5 - time).sqrt();
    for kind in [Kind::Peak, Kind::Mean, Kind::Rms] {
        assert_eq!(found(&motion, of(kind), &[&root]), Err(Missing::NotFinite));
    }
    let nothing = Motion { pieces: Vec::new(), ..run(0.0, 1.0, 1) };
    assert_eq!(found(&nothing, of(Kind::Mean), &[&root]), Err(Missing::Empty));
}

#[test]
fn what_is_nothing_but_rounding_is_looked_at_within_bounds() {
    let looked = std::cell::Cell::new(0);
    let noise = |time: f64| {
        looked.set(looked.get() + 1);
        1e-13
            * ((time.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as f64 / 16_777_216.0
                - 0.5)
    };
    let rms = found(&run(0.0, 1.0, 180), of(Kind::Rms), &[&noise]);
    is(rms, 1e-13 / 12.0_f64.sqrt(), 1e-14);
    // Halved to the end everywhere this takes 180 * 8 * 2^24 * 15 looks.
    assert!(looked.get() < 2_000_000, "{}", looked.get());
    // A run of kinks is still found to rounding.
    let kinks = |time: f64| (time * 40.0).sin().abs();
    let expected = (25.0 - (40.0 - 12.0 * PI).cos()) / 40.0;
    is(found(&run(0.0, 1.0, 180), of(Kind::Integral), &[&kinks]), expected, 12.0 * 1e-13);
}

/// Something that no halving makes smooth: the last digits of a product, a number of each time.
fn rounding(time: f64) -> f64 {
    let bits = time.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11;
    1e-9 * (bits as f64 / 2f64.powi(53) - 0.5)
}

#[test]
fn extremes_of_what_is_nothing_but_rounding_take_few_evaluations() {
    let motion = run(0.0, 3.0, 500);
    let count = std::cell::Cell::new(0);
    let sample = |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| {
        count.set(count.get() + 1);
        values[0] = rounding(time);
        values[1] = time.sin();
    };
    let found = extremes(&motion, ALWAYS, 2, &sample);
    let [Some(rounding), Some(sine)] = &found[..] else { panic!("{found:?}") };
    assert!(rounding.highest.value.abs() <= 0.5e-9 && rounding.lowest.value.abs() <= 0.5e-9);
    assert!((sine.highest.value - 1.0).abs() < 1e-15, "{sine:?}");
    // Nine in each of 500 steps. The naive way halves and climbs wherever something seems to rise: 203 000.
    assert!(count.get() < 7_000, "{} evaluations", count.get());
}

#[test]
fn beside_a_jump_small_waves_are_still_resolved() {
    let motion = run(0.0, 3.0, 3);
    let waves = |time: f64| if time < 0.3 { 5.0 } else { 1e-3 * (300.0 * time).sin() };
    let sample =
        |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| values[0] = waves(time);
    let found = extremes(&motion, ALWAYS, 1, &sample)[0].clone().unwrap();
    assert!((found.lowest.value + 1e-3).abs() < 1e-14, "{:?}", found.lowest);
}

#[test]
fn extremes_near_places_are_those_of_their_windows() {
    let motion = run(0.0, 10.0, 50);
    let sample = |_: Phase<'_, f64>, time: f64, _: &[f64], values: &mut [f64]| {
        values.copy_from_slice(&[time.sin(), 2.0 * time.cos() + 0.01 * time]);
    };
    let windows = [[(4.0, 5.0), (7.5, 8.2)], [(3.0, 3.4), (5.9, 6.4)]];
    let found = extremes_near(&motion, &windows, &sample);
    let value = |quantity: usize, end: usize| found[quantity][end].unwrap().value;
    assert!((value(0, 0) + 1.0).abs() < 1e-15 && (value(0, 1) - 1.0).abs() < 1e-15, "{found:?}");
    let turn = PI - (0.005_f64).asin();
    assert!((value(1, 0) - 2.0 * turn.cos() - 0.01 * turn).abs() < 1e-14, "{found:?}");
    let turn = 2.0 * PI + (0.005_f64).asin();
    assert!((value(1, 1) - 2.0 * turn.cos() - 0.01 * turn).abs() < 1e-14, "{found:?}");
}
