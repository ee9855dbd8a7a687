//! Mechanisms as data: what the command and the generated tests need to run any scene without knowing its type.
//!
//! Emitted code fills these tables. The solvers never look at a name or a unit in them; they are carried for whoever
//! prints the answer, and the dimensions for [`crate::check::scaling`]. Behind `dyn` stand whole runs, never single evaluations.

mod bind;
mod hybrid;
mod limits;
mod linkage;
mod path;
mod settings;
mod tolerance;

pub use bind::{bind, check_values, with};
pub use hybrid::{bind_cycle, bind_hybrid};
pub use limits::{Listed, Listing, RunLimits};
pub use linkage::{RunLinkage, bind_exact, bind_linkage};
pub use path::{Path, Sample};
pub use settings::{Method, Settings};
pub use tolerance::RunTolerance;

use crate::hybrid::{Cycle, CycleError};
use crate::measure::Missing;
use crate::problem::{Refused, Span};
use crate::shape::Shape;

/// One equation file.
#[derive(Clone, Copy)]
pub struct Mechanism {
    /// Name as the command takes it, `batten`.
    pub name: &'static str,
    /// Name as the file states it, `Batten`.
    pub title: &'static str,
    /// Documentation of the mechanism, lines joined by newlines.
    pub summary: &'static str,
    /// Source that the file cites.
    pub source: &'static str,
    /// File name of the equation file, `batten.eqn`; empty for a mechanism written inline.
    pub file: &'static str,
    /// Text of the equation file; empty for a mechanism written inline.
    pub text: &'static str,
    /// Paths, relative to the equation file, and texts of the files of its parts; none for a mechanism written inline.
    pub parts: &'static [(&'static str, &'static str)],
    /// Effects that the mechanism may show.
    pub effects: &'static [Named],
    /// Choices between descriptions, each with its alternatives.
    pub choices: &'static [Choice],
    /// Named sets of values.
    pub presets: &'static [Preset],
    /// The scenes, the default one first.
    pub scenes: &'static [SceneEntry],
}

/// A name with a line of explanation.
#[derive(Clone, Copy, Debug)]
pub struct Named {
    /// The name.
    pub name: &'static str,
    /// What it stands for.
    pub summary: &'static str,
}

/// Several descriptions of one thing.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// Name of the choice.
    pub name: &'static str,
    /// What is described.
    pub summary: &'static str,
    /// The alternatives, the default one first.
    pub alternatives: &'static [&'static str],
}

/// A named set of values.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Name of the preset.
    pub name: &'static str,
    /// What the values are.
    pub summary: &'static str,
    /// Names of parameters with their values in SI units.
    pub values: &'static [(&'static str, f64)],
}

/// What fixes the values of a scene (SI units, in the order of its constants), if the mechanism accepts them.
pub type Binder<R> = fn(&[f64]) -> Result<Box<R>, Refused>;

/// Fixes the values of a scene.
#[derive(Clone, Copy)]
pub enum Bind {
    /// Of a scene that moves by its equations of motion.
    Motion(Binder<dyn Run>),
    /// Of a linkage.
    Linkage(Binder<dyn RunLinkage>),
}

impl Bind {
    /// Fixes the values of a scene that moves by its equations of motion.
    ///
    /// # Errors
    /// The first value or condition that the mechanism does not accept, or that the scene is a linkage.
    pub fn motion(&self, values: &[f64]) -> Result<Box<dyn Run>, Refused> {
        match self {
            Bind::Motion(bind) => bind(values),
            Bind::Linkage(_) => Err(other_kind("a linkage, which is moved from outside")),
        }
    }

    /// Fixes the values of a linkage.
    ///
    /// # Errors
    /// The first value or condition that the mechanism does not accept, or that the scene is none.
    pub fn linkage(&self, values: &[f64]) -> Result<Box<dyn RunLinkage>, Refused> {
        match self {
            Bind::Linkage(bind) => bind(values),
            Bind::Motion(_) => Err(other_kind(
                "no linkage: it moves by its equations of motion",
            )),
        }
    }
}

