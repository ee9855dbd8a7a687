//! Motions through events that repeat: a ball on a shaken table, a mass that is shaken against a stop.

use crate::stability::{Row, told};
use std::f64::consts::PI;

use assur::hybrid::{self, Cycle, CycleError};
use assur::prelude::*;

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-12);

mod ball {
    assur::mechanism! {
        /// A ball that bounces on a table which moves up and down.
        Ball from "P. J. Holmes, J. Sound Vib. 84 (1982) 173";
        parameter g = 9.80665 [m/s^2], a = 1 mm, omega = 200 [1/s], e = 0.8 in 0 .. 1;
        let table = a*cos(omega*time);
        coordinate y: m = 1 mm, rate = 0.15 [m/s];
        motion ddot(y) = -g;
        when y - table falls { set y = table, dot(y) = dot(table) + e*(dot(table) - dot(y)); }
        output y, table;
        measure height = peak(y - table) [mm];
        scene bounce { periodic over 2*pi/omega; }
    }
}

mod rubbed {
    assur::mechanism! {
        /// A shaken mass that rubs; what rubs changes its sense within a thousandth of the speed. A stop is far away.
        Rubbed from "made up";
        parameter m = 1 kg, c = 100 [N/m], d = 1 [N s/m], F_c = 2 N, v_s = 0.5 [mm/s];
        parameter F = 8 N, omega = 12 [1/s], far = 1 m;
        coordinate x: m = 0;
        let rub = tanh(dot(x)/v_s);
        motion m*ddot(x) = F*cos(omega*time) - c*x - d*dot(x) - F_c*rub;
        output x;
        /// By how much areas of starts shrink over the period, as a logarithm.
        measure shrinks = total((d + F_c/v_s*(1 - rub^2))/m);
        effect stop "far away" { when x - far rises { set dot(x) = -dot(x); } }
        scene smooth { periodic over 2*pi/omega; }
        scene stopped = stop { periodic over 2*pi/omega; }
    }
}

/// The slope of what rubs is next to nothing but for moments: variations that choose their steps by themselves step over these,
/// and their product, which Liouville's formula gives, is not even near. That of a motion that is as accurate is.
#[test]
fn multipliers_of_what_rubs_follow_from_its_losses() {
    let check = |motion: Motion, rtol: f64| {
        let [first, second] = motion.multipliers() else { panic!("{:?}", motion.multipliers()) };
        let expected = (-motion.measure("shrinks").expect("it is there")).exp();
        // A pair of them that are no real numbers has the square of the modulus.
        let found = first.modulus() * second.modulus();
        assert!((found / expected - 1.0).abs() < 1e4 * rtol, "{rtol}: {found} {expected}");
        // Were it not for the rubbing, it would be the damping alone.
        let damping = (-motion.length().expect("a period")).exp();
        assert!(found < 0.9 * damping, "{found} {damping}");
    };
    for rtol in [1e-6, 1e-8, 1e-10] {
        let settings = Settings::new(Method::Dop853).rtol(rtol);
        check(rubbed::Smooth::default().solve(&settings).expect("it repeats"), rtol);
        check(rubbed::Stopped::default().solve(&settings).expect("it repeats"), rtol);
    }
}

mod stop {
    assur::mechanism! {
        /// A mass on a spring and a damper, shaken, and a second spring that it meets.
        Stop from "a piecewise linear oscillator";
        parameter m = 1 kg, c = 100 [N/m], d = 1 [N s/m], stiff = 1e5 [N/m], damping = 20 [N s/m];
        parameter F = 8 N, omega = 12 [1/s], gap = 5 mm;
        coordinate x: m = 0;
        let pull = F*cos(omega*time) - c*x - d*dot(x);
        let push = stiff*(x - gap) + damping*dot(x);
        mode free {
            let N = 0;
            motion m*ddot(x) = pull;
            when x - gap rises -> pressed;
        }
        mode pressed {
            let N = push;
            motion m*ddot(x) = pull - push;
            when push falls -> apart;
        }
        mode apart "The stop stays behind: its spring is not yet relaxed." {
            let N = 0;
            motion m*ddot(x) = pull;
            when x - gap falls -> free;
            when push rises -> pressed;
        }
        output x, dot(x), N;
        measure N_max = peak(N), contact = duration(N > 0);
        scene shaken { periodic over 2*pi/omega; }
    }
}

mod relay {
    assur::mechanism! {
        /// A relay that switches a lag: at given angles, or where the lag comes to a limit, once more by a quantity that
        /// jumps there.
        Relay from "made up";
        parameter T = 1 s, P = 2.2 s, push = 1/2, limit = 1/2;
        driver phi = 2*pi*time/P;
        state x: 1 = 0;
        let shaken = push*sin(phi);
        choice switch "what the relay switches by" {
            clock { let high = if sin(phi) > 0 { 10 + x } else { x - 10 }; let low = high; }
            level { let high = x - limit; let low = x + limit; }
            jump {
                let high = if x > limit { 3 + x } else { x - 3 };
                let low = if x < -limit { x - 3 } else { 3 + x };
            }
        }
        mode up { motion T*dot(x) + x = 1 + shaken; when high rises -> down; }
        mode down { motion T*dot(x) + x = -1 + shaken; when low falls -> up; }
        output x;
        scene clocked { periodic over P; }
        scene limited = switch.level { periodic over P; }
        scene jumping = switch.jump { periodic over P; }
    }
}

