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

/// Scales some values of `elastic` and checks that its distance from the limit is so many times the flexibility that is
/// left, or somewhat less.
#[track_caller]
fn check(names: &[&'static str], scales: &[f64], limit: &str, distances: [(&str, f64); 2]) {
    let limit = Solved::new("batten", limit);
    let whole = Solved::new("batten", "elastic");
    for scale in scales {
        let changes: Vec<(&str, f64)> =
            names.iter().map(|name| (*name, whole.constant(name) * scale)).collect();
        let stiff = Solved::with("batten", "elastic", &changes);
        let flexibility = scale.min(1.0 / scale);
        for (output, distance) in distances {
            let ratio = difference(&stiff, &limit, output) / flexibility / distance;
            assert!(
                (0.5..1.05).contains(&ratio),
                "{names:?} x {scale:e}, {output}: {ratio} of the distance"
            );
        }
    }
}

#[test]
fn a_stiff_bar_is_a_rigid_bar() {
    let bar = ["d33", "d44", "d34"];
    let distances = [("x3", 6.65e-4), ("phi2", 9.76e-6)];
    check(&bar, &[1e-2, 1e-3, 1e-4], "torsion", distances);
}

#[test]
fn a_stiff_shaft_is_a_rigid_shaft() {
    let distances = [("x3", 8.1e-5), ("phi2", 4e-3)];
    check(&["c"], &[1e1, 1e2, 1e3, 1e4], "bending", distances);
}
