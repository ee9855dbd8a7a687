//! The influence coefficients of the heald linkage as the paper prints them: which of them are right, and what the wrong
//! ones would say.
//!
//! V. G. Butkevich and others, equations (5) and (8) to (19); the corrections are in the comments of each test.

use crate::solved::{entry, values};
use assur::closure::Sample;
use std::f64::consts::FRAC_PI_2;

const L: [f64; 4] = [0.090, 0.230, 0.180, 0.120];
const S: f64 = 0.040;

/// Angles at an angle of the knife arm, and the influence coefficients of `phi7` in the order of the variables.
fn at(phi4: f64) -> (Sample, Vec<f64>) {
    let scene = entry("heald_linkage", "printed");
    let run = scene.bind.linkage(&values(scene, &[])).unwrap();
    let sample = run.follow(&[vec![phi4]]).unwrap().samples.remove(0);
    let all = run.influence(&[phi4]).unwrap();
    let count = all.len() / scene.outputs.len();
    (sample, all[2 * count..3 * count].to_vec())
}

/// The printed formulas, with `A`, `B`, `C` of (16) to (18): l4, l5, l6, l7, a, b, s, phi4.
fn printed(phi4: f64, sample: &Sample) -> [f64; 8] {
    let [phi5, phi7] = [0, 2].map(|index| sample.dependents[index]);
    let a = S + L[3] * phi7.cos();
    let b = (L[2] * L[2] - a * a).sqrt();
    let c = (phi7 - phi5).sin() + phi7.sin() * phi5.cos() - a / b * phi7.sin() * phi5.sin();
    let below = c * L[3];
    [
        -(phi5 - phi4).cos() / below,
        -1.0 / below,
        L[2] * phi5.sin() / (b * below),
        ((phi7 - phi5).cos() + phi5.cos() * phi7.cos() - a / b * phi5.sin() * phi7.cos()) / below,
        phi5.sin() / below,
        phi5.cos() / below,
        (phi5.cos() - a / b * phi5.sin()) / below,
        -L[0] * (phi5 - phi4).sin() / below,
    ]
}

#[track_caller]
fn check(found: f64, expected: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= 1e-11 * expected.abs().max(1.0), "{what}: off by {off:e}");
}

/// With the minus signs that the scan hides, (8) to (15) are what the loops say.
#[test]
fn the_corrected_coefficients_hold() {
    for degrees in [60.0_f64, 77.5, 90.0, 103.0, 120.0] {
        let phi4 = degrees.to_radians();
        let (sample, found) = at(phi4);
        let expected = printed(phi4, &sample);
        for (index, name) in ["l4", "l5", "l6", "l7", "a", "b", "s", "phi4"].iter().enumerate() {
            check(found[index], expected[index], name);
        }
    }
}

/// Equation (5) divides the first equation by the second: it gives the complement of the angle, 80.496° for 9.504°.
#[test]
fn the_printed_angle_of_the_rod_is_upside_down() {
    let (sample, _) = at(FRAC_PI_2);
    let phi7 = sample.dependents[2];
    let phi6 = sample.dependents[1];
    let above = 0.105 + L[3] * phi7.cos() - L[0] * FRAC_PI_2.cos() + L[2] * phi6.cos();
    let below = 0.080 + L[3] * phi7.sin() - L[0] * FRAC_PI_2.sin() + L[2] * phi6.sin();
    let upside_down = (above / below).atan();
    assert!((upside_down.to_degrees() - 80.496).abs() < 5e-4);
    check(below.atan2(above), sample.dependents[0], "the right way round");
    // What each of the equations (4) is then short of: 189 mm.
    let gap = L[1] * (upside_down.cos() - sample.dependents[0].cos());
    assert!((gap + 0.189).abs() < 5e-4, "{gap}");
}

/// Equation (19) leaves out `l6` and `s`: the worst case falls from 2.0570 to 1.604 mrad.
#[test]
fn the_printed_sum_leaves_out_a_fifth_of_the_error() {
    let (_, found) = at(FRAC_PI_2);
    let half_widths = [5e-5, 5e-5, 5e-5, 5e-5, 1e-4, 1e-4, 1e-4, 0.1_f64.to_radians()];
    let shares: Vec<f64> = found.iter().zip(half_widths).map(|(k, t)| k.abs() * t).collect();
    let whole: f64 = shares.iter().sum();
    let printed = whole - shares[2] - shares[6];
    assert!((whole - 2.0570e-3).abs() < 5e-8, "{whole}");
    assert!((printed - 1.604e-3).abs() < 5e-7, "{printed}");
    let sigma: f64 = shares.iter().map(|share| share * share / 3.0).sum::<f64>().sqrt();
    assert!((sigma - 0.55949e-3).abs() < 5e-9, "{sigma}");
}
