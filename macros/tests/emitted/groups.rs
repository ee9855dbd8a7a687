//! A linkage for each kind of group, against what a textbook says of it.

use assur::closure::{Assembly, GroupKind, Linkage};
use std::f64::consts::{PI, TAU};

/// Checks over a revolution that the dependent coordinates are those of a closed form, angles up to whole turns, and that
/// the linkage has these groups.
#[track_caller]
fn check<L: Linkage + Default>(kinds: &[GroupKind], expected: impl Fn(f64) -> Vec<f64>) {
    let linkage = L::default();
    let found: Vec<_> = linkage.shape().loops().groups.iter().map(|group| group.kind).collect();
    assert_eq!(found, kinds);
    let mut assembly = Assembly::<L, f64>::new(&linkage);
    assembly.start().expect("it assembles");
    for degree in 0..=360 {
        let theta = (30.0 + f64::from(degree)).to_radians();
        assembly.move_to(&[theta]).expect("it turns");
        for (j, expected) in expected(theta).into_iter().enumerate() {
            let found = assembly.position().as_ref()[j];
            let mut off = (found - expected).abs();
            if linkage.shape().loops().angles[j] {
                off = (off + PI).rem_euclid(TAU) - PI;
            }
            assert!(
                off.abs() < 4e-15,
                "coordinate {j} at {degree} + 30 degrees: {found}, expected {expected}"
            );
        }
    }
}

mod four_bar {
    assur::mechanism! {
        /// A crank drives a rocker.
        FourBar from "any textbook";
        dimension a = 20 mm, b = 70 mm, c = 50 mm, d = 75 mm;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent coupler ~ 30 deg, rocker ~ 90 deg;
        closure loop: a*dir(theta) + b*dir(coupler) = [d, 0] + c*dir(rocker);
        output rocker;
    }
}

/// The diagonal between crank and rocker pivot cuts the quadrilateral into two triangles.
#[test]
fn a_rocker_is_two_triangles_away() {
    check::<four_bar::FourBar>(&[GroupKind::Rrr], |theta| {
        let (a, b, c, d) = (0.020_f64, 0.070_f64, 0.050_f64, 0.075_f64);
        let (x, y) = (a * theta.cos() - d, a * theta.sin());
        let r = x.hypot(y);
        let rocker = y.atan2(x) - ((r * r + c * c - b * b) / (2.0 * r * c)).acos();
        let (u, v) = (c * rocker.cos() - x, c * rocker.sin() - y);
        vec![v.atan2(u), rocker]
    });
}

mod slider_crank {
    assur::mechanism! {
        /// An engine whose cylinder leans and is set aside.
        SliderCrank from "any textbook";
        dimension r = 40 mm, l = 130 mm, e = 10 mm;
        parameter lean = 20 deg;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent rod ~ 20 deg;
        dependent x: m ~ 160 mm;
        closure loop: r*dir(theta) + l*dir(rod) = rot(lean)*[x, e];
        output x;
    }
}

#[test]
fn a_piston_is_a_root_away() {
    check::<slider_crank::SliderCrank>(&[GroupKind::Rrp], |theta| {
        let (r, l, e) = (0.040_f64, 0.130_f64, 0.010_f64);
        let lean = 20.0_f64.to_radians();
        let crank = theta - lean;
        let rod = ((e - r * crank.sin()) / l).asin();
        vec![rod + lean, r * crank.cos() + l * rod.cos()]
    });
}

mod shaper {
    assur::mechanism! {
        /// A crank drives a lever through a block that slides on it, its centre line set off from the pivot.
        Shaper from "any textbook";
        dimension r = 40 mm, d = 100 mm, e = 8 mm;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent lever ~ 50 deg;
        dependent s: m ~ 120 mm;
        closure loop: [0, d] + r*dir(theta) = s*dir(lever) + e*dir(lever + 90 deg);
        output lever;
    }
}

