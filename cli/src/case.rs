//! One scene with its values: its task, its drivers and its variables.

use std::sync::Arc;

use assur::answer::Motion;
use assur::model::Model;
use assur::problem::{Refused, Span};
use assur::registry::SceneEntry;
use assur::shape::Subject;

use crate::constants::Constants;
use crate::error::Failure;
use crate::turn::Turn;
use crate::variables::{self, Variable};

/// A scene with its values.
pub struct Case {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Its dimensions and parameters.
    pub constants: Constants,
    /// What is reported.
    pub variables: Vec<Variable>,
    /// What it does; over all periods until the motion repeats.
    pub task: Span,
    /// Periods after which the motion repeats.
    pub repeats: usize,
    run: Arc<dyn Model>,
}

impl Case {
    /// Fixes the values.
    ///
    /// # Errors
    /// When the mechanism refuses them, with its reason.
    pub fn new(constants: Constants) -> Result<Self, Failure> {
        let scene = constants.scene;
        let run = scene
            .bind
            .motion(&constants.values)
            .map_err(|refused| self::refused(&constants, &refused))?;
        let task = run.span();
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
            repeats: 1,
            run: run.into(),
        })
    }

    /// The scene as the solvers see it.
    pub fn run(&self) -> &dyn Model {
        self.run.as_ref()
    }

    /// The same, to be asked.
    pub fn model(&self) -> Arc<dyn Model> {
        self.run.clone()
    }

    /// What its variables are.
    pub fn subjects(&self) -> Vec<Subject> {
        let variables = self.variables.iter();
        variables.map(|variable| variable.origin).collect()
    }

    /// Takes into account after what time the motion repeats: all of its periods are shown.
    pub fn repeat(&mut self, motion: &Motion) {
        if let Some(length) = motion.length() {
            self.repeats = motion.multiple();
            self.task = Span::Periodic(length);
        }
    }

    /// What its multipliers count by.
    pub fn turn(&self) -> Turn {
        Turn { periods: self.repeats }
    }

    /// Positions of the drivers at a time, SI units.
    pub fn drivers(&self, time: f64) -> Vec<f64> {
        self.run.drivers(time)
    }

    /// All variables at a time of the task, SI units.
    pub fn sample(&self, motion: &Motion, time: f64) -> Vec<f64> {
        motion.values(&self.subjects(), time)
    }
}

/// What to say when the mechanism refuses values.
pub fn refused(constants: &Constants, refused: &Refused) -> Failure {
    Failure::request(format!("scene `{}` does not accept these values", constants.scene.name))
        .place(match constants.given_names().as_slice() {
            [] => "the values of the file".to_owned(),
            names => format!("--set {}", names.join(", --set ")),
        })
        .reason(format!("{}: {}", refused.name, refused.reason))
        .remedy("change the value with --set, or leave it out for the default")
}