fn other_kind(reason: &str) -> Refused {
    Refused {
        name: "the scene".to_string(),
        reason: format!("it is {reason}"),
    }
}

/// One scene of a mechanism: its shape, and what fixes its values.
#[derive(Clone, Copy)]
pub struct SceneEntry {
    /// What it is made of.
    pub shape: &'static Shape,
    /// Fixes its values.
    pub bind: Bind,
}

impl std::ops::Deref for SceneEntry {
    type Target = Shape;

    fn deref(&self) -> &Shape {
        self.shape
    }
}

/// A scene whose parameter values are fixed, ready to run.
pub trait Run: Send + Sync {
    /// The task of the scene.
    fn span(&self) -> Span;
    /// Declared start values of the state, SI units.
    fn start(&self) -> Vec<f64>;
    /// Positions of the drivers at a time.
    fn drivers(&self, time: f64) -> Vec<f64>;
    /// Writes by how much the loops that the motion carries along close at a time, in SI units: less than zero where they
    /// do not, not a number where one before does not. Shape: [`Shape::carried`].
    fn margins(&self, time: f64, values: &mut [f64]);
    /// The first time of the task at which a driver has a position, see [`Span::time_of`].
    ///
    /// # Errors
    /// The lowest and the highest position that it has; neither is a number where there is no such driver.
    fn time_of(&self, driver: usize, position: f64) -> Result<f64, (f64, f64)> {
        let at = |time| self.drivers(time).get(driver).copied();
        self.span()
            .time_of(|time| at(time).unwrap_or(f64::NAN), position)
    }
    /// The mode in which the motion begins; a scene without modes has this one.
    fn first_mode(&self) -> usize {
        0
    }
    /// Number of modes; 0 where the motion has neither modes nor events.
    fn mode_count(&self) -> usize {
        0
    }
    /// All outputs in a mode at a time and state.
    fn outputs_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64>;
    /// Time derivative of the state in a mode.
    fn rates_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64>;
    /// All outputs at a time and state, in the first mode.
    fn outputs(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.outputs_in(self.first_mode(), time, state)
    }
    /// Time derivative of the state, in the first mode.
    fn rates(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.rates_in(self.first_mode(), time, state)
    }
    /// The periodic steady state.
    ///
    /// # Errors
    /// See [`crate::periodic::PeriodicError`].
    fn periodic(
        &self,
        period: f64,
        settings: &Settings,
    ) -> Result<crate::periodic::Orbit, crate::periodic::PeriodicError>;
    /// The motion through events that repeats, of a scene whose task that is.
    ///
    /// # Errors
    /// See [`CycleError`].
    fn cycle(&self, _period: f64, _settings: &Settings) -> Result<Cycle, CycleError> {
        Err(CycleError::NoTask)
    }
    /// The motion that repeats by itself, with its period, of a scene whose task that is.
    ///
    /// # Errors
    /// See [`CycleError`].
    fn clock(&self, _settings: &Settings) -> Result<Cycle, CycleError> {
        Err(CycleError::NoTask)
    }
    /// The motion from a start.
    ///
    /// # Errors
    /// See [`crate::ode::OdeError`].
    fn march(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<crate::ode::Trajectory, crate::ode::OdeError>;
    /// The motion from a start, through all modes; in one piece where there are none.
    ///
    /// # Errors
    /// See [`crate::hybrid::HybridError`].
    fn follow(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<crate::hybrid::Motion, crate::hybrid::HybridError>;
    /// The same from a start in another mode than the first.
    ///
    /// # Errors
    /// See [`crate::hybrid::HybridError`].
    fn follow_in(
        &self,
        _mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<crate::hybrid::Motion, crate::hybrid::HybridError> {
        self.follow(times, start, settings)
    }
    /// The measures of a run.
    fn measure(&self, motion: &crate::hybrid::Motion) -> Vec<Result<f64, Missing>>;
    /// Nanoseconds of one evaluation of the derivative with its time-only values, measured over this many calls.
    fn time_evaluation(&self, calls: usize) -> f64;
}
