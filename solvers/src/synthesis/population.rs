//! A generation of designs, and what it has learnt of how to make better ones.
//!
//! Differential evolution with success-history adaptation and linear reduction of the population, L-SHADE (R. Tanabe,
//! A. S. Fukunaga: *Improving the search performance of SHADE using linear population size reduction*, CEC 2014,
//! 1658–1665). Random numbers are found from generation and place, so that a population that is stored goes on as if it had
//! never stopped.

use super::problem::{Judge, Score, Sought, SynthesisError};
use crate::tolerance::{Random, normal_quantile};
use std::f64::consts::PI;

/// Fewest designs: three others are crossed with each.
pub(super) const LEAST: usize = 4;
/// Settings of successes that are remembered.
const MEMORY: usize = 6;
/// Designs that have been replaced are kept, so many times the population.
const ARCHIVE: f64 = 2.6;
/// The best designs, as a part of all, that others are drawn to.
const BEST: f64 = 0.11;
/// Spread of step lengths and crossing rates about what is remembered.
const SPREAD: f64 = 0.1;
/// Random numbers of a design and a generation that do not belong to one of its numbers.
const OWN: u64 = 64;

/// Designs with their scores, the best one first.
#[derive(Clone, Debug, PartialEq)]
pub struct Population {
    /// The designs, one behind the other.
    pub designs: Vec<f64>,
    /// Of each.
    pub scores: Vec<Score>,
    /// Designs that were replaced by better ones.
    pub archive: Vec<f64>,
    /// Step lengths and crossing rates that were successful.
    pub memory: [[f64; 2]; MEMORY],
    /// Which of them is written next.
    pub next: usize,
    /// Which generation it is.
    pub generation: u64,
    /// Designs that have been judged.
    pub evaluations: u64,
}

/// A design that is tried in the place of another.
struct Trial {
    length: f64,
    rate: f64,
}

impl Population {
    /// So many designs, anywhere between the bounds: one in each of as many equal parts of each range.
    pub(super) fn anywhere(sought: &[Sought], size: usize, seed: u64) -> Self {
        let (n, random) = (sought.len(), Random::new(seed, 0));
        let mut designs = vec![0.0; size * n];
        let mut order: Vec<usize> = (0..size).collect();
        for (k, one) in sought.iter().enumerate() {
            let place = |index: usize| (2 * k * size + index) as u64;
            for last in (1..size).rev() {
                order.swap(last, below(random.ahead(place(last)), last + 1));
            }
            for (index, part) in order.iter().enumerate() {
                let share = (*part as f64 + random.ahead(place(size + index))) / size as f64;
                designs[index * n + k] = one.low + share * one.width();
            }
        }
        Self {
            designs,
            scores: vec![Score::WORST; size],
            archive: Vec::new(),
            memory: [[0.5; 2]; MEMORY],
            next: 0,
            generation: 0,
            evaluations: 0,
        }
    }

    /// Numbers of a design.
    pub(super) fn length(&self) -> usize {
        self.designs.len() / self.scores.len().max(1)
    }

    /// A design.
    pub fn design(&self, index: usize) -> &[f64] {
        let n = self.length();
        &self.designs[index * n..][..n]
    }

    /// Judges all designs and puts the best one first.
    pub(super) fn begin(&mut self, judged: impl FnOnce(&[f64], &mut [Score])) {
        judged(&self.designs, &mut self.scores);
        self.evaluations += self.scores.len() as u64;
        self.sort(self.scores.len());
    }

    /// Replaces designs by better ones, each with one trial, and keeps the best.
    pub(super) fn advance(
        &mut self,
        judge: &dyn Judge,
        (seed, keep): (u64, usize),
        judged: impl FnOnce(&[f64], &mut [Score]),
    ) {
        self.generation += 1;
        let (n, size) = (self.length(), self.scores.len());
        let mut tried = vec![0.0; size * n];
        let mut trials = Vec::with_capacity(size);
        let stride = OWN + n as u64;
        for (index, tried) in tried.chunks_exact_mut(n).enumerate() {
            let place = (self.generation * 65_536 + index as u64).wrapping_mul(stride);
            let mut random = Random::new(seed, place);
            trials.push(self.tried(judge.sought(), index, &mut random, tried));
        }
        let mut scores = self.scores.clone();
        judged(&tried, &mut scores);
        self.evaluations += size as u64;
        let mut successes = Vec::new();
        for (index, (tried, score)) in tried.chunks_exact(n).zip(scores).enumerate() {
            if !score.is_as_good_as(&self.scores[index]) {
                continue;
            }
            if !self.scores[index].is_as_good_as(&score) {
                self.archive.extend_from_slice(&self.designs[index * n..][..n]);
                successes.push(index);
            }
            self.designs[index * n..][..n].copy_from_slice(tried);
            self.scores[index] = score;
        }
        self.learn(successes.iter().map(|index| &trials[*index]));
        self.sort(keep);
        self.forget(seed);
    }

