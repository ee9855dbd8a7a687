//! How measures of a way change with the constants of a linkage.
//!
//! An extreme changes to first order as the quantity does at its place, which may move. But a measure that is to be small meets
//! other places before long: those that are nearly as far out. It is therefore given by facets, one for each place at which
//! an extreme may come to lie, as if it lay there; the largest of them is the measure.
//!
//! Quantities at a place change with constants as the loops do that are kept closed. What else is found of a way, integrals and
//! such, is compared with that of linkages nearby; so is an extreme where a condition holds, unless that holds at the same places
//! whatever the constants are.

use assur_functions::Sense;

use super::course::{Course, Stretches};
use super::known::Known;
use super::track::Along;
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::derivative::duals;
use crate::closure::linkage::loops::Answers;
use crate::scalar::{Dual, Scalar};
use crate::shape::{Kind, Moment, Shape};

/// Parts in which a way is looked through for what is no extreme.
pub(super) const FEW: usize = 16;

/// Parts in which a condition is looked at, whether it is the same for all constants.
const MANY: usize = 128;

/// A measure, as if one extreme that it uses lay at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Facet {
    /// The place, that of the driver; none where the measure is what it is.
    pub at: Option<f64>,
    /// What it comes to, SI units.
    pub value: f64,
    /// Its derivatives by the constants.
    pub slopes: Vec<f64>,
}

/// Which measures are asked for, and by what they change.
#[derive(Clone, Debug)]
pub struct Facets {
    pub(super) along: Along,
    /// The constants with the widths of their ranges.
    pub(super) constants: Vec<(usize, f64)>,
    pub(super) measures: Vec<usize>,
    /// Of each primitive where extremes are looked for; none where that changes with the constants.
    pub(super) stretches: Vec<Option<Stretches>>,
    /// Of each measure the extremes that it is given by, place by place.
    spread: Vec<Vec<usize>>,
}

impl Facets {
    /// Of measures, each with the sense in which it is good, along a way of a linkage. One without a sense is given as it is, by one
    /// facet. The constants stand with the widths of their ranges. Linkages that are asked about later have as many facets.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub fn new(
        linkage: &dyn AnyLinkage,
        along: Along,
        constants: Vec<(usize, f64)>,
        measures: &[(usize, Option<Sense>)],
    ) -> Result<Self, ClosureError> {
        let mut facets = Self {
            along,
            constants,
            measures: measures.iter().map(|one| one.0).collect(),
            stretches: Vec::new(),
            spread: Vec::new(),
        };
        let primitives = linkage.shape().primitives.iter();
        let stretches = primitives.map(|primitive| facets.stretches(linkage, primitive.window));
        facets.stretches = stretches.collect::<Result<_, _>>()?;
        let spread = measures.iter().map(|(measure, sense)| {
            sense.map_or_else(Vec::new, |sense| facets.spread(linkage, *measure, sense))
        });
        facets.spread = spread.collect();
        Ok(facets)
    }

    /// Where a condition holds, if it does so whatever the constants are; without one everywhere.
    fn stretches(
        &self,
        linkage: &dyn AnyLinkage,
        window: Option<usize>,
    ) -> Result<Option<Stretches>, ClosureError> {
        let Some(window) = window else {
            return Ok(Some(Stretches::everywhere(self.along.bounds())));
        };
        if matches!(self.along, Along::Time(..)) {
            return Ok(None);
        }
        let loops = self.loops(linkage);
        let mut course = Course::new(linkage, self.along)?;
        let (from, to) = self.along.bounds();
        for part in 0..=MANY {
            let (_, slopes) =
                course.at(from + (to - from) * (part as f64 / MANY as f64), &loops)?;
            if slopes.iter().any(|all| all[window] != 0.0) {
                return Ok(None);
            }
        }
        let holds = Walk::new(linkage, self.along)?.stretches(FEW, window)?;
        Ok((!holds.is_empty()).then(|| Stretches::of(&holds, self.along.bounds())))
    }

    /// The loops for each constant.
    pub(super) fn loops(&self, linkage: &dyn AnyLinkage) -> Vec<Box<dyn Answers<Dual>>> {
        let values = linkage.values();
        let constants = self.constants.iter();
        constants
            .map(|(constant, _)| linkage.differentiate(&duals(&values, Some(*constant))))
            .collect()
    }

    /// The facets of all measures.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub fn of(&self, linkage: &dyn AnyLinkage) -> Result<Vec<Vec<Facet>>, ClosureError> {
        let known = self.look(linkage)?;
        let plain = known.measures(None);
        let all = self.measures.iter().zip(&self.spread);
        let all = all.map(|(measure, spread)| match spread.is_empty() {
            true => vec![plain.facet(*measure, None)],
            false => Self::of_measure(*measure, spread, &known),
        });
        Ok(all.collect())
    }

    fn of_measure(measure: usize, spread: &[usize], known: &Known) -> Vec<Facet> {
        let each = spread.iter().flat_map(|primitive| {
            let places = known.places[*primitive].iter();
            places.map(|place| {
                known.measures(Some((*primitive, place))).facet(measure, Some(place.at))
            })
        });
        each.collect()
    }

    /// The extremes that make a measure worse the further out they lie. An extreme that does not matter here may elsewhere.
    fn spread(&self, linkage: &dyn AnyLinkage, measure: usize, good: Sense) -> Vec<usize> {
        let shape = linkage.shape();
        let values = linkage.values();
        let loops = linkage.differentiate(&duals(&values, None));
        let found = vec![1.0; shape.primitives.len()];
        let rises = |primitive: usize| {
            let mut measures = vec![Dual::ZERO; shape.measures.len()];
            loops.measures(&duals(&found, Some(primitive)), &mut measures);
            measures[measure].slope
        };
        let uses = shape.uses[measure].iter().copied();
        let bad = uses.filter(|primitive| {
            let Some(sense) = self.extreme(shape, *primitive) else {
                return false;
            };
            let rises = rises(*primitive) * if good == Sense::Smallest { 1.0 } else { -1.0 };
            match sense {
                Sense::Largest => rises >= 0.0,
                Sense::Smallest => rises <= 0.0,
            }
        });
        bad.collect()
    }

    /// Which extreme a primitive is whose places stay what they are when constants change: those of a driver, not those of
    /// the time, at which drivers may then be elsewhere.
    pub(super) fn extreme(&self, shape: &Shape, primitive: usize) -> Option<Sense> {
        if self.stretches[primitive].is_none() || matches!(self.along, Along::Time(..)) {
            return None;
        }
        match shape.primitives[primitive].kind {
            Kind::Peak => Some(Sense::Largest),
            Kind::Lowest => Some(Sense::Smallest),
            _ => None,
        }
    }

    /// What passes zero where a primitive is the value of a quantity, and whether the last time counts.
    pub(super) fn passage(&self, shape: &Shape, primitive: usize) -> Option<(usize, bool)> {
        match (shape.primitives[primitive].kind, self.along) {
            (Kind::Value(Moment::Passes { index, last }), Along::Driver(..)) => Some((index, last)),
            _ => None,
        }
    }
}
