//! The first zero of a guard within a step.

use super::problem::Direction;

/// Halvings of a step before a touch without a crossing is taken for what it is.
const DEEPEST: u32 = 40;
/// By how many times its deviation in the middle a guard is trusted to leave its cubic.
const TRUST: f64 = 4.0;

/// A guard at a part of the step, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub part: f64,
    pub value: f64,
    /// Derivative by the part.
    pub slope: f64,
}

/// Where a guard passes zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// The first part of the step at which it has passed.
    pub part: f64,
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
    /// The guard at a part of the step.
    pub sample: &'a mut dyn FnMut(f64) -> Sample,
}

impl Search<'_> {
    /// The first crossing in the direction that is looked for between two samples. Leaves the sign there, or at the end.
    pub fn run(&mut self, from: Sample, to: Sample) -> Option<Crossing> {
        self.between(from, to, 0)
    }

    /// Whether a cubic through two samples stays away from zero by more than it changes.
    pub fn is_far(&self, from: &Sample, to: &Sample) -> bool {
        let (low, high) = range(&hull(from, to));
        self.has_kept(from, to) && f64::max(low, -high) > high - low
    }

    /// Whether both samples have the sign so far.
    fn has_kept(&self, from: &Sample, to: &Sample) -> bool {
        let signs = [from, to].map(|sample| self.sign_of(sample.value));
        self.sign != 0.0 && signs == [self.sign; 2]
    }

    fn between(&mut self, from: Sample, to: Sample, depth: u32) -> Option<Crossing> {
        if self.is_far(&from, &to) {
            return None;
        }
        let width = to.part - from.part;
        let hull = hull(&from, &to);
        let (low, high) = range(&hull);
        let sign = self.sign_of(to.value);
        let unchanged = self.has_kept(&from, &to);
        let distance = f64::max(low, -high);
        let middle = (self.sample)(from.part + 0.5 * width);
        let cubic = (hull[0] + 3.0 * (hull[1] + hull[2]) + hull[3]) / 8.0;
        let deviation = TRUST * (middle.value - cubic).abs();
        if unchanged && distance > deviation {
            return None;
        }
        let size = high.max(-low).max(middle.value.abs());
        if size <= self.noise
            || depth >= DEEPEST
            || middle.part <= from.part
            || middle.part >= to.part
        {
            return self.take(from, to);
        }
        let monotone = hull.windows(2).all(|pair| pair[1] > pair[0])
            || hull.windows(2).all(|pair| pair[1] < pair[0]);
        if monotone
            && deviation < high - low
            && self.sign != 0.0
            && sign != 0.0
            && sign != self.sign
        {
            return self.take(from, to);
        }
        let first = self.between(from, middle, depth + 1);
        match first {
            Some(_) => first,
            None => self.between(middle, to, depth + 1),
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
        let part = match leaves {
            true => from.part,
            false => self.narrow(from, to, before),
        };
        Some(Crossing { part, rising })
    }

    /// The smallest part that has the new sign, or none: the two ends of the last bracket are neighbours.
    fn narrow(&mut self, from: Sample, to: Sample, before: f64) -> f64 {
        let (mut low, mut high) = (from, to);
        // Zero on the way belongs to what was before.
        let has_passed = |sample: &Sample| sample.value * before < 0.0;
        let mut halve = false;
        loop {
            let width = high.part - low.part;
            let middle = low.part + 0.5 * width;
            if middle <= low.part || middle >= high.part {
                return high.part;
            }
            // Regula falsi, pushed a little across the zero so that both ends move in; halving where it does not help.
            let chord = low.part - low.value * width / (high.value - low.value);
            let push = (1e-3 * width).max(f64::EPSILON * high.part);
            let guess = match (chord - low.part) < 0.5 * width {
                true => chord + push,
                false => chord - push,
            };
            let inside = guess > low.part && guess < high.part;
            let part = if halve || !inside { middle } else { guess };
            let sample = (self.sample)(part);
            match has_passed(&sample) {
                true => high = sample,
                false => low = sample,
            }
            halve = high.part - low.part > 0.5 * width;
        }
    }

    fn sign_of(&self, value: f64) -> f64 {
        match value.abs() <= self.noise {
            true => 0.0,
            false => value.signum(),
        }
    }
}

/// The coefficients of the cubic through two samples, between which it lies.
fn hull(from: &Sample, to: &Sample) -> [f64; 4] {
    let width = to.part - from.part;
    [
        from.value,
        from.value + width * from.slope / 3.0,
        to.value - width * to.slope / 3.0,
        to.value,
    ]
}

/// The smallest and the largest of some values.
fn range(values: &[f64; 4]) -> (f64, f64) {
    let values = values.iter().copied();
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
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
            sample: &mut sample,
        };
        search.run(from, to)
    }

    #[test]
    fn a_crossing_is_enclosed_by_neighbours() {
        let root = crossing(Direction::Rises, -1.0, true, |x| x.exp() - 2.0, f64::exp).unwrap();
        assert!(
            root.rising && (root.part - 2.0f64.ln()).abs() < 4e-16,
            "{root:?}"
        );
        assert!(root.part.exp() > 2.0 && root.part.next_down().exp() <= 2.0);
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
            (fall.part - 0.299_912).abs() < 1e-6 && !fall.rising,
            "{fall:?}"
        );
        let rise = crossing(Direction::Rises, 1.0, true, value, slope).unwrap();
        assert!(
            (rise.part - 0.300_088).abs() < 1e-6 && rise.rising,
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

    /// `x⁴` leaves zero with neither rate nor curvature.
    #[test]
    fn a_guard_that_leaves_zero_passes_it_at_the_start() {
        let (value, slope) = (|x: f64| x.powi(4), |x: f64| 4.0 * x.powi(3));
        let found = crossing(Direction::Rises, 0.0, true, value, slope).unwrap();
        assert!(found.part < 2e-4, "{found:?}");
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
