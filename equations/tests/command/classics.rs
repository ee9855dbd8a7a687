//! `assur synth` on problems whose best is known: the examples, as a user would run them.

use serde_json::Value;
use std::f64::consts::LN_2;

use super::{answer, folder};

/// What is found for a scene of an example.
pub fn sought(example: &str, arguments: &[&str]) -> Value {
    let file = format!("{}/../examples/synthesis/{example}.eqn", env!("CARGO_MANIFEST_DIR"));
    let all = [&["synth", file.as_str(), "--format", "json"], arguments].concat();
    let directory = folder(&format!("classics_{example}_{}", arguments[1]));
    serde_json::from_str(&answer(&all, &directory)).expect("one JSON object")
}

pub fn value(list: &Value, index: usize) -> f64 {
    list[index]["value"].as_f64().expect("a number")
}

/// The best design, which holds in all directions but so many, in which it curves upwards.
#[track_caller]
pub fn settled(found: &Value, free: u64) -> Value {
    let best = &found["designs"][0];
    let polish = &best["polish"];
    assert!(polish["settled"] == true && polish["free"] == free, "{best}");
    let curvature = polish["least_curvature"].as_f64();
    assert_eq!(curvature.is_some_and(|one| one > 0.0), free > 0, "{best}");
    best.clone()
}

/// Four errors of equal size with alternating signs hold three lengths, so that none are better (Chebyshev's theorem). Those that
/// have no error at three points with Chebyshev's spacing err by 0.1017 degrees.
#[test]
fn three_lengths_generate_a_function() {
    let found = sought("function_generator", &["--scene", "lengths", "--evaluations", "4000"]);
    let best = settled(&found, 0);
    let [a, b, c] = [0, 1, 2].map(|index| value(&best["values"], index));
    let d = 100.0;
    // By Freudenstein's equation, (d/a - cos φ) cos ψ - sin φ sin ψ = d/c cos φ - (a² - b² + c² + d²)/(2 a c).
    let error = |x: f64| {
        let phi = (26.0 + 60.0 * (x - 1.0)).to_radians();
        let wanted = (305.0 + 90.0 * x.ln() / LN_2).to_radians();
        let (p, q) = (d / a - phi.cos(), -phi.sin());
        let r = d / c * phi.cos() - (a * a - b * b + c * c + d * d) / (2.0 * a * c);
        let side = (r / p.hypot(q)).acos();
        let off = [side, -side].map(|side| {
            let off = q.atan2(p) + side - wanted;
            off.sin().atan2(off.cos()).to_degrees()
        });
        if off[0].abs() < off[1].abs() { off[0] } else { off[1] }
    };
    let errors: Vec<f64> = (0..=10_000).map(|k| error(1.0 + f64::from(k) / 1e4)).collect();
    let largest = errors.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    assert!((largest - value(&best["measures"], 0)).abs() < 1e-7 && largest < 0.1017, "{best}");
    let mut signs: Vec<f64> =
        errors.iter().filter(|one| one.abs() > 0.9999 * largest).copied().collect();
    signs.dedup_by(|a, b| *a * *b > 0.0);
    assert_eq!(signs.len(), 4, "{signs:?}");
}

/// By a simplex method on the exact extremes, from the roots of the polynomial: a flat valley.
#[test]
fn the_cam_law_of_the_least_acceleration() {
    let found = sought("cam_law", &["--scene", "best", "--evaluations", "2000"]);
    let best = settled(&found, 1);
    assert!((value(&best["measures"], 0) - 4.381_904_404_688).abs() < 1e-9, "{best}");
    assert!((value(&best["values"], 0) - 0.336_369).abs() < 1e-6, "{best}");
}

/// By SciPy 1.17 on 20001 positions, which leave 1e-6 N of the peak.
#[test]
fn the_counterweight_of_the_least_shaking_force() {
    let found = sought("counterweight", &["--scene", "best", "--evaluations", "2000"]);
    let best = settled(&found, 0);
    assert!((value(&best["values"], 0) - 32.909_974_8).abs() < 1e-4, "{best}");
    assert!((value(&best["values"], 1) - 180.0).abs() < 1e-4, "{best}");
    assert!((value(&best["measures"], 0) - 190.083_925).abs() < 1e-4, "{best}");
}

/// The rocker that stands still for 60 of 360 degrees: a certified best design after few random ones.
#[test]
fn a_dwell_comes_of_polishing() {
    let effort = ["--scene", "best", "--evaluations", "198", "--searches", "1"];
    let best = settled(&sought("dwell_six_bar", &effort), 0);
    assert_eq!(best["keeps"], true, "{best}");
    assert!(best["worth"].as_f64().is_some_and(|worth| worth < 0.1), "{best}");
}

/// `a + weight max(3 - a, 0)` is least at 0, where the preference is worth less than it costs, else at 3, where it begins to be
/// missed.
#[test]
fn preferences_are_kept_where_that_is_worth_it() {
    let directory = folder("classics_preferences");
    for (weight, expected) in [("0.5", 0.0), ("2", 3.0)] {
        let text = format!(
            "assur::mechanism! {{ Wish from \"made up\"; parameter a = 1 in 0 .. 10; driver t in 0 .. 1; output y = a*t; \
             scene best {{ sweep t; vary a; prefer a > 3 weight {weight}; minimise peak(y); }} }}"
        );
        std::fs::write(directory.join("wish.eqn"), text).expect("the folder is writable");
        let all = ["synth", "wish.eqn", "--format", "json", "--evaluations", "400"];
        let found: Value = serde_json::from_str(&answer(&all, &directory)).expect("one object");
        let best = settled(&found, 0);
        assert!((value(&best["values"], 0) - expected).abs() < 1e-7, "{best}");
        assert_eq!(found["preferred"][0]["weight"].to_string().parse(), weight.parse::<f64>());
    }
}

/// Where errors are balanced their squares have corners, so that steps by squares alone end before.
#[test]
fn squares_of_largest_errors() {
    let directory = folder("classics_squares");
    let text = "assur::mechanism! { Lines from \"made up\"; parameter a = 0 in -2 .. 2, b = 0 in -2 .. 2; driver x in 0 .. 1; \
                output y = a + b*x; \
                scene best { sweep x; vary a, b; minimise peak(abs(x - a))^2 + peak(abs(2*x - b))^2; } }";
    std::fs::write(directory.join("lines.eqn"), text).expect("the folder is writable");
    let all = ["synth", "lines.eqn", "--format", "json", "--evaluations", "400"];
    let found: Value = serde_json::from_str(&answer(&all, &directory)).expect("one object");
    let best = &found["designs"][0];
    for (index, expected) in [0.5, 1.0].into_iter().enumerate() {
        assert!((value(&best["values"], index) - expected).abs() < 1e-7, "{best}");
    }
    assert!((value(&best["measures"], 0) - 1.25).abs() < 1e-7, "{best}");
}

/// No example has a mistake, those either that no other test runs.
#[test]
fn all_examples_are_sound() {
    let examples = format!("{}/../examples/synthesis", env!("CARGO_MANIFEST_DIR"));
    let all = std::fs::read_dir(examples).expect("the folder is there");
    let files: Vec<_> = all.map(|one| one.expect("it can be read").path()).collect();
    assert!(files.len() >= 6, "{files:?}");
    for file in files {
        answer(&["check", file.to_str().expect("UTF-8")], &folder("classics_check"));
    }
}
