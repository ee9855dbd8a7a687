//! Motions that repeat by themselves: nothing drives them, and their period is one more unknown.
//!
//! The motion from the start values is followed over stretches, each as long as all before it together. At the end of
//! each it is compared with its past: where it last passed the plane through its end, across its way, as near as ever.
//! The time since then is a guess of the period, and Newton's method closes the motion from there.

use super::super::Motion;
use super::error::CycleError;
use super::newton::Gap;
use super::{Cycle, follow, phase};
use crate::model::{Flow, Model};
use crate::settings::Settings;

/// So near to its past, over the sizes of its states, a motion is closed at once.
const NEAR: f64 = 1e-4;
/// Nearer than this Newton's method may be tried.
const CLOSE: f64 = 3e-2;
/// A motion further away than this is not the one that was followed.
const FAR: f64 = 0.5;
/// A motion that swings by less, over the sizes of its states, is at rest.
const REST: f64 = 1e-5;
/// Values that differ by less, over the sizes, are the same.
const ALIKE: f64 = 1e-6;
/// First stretch, in parts of the time in which the rates at the start change the state by its size.
const FIRST: f64 = 0.1;
/// Most stretches. Each doubles the time.
const STRETCHES: usize = 100;
/// Stretches after the first in which the motion came back to its past.
const PATIENCE: usize = 16;
/// Steps after which a motion is given up.
const STEPS: usize = 400_000;
/// Times that the state takes to change by its size, after which one that does not move is at rest.
const LONG: f64 = 100.0;
/// Parts of a step in which a passage is looked for.
const PARTS: usize = 4;
/// Parts of the range of a state that only rises at which its motion may begin, and how far from events, in parts of the
/// period.
const BEGINS: [f64; 5] = [0.5, 0.4, 0.6, 0.3, 0.7];
const APART: f64 = 1e-3;
/// Halvings of the time of a passage.
const HALVINGS: usize = 40;

/// A motion under way.
struct Walk<'a> {
    model: &'a dyn Model,
    settings: &'a Settings,
    mode: usize,
    state: Vec<f64>,
    /// The largest size of each state so far, its scale at least.
    sizes: Vec<f64>,
    time: f64,
    steps: usize,
}

/// A passage through the plane at the end of a motion.
#[derive(Clone, Copy)]
struct Passage {
    /// Time from there to the end.
    since: f64,
    /// Distance from the end, over the sizes.
    distance: f64,
}

/// The stable motion that a start leads to and that repeats by itself.
pub(super) fn find(
    model: &dyn Model,
    (mode, start): (usize, &[f64]),
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    let mut walk = Walk {
        model,
        settings,
        mode,
        state: start.to_vec(),
        sizes: model.shape().scales.to_vec(),
        time: 0.0,
        steps: 0,
    };
    walk.grow(start);
    let pace = walk.pace()?;
    let mut length = FIRST * pace;
    let (mut nearest, mut returned): (Option<Passage>, usize) = (None, 0);
    for _ in 0..STRETCHES {
        let motion = walk.stretch(length)?;
        walk.is_autonomous()?;
        if walk.time >= LONG * pace && walk.is_at_rest(&motion) {
            return Err(CycleError::Rest { time: walk.time });
        }
        length = walk.time;
        let Some(passage) = walk.passages(&motion) else {
            continue;
        };
        nearest = Some(passage);
        returned += 1;
        let is_last = returned > PATIENCE;
        let is_due = passage.distance <= NEAR || returned > 4 && passage.distance <= CLOSE;
        if is_due && let Some(cycle) = walk.close(passage.since)? {
            return Ok(cycle);
        }
        if is_last || walk.steps > STEPS {
            break;
        }
    }
    Err(CycleError::NoReturn { time: walk.time, nearest: nearest.map(|passage| passage.distance) })
}

