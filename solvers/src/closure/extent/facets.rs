//! How measures of a way change with the constants of a linkage.
//!
//! An extreme changes to first order as the quantity does at its place, which may move. But a measure that is to be small meets
//! other places before long: those that are nearly as far out. It is therefore given by facets, one for each place at which
//! an extreme may come to lie, as if it lay there; the largest of them is the measure.
//!
//! Quantities at a place change with constants as the loops do that are kept closed. What else is found of a way, integrals and
//! such, is compared with that of linkages nearby; so is an extreme where a condition holds, unless that holds at the same places
//! whatever the constants are.

use std::collections::BTreeMap;

use assur_functions::Sense;

use super::course::{Course, Stretches};
use super::track::Along;
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::derivative::duals;
use crate::closure::linkage::loops::Answers;
use crate::scalar::{Dual, Scalar};
use crate::shape::{Kind, Moment, Shape};

/// Parts in which a way is looked through for what is no extreme.
const FEW: usize = 16;
/// Part of its range by which a constant is varied for a difference.
const STEP: f64 = 1e-6;

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
    along: Along,
    /// The constants with the widths of their ranges.
    constants: Vec<(usize, f64)>,
    measures: Vec<usize>,
    /// Of each primitive where extremes are looked for; none where that changes with the constants.
    stretches: Vec<Option<Stretches>>,
    /// Of each measure the extremes that it is given by, place by place.
    spread: Vec<Vec<usize>>,
}

/// What is known of a way.
struct Known {
    /// What is found of it.
    found: Vec<f64>,
    /// How that changes with each constant.
    slopes: Vec<Vec<f64>>,
    /// Of each extreme its value at each place.
    places: Vec<Vec<Place>>,
    /// The loops for each constant.
    loops: Vec<Box<dyn Answers<Dual>>>,
}

/// A quantity at a place.
struct Place {
    at: f64,
    value: f64,
    slopes: Vec<f64>,
}

