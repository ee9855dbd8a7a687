//! Change points: two modes of a group meet, and both go on.
//!
//! There the sine of the transmission angle passes through zero along either smooth branch, so that its modulus, found
//! with a fixed mode, comes back. All is computed from positions at some distance on both sides, where the sines are
//! large enough to be known well: at the change point itself half of the digits are lost.

use super::continuation::Segment;
use super::stand::Stand;
use crate::closure::extent::root::through;
use crate::closure::position::assembly::Event;
use crate::closure::position::guide::Guide;
use crate::scalar::Scalar;
use crate::shape::GroupKind;

/// Sine at which it is decided whether modes meet, miss each other or leave a gap.
pub(super) const FINEST: f64 = 1e-6;
/// Sine at the nearest of the positions from which the change point is computed.
pub(super) const SINE: f64 = 2e-3;
/// A change point on a way.
pub(in crate::closure) struct Crossing {
    /// The group concerned.
    pub group: usize,
    /// Where on the way.
    pub at: f64,
    /// AssemblyModes before and after it.
    pub modes: (f64, f64),
    /// Within this distance the position is interpolated.
    pub near: f64,
    /// Where positions are known.
    pub nodes: [f64; 6],
    /// The unknowns of the group there.
    pub values: Vec<[f64; 6]>,
}

impl Crossing {
    /// The mode of the smooth branch.
    pub fn mode_at(&self, t: f64) -> f64 {
        if t <= self.at + self.near { self.modes.0 } else { self.modes.1 }
    }

    /// Whether a place is so far beyond it that more may have happened on the way.
    pub fn is_beyond(&self, t: f64) -> bool {
        t > self.nodes[5]
    }

    /// Whether the position has to be interpolated.
    pub fn is_at(&self, t: f64) -> bool {
        (t - self.at).abs() <= self.near
    }
}

impl Crossing {
    /// The change point of a group whose unknowns and sines are known at places on both sides of it, along the smooth
    /// branch. None if the sine does not change its sign between the third and the fourth, and only there.
    pub fn between(
        group: usize,
        nodes: [f64; 6],
        sines: [f64; 6],
        values: Vec<[f64; 6]>,
    ) -> Option<Self> {
        let [before, after] = [sines[2], sines[3]].map(f64::signum);
        let flips = sines[..3].iter().all(|sine| sine.signum() == before)
            && sines[3..].iter().all(|sine| sine.signum() == after);
        let rate = (sines[2] - sines[3]).abs() / (nodes[3] - nodes[2]);
        (flips && before != after).then(|| Self {
            group,
            at: through(sines, nodes, 0.0),
            modes: (before, after),
            near: FINEST / rate,
            nodes,
            values,
        })
    }

    /// Where it is, and at which distance from it the sine is large enough to be known well.
    pub fn place_and_unit(&self) -> (f64, f64) {
        let unit = self.near * (SINE / FINEST);
        (self.at, unit.min(self.nodes[3] - self.at))
    }

    /// Whether a place is among those from which it is computed.
    pub fn surrounds(&self, t: f64) -> bool {
        self.nodes[0] <= t && t <= self.nodes[5]
    }

    /// Slopes of the unknowns along the way.
    pub fn slopes(&self) -> Vec<f64> {
        let (a, b) = (self.nodes[2], self.nodes[3]);
        let slope = |values: &[f64; 6]| (values[3] - values[2]) / (b - a);
        self.values.iter().map(slope).collect()
    }
}

impl<S: Scalar> Guide<'_, S> {
    /// Takes the unknowns of a group at a change point from its neighbourhood. Gives the sine.
    pub(super) fn interpolate(&mut self, crossing: &Crossing, t: f64, instant: &[S]) -> f64 {
        let unknowns = self.entry.groups[crossing.group].unknowns;
        for (values, &j) in crossing.values.iter().zip(unknowns) {
            self.trial[j] = S::from_f64(through(crossing.nodes, *values, t));
        }
        let group = crossing.group;
        self.newton.sine(self.loops, group, instant, self.trial)
    }

    /// Closes a group that is iterated from its interpolated unknowns. Gives the sine, NaN if that fails.
    pub(super) fn close_between(&mut self, crossing: &Crossing, t: f64, instant: &[S]) -> f64 {
        self.interpolate(crossing, t, instant);
        let group = crossing.group;
        let closed = self.newton.close(self.loops, group, instant, self.trial);
        closed.map_or(f64::NAN, |closed| closed.sine)
    }

    /// Reports the change points that are passed, and remembers those that are stood on.
    pub(super) fn pass_crossings(&mut self, way: &mut Segment, t: f64) {
        self.stands.clear();
        for crossing in std::mem::take(&mut way.crossings) {
            if crossing.is_at(t) {
                self.stands.push(Stand::new(&crossing, way));
            } else if t > crossing.at {
                self.report(&crossing, way);
            } else {
                way.crossings.push(crossing);
            }
        }
    }

    fn report(&mut self, crossing: &Crossing, way: &Segment) {
        let iterated = self.entry.groups[crossing.group].kind == GroupKind::General;
        let before = if iterated { crossing.modes.0 } else { self.mode(crossing.group) };
        if before != crossing.modes.1 {
            self.events.push(Event::ChangePoint {
                group: crossing.group,
                at: way.at(crossing.at),
                mode: crossing.modes.1,
            });
        }
    }
}
