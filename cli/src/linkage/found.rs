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
use crate::ask::variables::Variable;
use crate::error::Failure;
use crate::published::{Comparison, Known, Stated};
use crate::show::measures::{self, Measured};

/// A linkage moved through its task.
pub struct Found {
    /// The linkage with its values.
    pub case: Case,
    /// Finely along the task.
    pub lines: Vec<Line>,
    /// Strokes over the task where it has one axis, see [`reach::strokes`].
    pub strokes: Option<Vec<Stroke>>,
    /// Numbers of the whole task; none where it is not gone through.
    pub measures: Vec<Measured>,
    /// Why there are none.
    pub unmeasured: Option<ClosureError>,
    /// Seconds that the positions took.
    pub seconds: f64,
}

impl Found {
    /// Moves a linkage finely through its task.
    ///
    /// # Errors
    /// Why it cannot be put together, with what cannot.
    pub fn of(case: Case) -> Result<Self, Box<(Case, ClosureError)>> {
        let grid = Grid::fine(&case);
        Self::on(&grid, case)
    }

    /// Moves a linkage through the stations of a grid.
    ///
    /// # Errors
    /// As [`Found::of`].
    pub fn on(grid: &Grid, case: Case) -> Result<Self, Box<(Case, ClosureError)>> {
        let clock = Instant::now();
        let lines = case.grid(grid);
        let seconds = clock.elapsed().as_secs_f64();
        match lines {
            Ok(lines) => {
                let (found, unmeasured) = match case.measures() {
                    Ok(found) => (found, None),
                    Err(error) => (Vec::new(), Some(error)),
                };
                let found = found.into_iter().map(|one| (one.value, one.error));
                let measures = measures::of(case.scene, found);
                let strokes = reach::strokes(&case);
                Ok(Self { strokes, measures, unmeasured, case, lines, seconds })
            }
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

    /// The time of a fact, if it has one, and the value there.
    fn value(&self, fact: &Expectation, variable: usize) -> Option<(Option<f64>, f64)> {
        let case = &self.case;
        let at = |place: Vec<f64>| self.at(fact.subject, variable, place);
        let limits = || match reach::extremes(case, &self.lines, self.strokes.as_ref(), variable) {
            Some((low, high)) => (low.value, high.value),
            None => (f64::NAN, f64::NAN),
        };
        let is_timed = matches!(case.moved.task, Task::Time(_));
        Some(match fact.at {
            At::Maximum => (None, limits().1),
            At::Minimum => (None, limits().0),
            At::Amplitude => {
                let (low, high) = limits();
                (None, low.abs().max(high.abs()))
            }
            At::Run => return None,
            At::Position(positions) => (None, at(case.standing_but(positions.iter().copied()))),
            At::Driver(driver, position) => {
                let time = case.time_of(driver, position).ok().filter(|_| is_timed);
                let standing = || case.standing_but([(driver, position)]);
                let place = time.map_or_else(standing, |time| case.place(&[time]));
                (time, at(place))
            }
            At::Time(time) => {
                let within = match &case.moved.task {
                    Task::Time(span) => span.reduce(time),
                    _ => None,
                };
                (within, within.map_or(f64::NAN, |time| at(case.place(&[time]))))
            }
        })
    }
}

impl Case {
    /// A published fact in words; none where no linkage has its place.
    pub fn stated(&self, fact: &'static Expectation) -> Option<Stated> {
        let quantity = self.scene.quantity(fact.subject)?;
        if let Subject::Measure(_) = fact.subject {
            let (name, unit) = (quantity.name.to_owned(), quantity.unit.to_owned());
            let (factor, place) = (quantity.factor, "run".to_owned());
            return Some(Stated { fact, name, unit, factor, variable: None, place });
        }
        let named = |variable: &Variable| variable.name == quantity.name;
        let variable = self.variables.iter().position(named)?;
        let printed = &self.variables[variable];
        let place = match fact.at {
            At::Maximum => "maximum".to_owned(),
            At::Minimum => "minimum".to_owned(),
            At::Amplitude => "amplitude".to_owned(),
            At::Run => return None,
            At::Position(positions) => {
                let label = positions.iter().map(|(index, at)| self.driver_at(*index, *at));
                label.collect::<Vec<_>>().join(", ")
            }
            At::Driver(driver, position) => self.driver_at(driver, position),
            At::Time(time) => amount_of(&TIME, time),
        };
        let (name, (unit, factor), variable) = match fact.subject {
            Subject::Influence(_, by) => {
                let by = influence::quantity(self, *self.moved.entry.variables.get(by)?)?;
                let name = format!("diff({}, {})", printed.name, by.name);
                (name, influence::unit_of(printed, &by), None)
            }
            _ => (printed.name.clone(), (printed.unit.clone(), printed.factor), Some(variable)),
        };
        Some(Stated { fact, name, unit, factor, variable, place })
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
            let (lines, measures) = (Vec::new(), Vec::new());
            Self { case, lines, strokes: None, measures, unmeasured: None, seconds: 0.0 }
        }))
    }

    fn compare(&self, fact: &'static Expectation) -> Option<Comparison> {
        let stated = self.case.stated(fact)?;
        if let Subject::Measure(index) = fact.subject {
            let found = self.measures.get(index);
            let (computed, error) = found
                .map_or((f64::NAN, f64::NAN), |one| (one.value.unwrap_or(f64::NAN), one.error));
            return Some(Comparison { stated, time: None, computed, error, comparable: true });
        }
        let quantity = self.case.scene.quantity(fact.subject)?;
        let mut variables = self.case.variables.iter();
        let variable = variables.position(|variable| variable.name == quantity.name)?;
        let (time, computed) = self.value(fact, variable)?;
        let error = 1e-12 * computed.abs();
        Some(Comparison { stated, time, computed, error, comparable: true })
    }
}
