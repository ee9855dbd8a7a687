//! Designs polished, and what holds them.
//!
//! The measures of a linkage are given by their facets ([`Facets`]), so that all places of an extreme that may count are known with
//! their slopes; those of a motion are compared with those of neighbours.

use super::neighbours::{INWARD, Neighbours};
use super::{Candidate, Design};
use crate::study::each;
use assur_solvers::closure::Facet;
use assur_solvers::synthesis::{Certificate, End, Local, Polished, certify, polish};

/// What a polished design may lose by that, over its value.
const LOSS: f64 = 1e-6;
/// Places of neighbouring facets are no farther apart than this part of the way.
const BESIDE_PLACES: f64 = 0.02;
/// Looks at most.
const LOOKS: u64 = 1000;
/// Saddles that are left at most.
const SADDLES: usize = 8;
/// Part of the ranges by which it is gone beyond one.
const FARTHER: f64 = 0.01;
/// A gain that counts, over the value.
const GAIN: f64 = 1e-9;

/// How a design was polished, and what holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Polish {
    /// How it ended.
    pub end: End,
    /// Looks at a design and its neighbours.
    pub looks: u64,
    /// What holds the design: places of what is made small first, then conditions.
    pub held: Vec<Held>,
    /// Values at a bound, by their place among those that are varied: what would be gained per range beyond the upper one, or
    /// below zero beyond the lower one.
    pub bounds: Vec<(usize, f64)>,
    /// How many directions these leave free.
    pub free: usize,
    /// The least curvature in these directions, per range squared; above zero if no neighbour is better. None where there is
    /// no such direction, or it is not known.
    pub curvature: Option<f64>,
    /// The largest slope that is left, per range.
    pub slope: f64,
}

/// A measure that holds a design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Which measure.
    pub measure: usize,
    /// The place of its extreme; none where it has no one place.
    pub at: Option<f64>,
    /// Of what is made small its share; of a condition what would be gained per unit of it.
    pub multiplier: f64,
}

/// A design as it is proposed.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    /// The design.
    pub candidate: Candidate,
    /// How it was polished; none where that made it no better.
    pub polish: Option<Polish>,
}

/// Polishes designs and gives the distinct ones, the best first. A design that polishing makes no better stays as it is, and so
/// do those that are left when `is_stopped` says so.
pub fn settle(
    design: &Design<'_>,
    found: Vec<Candidate>,
    threads: usize,
    is_stopped: &(dyn Fn() -> bool + Sync),
) -> Vec<Settled> {
    let settled = each(found.len(), threads, &|_| {}, &|index| {
        let candidate = found[index].clone();
        match is_stopped() {
            true => Settled { candidate, polish: None },
            false => design.settled(candidate, is_stopped),
        }
    });
    let mut all: Vec<Settled> = Vec::new();
    for one in settled {
        let is_same =
            |other: &&mut Settled| design.is_same(&other.candidate.design, &one.candidate.design);
        match all.iter_mut().find(is_same) {
            Some(other) if other.candidate.score.is_as_good_as(&one.candidate.score) => {}
            Some(other) => *other = one,
            None => all.push(one),
        }
    }
    all.sort_by(|a, b| a.candidate.score.order(&b.candidate.score));
    all
}

