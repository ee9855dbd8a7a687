//! Published positions.

use super::linkages::{FourBar, Heald, SixBar, SliderCrank};
use crate::closure::{Assembly, Closure, Linkage};
use crate::scalar::Fused;

/// A linkage put together at its start.
pub fn started<L: Linkage>(linkage: &L) -> Assembly<L, f64> {
    let mut assembly = Assembly::new(linkage);
    assembly.start().expect("the linkage assembles");
    assembly
}

/// First output in degrees after a move.
fn degrees<L: Linkage>(assembly: &mut Assembly<L, f64>, at: f64) -> f64 {
    assembly.move_to(&[at.to_radians()]).expect("the mode goes on");
    let mut values = vec![0.0; assembly.closure().shape().outputs.len()];
    assembly.outputs(&mut values);
    values[0].to_degrees()
}

/// Largest residual of an assembled linkage.
pub fn residual<L: Linkage>(assembly: &Assembly<L, f64>) -> f64 {
    let mut values = vec![0.0; assembly.coordinates().len()];
    let instant = assembly.closure().instant(assembly.independents());
    assembly.closure().residual(&instant, assembly.position(), &mut values);
    values.into_iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[test]
fn heald_linkage_as_printed() {
    let mut assembly = started(&Heald::printed());
    let start = assembly.position()[..3].to_vec();
    for (found, expected) in start.into_iter().zip([9.50421, 63.28431, -70.06145]) {
        assert!((found.to_degrees() - expected).abs() < 5e-6);
    }
    for (at, expected) in [(60.0, -58.60509), (90.0, -70.06145), (120.0, -81.96186)] {
        assert!((degrees(&mut assembly, at) - expected).abs() < 5e-6);
        assert!(residual(&assembly) < 1e-16);
    }
}

#[test]
fn heald_linkage_with_a_straight_guide() {
    let assembly = started(&Heald::guided());
    for (found, expected) in assembly.position().iter().zip([50.91779, 40.65752, -36.42903]) {
        assert!((found.to_degrees() - expected).abs() < 5e-6);
    }
}

#[test]
fn selvedge_linkage() {
    let mut assembly = started(&FourBar::default());
    // χ = 180° - θ
    for (at, chi) in [(90.0, 74.35483), (215.18382, 38.62483), (31.43187, 88.20922)] {
        degrees(&mut assembly, at);
        assert!((180.0 - assembly.position()[1].to_degrees() - chi).abs() < 1e-5, "{at}");
    }
    assert!((degrees(&mut assembly, 90.0) - 21.35768).abs() < 5e-6);
}

#[test]
fn slider_crank_is_its_closed_form() {
    let mut assembly = started(&SliderCrank::default());
    for k in 0..=72 {
        let at = f64::from(k).to_radians() * 5.0 + 0.5;
        assembly.move_to(&[at]).expect("the crank turns");
        let expected = 0.075 * at.cos() + (0.271f64.powi(2) - (0.075 * at.sin()).powi(2)).sqrt();
        assert!((assembly.position()[1] - expected).abs() < 1e-15);
    }
}

#[test]
fn six_bar_closes_all_the_way_on_any_scalar() {
    let mut plain = started(&SixBar::default());
    let mut fused = Assembly::<SixBar, Fused>::new(&SixBar::default());
    fused.start().expect("the linkage assembles");
    for k in 0..=720 {
        let at = f64::from(k).to_radians();
        plain.move_to(&[at]).expect("the crank turns");
        fused.move_to(&[Fused(at)]).expect("the crank turns");
        assert!(residual(&plain) < 2e-16);
        for (a, b) in plain.position().iter().zip(fused.position()) {
            assert!((a - b.0).abs() < 1e-14);
        }
    }
}
