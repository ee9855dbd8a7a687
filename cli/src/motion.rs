//! The motions that the solvers find for a scene.
//!
//! This is the only file that talks to the solvers.

use assur::hybrid::{self, CycleError, HybridError};
use assur::model::Model;
use assur::periodic::{self, PeriodicError};
use assur::problem::Span;
use assur::registry::{SceneEntry, Settings};

use crate::case::Case;
use crate::error::Failure;
use crate::measures::Measured;
use crate::unfollowed;

/// Roundings of a time by which it may be wrong when an event happens.
const BLUR: f64 = 64.0;

impl Case {
    /// Finds the motion.
    ///
    /// # Errors
    /// When the solver does not succeed, with the facts that it gives.
    pub fn solve(&self, settings: Settings) -> Result<Motion, Failure> {
        let clock = std::time::Instant::now();
        let run = self.run();
        let (from, to) = run.span().limits();
        let mut steady = None;
        let path = match run.span() {
            Span::Open => hybrid::Motion {
                mode: run.shape().first,
                ..hybrid::Motion::at_rest(from, &run.start())
            },
            _ if self.scene.states.is_empty() => {
                hybrid::Motion::without_states(run.shape().first, (from, to))
            }
            Span::Periodic(period) if !self.scene.modes.is_empty() => {
                let cycle = run.cycle(period, &settings);
                repeating(cycle.map_err(|error| self.no_cycle(&error))?, &mut steady)
            }
            Span::Autonomous => {
                let cycle = run.clock(&settings);
                repeating(cycle.map_err(|error| self.no_cycle(&error))?, &mut steady)
            }
            Span::Periodic(period) => {
                let orbit = run.periodic(period, &settings);
                let orbit = orbit.map_err(|error| self.not_periodic(&error))?;
                steady = Some(Steady {
                    condition: orbit.condition,
                    residual: orbit.residual,
                    free: orbit.free,
                    multiple: orbit.multiple,
                    followed: orbit.followed,
                    multipliers: orbit.multipliers,
                });
                hybrid::Motion::of(orbit.trajectory)
            }
            Span::Run(..) => {
                let motion = run.follow((from, to), &run.start(), &settings);
                motion.map_err(|error| self.not_followed(&error))?
            }
        };
        Ok(Motion {
            path,
            steady,
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
        let (mode, start) = motion.place(from);
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
        let told = unfollowed::tell(self.scene, self.run(), error);
        Failure::numerical("the motion could not be followed to its end")
            .reason(told.reason)
            .remedy(told.remedy)
    }

    fn no_cycle(&self, error: &CycleError) -> Failure {
        if let CycleError::Motion(inner) = error {
            return self.not_followed(inner);
        }
        let told = unfollowed::tell_cycle(self.scene, self.run(), error);
        Failure::numerical("no motion that repeats was found")
            .reason(told.reason)
            .remedy(told.remedy)
    }

    fn not_periodic(&self, error: &PeriodicError) -> Failure {
        if let PeriodicError::NotSettled(inner) = error {
            return self.no_cycle(inner);
        }
        let told = unfollowed::tell_periodic(self.scene, self.run(), error);
        Failure::numerical("no steady state was found")
            .reason(told.reason)
            .remedy(told.remedy)
    }
}

/// The motion of one of many runs over its task; if there is none, why, in words.
///
/// # Errors
/// When the solver does not succeed, or the scene has no task.
pub fn over_task(
    scene: &SceneEntry,
    run: &dyn Model,
    settings: &Settings,
) -> Result<hybrid::Motion, String> {
    match run.span() {
        Span::Periodic(period) if run.events().is_some() => {
            let cycle = run.cycle(period, settings);
            let told = |error: CycleError| unfollowed::tell_cycle(scene, run, &error).reason;
            cycle.map(|cycle| cycle.motion).map_err(told)
        }
        Span::Autonomous => {
            let cycle = run.clock(settings);
            let told = |error: CycleError| unfollowed::tell_cycle(scene, run, &error).reason;
            cycle.map(|cycle| cycle.motion).map_err(told)
        }
        Span::Periodic(period) => {
            let orbit = run.periodic(period, settings);
            orbit
                .map(|orbit| hybrid::Motion::of(orbit.trajectory))
                .map_err(|error| unfollowed::tell_periodic(scene, run, &error).reason)
        }
        Span::Run(from, to) => {
            let told = |error: HybridError| unfollowed::tell(scene, run, &error).reason;
            run.follow((from, to), &run.start(), settings).map_err(told)
        }
        Span::Open => Err("the scene has no task".to_owned()),
    }
}

/// What the solvers found.
pub struct Motion {
    /// At rest where there is no task, without states where the scene has none.
    path: hybrid::Motion,
    steady: Option<Steady>,
    /// How it was found.
    pub settings: Settings,
    /// Seconds that it took.
    pub seconds: f64,
}

/// What is known of a motion that repeats.
struct Steady {
    condition: f64,
    residual: f64,
    free: usize,
    multiple: usize,
    followed: Option<usize>,
    multipliers: Vec<periodic::Multiplier>,
}

/// The motion of a cycle, and what is known of it.
fn repeating(cycle: hybrid::Cycle, steady: &mut Option<Steady>) -> hybrid::Motion {
    *steady = Some(Steady {
        condition: cycle.condition,
        residual: cycle.residual,
        free: 0,
        multiple: cycle.multiple,
        followed: Some(cycle.followed),
        multipliers: cycle.multipliers,
    });
    cycle.motion
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
    /// Steps whose error is that of rounding and above the tolerance.
    pub rounded_steps: usize,
}

impl Motion {
    /// The motion as the solvers have it.
    pub fn path(&self) -> &hybrid::Motion {
        &self.path
    }

    /// Mode and state at a time of the task.
    pub fn place(&self, time: f64) -> (usize, Vec<f64>) {
        self.path.at(time)
    }

    /// The events that have happened, in their order.
    pub fn events(&self) -> &[hybrid::Happened] {
        &self.path.events
    }

    /// Times of the steps.
    pub fn steps(&self) -> Vec<f64> {
        let pieces = self.path.pieces.iter();
        let times = pieces.flat_map(|piece| piece.trajectory.times());
        times.copied().collect()
    }

    /// The measures of the run.
    pub fn measures(&self, case: &Case) -> Vec<Measured> {
        let found = case.run().measure(&self.path);
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
        let steady = self.steady.as_ref();
        steady.map_or(&[], |steady| &steady.multipliers)
    }

    /// The time after which the motion repeats, in seconds; none unless the task is a steady state.
    pub fn length(&self) -> Option<f64> {
        self.steady.as_ref().map(|_| self.path.time)
    }

    /// Periods that the motion from the start values was followed until it repeated; none where they pick nothing.
    pub fn followed(&self) -> Option<usize> {
        self.steady.as_ref()?.followed
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

    /// Periods after which the motion repeats.
    pub fn multiple(&self) -> usize {
        self.steady.as_ref().map_or(1, |steady| steady.multiple)
    }

    /// The mode at the begin.
    pub fn first_mode(&self, case: &Case) -> usize {
        match self.steady {
            Some(_) => self.path.mode,
            None => case.run().shape().first,
        }
    }

    /// Condition number of a steady state, residual after a period over the scales, and number of free motions that
    /// nothing determines; none unless the task is a steady state.
    pub fn closing(&self) -> Option<(f64, f64, usize)> {
        let steady = self.steady.as_ref()?;
        Some((steady.condition, steady.residual, steady.free))
    }

    /// Where `auto` changed the method: the times, and whether to the stiff one.
    pub fn switches(&self) -> Vec<(f64, bool)> {
        if self.steady.is_some() {
            return Vec::new();
        }
        let switches = self.path.switches();
        switches.map(|switch| (switch.time, switch.stiff)).collect()
    }

    /// The work that was done.
    pub fn effort(&self) -> Effort {
        let statistics = &self.path.statistics;
        Effort {
            steps: statistics.steps,
            rejected: statistics.rejected,
            evaluations: statistics.evaluations,
            jacobians: statistics.jacobians,
            stiff_steps: statistics.stiff_steps,
            rounded_steps: statistics.rounded_steps,
        }
    }
}
