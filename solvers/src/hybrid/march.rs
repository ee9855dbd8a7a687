//! The motion from event to event.

use super::carry::{Carry, Explicit, Stiff};
use super::erased::{Erased, Model, Own, Table};
use super::error::HybridError;
use super::motion::{Happened, Motion, Piece};
use super::problem::{EventEntry, Hybrid, Modes};
use super::rounding::terms;
use super::watch::{Guard, Watch};
use super::{CHATTER, NOISE, SOON, TURNS};
use crate::ode::{Dop853, OdeError, Options, Statistics, Tsit5, state_from};
use crate::problem::{Equations, Storage};
use crate::registry::{self, Settings};

/// The motion of a scene with modes from a start.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march<C: Hybrid>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    march_in(scene, C::FIRST, times, start, settings)
}

/// The same from a start in any mode.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march_in<C: Hybrid>(
    scene: &C,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let mut model = Own::new(scene.modal::<f64>());
    follow(&mut model, &Table::of::<C>(), mode, times, start, settings)
}

/// The motion of any equations. States of a usual length, one to three coordinates with their speeds, are arrays.
#[inline(never)]
fn follow(
    model: &mut dyn Model,
    table: &Table,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let by = match model.states() {
        2 => by_method::<[f64; 2]>,
        4 => by_method::<[f64; 4]>,
        6 => by_method::<[f64; 6]>,
        _ => by_method::<Vec<f64>>,
    };
    by(model, table, mode, times, start, settings)
}

fn by_method<V: Storage<f64>>(
    model: &mut dyn Model,
    table: &Table,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let way = (mode, times, start, settings);
    match settings.method {
        registry::Method::Tsit5 => march_by::<V, Explicit<V, Tsit5>>(model, table, way),
        registry::Method::Dop853 => march_by::<V, Explicit<V, Dop853>>(model, table, way),
        _ => march_by::<V, Stiff>(model, table, way),
    }
}

/// The motion by a method.
fn march_by<'a, V: Storage<f64>, M: Carry<f64, Erased<'a, V>>>(
    model: &'a mut dyn Model,
    table: &Table,
    (mode, times, start, settings): (usize, (f64, f64), &[f64], &Settings),
) -> Result<Motion, HybridError> {
    let mut equations = Erased::<V>::new(model);
    if mode >= table.events.len() {
        return Err(HybridError::Start {
            reason: format!(
                "there are {} modes, and it is to begin in number {mode}",
                table.events.len()
            ),
        });
    }
    equations.enter(mode);
    let mut motion = Motion {
        mode,
        ..Motion::at_rest(times.0, start)
    };
    let options = Options::scaled(settings.rtol, table.scales);
    let begun = (|| {
        options.check(times, table.scales.len())?;
        if times.1 < times.0 {
            return Err(OdeError::BadOption {
                name: "times",
                reason: format!(
                    "from {} s to {} s runs backwards, and events happen forwards",
                    times.0, times.1
                ),
            });
        }
        state_from::<f64, _>(&equations, start)
    })();
    let state = match begun {
        Ok(state) => state,
        Err(error) => {
            return Err(HybridError::Ode {
                error,
                mode,
                motion: Box::new(motion),
            });
        }
    };
    let moving = table.held[mode].iter().find(|place| start[**place] != 0.0);
    if let Some(place) = moving {
        let (name, value) = (table.names[*place], start[*place]);
        return Err(HybridError::Start {
            reason: format!(
                "{name} is {value} in SI units, and the mode in which the motion begins holds it at zero"
            ),
        });
    }
    let mut run = Run {
        equations,
        table,
        state,
        options,
        times,
        guards: vec![Guard::default(); most_events(table)],
        since: (times.0, 0),
        turns: 0,
        sides: vec![0.0; most_events(table)],
        bounce: None,
    };
    let mut method = M::new(&run.equations, settings.method);
    match run.through(&mut motion, &mut method) {
        Ok(()) => Ok(motion),
        Err(end) => Err(end.with(motion)),
    }
}

/// The largest number of events of a mode.
fn most_events(table: &Table) -> usize {
    table
        .events
        .iter()
        .map(|events| events.len())
        .max()
        .unwrap_or(0)
}

