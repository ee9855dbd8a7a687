//! A four-bar: a crank turns, a rod swings a rocker. Where does the rocker turn round, how far does it swing, and how
//! well is it driven on the way? Its limit positions lie where crank and rod are in line, its transmission angle is
//! least or greatest where the crank lies on the line of centres: both follow from triangles.
//!
//!     cargo run --example linkage

use assur::closure::{Along, Assembly, AtDeadPoint, Axis, ClosureError, strokes, sweep};
use std::f64::consts::{PI, TAU};

assur::mechanism! {
    /// Crank, rod and rocker on a line of centres.
    FourBar from "any textbook";
    dimension crank = 40 mm, rod = 120 mm, rocker = 80 mm, centres = 110 mm;
    driver beta ~ 90 deg in 0 deg .. 360 deg;
    dependent gamma ~ 20 deg, theta ~ 90 deg;
    closure loop: crank*dir(beta) + rod*dir(gamma) = [centres, 0] + rocker*dir(theta);
    output theta, mu = abs(asin(sin(theta - gamma)));
    scene turn;
}

/// The outputs, in their order.
const THETA: usize = 0;
const MU: usize = 1;

fn main() -> Result<(), ClosureError> {
    let four_bar = Turn::default();
    let revolution = Axis { from: 0.0, to: TAU, count: 13 };
    let positions = sweep(&four_bar, &[revolution], AtDeadPoint::Stop)?;
    println!("  crank     rocker  transmission angle");
    for index in 0..positions.len() {
        let (at, outputs) = (positions.independents(index), positions.outputs(index));
        let [crank, rocker, angle] = [at[0], outputs[THETA], outputs[MU]].map(f64::to_degrees);
        println!("{crank:5.0}° {rocker:9.4}° {angle:9.4}°");
    }

    let strokes = strokes(&four_bar, Along::Driver(0, (0.0, TAU)))?;
    let rocker = &strokes[THETA];
    println!("\n  limit positions         crank     rocker      exact");
    let Turn { crank, rod, .. } = four_bar;
    for (name, found, distance) in
        [("folded", rocker.greatest, rod - crank), ("stretched", rocker.least, rod + crank)]
    {
        let exact = rocker_at(&four_bar, distance);
        let [at, value, expected] = [found.at, found.value, exact].map(f64::to_degrees);
        println!("  {name:20} {at:8.4}° {value:9.4}° {expected:9.4}°");
        assert!((found.value - exact).abs() < 1e-12);
    }
    println!("  it swings {:.4}°", rocker.length().to_degrees());

    println!("\n  on the line of centres  crank  transmission      exact");
    let mut assembly = Assembly::<Turn, f64>::new(&four_bar);
    assembly.start()?;
    for (name, at) in [("inside", 0.0), ("outside", PI)] {
        assembly.travel(&[at])?;
        let mut outputs = [0.0; 2];
        assembly.outputs(&mut outputs);
        let exact = transmission_at(&four_bar, at);
        let [at, value, expected] = [at, outputs[MU], exact].map(f64::to_degrees);
        println!("  {name:20} {at:8.0}° {value:12.4}° {expected:9.4}°");
        assert!((outputs[MU] - exact).abs() < 1e-12);
    }
    Ok(())
}

/// The angle of the rocker whose pin is so far from the pivot of the crank.
fn rocker_at(four_bar: &Turn, distance: f64) -> f64 {
    let (c, d) = (four_bar.rocker, four_bar.centres);
    ((distance * distance - c * c - d * d) / (2.0 * c * d)).acos()
}

/// The acute angle between rod and rocker.
fn transmission_at(four_bar: &Turn, crank: f64) -> f64 {
    let (a, b, c, d) = (four_bar.crank, four_bar.rod, four_bar.rocker, four_bar.centres);
    let diagonal = a * a + d * d - 2.0 * a * d * crank.cos();
    ((b * b + c * c - diagonal) / (2.0 * b * c)).abs().acos()
}
