//! Every scene against `tests/reference/batten.json`, which another program in another language has computed.

use crate::solved::{RPM, Solved};
use serde_json::Value;
use std::sync::LazyLock;

/// The angle of the crank at the start of the blow into the locks.
const LOCKS: f64 = 1.9198;

/// Names there, names here, and the part of the error that does not shrink with the value: rounding of what it is
/// computed from.
const QUANTITIES: [(&str, &str, f64); 15] = [
    ("phi2", "phi2", 1e-13),
    ("dphi2", "dot(phi2)", 1e-11),
    ("ddphi2", "ddot(phi2)", 1e-8),
    ("x3", "x3", 1e-14),
    ("dx3", "dot(x3)", 1e-12),
    ("ddx3", "ddot(x3)", 1e-10),
    ("x4", "x4", 1e-14),
    ("dx4", "dot(x4)", 1e-12),
    ("ddx4", "ddot(x4)", 1e-10),
    ("w3", "w3", 1e-14),
    ("w4", "w4", 1e-14),
    ("F1", "F1", 1e-9),
    ("F2", "F2", 1e-9),
    ("M1", "drive_torque", 1e-9),
    ("shaft", "shaft_torque", 1e-9),
];

static REFERENCE: LazyLock<Value> =
    LazyLock::new(|| serde_json::from_str(include_str!("../../reference/batten.json")).unwrap());

/// A quantity of a solved scene at an angle; deflections as what they are, `x - x1`, where they are no states.
fn computed(solved: &Solved, angle: f64, name: &str) -> Option<f64> {
    let time = solved.time_at(angle);
    let state = match solved.orbit.start.is_empty() {
        true => Vec::new(),
        false => {
            let start = &solved.orbit.start;
            let motion = solved.run.march((0.0, time), start, &crate::solved::FINE);
            motion.unwrap().end().to_vec()
        }
    };
    let named = |quantities: &[assur::shape::Quantity], values: &[f64]| {
        let place = quantities.iter().position(|it| it.name == name)?;
        Some(values[place])
    };
    named(solved.entry.states, &state)
        .or_else(|| named(solved.entry.outputs, &solved.run.outputs(time, &state)))
}

#[track_caller]
fn check_state(solved: &Solved, case: &str, place: &str, angle: f64) {
    let expected = &REFERENCE[case][place];
    let mut compared = 0;
    for (key, name, rounding) in QUANTITIES {
        let (Some(expected), Some(found)) = (expected[key].as_f64(), computed(solved, angle, name))
        else {
            continue;
        };
        compared += 1;
        let off = (found - expected).abs();
        assert!(
            off <= 1e-10 * expected.abs() + rounding,
            "{case}, {place}, {name}: {found:e}, expected {expected:e}, off by {off:e}"
        );
    }
    assert!(compared >= 9, "{case}: only {compared} quantities");
}

#[track_caller]
fn check_multipliers(solved: &Solved, case: &str, tolerance: f64) {
    let Some(expected) = REFERENCE[case]["multipliers"].as_array() else {
        assert!(solved.orbit.multipliers.is_empty());
        return;
    };
    let mut left = solved.orbit.multipliers.clone();
    assert_eq!(left.len(), expected.len());
    for pair in expected {
        let (re, im) = (pair[0].as_f64().unwrap(), pair[1].as_f64().unwrap());
        let distance = |it: &assur::periodic::Multiplier| (it.re - re).hypot(it.im - im);
        let nearest = (0..left.len())
            .min_by(|a, b| distance(&left[*a]).total_cmp(&distance(&left[*b])))
            .unwrap();
        let off = distance(&left.swap_remove(nearest));
        assert!(off <= tolerance, "{case}: {re}{im:+}i is off by {off:e}");
    }
}

#[track_caller]
fn check(case: &str, solved: &Solved) {
    check_state(solved, case, "start", 0.0);
    if REFERENCE[case]["at_1.9198"].is_object() {
        check_state(solved, case, "at_1.9198", LOCKS);
    }
    check_multipliers(solved, case, 1e-10);
}

/// The cases of the reference and the scenes that they are.
const SCENES: [(&str, &str, &str); 11] = [
    ("elastic", "batten", "elastic"),
    ("rigid", "batten", "rigid"),
    ("torsion_only", "batten", "torsion"),
    ("bending_only", "batten", "bending"),
    ("uncoupled", "batten", "uncoupled"),
    ("nonlinear", "batten", "nonlinear"),
    ("exact", "batten", "exact"),
    ("harmonic", "batten", "harmonic"),
    ("damped", "batten", "damped"),
    ("table_T207", "batten_table", "table"),
    ("table_T217.5", "batten_table", "identity"),
];

#[test]
fn scenes_agree_with_the_reference() {
    for (case, mechanism, scene) in SCENES {
        check(case, &Solved::new(mechanism, scene));
    }
}

#[test]
fn other_speeds_agree_with_the_reference() {
    for speed in [248.0, 249.0, 251.0, 300.0] {
        let solved = Solved::with("batten", "elastic", &[("n", speed * RPM)]);
        check(&format!("elastic_n{speed}"), &solved);
    }
}

#[test]
fn amplitudes_agree_with_the_reference() {
    for (case, mechanism, scene) in SCENES {
        let solved = Solved::new(mechanism, scene);
        for (key, name, _) in &QUANTITIES[..3] {
            let Some(expected) = REFERENCE[case]["amplitudes"][key].as_f64() else {
                continue;
            };
            let found = solved.amplitude(name);
            // Samples miss the top by at most half of their distance squared times the curvature.
            assert!(
                (found / expected - 1.0).abs() < 1e-4,
                "{case}, {name}: {found:e}, expected {expected:e}"
            );
        }
    }
}

#[test]
fn deflections_agree_with_thirty_digits() {
    let solved = Solved::new("batten", "elastic");
    let reference = &REFERENCE["elastic"]["mpmath_30_digits"];
    for (place, angle) in [("start", 0.0), ("at_1.9198", LOCKS)] {
        for (key, name, allowed) in [
            ("w3", "w3", 1e-12),
            ("w4", "w4", 1e-12),
            ("dw3", "dot(w3)", 1e-10),
            ("dw4", "dot(w4)", 1e-10),
            ("phi2", "phi2", 1e-12),
            ("dphi2", "dot(phi2)", 1e-10),
        ] {
            let expected: f64 = reference[place][key].as_str().unwrap().parse().unwrap();
            let off = (computed(&solved, angle, name).unwrap() - expected).abs();
            assert!(off <= allowed, "{place}, {name} is off by {off:e}");
        }
    }
}

#[test]
fn expectations_of_all_scenes_hold() {
    let mut facts = 0;
    for mechanism in assur_equations::REGISTRY {
        for scene in mechanism.scenes {
            for index in 0..scene.expectations.len() {
                assur::check::fact(mechanism, scene.name, index).unwrap();
                facts += 1;
            }
        }
    }
    assert!(facts >= 24, "{facts}");
}
