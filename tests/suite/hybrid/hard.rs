//! Events of which the signs at the ends of steps say nothing, and events that meet.

use assur::hybrid::{HybridError, Motion, march};
use assur::prelude::*;

const SETTINGS: Settings = Settings {
    method: Method::Dop853,
    rtol: 1e-9,
};

/// Texts of the events that happened, with their times.
fn log<C: assur::hybrid::Hybrid>(motion: &Motion) -> Vec<(&'static str, f64)> {
    let one =
        |event: &assur::hybrid::Happened| (C::EVENTS[event.from][event.event].text, event.time);
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
            assert!(
                (event.time - expected).abs() < 1e-12,
                "{} {expected}",
                event.time
            );
        }
    }
    // The naive way compares signs at the ends of the steps.
    let ends = motion
        .pieces
        .iter()
        .flat_map(|piece| piece.trajectory.times());
    let seen = ends.filter(|time| time.sin() > 0.999999 + 1e-12).count();
    assert_eq!(seen, 0);
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
    let motion = march(
        &relay::Both::default(),
        (0.0, 3.0),
        &[0.0, -1.0, -1.0],
        &SETTINGS,
    )
    .expect("it comes to rest");
    let log = log::<relay::Both>(&motion);
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
    let Err(HybridError::Loop {
        time,
        modes,
        motion,
        ..
    }) = ended
    else {
        panic!("{ended:?}");
    };
    assert!((time - 1.0).abs() < 1e-14, "{time}");
    assert_eq!(modes, [0, 1, 0]);
    assert!(motion.events.len() > 10);
}

mod start {
    assur::mechanism! {
        /// A mass that is pushed from the very beginning, against a stop that is not there.
        Start from "made up";
        parameter gap = 0 m;
        coordinate x: m = 0, y: m = 0;
        mode alone {
            motion push: ddot(x) = 1 [m/s^4]*time^2;
            hold y;
            when x - gap rises -> together;
        }
        mode together {
            motion push: ddot(x) = 1 [m/s^4]*time^2;
            motion follow: ddot(y) = 1 [m/s^2];
        }
        output x, y;
        scene pushed { run time 0 s .. 1 s; }
    }
}

/// The guard is zero at the start, and so are its first three derivatives.
#[test]
fn an_event_at_the_start_takes_no_time() {
    let motion =
        march(&start::Pushed::default(), (0.0, 1.0), &[0.0; 4], &SETTINGS).expect("it moves");
    assert_eq!(motion.events.len(), 1);
    assert!(motion.events[0].time < 1e-3, "{}", motion.events[0].time);
    let late = start::Pushed { gap: 1.0 / 12.0 };
    let motion = march(&late, (0.0, 2.0), &[0.0; 4], &SETTINGS).expect("it moves");
    assert!(
        (motion.events[0].time - 1.0).abs() < 1e-9,
        "{}",
        motion.events[0].time
    );
    let never = start::Pushed { gap: 1e3 };
    let motion = march(&never, (0.0, 2.0), &[0.0; 4], &SETTINGS).expect("it moves");
    assert_eq!((motion.events.len(), motion.mode), (0, 0));
}

mod rub {
    assur::mechanism! {
        /// A block on a table, pushed by a force that swings, slowed by dry friction.
        Rub from "any textbook";
        parameter m = 1 kg, R = 1 N, F = 5 N, omega = 3 [rad/s];
        coordinate x: m = 0, rate = 1 [m/s];
        motion slide: m*ddot(x) = F*cos(omega*time) - R*sign(dot(x));
        output x, friction = -R*sign(dot(x)) [N];
        scene pushed { run time 0 s .. 10 s; }
        scene coasting { run time 0 s .. 10 s; }
    }
}

/// Where friction changes its sign the equations jump. A stepper that does not know it creeps up to each jump in ever
/// smaller steps, 7900 evaluations; to find the jumps and end steps there takes 970 for the same accuracy.
#[test]
fn steps_end_where_a_branch_changes() {
    let scene = rub::Pushed::default();
    let (fine, start) = (
        Settings {
            rtol: 1e-13,
            ..SETTINGS
        },
        [0.0, 1.0],
    );
    let reference = march(&scene, (0.0, 10.0), &start, &fine).expect("it slides");
    let located = march(&scene, (0.0, 10.0), &start, &SETTINGS).expect("it slides");
    let naive = assur::ode::march(&scene, (0.0, 10.0), &start, &SETTINGS).expect("it slides");
    let off = |end: &[f64]| (end[0] - reference.end[0]).abs();
    assert!(located.events.len() > 8);
    assert!(off(&located.end) < 5e-9 && off(naive.end()) < 5e-9);
    let (ours, theirs) = (located.statistics.evaluations, naive.statistics.evaluations);
    assert!(6 * ours < theirs, "{ours} {theirs}");
}

