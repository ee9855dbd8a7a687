//! Where motions with events begin.

use assur::hybrid::{HybridError, march};
use assur::prelude::*;

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-9);

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
    assert!((motion.events[0].time - 1.0).abs() < 1e-9, "{}", motion.events[0].time);
    let never = start::Pushed { gap: 1e3 };
    let motion = march(&never, (0.0, 2.0), &[0.0; 4], &SETTINGS).expect("it moves");
    assert_eq!((motion.events.len(), motion.mode), (0, 0));
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

mod wall {
    assur::mechanism! {
        /// A mass that is pushed against a wall, which takes up its speed.
        Wall from "made up";
        parameter e = 0 in 0 .. 1;
        coordinate x: m = -1 m;
        motion push: ddot(x) = 1 [m/s^2];
        when x rises { set dot(x) = -e*dot(x); }
        output x;
        scene pushed { run time 0 s .. 5 s; }
    }
}

/// A blow without rebound leaves the mass at the wall, and the push goes on: without a mode in which the mass rests there,
/// the event happens again and again.
#[test]
fn a_wall_that_takes_up_all_speed_is_not_passed() {
    let ended = march(&wall::Pushed::default(), (0.0, 5.0), &[-1.0, 0.0], &SETTINGS);
    let Err(HybridError::Chatter { since, motion, .. }) = ended else {
        panic!("{ended:?}");
    };
    assert!((since - 2.0_f64.sqrt()).abs() < 1e-12, "{since}");
    assert!(motion.end[0].abs() < 1e-12, "{:?}", motion.end);
}
