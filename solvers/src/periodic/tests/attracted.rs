//! Motions with losses: the start values pick what they come to.

use super::*;

/// `x'' + 0.2 x' + x + x³ = force cos(speed t)`, in angles of the force.
fn duffing(force: f64, speed: f64) -> Oscillator<false> {
    Oscillator {
        damping: 0.1 / speed,
        frequency: 1.0 / speed,
        modulation: 0.0,
        cubic: 1.0 / (speed * speed),
        force: force / (speed * speed),
        start: 0.0,
    }
}

const SPEEDS: usize = 201;

fn speed(number: usize) -> f64 {
    0.5 + 2.0 * number as f64 / (SPEEDS - 1) as f64
}

/// Checks that a motion repeats, is stable, and is the one that the start values come to.
#[track_caller]
fn check(scene: &Oscillator<false>, settings: &Settings) -> Orbit {
    let orbit = match solve(scene, TAU, settings) {
        Ok(orbit) => orbit,
        Err(failure) => panic!("{settings:?}, {}: {failure}", scene.frequency),
    };
    let words = format!("{settings:?}, {}", scene.frequency);
    assert!(orbit.residual < 1e3 * settings.rtol * 1e3, "{words}: {:e}", orbit.residual);
    assert!(orbit.multipliers[0].modulus() < 1.0, "{words}");
    assert!(orbit.followed.is_some_and(|count| count > 0), "{words}");
    orbit
}

#[test]
fn an_oscillator_is_found_at_every_speed_of_its_resonance_curve() {
    let settings = Settings::new(Method::Dop853).rtol(1e-8);
    for force in [0.3, 0.5, 1.0] {
        for number in 0..SPEEDS {
            check(&duffing(force, speed(number)), &settings);
        }
    }
}

#[test]
fn every_method_finds_the_same_one_near_the_peak() {
    for number in [60, 90, 100, 110, 120, 150] {
        let scene = duffing(0.5, speed(number));
        let found =
            [Method::Dop853, Method::Tsit5, Method::Radau, Method::Rosenbrock, Method::Auto]
                .map(|method| check(&scene, &Settings::new(method).rtol(1e-9)).start[0]);
        let (low, high) =
            found.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), one| {
                (one.min(low), one.max(high))
            });
        assert!(high - low < 1e-5, "{number}: {found:?}");
    }
}

#[test]
fn the_start_values_pick_one_of_two_motions() {
    let settings = Settings::new(Method::Dop853).rtol(1e-9);
    let scene = duffing(0.5, 1.6);
    let small = check(&scene, &settings);
    let large = check(&Oscillator { start: 1.9, ..scene }, &settings);
    let size = |orbit: &Orbit| orbit.start[0].hypot(orbit.start[1]);
    assert!(size(&large) > 2.0 * size(&small), "{} {}", size(&large), size(&small));
}

#[test]
fn a_motion_of_several_periods_begins_in_a_stated_one() {
    // Parametric resonance: after a period the motion is the opposite one, after two it repeats.
    let of = |start: f64, rtol: f64| {
        let scene = Oscillator {
            damping: 0.02,
            frequency: 0.5,
            modulation: 0.3,
            cubic: 1.0,
            force: 0.0,
            start,
        };
        let settings = Settings::new(Method::Dop853).rtol(rtol);
        check(&scene, &settings)
    };
    let found = [of(0.5, 1e-8), of(-0.5, 1e-10), of(0.7, 1e-9)];
    for orbit in &found {
        assert_eq!(orbit.multiple, 2);
        assert!((orbit.at(TAU)[0] + orbit.start[0]).abs() < 1e-6);
        assert!(orbit.start[0] > 0.0, "{:?}", orbit.start);
        assert!((orbit.start[0] - found[0].start[0]).abs() < 1e-6);
    }
}
