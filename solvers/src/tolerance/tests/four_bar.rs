//! A crank-rocker in closed form, whose statistics are checked against those of its solved equation.

use super::super::{Sampling, Source, Status, Study, monte_carlo};
use crate::closure::tests::linkages::FourBar;
use crate::shape::Distribution;

/// The rocker has rod and rocker in line with the stretched crank: only a rod that is long enough reaches.
#[test]
fn the_share_that_does_not_meet_is_the_one_that_is_known() {
    // At q = 180 deg the gap is l1 + d = 0.125, which l2 + l3 passes by a tenth of the tolerance.
    let tolerance = 1e-4;
    let linkage = FourBar::new([0.025, 0.065 + 0.1 * tolerance, 0.06, 0.1], 1.0, [0.5, 1.5]);
    let study = Study {
        output: 1,
        places: vec![vec![180f64.to_radians()]],
        sources: vec![Source {
            variable: 1,
            half_width: tolerance,
            distribution: Distribution::Uniform,
        }],
    };
    let sampling = Sampling { samples: 50_000, ..Sampling::default() };
    let found = monte_carlo(&linkage, &study, &sampling, &|_| ()).expect("it is at the brink");
    let place = &found.places[0];
    assert_eq!(place.status, Status::Conditional);
    assert_eq!(place.assembled, 50_000 - (place.failures.value * 5e4).round() as u64);
    assert!(place.failures.low < 0.45 && 0.45 < place.failures.high, "{place:?}");
}
