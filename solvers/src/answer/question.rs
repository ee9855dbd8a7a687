//! What is asked of a scene.

use super::error::Error;
use super::motion::{Motion, Repeats};
use crate::hybrid::{self, HybridError, Request};
use crate::model::{Bound, Flow, Model, assemble_beside};
use crate::periodic::{self, Multiplier};
use crate::problem::{Refused, Scene, Span};
use crate::settings::Settings;
use crate::shape::find;
use std::sync::Arc;

/// What is asked of a scene: its motion over its task, from its start, unless another one is given.
#[derive(Clone)]
pub struct Question {
    pub(super) model: Arc<dyn Model>,
    /// Why the mechanism does not accept the values, if it does not.
    refused: Option<Refused>,
    pub(super) mode: usize,
    start: Option<Vec<f64>>,
    pub(super) span: Span,
}

impl Question {
    /// The motion of a model over its task.
    pub fn of(model: Arc<dyn Model>) -> Self {
        Self { refused: None, mode: model.shape().first, start: None, span: model.span(), model }
    }

    /// From this start, SI units. Shape: [`Shape::states`](crate::shape::Shape::states).
    #[must_use]
    pub fn from(self, start: impl Into<Vec<f64>>) -> Self {
        Self { start: Some(start.into()), ..self }
    }

    /// From a start in a mode, by its index.
    #[must_use]
    pub fn in_mode(self, mode: usize) -> Self {
        Self { mode, ..self }
    }

    /// A run up to a time in seconds; from time 0 on, or from where the run of the file begins.
    #[must_use]
    pub fn until(self, end: f64) -> Self {
        let begin = match self.span {
            Span::Run(begin, _) => begin,
            _ => 0.0,
        };
        Self { span: Span::Run(begin, end), ..self }
    }

    /// A motion that repeats after this time in seconds, or after several of them.
    #[must_use]
    pub fn repeating_after(self, period: f64) -> Self {
        Self { span: Span::Periodic(period), ..self }
    }

    /// The position at which it rests, found from the start, with the vibrations about it.
    #[must_use]
    pub fn resting(self) -> Self {
        Self { span: Span::Rest, ..self }
    }

    /// The scene with its values.
    pub fn model(&self) -> &dyn Model {
        self.model.as_ref()
    }

    /// The answer by the usual method, see [`Settings::default`].
    ///
    /// # Errors
    /// [`Error`], with the figures.
    pub fn run(&self) -> Result<Motion, Error> {
        self.solve(&Settings::default())
    }

    /// The answer by a method, to an accuracy. Where loops come to a dead point it is that of the same motion with all
    /// positions as coordinates; the shape of the answer says that.
    ///
    /// # Errors
    /// [`Error`], with the figures.
    pub fn solve(&self, settings: &Settings) -> Result<Motion, Error> {
        let answer = self.attempt(settings);
        match answer {
            Err(error) if error.is_lost() || self.begins_lost() => match self.model.unreduced() {
                Some(model) => {
                    let other = self.unreduced(model.into())?;
                    other.attempt(&settings.of_states(self.model.shape(), other.model.shape()))
                }
                None => Err(error),
            },
            _ => answer,
        }
    }

    /// Whether the equations of the scene say nothing of how the motion begins, as those of a change point.
    fn begins_lost(&self) -> bool {
        let start = self.start();
        let mut rates = vec![0.0; self.model.shape().states.len()];
        if start.len() != rates.len() {
            return false;
        }
        let flow = Flow::new(self.model.as_ref(), self.mode);
        flow.rates(self.span.limits().0, &start, &mut rates);
        rates.iter().any(|rate| !rate.is_finite())
    }

    /// The question to the same motion with all positions as coordinates.
    fn unreduced(&self, model: Arc<dyn Model>) -> Result<Self, Error> {
        let Some(own) = &self.start else {
            return Ok(Self { model, ..self.clone() });
        };
        let (from, to) = (self.model.shape(), model.shape());
        let (mut start, mut kept) = (model.start(), Vec::new());
        for (state, value) in from.states.iter().zip(own) {
            if let Some(place) = find(to.states, state.name) {
                start[place] = *value;
                kept.push(place);
            }
        }
        let here = (self.mode, self.span.limits().0);
        let start = assemble_beside(model.as_ref(), here, start, &kept);
        Ok(Self { start: Some(start.map_err(Error::Refused)?), model, ..self.clone() })
    }

