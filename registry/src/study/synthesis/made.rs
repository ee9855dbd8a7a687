//! What becomes of a design that is made within tolerances.

use super::Design;
use crate::registry::Bind;
use assur_solvers::closure::Facet;
use assur_solvers::measure::Sense;

/// Widths of ranges over half-widths of tolerances: what is compared with linkages nearby is so by millionths of a range.
const WIDTHS: f64 = 1e3;

impl Design<'_> {
    /// What is made small, of a linkage whose constants err by the tolerances of its file: to first order, at each place its extreme
    /// and the root of the sum of the squares of what each half-width makes of it, where that is worst. Where all err normally,
    /// 99.87 of a hundred made ones are no worse at that place. None where nothing has a tolerance, or it does not get through its
    /// way.
    pub fn made(&self, design: &[f64]) -> Option<f64> {
        let Bind::Linkage(bind) = self.bind else { return None };
        let linkage = bind(&self.values(design)).ok()?;
        let constants = self.constants.iter().enumerate();
        let toleranced = constants.filter(|(_, constant)| constant.tolerance > 0.0);
        let (places, half_widths): (Vec<_>, Vec<f64>) = toleranced
            .map(|(index, constant)| ((index, WIDTHS * constant.tolerance), constant.tolerance))
            .unzip();
        if places.is_empty() {
            return None;
        }
        let wanted = [(self.synthesis.objective, Some(Sense::Smallest))];
        let facets = linkage.facets(linkage.way()?, places, &wanted).ok()?;
        let found = facets.of(&*linkage).ok()?;
        let worst = |facet: &Facet| {
            let squares = facet.slopes.iter().zip(&half_widths).map(|(slope, half)| slope * half);
            facet.value + squares.map(|one| one * one).sum::<f64>().sqrt()
        };
        found.first()?.iter().map(worst).reduce(f64::max)
    }
}
