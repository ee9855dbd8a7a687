//! The first zero of a guard within a step.

use super::cubic::{Reading, cubic, hull, is_far, is_resolved, range};
use super::narrow::Instants;
use crate::shape::Direction;

/// Halvings of a step before a touch without a crossing is taken for what it is.
const DEEPEST: u32 = 40;
/// By how many times its deviation in the middle a guard is trusted to leave its cubic.
const TRUST: f64 = 4.0;
/// Deviation from a cubic, over what the cubic spans, up to which it is good.
const GOOD: f64 = 0.2;
/// Halvings after which a guard that is nothing but rounding is taken for zero.
const FEW: u32 = 3;
/// What the largest slope counts in each half of a part of the step in which the guard is a cubic. In each half of that, and
/// so on, it is this times the square: beside a pole the slope is larger by any factor than elsewhere.
const FADE: f64 = 0.5;
/// Where a guard is looked at whose slopes may be larger than those at the ends of a step: multiples of the golden section,
/// which keep out of step with whatever swings.
const PROBES: [f64; 8] = [0.09, 0.236, 0.326, 0.472, 0.618, 0.708, 0.854, 0.944];
/// The largest value of `16 p (1 - p)²`: a deviation `d` in the middle is `16 d p² (1 - p)²` elsewhere, since value and
/// slope agree at both ends, and that is at most this many `d p`.
const LEAN: f64 = 64.0 / 27.0;

/// Where a guard passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// The guard at the first part of the step at which it has passed.
    pub at: Reading,
    /// The last part before, as far as parts can be told apart.
    pub before: f64,
    /// Whether it rises.
    pub rising: bool,
}

/// A guard on its way through a step.
pub(super) struct Search<'a> {
    /// In which direction zero is passed.
    pub direction: Direction,
    /// Values up to this are zero.
    pub noise: f64,
    /// Sign so far; 0 while the guard has been zero since the mode began.
    pub sign: f64,
    /// Whether a guard that has been zero since the mode began passes zero by leaving it.
    pub armed: bool,
    /// The largest slope that is known of it near by.
    pub slope: f64,
    /// The times that can be told apart.
    pub instants: Instants,
    /// The guard at a part of the step.
    pub sample: &'a mut dyn FnMut(f64) -> Reading,
    /// Whether what else an event asks for holds at a part of the step. A crossing at which it does not is passed over.
    pub permits: &'a dyn Fn(f64) -> bool,
}

