//! Groups whose angles count from each other, and that hold a distance, against the triangle by hand; and an angle that is
//! a length as well.

use assur::prelude::*;

mod by_loops {
    assur::mechanism! {
        Groups from "made up";
        dimension a = 50 mm +- 0.1 mm, b = 150 mm +- 0.1 mm, c = 120 mm +- 0.1 mm, d = 160 mm +- 0.1 mm, l = 200 mm +- 0.1 mm;
        driver phi ~ 90 deg in 0 deg .. 360 deg;
        dependent theta ~ 25 deg, psi ~ 45 deg, s ~ 250 mm;
        let A = a*dir(phi);
        let B = A + b*dir(theta);
        closure loop: B = [d, 0] + c*dir(theta + psi);
        closure rod: inner(B - [s, 0 mm], B - [s, 0 mm]) = l^2;
        output theta, psi, s, B, ratio = diff(psi, phi);
        scene turn { sweep phi; }
    }
}

#[test]
fn a_relative_angle_and_a_distance_are_those_of_the_triangle() {
    let path = by_loops::Turn::default().sweep(0.0..=std::f64::consts::TAU, 73).expect("it turns");
    let column = |name: &str| path.output(name).expect("an output");
    let (theta, psi, s) = (column("theta"), column("psi"), column("s"));
    for ((theta, psi), s) in theta.iter().zip(&psi).zip(&s) {
        let phi = theta.0;
        // From the end of the crank to the pivot of the rocker, and the angles of the triangle over it.
        let (x, y) = (0.16 - 0.05 * phi.cos(), -0.05 * phi.sin());
        let over = x.hypot(y);
        let at = |near: f64, far: f64| {
            ((near * near + over * over - far * far) / (2.0 * near * over)).acos()
        };
        let coupler = y.atan2(x) + at(0.15, 0.12);
        let rocker = y.atan2(x) + std::f64::consts::PI - at(0.12, 0.15);
        assert!((theta.1 - coupler).abs() < 1e-12, "{phi}: {} {coupler}", theta.1);
        assert!((psi.1 - (rocker - coupler)).abs() < 1e-12, "{phi}: {}", psi.1);
        let (bx, by) = (0.16 + 0.12 * rocker.cos(), 0.12 * rocker.sin());
        let slide = bx + (0.04 - by * by).sqrt();
        assert!((s.1 - slide).abs() < 1e-12, "{phi}: {} {slide}", s.1);
    }
}

/// A rack on a pinion, moved by a pin that sits off its middle: the angle stands in a cosine and beside it.
mod pinion {
    assur::mechanism! {
        Pinion from "made up";
        dimension r = 30 mm, e = 10 mm;
        driver x ~ 40 mm in 20 mm .. 60 mm;
        dependent phi ~ 60 deg;
        closure rack: x = r*phi + e*cos(phi);
        output phi;
        scene turn { sweep x; }
    }
}

#[test]
fn an_angle_that_is_a_length_as_well_is_iterated() {
    let path = pinion::Turn::default().sweep(0.02..=0.06, 3).expect("it turns");
    // By mpmath, 25 digits. Solved for the angle beside the cosine alone it would be no number.
    let expected = [0.3540024081653008, 1.2182312549028326, 2.194749278189322];
    for ((_, found), expected) in path.output("phi").expect("an output").iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}
