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

/// Where several searches stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stand {
    /// What the searches that are over have found, distinct.
    pub found: Vec<Candidate>,
    /// How many are over.
    pub over: u64,
    /// Designs that they have judged.
    pub judged: u64,
    /// The population of the one that goes on.
    pub population: Option<Population>,
}

impl Stand {
    /// Designs that have been judged.
    pub fn evaluations(&self) -> u64 {
        self.judged + self.population.as_ref().map_or(0, |population| population.evaluations)
    }

    /// What the best design so far is worth.
    pub fn best(&self) -> Option<&Score> {
        let found = self.found.iter().map(|one| &one.score);
        let own = self.population.iter().flat_map(|population| &population.scores);
        found.chain(own).min_by(|a, b| a.order(b))
    }

    /// Takes a design that was found, unless it is there, or a better one like it.
    fn take(&mut self, design: &Design<'_>, candidate: Candidate) {
        let is_same = |other: &&mut Candidate| design.is_same(&other.design, &candidate.design);
        match self.found.iter_mut().find(is_same) {
            Some(other) if other.score.is_as_good_as(&candidate.score) => {}
            Some(other) => *other = candidate,
            None => self.found.push(candidate),
        }
    }
}

/// Seeks so many times, each time from other designs, and gives the distinct ones that were found, the best first. It goes on from
/// where `stand` stands, and what it comes to is what it would have come to without a stop. The effort is that of so many
/// searches; others follow until `progress`, which hears where the searches stand, ends them.
///
/// # Errors
/// [`SynthesisError`] if the problem makes no sense, or the searches belong to another one.
pub fn seek(
    design: &Design<'_>,
    effort: &Effort,
    searches: u64,
    stand: &mut Stand,
    progress: &mut dyn FnMut(&Stand) -> ControlFlow<()>,
) -> Result<Vec<Candidate>, SynthesisError> {
    let searches = searches.max(1);
    let mut going = progress(stand);
    while going.is_continue() {
        let own = Effort {
            evaluations: effort.evaluations / searches,
            seed: effort.seed.wrapping_add(stand.over.wrapping_mul(0x9e37_79b9)),
            ..effort.clone()
        };
        let from = stand.population.take();
        let mut heard = |population: &Population| {
            stand.population = Some(population.clone());
            going = progress(stand);
            going
        };
        let Found { design: best, score, is_gathered, population } =
            search(design, &own, from, &mut heard)?;
        let evaluations = population.evaluations;
        let best = design.permitted(&design.best(&best).0);
        let candidate = Candidate { design: best, score, evaluations, is_gathered };
        if going.is_break() {
            let mut all = Stand { found: stand.found.clone(), ..Stand::default() };
            all.take(design, candidate);
            return Ok(sorted(all.found));
        }
        stand.take(design, candidate);
        stand.population = None;
        stand.judged += evaluations;
        stand.over += 1;
        going = progress(stand);
    }
    Ok(sorted(stand.found.clone()))
}

fn sorted(mut all: Vec<Candidate>) -> Vec<Candidate> {
    all.sort_by(|a, b| a.score.order(&b.score));
    all
}

impl Design<'_> {
    /// Whether two designs are one.
    pub(super) fn is_same(&self, a: &[f64], b: &[f64]) -> bool {
        let mut ways = a.iter().zip(b).zip(&self.sought);
        ways.all(|((a, b), one)| one.way(*a, *b).abs() <= SAME * one.width())
    }
}