impl Search<'_> {
    /// The first crossing in the direction that is looked for between two samples. Leaves the sign there, or at the end.
    pub fn run(&mut self, from: Reading, to: Reading) -> Option<Crossing> {
        self.between(from, to, 1.0, 0)
    }

    /// Looks for a zero where nothing is known yet of the guard between samples so far from each other: it is looked at
    /// here and
    /// there first. Also gives whether it is the cubic that the samples say.
    pub fn run_warily(&mut self, from: Reading, to: Reading) -> (Option<Crossing>, bool) {
        let width = to.part - from.part;
        let hull = hull(&from, &to);
        let (low, high) = range(&hull);
        let mut fits = true;
        let probes = PROBES.map(|part| {
            let probe = (self.sample)(from.part + part * width);
            let off = (probe.value - cubic(&hull, part)).abs();
            fits &= off <= GOOD * (high - low) + self.noise;
            self.slope = self.slope.max(probe.slope.abs());
            probe
        });
        let mut begin = from;
        for end in probes.into_iter().chain([to]) {
            let found = self.between(begin, end, 1.0, 1);
            if found.is_some() {
                return (found, fits);
            }
            begin = end;
        }
        (None, fits)
    }

    /// A crossing of a guard that is zero where the mode begins, or the next one if the guard gets its sign by no more than
    /// the error of the continuous solution: as long as it has that sign it says by its slope, which the equations know,
    /// that it goes the other way, and it gets there. The continuous solutions of stiff methods do not begin with the
    /// rates of the motion. Slopes up to `still` are rounding.
    #[cold]
    pub fn unless_taken_back(
        &mut self,
        crossing: Crossing,
        to: Reading,
        still: f64,
    ) -> Option<Crossing> {
        let sign = if crossing.rising { 1.0 } else { -1.0 };
        // Next to time 0 parts are told apart that are no numbers any more.
        let mut part = crossing.at.part.max(f64::EPSILON);
        while part < to.part {
            let sample = (self.sample)(part);
            let now = self.sign_of(sample.value);
            if now == -sign {
                self.sign = now;
                return self.run(sample, to);
            }
            if sample.slope * sign > still {
                break;
            }
            part *= 2.0;
        }
        Some(crossing)
    }

    /// Where it passes zero in a jump from one sample to another.
    pub fn jump(&mut self, from: Reading, to: Reading) -> Option<Crossing> {
        match self.sign_of(to.value) == self.sign {
            true => None,
            false => self.take(from, to),
        }
    }

    /// Whether both samples have the sign so far.
    fn has_kept(&self, from: &Reading, to: &Reading) -> bool {
        let signs = [from, to].map(|sample| self.sign_of(sample.value));
        self.sign != 0.0 && signs == [self.sign; 2]
    }

    fn between(&mut self, from: Reading, to: Reading, trust: f64, depth: u32) -> Option<Crossing> {
        let resolved = is_resolved(&from, &to, trust * self.slope);
        if resolved && self.has_kept(&from, &to) && is_far(&from, &to) {
            return None;
        }
        let width = to.part - from.part;
        let hull = hull(&from, &to);
        let (low, high) = range(&hull);
        let middle = (self.sample)(from.part + 0.5 * width);
        self.slope = self.slope.max(middle.slope.abs());
        let deviation = TRUST * (middle.value - cubic(&hull, 0.5)).abs();
        let agrees = deviation <= GOOD * (high - low);
        if depth == 0 && !agrees {
            return self.run_warily(from, to).0;
        }
        let resolved = is_resolved(&from, &to, trust * self.slope);
        if resolved && self.stays(&from, &to, &hull, deviation) {
            return None;
        }
        let size = high.max(-low).max(middle.value.abs());
        if (resolved || depth >= FEW) && size <= self.noise
            || depth >= DEEPEST
            || middle.part <= from.part
            || middle.part >= to.part
            || !deviation.is_finite()
        {
            return self.take(from, to);
        }
        let monotone = hull.windows(2).all(|pair| pair[1] > pair[0])
            || hull.windows(2).all(|pair| pair[1] < pair[0]);
        let signs = [middle, to].map(|sample| self.sign_of(sample.value));
        if resolved && monotone && agrees && self.sign != 0.0 && signs[1] == -self.sign {
            return match signs[0] == signs[1] {
                true => self.take(from, middle),
                false => self.take(middle, to),
            };
        }
        // Where the cubic is good the largest slope is that of elsewhere.
        let trust = if agrees { FADE * trust * trust } else { trust };
        let first = self.between(from, middle, trust, depth + 1);
        match first {
            Some(_) => first,
            None => self.between(middle, to, trust, depth + 1),
        }
    }

    /// Whether a guard that deviates so much from a cubic does not pass zero. Beside one that stays away from zero that is
    /// one that begins or ends near it: the cubic less what it has there is `p` times a parabola, which stays away.
    fn stays(&self, from: &Reading, to: &Reading, hull: &[f64; 4], deviation: f64) -> bool {
        let kept = |sample: &Reading| self.sign_of(sample.value) == self.sign;
        if self.sign == 0.0 || !kept(to) {
            return false;
        }
        let [a, b, c, d] = hull.map(|coefficient| coefficient * self.sign);
        let begins =
            |near: [f64; 3]| near.into_iter().fold(f64::INFINITY, f64::min) > LEAN * deviation;
        match kept(from) {
            true => {
                a.min(b).min(c).min(d) > deviation
                    || begins([3.0 * b, 1.5 * c, d])
                    || begins([a, 1.5 * b, 3.0 * c])
            }
            false => from.value.abs() <= self.noise && begins([3.0 * b, 1.5 * c, d]),
        }
    }

    /// What a stretch with at most one crossing comes to.
    fn take(&mut self, from: Reading, to: Reading) -> Option<Crossing> {
        let sign = self.sign_of(to.value);
        if sign == 0.0 || sign == self.sign {
            return None;
        }
        let leaves = self.sign == 0.0;
        let rising = sign > 0.0;
        let before = std::mem::replace(&mut self.sign, sign);
        if leaves && !self.armed {
            self.armed = true;
            return None;
        }
        if !self.direction.allows(rising) {
            return None;
        }
        let (before, at) = match leaves {
            true => (from.part, from),
            false => self.instants.narrow(self.sample, (from, to), before),
        };
        let crossing = Crossing { at, before, rising };
        (self.permits)(at.part).then_some(crossing)
    }

    fn sign_of(&self, value: f64) -> f64 {
        match value.abs() <= self.noise {
            true => 0.0,
            false => value.signum(),
        }
    }
}

#[cfg(test)]
mod tests;
