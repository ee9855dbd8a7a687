//! Looks for events in every step.

use super::NOISE;
use super::crossing::{Crossing, Sample, Search, is_far, is_resolved};
use super::problem::{Direction, EventEntry, Modes};
use super::room::{Guards, Room, Seen};
use super::rounding::terms;
use crate::ode::{Observer, Recorder, Step};
use crate::problem::Storage;
use std::ops::Range;

/// Roundings of the time by which two events differ that cannot be told apart: the continuous solution has as many.
const BLUR: f64 = 64.0;

/// A guard of less than this part of the largest that it has been may be no more than the rounding of its terms, which is
/// found out then.
pub(super) const NEAR: f64 = 1e-6;
/// A step in which a driver turns by more, in radians, is looked into.
const TURNED: f64 = 1.0;
/// A step that is longer by this than any in which a guard has been looked at is looked into.
const LONGER: f64 = 1.25;
/// What that length counts from one step to the next: now and then a guard is looked at again.
const FORGET: f64 = 0.997;
/// Bends of guards in a step that are told apart. More are found as what they are to a guard.
const BENDS: usize = 4;
/// What the largest rate of a guard counts from one step to the next.
const MEMORY: f64 = 0.8;

/// What is remembered of a guard.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Guard {
    /// Sign so far, 0 while it has been zero since the mode began.
    pub sign: f64,
    /// Whether leaving zero counts as passing it.
    pub armed: bool,
    /// The largest of its values and terms.
    pub size: f64,
    /// The time at which the mode began, and the terms of the rate there if the rate was no more than their rounding: as
    /// long as the guard has been zero, that rounding times the time since then is zero too.
    pub still: (f64, f64),
    /// The largest rate in the last steps; older ones count less.
    pub rate: f64,
    /// The length of the longest step within which it has been looked at and was what the ends of the step say. Older ones
    /// count less.
    pub looked: f64,
}

impl Guard {
    /// Values up to this count as zero.
    pub fn noise(&self) -> f64 {
        NOISE * f64::EPSILON * self.size
    }

    /// Values up to this at a time count as zero.
    pub fn noise_at(&self, time: f64) -> f64 {
        let (since, rate) = self.still;
        match self.sign == 0.0 {
            true => self.noise() + NOISE * f64::EPSILON * rate * (time - since),
            false => self.noise(),
        }
    }

    /// Whether the guard stays away from zero between the ends of a step by more than it changes.
    fn is_far(&self, from: &Sample, to: &Sample) -> bool {
        let keeps = |sample: &Sample| sample.value * self.sign > self.noise();
        self.sign != 0.0 && keeps(from) && keeps(to) && is_far(from, to)
    }
}

/// How far a step goes.
struct Way {
    length: f64,
    /// By how much the drivers that are angles turn.
    turned: f64,
    /// Parts of the step by which two events differ that cannot be told apart.
    blur: f64,
    /// Whether the terms of the guards have been found out.
    is_measured: bool,
}

impl Way {
    /// Whether so large a part of the step is more than is known of a guard, or than one may trust.
    #[inline(always)]
    fn is_unknown(&self, guard: &Guard, part: f64) -> bool {
        self.length * part > LONGER * guard.looked || self.turned * part > TURNED
    }
}

/// An event in a step.
#[derive(Clone, Copy, Debug)]
struct Found {
    event: usize,
    part: f64,
    /// The last part before it.
    before: f64,
}

/// An event that ends an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Due {
    /// Which event of the mode.
    pub event: usize,
    /// When.
    pub time: f64,
    /// Another one whose time cannot be told from this one's.
    pub with: Option<usize>,
}

