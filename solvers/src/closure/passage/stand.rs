//! Standing exactly at a change point, and leaving it along the smooth branches.
//!
//! Which branch that is depends on where the motion goes on, so that it is decided when the place is left: the slopes of
//! the unknowns, kept from the way that led there, tell the branches apart.

use super::continuation::{Segment, scalars};
use super::crossing::{Crossing, SINE};
use super::meeting::{CLEAR, Meeting};
use crate::closure::error::ClosureError;
use crate::closure::position::guide::Guide;
use crate::scalar::Scalar;
use crate::shape::GroupKind;

/// Part of a way on which the rate of a sine is measured that begins at zero.
const TINY: f64 = 1e-3;
/// How far a solution may be from where the slopes let expect it, as a part of the way there.
const NEAR: f64 = 0.25;

/// A group that stands exactly at a change point.
pub(in crate::closure) struct Stand {
    group: usize,
    /// The way that led there.
    heading: Vec<f64>,
    /// Slopes of the unknowns along it.
    slopes: Vec<f64>,
}

impl Stand {
    /// A group at a change point of a way.
    pub fn new(crossing: &Crossing, way: &Segment) -> Self {
        Self { group: crossing.group, heading: way.heading(), slopes: crossing.slopes() }
    }

    /// What the slopes let expect of the unknowns on another way.
    fn slopes_on(&self, way: &Segment) -> Vec<f64> {
        let along: f64 = way.heading().iter().zip(&self.heading).map(|(a, b)| a * b).sum();
        let square: f64 = self.heading.iter().map(|part| part * part).sum();
        self.slopes.iter().map(|slope| slope * along / square).collect()
    }
}

impl<S: Scalar> Guide<'_, S> {
    /// Prepares to leave the change points that are stood on along the smooth branches.
    pub(super) fn leave_stands(&mut self, way: &mut Segment) -> Result<(), ClosureError> {
        for stand in std::mem::take(self.stands) {
            let meeting = if self.entry.groups[stand.group].kind == GroupKind::General {
                self.leave_iterated(way, &stand).map_or(Meeting::None, Meeting::Point)
            } else {
                self.leave(way, &stand)
            };
            self.stands.push(stand);
            match meeting {
                Meeting::Point(crossing) => way.crossings.push(crossing),
                _ => return Err(self.lost_at(way, self.stands[0].group)),
            }
        }
        Ok(())
    }

    fn leave(&mut self, way: &Segment, stand: &Stand) -> Meeting {
        let group = stand.group;
        let rate = self.probe(way, TINY, group, 1.0).abs() / TINY;
        let before = -SINE / rate;
        let slopes = stand.slopes_on(way);
        let misses = [1.0, -1.0].map(|mode| {
            self.probe(way, before, group, mode);
            let parts = self.entry.groups[group].unknowns.iter().zip(&slopes);
            let missed = parts.map(|(&j, slope)| (self.moved(j) - slope * before).abs());
            missed.fold(0.0, f64::max)
        });
        let mode = if misses[0] < misses[1] { 1.0 } else { -1.0 };
        let clear = CLEAR * f64::min(misses[0], misses[1]) < f64::max(misses[0], misses[1]);
        if clear { self.choose(way, group, mode, 0.0, rate) } else { Meeting::None }
    }

    /// How far a dependent coordinate is from where it was.
    fn moved(&self, j: usize) -> f64 {
        (self.trial[j] - self.position[j]).to_f64()
    }

    /// The change point of a group that is iterated, from solutions where the slopes let expect them.
    fn leave_iterated(&mut self, way: &Segment, stand: &Stand) -> Option<Crossing> {
        let slopes = stand.slopes_on(way);
        let rate = self.close_along(way, stand.group, &slopes, TINY)?.abs() / TINY;
        let unit = SINE / rate;
        let nodes = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|k| k * unit);
        let unknowns = self.entry.groups[stand.group].unknowns;
        let mut values = vec![[0.0; 6]; unknowns.len()];
        let mut sines = [0.0; 6];
        for (k, &t) in nodes.iter().enumerate() {
            sines[k] = self.close_along(way, stand.group, &slopes, t)?;
            for (value, &j) in values.iter_mut().zip(unknowns) {
                value[k] = self.trial[j].to_f64();
            }
        }
        Crossing::between(stand.group, nodes, sines, values)
    }

    /// Closes a group by iteration from where slopes let expect it, and gives its sine.
    fn close_along(&mut self, way: &Segment, group: usize, slopes: &[f64], t: f64) -> Option<f64> {
        if group > 0 && self.probe(way, t, group - 1, self.mode(group - 1)).is_nan() {
            return None;
        }
        let unknowns = self.entry.groups[group].unknowns;
        for (slope, &j) in slopes.iter().zip(unknowns) {
            self.trial[j] = self.position[j] + S::from_f64(slope * t);
        }
        let instant = self.instant_at(&scalars::<S>(&way.at(t)));
        let closed = self.newton.close(self.loops, group, &instant, self.trial).ok()?;
        let parts = slopes.iter().zip(unknowns);
        let missed = parts.map(|(slope, &j)| (self.moved(j) - slope * t).abs()).fold(0.0, f64::max);
        let way = slopes.iter().fold(0.0, |most: f64, slope| most.max((slope * t).abs()));
        (missed <= NEAR * way).then_some(closed.sine)
    }
}
