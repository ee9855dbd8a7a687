//! From event to event, several at one instant, and the rules that end it.

pub(super) mod carry;
pub(super) mod end;
pub(super) mod march;
pub(super) mod settle;
pub(super) mod start;

use super::event::guard::Guard;
use super::event::room::Room;
use super::event::watch::Watch;
use super::motion::{Happened, Motion, Piece};
use super::numbers::Numbers;
use super::{CHATTER, SOON, TURNS};
use crate::model::Flow;
use crate::ode::{Options, Recorder, Statistics, Trajectory};
use crate::shape::{EventEntry, Shape};
use carry::Carrier;
use end::End;

/// A motion under way.
pub(super) struct Run<'a> {
    pub(super) flow: Flow<'a>,
    pub(super) shape: &'a Shape,
    pub(super) state: Vec<f64>,
    /// Room for a state.
    next: Vec<f64>,
    options: Options,
    times: (f64, f64),
    pub(super) guards: Vec<Guard>,
    /// For each mode how long the steps were in which its guards have been looked at.
    looked: Vec<Vec<f64>>,
    pub(super) room: Room,
    /// Keeps the motion in this mode.
    recorder: Recorder,
    /// Whether `room.here` are the guards of this instant.
    pub(super) is_known: bool,
    /// When events began to follow each other quickly, and how many there have been since.
    since: (f64, usize),
    /// On which side of each switching surface the motion is.
    pub(super) sides: Vec<f64>,
    /// The rate with which the guard of the last event passed zero.
    pub(super) arrival: f64,
    /// Events at this instant.
    turns: usize,
    /// The last event: its line, its time, and the rate of its guard after it.
    bounce: Option<(u32, f64, f64)>,
}

impl<'a> Run<'a> {
    /// A motion at its start.
    pub(super) fn new(
        flow: Flow<'a>,
        state: Vec<f64>,
        options: Options,
        times: (f64, f64),
    ) -> Self {
        let shape = flow.shape();
        let mut room = Room::default();
        // What the largest mode needs is taken at once.
        room.resize(shape.most_written());
        room.resize(shape.modes[flow.mode()].written());
        Self {
            flow,
            shape,
            next: state.clone(),
            recorder: Recorder::new(times.0, &state),
            state,
            options,
            times,
            guards: vec![Guard::default(); shape.most_guards()],
            looked: vec![vec![0.0; shape.most_guards()]; shape.modes.len()],
            room,
            is_known: false,
            since: (times.0, 0),
            arrival: 0.0,
            turns: 0,
            sides: vec![0.0; shape.most_guards()],
            bounce: None,
        }
    }

    /// From event to event up to the end.
    pub(super) fn through(
        &mut self,
        motion: &mut Motion,
        carrier: &mut Carrier,
    ) -> Result<(), End> {
        // The statement that has just happened, by its line.
        let mut last: Option<u32> = None;
        self.settle(motion.time)?;
        // The statement that has happened with it and is still to be carried out.
        let mut with: Option<u32> = None;
        while motion.time < self.times.1 {
            let events = self.shape.modes[self.flow.mode()].events;
            if let Some(event) = self.begin(motion.time, events, last, with.take())? {
                let begin = &self.room.begin;
                let guard = (begin.values()[event], begin.rates()[event]);
                self.happen(motion, (event, guard), &mut last)?;
                continue;
            }
            let mut watch = Watch::new(
                &self.flow,
                events,
                (motion.time, &mut self.next),
                &mut self.guards,
                (&mut self.room, &mut self.recorder),
                self.shape.modes[self.flow.mode()].guards(),
            );
            let times = (motion.time, self.times.1);
            let done = carrier.carry(times, &self.state, &self.options, &mut watch);
            let (due, lost, step, fast) = (watch.due, watch.lost, watch.step, watch.fast);
            self.state.copy_from_slice(watch.state);
            self.is_known = false;
            let statistics = *done.as_ref().unwrap_or(&Statistics::default());
            let mut trajectory = watch.recorder.take(statistics);
            trajectory.switches = carrier.switches().to_vec();
            self.keep(motion, events, trajectory);
            done.map_err(End::Ode)?;
            if let Some(event) = lost {
                return Err(End::Guard(event));
            }
            if let Some(turned) = fast {
                return Err(End::Turns(turned));
            }
            if step > 0.0 {
                self.options.first_step = Some(step);
            }
            if let Some(due) = due {
                motion.time = due.time;
                with = due.with.map(|event| events[event].line);
                self.happen(motion, (due.event, due.guard), &mut last)?;
            }
        }
        Ok(())
    }

