//! Why there are no tolerances of least cost.

use crate::closure::ClosureError;
use crate::tolerance::ToleranceError;
use std::fmt;

/// Why there are no tolerances of least cost. Candidates are counted from zero.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AllocationError {
    /// The influence on the output is not known along the way.
    Tolerance(ToleranceError),
    /// A band that is not positive and finite.
    BadBand {
        /// What was found.
        band: f64,
    },
    /// Limits of a tolerance that leave nothing, or are negative.
    BadLimits {
        /// The candidate concerned.
        candidate: usize,
        /// Lower limit.
        least: f64,
        /// Upper limit.
        most: f64,
    },
    /// A cost that does not fall with the tolerance.
    BadCost {
        /// The candidate concerned.
        candidate: usize,
        /// Factor of its cost.
        factor: f64,
        /// Exponent of its tolerance.
        exponent: f64,
    },
    /// Nothing bounds a tolerance: it has neither influence on the output nor an upper limit.
    Unbounded {
        /// The candidate concerned.
        candidate: usize,
    },
    /// With all tolerances at their lower limits the output still leaves the band.
    OutOfReach {
        /// The place where it errs most.
        at: Vec<f64>,
        /// What it errs there.
        reached: f64,
        /// What was asked for.
        band: f64,
        /// The candidate that contributes most there.
        candidate: usize,
        /// Its part of the error (of the variance, for standard deviations).
        share: f64,
    },
    /// The conic programme was not solved.
    NotSolved {
        /// The place where the output errs most per tolerance.
        at: Vec<f64>,
        /// How the solver describes that.
        status: String,
        /// Iterations spent.
        iterations: u32,
    },
    /// Places where the band is left kept turning up.
    NotSettled {
        /// Programmes that were solved.
        rounds: usize,
        /// How much the output still errs, as a multiple of the band.
        excess: f64,
    },
}

impl fmt::Display for AllocationError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Tolerance(error) => error.fmt(formatter),
            Self::BadBand { band } => {
                write!(formatter, "a band of {band} cannot be kept; it must be positive and finite")
            }
            Self::BadLimits { candidate, least, most } => write!(
                formatter,
                "tolerance {candidate} is to lie between {least} and {most}; expected 0 <= lower limit <= upper limit"
            ),
            Self::BadCost { candidate, factor, exponent } => write!(
                formatter,
                "the cost {factor}/t^{exponent} of tolerance {candidate} does not fall with t; expected both positive"
            ),
            Self::Unbounded { candidate } => write!(
                formatter,
                "tolerance {candidate} has no influence on the output and no upper limit; leave it out, or limit it"
            ),
            Self::OutOfReach { at, reached, band, candidate, share } => write!(
                formatter,
                "at {at:?} the output errs by {reached:e} with all tolerances at their lower limits, beyond the band of \
                 {band:e}; {:.0} % of it comes from tolerance {candidate}: lower its limit, or widen the band",
                100.0 * share
            ),
            Self::NotSolved { at, status, iterations } => write!(
                formatter,
                "the conic programme was not solved: {status} after {iterations} iterations; the output errs most at \
                 {at:?}: a dead point may be there, go less near to it"
            ),
            Self::NotSettled { rounds, excess } => write!(
                formatter,
                "after {rounds} rounds the output still errs by {excess} times the band between the places that were \
                 looked at; give more places"
            ),
        }
    }
}

impl std::error::Error for AllocationError {}

impl From<ToleranceError> for AllocationError {
    fn from(error: ToleranceError) -> Self {
        Self::Tolerance(error)
    }
}

impl From<ClosureError> for AllocationError {
    fn from(error: ClosureError) -> Self {
        Self::Tolerance(error.into())
    }
}