/// Without a push the block comes to rest, and friction holds it.
#[test]
fn friction_that_holds_is_reported() {
    let scene = rub::Coasting {
        F: 0.0,
        ..rub::Coasting::default()
    };
    let ended = march(&scene, (0.0, 10.0), &[0.0, 1.0], &SETTINGS);
    let Err(HybridError::Held { time, motion, .. }) = ended else {
        panic!("{ended:?}");
    };
    assert!((time - 1.0).abs() < 1e-12, "{time}");
    assert!((motion.end[0] - 0.5).abs() < 1e-12);
}

mod shelf {
    assur::mechanism! {
        /// A height with kinks: a follower on a rack that shows above a plate for a part of each turn.
        Shelf from "made up";
        parameter omega = 5 [rad/s];
        coordinate x: m = 0;
        let rack = max(0, cos(omega*time) - 0.5);
        motion follow: ddot(x) = rack*1 [m/s^2];
        output x, rack;
        scene turns { run time 0 s .. 4 s; }
    }
}

/// A kink in the time alone is a surface as well.
#[test]
fn kinks_of_what_drives_are_stepped_on() {
    let motion =
        march(&shelf::Turns::default(), (0.0, 4.0), &[0.0, 0.0], &SETTINGS).expect("it moves");
    let edge = (0.5_f64).acos() / 5.0;
    assert!((motion.events[0].time - edge).abs() < 1e-14);
    // v after whole turns: each gives (2 sin(pi/3) - pi/3)/omega.
    let turns = 3.0;
    let (_, state) = motion.at(std::f64::consts::TAU / 5.0 * turns);
    let expected = turns * (3.0_f64.sqrt() - std::f64::consts::PI / 3.0) / 5.0;
    assert!(
        (state[1] - expected).abs() < 1e-10,
        "{} {expected}",
        state[1]
    );
}

mod drag {
    assur::mechanism! {
        /// A block on a table, dragged by a spring whose other end is pushed just as hard as the block rubs.
        Drag from "made up";
        parameter J = 10 kg, m = 1 kg, c = 1e6 [N/m], d = 1100 [kg/s], F = 17 N;
        coordinate x: m = 0, y: m = 0;
        let T = c*(x - y);
        motion push: J*ddot(x) = F - d*dot(x) - T;
        mode rest {
            hold y;
            when T - F rises -> slip;
        }
        mode slip {
            motion rub: m*ddot(y) = T - F;
            when dot(y) falls -> rest { set dot(y) = 0; }
        }
        output T;
        scene dragged { run time 0 s .. 1 s; }
    }
}

/// Slip after slip the swing comes nearer to the friction, until they differ by the rounding of both. Seen as a number of
/// its own size that difference has a zero between any two others, and a search for the first has no end; nor do the
/// events, if a block whose acceleration is such a difference is taken to turn round.
#[test]
fn a_swing_that_ends_at_a_threshold() {
    let settings = Settings {
        rtol: 1e-13,
        ..SETTINGS
    };
    let drag = drag::Dragged::default();
    let motion = march(&drag, (0.0, 1.0), &[0.0; 4], &settings).expect("it comes to rest");
    assert!((60..200).contains(&motion.events.len()));
    assert!(motion.events.last().unwrap().time < 0.6);
    assert!(motion.statistics.evaluations < 30_000);
}

mod held {
    assur::mechanism! {
        /// A mass that a latch holds until a clock opens it.
        Latch from "made up";
        coordinate x: m = 2 m;
        mode latched {
            hold x;
            when time - 1 s rises -> free;
        }
        mode free {
            motion push: ddot(x) = 1 [m/s^2];
        }
        output x;
        scene opened { run time 0 s .. 3 s; }
    }
}

#[test]
fn what_is_held_stands_still() {
    let scene = held::Opened::default();
    let motion = march(&scene, (0.0, 3.0), &[2.0, 0.0], &SETTINGS).expect("it opens");
    assert_eq!(motion.at(0.5), (0, vec![2.0, 0.0]));
    assert!((motion.end[0] - 4.0).abs() < 1e-12, "{:?}", motion.end);
}

#[test]
fn a_start_that_moves_what_is_held_is_refused() {
    let ended = march(&held::Opened::default(), (0.0, 3.0), &[2.0, 0.5], &SETTINGS);
    let Err(error @ HybridError::Start { .. }) = ended else {
        panic!("{ended:?}");
    };
    let expected = "start: dot(x) is 0.5 in SI units, and the mode in which the motion begins holds it at zero";
    assert_eq!(error.to_string(), expected);
}
