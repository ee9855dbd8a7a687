//! The motion of a scene: of a run, of a steady state, through events or without.

use super::changes;
use super::error::{Error, unknown};
use super::estimate::Estimate;
use super::position::Position;
use super::question::Question;
use super::status::Status;
use crate::hybrid::{self, Cycle, Happened};
use crate::measure::Missing;
use crate::model::Model;
use crate::ode::Statistics;
use crate::periodic::{Multiplier, Orbit};
use crate::problem::{Phase, Span};
use crate::rest::Rest;
use crate::settings::Settings;
use crate::shape::{Energy, Shape, Subject, find};
use crate::stiff::Switch;

/// Parts of a step in which a value is looked for, and halvings that bring one down to neighbouring numbers.
const PARTS: usize = 8;
const HALVINGS: usize = 60;
/// Roundings of a time by which it may be wrong when an event happens.
const BLUR: f64 = 64.0;

/// The motion of a scene over its task.
#[derive(Clone)]
pub struct Motion {
    pub(super) question: Question,
    /// Unbegun where there is no task, without states where the scene has none.
    pub(super) path: hybrid::Motion,
    pub(super) repeats: Option<Repeats>,
    /// How it was found.
    pub settings: Settings,
    /// Seconds that it took.
    pub seconds: f64,
}

/// What is known of a motion that repeats.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// Periods after which it repeats.
    pub multiple: usize,
    /// Periods that the motion from the start values was followed until it repeats: they pick it where several attract.
    /// None where nothing attracts, or the equations are affine and have one motion.
    pub followed: Option<usize>,
    /// The Floquet multipliers, the largest modulus first.
    pub multipliers: Vec<Multiplier>,
    /// Amplification of relative errors into the motion. It grows without bound at a resonance.
    pub condition: f64,
    /// Largest change of a state after it has repeated, over its scale.
    pub residual: f64,
    /// Free motions that repeat too and are not driven: any amount of them could be added.
    pub free: usize,
}

impl Repeats {
    pub(super) fn of_cycle(cycle: Cycle) -> (hybrid::Motion, Option<Self>) {
        let repeats = Self {
            multiple: cycle.multiple,
            followed: Some(cycle.followed),
            multipliers: cycle.multipliers,
            condition: cycle.condition,
            residual: cycle.residual,
            free: 0,
        };
        let multipliers = repeats.multipliers.clone();
        (hybrid::Motion { multipliers, ..cycle.motion }, Some(repeats))
    }

    pub(super) fn of_orbit(orbit: Orbit) -> (hybrid::Motion, Option<Self>) {
        let repeats = Self {
            multiple: orbit.multiple,
            followed: orbit.followed,
            multipliers: orbit.multipliers,
            condition: orbit.condition,
            residual: orbit.residual,
            free: orbit.free,
        };
        let multipliers = repeats.multipliers.clone();
        (hybrid::Motion { multipliers, ..hybrid::Motion::of(orbit.trajectory) }, Some(repeats))
    }
}

impl Motion {
    /// The scene with its values.
    pub fn model(&self) -> &dyn Model {
        self.question.model.as_ref()
    }

    /// What the scene is made of.
    pub fn shape(&self) -> &Shape {
        self.model().shape()
    }

    /// The pieces between events, as the solvers have them.
    pub fn path(&self) -> &hybrid::Motion {
        &self.path
    }

    /// What is known of a motion that repeats; none of a run.
    pub fn repeats(&self) -> Option<&Repeats> {
        self.repeats.as_ref()
    }

    /// What is known of a position of rest; none of what moves.
    pub fn rest(&self) -> Option<&Rest> {
        self.path.rest.as_ref()
    }

    /// Floquet multipliers, the largest modulus first; none of a run.
    pub fn multipliers(&self) -> &[Multiplier] {
        self.repeats().map_or(&[], |repeats| &repeats.multipliers)
    }

    /// Periods after which the motion repeats.
    pub fn multiple(&self) -> usize {
        self.repeats().map_or(1, |repeats| repeats.multiple)
    }

    /// The time after which the motion repeats, in seconds; none of a run.
    pub fn length(&self) -> Option<f64> {
        self.repeats().map(|_| self.path.time)
    }

    /// What the solution took.
    pub fn statistics(&self) -> &Statistics {
        &self.path.statistics
    }

