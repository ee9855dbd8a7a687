//! How measures of a way change with the constants of a linkage.
//!
//! An extreme changes to first order as the quantity does at its place, which may move. But a measure that is to be small meets
//! other places before long: those that are nearly as far out. It is therefore given by facets, one for each place at which
//! an extreme may come to lie, as if it lay there; the largest of them is the measure.
//!
//! Quantities at a place change with constants as the loops do that are kept closed, see [`keep_closed`]. What else is found of a
//! way, integrals and such, is compared with that of linkages nearby.

use std::collections::HashMap;

use assur_functions::{Sense, top};

use super::track::Along;
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::derivative::{duals, keep_closed};
use crate::closure::linkage::loops::{Answers, instant_at};
use crate::scalar::{Dual, Scalar};
use crate::shape::{Kind, Primitive};

/// Parts of a way, in each of which an extreme may lie.
const PARTS: usize = 128;
/// Hills that are lower than the highest by more than this part of all that a quantity goes through are not climbed.
const FAR: f64 = 0.5;
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
    pub fn new(
        linkage: &dyn AnyLinkage,
        along: Along,
        constants: Vec<(usize, f64)>,
        measures: &[(usize, Sense)],
    ) -> Self {
        let mut facets = Self {
            along,
            constants,
            measures: measures.iter().map(|one| one.0).collect(),
            spread: Vec::new(),
        };
        let spread =
            measures.iter().map(|(measure, sense)| facets.spread(linkage, *measure, *sense));
        facets.spread = spread.collect();
        facets
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
            let Some(sense) = self.extreme(&shape.primitives[*primitive]) else {
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
    fn extreme(&self, primitive: &Primitive) -> Option<Sense> {
        match primitive.kind {
            _ if primitive.window.is_some() || matches!(self.along, Along::Time(..)) => None,
            Kind::Peak => Some(Sense::Largest),
            Kind::Lowest => Some(Sense::Smallest),
            _ => None,
        }
    }

    fn look(&self, linkage: &dyn AnyLinkage) -> Result<Known, ClosureError> {
        let (shape, values) = (linkage.shape(), linkage.values());
        let count = shape.primitives.len();
        let mut known = Known {
            found: vec![f64::NAN; count],
            slopes: vec![vec![f64::NAN; self.constants.len()]; count],
            places: (0..count).map(|_| Vec::new()).collect(),
            loops: self
                .constants
                .iter()
                .map(|(constant, _)| linkage.differentiate(&duals(&values, Some(*constant))))
                .collect(),
        };
        let used: Vec<usize> = (0..count)
            .filter(|index| self.measures.iter().any(|one| shape.uses[*one].contains(index)))
            .collect();
        let (extremes, others): (Vec<usize>, Vec<usize>) =
            used.iter().partition(|index| self.extreme(&shape.primitives[**index]).is_some());
        if !extremes.is_empty() {
            self.look_at_extremes(linkage, &extremes, &mut known)?;
        }
        if !others.is_empty() {
            self.compare(linkage, &others, &mut known)?;
        }
        Ok(known)
    }

    /// Finds extremes, and how quantities change at all places where they may lie.
    fn look_at_extremes(
        &self,
        linkage: &dyn AnyLinkage,
        extremes: &[usize],
        known: &mut Known,
    ) -> Result<(), ClosureError> {
        let shape = linkage.shape();
        let mut course = Course::new(linkage, self.along)?;
        for index in extremes {
            let primitive = &shape.primitives[*index];
            let sense = self.extreme(primitive).unwrap_or(Sense::Largest);
            let tops = course.tops(primitive.argument, sense)?;
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

/// The quantities at places of the way, and how they change there with each constant.
type There = (Vec<f64>, Vec<Vec<f64>>);

/// A linkage gone through its way.
struct Course<'a> {
    walk: Walk<'a>,
    /// The ends of its parts.
    ends: Vec<f64>,
    /// All quantities there.
    values: Vec<Vec<f64>>,
    /// What has been looked at closely, by the bits of the place.
    known: HashMap<u64, There>,
}

impl<'a> Course<'a> {
    fn new(linkage: &'a dyn AnyLinkage, along: Along) -> Result<Self, ClosureError> {
        let mut walk = Walk::new(linkage, along)?;
        let (from, to) = along.bounds();
        let ends: Vec<f64> =
            (0..=PARTS).map(|k| from + (to - from) * (k as f64 / PARTS as f64)).collect();
        let mut values = Vec::with_capacity(ends.len());
        for at in &ends {
            let mut there = vec![0.0; linkage.shape().measured];
            walk.look(*at, &mut there)?;
            values.push(there);
        }
        Ok(Self { walk, ends, values, known: HashMap::new() })
    }

    /// For each part the place where a quantity is furthest out. As constants change, a place that leaves a part by its end stays
    /// there, and the next part takes it on from there: neither values nor slopes jump, but for slopes in a valley, where the two
    /// ends of a part take turns.
    fn tops(&mut self, index: usize, sense: Sense) -> Result<Vec<f64>, ClosureError> {
        let value = |k: usize| self.values[k][index];
        let further = |k: usize| if sense.better(value(k + 1), value(k)) { k + 1 } else { k };
        let mut tops: Vec<f64> = (0..PARTS).map(|k| self.ends[further(k)]).collect();
        let mut there = vec![0.0; self.values[0].len()];
        // What is far from the extreme does not come to be it in linkages nearby.
        let all = (0..=PARTS).map(value);
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let is_far = |value: f64| match sense {
            Sense::Largest => high - value > FAR * (high - low),
            Sense::Smallest => value - low > FAR * (high - low),
        };
        for k in 0..=PARTS {
            let (before, after) = (k.saturating_sub(1), (k + 1).min(PARTS));
            let value = |k: usize| self.values[k][index];
            let is_further = |other: usize| sense.better(value(other), value(k));
            let is_flat = value(before) == value(k) && value(after) == value(k);
            if is_further(before) || is_further(after) || is_flat || is_far(value(k)) {
                continue;
            }
            let (low, high) = (self.ends[before], self.ends[after]);
            let mut stopped = None;
            let mut at = |place: f64| match self.walk.look(place, &mut there) {
                Ok(()) => there[index],
                Err(error) => {
                    stopped.get_or_insert(error);
                    f64::NAN
                }
            };
            let found = top(sense, (low.min(high), low.max(high)), &mut at).place;
            if let Some(error) = stopped {
                return Err(error);
            }
            let is_before = (found - self.ends[k]) * (self.ends[after] - self.ends[before]) < 0.0;
            tops[if is_before { before } else { k.min(PARTS - 1) }] = found;
        }
        Ok(tops)
    }

    /// The quantities at a place, and how they change there.
    fn at(&mut self, at: f64, loops: &[Box<dyn Answers<Dual>>]) -> Result<There, ClosureError> {
        if let Some(known) = self.known.get(&at.to_bits()) {
            return Ok(known.clone());
        }
        let mut values = vec![0.0; self.values[0].len()];
        self.walk.look(at, &mut values)?;
        let (drivers, stand) = self.walk.stand();
        let drivers = duals(&drivers, None);
        let slopes = loops.iter().map(|loops| {
            let instant = instant_at(&**loops, &drivers, &[]);
            let mut position = duals(&stand, None);
            let mut there = vec![Dual::ZERO; values.len()];
            match keep_closed(&**loops, &instant, &mut position) {
                Ok(()) => loops.measured(&instant, &position, &mut there),
                Err(_) => there.fill(Dual::constant(f64::NAN)),
            }
            // Where there is no derivative it is not zero.
            there.iter().map(|one| if one.value.is_nan() { f64::NAN } else { one.slope }).collect()
        });
        let slopes = slopes.collect();
        let there = (values, slopes);
        self.known.insert(at.to_bits(), there.clone());
        Ok(there)
    }
}