/// An observer that records the motion in a mode, and ends it at the first event.
pub(super) struct Watch<'a, E: Modes<f64>> {
    pub equations: &'a E,
    pub events: &'static [EventEntry],
    pub recorder: Recorder<f64>,
    pub guards: &'a mut [Guard],
    /// What ended the motion.
    pub due: Option<Due>,
    /// The event whose guard is not a number.
    pub lost: Option<usize>,
    /// The state there, or at the end of the last step.
    pub state: E::State,
    /// The length of the last whole step.
    pub step: f64,
    /// The guards at the begin of the step, and room for others.
    room: &'a mut Room,
    /// The drivers that are angles.
    angles: &'static [usize],
}

impl<'a, E: Modes<f64>> Watch<'a, E> {
    /// Watches the motion from a time and state, where the guards are known: those of `room.begin`.
    pub fn new(
        equations: &'a E,
        events: &'static [EventEntry],
        (time, state): (f64, &E::State),
        guards: &'a mut [Guard],
        room: &'a mut Room,
        angles: &'static [usize],
    ) -> Self {
        // Where the drivers are now is where the first step begins.
        room.turned(equations, time, angles);
        Self {
            equations,
            events,
            recorder: Recorder::new(time, state),
            guards,
            due: None,
            lost: None,
            state: state.clone(),
            step: 0.0,
            room,
            angles,
        }
    }

    /// The earliest event of a step.
    #[inline(always)]
    fn look(&mut self, step: &Step<'_, E::State>) {
        let length = step.to - step.from;
        self.step = length;
        self.room.end.look(self.equations, step.to, step.after);
        let turned = self.room.turned(self.equations, step.to, self.angles);
        let mut way = Way {
            length,
            turned,
            // Which is first of two that cannot be told apart is said by their order in the file.
            blur: BLUR * f64::EPSILON * (step.to / length).abs().max(1.0),
            is_measured: false,
        };
        let count = self.events.len();
        let strange = |event: &usize| !self.room.end.values[*event].is_finite();
        self.lost = (0..count).find(strange);
        if self.lost.is_some() {
            return self.pass(step);
        }
        self.room.bends.clear();
        self.room.seen.clear();
        for kink in count..self.room.end.values.len() {
            self.bend(step, &way, kink);
        }
        let surfaces = self.events.iter().filter(|entry| entry.surface.is_some());
        let own = count - surfaces.count();
        let surface = self.earliest(step, &mut way, own..count, None).0;
        if let Some(crossing) = surface {
            self.room.bends.push((crossing.before, crossing.part));
        }
        self.room.bends.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let limit = surface.map(|crossing| crossing.part);
        let (event, second) = self.earliest(step, &mut way, 0..own, limit);
        let (first, second) = match (event, surface) {
            (Some(event), Some(surface)) if event.part > surface.part + way.blur => {
                (Some(surface), None)
            }
            (Some(event), Some(surface)) if event.part >= surface.part - way.blur => {
                (Some(event), second.or(Some(surface.event)))
            }
            (None, _) => (surface, None),
            _ => (event, second),
        };
        match first {
            Some(Found { event, part, .. }) => {
                let time = step.from + part * length;
                between(step, part, &mut self.state);
                self.recorder.cut(time, &self.state);
                self.due = Some(Due {
                    event,
                    time,
                    with: second,
                });
            }
            None => self.pass(step),
        }
    }

    /// Nothing has happened in a step.
    #[inline(always)]
    fn pass(&mut self, step: &Step<'_, E::State>) {
        self.state.clone_from(step.after);
        std::mem::swap(&mut self.room.begin, &mut self.room.end);
    }

