//! What the mechanics says whatever the numbers are: closed forms, symmetry, reciprocity, balance.

use crate::solved::Solved;
use std::f64::consts::{PI, TAU};

/// Scenes that neither lose nor gain energy.
const UNDAMPED: [&str; 9] = [
    "elastic",
    "rigid",
    "torsion",
    "bending",
    "uncoupled",
    "first_order",
    "nonlinear",
    "exact",
    "harmonic",
];

/// Travel of an end of the bar where only the bar bends: `x = R - q/2 - R cos θ/(1 - ω²/P) + (q/2) cos 2θ/(1 - 4ω²/P)`.
pub fn bending_alone(solved: &Solved, angle: f64) -> f64 {
    let value = |name: &str| solved.constant(name);
    let (radius, speed) = (value("R"), value("n"));
    let q = radius * radius / (2.0 * value("l"));
    let p = 1.0 / ((value("d33") + value("d34")) * value("m3"));
    let ratio = speed * speed / p;
    radius - q / 2.0 - radius * angle.cos() / (1.0 - ratio)
        + q / 2.0 * (2.0 * angle).cos() / (1.0 - 4.0 * ratio)
}

#[test]
fn bending_alone_has_the_closed_form() {
    let solved = Solved::new("batten", "bending");
    let mut worst: f64 = 0.0;
    for index in 0..48 {
        let angle = TAU * index as f64 / 48.0;
        for name in ["x3", "x4"] {
            let off = solved.at(angle, name) - bending_alone(&solved, angle);
            worst = worst.max(off.abs());
        }
    }
    assert!(worst < 1e-12, "{worst:e} m");
}

#[test]
fn interpolation_keeps_the_digits_of_the_steps() {
    let solved = Solved::new("batten", "bending");
    let place = solved.place("x3");
    let samples = solved.samples(500);
    let off = |(index, it): (usize, &Vec<f64>)| {
        let angle = TAU * index as f64 / 500.0;
        (it[place] - bending_alone(&solved, angle)).abs()
    };
    let worst = samples.iter().enumerate().map(off).fold(0.0, f64::max);
    assert!(worst < 1e-12, "{worst:e} m");
}

#[test]
fn without_losses_the_lag_is_odd_and_the_bar_even_in_time() {
    for scene in UNDAMPED {
        let solved = Solved::new("batten", scene);
        // The sign of the quantity under reversal of time, and what counts as zero.
        for (name, sign, zero) in [
            ("phi2", -1.0, 1e-12),
            ("dot(phi2)", 1.0, 1e-10),
            ("x3", 1.0, 1e-12),
            ("x4", 1.0, 1e-12),
            ("dot(x3)", -1.0, 1e-10),
            ("dot(x4)", -1.0, 1e-10),
        ] {
            for index in 0..=12 {
                let angle = PI * index as f64 / 12.0;
                let there = solved.at(angle, name);
                let back = solved.at(TAU - angle, name);
                let off = (there - sign * back).abs();
                assert!(off < zero, "{scene}, {name} at {angle}: {off:e}");
            }
        }
    }
}

#[test]
fn multipliers_without_losses_are_reciprocal() {
    for scene in UNDAMPED {
        let multipliers = Solved::new("batten", scene).orbit.multipliers;
        let (mut re, mut im) = (1.0, 0.0);
        for one in &multipliers {
            (re, im) = (re * one.re - im * one.im, re * one.im + im * one.re);
            let square = one.re * one.re + one.im * one.im;
            let partner = (one.re / square, -one.im / square);
            let off = multipliers
                .iter()
                .map(|it| (it.re - partner.0).hypot(it.im - partner.1))
                .fold(f64::INFINITY, f64::min);
            assert!(off < 1e-9, "{scene}: 1/({one}) is missed by {off:e}");
        }
        let off = (re - 1.0).hypot(im);
        assert!(off < 1e-9, "{scene}: the determinant is off by {off:e}");
    }
}

#[test]
fn rod_forces_move_the_masses() {
    for scene in UNDAMPED.into_iter().chain(["damped"]) {
        let solved = Solved::new("batten", scene);
        let masses = ["m1", "m2", "m3", "m4"].map(|name| solved.constant(name));
        let rates = ["ddot(x1)", "ddot(x2)", "ddot(x3)", "ddot(x4)"];
        let rates = rates.map(|name| solved.place(name));
        let (first, second) = (solved.place("F1"), solved.place("F2"));
        let largest = solved.amplitude("F1");
        for outputs in solved.samples(64) {
            let inertia: f64 = masses.iter().zip(rates).map(|(m, it)| m * outputs[it]).sum();
            let off = (outputs[first] + outputs[second] - inertia).abs() / largest;
            assert!(off < 1e-14, "{scene}: {off:e} of the largest force");
        }
    }
}

#[test]
fn without_losses_the_drive_does_no_work() {
    for scene in UNDAMPED {
        let solved = Solved::new("batten", scene);
        let torque = solved.place("drive_torque");
        let share = solved.mean(|it| it[torque]) / solved.amplitude("drive_torque");
        assert!(share.abs() < 1e-10, "{scene}: {share:e} of the largest");
    }
}
