//! What was found of a motion, beside published values.

use assur::answer::{Ends, Estimate, Motion, Settings};
use assur::measure::ALWAYS;
use assur::shape::{At, Expectation, Subject};

use super::case::Case;
use super::curves::{self, Curves};
use super::measures::{self, Measured};
use crate::ask::case::amount_of;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::ask::variables::Variable;
use crate::error::Failure;
use crate::published::{Comparison, Known};

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
        let measures = measures::of(&case, &motion, &estimate);
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

impl Known for Found {
    fn constants(&self) -> &Constants {
        &self.case.constants
    }

    fn with(&self, constants: Constants) -> Result<Self, Failure> {
        Self::solve(Case::new(constants)?, &self.motion.settings)
    }

    fn compare(&self, fact: &'static Expectation) -> Option<Comparison> {
        let case = &self.case;
        let quantity = case.scene.quantity(fact.subject)?;
        let measure = match fact.subject {
            Subject::Measure(index) => Some(self.measures.get(index)?),
            _ => None,
        };
        let named = |one: &Variable| measure.is_none() && one.name == quantity.name;
        let variable = case.variables.iter().position(named);
        let (place, time) = match fact.at {
            _ if self.motion.rest().is_some() => ("rest".to_owned(), Some(0.0)),
            _ if measure.is_some() => ("whole run".to_owned(), None),
            At::Time(time) => (amount_of(&TIME, time), case.moved.task.reduce(time)),
            At::Driver(driver, position) => {
                (case.driver_at(driver, position), case.run().time_of(driver, position).ok())
            }
            At::Maximum => ("maximum".to_owned(), None),
            At::Minimum => ("minimum".to_owned(), None),
            At::Amplitude => ("amplitude".to_owned(), None),
            At::Position(_) | At::Run => return None,
        };
        let (computed, error) = match measure {
            Some(measure) => (measure.value.unwrap_or(f64::NAN), measure.error),
            None => self.value(variable?, fact.at, time)?,
        };
        let printed = variable.map(|index| &case.variables[index]);
        Some(Comparison {
            fact,
            name: quantity.name.to_owned(),
            unit: printed.map_or(quantity.unit, |one| &one.unit).to_owned(),
            factor: printed.map_or(quantity.factor, |one| one.factor),
            variable,
            place,
            time,
            computed,
            error,
            comparable: true,
        })
    }
}