    /// The earliest of some events in a step, up to a part of it, and the one that cannot be told apart from it.
    #[inline(always)]
    fn earliest(
        &mut self,
        step: &Step<'_, E::State>,
        way: &mut Way,
        events: Range<usize>,
        limit: Option<f64>,
    ) -> (Option<Found>, Option<usize>) {
        let length = way.length;
        let mut first: Option<Found> = None;
        let mut second: Option<usize> = None;
        let is_smooth = self.room.bends.is_empty();
        for event in events {
            let from = at(&self.room.begin, event, 0.0, length);
            let to = at(&self.room.end, event, 1.0, length);
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
            guard.rate *= MEMORY;
            let slope = (guard.rate * length)
                .max(from.slope.abs())
                .max(to.slope.abs());
            guard.rate = slope / length;
            guard.looked *= FORGET;
            let rough = is_smooth && !is_resolved(&from, &to, slope);
            let wary = rough || way.is_unknown(guard, 1.0);
            if !wary && is_smooth && guard.is_far(&from, &to) {
                continue;
            }
            if !way.is_measured && from.value.abs().min(to.value.abs()) <= NEAR * guard.size {
                way.is_measured = true;
                self.measure(step);
            }
            let until = match first {
                Some(found) => Some(found.part + 2.0 * way.blur),
                None => limit.map(|part| part + 2.0 * way.blur),
            };
            let Some(crossing) = self.search(step, way, event, (from, to), rough, until) else {
                continue;
            };
            let found = Found {
                event,
                part: crossing.part,
                before: crossing.before,
            };
            match first {
                Some(earlier) if found.part > earlier.part + way.blur => {}
                Some(earlier) if found.part >= earlier.part - way.blur => {
                    second = second.or(Some(event));
                }
                _ => (first, second) = (Some(found), None),
            }
        }
        (first, second)
    }

    /// Finds out how large the terms of the guards are at the end of a step.
    #[cold]
    fn measure(&mut self, step: &Step<'_, E::State>) {
        let Room {
            end,
            there,
            terms: sizes,
            ..
        } = &mut *self.room;
        terms(self.equations, step.to, step.after, end, there, sizes);
        for (guard, size) in self.guards.iter_mut().zip(&sizes.values) {
            guard.size = guard.size.max(*size);
        }
    }

    /// Notes where a kink lies in a step.
    #[inline(always)]
    fn bend(&mut self, step: &Step<'_, E::State>, way: &Way, kink: usize) {
        let length = step.to - step.from;
        let mut from = at(&self.room.begin, kink, 0.0, length);
        let to = at(&self.room.end, kink, 1.0, length);
        let guard = &mut self.guards[kink];
        guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
        if guard.is_far(&from, &to) {
            return;
        }
        while self.room.bends.len() < BENDS {
            let Some(crossing) = self.search(step, way, kink, (from, to), false, None) else {
                break;
            };
            self.room.bends.push((crossing.before, crossing.part));
            let Room { there, seen, .. } = &mut *self.room;
            from = look_at(
                self.equations,
                step,
                &mut self.state,
                (there, seen),
                (kink, crossing.part),
            );
        }
    }

    /// Where an event happens first in a step, up to a part of it. From bend to bend its guard is smooth.
    fn search(
        &mut self,
        step: &Step<'_, E::State>,
        way: &Way,
        event: usize,
        (from, to): (Sample, Sample),
        rough: bool,
        until: Option<f64>,
    ) -> Option<Crossing> {
        let length = step.to - step.from;
        let guard = &mut self.guards[event];
        let (equations, state) = (self.equations, &mut self.state);
        let Room {
            there, seen, bends, ..
        } = &mut *self.room;
        let mut sample = |part: f64| look_at(equations, step, state, (there, seen), (event, part));
        let slope = from.slope.abs().max(to.slope.abs());
        let to = match until {
            Some(part) if part < 1.0 => sample(part),
            _ => to,
        };
        let is_event = event < self.events.len();
        let direction = match is_event {
            true => self.events[event].direction,
            false => Direction::Crosses,
        };
        let mut search = Search {
            direction,
            noise: guard.noise_at(step.to),
            sign: guard.sign,
            armed: guard.armed,
            slope,
            blur: f64::EPSILON * (step.to / length).abs(),
            sample: &mut sample,
            permits: &|part| !is_event || permits(equations, event, step, part),
        };
        let mut begin = from;
        let ahead = |bend: &&(f64, f64)| is_event && bend.0 > from.part && bend.1 < to.part;
        let mut bends = bends.iter().filter(ahead);
        let mut bend = bends.next();
        let found = loop {
            let end = match bend {
                Some((before, _)) => (search.sample)(*before),
                None => to,
            };
            search.slope = search.slope.max(end.slope.abs());
            let width = end.part - begin.part;
            let found = match is_event && (rough || way.is_unknown(guard, width)) {
                true => {
                    let (found, fits) = search.run_warily(begin, end);
                    if fits {
                        guard.looked = guard.looked.max(width * length);
                    }
                    found
                }
                false => search.run(begin, end),
            };
            let (None, Some((_, after))) = (found, bend) else {
                break found;
            };
            bend = bends.next();
            begin = (search.sample)(*after);
            search.slope = search.slope.max(begin.slope.abs());
            let jumped = search.jump(end, begin);
            if jumped.is_some() {
                break jumped;
            }
        };
        (guard.sign, guard.armed) = (search.sign, search.armed);
        guard.rate = search.slope / length;
        found
    }
}

