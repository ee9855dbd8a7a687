//! Guards within a step: where they bend, and where they pass zero.

use super::crossing::{Crossing, Search};
use super::cubic::Reading;
use super::guard::Portion;
use super::narrow::Instants;
use super::room::{Guards, Room, Seen};
use super::watch::Watch;
use crate::hybrid::numbers::Numbers;
use crate::model::Flow;
use crate::ode::{Basis, Step};
use crate::shape::Direction;

/// Bends of guards in a step that are told apart. More are found as what they are to a guard.
const BENDS: usize = 4;

impl Watch<'_> {
    /// Notes where a kink lies in a step.
    pub(super) fn bend(&mut self, step: &Step<'_>, way: &Portion, kink: usize) {
        let length = step.to - step.from;
        let mut from = at(&self.room.begin, kink, way.part.0, length);
        let to = at(&self.room.end, kink, way.part.1, length);
        let guard = &mut self.guards[kink];
        guard.size = guard.size.max(from.value.abs()).max(to.value.abs());
        if guard.is_far(&from, &to) {
            return;
        }
        while self.room.bends.len() < BENDS {
            let Some(crossing) = self.search(step, way, kink, (from, to), false, None) else {
                break;
            };
            self.room.bends.push((crossing.before, crossing.at.part));
            from = crossing.at;
        }
    }

    /// Where an event happens first in a step, up to a part of it. From bend to bend its guard is smooth.
    pub(super) fn search(
        &mut self,
        step: &Step<'_>,
        way: &Portion,
        event: usize,
        (from, to): (Reading, Reading),
        rough: bool,
        until: Option<f64>,
    ) -> Option<Crossing> {
        let length = step.to - step.from;
        let guard = &mut self.guards[event];
        let (flow, state) = (self.flow, &mut *self.state);
        let Room { there, seen, bends, .. } = &mut *self.room;
        let mut sample = |part: f64| look_at(flow, step, state, (there, seen), (event, part));
        let slope = from.slope.abs().max(to.slope.abs());
        let begins = guard.began == Some(step.from);
        let still = guard.still_rate() * length;
        let to = match until {
            Some(part) if part < to.part => sample(part),
            _ => to,
        };
        let is_event = event < self.events.len();
        let (direction, conditional) = match self.events.get(event) {
            Some(entry) => (entry.direction, entry.conditional),
            None => (Direction::Crosses, false),
        };
        let mut search = Search {
            direction,
            noise: guard.noise_at(step.to),
            sign: guard.sign,
            armed: guard.armed,
            slope,
            instants: Instants::new(step.from, length),
            sample: &mut sample,
            permits: &|part| !conditional || permits(flow, event, step, part),
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
            let found = match found {
                Some(crossing) if begins && begin.part == 0.0 => {
                    search.unless_taken_back(crossing, end, still)
                }
                _ => found,
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
fn look_at(
    flow: &Flow<'_>,
    step: &Step<'_>,
    state: &mut [f64],
    (there, seen): (&mut Guards, &mut Seen),
    (guard, part): (usize, f64),
) -> Reading {
    let length = step.to - step.from;
    let sample = |value: f64, rate: f64| Reading { part, value, slope: rate * length };
    if let Some((value, rate)) = seen.find(part, guard) {
        return sample(value, rate);
    }
    between(step, part, state);
    let (values, rates) = seen.next(part).unwrap_or_else(|| there.both_mut());
    flow.guards(step.from + part * length, state, values, rates);
    sample(values[guard], rates[guard])
}

/// A guard at a part of a step of this length.
#[inline(always)]
pub(super) fn at(guards: &Guards, event: usize, part: f64, length: f64) -> Reading {
    Reading { part, value: guards.values()[event], slope: guards.rates()[event] * length }
}

/// Whether what else an event asks for holds at a part of a step.
fn permits(flow: &Flow<'_>, event: usize, step: &Step<'_>, part: f64) -> bool {
    let mut state = Numbers::new(step.after);
    between(step, part, state.as_mut());
    let time = step.from + part * (step.to - step.from);
    flow.permits(event, time, &state)
}

/// The state at a part of a step.
#[inline]
pub(super) fn between(step: &Step<'_>, part: f64, state: &mut [f64]) {
    if part == 1.0 {
        state.copy_from_slice(step.after);
        return;
    }
    // States of one to three coordinates stay in registers.
    match state.len() {
        2 => write(known::<2>(step, part), step, state),
        4 => write(known::<4>(step, part), step, state),
        6 => write(known::<6>(step, part), step, state),
        _ => any(step, part, state),
    }
}

/// Writes a state that a step has changed by so much.
#[inline(always)]
fn write<const N: usize>(change: [f64; N], step: &Step<'_>, state: &mut [f64]) {
    for (value, (change, before)) in state.iter_mut().zip(change.iter().zip(step.before)) {
        *value = change + before;
    }
}

/// What a step changes a state of this length by, at a part of it.
#[inline(always)]
fn known<const N: usize>(step: &Step<'_>, part: f64) -> [f64; N] {
    let (rows, _) = step.polynomial.as_chunks::<N>();
    let (pairs, last) = rows.as_chunks::<2>();
    let (mut sum, mut even) = ([0.0; N], [0.0; N]);
    if step.basis == Basis::Powers {
        // Even and odd powers apart, since each sum has to wait for itself.
        let square = part * part;
        if let [last] = last {
            sum = *last;
        }
        for [one, other] in pairs.iter().rev() {
            for index in 0..N {
                even[index] = (even[index] + other[index]) * square;
                sum[index] = sum[index] * square + one[index];
            }
        }
        for index in 0..N {
            sum[index] = sum[index] * part + even[index];
        }
        return sum;
    }
    let mut add = |coefficients: &[f64; N], factor: f64| {
        for index in 0..N {
            sum[index] = (sum[index] + coefficients[index]) * factor;
        }
    };
    if let [last] = last {
        add(last, part);
    }
    for [one, other] in pairs.iter().rev() {
        add(other, 1.0 - part);
        add(one, part);
    }
    sum
}

/// A state of any length at a part of a step, by Horner's rule.
fn any(step: &Step<'_>, part: f64, state: &mut [f64]) {
    let length = state.len();
    state.fill(0.0);
    let rows = step.polynomial.chunks_exact(length.max(1)).enumerate();
    for (number, row) in rows.rev() {
        let factor = match step.basis {
            Basis::Alternating if number % 2 == 1 => 1.0 - part,
            _ => part,
        };
        for (sum, coefficient) in state.iter_mut().zip(row) {
            *sum = (*sum + coefficient) * factor;
        }
    }
    for (sum, before) in state.iter_mut().zip(step.before) {
        *sum += before;
    }
}
