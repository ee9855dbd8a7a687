//! Looks for events in every step.

use super::NOISE;
use super::crossing::{Sample, Search, is_far, is_resolved};
use super::problem::{EventEntry, Modes};
use super::room::{Guards, Room};
use super::rounding::terms;
use crate::ode::{Observer, Recorder, Step};
use crate::problem::Storage;

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
const FORGET: f64 = 0.99;
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
        let mut first: Option<(f64, usize)> = None;
        let mut second: Option<usize> = None;
        let mut is_measured = false;
        // Which is first of two that cannot be told apart is said by their order in the file.
        let blur = BLUR * f64::EPSILON * (step.to / length).abs().max(1.0);
        for event in 0..self.events.len() {
            let from = at(&self.room.begin, event, 0.0, length);
            let to = at(&self.room.end, event, 1.0, length);
            if !to.value.is_finite() {
                self.lost = Some(event);
                break;
            }
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
            guard.rate *= MEMORY;
            let slope = (guard.rate * length)
                .max(from.slope.abs())
                .max(to.slope.abs());
            guard.rate = slope / length;
            guard.looked *= FORGET;
            let wary = length > LONGER * guard.looked
                || turned > TURNED
                || !is_resolved(&from, &to, slope);
            if !wary && guard.is_far(&from, &to) {
                continue;
            }
            if !is_measured && from.value.abs().min(to.value.abs()) <= NEAR * guard.size {
                is_measured = true;
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
            let until = first.map(|(part, _)| part + 2.0 * blur);
            let Some(part) = self.search(step, event, (from, to), wary, until) else {
                continue;
            };
            match first {
                Some((earlier, _)) if part > earlier + blur => {}
                Some((earlier, _)) if part >= earlier - blur => second = second.or(Some(event)),
                _ => (first, second) = (Some((part, event)), None),
            }
        }
        match first {
            Some((part, event)) => {
                let time = step.from + part * length;
                between(step, part, &mut self.state);
                self.recorder.cut(time, &self.state);
                self.due = Some(Due {
                    event,
                    time,
                    with: second,
                });
            }
            None => {
                self.state.clone_from(step.after);
                std::mem::swap(&mut self.room.begin, &mut self.room.end);
            }
        }
    }

    /// Where an event happens first in a step, up to a part of it.
    fn search(
        &mut self,
        step: &Step<'_, E::State>,
        event: usize,
        (from, to): (Sample, Sample),
        wary: bool,
        until: Option<f64>,
    ) -> Option<f64> {
        let length = step.to - step.from;
        let guard = &mut self.guards[event];
        let (equations, state, there) = (self.equations, &mut self.state, &mut self.room.there);
        let mut sample = |part: f64| {
            between(step, part, state);
            there.look(equations, step.from + part * length, state);
            at(there, event, part, length)
        };
        let slope = from.slope.abs().max(to.slope.abs());
        let to = match until {
            Some(part) if part < 1.0 => sample(part),
            _ => to,
        };
        let mut search = Search {
            direction: self.events[event].direction,
            noise: guard.noise_at(step.to),
            sign: guard.sign,
            armed: guard.armed,
            slope,
            blur: 0.5 * f64::EPSILON * (step.to / length).abs(),
            sample: &mut sample,
        };
        let mut begin = from;
        // A crossing at which something else that is asked for does not hold is passed over.
        let found = loop {
            let found = match wary {
                true => {
                    let (found, fits) = search.run_warily(begin, to);
                    if fits {
                        guard.looked = guard.looked.max(length);
                    }
                    found
                }
                false => search.run(begin, to),
            };
            let Some(found) = found else {
                break None;
            };
            if permits(equations, event, step, found.part) {
                break Some(found.part);
            }
            begin = (search.sample)(found.part);
        };
        (guard.sign, guard.armed) = (search.sign, search.armed);
        guard.rate = search.slope / length;
        found
    }
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
    let state = state.as_mut();
    state.fill(0.0);
    for (row, coefficients) in step.polynomial.iter().enumerate().rev() {
        let factor = if row % 2 == 0 { part } else { 1.0 - part };
        for (sum, coefficient) in state.iter_mut().zip(coefficients.as_ref()) {
            *sum = (*sum + coefficient) * factor;
        }
    }
    for (sum, before) in state.iter_mut().zip(step.before.as_ref()) {
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