#[test]
fn a_lever_points_to_the_block() {
    check::<shaper::Shaper>(&[GroupKind::Rpr], |theta| {
        let (r, d, e) = (0.040_f64, 0.100_f64, 0.008_f64);
        let (x, y) = (r * theta.cos(), d + r * theta.sin());
        let s = (x * x + y * y - e * e).sqrt();
        vec![y.atan2(x) - (e / s).atan(), s]
    });
}

mod yoke {
    assur::mechanism! {
        /// A crank pin in a slot that leans.
        Yoke from "any textbook";
        dimension r = 40 mm;
        parameter slope = 10 deg, lean = 70 deg;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent x: m ~ 30 mm, y: m ~ 20 mm;
        closure loop: r*dir(theta) = x*dir(slope) + y*dir(lean);
        output x, y;
    }
}

#[test]
fn a_yoke_moves_by_the_sine() {
    check::<yoke::Yoke>(&[GroupKind::Linear], |theta| {
        let (slope, lean) = (10.0_f64.to_radians(), 70.0_f64.to_radians());
        let part = 0.040 / (lean - slope).sin();
        vec![part * (lean - theta).sin(), part * (theta - slope).sin()]
    });
}

mod cam {
    assur::mechanism! {
        /// A rocker with a flat face lies on a round cam whose centre turns about the camshaft.
        FlatRocker from "any textbook";
        dimension eccentricity = 15 mm, radius = 30 mm, d = 120 mm;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent face ~ 170 deg;
        let centre = eccentricity*dir(theta) - [d, 0];
        closure loop: inner(dir(face + 90 deg), centre) = -radius;
        output face;
    }
}

#[test]
fn a_flat_face_touches_its_cam() {
    check::<cam::FlatRocker>(&[GroupKind::Angle], |theta| {
        let (eccentricity, radius, d) = (0.015_f64, 0.030_f64, 0.120_f64);
        let (x, y) = (eccentricity * theta.cos() - d, eccentricity * theta.sin());
        vec![y.atan2(x) + (radius / x.hypot(y)).asin()]
    });
}

/// No group of two links: five unknowns that only close together.
mod triad {
    assur::mechanism! {
        /// A platform on three rocking legs of which one is driven through the crank of another.
        Triad from "made up";
        dimension a = 12 mm;
        driver theta ~ 30 deg in 30 deg .. 390 deg;
        dependent turn ~ 0 deg, first ~ 90 deg, second ~ 90 deg;
        dependent x: m ~ 0 mm, y: m ~ 0 mm;
        point P = [x, y];
        closure left: P + rot(turn)*[-30 mm, 0] = [-30 mm, -80 mm] + 80 mm*dir(first);
        closure right: P + rot(turn)*[30 mm, 0] = [30 mm, -80 mm] + 80 mm*dir(second);
        closure crank: norm(P + rot(turn)*[0, 20 mm] - [90 mm, 20 mm] - a*dir(theta)) = 90 mm;
        output x, y, turn;
    }
}

#[test]
fn a_platform_closes_all_its_loops() {
    use assur::closure::Closure;
    assert_eq!(triad::Triad::shape().loops().groups.len(), 1);
    assert_eq!(triad::Triad::shape().loops().groups[0].kind, GroupKind::General);
    let mut assembly = Assembly::<triad::Triad, f64>::new(&triad::Triad::default());
    assembly.start().expect("it assembles");
    let first = assembly.position().as_ref().to_vec();
    for degree in 0..=360 {
        let theta = (30.0 + f64::from(degree)).to_radians();
        assembly.move_to(&[theta]).expect("it turns");
        let closure = assembly.closure();
        let mut residual = [f64::NAN; 5];
        let instant = closure.instant(&[theta]);
        closure.residual(&instant, assembly.position(), &mut residual);
        let largest = residual.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
        assert!(largest < 1e-16, "{largest:e} m at {degree} + 30 degrees");
    }
    for (last, first) in assembly.position().as_ref().iter().zip(first) {
        assert!((last - first).abs() < 1e-14);
    }
}