impl Walk<'_> {
    /// The time in which the rates here change the state by its size, all states over their scales.
    fn pace(&self) -> Result<f64, CycleError> {
        let largest = |values: &[f64]| {
            let scaled = values.iter().zip(self.model.shape().scales);
            scaled.fold(0.0, |most, (value, scale)| (value.abs() / scale).max(most))
        };
        let fastest = largest(&self.rate(self.mode, &self.state));
        let size = largest(&self.state);
        match fastest > 0.0 && fastest.is_finite() {
            true if size > 0.0 => Ok(size / fastest),
            true => Ok(1.0 / fastest),
            false => Err(CycleError::Rest { time: 0.0 }),
        }
    }

    fn rate(&self, mode: usize, state: &[f64]) -> Vec<f64> {
        let mut rate = vec![0.0; state.len()];
        Flow::on(self.model, mode, &[]).rates(0.0, state, &mut rate);
        rate
    }

    /// Follows the motion for a time.
    fn stretch(&mut self, length: f64) -> Result<Motion, CycleError> {
        let motion = follow(self.model, self.mode, (0.0, length), &self.state, self.settings)?;
        self.steps += motion.statistics.steps + motion.statistics.rejected;
        self.time += length;
        self.mode = motion.mode;
        self.state.copy_from_slice(&motion.end);
        for piece in &motion.pieces {
            for time in piece.trajectory.times() {
                self.grow(&piece.trajectory.at(*time));
            }
        }
        Ok(motion)
    }

    fn grow(&mut self, state: &[f64]) {
        for (size, value) in self.sizes.iter_mut().zip(state) {
            *size = size.max(value.abs());
        }
    }

    /// Refuses equations that depend on the time.
    fn is_autonomous(&self) -> Result<(), CycleError> {
        let local = Flow::on(self.model, self.mode, &[]);
        let mut first = vec![0.0; self.state.len()];
        local.rates(0.0, &self.state, &mut first);
        for part in [0.17, 0.5, 0.83] {
            let mut other = first.clone();
            local.rates(part * self.time, &self.state, &mut other);
            let differs = |(a, b): (&f64, &f64)| a != b && !(a.is_nan() && b.is_nan());
            if let Some(component) = first.iter().zip(&other).position(differs) {
                return Err(CycleError::Driven { component });
            }
        }
        Ok(())
    }

    /// Whether no state moves over a motion.
    fn is_at_rest(&self, motion: &Motion) -> bool {
        let mut widest = 0.0f64;
        for piece in &motion.pieces {
            for time in piece.trajectory.times() {
                widest = widest.max(self.apart(&piece.trajectory.at(*time), &motion.end));
            }
        }
        widest <= REST
    }

    /// How far two states are from each other, over the sizes.
    fn apart(&self, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other).zip(&self.sizes);
        let far = pairs.map(|((a, b), size)| (a - b).abs() / size);
        far.fold(0.0, f64::max)
    }

    /// The nearest passage of the plane through the end of a motion; of those within a factor of ten the last one.
    fn passages(&self, motion: &Motion) -> Option<Passage> {
        let rate = self.rate(self.mode, &self.state);
        let normal: Vec<f64> =
            rate.iter().zip(&self.sizes).map(|(rate, size)| rate / (size * size)).collect();
        let height = |state: &[f64]| -> f64 {
            let terms = state.iter().zip(&motion.end).zip(&normal);
            terms.map(|((a, b), normal)| (a - b) * normal).sum()
        };
        let mut found = Vec::new();
        for piece in motion.pieces.iter().filter(|piece| piece.mode == self.mode) {
            let times = piece.trajectory.times();
            let mut low = height(&piece.trajectory.at(times[0]));
            for ends in times.windows(2) {
                for part in 1..=PARTS {
                    let time =
                        |part: usize| ends[0] + (ends[1] - ends[0]) * part as f64 / PARTS as f64;
                    let high = height(&piece.trajectory.at(time(part)));
                    if low < 0.0 && high >= 0.0 && time(part) < motion.time {
                        let at = |time: f64| height(&piece.trajectory.at(time)) < 0.0;
                        let time = passed(at, time(part - 1), time(part));
                        found.push(Passage {
                            since: motion.time - time,
                            distance: self.apart(&piece.trajectory.at(time), &motion.end),
                        });
                    }
                    low = high;
                }
            }
        }
        let nearest = found.iter().map(|one| one.distance).fold(f64::INFINITY, f64::min);
        found.into_iter().rfind(|one| one.distance <= 10.0 * nearest)
    }

    /// The motion that repeats after about this time, near here.
    fn close(&self, period: f64) -> Result<Option<Cycle>, CycleError> {
        let gap = |mode: usize, period: f64| Gap {
            model: self.model,
            mode,
            period,
            multiple: 1,
            is_free: true,
            sizes: &self.sizes,
            settings: self.settings,
        };
        let followed = (self.time / period) as usize;
        let Some(cycle) = gap(self.mode, period).close(&self.state, followed)? else {
            return Ok(None);
        };
        let is_one = self.apart(&cycle.start(), &self.state) <= FAR
            && cycle.is_stable()
            && !self.is_at_rest(&cycle.motion);
        if !is_one {
            return Ok(None);
        }
        let tops = self.tops(&cycle.motion);
        let place = phase::first(&tops, &self.sizes, ALIKE.max(1e3 * self.settings.rtol));
        let Some((mode, state)) = tops.get(place) else {
            return Ok(Some(cycle));
        };
        let moved = gap(*mode, cycle.motion.time).close(state, followed)?;
        Ok(Some(moved.unwrap_or(cycle)))
    }

    /// Modes and states where the first state that moves is largest for a while; of one that only rises between events where
    /// it passes the middle of its range.
    fn tops(&self, motion: &Motion) -> Vec<(usize, Vec<f64>)> {
        let range = |state: usize| {
            let values = motion.pieces.iter().flat_map(|piece| {
                let times = piece.trajectory.times().iter();
                times.map(move |time| piece.trajectory.at(*time)[state])
            });
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), one| {
                (one.min(low), one.max(high))
            })
        };
        let moves = |state: &usize| {
            let (low, high) = range(*state);
            high - low > REST * self.sizes[*state]
        };
        let Some(state) = (0..self.sizes.len()).find(moves) else {
            return Vec::new();
        };
        let rises = |mode: usize, at: &[f64]| self.rate(mode, at)[state] > 0.0;
        let tops = places(motion, &rises);
        if !tops.is_empty() {
            return tops.into_iter().map(Place::without_time).collect();
        }
        // Not where something else changes: a jump at the begin would be now before it and now behind it.
        let (low, high) = range(state);
        let at_part = |part: f64| places(motion, &|_, at| at[state] < low + part * (high - low));
        let mut all = BEGINS.into_iter().map(at_part);
        let is_apart = |found: &Vec<Place>| {
            let near = |place: &Place| {
                let times = motion.events.iter().map(|event| (event.time - place.time).abs());
                times.fold(f64::INFINITY, f64::min) < APART * motion.time
            };
            !found.is_empty() && !found.iter().any(near)
        };
        let found = all.find(is_apart).unwrap_or_else(|| at_part(BEGINS[0]));
        found.into_iter().map(Place::without_time).collect()
    }
}

