//! Change points: two modes of a group meet, and both go on.
//!
//! There the sine of the transmission angle passes through zero along either smooth branch, so that its modulus, found
//! with a fixed mode, comes back. All is computed from positions at some distance on both sides, where the sines are
//! large enough to be known well: at the change point itself half of the digits are lost.

use super::assembly::{Assembly, Event};
use super::continuation::{Way, scalars};
use super::newton::Instant;
use super::problem::{GroupKind, Linkage};
use super::root::through;
use super::stand::Stand;
use crate::scalar::Scalar;

/// Sine at which it is decided whether modes meet, miss each other or leave a gap.
const FINEST: f64 = 1e-6;
/// Sine at the nearest of the positions from which the change point is computed.
pub(super) const SINE: f64 = 2e-3;
/// A branch is the smooth one if it is nearer to the expectation by this factor.
pub(super) const CLEAR: f64 = 4.0;

/// A change point on a way.
pub(super) struct Crossing {
    /// The group concerned.
    pub group: usize,
    /// Where on the way.
    at: f64,
    /// Modes before and after it.
    modes: (f64, f64),
    /// Within this distance the position is interpolated.
    near: f64,
    /// Where positions are known.
    nodes: [f64; 6],
    /// The unknowns of the group there.
    values: Vec<[f64; 6]>,
}

