//! Change points: two modes of a group meet, and both go on.
//!
//! There the sine of the transmission angle passes through zero along either smooth branch, so that its modulus, found
//! with a fixed mode, comes back. All is computed from positions at some distance on both sides, where the sines are
//! large enough to be known well: at the change point itself half of the digits are lost.

use super::assembly::{Assembly, Event};
use super::continuation::{Way, scalars};
use super::error::ClosureError;
use super::newton::Instant;
use super::problem::Linkage;
use super::root::through;
use crate::scalar::Scalar;

/// Sine at which it is decided whether modes meet, miss each other or leave a gap.
const FINEST: f64 = 1e-6;
/// Sine at the nearest of the positions from which the change point is computed.
const SINE: f64 = 2e-3;
/// Part of a way on which the rate of a sine is measured that begins at zero.
const TINY: f64 = 1e-3;
/// A branch is the smooth one if it is nearer to the expectation by this factor.
const CLEAR: f64 = 4.0;

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
    /// Slopes of the unknowns along the way.
    fn slopes(&self) -> Vec<f64> {
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
        let sine = self.sine(group);
        let step = self.ratio(&scalars::<S>(&way.at(1.0))).to_f64() / (1.0 - done);
        let slope = self.groups.changes.as_ref()[group].to_f64() * step;
        let at = guess.unwrap_or(done - sine / slope);
        if !(at > done && at < done + 4.0) {
            return Meeting::None;
        }
        let mode = self.mode(group);
        match self.close_in(way, group, mode, (done, at)) {
            Ok((at, rate)) => self.choose(way, group, mode, at, rate),
            Err(meeting) => meeting,
        }
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
    fn choose(&mut self, way: &Way, group: usize, mode: f64, at: f64, rate: f64) -> Meeting {
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

    /// Reports the change points that are passed, and remembers those that are stood on.
    pub(super) fn pass_crossings(&mut self, way: &mut Way, t: f64) {
        self.stands.clear();
        for crossing in std::mem::take(&mut way.crossings) {
            if crossing.is_at(t) {
                let heading = way.heading();
                let slopes = crossing.slopes();
                self.stands.push(Stand {
                    group: crossing.group,
                    heading,
                    slopes,
                });
            } else if t > crossing.at {
                self.report(&crossing, way);
            } else {
                way.crossings.push(crossing);
            }
        }
    }

    fn report(&mut self, crossing: &Crossing, way: &Way) {
        if self.mode(crossing.group) != crossing.modes.1 {
            self.events.push(Event::ChangePoint {
                group: crossing.group,
                at: way.at(crossing.at),
                mode: crossing.modes.1,
            });
        }
    }

    /// Prepares to leave the change points that are stood on along the smooth branches.
    pub(super) fn leave_stands(&mut self, way: &mut Way) -> Result<(), ClosureError> {
        for stand in std::mem::take(&mut self.stands) {
            let meeting = self.leave(way, &stand);
            self.stands.push(stand);
            match meeting {
                Meeting::Point(crossing) => way.crossings.push(crossing),
                _ => return Err(self.lost_at(way, self.stands[0].group)),
            }
        }
        Ok(())
    }

    fn leave(&mut self, way: &Way, stand: &Stand) -> Meeting {
        let group = stand.group;
        let rate = self.probe(way, TINY, group, 1.0).abs() / TINY;
        let before = -SINE / rate;
        let mut misses = [0.0; 2];
        for (miss, mode) in misses.iter_mut().zip([1.0, -1.0]) {
            self.probe(way, before, group, mode);
            *miss = stand.miss(way, before, L::GROUPS[group].unknowns, |j| {
                (self.trial.as_ref()[j] - self.position.as_ref()[j]).to_f64()
            });
        }
        let mode = if misses[0] < misses[1] { 1.0 } else { -1.0 };
        let clear = CLEAR * f64::min(misses[0], misses[1]) < f64::max(misses[0], misses[1]);
        if clear {
            self.choose(way, group, mode, 0.0, rate)
        } else {
            Meeting::None
        }
    }
}

/// A group that stands exactly at a change point.
pub(super) struct Stand {
    group: usize,
    /// The way that led there.
    heading: Vec<f64>,
    /// Slopes of the unknowns along it.
    slopes: Vec<f64>,
}

impl Stand {
    /// By how much the changes of the unknowns on the way to `t` differ from what the slopes let expect.
    fn miss(&self, way: &Way, t: f64, unknowns: &[usize], change: impl Fn(usize) -> f64) -> f64 {
        let heading = way.heading();
        let along: f64 = heading.iter().zip(&self.heading).map(|(a, b)| a * b).sum();
        let square: f64 = self.heading.iter().map(|part| part * part).sum();
        let parts = unknowns.iter().zip(&self.slopes);
        let misses = parts.map(|(&j, slope)| (change(j) - slope * t * along / square).abs());
        misses.fold(0.0, f64::max)
    }
}

/// The first three of six values.
fn first(values: [f64; 6]) -> [f64; 3] {
    [values[0], values[1], values[2]]
}
