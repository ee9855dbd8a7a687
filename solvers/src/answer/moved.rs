//! Questions to a linkage that is moved from outside: its positions, and what its tolerances make of them.

use super::error::{Error, unknown};
use crate::closure::{self, AtDeadPoint, Axis, Linkage, Positions, Variable};
use crate::shape::{Shape, Subject, find};
use crate::tolerance::{self, MonteCarlo, Sampling, Source, Study};
use std::ops::RangeInclusive;

/// What every linkage is asked.
pub trait Move: Linkage {
    /// Its positions while its first driver goes over a range, in so many even steps less one; the others stand where they
    /// start.
    ///
    /// # Errors
    /// [`Error::Open`], where it does not assemble at its start. Where the range is left early [`Sweep::positions`] says so.
    fn sweep(&self, range: RangeInclusive<f64>, count: usize) -> Result<Sweep, Error> {
        let (from, to) = range.into_inner();
        let ranges = self.ranges();
        let mut axes: Vec<Axis> = ranges.iter().map(|range| standing(range.start)).collect();
        if let Some(first) = axes.first_mut() {
            *first = Axis { from, to, count };
        }
        let positions = closure::sweep(self, &axes, AtDeadPoint::Stop).map_err(Error::Open)?;
        let shape = Linkage::shape(self);
        Ok(Sweep { shape, positions })
    }

    /// A question about the errors of an output, by its name, that the tolerances of the file make.
    fn tolerance(&self, output: &str) -> Tolerance<'_, Self> {
        let standing = self.ranges().iter().map(|range| range.start).collect();
        Tolerance { linkage: self, output: output.to_owned(), place: Ok(standing) }
    }
}

impl<L: Linkage> Move for L {}

/// A driver that stands still.
fn standing(position: f64) -> Axis {
    Axis { from: position, to: position, count: 1 }
}

/// The positions of a linkage along its first driver.
#[derive(Clone, Debug)]
pub struct Sweep {
    shape: &'static Shape,
    positions: Positions,
}

impl Sweep {
    /// The positions as the solver has them, with the dead points on the way and where they end early.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// An output or dependent coordinate by its name: pairs of the position of the driver and its value, SI units.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn output(&self, name: &str) -> Result<Vec<(f64, f64)>, Error> {
        let dependents = self.shape.linkage.map_or(&[][..], |linkage| linkage.dependents);
        let output = find(self.shape.outputs, name).map(Subject::Output);
        let subject = output.or_else(|| find(dependents, name).map(Subject::State));
        let known = self.shape.outputs.iter().chain(dependents);
        let subject = subject.ok_or_else(|| unknown(name, known.map(|one| one.name)))?;
        Ok(self.values(subject))
    }

    /// The values of a subject over the positions; nothing of what has no value in a position.
    pub fn values(&self, subject: Subject) -> Vec<(f64, f64)> {
        let value = |index: usize| match subject {
            Subject::Output(place) => self.positions.outputs(index).get(place).copied(),
            Subject::State(place) => self.positions.coordinates(index).get(place).copied(),
            _ => None,
        };
        let driver = |index: usize| self.positions.independents(index).first().copied();
        let pairs = (0..self.positions.len()).map(|index| Some((driver(index)?, value(index)?)));
        pairs.flatten().collect()
    }
}

/// A question about the errors of an output of a linkage.
pub struct Tolerance<'a, L> {
    linkage: &'a L,
    output: String,
    /// Positions of the drivers; or why there are none.
    place: Result<Vec<f64>, Error>,
}

impl<L: Linkage> Tolerance<'_, L> {
    /// Where a driver, by its name, has this position, SI units; the others stand where they start.
    #[must_use]
    pub fn at(mut self, driver: &str, position: f64) -> Self {
        let drivers = Linkage::shape(self.linkage).drivers;
        if let Ok(place) = &mut self.place {
            match find(drivers, driver) {
                Some(index) => place[index] = position,
                None => {
                    self.place = Err(unknown(driver, drivers.iter().map(|one| one.name)));
                }
            }
        }
        self
    }

    /// What errs by how much, and where: for what [`mod@crate::tolerance`] answers.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn study(&self) -> Result<Study, Error> {
        let shape = Linkage::shape(self.linkage);
        let Some(output) = find(shape.outputs, &self.output) else {
            let outputs = shape.outputs.iter();
            return Err(unknown(&self.output, outputs.map(|one| one.name)));
        };
        Ok(Study { output, places: vec![self.place.clone()?], sources: sources(shape) })
    }

    /// The errors of so many linkages made at random.
    ///
    /// # Errors
    /// [`Error::Unknown`]; [`Error::Tolerance`], where the question makes no sense.
    pub fn monte_carlo(&self, samples: u64) -> Result<MonteCarlo, Error> {
        let sampling = Sampling { samples, ..Sampling::default() };
        let found = tolerance::monte_carlo(self.linkage, &self.study()?, &sampling, &|_| {});
        found.map_err(Error::Tolerance)
    }
}

/// What errs by the tolerances of the file.
fn sources(shape: &Shape) -> Vec<Source> {
    let Some(linkage) = shape.linkage else {
        return Vec::new();
    };
    let variables = linkage.variables.iter().enumerate();
    let sources = variables.map(|(variable, kind)| {
        let (half_width, distribution) = match kind {
            Variable::Constant(index) => {
                let constant = &shape.constants[*index];
                (constant.tolerance, constant.distribution)
            }
            Variable::Driver(index) => linkage.tolerances[*index],
        };
        Source { variable, half_width, distribution }
    });
    sources.filter(|source| source.half_width > 0.0).collect()
}
