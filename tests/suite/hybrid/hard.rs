//! Events of which the signs at the ends of steps say nothing, and events that meet.

use crate::stability::{Row, told};
use assur::hybrid::{HybridError, Motion, march};
use assur::prelude::*;
use assur::shape::Shape;

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-9);

/// Texts of the events that happened, with their times.
fn log(shape: &Shape, motion: &Motion) -> Vec<(&'static str, f64)> {
    let one = |event: &assur::hybrid::Happened| {
        (shape.modes[event.from].events[event.event].text, event.time)
    };
    motion.events.iter().map(one).collect()
}

mod graze {
    assur::mechanism! {
        /// A turning mark that just reaches a level.
        Graze from "made up";
        parameter level = 0.999999;
        state phase: 1 = 0;
        state counted: 1 = 0;
        motion turn: dot(phase) = 1 [1/s];
        motion count: dot(counted) = 0 [1/s];
        output counted;
        when sin(phase) - level crosses { set counted = counted + 1; }
        scene once { run time 0 s .. 40 s; }
    }
}

/// The level is passed twice in 2.8 ms; the steps are seconds long.
#[test]
fn pairs_of_crossings_within_a_step_are_found() {
    let graze = graze::Once::default();
    let motion = march(&graze, (0.0, 40.0), &[0.0, 0.0], &SETTINGS).expect("it turns");
    assert_eq!(motion.events.len(), 2 * 7);
    assert!(motion.statistics.largest_step > 1.0);
    let half = 0.999999_f64.acos();
    for (k, pair) in motion.events.chunks(2).enumerate() {
        let top = std::f64::consts::TAU * (k as f64 + 0.25);
        for (event, expected) in pair.iter().zip([top - half, top + half]) {
            assert!((event.time - expected).abs() < 1e-12, "{} {expected}", event.time);
        }
    }
    // The naive way compares signs at the ends of the steps.
    let ends = motion.pieces.iter().flat_map(|piece| piece.trajectory.times());
    let seen = ends.filter(|time| time.sin() > 0.999999 + 1e-12).count();
    assert_eq!(seen, 0);
    told(&Row {
        case: "Grazing",
        tried: "a level that is passed and left within 2.8 ms, in steps of more than a second, seven times",
        naive: format!("signs at the ends of steps: {seen} of 14 crossings"),
        ours: format!(
            "{} of 14, to 1e-12 s; a touch from inside changes nothing",
            motion.events.len()
        ),
        cost: "values of the guard along the dense output, no more steps".to_owned(),
    });
}

/// The state is a straight line, so that steps grow without end, over many turns of the mark. What the guard does
/// meanwhile is looked at all the same: to trust a cubic through its ends misses one crossing in eighty.
#[test]
fn steps_over_many_swings_of_a_guard_hide_nothing() {
    for method in [Method::Tsit5, Method::Dop853, Method::Taylor, Method::Radau, Method::Rosenbrock]
    {
        for run in 1..60 {
            let run = f64::from(run);
            let (level, shift) = (0.999_999 * (0.77 * run).sin(), 0.11 * run);
            let graze = graze::Once { level };
            let settings = Settings { method, ..SETTINGS };
            let motion = march(&graze, (0.0, 400.0), &[shift, 0.0], &settings).expect("it turns");
            // The mark passes the level twice in each turn.
            let [start, turns] = [shift, shift + 400.0].map(|mark| mark / std::f64::consts::TAU);
            let half = level.acos() / std::f64::consts::TAU;
            let passed = |at: f64| (turns - at).floor() - (start - at).floor();
            let expected = passed(0.25 - half) + passed(0.25 + half);
            let found = motion.events.len();
            assert_eq!(found, expected as usize, "{method:?}, level {level}");
        }
    }
}

mod touch {
    assur::mechanism! {
        /// A turning mark that touches a level and does not pass it.
        Touch from "made up";
        state phase: 1 = 0;
        motion turn: dot(phase) = 1 [1/s];
        output phase;
        when sin(phase) - 1 crosses { set phase = phase + 100; }
        scene once { run time 0 s .. 40 s; }
    }
}

#[test]
fn a_touch_changes_nothing() {
    let motion = march(&touch::Once::default(), (0.0, 40.0), &[0.0], &SETTINGS).expect("it turns");
    assert_eq!(motion.events.len(), 0, "{:?}", motion.events);
    assert!((motion.end[0] - 40.0).abs() < 1e-12);
}

