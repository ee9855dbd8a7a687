//! Looks for events in every step.

use super::NOISE;
use super::crossing::{Crossing, Sample, Search};
use super::problem::{EventEntry, Modes};
use super::rounding::terms;
use crate::ode::{Observer, Recorder, Step};
use crate::problem::Storage;
use crate::scalar::Scalar;

/// Roundings of the time by which two events differ that cannot be told apart: the continuous solution has as many.
const BLUR: f64 = 64.0;

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
pub(super) struct Watch<'a, S: Scalar, E: Modes<S>> {
    pub equations: &'a E,
    pub events: &'static [EventEntry],
    pub recorder: Recorder<S>,
    pub guards: &'a mut [Guard],
    /// What ended the motion.
    pub due: Option<Due>,
    /// The state there, or at the end of the last step.
    pub state: E::State,
    /// The length of the last whole step.
    pub step: f64,
    /// Values and rates of the guards at the begin of the step.
    values: Vec<S>,
    rates: Vec<S>,
    /// The same anywhere.
    there: (Vec<S>, Vec<S>),
    /// The same at the end of the step.
    end: (Vec<S>, Vec<S>),
}

impl<'a, S: Scalar, E: Modes<S>> Watch<'a, S, E> {
    /// Watches the motion from a time and state, where the guards are known.
    pub fn new(
        equations: &'a E,
        events: &'static [EventEntry],
        time: f64,
        state: &E::State,
        guards: &'a mut [Guard],
    ) -> Self {
        let zeros = || vec![S::ZERO; events.len()];
        let mut watch = Self {
            equations,
            events,
            recorder: Recorder::new(time, state),
            guards,
            due: None,
            state: state.clone(),
            step: 0.0,
            values: zeros(),
            rates: zeros(),
            there: (zeros(), zeros()),
            end: (zeros(), zeros()),
        };
        let instant = equations.instant(S::from_f64(time));
        equations.guards(&instant, state, &mut watch.values, &mut watch.rates);
        watch
    }

    /// The earliest event of a step.
    #[inline(always)]
    fn look(&mut self, step: &Step<'_, E::State>) {
        let length = step.to - step.from;
        let instant = self.equations.instant(S::from_f64(step.to));
        let (values, rates) = (&mut self.end.0, &mut self.end.1);
        self.equations.guards(&instant, step.after, values, rates);
        let mut first: Option<(Crossing, usize)> = None;
        let mut second = first;
        let mut sizes = None;
        for (event, entry) in self.events.iter().enumerate() {
            let from = Sample {
                part: 0.0,
                value: self.values[event].to_f64(),
                slope: self.rates[event].to_f64() * length,
            };
            let to = Sample {
                part: 1.0,
                value: self.end.0[event].to_f64(),
                slope: self.end.1[event].to_f64() * length,
            };
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
            let (equations, state, there) = (self.equations, &mut self.state, &mut self.there);
            let mut sample = |part: f64| {
                between(step, part, state);
                let time = S::from_f64(step.from + part * length);
                let instant = equations.instant(time);
                equations.guards(&instant, state, &mut there.0, &mut there.1);
                Sample {
                    part,
                    value: there.0[event].to_f64(),
                    slope: there.1[event].to_f64() * length,
                }
            };
            let mut search = Search {
                direction: entry.direction,
                noise: guard.noise_at(step.to),
                sign: guard.sign,
                armed: guard.armed,
                sample: &mut sample,
            };
            if search.is_far(&from, &to) {
                continue;
            }
            let sizes = sizes
                .get_or_insert_with(|| terms(equations, step.to, step.after, self.events.len()));
            guard.size = guard.size.max(sizes[event].value);
            search.noise = guard.noise_at(step.to);
            let mut begin = from;
            // A crossing at which something else that is asked for does not hold is passed over.
            let found = loop {
                let Some(found) = search.run(begin, to) else {
                    break None;
                };
                let here = (search.sample)(found.part);
                if permits(equations, event, step, found.part) {
                    break Some(found);
                }
                begin = here;
            };
            (guard.sign, guard.armed) = (search.sign, search.armed);
            let Some(found) = found else { continue };
            // Which is first of two that cannot be told apart is said by their order in the file.
            let blur = BLUR * f64::EPSILON * (step.to / length).abs().max(1.0);
            match first {
                Some((earlier, _)) if found.part > earlier.part + blur => {}
                Some((earlier, _)) if found.part >= earlier.part - blur => {
                    second = second.or(Some((found, event)));
                }
                _ => (first, second) = (Some((found, event)), None),
            }
        }
        self.step = length;
        match first {
            Some((crossing, event)) => {
                let time = step.from + crossing.part * length;
                between(step, crossing.part, &mut self.state);
                self.recorder.cut(time, &self.state);
                let with = second.map(|(_, event)| event);
                self.due = Some(Due { event, time, with });
            }
            None => {
                self.state.clone_from(step.after);
                std::mem::swap(&mut self.values, &mut self.end.0);
                std::mem::swap(&mut self.rates, &mut self.end.1);
            }
        }
    }
}

/// Whether what else an event asks for holds at a part of a step.
fn permits<S: Scalar, E: Modes<S>>(
    equations: &E,
    event: usize,
    step: &Step<'_, E::State>,
    part: f64,
) -> bool {
    let mut state = step.after.clone();
    between(step, part, &mut state);
    let time = step.from + part * (step.to - step.from);
    equations.permits(event, &equations.instant(S::from_f64(time)), &state)
}

/// The state at a part of a step.
#[inline(always)]
fn between<S: Scalar, V: Storage<S>>(step: &Step<'_, V>, part: f64, state: &mut V) {
    if part == 1.0 {
        state.clone_from(step.after);
        return;
    }
    let (part, rest) = (S::from_f64(part), S::from_f64(1.0 - part));
    for (index, slot) in state.as_mut().iter_mut().enumerate() {
        let mut value = S::ZERO;
        for (row, coefficients) in step.polynomial.iter().enumerate().rev() {
            let factor = if row % 2 == 0 { part } else { rest };
            value = (value + coefficients.as_ref()[index]) * factor;
        }
        *slot = step.before.as_ref()[index] + value;
    }
}

impl<S: Scalar, E: Modes<S>> Observer<E::State> for Watch<'_, S, E> {
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
        self.due.is_some()
    }
}
