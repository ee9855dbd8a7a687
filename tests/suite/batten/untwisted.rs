//! The stiffness that the rod force of the motion without twist gives the lag, against that motion itself.

use crate::solved::{Solved, bind, entry};

/// Ends of the bar that are not alike.
const UNEQUAL: [(&str, f64); 2] = [("m4", 12.0), ("d33", 5e-6)];

/// What the scene `first_order` adds to the acceleration of the lag, as a force on the brake-side rod.
fn added_force(angle: f64) -> f64 {
    let lag = 1e-3;
    let state = [lag, 2e-4, -3e-4, 0.1, 0.2, -0.1];
    let (first, paper) = (entry("batten", "first_order"), entry("batten", "elastic"));
    let [with, without] = [first, paper].map(|scene| {
        let run = bind(scene, &UNEQUAL).expect("values that can be");
        let outputs = scene.outputs.iter();
        let place = outputs.map(|it| it.name).position(|name| name == "ddot(phi2)");
        run.outputs(angle / speed(), &state)[place.expect("an output")]
    });
    let (radius, rod, inertia, mass): (f64, f64, f64, f64) = (0.075, 0.271, 0.1004, 28.5);
    let q = radius * radius / (2.0 * rod);
    let slope = radius * angle.sin() - q * (2.0 * angle).sin();
    let bend = radius * angle.cos() - 2.0 * q * (2.0 * angle).cos();
    (without - with) * (inertia + mass * slope * slope) / (bend * lag)
}

/// Of the crank, in radians per second.
fn speed() -> f64 {
    250.0 * crate::solved::RPM
}

#[test]
fn the_first_order_takes_the_force_of_the_motion_without_twist() {
    let untwisted = Solved::with("batten", "bending", &UNEQUAL);
    for angle in [0.3, 1.0, 2.0, 2.9, 4.0, 5.5] {
        let (found, expected) = (added_force(angle), untwisted.at(angle, "F2"));
        assert!(
            (found - expected).abs() < 1e-7 * (1.0 + expected.abs()),
            "{angle}: {found} {expected}"
        );
    }
}