    /// Keeps a way without events, and counts its steps.
    fn keep(&mut self, motion: &mut Motion, events: &[EventEntry], trajectory: Trajectory) {
        let statistics = trajectory.statistics;
        let tried = statistics.steps + statistics.rejected;
        self.options.max_steps = self.options.max_steps.saturating_sub(tried);
        motion.statistics.add(&statistics);
        motion.time = trajectory.times()[trajectory.times().len() - 1];
        motion.end.copy_from_slice(trajectory.end());
        if motion.time > trajectory.times()[0] {
            let (mode, sides) = (self.flow.mode(), self.sides_here(events));
            motion.pieces.push(Piece { mode, sides, trajectory });
        }
    }

    /// Carries out an event, whose guard has a value and a rate.
    fn happen(
        &mut self,
        motion: &mut Motion,
        (event, (guard, rate)): (usize, (f64, f64)),
        last: &mut Option<u32>,
    ) -> Result<(), End> {
        let from = self.flow.mode();
        let entry = &self.shape.modes[from].events[event];
        self.arrival = rate;
        self.next.copy_from_slice(&self.state);
        if entry.sets {
            self.flow.jump(event, motion.time, &self.state, &mut self.next);
            if self.next.iter().any(|value| value.is_nan()) {
                return Err(End::Lost(event));
            }
        }
        let noise = self.guards[event].noise();
        let size = self.guards[event].size;
        if entry.target != from {
            self.enter(from, entry.target);
        }
        if entry.sets || entry.target != from {
            let held = self.flow.seize(motion.time, &self.state, &mut self.next);
            held.map_err(End::Ode)?;
        }
        let before = motion.events.last().map(|one| one.time);
        let happened = Happened {
            time: motion.time,
            from,
            event,
            to: entry.target,
            before: Numbers::new(&self.state),
            after: Numbers::new(&self.next),
            guard,
        };
        motion.end.copy_from_slice(&happened.after);
        motion.mode = entry.target;
        motion.events.push(happened);
        self.state.copy_from_slice(&self.next);
        self.is_known = false;
        *last = Some(entry.line);
        self.count(motion, before)?;
        // Between this event and the last of the same kind the guard rose above zero by less than it can be told from.
        let same =
            self.shape.modes[entry.target].events.iter().position(|one| one.line == entry.line);
        let lost = self.bounce.filter(|(line, time, rate)| {
            *line == entry.line && motion.time > *time && (motion.time - time) * rate.abs() <= noise
        });
        match entry.surface {
            Some(surface) => {
                let side = self.leaving(motion.time, event, surface)?;
                self.put(surface, side);
            }
            None => self.settle(motion.time)?,
        }
        self.bounce = same.and_then(|event| {
            let (value, rate) = self.guard(motion.time, event);
            // A guard that has jumped has left zero.
            let fastest = rate.abs().max(self.arrival.abs());
            let blur = 4.0 * f64::EPSILON * (fastest * motion.time).abs();
            let is_zero = value.abs() <= noise.max(blur);
            is_zero.then_some((entry.line, motion.time, rate))
        });
        if let Some(event) = same {
            self.guards[event].size = size;
        }
        match lost {
            Some((_, time, _)) => {
                Err(End::Chatter { since: self.since.0.min(time), events: self.since.1.max(2) })
            }
            None => Ok(()),
        }
    }

    /// Goes from one mode to another. How long the steps were in which a guard has been looked at is known there from before.
    fn enter(&mut self, from: usize, to: usize) {
        self.flow.enter(to);
        for (guard, looked) in self.guards.iter().zip(&mut self.looked[from]) {
            *looked = guard.looked;
        }
        for (guard, looked) in self.guards.iter_mut().zip(&self.looked[to]) {
            *guard = Guard { looked: *looked, ..Guard::default() };
        }
        self.room.resize(self.shape.modes[to].written());
    }

    /// Counts events that follow each other without end, or ever more quickly.
    fn count(&mut self, motion: &Motion, before: Option<f64>) -> Result<(), End> {
        let now = motion.time;
        match before == Some(now) {
            true => self.turns += 1,
            false => self.turns = 1,
        }
        if self.turns > TURNS {
            let last = motion.events.iter().rev().take(TURNS);
            let mut modes: Vec<usize> = last.map(|one| one.to).collect();
            modes.reverse();
            let first = modes[0];
            if let Some(length) = modes.iter().skip(1).position(|mode| *mode == first) {
                modes.truncate(length + 2);
            }
            return Err(End::Loop(modes));
        }
        let soon = SOON * (self.times.1 - self.times.0);
        match before {
            Some(before) if now - before <= soon => self.since.1 += 1,
            _ => self.since = (now, 1),
        }
        match self.since.1 > CHATTER {
            true => Err(End::Chatter { since: self.since.0, events: self.since.1 }),
            false => Ok(()),
        }
    }
}
