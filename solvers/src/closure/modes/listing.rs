//! How a linkage can be assembled, and how far it goes.

use std::f64::consts::TAU;

use assur_functions::Sense;

use crate::closure::extent::limits::stretch_of;
use crate::closure::extent::measures::{Measured, measures_of, weighed_of};
use crate::closure::extent::sampled::sampled_of;
use crate::closure::extent::strokes::strokes_of;
use crate::closure::modes::modes_of;
use crate::closure::{
    Along, AnyLinkage, AssemblyMode, ClosureError, Facets, Newton, Range, Search, Stretch, Stroke,
};
use crate::measure::Missing;
use crate::problem::Span;

/// Solutions nearer to each other than this are the same, in radians, metres or whatever a coordinate is in.
const SAME: f64 = 1e-6;

/// All assembly modes at one place, each with what it amounts to.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The modes.
    pub modes: Vec<Listed>,
    /// Whether there are certainly no others (but for displacements beyond the bound of the search).
    pub complete: bool,
    /// Boxes of unknowns that could not be decided: two modes may meet there, or nearly.
    pub undecided: usize,
    /// Boxes that were looked at.
    pub boxes: usize,
    /// Which of the modes the start values pick.
    pub declared: Option<usize>,
    /// Why the linkage does not get to the place in that mode.
    pub stopped: Option<ClosureError>,
}

/// One assembly mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The dependent coordinates, angles within `±π`.
    pub dependents: Vec<f64>,
    /// The outputs.
    pub outputs: Vec<f64>,
    /// Sine of the transmission angle of each group: its determinant over the lengths of its columns.
    pub sines: Vec<f64>,
    /// What is left of each loop equation.
    pub residuals: Vec<f64>,
}

