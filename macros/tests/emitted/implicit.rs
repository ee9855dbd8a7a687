//! Equations of motion in which two accelerations stand on both sides.

use super::{check, rate};

assur::mechanism! {
    /// A cart with a pendulum, as the equations are written in books.
    Cart from "any textbook";
    parameter M = 3 kg, m = 1 kg, l = 0.5 m, g = 9.81 [m/s^2];
    coordinate x: m = 0, phi: rad = 0.1;
    motion cart: (M + m)*ddot(x) + m*l*ddot(phi)*cos(phi) = m*l*dot(phi)^2*sin(phi);
    motion pendulum: l*ddot(phi) = -ddot(x)*cos(phi) - g*sin(phi);
}

#[test]
fn both_equations_hold() {
    let (phi, speed) = (0.7_f64, 1.5_f64);
    let rate = rate::<Cart>(0.0, &[0.2, phi, -0.3, speed]);
    let (x2, phi2) = (rate[2], rate[3]);
    let (sine, cosine) = phi.sin_cos();
    let left = 4.0 * x2 + 0.5 * phi2 * cosine;
    check(&[left], &[0.5 * speed * speed * sine]);
    check(&[0.5 * phi2], &[-x2 * cosine - 9.81 * sine]);
}
