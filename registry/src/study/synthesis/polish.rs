//! Designs polished, and what holds them.
//!
//! The measures of a linkage are given by their facets ([`Facets`]), so that all places of an extreme that may count are known with
//! their slopes; those of a motion are compared with those of neighbours.

use super::{Candidate, Design};
use crate::registry::Bind;
use crate::study::each;
use assur_solvers::closure::{AnyLinkage, Facet, Facets};
use assur_solvers::measure::Sense;
use assur_solvers::synthesis::{Aim, End, Local, Look, Sought, certify, polish};

/// Conditions are kept by so much more than they have to be, over what they change by within the ranges: what a measure says of
/// them is not exact either.
const INWARD: f64 = 1e-9;
/// What a polished design may lose by that, over its value.
const LOSS: f64 = 1e-6;
/// Part of its range by which a value is varied to see how a motion changes.
const BESIDE: f64 = 1e-4;
/// Places of neighbouring facets are no farther apart than this part of the way.
const BESIDE_PLACES: f64 = 0.02;
/// Looks at most.
const LOOKS: u64 = 1000;

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
        let mut neighbours =
            Neighbours { design: self, facets: None, scales: Vec::new(), is_stopped };
        let polished = polish(&mut neighbours, Aim::Largest, from, LOOKS).ok()?;
        let certificate = certify(&mut neighbours, Aim::Largest, &polished)?;
        let all = neighbours.facets_of(&polished.design)?;
        let (first, others) = all.split_first()?;
        let held = |index: usize, multiplier: f64| Held {
            measure: self.synthesis.objective,
            at: first[summit(first, index)].at,
            multiplier,
        };
        let objective =
            certificate.values.iter().map(|(index, multiplier)| held(*index, *multiplier));
        // The rows of conditions are those of all facets, one condition after the other.
        let rows = others.iter().enumerate();
        let rows: Vec<_> =
            rows.flat_map(|(k, facets)| (0..facets.len()).map(move |place| (k, place))).collect();
        let conditions = certificate.conditions.iter().map(|(index, multiplier)| {
            let (k, place) = rows[*index];
            let measure = self.synthesis.conditions[k];
            let at = others[k][place].at;
            Held { measure, at, multiplier: multiplier / neighbours.scales[k] }
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
        let polish = Polish {
            end: polished.end,
            looks: polished.looks,
            held,
            bounds: certificate.bounds,
            free: certificate.free,
            curvature: certificate.curvature,
            slope: polished.slope,
        };
        Some((polish, polished.design))
    }

    /// What is made small, then the conditions, each with the sense in which it is good.
    fn wanted(&self) -> Vec<(usize, Sense)> {
        let conditions = self.synthesis.conditions.iter();
        let first = (self.synthesis.objective, Sense::Smallest);
        std::iter::once(first).chain(conditions.map(|one| (*one, Sense::Largest))).collect()
    }
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

/// The neighbours of a design.
struct Neighbours<'a> {
    design: &'a Design<'a>,
    /// Of a linkage, once one is known.
    facets: Option<Facets>,
    /// What each condition changes by within the ranges, where polishing begins.
    scales: Vec<f64>,
    is_stopped: &'a dyn Fn() -> bool,
}

impl Neighbours<'_> {
    fn facets_of(&mut self, design: &[f64]) -> Option<Vec<Vec<Facet>>> {
        match self.design.bind {
            Bind::Linkage(bind) => {
                let linkage = bind(&self.design.values(design)).ok()?;
                self.of_linkage(&*linkage)
            }
            Bind::Motion(_) => self.compared(design),
        }
    }

    fn of_linkage(&mut self, linkage: &dyn AnyLinkage) -> Option<Vec<Vec<Facet>>> {
        let way = linkage.way()?;
        let design = self.design;
        let facets = self.facets.get_or_insert_with(|| {
            let constants = design.synthesis.varied.iter();
            let constants = constants.map(|one| (one.constant, one.to - one.from)).collect();
            linkage.facets(way, constants, &design.wanted())
        });
        facets.of(linkage).ok()
    }

    /// The measures as they are, beside those of neighbours within the bounds.
    fn compared(&self, design: &[f64]) -> Option<Vec<Vec<Facet>>> {
        let measures = |design: &[f64]| -> Option<Vec<f64>> {
            let all = self.design.found(design)?;
            Some(all.into_iter().map(|one| one.unwrap_or(f64::NAN)).collect())
        };
        let here = measures(design)?;
        let beside = self.design.sought.iter().enumerate().map(|(index, one)| {
            let [behind, ahead] = [-BESIDE, BESIDE].map(|part| {
                let mut other = design.to_vec();
                other[index] += part * one.width();
                if !one.is_turn {
                    other[index] = other[index].clamp(one.low, one.high);
                }
                other
            });
            let way = ahead[index] - behind[index];
            let (behind, ahead) = (measures(&behind)?, measures(&ahead)?);
            Some(ahead.iter().zip(behind).map(|(a, b)| (a - b) / way).collect::<Vec<f64>>())
        });
        let slopes: Vec<Vec<f64>> = beside.collect::<Option<_>>()?;
        let facet = |(measure, _): (usize, Sense)| {
            let slopes = slopes.iter().map(|all| all[measure]).collect();
            vec![Facet { at: None, value: here[measure], slopes }]
        };
        Some(self.design.wanted().into_iter().map(facet).collect())
    }

    /// The slopes of a facet in units of the ranges, all together.
    fn reach(&self, facet: &Facet) -> f64 {
        let each = facet.slopes.iter().zip(&self.design.sought);
        each.map(|(slope, one)| slope.abs() * one.width()).sum()
    }
}

impl Local for Neighbours<'_> {
    fn sought(&self) -> &[Sought] {
        &self.design.sought
    }

    fn is_stopped(&self) -> bool {
        (self.is_stopped)()
    }

    fn look(&mut self, design: &[f64]) -> Option<Look> {
        let all = self.facets_of(design)?;
        let (first, others) = all.split_first()?;
        if self.scales.is_empty() {
            let reach = |facets: &Vec<Facet>| {
                let most = facets.iter().map(|facet| self.reach(facet)).fold(0.0, f64::max);
                if most > 0.0 && most.is_finite() { most } else { 1.0 }
            };
            self.scales = others.iter().map(reach).collect();
        }
        let mut look = Look::default();
        for facet in first {
            look.values.push(facet.value);
            look.slopes.extend(&facet.slopes);
        }
        for (facets, scale) in others.iter().zip(&self.scales) {
            for facet in facets {
                look.conditions.push(facet.value / scale - INWARD);
                look.slopes.extend(facet.slopes.iter().map(|slope| slope / scale));
            }
        }
        Some(look)
    }
}
