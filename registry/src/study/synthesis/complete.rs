//! Designs of which a part follows from a condition.

use super::Design;
use crate::registry::Bind;
use assur_solvers::synthesis::{Fit, Score, Sought};

/// Places of a way at which the condition is looked at.
const PLACES: usize = 72;

impl Design<'_> {
    /// The numbers that are chosen; behind them stand those that follow from a condition.
    pub(super) fn chosen(&self) -> &[Sought] {
        &self.sought[..self.synthesis.chosen()]
    }

    /// The best design with these numbers, and what it is worth.
    pub(super) fn best(&self, chosen: &[f64]) -> (Vec<f64>, Score) {
        let scored = self.complete(chosen).into_iter().map(|design| {
            let score = self.score(&design);
            (design, score)
        });
        let best =
            scored.reduce(|best, other| if other.1.order(&best.1).is_lt() { other } else { best });
        best.unwrap_or_else(|| (chosen.to_vec(), Score::WORST))
    }

    /// The designs with these numbers, at least one. Where the condition says nothing, since loops do not close, one from the middles of the ranges.
    pub(super) fn complete(&self, chosen: &[f64]) -> Vec<Vec<f64>> {
        let middles = self.sought[chosen.len()..].iter().map(|one| 0.5 * (one.low + one.high));
        let middle: Vec<f64> = chosen.iter().copied().chain(middles).collect();
        match self.follow(&middle) {
            Some(all) if !all.is_empty() => {
                let whole = |own: Vec<f64>| chosen.iter().copied().chain(own).collect();
                all.into_iter().map(whole).collect()
            }
            _ => vec![middle],
        }
    }

    /// What follows from the condition, the best first.
    fn follow(&self, design: &[f64]) -> Option<Vec<Vec<f64>>> {
        let solved = self.synthesis.solved.as_ref()?;
        let Bind::Linkage(bind) = self.bind else { return None };
        let linkage = bind(&self.values(design)).ok()?;
        let all = linkage.sampled(linkage.way()?, solved.groups, PLACES)?;
        let terms =
            |there: &Vec<f64>| solved.terms.iter().map(|term| there[term.quantity]).collect();
        let coefficients: Vec<Vec<f64>> = all.iter().map(terms).collect();
        let bounds = solved.unknowns.iter().map(|place| {
            let one = &self.sought[*place];
            (one.low, one.high)
        });
        let bounds: Vec<(f64, f64)> = bounds.collect();
        Some(Fit::of(solved, &bounds, &coefficients)?.candidates())
    }
}
