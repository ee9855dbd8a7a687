//! One scene with its values, and the motions that the solvers find for it.
//!
//! This is the only file that talks to the solvers.

use assur::registry::{Run, SceneEntry, Settings};
use assur::{ode, periodic, problem};

use crate::error::Failure;
use crate::values::Constants;
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
            .place(refused.name)
            .reason(refused.reason)
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

    /// Finds the motion.
    ///
    /// # Errors
    /// When the solver does not succeed, with the facts that it gives.
    pub fn solve(&self, settings: Settings) -> Result<Motion, Failure> {
        let clock = std::time::Instant::now();
        let path = if self.scene.states.is_empty() {
            Path::Positions
        } else {
            match self.task {
                Task::Periodic(period) => Path::Orbit(
                    self.run
                        .periodic(period, &settings)
                        .map_err(|error| not_periodic(&error))?,
                ),
                Task::Run(from, to) => Path::Trajectory(
                    self.run
                        .march((from, to), &self.run.start(), &settings)
                        .map_err(|error| not_marched(&error))?,
                ),
                Task::Open => Path::Start(self.run.start()),
            }
        };
        Ok(Motion {
            path,
            settings,
            seconds: clock.elapsed().as_secs_f64(),
        })
    }

    /// Nanoseconds that integrating over one cycle takes, or over the run.
    ///
    /// # Errors
    /// When the integration does not succeed.
    pub fn time_cycle(&self, motion: &Motion) -> Result<f64, Failure> {
        let (from, to) = self.task.limits();
        let start = motion.state(from);
        let clock = std::time::Instant::now();
        if start.is_empty() {
            return Ok(0.0);
        }
        self.run
            .march((from, to), &start, &motion.settings)
            .map_err(|error| not_marched(&error))?;
        Ok(clock.elapsed().as_secs_f64() * 1e9)
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

/// What the solvers found.
pub struct Motion {
    path: Path,
    /// How it was found.
    pub settings: Settings,
    /// Seconds that it took.
    pub seconds: f64,
}

enum Path {
    /// There is no state.
    Positions,
    /// There is no task: the declared start.
    Start(Vec<f64>),
    Orbit(periodic::Orbit),
    Trajectory(ode::Trajectory),
}

/// Work of a solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Steps taken.
    pub steps: usize,
    /// Steps rejected.
    pub rejected: usize,
    /// Evaluations of the derivative.
    pub evaluations: usize,
}

impl Motion {
    /// The state at a time of the task.
    pub fn state(&self, time: f64) -> Vec<f64> {
        match &self.path {
            Path::Positions => Vec::new(),
            Path::Start(state) => state.clone(),
            Path::Orbit(orbit) => orbit.trajectory.at(time),
            Path::Trajectory(trajectory) => trajectory.at(time),
        }
    }

    /// Floquet multipliers as real and imaginary parts; none unless the task is a steady state.
    pub fn multipliers(&self) -> Vec<(f64, f64)> {
        match &self.path {
            Path::Orbit(orbit) => orbit
                .multipliers
                .iter()
                .map(|value| (value.re, value.im))
                .collect(),
            _ => Vec::new(),
        }
    }

    /// The work that was done.
    pub fn effort(&self) -> Effort {
        let statistics = match &self.path {
            Path::Positions | Path::Start(_) => return Effort::default(),
            Path::Orbit(orbit) => &orbit.trajectory.statistics,
            Path::Trajectory(trajectory) => &trajectory.statistics,
        };
        Effort {
            steps: statistics.steps,
            rejected: statistics.rejected,
            evaluations: statistics.evaluations,
        }
    }
}

fn not_periodic(error: &periodic::PeriodicError) -> Failure {
    Failure::numerical("no steady state was found")
        .reason(error.to_string())
        .remedy("near a resonance move the speed a little, or choose a scene with damping; else try a smaller --rtol")
}

fn not_marched(error: &ode::OdeError) -> Failure {
    Failure::numerical("the motion could not be followed to its end")
        .reason(error.to_string())
        .remedy("check the values given with --set; else try another --method or --rtol")
}
