//! Designs judged against others that they have to be as good as.

use super::{Design, missed};
use crate::registry::Bind;
use assur_solvers::closure::{AnyLinkage, losers};
use assur_solvers::scalar::Interval;
use assur_solvers::shape::Kind;
use assur_solvers::synthesis::{Judge, Score, Sought};

/// What measures may differ by, found at a place or on the whole way, SI units or a part of them.
const SLACK: f64 = 1e-9;

/// What is sought are the values that no condition gives: of the designs that it leaves the best counts.
impl Judge for Design<'_> {
    fn sought(&self) -> &[Sought] {
        self.chosen()
    }

    fn judge(&self, designs: &[f64], scores: &mut [Score]) {
        let chosen = designs.chunks_exact(self.chosen().len()).enumerate();
        let all = chosen.flat_map(|(owner, chosen)| {
            self.complete(chosen).into_iter().map(move |design| (owner, design))
        });
        let all: Vec<(usize, Vec<f64>)> = all.collect();
        let lost = self.losers(&all, scores);
        scores.fill(Score::WORST);
        for (index, (owner, design)) in all.iter().enumerate() {
            if !lost.contains(&index) {
                let score = self.score(design);
                if score.order(&scores[*owner]).is_lt() {
                    scores[*owner] = score;
                }
            }
        }
    }
}

impl Design<'_> {
    /// Which of these designs, each with its owner, are certainly worse than the score that the owner has. So that this is told from
    /// a few places of the way, the owner has to get through it.
    fn losers(&self, designs: &[(usize, Vec<f64>)], rivals: &[Score]) -> Vec<usize> {
        let (Bind::Linkage(bind), true) = (self.bind, self.has_extremes()) else {
            return Vec::new();
        };
        let is_through = |rival: &Score| rival.is_kept() || rival.missed < self.count();
        let compared = designs.iter().enumerate().filter(|(_, one)| is_through(&rivals[one.0]));
        let linkages: Vec<(usize, Box<dyn AnyLinkage>)> = compared
            .filter_map(|(index, (_, design))| {
                let linkage = bind(&self.values(design)).ok()?;
                let known = linkage.of_constants();
                // These are not compared: their scores are at hand.
                missed(&self.margins(|index| known[index], true))
                    .is_none()
                    .then_some((index, linkage))
            })
            .collect();
        losers(&linkages, &|index, bounds| self.is_worse(bounds, &rivals[designs[index].0]))
    }

    /// Whether what is made small, kept or preferred is told by extremes.
    fn has_extremes(&self) -> bool {
        let is_extreme = |primitive: &usize| {
            matches!(self.shape.primitives[*primitive].kind, Kind::Peak | Kind::Lowest)
        };
        let mut uses = self.shape.uses.iter().enumerate();
        uses.any(|(measure, uses)| self.needs(measure) && uses.iter().any(is_extreme))
    }

    /// Whether a design is worse than a score whichever values its measures have between these bounds.
    fn is_worse(&self, bounds: &[Interval], rival: &Score) -> bool {
        let margins = self.margins(|index| bounds[index].high + SLACK, false);
        if let Some(first) = missed(&margins) {
            return first > rival.missed + SLACK;
        }
        let least = bounds[self.synthesis.objective].low;
        let best = self.synthesis.worth(least, |index| bounds[index].high);
        rival.is_kept() && best > rival.value + SLACK * (1.0 + rival.value.abs())
    }
}
