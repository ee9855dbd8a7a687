//! Section 4 of the specification: what the paper prints, how it is met, and by how much it is not.

use super::*;

const INCLINATION: f64 = 47.5 * std::f64::consts::PI / 180.0;

/// The speed in a table, in m/s or rpm, and with how many of its digits.
#[track_caller]
fn rounds_to(found: f64, printed: f64, half: f64) {
    assert!((found - printed).abs() <= half, "{found}, printed {printed}");
}

#[test]
fn what_follows_from_the_printed_values() {
    let here = Formula::of("sliding", &[], 1.71);
    rounds_to(here.get("V_star"), 2.0, 1e-12);
    rounds_to(here.get("c_p"), 5.583e4, 5.0);
    let rpm = std::f64::consts::TAU / 60.0;
    rounds_to(here.get("speed") / rpm, 342.87, 0.005);
    rounds_to(Formula::of("sliding", &[], 1.64).get("speed") / rpm, 328.84, 0.005);
    rounds_to(Formula::of("sliding", &[], 1.6383).get("speed") / rpm, 328.5, 0.01);
    rounds_to(here.get("limit"), 1.8327, 5e-5);
    rounds_to(here.get("limit_speed") / rpm, 367.5, 0.05);
}

/// The reconstructed rebound, of four variants.
#[test]
fn reconstructed_rebound() {
    for (scene, expected) in [
        ("graze_cos2", 1.55),
        ("graze_sin2", 1.34),
        ("graze_total", 1.64),
        ("reach_cos2", 1.60),
        ("reach", 1.68),
    ] {
        rounds_to(Formula::of(scene, &[], INCLINATION).get("V_c"), expected, 0.005);
    }
    rounds_to(Formula::of("graze_total", &[], INCLINATION).get("V_c"), 1.639, 5e-4);
    rounds_to(Formula::of("graze", &[], INCLINATION).get("V_c"), 1.663, 5e-4);
}

/// None of the twenty variants meets both published speeds, 1.64 and 1.71 m/s; the closest was picked afterwards.
#[test]
fn no_variant_meets_both_published_speeds() {
    let variants = closed("variants");
    assert_eq!(variants.len(), 20);
    let apart = |one: &Value| {
        let graze = number(&one["graze"]);
        // A first rebound that is faster than 2 m/s at once reaches the cam at its own threshold.
        let reach = if one["reach"].is_null() { graze } else { number(&one["reach"]) };
        (graze / 1.64 - 1.0).abs().max((reach / 1.71 - 1.0).abs())
    };
    let nearest = variants.iter().map(apart).fold(f64::INFINITY, f64::min);
    assert!(nearest > 0.015, "{nearest}");
    // The other reading of the printed stiffness, ten times as much, is excluded.
    let scene = entry("needle_impact", "unselected");
    let rebounds = |speed: f64| {
        let moved = Moved::of("unselected", &[("C", 5.31e5), ("V_c", speed)], 3e-3);
        assert_eq!(scene.name, moved.scene.name);
        let left = moved.event("overrun").before[1];
        left > speed * INCLINATION.tan() * (1.0 + 1e-9)
    };
    assert!(rebounds(1.0) && rebounds(0.6), "far below 1.64 m/s");
}

/// The curve through both points, and how far the rounding of these leaves it open.
#[test]
fn fitted_rebound() {
    let at = |speed: f64, changes: &[(&str, f64)]| {
        Formula::of("struck_fitted", changes, speed).get("V_0")
    };
    rounds_to(at(1.71, &[]), 2.0, 1e-12);
    rounds_to(at(1.64, &[]), 1.64 * INCLINATION.tan(), 1e-12);
    rounds_to(at(1.5, &[]), 1.5 * INCLINATION.tan(), 1e-12);
    let b = |changes: &[(&str, f64)]| {
        let (low, speed) =
            (changes.iter().find(|one| one.0 == "V_r").map_or(1.64, |one| one.1), 1.9);
        let tan2 = INCLINATION.tan().powi(2);
        (at(speed, changes).powi(2) - speed * speed * tan2) / ((speed * speed - low * low) * tan2)
    };
    rounds_to(b(&[]), 1.853, 5e-4);
    let ends = [
        b(&[("V_r", 1.635), ("V_i", 1.715)]),
        b(&[("V_r", 1.645), ("V_i", 1.705)]),
        b(&[("V_r", 1.645), ("V_i", 1.715)]),
        b(&[("V_r", 1.635), ("V_i", 1.705)]),
    ];
    let least = ends.into_iter().fold(f64::INFINITY, f64::min);
    let most = ends.into_iter().fold(0.0, f64::max);
    assert!(least < 1.64 && most > 1.96, "{ends:?}");
}

/// Eq (12) begins with the butt `P_C/c_p` above the cam: it says too little, and where the impact is small a pull.
#[test]
fn formula_12_underestimates() {
    let both = |speed: f64| {
        let changes = [("V_given", speed), ("Delta", 0.0)];
        (Formula::blow("blow", &changes), Formula::blow("blow_paper", &changes))
    };
    let mut speed = 0.01;
    while speed < 20.0 {
        let (exact, paper) = both(speed);
        assert!(paper < exact && exact > 0.0, "{speed}: {paper} {exact}");
        assert_eq!(paper < 0.0, speed < 0.908, "{speed}: {paper}");
        speed *= 1.05;
    }
    let (exact, paper) = both(0.908);
    assert!(paper.abs() < 2e-3 && exact > 2.0, "{paper} {exact}");
    // Without damping: V sqrt(m c) - P against sqrt(P^2 + V^2 m c) - P.
    for speed in [0.1, 1.0, 5.0] {
        let changes = [("V_given", speed), ("Delta", 0.0), ("h_p", 0.0)];
        let c = 1.0 / (1.0 / 2.04e6 + 1.0 / 5.74e4);
        let blow = speed * (0.6e-3_f64 * c).sqrt();
        check("paper", Formula::blow("blow_paper", &changes), blow - 4.8, 1e-12);
        check(
            "exact",
            Formula::blow("blow", &changes),
            blow * blow / (blow.hypot(4.8) + 4.8),
            1e-12,
        );
    }
}

/// The log decrement over the undamped period, as the paper has it, against that over the damped one: a second-order
/// difference.
#[test]
fn both_decrements_agree_to_first_order() {
    let c: f64 = 1.0 / (1.0 / 2.04e6 + 1.0 / 5.74e4);
    let w = (c / 0.6e-3).sqrt();
    for h in [50.0, 565.1] {
        let d = std::f64::consts::TAU * h / w;
        let by_paper = w * (1.0 - (h / w).powi(2)).sqrt();
        let by_damped = w / (1.0 + (d / std::f64::consts::TAU).powi(2)).sqrt();
        let apart = (by_paper / by_damped - 1.0).abs();
        assert!(apart < (h / w).powi(4), "{apart:e}");
    }
}
