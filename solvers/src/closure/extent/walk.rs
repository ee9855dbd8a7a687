//! A linkage on its way, asked for the quantities that measures look at.

use std::cell::RefCell;

use super::track::Along;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::Loops;
use crate::closure::position::guide::Moves;
use crate::hybrid::Motion;
use crate::measure::{self, Missing, Probe};
use crate::problem::Phase;

/// A linkage that goes its way.
pub(super) struct Walk<'a> {
    linkage: &'a dyn AnyLinkage,
    along: Along,
    assembly: Box<dyn Moves>,
    /// Its loops.
    pub loops: Box<dyn Loops<f64>>,
    standing: Vec<f64>,
}

impl<'a> Walk<'a> {
    /// Puts a linkage together.
    ///
    /// # Errors
    /// As [`Assembly::start`](crate::closure::Assembly::start).
    pub fn new(linkage: &'a dyn AnyLinkage, along: Along) -> Result<Self, ClosureError> {
        let mut assembly = linkage.assemble();
        assembly.guide().start()?;
        Ok(Self {
            standing: assembly.guide().independents.to_vec(),
            assembly,
            loops: linkage.prepare(&linkage.values()),
            linkage,
            along,
        })
    }

    /// The drivers at a place of the way, and behind them how they move.
    fn place(&self, at: f64) -> Result<Vec<f64>, ClosureError> {
        match self.along {
            Along::Driver(index, _) => {
                let mut place = self.standing.clone();
                place[index] = at;
                Ok(place)
            }
            Along::Time(..) => self.linkage.drive(at).ok_or_else(|| ClosureError::BadRange {
                reason: "the drivers do not move in time".to_owned(),
            }),
        }
    }

    /// Goes to a place and looks at all quantities.
    ///
    /// # Errors
    /// Why the linkage does not get there.
    pub fn look(&mut self, at: f64, values: &mut [f64]) -> Result<(), ClosureError> {
        let place = self.place(at)?;
        let (drivers, motion) = place.split_at(self.standing.len());
        self.assembly.travel(drivers)?;
        let guide = self.assembly.guide();
        match self.linkage.motion(motion) {
            [] => guide.loops.measured(guide.instant, guide.position, values),
            motion => {
                let instant = guide.loops.instant_row(drivers, motion);
                guide.loops.measured(&instant, guide.position, values);
            }
        }
        Ok(())
    }

    /// Where it stands: the drivers, and the whole position.
    pub fn stand(&mut self) -> (Vec<f64>, Vec<f64>) {
        let guide = self.assembly.guide();
        (guide.independents.to_vec(), guide.position.to_vec())
    }

    /// What measures look for, the way being looked through in so many parts; only those primitives that are wanted, the others
    /// are missing.
    ///
    /// # Errors
    /// Why the linkage does not get through it.
    pub fn find(
        &mut self,
        parts: usize,
        wanted: &dyn Fn(usize) -> bool,
    ) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
        let shape = self.linkage.shape();
        let places: Vec<usize> = (0..shape.primitives.len()).filter(|one| wanted(*one)).collect();
        let primitives: Vec<_> = places.iter().map(|place| shape.primitives[*place]).collect();
        let (found, _) = self.look_through(parts, &|motion, sample| {
            measure::find(motion, &primitives, shape.measured, sample)
        })?;
        let mut all = vec![Err(Missing::NotLookedFor); shape.primitives.len()];
        for (place, one) in places.into_iter().zip(found) {
            all[place] = one;
        }
        Ok(all)
    }

    /// The stretches of the way in which a quantity is positive, in the order in which they are gone through.
    ///
    /// # Errors
    /// Why the linkage does not get through it.
    pub fn stretches(
        &mut self,
        parts: usize,
        quantity: usize,
    ) -> Result<Vec<(f64, f64)>, ClosureError> {
        let count = self.linkage.shape().measured;
        let (found, sign) = self.look_through(parts, &|motion, sample| {
            measure::stretches(motion, quantity, count, sample)
        })?;
        Ok(found.into_iter().map(|(from, to)| (sign * from, sign * to)).collect())
    }

    /// Where a quantity passes zero on the way for the first and the last time; none where it does not.
    ///
    /// # Errors
    /// Why the linkage does not get through it.
    pub fn passages(
        &mut self,
        parts: usize,
        quantity: usize,
    ) -> Result<Option<(f64, f64)>, ClosureError> {
        let count = self.linkage.shape().measured;
        let (found, sign) = self.look_through(parts, &|motion, sample| {
            measure::passages(motion, quantity, count, sample)
        })?;
        Ok(found.map(|(first, last)| (sign * first, sign * last)))
    }

    /// Looks at the way as at a motion of so many steps; its time is the place of the driver with this sign.
    fn look_through<T>(
        &mut self,
        parts: usize,
        find: &dyn Fn(&Motion, &Probe<'_>) -> T,
    ) -> Result<(T, f64), ClosureError> {
        let (from, to) = self.along.bounds();
        // A way that is gone backwards begins where it begins.
        let sign = if from > to { -1.0 } else { 1.0 };
        let motion = Motion::without_states(0, (sign * from, sign * to), parts);
        let (walk, stopped) = (RefCell::new(self), RefCell::new(None));
        let sample = |_: Phase<'_, f64>, at: f64, _: &[f64], values: &mut [f64]| {
            // Once it does not get there all is lost, and to find out how much takes long.
            let mut stopped = stopped.borrow_mut();
            if stopped.is_none() {
                *stopped = walk.borrow_mut().look(sign * at, values).err();
            }
            if stopped.is_some() {
                values.fill(f64::NAN);
            }
        };
        let found = find(&motion, &sample);
        stopped.into_inner().map_or(Ok((found, sign)), Err)
    }
}
