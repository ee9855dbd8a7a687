//! The same machine in other units moves in the same way.

use crate::solved::FINE;
use approx::assert_relative_eq;
use assur::answer::Settings;
use assur::ode;
use assur::problem::{Scene, Smooth};

/// In metres, kilograms and seconds.
mod large {
    assur::mechanism! {
        /// A rod that swings about one end, with friction.
        Pendulum from "any textbook";
        dimension l = 0.25 m;
        parameter m = 0.3 kg, g = 9.81 [m/s^2], b = 2e-3 [kg m^2/s];
        coordinate phi: rad = 2;
        kinetic     m*(l*dot(phi))^2/6;
        potential   m*g*l*(1 - cos(phi))/2;
        dissipation b*dot(phi)^2/2;
        output force = m*g*cos(phi) [N];
        scene swing "some swings" { run time 0 s .. 5 s; }
    }
}

/// In millimetres, grams and milliseconds.
mod small {
    assur::mechanism! {
        /// A rod that swings about one end, with friction.
        Pendulum from "any textbook";
        dimension l = 250 mm;
        parameter m = 300 g, g = 9.81e-3 [mm/ms^2], b = 2 [g mm^2/us];
        coordinate phi: rad = 2;
        kinetic     m*(l*dot(phi))^2/6;
        potential   m*g*l*(1 - cos(phi))/2;
        dissipation b*dot(phi)^2/2;
        output force = m*g*cos(phi) [mN];
        scene swing "some swings" { run time 0 ms .. 5000 ms; }
    }
}

/// The angle at equal parts of the task, with the unit of time as a factor.
fn angles<C: Smooth>(scene: &C, seconds: f64, settings: &Settings) -> Vec<f64> {
    let motion = ode::march(scene, (0.0, 5.0 * seconds), &scene.start(), settings).unwrap();
    (0..=50).map(|index| motion.at(0.1 * seconds * f64::from(index))[0]).collect()
}

#[track_caller]
fn check(angles: &[f64], expected: &[f64]) {
    for (index, (angle, expected)) in angles.iter().zip(expected).enumerate() {
        let off = (angle - expected).abs();
        assert!(off < 1e-10, "at {index} tenths of a second: off by {off:e}");
    }
}

#[test]
fn units_in_the_file_do_not_change_the_motion() {
    let (large, small) = (large::Swing::default(), small::Swing::default());
    for (small, large) in small.values().into_iter().zip(large.values()) {
        // 9.81e-3 is no binary fraction: the literal itself is rounded.
        assert_relative_eq!(small, large, max_relative = f64::EPSILON);
    }
    assert_eq!(large.span(), small.span());
    check(&angles(&small, 1.0, &FINE), &angles(&large, 1.0, &FINE));
}

#[test]
fn numbers_of_a_millimetre_gram_millisecond_world_give_the_same_motion() {
    let large = large::Swing::default();
    let numbers = large::Swing { l: 250.0, m: 300.0, g: 9.81e-3, b: 2e-3 * 1e6 };
    check(&angles(&numbers, 1e3, &FINE), &angles(&large, 1.0, &FINE));
}
