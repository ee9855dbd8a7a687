//! The distinct designs that several searches find.

use std::ops::ControlFlow;

use super::Design;
use assur_solvers::synthesis::{Effort, Found, Population, Score, SynthesisError, search};

/// Designs that differ by less, as a part of each range, are one.
const SAME: f64 = 1e-3;

/// A design that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The constants that are varied.
    pub design: Vec<f64>,
    /// What it is worth.
    pub score: Score,
    /// Designs that were judged to find it.
    pub evaluations: u64,
    /// Whether all designs had come together.
    pub is_gathered: bool,
}

/// Seeks so many times, each time from other designs, and gives the distinct ones that were found, the best first.
/// `progress` hears how many designs have been judged, and of the best score so far; it may end the search.
///
/// # Errors
/// [`SynthesisError`] if the problem makes no sense.
pub fn seek(
    design: &Design<'_>,
    effort: &Effort,
    searches: u64,
    progress: &mut dyn FnMut(u64, Score) -> ControlFlow<()>,
) -> Result<Vec<Candidate>, SynthesisError> {
    let mut all: Vec<Candidate> = Vec::new();
    let (mut judged, mut best, mut going) = (0, Score::WORST, ControlFlow::Continue(()));
    for index in 0..searches.max(1) {
        let own = Effort {
            evaluations: effort.evaluations / searches.max(1),
            seed: effort.seed.wrapping_add(index.wrapping_mul(0x9e37_79b9)),
            ..effort.clone()
        };
        let mut heard = |population: &Population| {
            if population.scores[0].is_as_good_as(&best) {
                best = population.scores[0];
            }
            going = progress(judged + population.evaluations, best);
            going
        };
        let Found { design: found, score, is_gathered, population } =
            search(design, &own, None, &mut heard)?;
        judged += population.evaluations;
        let evaluations = population.evaluations;
        match all.iter_mut().find(|other| design.is_same(&other.design, &found)) {
            Some(other) if other.score.is_as_good_as(&score) => {}
            Some(other) => (other.design, other.score) = (found, score),
            None => all.push(Candidate { design: found, score, evaluations, is_gathered }),
        }
        if going.is_break() {
            break;
        }
    }
    all.sort_by(|a, b| a.score.order(&b.score));
    Ok(all)
}

impl Design<'_> {
    /// Whether two designs are one.
    pub(super) fn is_same(&self, a: &[f64], b: &[f64]) -> bool {
        let mut ways = a.iter().zip(b).zip(&self.sought);
        ways.all(|((a, b), one)| one.way(*a, *b).abs() <= SAME * one.width())
    }
}
