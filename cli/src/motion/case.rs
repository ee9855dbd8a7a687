//! A scene that moves by its equations of motion, with its values.

use std::sync::Arc;

use assur::answer::Motion;
use assur::model::Model;
use assur::problem::{Phase, Span};
use assur::shape::{Quantity, Subject};

use super::turn::Turn;
use crate::ask::case;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::ask::variables;
use crate::error::Failure;
use crate::plot::Selection;
use crate::show::number;

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

    /// Adds the energies that are asked for by name.
    ///
    /// # Errors
    /// When the scene states no energies.
    pub fn add_energies(&mut self, curves: &Selection) -> Result<(), Failure> {
        let known = |name: &str| self.variables.iter().any(|one| one.name == name);
        let asked: Vec<_> = variables::energies()
            .into_iter()
            .filter(|one| curves.names(&one.name) && !known(&one.name))
            .collect();
        let (model, time) = (self.run(), self.moved.task.limits().0);
        let phase = Phase::of(model.shape().first);
        if let Some(first) = asked.first()
            && model.reports().energy(phase, time, &model.start()).is_none()
        {
            return Err(Failure::request(format!("scene `{}` states no energies", self.scene.name))
                .place(format!("--curves {}", first.name))
                .remedy("state `kinetic` and `potential` in the equation file instead of equations of motion"));
        }
        self.variables.extend(asked);
        Ok(())
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

    /// The task in words, as far as it is known before anything is solved.
    pub fn task_in_words(&self) -> String {
        match self.moved.task {
            Span::Periodic(period) => {
                format!("steady state over one period of {} s", number::short(period))
            }
            Span::Autonomous => "steady state that repeats by itself".to_owned(),
            Span::Run(from, to) => {
                format!("motion from {} s to {} s", number::short(from), number::short(to))
            }
            Span::Rest => "position of rest".to_owned(),
            Span::Open => "positions".to_owned(),
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