    /// The Floquet multipliers of the motion that repeats, the largest modulus first, and after how many periods it does. Where
    /// equations are affine all motions have the same ones, and none is looked for: a resonance has multipliers too.
    ///
    /// # Errors
    /// [`Error`], with the figures.
    pub fn multipliers(&self, settings: &Settings) -> Result<(Vec<Multiplier>, usize), Error> {
        match self.span {
            Span::Periodic(period)
                if self.refused.is_none() && self.is_smooth() && self.model.shape().is_linear =>
            {
                Ok((periodic::multipliers_of(self.model.as_ref(), period, settings)?, 1))
            }
            _ => {
                let motion = self.solve(settings)?;
                Ok((motion.multipliers().to_vec(), motion.multiple()))
            }
        }
    }

    /// Whether shooting knows all that there is: no events, and no closures that hold the coordinates, which leave them fewer
    /// directions than there are states.
    fn is_smooth(&self) -> bool {
        self.model.events().is_none() && self.model.shape().augmented.is_none()
    }

    /// [`Question::solve`] by the equations of the scene as they are: dead points are errors.
    ///
    /// # Errors
    /// [`Error`], with the figures.
    pub fn attempt(&self, settings: &Settings) -> Result<Motion, Error> {
        if let Some(refused) = &self.refused {
            return Err(Error::Refused(refused.clone()));
        }
        let clock = std::time::Instant::now();
        let (path, repeats) = self.follow(settings)?;
        Ok(Motion {
            question: self.clone(),
            path,
            repeats,
            settings: settings.clone(),
            seconds: clock.elapsed().as_secs_f64(),
        })
    }

    /// The start, SI units.
    fn start(&self) -> Vec<f64> {
        self.start.clone().unwrap_or_else(|| self.model.start())
    }

    /// The motion over the task, and what is known of it where it repeats.
    fn follow(&self, settings: &Settings) -> Result<(hybrid::Motion, Option<Repeats>), Error> {
        let (model, start) = (self.model.as_ref(), self.start());
        let place = (self.mode, &start[..]);
        match self.span {
            Span::Open => {
                let here = hybrid::Motion::unbegun(0.0, &start);
                let mode = self.mode;
                Ok((hybrid::Motion { mode, ..here }, None))
            }
            span if model.shape().states.is_empty() => {
                Ok((hybrid::Motion::without_states(self.mode, span.limits(), hybrid::STILL), None))
            }
            Span::Rest => Ok((hybrid::rest_of(model, self.mode, &start)?, None)),
            Span::Periodic(period) if !self.is_smooth() => {
                let cycle = hybrid::cycle_of(model, place, period, settings)?;
                Ok(Repeats::of_cycle(cycle))
            }
            Span::Autonomous => Ok(Repeats::of_cycle(hybrid::clock_of(model, place, settings)?)),
            Span::Periodic(period) => {
                let orbit = periodic::of(model, &start, period, settings)?;
                Ok(Repeats::of_orbit(orbit))
            }
            Span::Run(from, to) => Ok((self.march((from, to), &start, settings)?, None)),
        }
    }

    fn march(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<hybrid::Motion, HybridError> {
        let way = Request { mode: self.mode, times, start, settings, is_checked: true };
        way.of(self.model.as_ref())
    }
}

/// What every scene is asked.
pub trait Solve: Scene {
    /// A question to the scene, to be changed by what is said.
    fn ask(&self) -> Question {
        let mut question = Question::of(Arc::new(Bound::new(self)));
        question.refused = self.check().err();
        question
    }

    /// A question from this start, SI units.
    fn from(&self, start: impl Into<Vec<f64>>) -> Question {
        self.ask().from(start)
    }

    /// The motion over the task of the scene, by the usual method.
    ///
    /// # Errors
    /// [`Error`], with the figures.
    fn run(&self) -> Result<Motion, Error> {
        self.ask().run()
    }

    /// The motion over the task of the scene, by a method, to an accuracy.
    ///
    /// # Errors
    /// [`Error`], with the figures.
    fn solve(&self, settings: &Settings) -> Result<Motion, Error> {
        self.ask().solve(settings)
    }
}

impl<C: Scene> Solve for C {}
