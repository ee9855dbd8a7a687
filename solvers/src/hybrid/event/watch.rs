//! Looks for events in every step.

use super::crossing::Crossing;
use super::cubic::{Reading, is_resolved, larger};
use super::guard::{Guard, Portion};
use super::room::Room;
use super::rounding::terms;
use super::within::{at, between};
use crate::model::Flow;
use crate::ode::{Observer, Recorder, Step};
use crate::shape::EventEntry;
use std::ops::Range;

/// Parts of a step in which an angle turns by no more, in radians, are looked at.
const TURNED: f64 = 1.0;
/// Turns of an angle in a step, in radians, that are too many.
const MOST: f64 = 1e7;
/// Roundings of the time by which two events differ that cannot be told apart: the continuous solution has as many.
const BLUR: f64 = 64.0;

/// A guard of less than this part of the largest that it has been may be no more than the rounding of its terms, which is
/// found out then.
pub(in crate::hybrid) const NEAR: f64 = 1e-6;
/// What that length counts from one step to the next: now and then a guard is looked at again.
const FORGET: f64 = 0.997;
/// What the largest rate of a guard counts from one step to the next.
const MEMORY: f64 = 0.8;

/// An event in a step.
#[derive(Clone, Copy, Debug)]
struct Found {
    event: usize,
    crossing: Crossing,
}

impl Found {
    fn part(&self) -> f64 {
        self.crossing.at.part
    }
}

/// An event that ends an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::hybrid) struct Due {
    /// Which event of the mode.
    pub event: usize,
    /// When.
    pub time: f64,
    /// Value and rate of its guard there.
    pub guard: (f64, f64),
    /// Another one whose time cannot be told from this one's.
    pub with: Option<usize>,
}

/// An observer that records the motion in a mode, and ends it at the first event.
pub(in crate::hybrid) struct Watch<'a> {
    pub flow: &'a Flow<'a>,
    pub events: &'static [EventEntry],
    pub recorder: &'a mut Recorder,
    pub guards: &'a mut [Guard],
    /// What ended the motion.
    pub due: Option<Due>,
    /// The event whose guard is not a number.
    pub lost: Option<usize>,
    /// By how much an angle turns, if that is too far to look for events.
    pub fast: Option<f64>,
    /// The state there, or at the end of the last step.
    pub state: &'a mut [f64],
    /// The length of the last whole step.
    pub step: f64,
    /// The guards at the begin of the step, and room for others.
    pub(super) room: &'a mut Room,
    /// The number of guards and their kinks; what stands behind them are angles.
    smooth: usize,
}

