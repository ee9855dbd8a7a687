//! The motions that the solvers find for a scene.
//!
//! This is the only file that talks to the solvers.

use assur::hybrid::{self, CycleError, HybridError};
use assur::periodic::{self, PeriodicError};
use assur::problem::Span;
use assur::registry::{Run, SceneEntry, Settings};

use crate::case::Case;
use crate::error::Failure;
use crate::measures::Measured;
use crate::unfollowed;

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
            match self.run().span() {
                Span::Periodic(period) if !self.scene.modes.is_empty() => Path::Cycle(
                    self.run()
                        .cycle(period, &settings)
                        .map_err(|error| self.no_cycle(&error))?,
                ),
                Span::Autonomous => Path::Cycle(
                    self.run()
                        .clock(&settings)
                        .map_err(|error| self.no_cycle(&error))?,
                ),
                Span::Periodic(period) => Path::Orbit(
                    self.run()
                        .periodic(period, &settings)
                        .map_err(|error| self.not_periodic(&error))?,
                ),
                Span::Run(from, to) => Path::Through(
                    self.run()
                        .follow((from, to), &self.run().start(), &settings)
                        .map_err(|error| self.not_followed(&error))?,
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
        let (mode, start) = motion.place(self, from);
        let clock = std::time::Instant::now();
        self.run()
            .follow_in(mode, (from, to), &start, &motion.settings)
            .map_err(|error| self.not_followed(&error))?;
        Ok(clock.elapsed().as_secs_f64())
    }

    /// Name of a mode.
    pub fn mode(&self, mode: usize) -> &'static str {
        self.scene.modes.get(mode).map_or("", |mode| mode.name)
    }

    fn not_followed(&self, error: &HybridError) -> Failure {
        let told = unfollowed::tell(self.scene, error);
        Failure::numerical("the motion could not be followed to its end")
            .reason(told.reason)
            .remedy(told.remedy)
    }

    fn no_cycle(&self, error: &CycleError) -> Failure {
        if let CycleError::Motion(inner) = error {
            return self.not_followed(inner);
        }
        let told = unfollowed::tell_cycle(self.scene, error);
        Failure::numerical("no motion that repeats was found")
            .reason(told.reason)
            .remedy(told.remedy)
    }

    fn not_periodic(&self, error: &PeriodicError) -> Failure {
        if let PeriodicError::NotSettled(inner) = error {
            return self.no_cycle(inner);
        }
        Failure::numerical("no steady state was found")
            .reason(error.to_string())
            .remedy("near a resonance move the speed a little, or choose a scene with damping; else try a smaller --rtol")
    }
}

