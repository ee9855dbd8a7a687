//! A linkage gone through its way: where quantities are furthest out, and how they change there with the constants.

use std::collections::HashMap;

use assur_functions::{Sense, top};

use super::track::Along;
use super::walk::Walk;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::derivative::{duals, keep_closed};
use crate::closure::linkage::loops::Answers;
use crate::scalar::{Dual, Scalar};

/// Parts of a whole way, in each of which an extreme may lie.
const PARTS: f64 = 128.0;
/// Parts of a stretch of it at least.
const LEAST: f64 = 8.0;
/// Hills that are lower than the highest by more than this part of all that a quantity goes through are not climbed.
const FAR: f64 = 0.5;

/// Stretches of a way, each by the ends of its parts.
#[derive(Clone, Debug)]
pub(super) struct Stretches(Vec<Vec<f64>>);

impl Stretches {
    /// The whole way.
    pub fn everywhere(way: (f64, f64)) -> Self {
        Self::of(&[way], way)
    }

    /// Some stretches of a way.
    pub fn of(stretches: &[(f64, f64)], way: (f64, f64)) -> Self {
        let parts = |(from, to): &(f64, f64)| {
            let share = (to - from) / (way.1 - way.0);
            let count = (PARTS * share).round().max(LEAST);
            (0..=count as usize).map(|k| from + (to - from) * (k as f64 / count)).collect()
        };
        Self(stretches.iter().map(parts).collect())
    }
}

/// The quantities at a place of the way, and how they change there with each constant.
type There = (Vec<f64>, Vec<Vec<f64>>);

/// A linkage that goes its way.
pub(super) struct Course<'a> {
    linkage: &'a dyn AnyLinkage,
    along: Along,
    walk: Walk<'a>,
    /// Number of quantities.
    count: usize,
    /// What has been looked at, by the bits of the place.
    seen: HashMap<u64, Vec<f64>>,
    /// What has been looked at closely.
    known: HashMap<u64, There>,
}

impl<'a> Course<'a> {
    /// Puts a linkage together.
    ///
    /// # Errors
    /// Why it cannot be.
    pub fn new(linkage: &'a dyn AnyLinkage, along: Along) -> Result<Self, ClosureError> {
        let count = linkage.shape().measured;
        let walk = Walk::new(linkage, along)?;
        Ok(Self { linkage, along, walk, count, seen: HashMap::new(), known: HashMap::new() })
    }

    /// A quantity at a place.
    fn value(&mut self, at: f64, quantity: usize) -> Result<f64, ClosureError> {
        if let Some(seen) = self.seen.get(&at.to_bits()) {
            return Ok(seen[quantity]);
        }
        let mut there = vec![0.0; self.count];
        self.walk.look(at, &mut there)?;
        let value = there[quantity];
        self.seen.insert(at.to_bits(), there);
        Ok(value)
    }

