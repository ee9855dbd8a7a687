//! Looking ahead where the sine of a group goes to zero: whether two modes meet there, miss each other or leave a gap.

use super::continuation::{Segment, scalars};
use super::crossing::{Crossing, FINEST, SINE};
use crate::closure::extent::root::through;
use crate::closure::position::guide::Guide;
use crate::scalar::Scalar;

/// A branch is the smooth one if it is nearer to the expectation by this factor.
pub(super) const CLEAR: f64 = 4.0;

/// What lies ahead of a group whose sine goes to zero.
pub(super) enum Meeting {
    /// A change point.
    Point(Crossing),
    /// A gap, with a place inside it.
    Gap(f64),
    /// Nothing that could be told.
    None,
}

impl<S: Scalar> Guide<'_, S> {
    /// Looks ahead from `done`, where the sine of a group goes to zero, at about `guess` if that is known.
    pub(super) fn meet(
        &mut self,
        way: &Segment,
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
    pub(super) fn zero_ahead(&self, way: &Segment, done: f64, group: usize) -> Option<f64> {
        let steps = self.ratio(&scalars::<S>(&way.at(1.0))).to_f64() / (1.0 - done);
        let slope = self.groups.changes[group].to_f64() * steps;
        let at = done - self.sine(group) / slope;
        (at > done && at < done + 4.0).then_some(at)
    }

    /// Closes in on a zero of the sine, whose modulus comes back. Gives the place and the rate of the sine.
    fn close_in(
        &mut self,
        way: &Segment,
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
                return Err(if margin < -allowed { Meeting::Gap(right) } else { Meeting::None });
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
        way: &Segment,
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
        if touches { Ok((at, before / (at - left))) } else { Err(Meeting::None) }
    }

    /// Chooses the smooth continuation.
    pub(super) fn choose(
        &mut self,
        way: &Segment,
        group: usize,
        mode: f64,
        at: f64,
        rate: f64,
    ) -> Meeting {
        let unit = SINE / rate;
        let nodes = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|k| at + k * unit);
        let unknowns = self.entry.groups[group].unknowns;
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
                    value[k] = self.trial[j].to_f64();
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
}

/// The first three of six values.
fn first(values: [f64; 6]) -> [f64; 3] {
    [values[0], values[1], values[2]]
}