/// A place of a motion.
struct Place {
    time: f64,
    mode: usize,
    state: Vec<f64>,
}

impl Place {
    /// Mode and state.
    fn without_time(self) -> (usize, Vec<f64>) {
        (self.mode, self.state)
    }
}

/// Places of a motion where something that holds ceases to.
fn places(motion: &Motion, holds: &dyn Fn(usize, &[f64]) -> bool) -> Vec<Place> {
    let mut places = Vec::new();
    for piece in &motion.pieces {
        let times = piece.trajectory.times();
        let at = |time: f64| holds(piece.mode, &piece.trajectory.at(time));
        for ends in times.windows(2) {
            for part in 0..PARTS {
                let time = |part: usize| ends[0] + (ends[1] - ends[0]) * part as f64 / PARTS as f64;
                if at(time(part)) && !at(time(part + 1)) {
                    let time = passed(at, time(part), time(part + 1));
                    let state = piece.trajectory.at(time);
                    places.push(Place { time, mode: piece.mode, state });
                }
            }
        }
    }
    places
}

/// When something that holds at the first of two times ceases to.
fn passed(holds: impl Fn(f64) -> bool, mut from: f64, mut to: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        match holds(middle) {
            true => from = middle,
            false => to = middle,
        }
    }
    to
}
