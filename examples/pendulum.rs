//! A point mass on a massless rod swings without losses, from a small angle to nearly upside down. The wider it swings
//! the longer it takes; how long, the arithmetic-geometric mean of Gauss tells exactly:
//! `T = 2π √(l/g) / agm(1, cos(φ₀/2))`.
//!
//!     cargo run --example pendulum

use assur::prelude::*;

assur::mechanism! {
    /// A point mass on a massless rod.
    Pendulum from "C. F. Gauss, Bestimmung der Anziehung, 1818";
    dimension l = 0.5 m;
    parameter m = 1 kg, g = 9.81 [m/s^2];
    coordinate phi: rad = 0.1;
    kinetic   m*(l*dot(phi))^2/2;
    potential -m*g*l*cos(phi);
    scene swing "a swing and a half" { run time 0 s .. 2 s; }
}

fn main() {
    println!("  start      period       exact     deviation");
    for degrees in [1.0_f64, 30.0, 90.0, 150.0, 170.0, 179.0] {
        let (period, exact) = (period(degrees.to_radians()), exact(degrees.to_radians()));
        let deviation = period / exact - 1.0;
        println!("{degrees:5} deg {period:10.7} s {exact:10.7} s  {deviation:9.1e}");
        assert!(deviation.abs() < 1e-10);
    }
}

/// The period of the swing from rest at an angle: four times the time to the lowest point.
fn period(angle: f64) -> f64 {
    let settings = Settings::new(Method::Dop853).rtol(1e-13);
    let motion = Swing::default().from([angle, 0.0]).solve(&settings);
    let lowest = motion.unwrap().first_time(Swing::PHI, 0.0);
    4.0 * lowest.expect("it swings through")
}

/// The same by the arithmetic-geometric mean.
fn exact(angle: f64) -> f64 {
    let Swing { l, g, .. } = Swing::default();
    let (mut a, mut b) = (1.0, (angle / 2.0).cos());
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, f64::sqrt(a * b));
    }
    std::f64::consts::TAU * (l / g).sqrt() / a
}
