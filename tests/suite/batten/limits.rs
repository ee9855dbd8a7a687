//! What a scene becomes as a stiffness grows is the scene without that effect.

use crate::solved::Solved;
use std::f64::consts::TAU;

/// Largest difference of an output of two scenes over the period.
fn difference(first: &Solved, second: &Solved, name: &str) -> f64 {
    let (a, b) = (first.place(name), second.place(name));
    (0..24)
        .map(|index| first.time_at(TAU * index as f64 / 24.0))
        .map(|time| (first.outputs(time)[a] - second.outputs(time)[b]).abs())
        .fold(0.0, f64::max)
}

/// Scales some values of `elastic` more and more and checks that the difference from the limit falls with the scale.
#[track_caller]
fn check(names: &[&str], scales: &[f64], limit: &str, output: &str, per_scale: f64) {
    let limit = Solved::new("batten", limit);
    let whole = Solved::new("batten", "elastic");
    for scale in scales {
        let change = |name: &&'static str| (*name, whole.constant(name) * scale);
        let changes: Vec<(&str, f64)> = names.iter().map(|it| change(&leak(it))).collect();
        let stiff = Solved::with("batten", "elastic", &changes);
        let softness = if *scale < 1.0 { *scale } else { 1.0 / scale };
        let off = difference(&stiff, &limit, output);
        println!(
            "{names:?} x {scale:e}: {output} off {off:e}, per scale {:e}",
            off / softness
        );
        assert!(
            off <= per_scale * softness,
            "{names:?} x {scale:e}: {off:e}"
        );
    }
}
fn leak(s: &str) -> &'static str {
    Box::leak(s.to_string().into_boxed_str())
}

const BAR: [&str; 3] = ["d33", "d44", "d34"];

#[test]
fn a_stiff_bar_is_a_rigid_bar() {
    let scales = [1e-1, 1e-2, 1e-3, 1e-4];
    check(&BAR, &scales, "torsion", "x3", 1e-3);
    check(&BAR, &scales, "torsion", "phi2", 1e-2);
}

#[test]
fn a_stiff_shaft_is_a_rigid_shaft() {
    let scales = [1e1, 1e2, 1e3, 1e4];
    check(&["c"], &scales, "bending", "x3", 1e-2);
    check(&["c"], &scales, "bending", "phi2", 1e-1);
}
