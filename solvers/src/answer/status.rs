//! How far an answer is one.

use super::motion::Motion;
use crate::rest::Rest;
use std::fmt;

/// How far an answer is one. A motion that could not be followed is an [`Error`](super::Error) instead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Status {
    /// As asked for.
    Complete,
    /// The error of so many steps is that of rounding, and above the tolerance: a smaller one changes nothing.
    Rounded {
        /// The steps.
        steps: usize,
    },
    /// It repeats, and small disturbances grow: a machine does not move like that.
    Unstable {
        /// The largest modulus of a Floquet multiplier.
        modulus: f64,
    },
    /// It rests, and small disturbances grow: it will not stay there.
    Falls {
        /// How fast the fastest of them grows, 1/s.
        rate: f64,
    },
    /// It rests, and would rest as well a little aside: where, the start says.
    Indifferent {
        /// In how many directions.
        directions: usize,
    },
    /// It repeats, and any amount of free motions could be added: the smallest is given.
    Free {
        /// How many.
        motions: usize,
    },
}

/// Moduli up to this above 1 are no growth: motions without losses have theirs there.
const NEUTRAL: f64 = 1e-6;

impl Status {
    pub(super) fn of(motion: &Motion) -> Self {
        let largest = motion.multipliers().first();
        let modulus = largest.map_or(0.0, |multiplier| multiplier.modulus());
        let free = motion.repeats().map_or(0, |repeats| repeats.free);
        let rest = motion.rest();
        let growing = rest.and_then(Rest::growing).map(|one| one.rate);
        let directions = rest.map_or(0, |rest| rest.free);
        let steps = motion.statistics().rounded_steps;
        match () {
            () if modulus > 1.0 + NEUTRAL => Self::Unstable { modulus },
            () if let Some(rate) = growing => Self::Falls { rate },
            () if directions > 0 => Self::Indifferent { directions },
            () if free > 0 => Self::Free { motions: free },
            () if steps > 0 => Self::Rounded { steps },
            () => Self::Complete,
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Complete => formatter.write_str("complete"),
            Self::Rounded { steps } => write!(
                formatter,
                "complete; {steps} steps are as accurate as rounding lets them be, not as asked for"
            ),
            Self::Unstable { modulus } => write!(
                formatter,
                "it repeats, but a disturbance grows {modulus:.3} times in each cycle"
            ),
            Self::Falls { rate } => write!(
                formatter,
                "it rests, but not for long: a disturbance grows e-fold in {:.3e} s",
                1.0 / rate
            ),
            Self::Indifferent { directions } => write!(
                formatter,
                "it rests, and would as well a little aside, in {directions} directions that nothing holds"
            ),
            Self::Free { motions } => {
                write!(formatter, "it repeats, and so do {motions} free motions that may be added")
            }
        }
    }
}