/// Why the motion ends early.
enum End {
    Ode(OdeError),
    Loop(Vec<usize>),
    Chatter { since: f64, events: usize },
    Held(usize),
}

impl End {
    #[cold]
    fn with(self, motion: Motion) -> HybridError {
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
struct Run<'a, 'b, V> {
    equations: Erased<'a, V>,
    table: &'b Table,
    state: V,
    options: Options,
    times: (f64, f64),
    guards: Vec<Guard>,
    /// When events began to follow each other quickly, and how many there have been since.
    since: (f64, usize),
    /// On which side of each switching surface the motion is.
    sides: Vec<f64>,
    /// Events at this instant.
    turns: usize,
    /// The last event: its line, its time, and the rate of its guard after it.
    bounce: Option<(u32, f64, f64)>,
}

impl<'a, V: Storage<f64>> Run<'a, '_, V> {
    /// From event to event up to the end.
    #[inline(always)]
    fn through<M: Carry<f64, Erased<'a, V>>>(
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
            if let Some(event) = self.begin(motion.time, events, last, with.take()) {
                self.happen(motion, event, &mut last)?;
                continue;
            }
            let mut watch = Watch::new(
                &self.equations,
                events,
                motion.time,
                &self.state,
                &mut self.guards,
            );
            let done = method.carry(
                (motion.time, self.times.1),
                &self.state,
                &self.options,
                &mut watch,
            );
            let (due, step) = (watch.due, watch.step);
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
    ) -> Option<usize> {
        let instant = self.equations.instant(time);
        let mut values = vec![0.0; events.len()];
        let mut rates = values.clone();
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
        let mut due = None;
        let terms = terms(&self.equations, time, &self.state, events.len());
        for (event, entry) in events.iter().enumerate() {
            let (value, rate) = (values[event], rates[event]);
            // A rate that is no more than its rounding does not say where the guard goes.
            let is_still = rate.abs() <= NOISE * f64::EPSILON * terms[event].rate;
            let guard = &mut self.guards[event];
            guard.size = guard.size.max(value.abs()).max(terms[event].value);
            // The time is known to a rounding, and so is the guard.
            let blur = 4.0 * f64::EPSILON * (rate * time).abs();
            let is_zero = value.abs() <= guard.noise().max(blur);
            if let Some(surface) = entry.surface {
                (guard.sign, guard.armed) = (self.sides[surface], true);
                continue;
            }
            guard.armed = last != Some(entry.line);
            guard.sign = match is_zero {
                true => 0.0,
                false => value.signum(),
            };
            let passes = is_zero && !is_still && entry.direction.allows(rate > 0.0)
                || with == Some(entry.line);
            if passes
                && guard.armed
                && due.is_none()
                && self.equations.permits(event, &instant, &self.state)
            {
                due = Some(event);
            }
            guard.still = (time, if is_still { terms[event].rate } else { 0.0 });
            if is_zero && !is_still && !guard.armed {
                guard.sign = rate.signum();
            }
        }
        due
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
    fn guard(&self, time: f64, event: usize) -> (f64, f64) {
        let instant = self.equations.instant(time);
        let count = self.table.events[self.equations.mode()].len();
        let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
        (values[event], rates[event])
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
        let instant = self.equations.instant(motion.time);
        let count = self.table.events[from].len();
        let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
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
            guard: values[event],
        };
        motion.end.copy_from_slice(&happened.after);
        motion.mode = entry.target;
        motion.events.push(happened);
        self.state = after;
        let noise = self.guards[event].noise();
        let size = self.guards[event].size;
        self.equations.enter(entry.target);
        if entry.target != from {
            self.guards.fill(Guard::default());
        }
        *last = Some(entry.line);
        self.count(motion, before)?;
        // Between this event and the last of the same kind the guard rose above zero by less than it can be told from.
        let same = self.table.events[entry.target]
            .iter()
            .position(|one| one.line == entry.line);
        let lost = self.bounce.is_some_and(|(line, time, rate)| {
            line == entry.line && motion.time > time && (motion.time - time) * rate.abs() <= noise
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
            true => Err(End::Chatter {
                since: self.since.0,
                events: self.since.1,
            }),
            false => Ok(()),
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