/// A guard at a part of a step. What one guard is looked at for, the others are to be looked at for too.
#[inline(always)]
fn look_at<E: Modes<f64>>(
    equations: &E,
    step: &Step<'_, E::State>,
    state: &mut E::State,
    (there, seen): (&mut Guards, &mut Seen),
    (guard, part): (usize, f64),
) -> Sample {
    let length = step.to - step.from;
    if let Some(guards) = seen.find(part) {
        return at(guards, guard, part, length);
    }
    between(step, part, state);
    let there = seen.next(part).unwrap_or(there);
    there.look(equations, step.from + part * length, state);
    at(there, guard, part, length)
}

/// A guard at a part of a step of this length.
#[inline(always)]
fn at(guards: &Guards, event: usize, part: f64, length: f64) -> Sample {
    Sample {
        part,
        value: guards.values[event],
        slope: guards.rates[event] * length,
    }
}

/// Whether what else an event asks for holds at a part of a step.
fn permits<E: Modes<f64>>(
    equations: &E,
    event: usize,
    step: &Step<'_, E::State>,
    part: f64,
) -> bool {
    let mut state = step.after.clone();
    between(step, part, &mut state);
    let time = step.from + part * (step.to - step.from);
    equations.permits(event, &equations.instant(time), &state)
}

/// The state at a part of a step.
#[inline(always)]
fn between<V: Storage<f64>>(step: &Step<'_, V>, part: f64, state: &mut V) {
    if part == 1.0 {
        state.clone_from(step.after);
        return;
    }
    // The length of a polynomial that is known lets its loop be written out.
    match <&[V; 7]>::try_from(step.polynomial) {
        Ok(polynomial) => polynomial_at(polynomial, step.before, part, state),
        Err(_) => polynomial_at(step.polynomial, step.before, part, state),
    }
}

/// A polynomial of a step at a part of it.
#[inline(always)]
fn polynomial_at<V: Storage<f64>>(polynomial: &[V], before: &V, part: f64, state: &mut V) {
    let state = state.as_mut();
    state.fill(0.0);
    for (row, coefficients) in polynomial.iter().enumerate().rev() {
        let factor = if row % 2 == 0 { part } else { 1.0 - part };
        for (sum, coefficient) in state.iter_mut().zip(coefficients.as_ref()) {
            *sum = (*sum + coefficient) * factor;
        }
    }
    for (sum, before) in state.iter_mut().zip(before.as_ref()) {
        *sum += before;
    }
}

impl<E: Modes<f64>> Observer<E::State> for Watch<'_, E> {
    #[inline(always)]
    fn wants_dense(&mut self, _from: f64, _to: f64) -> bool {
        true
    }

    #[inline(always)]
    fn step(&mut self, step: &Step<'_, E::State>) {
        self.recorder.step(step);
        self.look(step);
    }

    #[inline(always)]
    fn has_enough(&self) -> bool {
        self.due.is_some() || self.lost.is_some()
    }
}
