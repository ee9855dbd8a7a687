//! Branches on quantities: stops, friction, clearances.

use super::{check, outputs, rate};

assur::mechanism! {
    /// A mass between two springs with clearance, on a rough table.
    Stops from "made up";
    parameter m = 2 kg, k = 300 [N/m], gap = 0.1 m, mu = 0.2, g = 10 [m/s^2];
    coordinate x: m = 0;
    let right = if x > gap { k*(x - gap) } else { 0 N };
    let left = max(-gap - x, 0 m)*k;
    let friction = mu*m*g*sign(dot(x));
    motion slide: m*ddot(x) = left - right - friction;
    output right [N], left [N], distance = min(abs(x), gap);
}

#[test]
fn each_branch_has_its_force() {
    check(&rate::<Stops>(0.0, &[0.05, 1.0]), &[1.0, -2.0]);
    check(&rate::<Stops>(0.0, &[0.15, -1.0]), &[-1.0, 2.0 - 7.5]);
    check(&rate::<Stops>(0.0, &[-0.2, 0.5]), &[0.5, 15.0 - 2.0]);
}

#[test]
fn outputs_follow_the_branch() {
    check(&outputs::<Stops>(0.0, &[0.15, 0.0]), &[15.0, 0.0, 0.1]);
    check(&outputs::<Stops>(0.0, &[-0.05, 0.0]), &[0.0, 0.0, 0.05]);
    check(&outputs::<Stops>(0.0, &[-0.2, 0.0]), &[0.0, 30.0, 0.1]);
}