/// The motion of one of many runs over its task; if there is none, why, in words.
///
/// # Errors
/// When the solver does not succeed, or the scene has no task.
pub fn over_task(
    scene: &SceneEntry,
    run: &dyn Run,
    settings: &Settings,
) -> Result<hybrid::Motion, String> {
    match run.span() {
        Span::Periodic(period) if run.mode_count() > 0 => {
            let cycle = run.cycle(period, settings);
            let told = |error: CycleError| unfollowed::tell_cycle(scene, &error).reason;
            cycle.map(|cycle| cycle.motion).map_err(told)
        }
        Span::Autonomous => {
            let cycle = run.clock(settings);
            let told = |error: CycleError| unfollowed::tell_cycle(scene, &error).reason;
            cycle.map(|cycle| cycle.motion).map_err(told)
        }
        Span::Periodic(period) => {
            let orbit = run.periodic(period, settings);
            orbit
                .map(|orbit| hybrid::Motion::of(orbit.trajectory))
                .map_err(|error| error.to_string())
        }
        Span::Run(from, to) => {
            let told = |error: HybridError| unfollowed::tell(scene, &error).reason;
            run.follow((from, to), &run.start(), settings).map_err(told)
        }
        Span::Open => Err("the scene has no task".to_owned()),
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
    Through(hybrid::Motion),
    Cycle(hybrid::Cycle),
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
    /// Evaluations of the Jacobian.
    pub jacobians: usize,
    /// Steps taken by a stiff method.
    pub stiff_steps: usize,
}

impl Motion {
    /// Mode and state at a time of the task.
    pub fn place(&self, case: &Case, time: f64) -> (usize, Vec<f64>) {
        let first = case.run().first_mode();
        match &self.path {
            Path::Positions => (first, Vec::new()),
            Path::Start(state) => (first, state.clone()),
            Path::Orbit(orbit) => (first, orbit.trajectory.at(time)),
            Path::Through(motion) => motion.at(time),
            Path::Cycle(cycle) => cycle.motion.at(time),
        }
    }

    /// The events that have happened, in their order.
    pub fn events(&self) -> &[hybrid::Happened] {
        match &self.path {
            Path::Through(motion) => &motion.events,
            Path::Cycle(cycle) => &cycle.motion.events,
            _ => &[],
        }
    }

    /// The measures of the run.
    pub fn measures(&self, case: &Case) -> Vec<Measured> {
        let found = match &self.path {
            Path::Orbit(orbit) => {
                let motion = hybrid::Motion::of(orbit.trajectory.clone());
                case.run().measure(&motion)
            }
            Path::Through(motion) => case.run().measure(motion),
            Path::Cycle(cycle) => case.run().measure(&cycle.motion),
            Path::Positions | Path::Start(_) => Vec::new(),
        };
        let measures = case.scene.measures.iter().zip(found);
        let measures = measures.map(|(quantity, value)| Measured {
            quantity,
            value,
            error: f64::NAN,
        });
        measures.collect()
    }

    /// Number of events up to a time.
    pub fn passed(&self, time: f64) -> usize {
        self.events().partition_point(|event| event.time <= time)
    }

    /// Floquet multipliers; none unless the task is a steady state.
    pub fn multipliers(&self) -> &[periodic::Multiplier] {
        match &self.path {
            Path::Orbit(orbit) => &orbit.multipliers,
            Path::Cycle(cycle) => &cycle.multipliers,
            _ => &[],
        }
    }

    /// The time after which the motion repeats, in seconds; none unless the task is a steady state.
    pub fn length(&self) -> Option<f64> {
        match &self.path {
            Path::Orbit(orbit) => orbit.trajectory.times().last().copied(),
            Path::Cycle(cycle) => Some(cycle.motion.time),
            _ => None,
        }
    }

    /// Periods that the motion from the start values was followed until it repeated; none where they pick nothing.
    pub fn followed(&self) -> Option<usize> {
        match &self.path {
            Path::Orbit(orbit) => orbit.followed,
            Path::Cycle(cycle) => Some(cycle.followed),
            _ => None,
        }
    }

    /// Periods after which the motion repeats.
    pub fn multiple(&self) -> usize {
        match &self.path {
            Path::Orbit(orbit) => orbit.multiple,
            Path::Cycle(cycle) => cycle.multiple,
            _ => 1,
        }
    }

    /// The mode at the begin.
    pub fn first_mode(&self, case: &Case) -> usize {
        match &self.path {
            Path::Cycle(cycle) => cycle.motion.mode,
            _ => case.run().first_mode(),
        }
    }

    /// Condition number of a steady state, residual after a period over the scales, and number of free motions that
    /// nothing determines; none unless the task is a steady state.
    pub fn closing(&self) -> Option<(f64, f64, usize)> {
        match &self.path {
            Path::Orbit(orbit) => Some((orbit.condition, orbit.residual, orbit.free)),
            Path::Cycle(cycle) => Some((cycle.condition, cycle.residual, 0)),
            _ => None,
        }
    }

    /// Where `auto` changed the method: the times, and whether to the stiff one.
    pub fn switches(&self) -> Vec<(f64, bool)> {
        match &self.path {
            Path::Through(motion) => motion
                .switches()
                .map(|switch| (switch.time, switch.stiff))
                .collect(),
            _ => Vec::new(),
        }
    }

    /// The work that was done.
    pub fn effort(&self) -> Effort {
        let statistics = match &self.path {
            Path::Positions | Path::Start(_) => return Effort::default(),
            Path::Orbit(orbit) => &orbit.trajectory.statistics,
            Path::Through(motion) => &motion.statistics,
            Path::Cycle(cycle) => &cycle.motion.statistics,
        };
        Effort {
            steps: statistics.steps,
            rejected: statistics.rejected,
            evaluations: statistics.evaluations,
            jacobians: statistics.jacobians,
            stiff_steps: statistics.stiff_steps,
        }
    }
}