    /// Makes a trial: from a design towards one of the best, and along the difference of two others.
    fn tried(
        &self,
        sought: &[Sought],
        index: usize,
        random: &mut Random,
        tried: &mut [f64],
    ) -> Trial {
        let (n, size) = (self.length(), self.scores.len());
        let [length, rate] = self.memory[below(random.uniform(), MEMORY)];
        let rate = (rate + SPREAD * normal_quantile(random.uniform())).clamp(0.0, 1.0);
        let length = step(length, random);
        let best = below(random.uniform(), ((BEST * size as f64).round() as usize).max(2));
        let other = besides(below(random.uniform(), size - 1), &[index]);
        let archived = self.archive.len() / n;
        let third = below(random.uniform(), size + archived - 2);
        let mut taken = [index, other];
        taken.sort_unstable();
        let third = besides(third, &taken);
        let third = match third < size {
            true => self.design(third),
            false => &self.archive[(third - size) * n..][..n],
        };
        let (own, best, other) = (self.design(index), self.design(best), self.design(other));
        let always = below(random.uniform(), n);
        for (k, (tried, one)) in tried.iter_mut().zip(sought).enumerate() {
            let is_crossed = random.uniform() < rate;
            *tried = own[k];
            if is_crossed || k == always {
                let moved = one.way(own[k], best[k]) + one.way(third[k], other[k]);
                *tried = one.within(own[k] + length * moved, own[k]);
            }
        }
        Trial { length, rate }
    }

    /// Remembers what was successful: means of the second over the first powers, which prefer what is large.
    fn learn<'a>(&mut self, successes: impl Iterator<Item = &'a Trial>) {
        let (mut lengths, mut rates) = ([0.0; 2], [0.0; 2]);
        for Trial { length, rate } in successes {
            lengths = [lengths[0] + length, lengths[1] + length * length];
            rates = [rates[0] + rate, rates[1] + rate * rate];
        }
        if lengths[0] > 0.0 {
            let rate = if rates[0] > 0.0 { rates[1] / rates[0] } else { 0.0 };
            self.memory[self.next] = [lengths[1] / lengths[0], rate];
            self.next = (self.next + 1) % MEMORY;
        }
    }

    /// Puts the best designs first and keeps so many.
    fn sort(&mut self, keep: usize) {
        let n = self.length();
        let mut order: Vec<usize> = (0..self.scores.len()).collect();
        order.sort_by(|a, b| {
            let [a, b] = [&self.scores[*a], &self.scores[*b]];
            b.is_as_good_as(a).cmp(&a.is_as_good_as(b))
        });
        order.truncate(keep.max(LEAST));
        self.designs =
            order.iter().flat_map(|index| &self.designs[index * n..][..n]).copied().collect();
        self.scores = order.iter().map(|index| self.scores[*index]).collect();
    }

    /// Leaves out of the archive, anywhere, what it has no room for.
    fn forget(&mut self, seed: u64) {
        let n = self.length();
        let room = (ARCHIVE * self.scores.len() as f64) as usize;
        let mut random = Random::new(seed, !self.generation);
        while self.archive.len() > room * n {
            let last = self.archive.len() / n - 1;
            let gone = below(random.uniform(), last + 1);
            self.archive.copy_within(last * n.., gone * n);
            self.archive.truncate(last * n);
        }
    }

    /// Whether all its designs are the same to a part of each range.
    pub(super) fn is_gathered(&self, sought: &[Sought], part: f64) -> bool {
        let first = self.design(0);
        (1..self.scores.len()).all(|index| {
            let ways = self.design(index).iter().zip(first).zip(sought);
            ways.into_iter().all(|((a, b), one)| one.way(*a, *b).abs() <= part * one.width())
        })
    }

    /// Whether it can go on with a problem.
    pub(super) fn check(&self, sought: &[Sought]) -> Result<(), SynthesisError> {
        if self.scores.len() < LEAST {
            return Err(SynthesisError::BadPopulation { size: self.scores.len(), least: LEAST });
        }
        let (found, expected) = (self.length(), sought.len());
        if found != expected
            || self.designs.len() != found * self.scores.len()
            || !self.archive.len().is_multiple_of(expected)
            || self.next >= MEMORY
        {
            return Err(SynthesisError::OtherProblem { found, expected });
        }
        Ok(())
    }
}

/// A whole number below another, from one between 0 and 1.
fn below(share: f64, count: usize) -> usize {
    ((share * count as f64) as usize).min(count.saturating_sub(1))
}

/// The number that has so many before it once others, the smallest first, are left out.
fn besides(mut index: usize, others: &[usize]) -> usize {
    for other in others {
        index += usize::from(index >= *other);
    }
    index
}

/// A length of steps about one that is remembered, by Cauchy's distribution; above zero, at most one.
fn step(about: f64, random: &mut Random) -> f64 {
    for _ in 0..OWN / 2 {
        let length = about + SPREAD * (PI * (random.uniform() - 0.5)).tan();
        if length > 0.0 {
            return length.min(1.0);
        }
    }
    SPREAD
}
