//! What was found of a linkage, beside published values.

use std::time::Instant;

use assur::closure::{ClosureError, Sample, Stroke};
use assur::shape::{At, Expectation, Subject};

use super::case::{Case, Task};
use super::influence;
use super::line::{Grid, Line};
use super::reach;
use crate::ask::case::amount_of;
use crate::ask::constants::Constants;
use crate::ask::values::TIME;
use crate::error::Failure;
use crate::published::{Comparison, Known};

/// A linkage moved through its task.
pub struct Found {
    /// The linkage with its values.
    pub case: Case,
    /// Finely along the task.
    pub lines: Vec<Line>,
    /// Strokes over the task where it has one axis, see [`reach::strokes`].
    pub strokes: Option<Vec<Stroke>>,
    /// Seconds that the positions took.
    pub seconds: f64,
}

impl Found {
    /// Moves a linkage.
    ///
    /// # Errors
    /// Why it cannot be put together, with what cannot.
    pub fn of(case: Case) -> Result<Self, Box<(Case, ClosureError)>> {
        let clock = Instant::now();
        let lines = case.grid(&Grid::fine(&case));
        let seconds = clock.elapsed().as_secs_f64();
        match lines {
            Ok(lines) => Ok(Self { strokes: reach::strokes(&case), case, lines, seconds }),
            Err(error) => Err(Box::new((case, error))),
        }
    }

    /// What a fact speaks of at a place.
    fn at(&self, subject: Subject, variable: usize, place: Vec<f64>) -> f64 {
        let case = &self.case;
        match subject {
            Subject::Influence(output, by) => {
                let width = case.moved.entry.variables.len();
                let values = case.run().influence(&place).unwrap_or_default();
                values.get(output * width + by).copied().unwrap_or(f64::NAN)
            }
            _ => {
                let value = |sample: Sample| case.values(&sample)[variable];
                case.at(place).map_or(f64::NAN, value)
            }
        }
    }

    /// The place of a fact in words, its time if it has one, and the value there.
    fn value(&self, fact: &Expectation, variable: usize) -> Option<(String, Option<f64>, f64)> {
        let case = &self.case;
        let at = |place: Vec<f64>| self.at(fact.subject, variable, place);
        let limits = || match reach::extremes(case, &self.lines, self.strokes.as_ref(), variable) {
            Some((low, high)) => (low.value, high.value),
            None => (f64::NAN, f64::NAN),
        };
        let is_timed = matches!(case.moved.task, Task::Time(_));
        Some(match fact.at {
            At::Maximum => ("maximum".to_owned(), None, limits().1),
            At::Minimum => ("minimum".to_owned(), None, limits().0),
            At::Amplitude => {
                let (low, high) = limits();
                ("amplitude".to_owned(), None, low.abs().max(high.abs()))
            }
            At::Run => return None,
            At::Position(positions) => {
                let label = positions.iter().map(|(index, at)| case.driver_at(*index, *at));
                let label = label.collect::<Vec<_>>().join(", ");
                (label, None, at(case.standing_but(positions.iter().copied())))
            }
            At::Driver(driver, position) => {
                let time = case.time_of(driver, position).ok().filter(|_| is_timed);
                let standing = || case.standing_but([(driver, position)]);
                let place = time.map_or_else(standing, |time| case.place(&[time]));
                (case.driver_at(driver, position), time, at(place))
            }
            At::Time(time) => {
                let within = match &case.moved.task {
                    Task::Time(span) => span.reduce(time),
                    _ => None,
                };
                let computed = within.map_or(f64::NAN, |time| at(case.place(&[time])));
                (amount_of(&TIME, time), within, computed)
            }
        })
    }
}

impl Known for Found {
    fn constants(&self) -> &Constants {
        &self.case.constants
    }

    fn with(&self, constants: Constants) -> Result<Self, Failure> {
        // What does not close has no value, which the comparison shows.
        Ok(Self::of(Case::new(constants)?).unwrap_or_else(|apart| {
            let (case, _) = *apart;
            Self { case, lines: Vec::new(), strokes: None, seconds: 0.0 }
        }))
    }

    fn compare(&self, fact: &'static Expectation) -> Option<Comparison> {
        let case = &self.case;
        let quantity = case.scene.quantity(fact.subject)?;
        let variable = case.variables.iter().position(|variable| variable.name == quantity.name)?;
        let (place, time, computed) = self.value(fact, variable)?;
        let printed = &case.variables[variable];
        let (name, (unit, factor), variable) = match fact.subject {
            Subject::Influence(_, by) => {
                let by = influence::quantity(case, *case.moved.entry.variables.get(by)?)?;
                let name = format!("diff({}, {})", printed.name, by.name);
                (name, influence::unit_of(printed, &by), None)
            }
            _ => (printed.name.clone(), (printed.unit.clone(), printed.factor), Some(variable)),
        };
        let error = 1e-12 * computed.abs();
        let comparable = true;
        Some(Comparison {
            fact,
            name,
            unit,
            factor,
            variable,
            place,
            time,
            computed,
            error,
            comparable,
        })
    }
}