impl Crossing {
    /// The mode of the smooth branch.
    pub fn mode_at(&self, t: f64) -> f64 {
        if t <= self.at + self.near {
            self.modes.0
        } else {
            self.modes.1
        }
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

/// What lies ahead of a group whose sine goes to zero.
pub(super) enum Meeting {
    /// A change point.
    Point(Crossing),
    /// A gap, with a place inside it.
    Gap(f64),
    /// Nothing that could be told.
    None,
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// Looks ahead from `done`, where the sine of a group goes to zero, at about `guess` if that is known.
    pub(super) fn meet(
        &mut self,
        way: &Way,
        done: f64,
        guess: Option<f64>,
        group: usize,
    ) -> Meeting {
        let Some(at) = guess.or_else(|| self.zero_ahead(way, done, group)) else {
            return Meeting::None;
        };
        let mode = self.mode(group);
        match self.close_in(way, group, mode, (done, at)) {
            Ok((at, rate)) => self.choose(way, group, mode, at, rate),
            Err(meeting) => meeting,
        }
    }

    /// Where the sine of a group goes to zero, from its change in the last step.
    pub(super) fn zero_ahead(&self, way: &Way, done: f64, group: usize) -> Option<f64> {
        let steps = self.ratio(&scalars::<S>(&way.at(1.0))).to_f64() / (1.0 - done);
        let slope = self.groups.changes.as_ref()[group].to_f64() * steps;
        let at = done - self.sine(group) / slope;
        (at > done && at < done + 4.0).then_some(at)
    }

    /// Closes in on a zero of the sine, whose modulus comes back. Gives the place and the rate of the sine.
    fn close_in(
        &mut self,
        way: &Way,
        group: usize,
        mode: f64,
        (from, at): (f64, f64),
    ) -> Result<(f64, f64), Meeting> {
        let (mut left, mut at) = (from, at);
        let mut before = self.probe(way, left, group, mode).abs();
        for _ in 0..20 {
            let right = at + (at - left);
            let after = self.probe(way, right, group, mode).abs();
            if after.is_nan() {
                let margin = self.margin_at(way, right, group);
                let allowed = self.allowance(way, left, group);
                return Err(if margin < -allowed {
                    Meeting::Gap(right)
                } else {
                    Meeting::None
                });
            }
            at = (left * after + right * before) / (before + after);
            if before <= FINEST {
                return self.decide(way, group, mode, (left, at, before));
            }
            left = at - 0.2 * (at - left);
            before = self.probe(way, left, group, mode).abs();
            if before.is_nan() || left <= from {
                return Err(Meeting::None);
            }
        }
        Err(Meeting::None)
    }

    /// Decides whether the sine really is zero at a place, up to rounding, given what it is a little before.
    fn decide(
        &mut self,
        way: &Way,
        group: usize,
        mode: f64,
        (left, at, before): (f64, f64, f64),
    ) -> Result<(f64, f64), Meeting> {
        let middle = self.probe(way, at, group, mode).abs();
        let touches = if middle.is_nan() {
            let margin = self.margin_at(way, at, group);
            if margin < -self.allowance(way, left, group) {
                return Err(Meeting::Gap(at));
            }
            margin.is_finite()
        } else {
            middle <= 0.3 * before
        };
        if touches {
            Ok((at, before / (at - left)))
        } else {
            Err(Meeting::None)
        }
    }

    /// Chooses the smooth continuation.
    pub(super) fn choose(
        &mut self,
        way: &Way,
        group: usize,
        mode: f64,
        at: f64,
        rate: f64,
    ) -> Meeting {
        let unit = SINE / rate;
        let nodes = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|k| at + k * unit);
        let unknowns = L::GROUPS[group].unknowns;
        let mut sines = [0.0; 6];
        let mut same = vec![[0.0; 6]; unknowns.len()];
        let mut other = same.clone();
        for (k, &t) in nodes.iter().enumerate() {
            for (values, mode) in [(&mut other, -mode), (&mut same, mode)] {
                sines[k] = self.probe(way, t, group, mode).abs();
                if sines[k].is_nan() {
                    return Meeting::None;
                }
                for (value, &j) in values.iter_mut().zip(unknowns) {
                    value[k] = self.trial.as_ref()[j].to_f64();
                }
            }
            if k >= 3 {
                sines[k] = -sines[k];
            }
        }
        let miss = |values: &[[f64; 6]]| {
            let parts = same.iter().zip(values).map(|(before, after)| {
                let expected = through(first(nodes), first(*before), nodes[3]);
                (after[3] - expected).abs()
            });
            parts.fold(0.0, f64::max)
        };
        let (kept, left) = (miss(&same), miss(&other));
        if !(CLEAR * kept < left || CLEAR * left < kept) {
            return Meeting::None;
        }
        let modes = (mode, if kept < left { mode } else { -mode });
        if left < kept {
            for (values, after) in same.iter_mut().zip(&other) {
                values[3..].copy_from_slice(&after[3..]);
            }
        }
        Meeting::Point(Crossing {
            group,
            at: through(sines, nodes, 0.0),
            modes,
            near: FINEST / rate,
            nodes,
            values: same,
        })
    }

    /// Takes the unknowns of a group at a change point from its neighbourhood. Gives the sine.
    pub(super) fn interpolate(
        &mut self,
        crossing: &Crossing,
        t: f64,
        instant: &Instant<L, S>,
    ) -> f64 {
        let unknowns = L::GROUPS[crossing.group].unknowns;
        for (values, &j) in crossing.values.iter().zip(unknowns) {
            self.trial.as_mut()[j] = S::from_f64(through(crossing.nodes, *values, t));
        }
        let group = crossing.group;
        self.newton
            .sine(&self.closure, group, instant, &mut self.trial)
    }

    /// Closes a group that is iterated from its interpolated unknowns. Gives the sine, NaN if that fails.
    pub(super) fn close_between(
        &mut self,
        crossing: &Crossing,
        t: f64,
        instant: &Instant<L, S>,
    ) -> f64 {
        self.interpolate(crossing, t, instant);
        let group = crossing.group;
        let closed = self
            .newton
            .close(&self.closure, group, instant, &mut self.trial);
        closed.map_or(f64::NAN, |closed| closed.sine)
    }

    /// Reports the change points that are passed, and remembers those that are stood on.
    pub(super) fn pass_crossings(&mut self, way: &mut Way, t: f64) {
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

    fn report(&mut self, crossing: &Crossing, way: &Way) {
        let iterated = L::GROUPS[crossing.group].kind == GroupKind::General;
        let before = if iterated {
            crossing.modes.0
        } else {
            self.mode(crossing.group)
        };
        if before != crossing.modes.1 {
            self.events.push(Event::ChangePoint {
                group: crossing.group,
                at: way.at(crossing.at),
                mode: crossing.modes.1,
            });
        }
    }
}

/// The first three of six values.
fn first(values: [f64; 6]) -> [f64; 3] {
    [values[0], values[1], values[2]]
}
