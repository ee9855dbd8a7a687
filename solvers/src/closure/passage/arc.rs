//! The curve of positions along a way, by its own length: the way may turn back at a dead point, the curve does not.
//!
//! Pseudo-arclength continuation (H. B. Keller, 1977; E. Allgower, K. Georg: *Numerical Continuation Methods*, 1990,
//! chapters 6 and 7) of all loops `F(z, t) = 0` at once, `t` the place on the way. The derivatives come from dual
//! numbers, so that they exist where the kinematic coefficients do not.

use super::continuation::{Segment, scalars};
use crate::closure::extent::root::brent;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::{Answers, Square};
use crate::dense::Lu;
use crate::scalar::{Dual, Scalar};
use crate::shape::LinkageEntry;

/// Largest turn of the tangent in one step: its cosine.
const STRAIGHT: f64 = 0.97;
/// Largest and smallest length of one step towards a place, and their number.
const LONGEST: f64 = 0.05;
const SHORTEST: f64 = 1e-9;
const STEPS: usize = 200;
/// Length that counts as none, in radians.
const REACHED: f64 = 1e-12;
/// Iterations of the corrector.
const ITERATIONS: usize = 8;
/// Length of a correction, in radians, that ends the iteration.
const CORRECTED: f64 = 1e-9;

/// A point of the curve with its tangent.
#[derive(Clone)]
pub(super) struct Point {
    /// Dependent coordinates and, last, the place on the way, in their units.
    pub y: Vec<f64>,
    /// Direction of the curve, of length one.
    pub tangent: Vec<f64>,
}

/// The curve of positions over a way.
pub(super) struct Curve<'a> {
    loops: Box<dyn Answers<Dual>>,
    entry: &'static LinkageEntry,
    way: &'a Segment,
    /// Units of the dependent coordinates, and of the place on the way.
    units: Vec<f64>,
    square: Square<Dual>,
    position: Vec<Dual>,
}

impl<'a> Curve<'a> {
    /// The curve. Units of the dependent coordinates and, last, of the place: what counts as much as a radian.
    pub fn new(linkage: &dyn AnyLinkage, way: &'a Segment, units: Vec<f64>) -> Self {
        let values: Vec<Dual> = scalars(&linkage.values());
        let loops = linkage.differentiate(&values);
        Self {
            entry: linkage.shape().loops(),
            way,
            units,
            square: Square::of(linkage.shape()),
            position: vec![Dual::ZERO; loops.lengths().0],
            loops,
        }
    }

    /// A point of the curve from a closed position, its tangent pointing along the way.
    pub fn begin(&mut self, coordinates: &[f64], t: f64) -> Option<Point> {
        let n = self.entry.dependents.len();
        let mut y: Vec<f64> =
            coordinates[..n].iter().zip(&self.units).map(|(z, unit)| z / unit).collect();
        y.push(t / self.units[n]);
        let mut along = vec![0.0; n + 1];
        along[n] = 1.0;
        let tangent = self.tangent(&y, &along)?;
        Some(Point { y, tangent })
    }

    /// The place of a point on the way.
    pub fn place(&self, point: &Point) -> f64 {
        point.y[self.entry.dependents.len()] * self.units[self.entry.dependents.len()]
    }

    /// The dependent coordinates of a point.
    pub fn coordinates(&self, point: &Point) -> Vec<f64> {
        let parts = point.y[..self.entry.dependents.len()].iter().zip(&self.units);
        parts.map(|(z, unit)| z * unit).collect()
    }

    /// The rate of the place along the curve; zero at a dead point.
    pub fn rate(&self, point: &Point) -> f64 {
        point.tangent[self.entry.dependents.len()]
    }

    /// The point at a length beyond another one, if it is certainly on the same curve.
    pub fn beyond(&mut self, from: &Point, length: f64) -> Option<Point> {
        let mut y: Vec<f64> =
            from.y.iter().zip(&from.tangent).map(|(y, part)| y + length * part).collect();
        let expected = y.clone();
        for _ in 0..ITERATIONS {
            let (mut matrix, residual) = self.system(&y, &from.tangent);
            let offset: f64 = (0..y.len()).map(|k| from.tangent[k] * (y[k] - expected[k])).sum();
            let mut change: Vec<f64> =
                residual.into_iter().chain([offset]).map(|value| -value).collect();
            solve(&mut matrix, &mut change)?;
            let size = change.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
            for (value, part) in y.iter_mut().zip(&change) {
                *value += part;
            }
            if size > 0.5 * length.abs() + CORRECTED || !size.is_finite() {
                return None;
            }
            if size <= CORRECTED {
                let tangent = self.tangent(&y, &from.tangent)?;
                let cosine: f64 = tangent.iter().zip(&from.tangent).map(|(a, b)| a * b).sum();
                return (cosine >= STRAIGHT).then_some(Point { y, tangent });
            }
        }
        None
    }