mod tent {
    assur::mechanism! {
        /// A number that is kicked once a period.
        Tent from "the tent map";
        parameter P = 1 s, slope = 1.9;
        driver phi = 2*pi*time/P;
        state x: 1 = 0.3;
        motion rest: dot(x) = 0 [1/s];
        when cos(phi) falls { set x = if x < 1/2 { slope*x } else { slope*(1 - x) }; }
        output x;
        scene kicked { periodic over P; }
    }
}

/// The scene at which the ball bounces once a period, with this amplitude in terms of gravity.
fn bounce(amplitude: f64) -> ball::Bounce {
    let scene = ball::Bounce::default();
    ball::Bounce { a: amplitude * scene.g / scene.omega.powi(2), ..scene }
}

/// Looks for it near the motion of the closed form.
fn cycle(scene: &ball::Bounce) -> Result<Cycle, CycleError> {
    let period = 2.0 * PI / scene.omega;
    let (speed, impact) = closed_form(scene);
    let (place, flown) = (scene.a * impact.cos(), period - impact / scene.omega);
    let y = place + speed * flown - scene.g * flown * flown / 2.0;
    let start = [y, 1.0001 * (speed - scene.g * flown)];
    hybrid::cycle_from(scene, (0, &start), period, &FINE)
}

/// Speed after the impact and the angle at which it happens, where the ball bounces once a period: it leaves and comes
/// back at half the speed that gravity changes in a period, and the table makes up for the loss.
fn closed_form(scene: &ball::Bounce) -> (f64, f64) {
    let speed = scene.g * PI / scene.omega;
    let table = speed * (1.0 - scene.e) / (1.0 + scene.e);
    (speed, 2.0 * PI - (table / (scene.a * scene.omega)).asin())
}

/// The largest amplitude at which bouncing once a period is stable: there its multiplier is -1.
fn limit(e: f64) -> f64 {
    let lost = PI * (1.0 - e) / (1.0 + e);
    lost.hypot(2.0 * (1.0 + e * e) / (1.0 + e).powi(2))
}

#[test]
fn a_ball_bounces_once_a_period_at_the_phase_of_the_closed_form() {
    let scene = bounce(0.9);
    let found = cycle(&scene).unwrap();
    assert_eq!((found.multiple, found.motion.events.len()), (1, 1));
    let (speed, angle) = closed_form(&scene);
    let event = &found.motion.events[0];
    assert!((event.before[1] + speed).abs() < 1e-11 * speed, "{event:?}");
    assert!((event.after[1] - speed).abs() < 1e-11 * speed, "{event:?}");
    assert!((scene.omega * event.time - angle).abs() < 1e-10, "{}", scene.omega * event.time);
    // One impact loses the area e^2 in the plane of phase and speed.
    let product: f64 = found.multipliers.iter().map(|one| one.modulus()).product();
    assert!((product - scene.e.powi(2)).abs() < 1e-9, "{product}");
}

#[test]
fn the_multiplier_is_minus_one_where_the_closed_form_says_that_the_motion_doubles_its_period() {
    let e = ball::Bounce::default().e;
    let below = cycle(&bounce(limit(e) * 0.9999)).unwrap();
    assert_eq!(below.multiple, 1);
    let largest = below.multipliers[0];
    assert!(largest.re < -0.99 && largest.re > -1.0 && largest.im == 0.0, "{largest}");
    let above = cycle(&bounce(limit(e) * 1.01)).unwrap();
    assert_eq!(above.multiple, 2);
    assert!(above.is_stable());
    assert_eq!(above.motion.events.len(), 2);
}

/// A map of which every motion that repeats is unstable, as often as it is applied: its slope is 1.9 or -1.9.
#[test]
fn where_nothing_that_repeats_is_stable_the_evidence_is_given() {
    let scene = tent::Kicked::default();
    let error = hybrid::cycle(&scene, scene.P, &FINE).unwrap_err();
    let CycleError::NoneStable { followed, growth, unstable, .. } = &error else {
        panic!("not expected: {error}");
    };
    assert!(*followed > 400 && (growth - scene.slope).abs() < 1e-9, "{error}");
    if let Some(cycle) = unstable {
        let expected = scene.slope.powi(cycle.multiple as i32);
        let found = cycle.multipliers[0].modulus();
        assert!((found / expected - 1.0).abs() < 1e-9, "{error}");
    }
    // The naive way, a long simulation, returns numbers all the same.
    let naive = hybrid::march(&scene, (0.0, 100.0 * scene.P), &scene.start(), &FINE).unwrap();
    assert!(naive.end.iter().all(|one| one.is_finite()));
    told(&Row {
        case: "Nothing stable",
        tried: "a map of slope 1.9, of which every motion that repeats is unstable",
        naive: format!(
            "a simulation of 100 periods ends at {:.4}, which says nothing",
            naive.end[0]
        ),
        ours: format!("an error: {}", error.to_string().replace('\n', " ")),
        cost: format!("{followed} periods are followed"),
    });
}