    /// For each part of some stretches the place where a quantity is furthest out. As constants change, a place that leaves a part
    /// by its end stays there, and the next part takes it on from there: neither values nor slopes jump, but for slopes in a
    /// valley, where the two ends of a part take turns.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub fn tops(
        &mut self,
        quantity: usize,
        stretches: &Stretches,
        sense: Sense,
    ) -> Result<Vec<f64>, ClosureError> {
        let mut all = Vec::with_capacity(stretches.0.len());
        for ends in &stretches.0 {
            let values = ends.iter().map(|at| self.value(*at, quantity));
            all.push(values.collect::<Result<Vec<f64>, _>>()?);
        }
        // What is far from the extreme does not come to be it in linkages nearby.
        let each = all.iter().flatten();
        let (low, high) = each.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(*value), high.max(*value))
        });
        let is_far = |value: f64| match sense {
            Sense::Largest => high - value > FAR * (high - low),
            Sense::Smallest => value - low > FAR * (high - low),
        };
        let mut tops = Vec::new();
        for (ends, values) in stretches.0.iter().zip(&all) {
            let first = tops.len();
            let further = |k: usize| {
                if sense.better(values[k + 1], values[k]) { k + 1 } else { k }
            };
            let last = ends.len() - 1;
            tops.extend((0..last).map(|k| ends[further(k)]));
            for k in 0..=last {
                let (before, after) = (k.saturating_sub(1), (k + 1).min(last));
                let is_further = |other: usize| sense.better(values[other], values[k]);
                let is_flat = values[before] == values[k] && values[after] == values[k];
                if is_further(before) || is_further(after) || is_flat || is_far(values[k]) {
                    continue;
                }
                let found = self.climb(quantity, (ends[before], ends[after]), sense)?;
                let is_before = (found - ends[k]) * (ends[after] - ends[before]) < 0.0;
                tops[first + if is_before { before } else { k.min(last - 1) }] = found;
            }
        }
        Ok(tops)
    }

    /// The place between two others where a quantity is furthest out.
    fn climb(
        &mut self,
        quantity: usize,
        (low, high): (f64, f64),
        sense: Sense,
    ) -> Result<f64, ClosureError> {
        let (mut stopped, mut there) = (None, vec![0.0; self.count]);
        let mut at = |place: f64| match self.walk.look(place, &mut there) {
            Ok(()) => there[quantity],
            Err(error) => {
                stopped.get_or_insert(error);
                f64::NAN
            }
        };
        let found = top(sense, (low.min(high), low.max(high)), &mut at).place;
        stopped.map_or(Ok(found), Err)
    }

    /// The value of a quantity where another passes zero, and how it changes with each constant: as the quantity does there, and with
    /// the place.
    ///
    /// # Errors
    /// Why the linkage does not get there.
    pub fn passing(
        &mut self,
        at: f64,
        (quantity, guard): (usize, usize),
        loops: &[Box<dyn Answers<Dual>>],
    ) -> Result<(f64, Vec<f64>), ClosureError> {
        let (values, slopes) = self.at(at, loops)?;
        let mut there = vec![0.0; self.count];
        self.walk.look(at, &mut there)?;
        let (drivers, stand) = self.walk.stand();
        let Along::Driver(driver, _) = self.along else {
            return Ok((values[quantity], vec![f64::NAN; loops.len()]));
        };
        let still = self.linkage.differentiate(&duals(&self.linkage.values(), None));
        let along = changes(&*still, &duals(&drivers, Some(driver)), &stand, self.count);
        let moved = |own: &Vec<f64>| own[quantity] - along[quantity] * own[guard] / along[guard];
        Ok((values[quantity], slopes.iter().map(moved).collect()))
    }

    /// The quantities at a place, and how they change there.
    ///
    /// # Errors
    /// Why the linkage does not get there.
    pub fn at(&mut self, at: f64, loops: &[Box<dyn Answers<Dual>>]) -> Result<There, ClosureError> {
        if let Some(known) = self.known.get(&at.to_bits()) {
            return Ok(known.clone());
        }
        let mut values = vec![0.0; self.count];
        self.walk.look(at, &mut values)?;
        let (drivers, stand) = self.walk.stand();
        let drivers = duals(&drivers, None);
        let slopes = loops.iter().map(|loops| changes(&**loops, &drivers, &stand, values.len()));
        let slopes = slopes.collect();
        let there = (values, slopes);
        self.known.insert(at.to_bits(), there.clone());
        Ok(there)
    }
}

/// How so many quantities change at a position with what the drivers, or the loops, are differentiated by.
fn changes(loops: &dyn Answers<Dual>, drivers: &[Dual], stand: &[f64], count: usize) -> Vec<f64> {
    let instant = loops.instant_row(drivers, &[]);
    let mut position = duals(stand, None);
    let mut there = vec![Dual::ZERO; count];
    match keep_closed(loops, &instant, &mut position) {
        Ok(()) => loops.measured(&instant, &position, &mut there),
        Err(_) => there.fill(Dual::constant(f64::NAN)),
    }
    // Where there is no derivative it is not zero.
    there.iter().map(|one| if one.value.is_nan() { f64::NAN } else { one.slope }).collect()
}