    /// The point at a place further on, if the curve goes there without turning back.
    pub fn reach(&mut self, from: Point, t: f64) -> Option<Point> {
        let mut point = from;
        for _ in 0..STEPS {
            let left = (t - self.place(&point)) / self.units[self.entry.dependents.len()];
            let mut length = left / self.rate(&point);
            if length.abs() < REACHED {
                return Some(point);
            }
            length = length.clamp(-LONGEST, LONGEST);
            let mut next = self.beyond(&point, length);
            while next.is_none() && length.abs() > SHORTEST {
                length *= 0.5;
                next = self.beyond(&point, length);
            }
            point = next.filter(|next| self.rate(next) > 0.0)?;
        }
        None
    }

    /// The dead point between two points of the curve on either side of it, one `length` beyond the other.
    pub fn dead_point(&mut self, from: &Point, to: &Point, length: f64) -> Point {
        let ends = (self.rate(from), self.rate(to));
        let root = brent(
            |s| self.beyond(from, s).map_or(f64::NAN, |point| self.rate(&point)),
            (0.0, ends.0),
            (length, ends.1),
        );
        self.beyond(from, root).unwrap_or_else(|| from.clone())
    }

    /// The direction of the curve that goes on with another one.
    fn tangent(&mut self, y: &[f64], along: &[f64]) -> Option<Vec<f64>> {
        let (mut matrix, _) = self.system(y, along);
        let mut tangent = vec![0.0; y.len()];
        tangent[self.entry.dependents.len()] = 1.0;
        solve(&mut matrix, &mut tangent)?;
        let length = tangent.iter().map(|part| part * part).sum::<f64>().sqrt();
        tangent.iter_mut().for_each(|part| *part /= length);
        length.is_finite().then_some(tangent)
    }

    /// Derivatives of all equations by all coordinates and the place, with a last row added, and the residuals. The rows
    /// are in the order of the groups, in units of their largest derivatives.
    fn system(&mut self, y: &[f64], last: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.entry.dependents.len();
        let mut matrix = vec![0.0; (n + 1) * (n + 1)];
        let mut residual = vec![0.0; n];
        for column in 0..=n {
            self.look(y, column, |row, found| {
                residual[row] = found.value;
                matrix[row * (n + 1) + column] = found.slope;
            });
        }
        for (row, value) in matrix.chunks_exact_mut(n + 1).zip(&mut residual) {
            let size = row.iter().fold(f64::MIN_POSITIVE, |most, entry| most.max(entry.abs()));
            row.iter_mut().for_each(|entry| *entry /= size);
            *value /= size;
        }
        matrix[n * (n + 1)..].copy_from_slice(last);
        (matrix, residual)
    }

    /// Evaluates all equations with their derivatives by one coordinate or the place.
    fn look(&mut self, y: &[f64], column: usize, mut take: impl FnMut(usize, Dual)) {
        let n = self.entry.dependents.len();
        let mut independents: Vec<Dual> = scalars(&self.way.at(y[n] * self.units[n]));
        if column == n {
            for (value, part) in independents.iter_mut().zip(self.way.heading()) {
                value.slope = part * self.units[n];
            }
        }
        let instant = self.loops.instant_row(&independents, &[]);
        for (j, unit) in self.units[..n].iter().enumerate() {
            let slope = if j == column { *unit } else { 0.0 };
            self.position[j] = Dual { value: y[j] * unit, slope };
        }
        let mut row = 0;
        for (index, group) in self.entry.groups.iter().enumerate() {
            self.square.look(&*self.loops, index, &instant, &mut self.position);
            for found in &self.square.residual[..group.unknowns.len()] {
                take(row, *found);
                row += 1;
            }
        }
    }
}

/// Solves a system in place.
fn solve(matrix: &mut [f64], right: &mut [f64]) -> Option<()> {
    let mut pivots = vec![0; right.len()];
    Lu::factor(matrix, right.len(), &mut pivots).ok()?;
    Lu::substitute(matrix, &pivots, right);
    Some(())
}
