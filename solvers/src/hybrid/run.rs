//! From event to event, several at one instant, and the rules that end it.

use super::carry::Carry;
use super::erased::{Erased, Table};
use super::error::HybridError;
use super::motion::{Happened, Motion, Piece};
use super::problem::{EventEntry, Modes};
use super::room::Room;
use super::rounding::terms;
use super::watch::{Guard, NEAR, Watch};
use super::{CHATTER, NOISE, SOON, TURNS};
use crate::ode::{OdeError, Options, Statistics};
use crate::problem::{Equations, Storage};

/// Part of the rate with which a guard passed zero that counts as none after the event.
const STOPPED: f64 = 1e-9;

/// Why the motion ends early.
pub(super) enum End {
    Ode(OdeError),
    Loop(Vec<usize>),
    Chatter { since: f64, events: usize },
    Held(usize),
    Guard(usize),
}

impl End {
    #[cold]
    pub(super) fn with(self, motion: Motion) -> HybridError {
        let (time, mode) = (motion.time, motion.mode);
        let motion = Box::new(motion);
        match self {
            Self::Ode(error) => HybridError::Ode {
                error,
                mode,
                motion,
            },
            Self::Held(event) => HybridError::Held {
                time,
                mode,
                event,
                motion,
            },
            Self::Guard(event) => HybridError::Guard {
                time,
                mode,
                event,
                motion,
            },
            Self::Loop(modes) => HybridError::Loop {
                time,
                modes,
                turns: TURNS,
                motion,
            },
            Self::Chatter { since, events } => {
                let last = motion.events.iter().rev().take(8);
                let mut modes: Vec<usize> = last.map(|one| one.to).collect();
                modes.sort_unstable();
                modes.dedup();
                HybridError::Chatter {
                    time,
                    since,
                    events,
                    modes,
                    motion,
                }
            }
        }
    }
}

/// A motion under way.
pub(super) struct Run<'a, 'b, V> {
    equations: Erased<'a, V>,
    table: &'b Table,
    state: V,
    options: Options,
    times: (f64, f64),
    guards: Vec<Guard>,
    /// For each mode how long the steps were in which its guards have been looked at.
    looked: Vec<Vec<f64>>,
    room: Room,
    /// When events began to follow each other quickly, and how many there have been since.
    since: (f64, usize),
    /// On which side of each switching surface the motion is.
    sides: Vec<f64>,
    /// The rate with which the guard of the last event passed zero.
    arrival: f64,
    /// Events at this instant.
    turns: usize,
    /// The last event: its line, its time, and the rate of its guard after it.
    bounce: Option<(u32, f64, f64)>,
}

impl<'a, 'b, V: Storage<f64>> Run<'a, 'b, V> {
    /// A motion at its start.
    pub(super) fn new(
        equations: Erased<'a, V>,
        table: &'b Table,
        state: V,
        options: Options,
        times: (f64, f64),
    ) -> Self {
        let mut room = Room::default();
        room.resize(table.guards(equations.mode()));
        room.drivers = [vec![0.0; table.drivers.0], vec![0.0; table.drivers.0]];
        Self {
            equations,
            table,
            state,
            options,
            times,
            guards: vec![Guard::default(); table.most_guards()],
            looked: vec![vec![0.0; table.most_guards()]; table.events.len()],
            room,
            since: (times.0, 0),
            arrival: 0.0,
            turns: 0,
            sides: vec![0.0; table.most_guards()],
            bounce: None,
        }
    }

