//! One scene with its values: its task, its drivers, and where in the task a position is reached.

use assur::problem;
use assur::registry::{Run, SceneEntry};

use crate::constants::Constants;
use crate::error::Failure;
use crate::motion::Motion;
use crate::variables::{self, Variable};

/// Samples along a task when a position of a driver is sought.
const SEARCH: usize = 2048;

/// What the scene does, times in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Task {
    /// The steady state that repeats after this period.
    Periodic(f64),
    /// A motion from a time to a time.
    Run(f64, f64),
    /// Positions only, where they are asked for.
    Open,
}

impl Task {
    /// First and last time.
    pub fn limits(self) -> (f64, f64) {
        match self {
            Self::Periodic(period) => (0.0, period),
            Self::Run(from, to) => (from, to),
            Self::Open => (0.0, 0.0),
        }
    }
}

/// A scene with its values.
pub struct Case {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Its dimensions and parameters.
    pub constants: Constants,
    /// What is reported.
    pub variables: Vec<Variable>,
    /// What it does.
    pub task: Task,
    run: Box<dyn Run>,
}

impl Case {
    /// Fixes the values.
    ///
    /// # Errors
    /// When the mechanism refuses them, with its reason.
    pub fn new(constants: Constants) -> Result<Self, Failure> {
        let scene = constants.scene;
        let run = (scene.bind)(&constants.values).map_err(|refused| {
            Failure::request(format!(
                "scene `{}` does not accept these values",
                scene.name
            ))
            .place(match constants.given_names().as_slice() {
                [] => "the values of the file".to_owned(),
                names => format!("--set {}", names.join(", --set ")),
            })
            .reason(format!("{}: {}", refused.name, refused.reason))
            .remedy("change the value with --set, or leave it out for the default")
        })?;
        let task = match run.span() {
            problem::Span::Periodic(period) => Task::Periodic(period),
            problem::Span::Run(from, to) => Task::Run(from, to),
            problem::Span::Open => Task::Open,
        };
        let (from, to) = task.limits();
        if !(from.is_finite() && to.is_finite() && from <= to) {
            return Err(Failure::request(format!(
                "the task of scene `{}` would last from {from} s to {to} s",
                scene.name
            ))
            .remedy("change the value with --set that its period or its times depend on"));
        }
        Ok(Self {
            scene,
            variables: variables::of_scene(scene),
            constants,
            task,
            run,
        })
    }

    /// The scene as the solvers see it.
    pub fn run(&self) -> &dyn Run {
        self.run.as_ref()
    }

    /// Positions of the drivers at a time, SI units.
    pub fn drivers(&self, time: f64) -> Vec<f64> {
        self.run.drivers(time)
    }

    /// The time within the task at which a driver first reaches a position. In a steady state the position may lie any
    /// number of cycles away.
    ///
    /// # Errors
    /// The lowest and the highest position that are reached.
    pub fn time_of(&self, driver: usize, position: f64) -> Result<f64, (f64, f64)> {
        let at = |time: f64| {
            self.run
                .drivers(time)
                .get(driver)
                .copied()
                .unwrap_or(f64::NAN)
        };
        let (from, to) = match self.task {
            Task::Open => (0.0, 1.0),
            _ => self.task.limits(),
        };
        let (first, last) = (at(from), at(to));
        let advance = last - first;
        let position = match self.task {
            Task::Periodic(_) if advance != 0.0 => {
                position - ((position - first) / advance).floor() * advance
            }
            _ => position,
        };
        let near = 1e-12 * (first.abs() + last.abs() + position.abs()).max(f64::MIN_POSITIVE);
        let time = |index: usize| from + (to - from) * index as f64 / SEARCH as f64;
        let (mut low, mut high) = (first, first);
        for index in 0..=SEARCH {
            let here = at(time(index));
            if (here - position).abs() <= near {
                return Ok(time(index));
            }
            low = low.min(here);
            high = high.max(here);
            if index < SEARCH && (here - position) * (at(time(index + 1)) - position) < 0.0 {
                return Ok(bisect(
                    |time| at(time) - position,
                    time(index),
                    time(index + 1),
                ));
            }
        }
        Err((low, high))
    }

    /// The time of the task that a given time means: in a steady state every cycle is like the first.
    pub fn reduce(&self, time: f64) -> Option<f64> {
        match self.task {
            Task::Periodic(period) if period > 0.0 => Some(time.rem_euclid(period)),
            Task::Run(from, to) => (from..=to).contains(&time).then_some(time),
            _ => Some(time),
        }
    }

    /// All variables at a time of the task, SI units.
    pub fn sample(&self, motion: &Motion, time: f64) -> Vec<f64> {
        variables::evaluate(&self.variables, self.run(), time, &motion.state(time))
    }
}

fn bisect(function: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let rising = function(from) < 0.0;
    for _ in 0..80 {
        let middle = from + (to - from) / 2.0;
        if (function(middle) < 0.0) == rising {
            from = middle;
        } else {
            to = middle;
        }
    }
    to
}
