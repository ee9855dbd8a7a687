//! Where a mode begins: the signs of its guards, and the sides of its switching surfaces.

use super::end::End;
use crate::hybrid::NOISE;
use crate::hybrid::event::room::Room;
use crate::hybrid::event::rounding::terms;
use crate::hybrid::event::watch::NEAR;
use crate::hybrid::numbers::Numbers;
use crate::hybrid::run::Run;
use crate::shape::EventEntry;

/// Part of the rate with which a guard passed zero that counts as none after the event.
const STOPPED: f64 = 1e-9;

impl Run<'_> {
    /// Notes the signs of the guards where a mode begins. Gives the event that happens there at once: its guard is zero
    /// and passes, or it has happened together with the last one.
    pub(super) fn begin(
        &mut self,
        time: f64,
        events: &[EventEntry],
        last: Option<u32>,
        with: Option<u32>,
    ) -> Result<Option<usize>, End> {
        self.look(time);
        self.is_known = false;
        std::mem::swap(&mut self.room.begin, &mut self.room.here);
        let Room { begin, there, terms: sizes, .. } = &mut self.room;
        let strange = |event: &usize| !begin.values()[*event].is_finite();
        if let Some(event) = (0..events.len()).find(strange) {
            return Err(End::Guard(event));
        }
        // Only a small guard may be no more than the rounding of its terms.
        let is_small = |(event, entry): (usize, &EventEntry)| {
            let size = self.guards[event].size;
            entry.surface.is_none() && begin.values()[event].abs() <= NEAR * size || size == 0.0
        };
        match events.iter().enumerate().any(is_small) {
            true => terms(&self.flow, time, &self.state, begin, there, sizes),
            false => sizes.clear(),
        }
        let mut due = None;
        for (event, entry) in events.iter().enumerate() {
            let (value, rate) = (begin.values()[event], begin.rates()[event]);
            // A rate that is no more than its rounding does not say where the guard goes.
            let is_still = rate.abs() <= NOISE * f64::EPSILON * sizes.rates()[event];
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(value.abs()).max(sizes.values()[event]);
            // The time is known to a rounding, and so is the guard.
            let blur = 4.0 * f64::EPSILON * (rate * time).abs();
            let is_zero = value.abs() <= guard.noise().max(blur);
            guard.began = is_zero.then_some(time);
            if let Some(surface) = entry.surface {
                (guard.sign, guard.armed) = (self.sides[surface], true);
                continue;
            }
            // An event that has just happened has to come back first, unless it has stopped its guard: what pushes that
            // across again makes it happen again.
            let is_stopped = is_still && rate.abs() <= STOPPED * self.arrival.abs();
            guard.armed = last != Some(entry.line) || is_stopped;
            guard.sign = match (is_zero, is_still) {
                (false, _) => value.signum(),
                (true, false) => rate.signum(),
                (true, true) => 0.0,
            };
            let passes = is_zero && !is_still && entry.direction.allows(rate > 0.0)
                || with == Some(entry.line);
            guard.still = (time, if is_still { sizes.rates()[event] } else { 0.0 });
            if passes && guard.armed && due.is_none() {
                let is_permitted =
                    !entry.conditional || self.flow.permits(event, time, &self.state);
                due = is_permitted.then_some(event);
            }
        }
        let kinks = events.len()..self.shape.modes[self.flow.mode()].guards();
        for (guard, value) in self.guards[kinks.clone()].iter_mut().zip(&begin.values()[kinks]) {
            guard.size = guard.size.max(value.abs());
            guard.sign = match value.abs() <= guard.noise() {
                false => value.signum(),
                true => 0.0,
            };
            guard.armed = false;
        }
        Ok(due)
    }

    /// Chooses the side of every switching surface where a mode begins, or where the state has jumped.
    pub(super) fn settle(&mut self, time: f64) -> Result<(), End> {
        let events = self.shape.modes[self.flow.mode()].events;
        for surface in events.iter().filter_map(|entry| entry.surface) {
            self.put(surface, 0.0);
        }
        for (event, entry) in events.iter().enumerate() {
            let Some(surface) = entry.surface else {
                continue;
            };
            let (value, _) = self.guard(time, event);
            let size = self.guards[event].size.max(value.abs());
            let is_zero = value.abs() <= NOISE * f64::EPSILON * size;
            let side = match is_zero {
                false => value.signum(),
                true => self.leaving(time, event, surface)?,
            };
            self.put(surface, side);
        }
        Ok(())
    }

    /// The sides of the switching surfaces of this mode.
    pub(super) fn sides_here(&self, events: &[EventEntry]) -> Numbers {
        let surfaces = events.iter().filter(|entry| entry.surface.is_some());
        Numbers::new(&self.sides[..surfaces.count()])
    }

    /// Puts the motion on a side of a switching surface.
    pub(super) fn put(&mut self, surface: usize, side: f64) {
        self.is_known &= self.sides[surface] == side;
        self.sides[surface] = side;
        self.flow.put(surface, side);
    }

    /// The side to which a motion leaves a switching surface on which it is.
    pub(super) fn leaving(&mut self, time: f64, event: usize, surface: usize) -> Result<f64, End> {
        for side in [1.0, -1.0] {
            self.put(surface, side);
            if self.guard(time, event).1 * side >= 0.0 {
                return Ok(side);
            }
        }
        Err(End::Held(event))
    }

    /// Value and rate of a guard here.
    pub(super) fn guard(&mut self, time: f64, event: usize) -> (f64, f64) {
        self.look(time);
        let here = &self.room.here;
        (here.values()[event], here.rates()[event])
    }

    /// Computes the guards here, unless they are known.
    fn look(&mut self, time: f64) {
        if !self.is_known {
            let here = &mut self.room.here;
            here.look(&self.flow, time, &self.state);
            self.is_known = true;
        }
    }
}