    /// From event to event up to the end.
    #[inline(always)]
    pub(super) fn through<M: Carry<Erased<'a, V>>>(
        &mut self,
        motion: &mut Motion,
        method: &mut M,
    ) -> Result<(), End> {
        // The statement that has just happened, by its line.
        let mut last: Option<u32> = None;
        self.settle(motion.time)?;
        // The statement that has happened with it and is still to be carried out.
        let mut with: Option<u32> = None;
        while motion.time < self.times.1 {
            let events = self.table.events[self.equations.mode()];
            if let Some(event) = self.begin(motion.time, events, last, with.take())? {
                self.happen(motion, event, &mut last)?;
                continue;
            }
            let mut watch = Watch::new(
                &self.equations,
                events,
                (motion.time, &self.state),
                &mut self.guards,
                &mut self.room,
                self.table.drivers.1,
            );
            let done = method.carry(
                (motion.time, self.times.1),
                &self.state,
                &self.options,
                &mut watch,
            );
            let (due, lost, step) = (watch.due, watch.lost, watch.step);
            self.state.clone_from(&watch.state);
            let statistics = *done.as_ref().unwrap_or(&Statistics::default());
            let mut trajectory = watch.recorder.finish(statistics);
            trajectory.switches = method.switches().to_vec();
            motion.time = trajectory.times()[trajectory.times().len() - 1];
            motion.end.copy_from_slice(trajectory.end());
            motion.statistics.add(&statistics);
            if motion.time > trajectory.times()[0] {
                motion.pieces.push(Piece {
                    mode: self.equations.mode(),
                    sides: self.sides_here(events),
                    trajectory,
                });
            }
            done.map_err(End::Ode)?;
            if let Some(event) = lost {
                return Err(End::Guard(event));
            }
            if step > 0.0 {
                self.options.first_step = Some(step);
            }
            if let Some(due) = due {
                motion.time = due.time;
                with = due.with.map(|event| events[event].line);
                self.happen(motion, due.event, &mut last)?;
            }
        }
        Ok(())
    }

    /// Notes the signs of the guards where a mode begins. Gives the event that happens there at once: its guard is zero
    /// and passes, or it has happened together with the last one.
    fn begin(
        &mut self,
        time: f64,
        events: &[EventEntry],
        last: Option<u32>,
        with: Option<u32>,
    ) -> Result<Option<usize>, End> {
        let Room {
            begin,
            there,
            terms: sizes,
            ..
        } = &mut self.room;
        begin.look(&self.equations, time, &self.state);
        let strange = |event: &usize| !begin.values[*event].is_finite();
        if let Some(event) = (0..events.len()).find(strange) {
            return Err(End::Guard(event));
        }
        // Only a small guard may be no more than the rounding of its terms.
        let is_small = |(event, entry): (usize, &EventEntry)| {
            let size = self.guards[event].size;
            entry.surface.is_none() && begin.values[event].abs() <= NEAR * size || size == 0.0
        };
        match events.iter().enumerate().any(is_small) {
            true => terms(&self.equations, time, &self.state, begin, there, sizes),
            false => sizes.clear(),
        }
        let mut due = None;
        for (event, entry) in events.iter().enumerate() {
            let (value, rate) = (begin.values[event], begin.rates[event]);
            // A rate that is no more than its rounding does not say where the guard goes.
            let is_still = rate.abs() <= NOISE * f64::EPSILON * sizes.rates[event];
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(value.abs()).max(sizes.values[event]);
            // The time is known to a rounding, and so is the guard.
            let blur = 4.0 * f64::EPSILON * (rate * time).abs();
            let is_zero = value.abs() <= guard.noise().max(blur);
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
            guard.still = (time, if is_still { sizes.rates[event] } else { 0.0 });
            if passes && guard.armed && due.is_none() {
                let instant = self.equations.instant(time);
                let is_permitted = self.equations.permits(event, &instant, &self.state);
                due = is_permitted.then_some(event);
            }
        }
        let kinks = events.len()..begin.values.len();
        for (guard, value) in self.guards[kinks.clone()]
            .iter_mut()
            .zip(&begin.values[kinks])
        {
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
    fn settle(&mut self, time: f64) -> Result<(), End> {
        let events = self.table.events[self.equations.mode()];
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
    fn sides_here(&self, events: &[EventEntry]) -> Vec<f64> {
        let surfaces = events.iter().filter(|entry| entry.surface.is_some());
        self.sides[..surfaces.count()].to_vec()
    }

    /// Puts the motion on a side of a switching surface.
    fn put(&mut self, surface: usize, side: f64) {
        self.sides[surface] = side;
        self.equations.side(surface, side);
    }

    /// The side to which a motion leaves a switching surface on which it is.
    fn leaving(&mut self, time: f64, event: usize, surface: usize) -> Result<f64, End> {
        for side in [1.0, -1.0] {
            self.put(surface, side);
            if self.guard(time, event).1 * side >= 0.0 {
                return Ok(side);
            }
        }
        Err(End::Held(event))
    }

    /// Value and rate of a guard here.
    fn guard(&mut self, time: f64, event: usize) -> (f64, f64) {
        let there = &mut self.room.there;
        there.look(&self.equations, time, &self.state);
        (there.values[event], there.rates[event])
    }

    /// Carries out an event.
    fn happen(
        &mut self,
        motion: &mut Motion,
        event: usize,
        last: &mut Option<u32>,
    ) -> Result<(), End> {
        let from = self.equations.mode();
        let entry = &self.table.events[from][event];
        let (guard, rate) = self.guard(motion.time, event);
        self.arrival = rate;
        let instant = self.equations.instant(motion.time);
        let mut after = self.state.clone();
        self.equations
            .jump(event, &instant, &self.state, &mut after);
        let plain = |state: &V| state.as_ref().to_vec();
        let before = motion.events.last().map(|one| one.time);
        let happened = Happened {
            time: motion.time,
            from,
            event,
            to: entry.target,
            before: plain(&self.state),
            after: plain(&after),
            guard,
        };
        motion.end.copy_from_slice(&happened.after);
        motion.mode = entry.target;
        motion.events.push(happened);
        self.state = after;
        let noise = self.guards[event].noise();
        let size = self.guards[event].size;
        if entry.target != from {
            self.equations.enter(entry.target);
            for (guard, looked) in self.guards.iter_mut().zip(&mut self.looked[from]) {
                *looked = guard.looked;
            }
            let known = self.looked[entry.target].iter();
            for (guard, looked) in self.guards.iter_mut().zip(known) {
                *guard = Guard {
                    looked: *looked,
                    ..Guard::default()
                };
            }
            self.room.resize(self.table.guards(entry.target));
        }
        *last = Some(entry.line);
        self.count(motion, before)?;
        // Between this event and the last of the same kind the guard rose above zero by less than it can be told from.
        let same = self.table.events[entry.target]
            .iter()
            .position(|one| one.line == entry.line);
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
        self.bounce = same.map(|event| {
            let (_, rate) = self.guard(motion.time, event);
            (entry.line, motion.time, rate)
        });
        if let Some(event) = same {
            self.guards[event].size = size;
        }
        match lost {
            Some((_, time, _)) => Err(End::Chatter {
                since: self.since.0.min(time),
                events: self.since.1.max(2),
            }),
            None => Ok(()),
        }
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
            true => Err(End::Chatter {
                since: self.since.0,
                events: self.since.1,
            }),
            false => Ok(()),
        }
    }
}
