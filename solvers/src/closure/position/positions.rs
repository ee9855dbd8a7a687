//! Positions that were gone through, written down.

use super::assembly::{Assembly, Event};
use crate::closure::error::ClosureError;
use crate::closure::linkage::problem::Linkage;
use crate::scalar::Scalar;
use crate::shape::Shape;

/// Positions in the order in which they were asked for: the last variable changes fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Positions {
    /// Numbers of independent variables, dependent coordinates and outputs.
    widths: (usize, usize, usize),
    independents: Vec<f64>,
    coordinates: Vec<f64>,
    outputs: Vec<f64>,
    sines: Vec<f64>,
    /// What happened on the way.
    pub events: Vec<Event>,
    /// Why the first position that could not be reached could not, if there is one. Of a single variable the positions
    /// end before it; in a grid of several, positions that were not reached are NaN.
    pub end: Option<ClosureError>,
    /// How many positions were not reached.
    pub missed: usize,
}

impl Positions {
    /// Number of positions.
    pub fn len(&self) -> usize {
        self.sines.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.sines.is_empty()
    }

    /// The independent variables at a position.
    pub fn independents(&self, index: usize) -> &[f64] {
        &self.independents[index * self.widths.0..][..self.widths.0]
    }

    /// The dependent coordinates at a position, angles continued over whole turns.
    pub fn coordinates(&self, index: usize) -> &[f64] {
        &self.coordinates[index * self.widths.1..][..self.widths.1]
    }

    /// The outputs at a position.
    pub fn outputs(&self, index: usize) -> &[f64] {
        &self.outputs[index * self.widths.2..][..self.widths.2]
    }

    /// Smallest modulus of the sines of transmission angles at a position.
    pub fn sine(&self, index: usize) -> f64 {
        self.sines[index]
    }

    /// Room for a number of positions, all NaN.
    pub(super) fn new(shape: &Shape, count: usize) -> Self {
        let room = |width: usize| vec![f64::NAN; width * count];
        let widths = (shape.drivers.len(), shape.loops().dependents.len(), shape.outputs.len());
        Self {
            widths,
            independents: room(widths.0),
            coordinates: room(widths.1),
            outputs: room(widths.2),
            sines: room(1),
            ..Self::default()
        }
    }

    /// Leaves only the first ones.
    pub(super) fn truncate(&mut self, count: usize) {
        self.independents.truncate(count * self.widths.0);
        self.coordinates.truncate(count * self.widths.1);
        self.outputs.truncate(count * self.widths.2);
        self.sines.truncate(count);
    }

    /// Adds room for one position.
    pub(super) fn extend(&mut self) {
        let (a, b, c) = self.widths;
        for (values, width) in
            [(&mut self.independents, a), (&mut self.coordinates, b), (&mut self.outputs, c)]
        {
            values.resize(values.len() + width, f64::NAN);
        }
        self.sines.push(f64::NAN);
    }
}

/// Writes a position down.
#[inline(always)]
pub(super) fn record<L: Linkage, S: Scalar>(
    assembly: &Assembly<L, S>,
    outputs: &mut [S],
    positions: &mut Positions,
    index: usize,
) {
    assembly.outputs(outputs);
    let (a, b, c) = positions.widths;
    copy(&mut positions.independents[index * a..][..a], assembly.independents());
    copy(&mut positions.coordinates[index * b..][..b], assembly.position().as_ref());
    copy(&mut positions.outputs[index * c..][..c], outputs);
    positions.sines[index] = assembly.weakest().1.abs();
}

#[inline(always)]
fn copy<S: Scalar>(to: &mut [f64], from: &[S]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = from.to_f64();
    }
}
