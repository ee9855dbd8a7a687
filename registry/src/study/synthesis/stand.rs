//! Where several searches stand, and the distinct designs that they have found.

use super::Design;
use assur_solvers::synthesis::{Population, Score};

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
    /// The populations of those that follow, in their order: of the ones that go on, and of others that are over and wait for them.
    /// None where nothing has been judged yet.
    pub populations: Vec<Option<Population>>,
}

impl Stand {
    /// Designs that have been judged.
    pub fn evaluations(&self) -> u64 {
        let populations = self.populations.iter().flatten();
        self.judged + populations.map(|population| population.evaluations).sum::<u64>()
    }

    /// What the best design so far is worth.
    pub fn best(&self) -> Option<&Score> {
        let found = self.found.iter().map(|one| &one.score);
        let own = self.populations.iter().flatten().flat_map(|population| &population.scores);
        found.chain(own).min_by(|a, b| a.order(b))
    }

    /// Takes a design that was found, unless it is there, or a better one like it.
    pub(super) fn take(&mut self, design: &Design<'_>, candidate: Candidate) {
        let is_same = |other: &&mut Candidate| design.is_same(&other.design, &candidate.design);
        match self.found.iter_mut().find(is_same) {
            Some(other) if other.score.is_as_good_as(&candidate.score) => {}
            Some(other) => *other = candidate,
            None => self.found.push(candidate),
        }
    }

    /// The population of a search that is not yet over.
    pub(super) fn population(&mut self, number: u64) -> &mut Option<Population> {
        let place = (number - self.over) as usize;
        if self.populations.len() <= place {
            self.populations.resize(place + 1, None);
        }
        &mut self.populations[place]
    }

    /// The first search that was not yet over is so.
    pub(super) fn end(&mut self, design: &Design<'_>, candidate: Candidate) {
        self.judged += candidate.evaluations;
        self.over += 1;
        self.populations.remove(0);
        self.take(design, candidate);
    }
}

impl Design<'_> {
    /// Whether two designs are one.
    pub(super) fn is_same(&self, a: &[f64], b: &[f64]) -> bool {
        let mut ways = a.iter().zip(b).zip(&self.sought);
        ways.all(|((a, b), one)| one.way(*a, *b).abs() <= SAME * one.width())
    }
}
