//! Guards with kinks and jumps, against guards that are looked at everywhere.

use assur::hybrid::{HybridError, march};
use assur::prelude::*;

mod random {
    assur::mechanism! {
        /// A guard that bends and jumps while the state does nothing, so that steps grow over many turns.
        Random from "made up";
        parameter fast = 5 [rad/s], slow = 2 [rad/s], p = 1, q = 1, r = 0 s, level = 0.5, low = 0.1, middle = 0.2;
        let height = max(sin(fast*time), low);
        let gate = if sin(slow*time) > middle { 1 } else { 0 };
        let seen = p*height + q*abs(cos(slow*time) - middle)*gate + r*dot(height) - level;
        state counted: 1 = 0;
        motion count: dot(counted) = 0 [1/s];
        output counted;
        when seen crosses { set counted = counted + 1; }
        scene go { run time 0 s .. 10 s; }
    }
}

/// The same guard by hand.
fn seen(one: &random::Go, time: f64) -> f64 {
    let (angle, turn) = (one.fast * time, one.slow * time);
    let height = angle.sin().max(one.low);
    let rate = match angle.sin() > one.low {
        true => one.fast * angle.cos(),
        false => 0.0,
    };
    let gate = if turn.sin() > one.middle { 1.0 } else { 0.0 };
    one.p * height + one.q * (turn.cos() - one.middle).abs() * gate + one.r * rate - one.level
}

/// Numbers made at random, the same in every run.
struct Dice(u64);

impl Dice {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Between 50000 points guards change their sign where an event is found, and nowhere else.
#[test]
fn no_jump_and_no_bend_hides_a_crossing() {
    const POINTS: usize = 50_000;
    let (mut dice, mut count) = (Dice(7), 0);
    for case in 0..600 {
        let r = dice.between(-0.1, 0.1);
        let one = random::Go {
            fast: dice.between(1.0, 20.0),
            slow: dice.between(0.3, 9.0),
            p: dice.between(-1.0, 1.0),
            q: dice.between(-1.0, 1.0),
            r: if case % 2 == 0 { r } else { 0.0 },
            level: dice.between(-1.0, 1.5),
            low: dice.between(-0.9, 0.9),
            middle: dice.between(-0.9, 0.9),
        };
        let methods = [Method::Tsit5, Method::Dop853, Method::Radau, Method::Taylor];
        let method = methods[case % 4];
        let settings = Settings::new(method).rtol(1e-6);
        let motion = march(&one, (0.0, 10.0), &[0.0], &settings).expect("nothing moves");
        let time = |point: usize| 10.0 * point as f64 / POINTS as f64;
        let mut before = seen(&one, 0.0);
        for point in 1..=POINTS {
            let value = seen(&one, time(point));
            if before * value < 0.0 {
                count += 1;
                let within = (time(point - 1) - 1e-9)..(time(point) + 1e-9);
                let is_found = motion.events.iter().any(|event| within.contains(&event.time));
                assert!(is_found, "{method:?}: nothing in {within:?} with {one:?}");
            }
            before = value;
        }
        for event in &motion.events {
            let [low, high] = [-1e-8, 1e-8].map(|off| seen(&one, event.time + off));
            assert!(low * high <= 0.0, "{method:?}: {} with {one:?}", event.time);
        }
    }
    assert!(count > 8000, "{count}");
}

mod rest {
    assur::mechanism! {
        /// A mark that swings for a short while after a long rest, beside a slow swing that the steps follow.
        Rest from "made up";
        parameter omega = 40 [rad/s], middle = 50 s, width = 0.4 s, level = 0.5;
        let swing = sin(omega*time)*exp(-((time - middle)/width)^2);
        state slow: 1 = 1, turned: 1 = 0;
        motion swings: dot(slow) = -0.3*turned/(1 s);
        motion turns: dot(turned) = 0.3*slow/(1 s);
        output slow;
        when swing - level rises { set slow = slow; }
        scene go { run time 0 s .. 60 s; }
    }
}

/// Steps are all about as long as those that have been looked into in the rest, and longer than all of the swing.
#[test]
fn what_begins_after_a_long_rest_is_seen() {
    let one = rest::Go::default();
    let swing = |time: f64| {
        let far = (time - one.middle) / one.width;
        (one.omega * time).sin() * (-far * far).exp() - one.level
    };
    let times: Vec<f64> = (0..200_000).map(|k| 49.0 + f64::from(k) * 1e-5).collect();
    let rises = times.windows(2).filter(|pair| swing(pair[0]) < 0.0 && swing(pair[1]) >= 0.0);
    let rises: Vec<f64> = rises.map(|pair| pair[0]).collect();
    assert_eq!(rises.len(), 5);
    let settings = Settings::new(Method::Dop853).rtol(1e-6);
    let motion = march(&one, (0.0, 60.0), &[1.0, 0.0], &settings).expect("it turns");
    assert!(motion.statistics.largest_step > 2.0);
    assert_eq!(motion.events.len(), rises.len(), "{rises:?}");
    for (event, before) in motion.events.iter().zip(rises) {
        assert!((before..before + 1e-5).contains(&event.time), "{}", event.time);
    }
}

/// More turns than can be looked at are an error, not a motion without events.
#[test]
fn an_absurd_speed_is_an_error() {
    let settings = Settings::new(Method::Dop853).rtol(1e-6);
    let one = rest::Go { omega: 1e12, ..rest::Go::default() };
    let ended = march(&one, (0.0, 60.0), &[1.0, 0.0], &settings);
    let Err(HybridError::Turns { turned, .. }) = ended else {
        panic!("{:?}", ended.map(|motion| motion.events.len()));
    };
    assert!(turned > 1e7);
}