impl<'a> Watch<'a> {
    /// Watches the motion from a time and state, where the guards are known: those of `room.begin`.
    pub fn new(
        flow: &'a Flow<'a>,
        events: &'static [EventEntry],
        (time, state): (f64, &'a mut [f64]),
        guards: &'a mut [Guard],
        (room, recorder): (&'a mut Room, &'a mut Recorder),
        smooth: usize,
    ) -> Self {
        recorder.restart(time, state);
        Self {
            flow,
            events,
            recorder,
            guards,
            due: None,
            lost: None,
            fast: None,
            state,
            step: 0.0,
            room,
            smooth,
        }
    }

    /// The earliest event of a step. One in which an angle turns far is looked at part by part.
    #[inline(always)]
    fn look(&mut self, step: &Step<'_>) {
        let length = step.to - step.from;
        self.step = length;
        self.room.end.look(self.flow, step.to, step.after);
        let turned = self.room.turned(self.smooth, length);
        if turned > TURNED {
            return self.look_often(step, turned);
        }
        self.look_between(step, (0.0, 1.0));
    }

    /// Looks at a step part by part.
    #[cold]
    fn look_often(&mut self, step: &Step<'_>, turned: f64) {
        if turned > MOST {
            self.fast = Some(turned);
            return self.pass(step);
        }
        let count = (turned / TURNED).ceil();
        let length = step.to - step.from;
        std::mem::swap(&mut self.room.end, &mut self.room.last);
        let mut from = 0.0;
        while from < 1.0 && self.due.is_none() && self.lost.is_none() {
            let to = ((from * count).round() + 1.0) / count;
            if to < 1.0 {
                between(step, to, self.state);
                let time = step.from + to * length;
                self.room.end.look(self.flow, time, self.state);
            } else {
                std::mem::swap(&mut self.room.end, &mut self.room.last);
            }
            self.look_between(step, (from, to.min(1.0)));
            from = to;
        }
    }

    /// The earliest event of a part of a step.
    #[inline(never)]
    fn look_between(&mut self, step: &Step<'_>, part: (f64, f64)) {
        let length = step.to - step.from;
        let mut way = Portion {
            length,
            part,
            // Which is first of two that cannot be told apart is said by their order in the file.
            blur: BLUR * f64::EPSILON * (step.to / length).abs().max(1.0),
            is_measured: false,
        };
        let count = self.events.len();
        let strange = |event: &usize| !self.room.end.values()[*event].is_finite();
        self.lost = (0..count).find(strange);
        if self.lost.is_some() {
            return self.pass(step);
        }
        self.room.bends.clear();
        self.room.seen.clear();
        for kink in count..self.smooth {
            self.bend(step, &way, kink);
        }
        let surfaces = self.events.iter().filter(|entry| entry.surface.is_some());
        let own = count - surfaces.count();
        let surface = self.earliest(step, &mut way, own..count, None).0;
        if let Some(Found { crossing, .. }) = surface {
            self.room.bends.push((crossing.before, crossing.at.part));
        }
        self.room.bends.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let limit = surface.map(|found| found.part());
        let (event, second) = self.earliest(step, &mut way, 0..own, limit);
        let (first, second) = match (event, surface) {
            (Some(event), Some(surface)) if event.part() > surface.part() + way.blur => {
                (Some(surface), None)
            }
            (Some(event), Some(surface)) if event.part() >= surface.part() - way.blur => {
                (Some(event), second.or(Some(surface.event)))
            }
            (None, _) => (surface, None),
            _ => (event, second),
        };
        match first {
            Some(Found { event, crossing }) => {
                let Reading { part, value, slope } = crossing.at;
                let time = step.from + part * length;
                between(step, part, self.state);
                self.recorder.cut(time, self.state);
                self.due = Some(Due { event, time, guard: (value, slope / length), with: second });
            }
            None => self.pass(step),
        }
    }

    /// Nothing has happened in a step.
    #[inline(always)]
    fn pass(&mut self, step: &Step<'_>) {
        self.state.copy_from_slice(step.after);
        std::mem::swap(&mut self.room.begin, &mut self.room.end);
    }

    /// The earliest of some events in a step, up to a part of it, and the one that cannot be told apart from it.
    #[inline(never)]
    fn earliest(
        &mut self,
        step: &Step<'_>,
        way: &mut Portion,
        events: Range<usize>,
        limit: Option<f64>,
    ) -> (Option<Found>, Option<usize>) {
        let length = way.length;
        let mut first: Option<Found> = None;
        let mut second: Option<usize> = None;
        let is_smooth = self.room.bends.is_empty();
        for event in events {
            let from = at(&self.room.begin, event, way.part.0, length);
            let to = at(&self.room.end, event, way.part.1, length);
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
            guard.rate *= MEMORY;
            let slope = larger(to.slope.abs(), guard.rate * length);
            let slope = larger(from.slope.abs(), slope);
            guard.rate = slope / length;
            guard.looked *= FORGET;
            let rough = is_smooth && !is_resolved(&from, &to, slope);
            let wary = rough || way.is_unknown(guard, way.part.1 - way.part.0);
            if !wary && is_smooth && guard.is_far(&from, &to) {
                continue;
            }
            // What an event begins with has been measured at the end of the step before, or where the mode began; a surface
            // that has just been passed has not.
            let least = match self.events[event].surface {
                Some(_) => from.value.abs().min(to.value.abs()),
                None => to.value.abs(),
            };
            if !way.is_measured && least <= NEAR * guard.size {
                way.is_measured = true;
                self.measure(step, way.part.1);
            }
            let until = match first {
                Some(found) => Some(found.part() + 2.0 * way.blur),
                None => limit.map(|part| part + 2.0 * way.blur),
            };
            let Some(crossing) = self.search(step, way, event, (from, to), rough, until) else {
                continue;
            };
            let found = Found { event, crossing };
            match first {
                Some(earlier) if found.part() > earlier.part() + way.blur => {}
                Some(earlier) if found.part() >= earlier.part() - way.blur => {
                    second = second.or(Some(event));
                }
                _ => (first, second) = (Some(found), None),
            }
        }
        (first, second)
    }

    /// Finds out how large the terms of the guards are at the end of a part of a step.
    #[cold]
    fn measure(&mut self, step: &Step<'_>, part: f64) {
        let Room { end, there, terms: sizes, .. } = &mut *self.room;
        between(step, part, self.state);
        let time = step.from + part * (step.to - step.from);
        terms(self.flow, time, self.state, end, there, sizes);
        for (guard, size) in self.guards.iter_mut().zip(sizes.values()) {
            guard.size = guard.size.max(*size);
        }
    }
}

impl Observer for Watch<'_> {
    #[inline(always)]
    fn wants_dense(&mut self, _from: f64, _to: f64) -> bool {
        true
    }

    #[inline(always)]
    fn step(&mut self, step: &Step<'_>) {
        self.recorder.step(step);
        self.look(step);
    }

    #[inline(always)]
    fn has_enough(&self) -> bool {
        self.due.is_some() || self.lost.is_some() || self.fast.is_some()
    }
}
