//! What is remembered of a guard from step to step.

use super::cubic::{Reading, is_far};
use crate::hybrid::NOISE;

/// A step that is longer by this than any in which a guard has been looked at is looked into.
const LONGER: f64 = 1.25;

/// What is remembered of a guard.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::hybrid) struct Guard {
    /// Sign so far, 0 while it has been zero since the mode began.
    pub sign: f64,
    /// Whether leaving zero counts as passing it.
    pub armed: bool,
    /// The largest of its values and terms.
    pub size: f64,
    /// The time at which the mode began, and the terms of the rate there if the rate was no more than their rounding: as
    /// long as the guard has been zero, that rounding times the time since then is zero too.
    pub still: (f64, f64),
    /// When the mode began, if the guard was zero there.
    pub began: Option<f64>,
    /// The largest rate in the last steps; older ones count less.
    pub rate: f64,
    /// The length of the longest step within which it has been looked at and was what the ends of the step say. Older ones
    /// count less.
    pub looked: f64,
}

impl Guard {
    /// Values up to this count as zero.
    pub fn noise(&self) -> f64 {
        NOISE * f64::EPSILON * self.size
    }

    /// Values up to this at a time count as zero.
    pub fn noise_at(&self, time: f64) -> f64 {
        match self.sign == 0.0 {
            true => self.noise() + self.still_rate() * (time - self.still.0),
            false => self.noise(),
        }
    }

    /// Rates up to this counted as zero where the mode began.
    pub fn still_rate(&self) -> f64 {
        NOISE * f64::EPSILON * self.still.1
    }

    /// Whether the guard stays away from zero between the ends of a step by more than it changes.
    pub fn is_far(&self, from: &Reading, to: &Reading) -> bool {
        let keeps = |sample: &Reading| sample.value * self.sign > self.noise();
        self.sign != 0.0 && keeps(from) && keeps(to) && is_far(from, to)
    }
}

/// How far a part of a step goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Portion {
    /// Length of the whole step, in seconds.
    pub length: f64,
    /// Where the part begins and ends.
    pub part: (f64, f64),
    /// Parts of the step by which two events differ that cannot be told apart.
    pub blur: f64,
    /// Whether the terms of the guards have been found out.
    pub is_measured: bool,
}

impl Portion {
    /// Whether so large a part of the step is more than is known of a guard.
    #[inline(always)]
    pub fn is_unknown(&self, guard: &Guard, part: f64) -> bool {
        self.length * part > LONGER * guard.looked
    }
}
