//! Dead points, limit positions and strokes against closed forms and published numbers.

use super::linkages::{FourBar, Heald, SliderCrank};
use crate::closure::{Along, stretch, strokes};
use std::f64::consts::{PI, TAU};

#[test]
fn heald_linkage_lives_on_a_known_stretch() {
    let found = stretch(&Heald::printed(), 0, (-PI, TAU)).expect("it assembles");
    for (end, expected) in [(found.low, -65.330f64), (found.high, 220.223)] {
        assert_eq!(end.dead, Some(0));
        assert!((end.at.to_degrees() - expected).abs() < 6e-4);
    }
}

#[test]
fn straight_guide_ends_where_links_are_in_line() {
    // At φ6 = φ7 = ±acos(s/(l6 - l7)), F and L lie on one line with G, and the height is known.
    let found = stretch(&Heald::guided(), 0, (-PI, PI)).expect("it assembles");
    let ends = [found.low, found.high].map(|end| (end.dead, end.outputs[0]));
    let line = (40.0f64 / 60.0).acos();
    for (dead, output) in ends {
        assert_eq!(dead, Some(0));
        assert!(
            (output.abs() - line).abs() < 1e-9 || (output.abs() - (PI - line)).abs() < 1e-9,
            "{output}"
        );
    }
}

#[test]
fn swing_of_the_selvedge_linkage() {
    let strokes = strokes(&FourBar::default(), Along::Driver(0, (0.0, TAU))).expect("it assembles");
    let rocker = &strokes[1];
    // χ = 180° - θ
    assert!((rocker.length().to_degrees() - 49.58438).abs() < 1e-5);
    assert_eq!(rocker.limits.len(), 2);
    let (l1, l2, l3, a) = (0.025f64, 0.09f64, 0.06f64, 0.1f64);
    // Limit positions: crank and rod in line, rho = l2 ± l1.
    for (extreme, rho, turn) in [(rocker.least, l2 + l1, 0.0), (rocker.greatest, l2 - l1, PI)] {
        let expected = turn + ((rho * rho + a * a - l3 * l3) / (2.0 * rho * a)).acos();
        assert!((extreme.at - expected).abs() < 1e-12, "{} {expected}", extreme.at);
    }
    assert!((rocker.least.at.to_degrees() - 31.43187).abs() < 1e-5);
    assert!((rocker.greatest.at.to_degrees() - 215.18382).abs() < 1e-5);
}

#[test]
fn stroke_of_a_slider() {
    let mut linkage = SliderCrank::default();
    linkage.values[2] = 0.03;
    let along = Along::Driver(0, (0.1, TAU + 0.1));
    let stroke = &strokes(&linkage, along).expect("it assembles")[0];
    let reach = |rho: f64| (rho * rho - 0.0009f64).sqrt();
    let (outer, inner) = (reach(0.346), reach(0.196));
    assert!((stroke.greatest.value - outer).abs() < 1e-15);
    assert!((stroke.least.value - inner).abs() < 1e-15);
    assert!((stroke.length() - (outer - inner)).abs() < 1e-15);
    assert!(
        (stroke.greatest.at - (0.03f64 / 0.346).asin()).abs() < 1e-12 || stroke.greatest.at > TAU
    );
    assert!((stroke.least.at - PI - (0.03f64 / 0.196).asin()).abs() < 1e-12);
}

#[test]
fn stroke_up_to_dead_points() {
    let linkage = FourBar::new([0.08, 0.05, 0.05, 0.1], 0.8, [0.5, 2.0]);
    let strokes = strokes(&linkage, Along::Driver(0, (0.0, 1.5))).expect("it assembles");
    // Rod and rocker in line with the span at the upper end.
    let end = (0.0064f64 / 0.016).acos();
    let expected = (-0.08 * end.sin()).atan2(0.1 - 0.08 * end.cos());
    for stroke in &strokes {
        let at_end = [stroke.least, stroke.greatest]
            .into_iter()
            .find(|extreme| (extreme.at - end).abs() < 1e-12);
        if let Some(extreme) = at_end {
            let value = extreme.value.rem_euclid(PI);
            assert!((value - expected.rem_euclid(PI)).abs() < 1e-11, "{value}");
        }
    }
    let found = stretch(&linkage, 0, (0.0, 1.5)).expect("it assembles");
    assert_eq!(found.high.dead, Some(0));
    for output in found.high.outputs {
        assert!((output.rem_euclid(PI) - expected.rem_euclid(PI)).abs() < 1e-11, "{output}");
    }
}
