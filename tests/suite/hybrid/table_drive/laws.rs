//! What the mechanics says whatever the numbers are: continuity, energy, momentum, scale.

use super::*;

/// Values for which the table runs up at once, after it has stuck, or not at all; and with which damping.
const VARIANTS: [&[(&str, f64)]; 5] = [
    &[],
    &[("J1", 6.3e-4), ("Mc", 1.0)],
    &[("J1", 6.3e-4), ("J2", 1.15e-3), ("beta", 0.1), ("Mc", 1.0)],
    &[("beta", 1e-3), ("Mc", 16.5), ("J2", 5e-5)],
    &[("beta", 0.01), ("Mc", 18.0)],
];

#[track_caller]
fn check_continuity<C: Drive>(drive: C) {
    let moved = Moved::of(drive, 0.05);
    assert!(!moved.motion.events.is_empty());
    for event in &moved.motion.events {
        for (index, (before, after)) in event.before.iter().zip(&event.after).enumerate() {
            // What is set is a speed that has just passed zero.
            let off = (before - after).abs();
            assert!(off < 1e-9, "{} jumps by {off:e}", moved.drive.shape().states[index].name);
        }
    }
}

#[test]
fn angles_and_speeds_are_continuous() {
    for changes in VARIANTS {
        check_continuity(Table1::with(changes));
        check_continuity(Full::with(changes));
        check_continuity(Balance::with(changes));
        check_continuity(Switched::with(changes));
        check_continuity(Loose::with(changes));
        check_continuity(LooseFull::with(changes));
    }
}

/// At the start of the table its acceleration jumps by what the damping transmits, at the end of the first stage the
/// motor's by the jump of its torque.
#[test]
fn accelerations_jump_by_what_the_torques_do() {
    let moved = Moved::of(Table2::default(), 0.01);
    let event = moved.event("run");
    let jump = moved.output("ddot(phi2)", event.time);
    let expected = moved.drive.beta * event.before[2] / moved.drive.J2;
    assert!((jump / expected - 1.0).abs() < 1e-10, "{jump} {expected}");

    let moved = Moved::of(Full::default(), 0.01);
    let jump = moved.output("ddot(phi2)", moved.event("run").time);
    assert!(jump.abs() < 1e-8, "{jump:e}");

    let moved = Moved::of(Switched::default(), 0.01);
    let event = moved.event("run");
    let side = |name: &str| {
        [(event.from, &event.before), (event.to, &event.after)]
            .map(|(mode, state)| moved.output_of(name, event.time, mode, state))
    };
    let (torque, acceleration) = (side("motor_torque"), side("ddot(phi1)"));
    assert!(torque[1] - torque[0] > 10.0, "{torque:?}");
    let off = moved.drive.J1 * (acceleration[1] - acceleration[0]) - (torque[1] - torque[0]);
    assert!(off.abs() < 1e-12, "{off:e}");
}

/// What the motor has given is in the speeds and in the link, or was taken by damping and resistance; through sticking
/// and slipping too.
#[test]
fn work_is_accounted_for() {
    for changes in VARIANTS {
        let moved = Moved::of(Balance::with(changes), 0.1);
        let Balance { J1, J2, c, .. } = moved.drive;
        let largest = moved.output("W_motor", 0.1);
        for time in moved.times().into_iter().step_by(50) {
            let get = |name: &str| moved.output(name, time);
            let stored = J1 * get("dot(phi1)").powi(2) / 2.0
                + J2 * get("dot(phi2)").powi(2) / 2.0
                + c * get("twist").powi(2) / 2.0;
            let left = get("W_motor") - get("W_damping") - get("W_resistance");
            let off = (stored - left).abs() / largest;
            assert!(off < 1e-11, "{changes:?} at {time} s: {off:e} of the work");
        }
    }
}

#[test]
fn momentum_is_accounted_for() {
    for changes in VARIANTS {
        let moved = Moved::of(Balance::with(changes), 0.1);
        let Balance { J1, J2, omega, .. } = moved.drive;
        for time in moved.times().into_iter().step_by(50) {
            let get = |name: &str| moved.output(name, time);
            let off = J1 * get("dot(phi1)") + J2 * get("dot(phi2)") - get("impulse");
            assert!(off.abs() < 1e-11 * J1 * omega, "{changes:?} at {time} s: {off:e}");
        }
    }
}

/// Inertias, stiffness, damping and torques times one number: the same motion.
#[test]
fn only_ratios_of_inertias_and_torques_matter() {
    let scaled = |factor: f64, changes: &[(&str, f64)]| {
        let mut drive = Switched::with(changes);
        for value in [&mut drive.J1, &mut drive.J2, &mut drive.c, &mut drive.beta] {
            *value *= factor;
        }
        for value in [&mut drive.Mc, &mut drive.Ms, &mut drive.Mst] {
            *value *= factor;
        }
        Moved::of(drive, 0.05)
    };
    for changes in VARIANTS {
        let one = scaled(1.0, changes);
        for factor in [1e-6, 1.0 / 7.0, 3e4] {
            let other = scaled(factor, changes);
            assert_eq!(one.modes(), other.modes());
            for time in [1e-3, 5e-3, 0.02, 0.05] {
                for name in ["phi1", "phi2", "twist", "dot(phi1)", "dot(phi2)"] {
                    let (a, b) = (one.output(name, time), other.output(name, time));
                    assert!((a - b).abs() < 1e-9 * (1e-3 + a.abs()), "{name} at {time} s: {a} {b}");
                }
            }
        }
    }
}

/// In the end the speeds are those at which the motor carries the resistance, and the link is wound by it.
#[test]
fn the_steady_state_carries_the_resistance() {
    for changes in &VARIANTS[..4] {
        let moved = Moved::of(Table1::with(changes), 3.0);
        let Table1 { c, Mc, Ms, omega, .. } = moved.drive;
        let alpha = omega * (1.0 - Mc / Ms);
        for (name, expected) in [
            ("dot(phi1)", alpha),
            ("dot(phi2)", alpha),
            ("twist", Mc / c),
            ("motor_torque", Mc),
            ("link_torque", Mc),
            ("elastic_torque", Mc),
        ] {
            let found = moved.output(name, 3.0);
            assert!((found / expected - 1.0).abs() < 1e-9, "{name}: {found} {expected}");
        }
    }
}
