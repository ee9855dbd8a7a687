//! Energies give the equations; the generated tests of this module check them as well.

use super::{check, names, rate_of};
use assur::problem::{Phase, Reports, Scene, Span};

assur::mechanism! {
    /// A point mass on a massless rod.
    Pendulum from "any textbook";
    dimension l = 1 m;
    parameter m = 2 kg, g = 9.81 [m/s^2];
    coordinate phi: rad = 0.1;
    kinetic   m*(l*dot(phi))^2/2;
    potential -m*g*l*cos(phi);
    scene swing "two swings or so" { run time 0 s .. 4 s; }
}

#[test]
fn the_pendulum_swings() {
    let pendulum = Swing { l: 0.5, ..Swing::default() };
    let rate = rate_of(&pendulum, 0.0, &[0.1, 0.25]);
    check(&rate, &[0.25, -9.81 / 0.5 * 0.1_f64.sin()]);
    let equations = pendulum.prepare::<f64>();
    let energy = equations.energy(Phase::of(0), 0.0, &[0.1, 0.25]).unwrap();
    check(&[energy.0, energy.1], &[0.25 * 0.25 * 0.25, -2.0 * 9.81 * 0.5 * 0.1_f64.cos()]);
}

#[test]
fn the_scene_is_described() {
    assert_eq!(Pendulum::default().span(), Span::Run(0.0, 4.0));
    assert_eq!(names::<Swing>(), ["phi", "dot(phi)"]);
    assert_eq!(Swing::default().start(), [0.1, 0.0]);
    assert_eq!(MECHANISM.name, "pendulum");
    assert_eq!(MECHANISM.scenes[0].name, "swing");
}