    /// Where `auto` changed the method on the way; none of a motion that repeats.
    pub fn switches(&self) -> Vec<Switch> {
        match self.repeats {
            Some(_) => Vec::new(),
            None => self.path.switches().collect(),
        }
    }

    /// The mode at the begin.
    pub fn first_mode(&self) -> usize {
        match self.repeats {
            Some(_) => self.path.mode,
            None => self.question.mode,
        }
    }

    /// The task: of a motion that repeats all of its periods.
    pub fn task(&self) -> Span {
        self.length().map_or(self.question.span, Span::Periodic)
    }

    /// How far it is an answer.
    pub fn status(&self) -> Status {
        Status::of(self)
    }

    /// Everything that the scene says at a time. A motion that repeats goes on for ever; beyond the ends of a run it is
    /// where the run ends.
    pub fn at(&self, time: f64) -> Position {
        let time = match self.length() {
            Some(length) if length > 0.0 => time.rem_euclid(length),
            _ => time,
        };
        self.at_exactly(time)
    }

    /// Mode and state at a time of the task; at an event, those after it.
    pub fn place(&self, time: f64) -> (usize, Vec<f64>) {
        self.path.at(time)
    }

    /// A state or output by its name at a time, SI units.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn value(&self, name: &str, time: f64) -> Result<f64, Error> {
        let subject = self.subject(name)?;
        Ok(self.at(time)[subject])
    }

    /// An output by its name at a time, SI units.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn output(&self, name: &str, time: f64) -> Result<f64, Error> {
        let outputs = self.shape().outputs;
        let place = find(outputs, name);
        match place {
            Some(index) => Ok(self.at(time).outputs[index]),
            None => Err(unknown(name, outputs.iter().map(|one| one.name))),
        }
    }

    /// What a name stands for: a state, or else an output.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn subject(&self, name: &str) -> Result<Subject, Error> {
        let (states, outputs) = (self.shape().states, self.shape().outputs);
        let state = find(states, name).map(Subject::State);
        let subject = state.or_else(|| find(outputs, name).map(Subject::Output));
        subject.ok_or_else(|| unknown(name, states.iter().chain(outputs).map(|one| one.name)))
    }

    /// The first time of the task at which something has a value; none if it never has it.
    pub fn first_time(&self, subject: Subject, value: f64) -> Option<f64> {
        let off =
            |time: f64| Some(self.values(&[subject], time)[0] - value).filter(|off| !off.is_nan());
        let steps = self.steps();
        let mut before: Option<(f64, f64)> = None;
        for step in steps.windows(2) {
            for part in 0..=PARTS {
                let time = step[0] + (step[1] - step[0]) * part as f64 / PARTS as f64;
                let here = off(time)?;
                if here == 0.0 {
                    return Some(time);
                }
                match before {
                    Some((from, last)) if last * here < 0.0 => {
                        return Some(halved(&off, (from, time), last));
                    }
                    _ => before = Some((time, here)),
                }
            }
        }
        None
    }

    /// The position at a time of the task, of which the end is not the begin.
    pub fn at_exactly(&self, time: f64) -> Position {
        let (mode, state) = self.place(time);
        let phase = Phase { mode, sides: self.path.sides(time) };
        let model = self.model();
        Position {
            rates: model.rates_on(phase, time, &state),
            outputs: model.outputs_on(phase, time, &state),
            time,
            mode,
            state,
        }
    }

    /// Some subjects at a time of the task, SI units; NaN where a subject has no value at one time.
    pub fn values(&self, subjects: &[Subject], time: f64) -> Vec<f64> {
        let (mode, state) = self.place(time);
        let phase = Phase { mode, sides: self.path.sides(time) };
        self.values_on(subjects, phase, time, &state)
    }

    /// Some subjects in a phase at a time and state.
    pub(super) fn values_on(
        &self,
        subjects: &[Subject],
        phase: Phase<'_, f64>,
        time: f64,
        state: &[f64],
    ) -> Vec<f64> {
        let asks = |kind: fn(&Subject) -> bool| subjects.iter().any(kind);
        let model = self.model();
        let rates = match asks(|one| matches!(one, Subject::Rate(_))) {
            true => model.rates_on(phase, time, state),
            false => Vec::new(),
        };
        let outputs = match asks(|one| matches!(one, Subject::Output(_))) {
            true => model.outputs_on(phase, time, state),
            false => Vec::new(),
        };
        let position = Position { time, mode: phase.mode, state: state.to_vec(), rates, outputs };
        let energy = |which: Energy| {
            let (kinetic, potential) = model.reports().energy(phase, time, state)?;
            Some(match which {
                Energy::Kinetic => kinetic,
                Energy::Potential => potential,
                Energy::Both => kinetic + potential,
            })
        };
        let values = subjects.iter().map(|subject| match subject {
            Subject::Energy(which) => energy(*which),
            other => position.get(*other),
        });
        values.map(|value| value.unwrap_or(f64::NAN)).collect()
    }

    /// The measures of the run, in the order of the file, SI units.
    pub fn measures(&self) -> Vec<Result<f64, Missing>> {
        self.model().measure(&self.path)
    }

    /// A measure of the run by its name, SI units.
    ///
    /// # Errors
    /// [`Error::Unknown`]; [`Error::Missing`], if the run does not have it.
    pub fn measure(&self, name: &str) -> Result<f64, Error> {
        let shape = self.shape();
        let Some(index) = find(shape.measures, name) else {
            return Err(unknown(name, shape.measures.iter().map(|one| one.name)));
        };
        let modes: Vec<&str> = shape.modes.iter().map(|mode| mode.name).collect();
        self.measures()[index].map_err(|why| Error::Missing {
            name: shape.measures[index].name,
            reason: why.text(&modes),
        })
    }

    /// The events that have happened, in their order.
    pub fn events(&self) -> &[Happened] {
        &self.path.events
    }

    /// Number of events up to a time.
    pub fn passed(&self, time: f64) -> usize {
        self.events().partition_point(|event| event.time <= time)
    }

    /// The times at which closures that hold the coordinates depend on each other for an instant: there the motion might go
    /// on in several ways, and goes on by its momentum. None where loops are closed in closed form.
    pub fn change_points(&self) -> Vec<f64> {
        changes::times(self)
    }

    /// Whether a time cannot be told from that of an event.
    pub fn is_beside_event(&self, time: f64) -> bool {
        let near = BLUR * f64::EPSILON * time.abs();
        self.passed(time + near) != self.passed(time - near)
    }

    /// Whether as much happens in it as in another motion.
    pub fn is_like(&self, other: &Self) -> bool {
        self.events().len() == other.events().len() && self.multiple() == other.multiple()
    }

    /// Times of the steps.
    pub fn steps(&self) -> Vec<f64> {
        let pieces = self.path.pieces.iter();
        let times = pieces.flat_map(|piece| piece.trajectory.times());
        times.copied().collect()
    }

    /// How accurate this motion is, by solving the same task again with other tolerances.
    ///
    /// # Errors
    /// When neither of the other tolerances comes out.
    pub fn estimate(&self) -> Result<Estimate, Error> {
        Estimate::of(self)
    }

    /// The largest estimated error of a state or output over the task, by its name, SI units. The task is solved twice more;
    /// to ask for several take [`Motion::estimate`].
    ///
    /// # Errors
    /// [`Error::Unknown`]; or why the other solutions do not come out.
    pub fn estimated_error(&self, name: &str) -> Result<f64, Error> {
        let subjects = [self.subject(name)?];
        let steps = self.steps();
        let middles = steps.windows(2).map(|step| 0.5 * (step[0] + step[1]));
        let times: Vec<f64> = steps.iter().copied().chain(middles).collect();
        let errors = self.estimate()?.largest(self, &subjects, &times);
        Ok(errors.first().copied().unwrap_or(f64::NAN))
    }
}

/// Where what has one sign at the begin of a stretch, and the other at its end, is zero.
fn halved(off: &dyn Fn(f64) -> Option<f64>, (mut from, mut to): (f64, f64), begin: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = from + 0.5 * (to - from);
        match off(middle) {
            Some(here) if here * begin > 0.0 => from = middle,
            _ => to = middle,
        }
    }
    to
}

impl std::fmt::Debug for Motion {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Motion")
            .field("scene", &self.shape().name)
            .field("task", &self.task())
            .field("steps", &self.statistics().steps)
            .field("events", &self.events().len())
            .field("repeats", &self.repeats)
            .finish_non_exhaustive()
    }
}
