//! The motions that the solvers find for a scene.
//!
//! This is the only file that talks to the solvers.

use assur::problem::Span;
use assur::registry::Settings;
use assur::{ode, periodic};

use crate::case::Case;
use crate::error::Failure;

impl Case {
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
                Span::Periodic(period) => Path::Orbit(
                    self.run()
                        .periodic(period, &settings)
                        .map_err(|error| not_periodic(&error))?,
                ),
                Span::Run(from, to) => Path::Trajectory(
                    self.run()
                        .march((from, to), &self.run().start(), &settings)
                        .map_err(|error| not_marched(&error))?,
                ),
                Span::Open => Path::Start(self.run().start()),
            }
        };
        Ok(Motion {
            path,
            settings,
            seconds: clock.elapsed().as_secs_f64(),
        })
    }

    /// Seconds that following the motion over one cycle takes, or over the run.
    ///
    /// # Errors
    /// When the integration does not succeed.
    pub fn time_cycle(&self, motion: &Motion) -> Result<f64, Failure> {
        let (from, to) = self.task.limits();
        let start = motion.state(from);
        let clock = std::time::Instant::now();
        self.run()
            .march((from, to), &start, &motion.settings)
            .map_err(|error| not_marched(&error))?;
        Ok(clock.elapsed().as_secs_f64())
    }
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

    /// Condition number of a steady state, residual after a period over the scales, and number of free motions that
    /// nothing determines; none unless the task is a steady state.
    pub fn closing(&self) -> Option<(f64, f64, usize)> {
        match &self.path {
            Path::Orbit(orbit) => Some((orbit.condition, orbit.residual, orbit.free)),
            _ => None,
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
