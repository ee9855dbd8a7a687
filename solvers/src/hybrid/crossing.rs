//! The first zero of a guard within a step.

use super::cubic::{Sample, cubic, hull, is_far, is_resolved, range};
use super::narrow::Instants;
use super::problem::Direction;

/// Halvings of a step before a touch without a crossing is taken for what it is.
const DEEPEST: u32 = 40;
/// By how many times its deviation in the middle a guard is trusted to leave its cubic.
const TRUST: f64 = 4.0;
/// Deviation from a cubic, over what the cubic spans, up to which it is good.
const GOOD: f64 = 0.2;
/// Halvings after which a guard that is nothing but rounding is taken for zero.
const FEW: u32 = 3;
/// What the largest slope counts in each half of a part of the step in which the guard is a cubic.
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
    pub at: Sample,
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
    pub sample: &'a mut dyn FnMut(f64) -> Sample,
    /// Whether what else an event asks for holds at a part of the step. A crossing at which it does not is passed over.
    pub permits: &'a dyn Fn(f64) -> bool,
}

impl Search<'_> {
    /// The first crossing in the direction that is looked for between two samples. Leaves the sign there, or at the end.
    pub fn run(&mut self, from: Sample, to: Sample) -> Option<Crossing> {
        self.between(from, to, 1.0, 0)
    }

    /// The same where nothing is known yet of the guard between samples so far from each other: it is looked at here and
    /// there first. Also gives whether it is the cubic that the samples say.
    pub fn run_warily(&mut self, from: Sample, to: Sample) -> (Option<Crossing>, bool) {
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
        to: Sample,
        still: f64,
    ) -> Option<Crossing> {
        let sign = if crossing.rising { 1.0 } else { -1.0 };
        let mut part = crossing.at.part.max(self.instants.apart(0.0));
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
    pub fn jump(&mut self, from: Sample, to: Sample) -> Option<Crossing> {
        match self.sign_of(to.value) == self.sign {
            true => None,
            false => self.take(from, to),
        }
    }

    /// Whether both samples have the sign so far.
    fn has_kept(&self, from: &Sample, to: &Sample) -> bool {
        let signs = [from, to].map(|sample| self.sign_of(sample.value));
        self.sign != 0.0 && signs == [self.sign; 2]
    }

    fn between(&mut self, from: Sample, to: Sample, trust: f64, depth: u32) -> Option<Crossing> {
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
        let trust = if agrees { FADE * trust } else { trust };
        let first = self.between(from, middle, trust, depth + 1);
        match first {
            Some(_) => first,
            None => self.between(middle, to, trust, depth + 1),
        }
    }

    /// Whether a guard that deviates so much from a cubic does not pass zero. Beside one that stays away from zero that is
    /// one that begins or ends near it: the cubic less what it has there is `p` times a parabola, which stays away.
    fn stays(&self, from: &Sample, to: &Sample, hull: &[f64; 4], deviation: f64) -> bool {
        let kept = |sample: &Sample| self.sign_of(sample.value) == self.sign;
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
    fn take(&mut self, from: Sample, to: Sample) -> Option<Crossing> {
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
mod tests {
    use super::*;

    /// Where a function first passes zero on the way from 0 to 1.
    fn crossing(
        direction: Direction,
        sign: f64,
        armed: bool,
        value: impl Fn(f64) -> f64,
        slope: impl Fn(f64) -> f64,
    ) -> Option<Crossing> {
        let mut sample = |part: f64| Sample {
            part,
            value: value(part),
            slope: slope(part),
        };
        let (from, to) = (sample(0.0), sample(1.0));
        let mut search = Search {
            direction,
            noise: 1e-15,
            sign,
            armed,
            slope: 0.0,
            instants: Instants::new(0.0, 1.0),
            sample: &mut sample,
            permits: &|_| true,
        };
        search.run(from, to)
    }

    #[test]
    fn a_crossing_is_enclosed_to_the_last_bits() {
        let root = crossing(Direction::Rises, -1.0, true, |x| x.exp() - 2.0, f64::exp).unwrap();
        let (before, after) = (root.before, root.at.part);
        assert!(
            root.rising && (after - 2.0f64.ln()).abs() < 4e-16,
            "{root:?}"
        );
        assert!(after.exp() > 2.0 && before.exp() < 2.0);
        assert!(after - before <= 8.0 * f64::EPSILON, "{root:?}");
        assert_eq!(
            crossing(Direction::Falls, -1.0, true, |x| x.exp() - 2.0, f64::exp),
            None
        );
    }

    /// Two crossings 2e-4 apart, of which the signs at the ends say nothing.
    #[test]
    fn a_pair_of_crossings_within_a_step_is_found() {
        let value = |x: f64| (x - 0.3).powi(2) * (1.0 + x) - 1e-8;
        let slope = |x: f64| 2.0 * (x - 0.3) * (1.0 + x) + (x - 0.3).powi(2);
        assert!(value(0.0) > 0.0 && value(1.0) > 0.0);
        let fall = crossing(Direction::Falls, 1.0, true, value, slope).unwrap();
        assert!(
            (fall.at.part - 0.299_912).abs() < 1e-6 && !fall.rising,
            "{fall:?}"
        );
        let rise = crossing(Direction::Rises, 1.0, true, value, slope).unwrap();
        assert!(
            (rise.at.part - 0.300_088).abs() < 1e-6 && rise.rising,
            "{rise:?}"
        );
    }

    #[test]
    fn a_touch_is_no_crossing() {
        let value = |x: f64| (x - 0.3).powi(2);
        assert_eq!(
            crossing(Direction::Crosses, 1.0, true, value, |x| 2.0 * (x - 0.3)),
            None
        );
    }

    /// The continuous solution begins downwards and the motion upwards, `2 x`: it is never below zero.
    #[test]
    fn an_error_of_the_continuous_solution_is_no_crossing() {
        let (value, slope) = (|x: f64| x * x - 1e-3 * x, |x: f64| 2.0 * x);
        let found = crossing(Direction::Falls, 0.0, true, value, slope).unwrap();
        assert!(!found.rising, "{found:?}");
        let kept = |value: fn(f64) -> f64, slope: fn(f64) -> f64| {
            let mut sample = |part: f64| Sample {
                part,
                value: value(part),
                slope: slope(part),
            };
            let to = sample(1.0);
            let mut search = Search {
                direction: Direction::Falls,
                noise: 1e-15,
                sign: -1.0,
                armed: true,
                slope: 0.0,
                instants: Instants::new(0.0, 1.0),
                sample: &mut sample,
                permits: &|_| true,
            };
            (search.unless_taken_back(found, to, 0.0), search.sign)
        };
        assert_eq!(kept(value, slope), (None, 1.0));
        // A motion that goes down says so, and one that does not come back is believed to.
        let down = kept(value, |x| 2.0 * x - 1e-3);
        assert_eq!(down, (Some(found), -1.0));
        let stays = kept(|x| -1e-3 * x, slope);
        assert_eq!(stays, (Some(found), -1.0));
    }

    /// `x⁴` leaves zero with neither rate nor curvature.
    #[test]
    fn a_guard_that_leaves_zero_passes_it_at_the_start() {
        let (value, slope) = (|x: f64| x.powi(4), |x: f64| 4.0 * x.powi(3));
        let found = crossing(Direction::Rises, 0.0, true, value, slope).unwrap();
        assert!(found.at.part < 2e-4, "{found:?}");
        assert_eq!(crossing(Direction::Falls, 0.0, true, value, slope), None);
        assert_eq!(crossing(Direction::Rises, 0.0, false, value, slope), None);
    }

    #[test]
    fn a_guard_that_stays_zero_passes_nothing() {
        assert_eq!(
            crossing(Direction::Crosses, 0.0, true, |_| 0.0, |_| 0.0),
            None
        );
    }
}