impl Facets {
    /// Of measures, each with the sense in which it is good, along a way of a linkage. The constants stand with the widths of
    /// their ranges. Linkages that are asked about later have as many facets.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub fn new(
        linkage: &dyn AnyLinkage,
        along: Along,
        constants: Vec<(usize, f64)>,
        measures: &[(usize, Sense)],
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
        let spread =
            measures.iter().map(|(measure, sense)| facets.spread(linkage, *measure, *sense));
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
        for part in 0..=FEW {
            let (_, slopes) = course.at(from + (to - from) * (part as f64 / FEW as f64), &loops)?;
            if slopes.iter().any(|all| all[window] != 0.0) {
                return Ok(None);
            }
        }
        let holds = Walk::new(linkage, self.along)?.stretches(FEW, window)?;
        Ok((!holds.is_empty()).then(|| Stretches::of(&holds, self.along.bounds())))
    }

    /// The loops for each constant.
    fn loops(&self, linkage: &dyn AnyLinkage) -> Vec<Box<dyn Answers<Dual>>> {
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
        let all = self.measures.iter().zip(&self.spread);
        Ok(all.map(|(measure, spread)| self.of_measure(*measure, spread, &known)).collect())
    }

    fn of_measure(&self, measure: usize, spread: &[usize], known: &Known) -> Vec<Facet> {
        if spread.is_empty() {
            return vec![known.facet(measure, None)];
        }
        let each = spread.iter().flat_map(|primitive| {
            let places = known.places[*primitive].iter();
            places.map(|place| known.facet(measure, Some((*primitive, place))))
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
            let Some(sense) = self.extreme(&shape, *primitive) else {
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
    fn extreme(&self, shape: &Shape, primitive: usize) -> Option<Sense> {
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
    fn passage(&self, shape: &Shape, primitive: usize) -> Option<(usize, bool)> {
        match (shape.primitives[primitive].kind, self.along) {
            (Kind::Value(Moment::Passes { index, last }), Along::Driver(..)) => Some((index, last)),
            _ => None,
        }
    }

    fn look(&self, linkage: &dyn AnyLinkage) -> Result<Known, ClosureError> {
        let shape = linkage.shape();
        let count = shape.primitives.len();
        let mut known = Known {
            found: vec![f64::NAN; count],
            slopes: vec![vec![f64::NAN; self.constants.len()]; count],
            places: (0..count).map(|_| Vec::new()).collect(),
            loops: self.loops(linkage),
        };
        let used: Vec<usize> = (0..count)
            .filter(|index| self.measures.iter().any(|one| shape.uses[*one].contains(index)))
            .collect();
        let (extremes, others): (Vec<usize>, Vec<usize>) =
            used.iter().partition(|index| self.extreme(&shape, **index).is_some());
        let (passages, others): (Vec<usize>, Vec<usize>) =
            others.iter().partition(|index| self.passage(&shape, **index).is_some());
        let mut course = Course::new(linkage, self.along)?;
        self.look_at_extremes((linkage, &mut course), &extremes, &mut known)?;
        self.look_at_passages((linkage, &mut course), &passages, &mut known)?;
        if !others.is_empty() {
            self.compare(linkage, &others, &mut known)?;
        }
        Ok(known)
    }

    /// Finds extremes, and how quantities change at all places where they may lie.
    fn look_at_extremes(
        &self,
        (linkage, course): (&dyn AnyLinkage, &mut Course<'_>),
        extremes: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let shape = linkage.shape();
        for index in extremes {
            let primitive = &shape.primitives[*index];
            let Some((sense, stretches)) =
                self.extreme(&shape, *index).zip(self.stretches[*index].as_ref())
            else {
                continue;
            };
            let tops = course.tops(primitive.argument, stretches, sense)?;
            let mut places = Vec::with_capacity(tops.len());
            for at in tops {
                let (values, slopes) = course.at(at, &known.loops)?;
                let value = values[primitive.argument];
                let slopes = slopes.iter().map(|all| all[primitive.argument]).collect();
                places.push(Place { at, value, slopes });
            }
            let best = places.iter().reduce(|best, place| {
                if sense.better(place.value, best.value) { place } else { best }
            });
            if let Some(best) = best {
                (known.found[*index], known.slopes[*index]) = (best.value, best.slopes.clone());
            }
            known.places[*index] = places;
        }
        Ok(())
    }

    /// Finds values where something passes zero, and how they change with the place.
    fn look_at_passages(
        &self,
        (linkage, course): (&dyn AnyLinkage, &mut Course<'_>),
        passages: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let shape = linkage.shape();
        let mut places = BTreeMap::new();
        for index in passages {
            let Some((guard, is_last)) = self.passage(shape, *index) else { continue };
            let ends = match places.get(&guard) {
                Some(ends) => *ends,
                None => {
                    let ends = Walk::new(linkage, self.along)?.passages(FEW, guard)?;
                    places.insert(guard, ends);
                    ends
                }
            };
            let Some((first, last)) = ends else { continue };
            let at = if is_last { last } else { first };
            let quantity = shape.primitives[*index].argument;
            (known.found[*index], known.slopes[*index]) =
                course.passing(at, (quantity, guard), &known.loops)?;
        }
        Ok(())
    }

    /// Compares what is found with that of linkages nearby.
    fn compare(
        &self,
        linkage: &dyn AnyLinkage,
        others: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let values = linkage.values();
        let found = |values: &[f64]| -> Result<Vec<f64>, ClosureError> {
            let linkage = linkage.with_values(values);
            let found =
                Walk::new(&*linkage, self.along)?.find(FEW, &|index| others.contains(&index))?;
            Ok(found.into_iter().map(|one| one.unwrap_or(f64::NAN)).collect())
        };
        let here = found(&values)?;
        for index in others {
            known.found[*index] = here[*index];
        }
        for (column, (constant, width)) in self.constants.iter().enumerate() {
            let beside = |way: f64| {
                let mut values = values.clone();
                values[*constant] += way * STEP * width;
                found(&values)
            };
            let (behind, ahead) = (beside(-1.0)?, beside(1.0)?);
            for index in others {
                known.slopes[*index][column] =
                    (ahead[*index] - behind[*index]) / (2.0 * STEP * width);
            }
        }
        Ok(())
    }
}

impl Known {
    /// A measure, as if an extreme lay at a place.
    fn facet(&self, measure: usize, extreme: Option<(usize, &Place)>) -> Facet {
        let mut value = f64::NAN;
        let slopes = self.loops.iter().enumerate().map(|(column, loops)| {
            let all = self.found.iter().zip(&self.slopes);
            let mut found: Vec<Dual> =
                all.map(|(value, slopes)| Dual { value: *value, slope: slopes[column] }).collect();
            if let Some((index, place)) = extreme {
                found[index] = Dual { value: place.value, slope: place.slopes[column] };
            }
            let mut measures = vec![Dual::ZERO; loops.shape().measures.len()];
            loops.measures(&found, &mut measures);
            value = measures[measure].value;
            measures[measure].slope
        });
        let slopes = slopes.collect();
        Facet { at: extreme.map(|(_, place)| place.at), value, slopes }
    }
}
