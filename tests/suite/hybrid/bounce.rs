//! A ball on a floor.

use assur::hybrid::{HybridError, march};
use assur::prelude::*;

use crate::stability::{Row, told};

assur::mechanism! {
    /// A ball that falls on a floor and springs back.
    Ball from "any textbook";
    parameter g = 9.80665 [m/s^2], e = 0.8;
    coordinate x: m = 1 m;
    motion fall: ddot(x) = -g;
    output x, dot(x);
    when x falls { set dot(x) = -e*dot(x); }
    scene fall { run time 0 s .. 3 s; }
}

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-10);

/// Times of the impacts: the first after `√(2h/g)`, each flight `e` times as long as the one before.
fn impacts(e: f64, count: i32) -> Vec<f64> {
    let first = (2.0 / 9.80665_f64).sqrt();
    (0..count).map(|k| first + 2.0 * first * (1..=k).map(|j| e.powi(j)).sum::<f64>()).collect()
}

#[test]
fn impacts_are_found_to_the_last_digits() {
    let ball = Fall::default();
    let motion = march(&ball, (0.0, 3.0), &[1.0, 0.0], &SETTINGS).expect("it bounces");
    let expected = impacts(0.8, motion.events.len() as i32);
    assert_eq!(motion.events.len(), 6);
    for (event, expected) in motion.events.iter().zip(expected) {
        assert!((event.time - expected).abs() < 5e-14, "{} {expected}", event.time);
        assert!(event.guard.abs() < 1e-14 && event.after[1] == -0.8 * event.before[1]);
    }
}

/// A ball that loses a fifth of its speed each time comes to rest after infinitely many impacts.
#[test]
fn a_ball_that_comes_to_rest_is_reported_as_chatter() {
    let ball = Fall::default();
    let rest = impacts(0.8, 400)[399];
    let ended = march(&ball, (0.0, 10.0), &[1.0, 0.0], &SETTINGS);
    let Err(HybridError::Chatter { time, events, motion, .. }) = ended else {
        panic!("{}", ended.map_or_else(|e| e.to_string(), |m| format!("{:?}", m.events.last())));
    };
    assert!((time - rest).abs() < 1e-6, "{time} {rest}");
    assert!(
        (60..90).contains(&motion.events.len()) && events < 30,
        "{events} of {}",
        motion.events.len()
    );
    // The naive way, steps of a millisecond: turn the speed about where the height is below zero.
    let (mut height, mut speed, mut lowest) = (1.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..10_000 {
        speed -= 9.80665e-3;
        height += 1e-3 * speed;
        if height < 0.0 {
            speed *= -0.8;
        }
        lowest = lowest.min(height);
    }
    assert!(lowest < -1e-3, "{lowest}");
    told(&Row {
        case: "Chatter and Zeno",
        tried: "a ball that keeps 0.8 of its speed at each impact, beyond the 4 s after which it rests",
        naive: format!(
            "steps of 1 ms with the speed turned below the floor: {lowest:.0e} m, through the floor"
        ),
        ours: format!(
            "reported at {time:.7} s (exactly {rest:.7} s), after {} impacts",
            motion.events.len()
        ),
        cost: format!("{} evaluations", motion.statistics.evaluations),
    });
}

/// Without a loss the impacts keep their phase over many cycles.
#[test]
fn impacts_keep_their_phase() {
    let ball = Fall { e: 1.0, ..Fall::default() };
    let first = (2.0 / 9.80665_f64).sqrt();
    let cycles = 1000.0;
    let end = first * (2.0 * cycles + 2.0);
    let motion = march(&ball, (0.0, end), &[1.0, 0.0], &SETTINGS).expect("it bounces");
    assert_eq!(motion.events.len(), 1001, "{:?}", motion.events.last());
    let last = motion.events.last().unwrap().time;
    let drift = last / (first * (2.0 * cycles + 1.0)) - 1.0;
    assert!(drift.abs() < 1e-11, "{drift:e}");
}
