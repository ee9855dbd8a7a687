//! The motion from event to event.

use super::error::HybridError;
use super::motion::{Happened, Motion, Piece};
use super::problem::{EventEntry, Hybrid, Modes};
use super::rounding::terms;
use super::watch::{Guard, Watch};
use super::{CHATTER, NOISE, SOON, TURNS};
use crate::dispatch::{Task, dispatch};
use crate::ode::{Dop853, Method, OdeError, Options, Statistics, Tsit5, Workspace};
use crate::ode::{Plain, integrate, state_from};
use crate::problem::Equations;
use crate::registry::{self, Settings};
use crate::scalar::Scalar;

/// The motion of a scene with modes from a start, on the scalar type that is fastest on the machine at hand.
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
    dispatch(Marching {
        scene,
        mode,
        times,
        start,
        settings,
    })
}

/// The task of [`march`].
struct Marching<'a, C> {
    scene: &'a C,
    mode: usize,
    times: (f64, f64),
    start: &'a [f64],
    settings: &'a Settings,
}

impl<C: Hybrid> Task for Marching<'_, C> {
    type Output = Result<Motion, HybridError>;
    const LARGE: bool = C::LARGE;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Self::Output {
        march_on::<C, S>(self.scene, self.mode, self.times, self.start, self.settings)
    }
}

/// The motion of a scene with modes from a start in a mode, evaluated on a scalar type.
///
/// # Errors
/// [`HybridError`], with the motion so far.
#[inline(always)]
pub fn march_on<C: Hybrid, S: Scalar>(
    scene: &C,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let mut equations = scene.modal::<S>();
    if mode >= C::EVENTS.len() {
        return Err(HybridError::Start {
            reason: format!(
                "there are {} modes, and it is to begin in number {mode}",
                C::EVENTS.len()
            ),
        });
    }
    equations.enter(mode);
    let mut motion = Motion {
        mode,
        ..Motion::at_rest(times.0, start)
    };
    let options = Options::scaled(settings.rtol, C::SCALES);
    let begun = (|| {
        options.check(times, C::STATES)?;
        if times.1 < times.0 {
            return Err(OdeError::BadOption {
                name: "times",
                reason: format!(
                    "from {} s to {} s runs backwards, and events happen forwards",
                    times.0, times.1
                ),
            });
        }
        state_from::<S, _>(&equations, start)
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
    let moving = C::HELD[mode].iter().find(|place| start[**place] != 0.0);
    if let Some(place) = moving {
        let (name, value) = (C::STATE_NAMES[*place], start[*place]);
        return Err(HybridError::Start {
            reason: format!(
                "{name} is {value} in SI units, and the mode in which the motion begins holds it at zero"
            ),
        });
    }
    let mut run = Run::<C, S> {
        equations,
        state,
        options,
        times,
        guards: vec![Guard::default(); most_events::<C>()],
        since: (times.0, 0),
        turns: 0,
        sides: vec![0.0; most_events::<C>()],
        bounce: None,
    };
    let ended = match settings.method {
        registry::Method::Tsit5 => run.through::<Tsit5>(&mut motion),
        registry::Method::Dop853 => run.through::<Dop853>(&mut motion),
    };
    match ended {
        Ok(()) => Ok(motion),
        Err(end) => Err(end.with(motion)),
    }
}

/// The largest number of events of a mode.
fn most_events<C: Hybrid>() -> usize {
    C::EVENTS
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
struct Run<C: Hybrid, S: Scalar> {
    equations: C::Modal<S>,
    state: <C::Modal<S> as Equations<S>>::State,
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

impl<C: Hybrid, S: Scalar> Run<C, S> {
    /// From event to event up to the end.
    #[inline(always)]
    fn through<M: Method>(&mut self, motion: &mut Motion) -> Result<(), End> {
        let mut workspace = Workspace::<_, M>::new::<S, _>(&Plain(&self.equations));
        // The statement that has just happened, by its line.
        let mut last: Option<u32> = None;
        self.settle(motion.time)?;
        // The statement that has happened with it and is still to be carried out.
        let mut with: Option<u32> = None;
        while motion.time < self.times.1 {
            let events = C::EVENTS[self.equations.mode()];
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
            let done = integrate(
                &Plain(&self.equations),
                (motion.time, self.times.1),
                &self.state,
                &self.options,
                &mut workspace,
                &mut watch,
            );
            let (due, step) = (watch.due, watch.step);
            self.state.clone_from(&watch.state);
            let statistics = *done.as_ref().unwrap_or(&Statistics::default());
            let trajectory = watch.recorder.finish(statistics);
            motion.time = trajectory.times()[trajectory.times().len() - 1];
            motion.end.copy_from_slice(trajectory.end());
            motion.count(&statistics);
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
        let instant = self.equations.instant(S::from_f64(time));
        let mut values = vec![S::ZERO; events.len()];
        let mut rates = values.clone();
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
        let mut due = None;
        let terms = terms(&self.equations, time, &self.state, events.len());
        for (event, entry) in events.iter().enumerate() {
            let (value, rate) = (values[event].to_f64(), rates[event].to_f64());
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
        let events = C::EVENTS[self.equations.mode()];
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
        self.equations.side(surface, S::from_f64(side));
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
        let instant = self.equations.instant(S::from_f64(time));
        let count = C::EVENTS[self.equations.mode()].len();
        let (mut values, mut rates) = (vec![S::ZERO; count], vec![S::ZERO; count]);
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
        (values[event].to_f64(), rates[event].to_f64())
    }

    /// Carries out an event.
    fn happen(
        &mut self,
        motion: &mut Motion,
        event: usize,
        last: &mut Option<u32>,
    ) -> Result<(), End> {
        let from = self.equations.mode();
        let entry = &C::EVENTS[from][event];
        let instant = self.equations.instant(S::from_f64(motion.time));
        let count = C::EVENTS[from].len();
        let (mut values, mut rates) = (vec![S::ZERO; count], vec![S::ZERO; count]);
        self.equations
            .guards(&instant, &self.state, &mut values, &mut rates);
        let mut after = self.state.clone();
        self.equations
            .jump(event, &instant, &self.state, &mut after);
        let plain = |state: &<C::Modal<S> as Equations<S>>::State| {
            state
                .as_ref()
                .iter()
                .map(|one| one.to_f64())
                .collect::<Vec<f64>>()
        };
        let before = motion.events.last().map(|one| one.time);
        let happened = Happened {
            time: motion.time,
            from,
            event,
            to: entry.target,
            before: plain(&self.state),
            after: plain(&after),
            guard: values[event].to_f64(),
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
        let same = C::EVENTS[entry.target]
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
