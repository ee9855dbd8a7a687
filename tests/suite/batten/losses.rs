//! Damping: what the drive puts in goes to the shaft and the bar, unless the description of the crank loses some.

use crate::solved::Solved;
use approx::assert_relative_eq;

/// Mean power that shaft and bar lose, from the speeds.
fn lost(solved: &Solved) -> f64 {
    let value = |name: &str| solved.constant(name);
    let (shaft, bar) = (value("c") * value("beta_t"), value("beta_b"));
    let (d33, d44, d34) = (value("d33"), value("d44"), value("d34"));
    let lambda = value("lambda");
    let speeds = ["dot(x1)", "dot(x2)", "dot(x3)", "dot(x4)", "dot(phi2)"];
    let places = speeds.map(|name| solved.place(name));
    solved.mean(|outputs| {
        let [v1, v2, v3, v4, lag] = places.map(|place| outputs[place]);
        let u3 = v3 - (1.0 + lambda) * v1 + lambda * v2;
        let u4 = v4 - (1.0 + lambda) * v2 + lambda * v1;
        let bent = (d44 * u3 * u3 - 2.0 * d34 * u3 * u4 + d33 * u4 * u4) / (d33 * d44 - d34 * d34);
        shaft * lag * lag + bar * bent
    })
}

/// Mean power of the drive.
fn driven(solved: &Solved) -> f64 {
    let torque = solved.place("drive_torque");
    solved.mean(|outputs| outputs[torque]) * solved.constant("n")
}

#[test]
fn the_drive_covers_the_losses_when_the_lag_enters_as_it_is() {
    let solved = Solved::new("batten", "damped");
    println!("driven {} lost {}", driven(&solved), lost(&solved));
    assert_relative_eq!(driven(&solved), lost(&solved), max_relative = 1e-9);
    assert_relative_eq!(lost(&solved), 0.391_073_488_65, max_relative = 1e-9);
}

#[test]
fn faster_damping_costs_more() {
    let at = |beta: f64| Solved::with("batten", "damped", &[("beta_t", beta), ("beta_b", beta)]);
    let costs = [1e-5, 1e-4, 1e-3].map(|beta| lost(&at(beta)));
    println!("{costs:?}");
    assert!(costs[0] < costs[1] && costs[1] < costs[2], "{costs:?}");
}
