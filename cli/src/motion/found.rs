//! What was found of a motion, beside published values.

use assur::answer::{Ends, Estimate, Motion, Settings};
use assur::measure::ALWAYS;
use assur::problem::Span;
use assur::shape::{At, Expectation, Subject};

use super::case::Case;
use super::curves::{self, Curves};
use crate::ask::case::amount_of;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::ask::variables::Variable;
use crate::error::Failure;
use crate::published::{Comparison, Known, Stated};
use crate::show::measures::{self, Measured};

/// A motion with its errors.
pub struct Found {
    /// The scene with its values.
    pub case: Case,
    /// The motion.
    pub motion: Motion,
    /// The curves.
    pub curves: Curves,
    /// How accurate it is.
    pub estimate: Estimate,
    /// Smallest and largest value of each variable over the task; none where it has no length.
    pub extremes: Vec<Ends>,
    /// Numbers of the whole task.
    pub measures: Vec<Measured>,
}

impl Found {
    /// Looks closely at a motion.
    ///
    /// # Errors
    /// When solving with other tolerances does not succeed.
    pub fn of(case: Case, motion: Motion) -> Result<Self, Failure> {
        let subjects = case.subjects();
        let extremes = motion.extremes(&subjects, ALWAYS);
        let curves = curves::sample(&case, &motion, &extremes);
        let estimate = motion.estimate().map_err(|error| case.unanswered(&error))?;
        let found = motion.measures();
        let errors = estimate.measures(&motion, &found);
        let measures = measures::of(case.scene, found.into_iter().zip(errors));
        let extremes = estimate.extremes(&motion, &subjects, &curves.samples(), &extremes);
        Ok(Self { case, motion, curves, estimate, extremes, measures })
    }

    /// Finds a motion.
    ///
    /// # Errors
    /// When the solvers do not succeed.
    pub fn solve(mut case: Case, settings: &Settings) -> Result<Self, Failure> {
        let motion = case.solve(settings)?;
        case.repeat(&motion);
        Self::of(case, motion)
    }

    /// A value of a variable where a fact says, with the estimated error.
    fn value(&self, variable: usize, at: At, time: Option<f64>) -> Option<(f64, f64)> {
        let (case, motion) = (&self.case, &self.motion);
        if let Some(time) = time {
            let error = self.estimate.at(motion, &case.subjects(), time)[variable];
            return Some((case.sample(motion, time)[variable], error));
        }
        let Some(ends) = self.extremes.get(variable) else {
            return Some((f64::NAN, f64::NAN));
        };
        let end = match at {
            At::Maximum => ends.highest,
            At::Minimum => ends.lowest,
            At::Amplitude => ends.furthest(),
            _ => return None,
        };
        let value = if matches!(at, At::Amplitude) { end.value.abs() } else { end.value };
        Some((value, end.error))
    }
}

impl Case {
    /// A published fact in words; none where no motion has its place.
    pub fn stated(&self, fact: &'static Expectation) -> Option<Stated> {
        let quantity = self.scene.quantity(fact.subject)?;
        let is_measure = matches!(fact.subject, Subject::Measure(_));
        let named = |one: &Variable| !is_measure && one.name == quantity.name;
        let variable = self.variables.iter().position(named);
        let place = match fact.at {
            _ if self.moved.task == Span::Rest => "rest".to_owned(),
            _ if is_measure => "whole run".to_owned(),
            At::Time(time) => amount_of(&TIME, time),
            At::Driver(driver, position) => self.driver_at(driver, position),
            At::Maximum => "maximum".to_owned(),
            At::Minimum => "minimum".to_owned(),
            At::Amplitude => "amplitude".to_owned(),
            At::Position(_) | At::Run => return None,
        };
        let printed = variable.map(|index| &self.variables[index]);
        Some(Stated {
            fact,
            name: quantity.name.to_owned(),
            unit: printed.map_or(quantity.unit, |one| &one.unit).to_owned(),
            factor: printed.map_or(quantity.factor, |one| one.factor),
            variable,
            place,
        })
    }
}

impl Known for Found {
    fn constants(&self) -> &Constants {
        &self.case.constants
    }

    fn with(&self, constants: Constants) -> Result<Self, Failure> {
        Self::solve(Case::new(constants)?, &self.motion.settings)
    }

    fn compare(&self, fact: &'static Expectation) -> Option<Comparison> {
        let case = &self.case;
        let stated = case.stated(fact)?;
        let time = match (fact.subject, fact.at) {
            _ if self.motion.rest().is_some() => Some(0.0),
            (Subject::Measure(_), _) => None,
            (_, At::Time(time)) => case.moved.task.reduce(time),
            (_, At::Driver(driver, position)) => case.run().time_of(driver, position).ok(),
            _ => None,
        };
        let (computed, error) = match fact.subject {
            Subject::Measure(index) => {
                let measure = self.measures.get(index)?;
                (measure.value.unwrap_or(f64::NAN), measure.error)
            }
            _ => self.value(stated.variable?, fact.at, time)?,
        };
        Some(Comparison { stated, time, computed, error, comparable: true })
    }
}
