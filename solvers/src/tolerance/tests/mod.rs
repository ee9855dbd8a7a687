mod brink;
mod four_bar;
mod published;
mod rounding;
mod second;
mod seeds;

use super::{Source, Study};
pub(super) use crate::closure::tests::linkages::Heald;
use crate::shape::Distribution;

/// The heald linkage with its tolerances: 0.05 mm, for a, b, s 0.1 mm, 0.1 deg, as many times, of this distribution.
pub(super) fn study(degrees: &[f64], scale: f64, distribution: Distribution) -> Study {
    let tolerances = [5e-5, 5e-5, 5e-5, 5e-5, 1e-4, 1e-4, 1e-4, 0.1f64.to_radians()];
    let source = |(variable, tolerance): (usize, &f64)| Source {
        variable,
        half_width: scale * tolerance,
        distribution,
    };
    Study {
        output: 0,
        places: degrees.iter().map(|one| vec![one.to_radians()]).collect(),
        sources: tolerances.iter().enumerate().map(source).collect(),
    }
}

/// The same with the tolerances as they are, at one position.
fn at(degrees: f64) -> (Heald, Study) {
    (Heald::default(), study(&[degrees], 1.0, Distribution::Uniform))
}