impl dyn AnyLinkage + '_ {
    /// All assembly modes at a place, and which one the start values pick; see [`fn@crate::closure::modes`]. The place is the
    /// positions of the drivers, and behind them how these move where that is known.
    ///
    /// # Errors
    /// [`ClosureError::BadRange`] if the place makes no sense.
    pub fn modes(&self, place: &[f64], search: &Search) -> Result<Listing, ClosureError> {
        let (drivers, motion) = place.split_at(place.len().min(self.shape().drivers.len()));
        let found = modes_of(self, drivers, search)?;
        let modes = found.modes.into_iter();
        let modes: Vec<_> = modes.map(|mode| self.listed((drivers, motion), mode)).collect();
        let (declared, stopped) = match self.there(drivers) {
            Ok(dependents) => {
                let same = |mode: &Listed| self.is_same(&mode.dependents, &dependents);
                (modes.iter().position(same), None)
            }
            Err(error) => (None, Some(error)),
        };
        Ok(Listing {
            modes,
            complete: found.complete,
            undecided: found.undecided,
            boxes: found.boxes,
            declared,
            stopped,
        })
    }

    /// How far one driver goes within bounds, see [`fn@crate::closure::stretch`].
    ///
    /// # Errors
    /// As there.
    pub fn stretch(&self, driver: usize, bounds: (f64, f64)) -> Result<Stretch, ClosureError> {
        stretch_of(self, driver, bounds)
    }

    /// Limit positions and strokes of the outputs, and behind them of the dependent coordinates, see
    /// [`fn@crate::closure::strokes`].
    ///
    /// # Errors
    /// As there.
    pub fn strokes(&self, along: Along) -> Result<Vec<Stroke>, ClosureError> {
        strokes_of(self, along)
    }

    /// The measures along a way, in the order of the file.
    ///
    /// # Errors
    /// Why the linkage does not get through it.
    pub fn measures(&self, along: Along) -> Result<Vec<Measured>, ClosureError> {
        measures_of(self, along)
    }

    /// Those that are wanted, by their index, by a look at fewer places, for designs that are weighed against many others: without
    /// errors. The others are missing.
    ///
    /// # Errors
    /// As there.
    pub fn weighed(
        &self,
        along: Along,
        wanted: &dyn Fn(usize) -> bool,
    ) -> Result<Vec<Result<f64, Missing>>, ClosureError> {
        weighed_of(self, along, wanted)
    }

    /// All quantities that measures look at, at the middles of so many parts of a way, only some groups of loops being closed, each
    /// after those that it needs: what needs others means nothing. None where one of them does not close.
    pub fn sampled(&self, along: Along, groups: &[usize], places: usize) -> Option<Vec<Vec<f64>>> {
        sampled_of(self, along, groups, places)
    }

    /// How measures along a way change with constants, each with the width of its range: what [`Facets::of`] answers, for
    /// this linkage and for others of its kind. Each measure stands with the sense in which it is good.
    ///
    /// # Errors
    /// Why the linkage does not get through its way.
    pub fn facets(
        &self,
        along: Along,
        constants: Vec<(usize, f64)>,
        measures: &[(usize, Option<Sense>)],
    ) -> Result<Facets, ClosureError> {
        Facets::new(self, along, constants, measures)
    }

    /// The measures as the constants alone give them: those that use a primitive, which is found on a way, mean nothing.
    pub fn of_constants(&self) -> Vec<f64> {
        let shape = self.shape();
        let mut values = vec![f64::NAN; shape.measures.len()];
        let found = vec![f64::NAN; shape.primitives.len()];
        self.prepare(&self.values()).measures(&found, &mut values);
        values
    }

    /// The way of the task, where it has one: that of the only driver that is swept, or the time. A sweep may go backwards.
    pub fn way(&self) -> Option<Along> {
        if !matches!(self.span(), Span::Open) {
            let (from, to) = self.span().limits();
            return Some(Along::Time(from, to));
        }
        let ranges = self.ranges();
        let goes = |range: &Range| range.from.is_finite() && range.to != range.from;
        let mut swept = ranges.iter().enumerate().filter(|(_, range)| goes(range));
        match (swept.next(), swept.next()) {
            (Some((driver, range)), None) => Some(Along::Driver(driver, (range.from, range.to))),
            _ => None,
        }
    }

    /// How drivers move, if as much is given as they have.
    pub(in crate::closure) fn motion<'a>(&self, motion: &'a [f64]) -> &'a [f64] {
        match motion.len() == self.shape().loops().motion {
            true => motion,
            false => &[],
        }
    }

    /// A mode with its outputs and what is left of its equations.
    fn listed(&self, (drivers, motion): (&[f64], &[f64]), mode: AssemblyMode) -> Listed {
        let (shape, loops) = (self.shape(), self.prepare(&self.values()));
        let instant = loops.instant_row(drivers, self.motion(motion));
        let mut position = vec![0.0; loops.lengths().0];
        position[..mode.coordinates.len()].copy_from_slice(&mode.coordinates);
        // What the position holds beside the coordinates follows from them.
        let mut newton = Newton::new(shape);
        for group in 0..shape.loops().groups.len() {
            newton.sine(&*loops, group, &instant, &mut position);
        }
        let mut outputs = vec![0.0; shape.outputs.len()];
        loops.outputs(&instant, &position, &mut outputs);
        let mut residuals = vec![0.0; shape.loops().dependents.len()];
        loops.residual(&instant, &position, &mut residuals);
        Listed { dependents: mode.coordinates, outputs, sines: mode.sines, residuals }
    }

    /// The dependent coordinates at a place in the mode that the start values pick.
    fn there(&self, place: &[f64]) -> Result<Vec<f64>, ClosureError> {
        let mut assembly = self.assemble();
        assembly.guide().start()?;
        assembly.travel(place)?;
        Ok(assembly.guide().coordinates())
    }

    /// Whether two positions are one, angles but for whole turns.
    fn is_same(&self, a: &[f64], b: &[f64]) -> bool {
        let mut pairs = a.iter().zip(b).zip(self.shape().loops().angles);
        pairs.all(|((a, b), is_angle)| {
            let apart = match is_angle {
                true => (a - b) - TAU * ((a - b) / TAU).round(),
                false => a - b,
            };
            apart.abs() < SAME
        })
    }
}
