//! A scene that moves by its equations of motion, with its values.

use std::sync::Arc;

use assur::answer::Motion;
use assur::model::Model;
use assur::problem::Span;
use assur::shape::{Quantity, Subject};

use super::turn::Turn;
use crate::ask::case;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::ask::variables;
use crate::error::Failure;

/// What moves it.
pub struct Course {
    /// What it does; over all periods until the motion repeats.
    pub task: Span,
    /// Periods after which the motion repeats.
    pub repeats: usize,
    model: Arc<dyn Model>,
}

/// A scene with its values.
pub type Case = case::Case<Course>;

impl Case {
    /// Fixes the values.
    ///
    /// # Errors
    /// When the mechanism refuses them, with its reason.
    pub fn new(constants: Constants) -> Result<Self, Failure> {
        let scene = constants.scene;
        let model = scene.bind.motion(&constants.values);
        let model = model.map_err(|refused| case::refused(&constants, &refused))?;
        let task = model.span();
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
            drivers: scene.drivers.to_vec(),
            moved: Course { task, repeats: 1, model: model.into() },
        })
    }

    /// The scene as the solvers see it.
    pub fn run(&self) -> &dyn Model {
        self.moved.model.as_ref()
    }

    /// The model, to be asked.
    pub fn model(&self) -> Arc<dyn Model> {
        self.moved.model.clone()
    }

    /// What its variables are.
    pub fn subjects(&self) -> Vec<Subject> {
        let variables = self.variables.iter();
        variables.map(|variable| variable.origin).collect()
    }

    /// Takes into account after what time the motion repeats: all of its periods are shown.
    pub fn repeat(&mut self, motion: &Motion) {
        if let Some(length) = motion.length() {
            self.moved.repeats = motion.multiple();
            self.moved.task = Span::Periodic(length);
        }
    }

    /// What its multipliers count by.
    pub fn turn(&self) -> Turn {
        Turn { periods: self.moved.repeats }
    }

    /// Positions of the drivers at a time, SI units.
    pub fn drivers_at(&self, time: f64) -> Vec<f64> {
        self.run().drivers(time)
    }

    /// The first driver, or the time where there is none, and what it is at a time, SI units.
    pub fn leading(&self, time: f64) -> (Quantity, f64) {
        let driver = self.drivers.first().copied().zip(self.drivers_at(time).first().copied());
        driver.unwrap_or((TIME, time))
    }

    /// All variables at a time of the task, SI units.
    pub fn sample(&self, motion: &Motion, time: f64) -> Vec<f64> {
        motion.values(&self.subjects(), time)
    }
}
