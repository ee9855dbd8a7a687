//! Section 3 of the specification, where it has closed forms.

use super::*;

#[test]
fn thresholds_of_a_needle_that_slides() {
    let here = Formula::of("sliding", &[], 1.71);
    for (name, key) in
        [("V_star", "V_star"), ("c_p", "c_p"), ("limit", "limit"), ("limit_speed", "limit_speed")]
    {
        check(name, here.get(name), number(&REFERENCE["closed"][key]), 1e-14);
    }
}

/// Speeds, forces and wear of a needle that slides, with all variants of the force.
#[test]
fn needles_that_slide() {
    for one in closed("sliding") {
        let at = number(&one["V_c"]);
        let here = Formula::of("sliding", &[], at);
        for name in ["speed", "V_0", "V_tau", "F", "gap_needed"] {
            check(name, here.get(name), number(&one[name]), 1e-13);
        }
        let reached = number(&one["V_tau"]) > 0.0;
        check("damage", here.get("damage_cam"), number(&one["damage_cam"]), 1e-12);
        let other = |scene: &str| Formula::of(scene, &[], at);
        check("total", other("sliding_total").get("F"), number(&one["F_total"]), 1e-13);
        check("plain", other("sliding_plain").get("F"), number(&one["F_plain"]), 1e-13);
        check("used", other("sliding_plain").get("used"), number(&one["used_plain"]), 1e-12);
        if reached {
            check("eq (12)", other("sliding_paper").get("F"), number(&one["F_paper"]), 1e-13);
            check("stress", here.get("stress_cam"), number(&one["stress_cam"]), 1e-13);
        }
    }
}

/// Impacts of speeds over six powers of ten, from no damping over critical damping to ten times as much.
#[test]
fn blows_of_every_damping() {
    for one in closed("blows") {
        let changes = changes(&one["values"]);
        for (scene, key) in [("blow", "exact"), ("blow_total", "total"), ("blow_paper", "paper")] {
            // Near critical damping eq (12) takes a time of pi/0, and its digits are those of the root in it.
            let h = changes.iter().find(|one| one.0 == "h_p").unwrap().1;
            let has_none = key == "paper" && h > 9000.0;
            if !one[key].is_null() && !has_none {
                let what = format!("{scene} {changes:?}");
                check(&what, Formula::blow(scene, &changes), number(&one[key]), 1e-12);
            }
        }
    }
}

/// The time at which the needle leaves the wedge is the root of an equation, found along the speed of the cylinder.
#[test]
fn needles_that_rebound() {
    for one in closed("struck") {
        let here = Formula::of("struck", &[], number(&one["V_c"]));
        // Near the first rebound the time of it, a double root, has half of the digits less.
        let near = number(&one["V_c"]) < 1.669;
        for name in ["t_leave", "V_0", "V_tau", "F", "F_wedge", "stress_wedge", "stress_cam"] {
            let expected = number(&one[name]);
            check(name, here.get(name), expected, if near { 1e-10 } else { 1e-12 });
        }
        for name in ["damage_wedge", "damage_cam", "used"] {
            check(name, here.get(name), number(&one[name]), 1e-11);
        }
    }
}

/// The speeds at which a needle begins to rebound and to strike the limiting cam, over the inclination of the wedge.
#[test]
fn thresholds_of_a_needle_that_rebounds() {
    for one in closed("over_inclination") {
        for (scene, key) in [
            ("graze", "graze"),
            ("graze_total", "total"),
            ("graze_cos2", "cos2"),
            ("reach", "reach"),
            ("reach_cos2", "reach_cos2"),
        ] {
            let here = Formula::of(scene, &[], number(&one["alpha"]));
            let what = format!("{scene} at {}", one["alpha"]);
            check(&what, here.get("V_c"), number(&one[key]), 1e-11);
            if scene.starts_with("graze") {
                // The first rebound is proportional to the friction: so the influence is their ratio.
                check(&what, here.get("by_friction"), number(&one[key]) / 4.8, 1e-9);
            }
        }
    }
}

/// A wedge of any factor.
#[test]
fn thresholds_of_the_variants_that_are_scenes() {
    for one in closed("variants") {
        let whole = one["whole"].as_bool().unwrap();
        let scene = match (one["factor"].as_str().unwrap(), one["begin"].as_str().unwrap()) {
            ("sincos", "stuck") if whole => "graze_total",
            ("sincos", "stuck") => "graze",
            ("cos2", "free") if !whole => "graze_cos2",
            ("sin2", "free") if !whole => "graze_sin2",
            ("cot2", "free") if !whole => "graze_cot2",
            ("one", "free") if !whole => "graze_one",
            _ => continue,
        };
        let here = Formula::of(scene, &[], 47.5_f64.to_radians());
        check(scene, here.get("V_c"), number(&one["graze"]), 1e-11);
        check(scene, here.get("t_leave"), number(&one["t_graze"]), 1e-7);
    }
}