/// A mass that never meets its stop, with so little damping that what it begins with is there for thousands of periods.
/// After 480 of them it is still far from the motion that repeats, and where it swings once in four periods it comes near
/// to its past after four: it repeats after one all the same.
#[test]
fn what_dies_out_slowly_repeats_after_one_period() {
    for (c, d) in [(55.0, 0.02), (55.0, 0.002), (9.0, 0.02), (9.0, 0.1)] {
        let (gap, omega) = (10.0, 12.0);
        let scene = stop::Shaken { c, d, gap, omega, ..stop::Shaken::default() };
        let period = 2.0 * PI / omega;
        let found = hybrid::cycle(&scene, period, &FINE).unwrap();
        assert_eq!(found.multiple, 1, "c = {c}, d = {d}");
        let expected = (-d * period / 2.0).exp();
        for one in &found.multipliers {
            assert!((one.modulus() - expected).abs() < 1e-9, "{one} {expected}");
        }
        // The amplitude of the forced oscillation, at the force and 90 degrees behind it.
        let (_, state) = found.motion.at(0.0);
        let (stiff, lag) = (c - omega * omega, d * omega);
        let x = 8.0 * stiff / (stiff * stiff + lag * lag);
        assert!((state[0] - x).abs() < 1e-9, "{} {x}", state[0]);
    }
}

#[test]
fn the_multipliers_are_those_of_differences() {
    let scene = stop::Shaken::default();
    let period = 2.0 * PI / scene.omega;
    let found = hybrid::cycle(&scene, period, &FINE).unwrap();
    assert!(found.motion.events.len() >= 2, "{:?}", found.motion.events.len());
    let time = period * found.multiple as f64;
    let piece = &found.motion.pieces[0];
    let start = piece.trajectory.at(0.0);
    let end = |change: [f64; 2]| {
        let start = [start[0] + change[0], start[1] + change[1]];
        hybrid::march_in(&scene, piece.mode, (0.0, time), &start, &FINE).unwrap().end
    };
    let column = |change: [f64; 2], size: f64| {
        let (after, before) = (end(change), end([-change[0], -change[1]]));
        [0, 1].map(|row| (after[row] - before[row]) / (2.0 * size))
    };
    let (first, second) = (column([1e-8, 0.0], 1e-8), column([0.0, 1e-7], 1e-7));
    let (trace, determinant) = (first[0] + second[1], first[0] * second[1] - first[1] * second[0]);
    let [a, b] = [found.multipliers[0], found.multipliers[1]];
    assert!((a.re + b.re - trace).abs() < 1e-6, "{} against {trace}", a.re + b.re);
    let product = a.re * b.re - a.im * b.im;
    assert!((product - determinant).abs() < 1e-6, "{product} against {determinant}");
    // Without the jump of the variations at events they are others: the smooth part alone.
    let smooth = (-scene.d / scene.m * time).exp();
    assert!((product - smooth).abs() > 1e-3, "{product} {smooth}");
}

#[test]
fn a_long_simulation_comes_to_the_same_motion() {
    let scene = stop::Shaken::default();
    let period = 2.0 * PI / scene.omega;
    let found = hybrid::cycle(&scene, period, &FINE).unwrap();
    assert!(found.is_stable());
    let turns = 400.0 * found.multiple as f64;
    let long = hybrid::march(&scene, (0.0, turns * period), &scene.start(), &FINE).unwrap();
    // The long one may have come to any of the periods.
    let apart = |number: usize| {
        let (_, state) = found.motion.at(number as f64 * period);
        let pairs = long.end.iter().zip(&state);
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    let nearest = (0..found.multiple).map(apart).fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-9, "{nearest:e}");
}

/// What it jumps by is a function of time alone: all motions switch together, and only the lag forgets.
#[test]
fn a_guard_that_jumps_at_a_given_time_does_not_depend_on_the_state() {
    let scene = relay::Clocked::default();
    let found = hybrid::cycle(&scene, scene.P, &FINE).unwrap();
    assert_eq!((found.multiple, found.motion.events.len()), (1, 2));
    let expected = (-scene.P / scene.T).exp();
    let multiplier = found.multipliers[0];
    assert!((multiplier.re - expected).abs() < 1e-11, "{multiplier} against {expected}");
}

#[test]
fn a_guard_that_jumps_where_another_passes_zero_is_that_other() {
    let (limited, jumping) = (relay::Limited::default(), relay::Jumping::default());
    let one = hybrid::cycle(&limited, limited.P, &FINE).unwrap();
    let other = hybrid::cycle(&jumping, jumping.P, &FINE).unwrap();
    assert_eq!((one.multiple, other.multiple), (1, 1));
    let [a, b] = [one, other].map(|cycle| cycle.multipliers[0].re);
    assert!((a - b).abs() < 1e-8, "{a} against {b}");
    let smooth = (-limited.P / limited.T).exp();
    assert!((a - smooth).abs() > 0.01, "{a}");
}
