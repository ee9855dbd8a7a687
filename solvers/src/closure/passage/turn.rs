//! Dead points of any group: where the curve of positions turns back on its way, and passing through.

use super::arc::{Curve, Point};
use super::continuation::{Segment, scalars};
use super::crossing::Crossing;
use crate::closure::error::ClosureError;
use crate::closure::extent::root::brent;
use crate::closure::position::assembly::Event;
use crate::closure::position::guide::Guide;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// First length along the curve that is tried, in radians.
const FIRST: f64 = 0.01;
/// Largest length of one step.
const LARGEST: f64 = 0.1;
/// Smallest length of one step.
const SMALLEST: f64 = 1e-9;
/// Part of the largest dimension below which a displacement is rounding.
const NOTHING: f64 = 1e-9;
/// Largest number of steps.
const STEPS: usize = 2000;

/// A turn of the curve: the points on both sides of it, and it.
struct Turn {
    after: Point,
    dead: Point,
}

impl<S: Scalar> Guide<'_, S> {
    /// Where the curve of positions from `done` turns back before the end of the way.
    pub(super) fn turn_ahead(&mut self, way: &Segment, done: f64) -> Option<f64> {
        let mut curve = self.curve(way);
        let begin = curve.begin(&self.coordinates(), done)?;
        let turn = find_turn(&mut curve, begin)?;
        Some(curve.place(&turn.dead))
    }

    /// The change point ahead of a group that is iterated, if the curve of positions goes smoothly through one.
    pub(super) fn cross_ahead(
        &mut self,
        way: &Segment,
        done: f64,
        group: usize,
    ) -> Option<Crossing> {
        let at = self.zero_ahead(way, done, group)?;
        let rough = self.cross_near(way, done, group, (at, 0.25 * (at - done)))?;
        let fine = rough.place_and_unit();
        self.cross_near(way, done, group, fine)
    }

    /// The change point, looked for from places about where it is expected, a unit apart.
    fn cross_near(
        &mut self,
        way: &Segment,
        done: f64,
        group: usize,
        (at, unit): (f64, f64),
    ) -> Option<Crossing> {
        let nodes = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|k| at + k * unit);
        let mut curve = self.curve(way);
        let mut point = curve.begin(&self.coordinates(), done)?;
        let unknowns = self.entry.groups[group].unknowns;
        let mut values = vec![[0.0; 6]; unknowns.len()];
        let mut sines = [0.0; 6];
        for (k, &t) in nodes.iter().enumerate() {
            point = curve.reach(point, t)?;
            let coordinates = curve.coordinates(&point);
            let instant = self.instant_at(&scalars::<S>(&way.at(t)));
            for (entry, value) in self.trial.iter_mut().zip(&coordinates) {
                *entry = S::from_f64(*value);
            }
            for before in 0..=group {
                sines[k] = self.newton.sine(self.loops, before, &instant, self.trial);
            }
            for (value, &j) in values.iter_mut().zip(unknowns) {
                value[k] = coordinates[j];
            }
        }
        Crossing::between(group, nodes, sines, values)
    }

    /// The dead point on the way to these independent variables: where it is, and the dependent coordinates there.
    pub(in crate::closure) fn dead_position(
        &mut self,
        wanted: &[f64],
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let way = Segment::new(self.place(), wanted.to_vec());
        let mut curve = self.curve(&way);
        let begin = curve.begin(&self.coordinates(), 0.0)?;
        let dead = find_turn(&mut curve, begin)?.dead;
        Some((way.at(curve.place(&dead)), curve.coordinates(&dead)))
    }

    /// Passes through the dead point on the way to these independent variables, by the length of the curve of positions,
    /// back to where the linkage stands, on the other mode.
    ///
    /// # Errors
    /// [`ClosureError::ModeLost`] if there is no dead point on this way, or the curve could not be followed.
    pub fn pass_dead_point(&mut self, wanted: &[f64]) -> Result<(), ClosureError> {
        let here = self.place();
        let way = Segment::new(here.clone(), wanted.to_vec());
        let back = self.go_around(&way);
        let Some((coordinates, dead)) = back else {
            let (group, sine) = self.weakest();
            return Err(ClosureError::ModeLost { group, at: here, wanted: wanted.to_vec(), sine });
        };
        let before: Vec<f64> = (0..self.entry.groups.len()).map(|group| self.sine(group)).collect();
        let mut events = std::mem::take(self.events);
        let outcome = self.start_at(&here, &coordinates);
        for (group, sine) in before.into_iter().enumerate() {
            if outcome.is_ok() && sine.signum() != self.sine(group).signum() {
                let (at, mode) = (way.at(dead), self.sine(group).signum());
                events.push(Event::DeadPoint { group, at, mode });
            }
        }
        *self.events = events;
        outcome.map(|_| ())
    }

    /// Follows the curve around its turn. Gives the coordinates at the begin of the way on the other side, and where it
    /// turns.
    fn go_around(&mut self, way: &Segment) -> Option<(Vec<f64>, f64)> {
        let mut curve = self.curve(way);
        let begin = curve.begin(&self.coordinates(), 0.0)?;
        let Turn { after, dead } = find_turn(&mut curve, begin)?;
        let (mut point, mut length) = (after, FIRST);
        for _ in 0..STEPS {
            if curve.place(&point) <= 0.0 {
                return Some((curve.coordinates(&point), curve.place(&dead)));
            }
            match curve.beyond(&point, length) {
                Some(next) if curve.place(&next) >= 0.0 => {
                    point = next;
                    length = f64::min(2.0 * length, LARGEST);
                }
                Some(next) => {
                    let ends = (curve.place(&point), curve.place(&next));
                    let place =
                        |s| curve.beyond(&point, s).map_or(f64::NAN, |point| curve.place(&point));
                    let root = brent(place, (0.0, ends.0), (length, ends.1));
                    let last = curve.beyond(&point, root)?;
                    return Some((curve.coordinates(&last), curve.place(&dead)));
                }
                None if length > SMALLEST => length *= 0.5,
                None => return None,
            }
        }
        None
    }

    fn curve<'a>(&self, way: &'a Segment) -> Curve<'a> {
        Curve::new(self.linkage, way, self.units(way))
    }

    /// What counts as much as a radian: of the dependent coordinates, the size that displacements have; of the way, the
    /// part on which a driver makes 1/2π of its period or goes through its range.
    fn units(&self, way: &Segment) -> Vec<f64> {
        let (coordinates, constants) = (self.coordinates(), self.linkage.shape().constants);
        let values = self.linkage.values();
        let sizes = coordinates.iter().enumerate().map(|(j, value)| {
            let alike = |index: &usize| {
                constants[*index].quantity.dimension == self.entry.dependents[j].dimension
            };
            let alike = (0..constants.len()).filter(alike).map(|index| values[index].abs());
            // What is nothing beside the dimensions has no size of its own.
            match (value.abs(), alike.fold(0.0, f64::max)) {
                _ if self.entry.angles[j] => 1.0,
                (size, largest) if size > NOTHING * largest => size,
                (_, largest) if largest > 0.0 => largest,
                _ => 1.0,
            }
        });
        let parts = way.heading().into_iter().zip(self.linkage.ranges()).map(|(part, range)| {
            let scale = if range.period.is_finite() {
                range.period / TAU
            } else {
                (range.to - range.from).abs()
            };
            if scale > 0.0 { part.abs() / scale } else { part.abs() }
        });
        let fastest = parts.fold(0.0, f64::max);
        sizes.chain([1.0 / fastest]).collect()
    }
}

/// Follows the curve until it turns back before the end of its way.
fn find_turn(curve: &mut Curve<'_>, begin: Point) -> Option<Turn> {
    let (mut point, mut length) = (begin, FIRST);
    for _ in 0..STEPS {
        match curve.beyond(&point, length) {
            Some(next) if curve.rate(&next) <= 0.0 => {
                let dead = curve.dead_point(&point, &next, length);
                return (curve.place(&dead) <= 1.0).then_some(Turn { after: next, dead });
            }
            Some(next) => {
                if curve.place(&next) > 1.0 && curve.place(&point) > 1.0 {
                    return None;
                }
                point = next;
                length = f64::min(2.0 * length, LARGEST);
            }
            None if length > SMALLEST => length *= 0.5,
            None => return None,
        }
    }
    None
}