impl Design<'_> {
    fn settled(&self, candidate: Candidate, is_stopped: &dyn Fn() -> bool) -> Settled {
        let Some((polished, values)) = self.polished(&candidate.design, is_stopped) else {
            return Settled { candidate, polish: None };
        };
        let (score, before) = (self.score(&values), candidate.score);
        // Conditions are kept by more than a search may have left of them.
        let is_as_good = score.is_kept()
            && before.is_kept()
            && score.value - before.value <= LOSS * before.value.abs();
        match is_as_good || score.is_as_good_as(&before) {
            true => Settled {
                candidate: Candidate { design: values, score, ..candidate },
                polish: Some(polished),
            },
            false => Settled { candidate, polish: None },
        }
    }

    /// Polishes a design; none where it cannot be judged.
    fn polished(&self, from: &[f64], is_stopped: &dyn Fn() -> bool) -> Option<(Polish, Vec<f64>)> {
        let is_sum = !self.synthesis.squares.is_empty();
        let found = is_sum.then(|| self.polished_by(true, from, is_stopped)).flatten();
        // The square of an extreme has corners where two places are as far out: there its places have to be known.
        match found {
            Some((polish, design)) if polish.end == End::Stuck => {
                let again = self.polished_by(false, &design, is_stopped);
                let again = again.map(|(other, design)| {
                    (Polish { looks: polish.looks + other.looks, ..other }, design)
                });
                again.or(Some((polish, design)))
            }
            Some(found) => Some(found),
            None => self.polished_by(false, from, is_stopped),
        }
    }

    /// Polishes a design by the squares of which what is made small is the sum, or by all places of its extremes.
    fn polished_by(
        &self,
        squares: bool,
        from: &[f64],
        is_stopped: &dyn Fn() -> bool,
    ) -> Option<(Polish, Vec<f64>)> {
        let (mut neighbours, from) = Neighbours::of(self, squares, from, is_stopped)?;
        let aim = neighbours.aim();
        let polished = polish(&mut neighbours, aim, &from, LOOKS).ok()?;
        let (polished, certificate) = beyond_saddles(&mut neighbours, polished)?;
        let all = neighbours.facets_of(&polished.design)?;
        let (first, others) = all.split_at(neighbours.small().len());
        let held = |index: usize, multiplier: f64| Held {
            measure: self.synthesis.objective,
            at: first[0][summit(&first[0], index)].at,
            multiplier,
        };
        // Squares hold nothing one by one.
        let objective = certificate.values.iter().filter(|_| !squares);
        let objective = objective.map(|(index, multiplier)| held(*index, *multiplier));
        let wanted = neighbours.wanted();
        // The rows of conditions are those of all facets, one condition after the other.
        let rows = others.iter().enumerate();
        let rows: Vec<_> =
            rows.flat_map(|(k, facets)| (0..facets.len()).map(move |place| (k, place))).collect();
        let conditions = certificate.conditions.iter().map(|(index, multiplier)| {
            let (k, place) = rows[*index];
            let (measure, at) = (wanted[first.len() + k].0, others[k][place].at);
            Held { measure, at, multiplier: multiplier / neighbours.scale(k) }
        });
        // Several parts of the way may stand for one place.
        let mut held: Vec<Held> = Vec::new();
        for one in objective.chain(conditions) {
            match held.last_mut() {
                Some(last)
                    if one.at.is_some() && (last.measure, last.at) == (one.measure, one.at) =>
                {
                    last.multiplier += one.multiplier;
                }
                _ => held.push(one),
            }
        }
        let bounds = certificate.bounds.iter();
        let bounds = bounds.filter_map(|(index, gain)| Some((neighbours.varied(*index)?, *gain)));
        let polish = Polish {
            end: polished.end,
            looks: polished.looks,
            held,
            bounds: bounds.collect(),
            free: certificate.free,
            curvature: certificate.curvature,
            slope: polished.slope,
        };
        Some((polish, neighbours.whole(&polished.design)))
    }
}

/// Goes on from where a design is level, but something better lies farther on in some direction.
fn beyond_saddles(
    neighbours: &mut Neighbours<'_>,
    mut best: Polished,
) -> Option<(Polished, Certificate)> {
    let aim = neighbours.aim();
    let mut certificate = certify(neighbours, aim, &best)?;
    for _ in 0..SADDLES {
        if best.end != End::Settled || !certificate.curvature.is_some_and(|one| one < 0.0) {
            break;
        }
        let mut looks = best.looks;
        let mut found: Option<Polished> = None;
        for sign in [-1.0, 1.0] {
            let sought = neighbours.sought().iter().zip(&best.design).zip(&certificate.direction);
            let beside = sought.map(|((one, number), part)| {
                one.within(number + sign * FARTHER * part * one.width(), *number)
            });
            let beside: Vec<f64> = beside.collect();
            let Ok(other) = polish(neighbours, aim, &beside, LOOKS) else { continue };
            looks += other.looks;
            let before = found.as_ref().unwrap_or(&best);
            let gain = before.value - other.value;
            if other.missed <= before.missed + INWARD && gain > GAIN * before.value.abs() {
                found = Some(other);
            }
        }
        match found {
            Some(other) => best = Polished { looks, ..other },
            None => break,
        }
        certificate = certify(neighbours, aim, &best)?;
    }
    Some((best, certificate))
}

/// Which facet is the top of the hill that another lies on: of a part of the way in which a quantity only rises, its end stands for
/// the top in the next.
fn summit(facets: &[Facet], mut index: usize) -> usize {
    loop {
        let here = &facets[index];
        let is_beside = |other: &Facet| match (here.at, other.at) {
            (Some(a), Some(b)) => (a - b).abs() <= BESIDE_PLACES * span(facets),
            _ => false,
        };
        let beside = [index.checked_sub(1), index.checked_add(1)].into_iter().flatten();
        let higher = beside.filter(|other| {
            facets.get(*other).is_some_and(|other| other.value > here.value && is_beside(other))
        });
        match higher.max_by(|a, b| facets[*a].value.total_cmp(&facets[*b].value)) {
            Some(other) => index = other,
            None => return index,
        }
    }
}

/// How far apart the places of facets lie at most.
fn span(facets: &[Facet]) -> f64 {
    let places = facets.iter().filter_map(|facet| facet.at);
    let (low, high) = places
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    high - low
}