mod relay {
    assur::mechanism! {
        /// Two marks that arrive together, the second of which starts a third.
        Relay from "made up";
        state a: 1 = 0, b: 1 = -1, c: 1 = -1;
        mode wait {
            motion first: dot(a) = 1 [1/s];
            motion second: dot(b) = 2 [1/s];
            hold c;
            when a - 1 rises -> half { set a = 5; }
        }
        mode half {
            hold a, b, c;
        }
        when b - 1 rises -> full { set c = 0; }
        mode full {
            hold a, b;
            motion third: dot(c) = 1 [1/s];
            when c rises -> done { set c = c - 3; }
        }
        mode done {
            hold a, b, c;
        }
        output a, b, c;
        scene both { run time 0 s .. 3 s; }
    }
}

/// One event sets what another watches: both happen at one instant, one after the other.
#[test]
fn events_at_one_instant_follow_each_other() {
    let motion = march(&relay::Both::default(), (0.0, 3.0), &[0.0, -1.0, -1.0], &SETTINGS)
        .expect("it comes to rest");
    let log = log(relay::Both::shape(), &motion);
    let texts: Vec<_> = log.iter().map(|one| one.0).collect();
    assert_eq!(
        texts,
        [
            "when a - 1 rises -> half { set a = 5; }",
            "when b - 1 rises -> full { set c = 0; }",
            "when c rises -> done { set c = c - 3; }",
        ]
    );
    assert!(log.iter().all(|one| (one.1 - 1.0).abs() < 1e-14), "{log:?}");
    assert_eq!((motion.end[0], motion.end[2]), (5.0, -3.0));
    assert!((motion.end[1] - 1.0).abs() < 1e-14);
    assert_eq!(motion.mode, 3);
}

/// A motion that begins where its mode is over would go on in it: nothing passes zero any more.
#[test]
fn a_start_beyond_the_end_of_its_mode_is_refused() {
    let marks = [5.0, -1.0, -1.0];
    let ended = march(&relay::Both::default(), (0.0, 3.0), &marks, &SETTINGS);
    let text = ended.unwrap_err().to_string();
    assert_eq!(
        text,
        "start: it is to begin in the mode `wait`, where `when a - 1 rises -> half { set a = 5; }` has happened already: what \
         that watches is 4; begin in the mode that follows, with `start half` in the scene, or with other values"
    );
}

mod geared {
    assur::mechanism! {
        /// A mark that goes at one of two speeds: half of the condition depends on a constant alone.
        Geared from "made up";
        parameter gear = 3, slow = 1 [1/s];
        state x: 1 = 0;
        motion go: dot(x) = if gear > 2 && x < 2 { 2*slow } else { slow };
        when x - 3 rises { set x = 0; }
        output x;
        scene once { run time 0 s .. 3 s; }
    }
}

/// What is known of a condition before the run is kept beside the numbers, and goes with them to other threads.
#[test]
fn conditions_on_constants_are_kept() {
    for (gear, end) in [(3.0, 2.5), (1.0, 0.5)] {
        let geared = geared::Once { gear, slow: 1.0 };
        let motion = march(&geared, (0.0, 3.5), &[0.0], &SETTINGS).expect("it goes");
        assert!((motion.end[0] - end).abs() < 1e-12, "{:?}", motion.end);
    }
}

mod circle {
    assur::mechanism! {
        /// Two modes that lead to each other without taking any time.
        Circle from "made up";
        state x: 1 = -1;
        motion go: dot(x) = 1 [1/s];
        mode left { when x rises -> right { set x = 0; } }
        mode right { when 2*x rises -> left { set x = 0; } }
        output x;
        scene turns { run time 0 s .. 3 s; }
    }
}

#[test]
fn events_without_end_at_one_instant_are_reported_with_their_modes() {
    let ended = march(&circle::Turns::default(), (0.0, 3.0), &[-1.0], &SETTINGS);
    let Err(HybridError::Loop { time, modes, motion, .. }) = ended else {
        panic!("{ended:?}");
    };
    assert!((time - 1.0).abs() < 1e-14, "{time}");
    assert_eq!(modes, [0, 1, 0]);
    assert!(motion.events.len() > 10);
}
