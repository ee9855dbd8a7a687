//! Why a position could not be found.

use std::fmt;

/// Why a position could not be found. Groups are counted from zero; angles are in radians, lengths in metres.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ClosureError {
    /// The links cannot meet.
    NotAssembled {
        /// The group concerned.
        group: usize,
        /// The independent variables.
        at: Vec<f64>,
        /// The gap that is left, in the unit of the equations.
        gap: f64,
    },
    /// The iteration for a group neither closed it nor showed that it cannot be closed.
    NotConverged {
        /// The group concerned.
        group: usize,
        /// The independent variables.
        at: Vec<f64>,
        /// Largest residual that is left, in the unit of its equation.
        residual: f64,
        /// Iterations spent.
        iterations: usize,
        /// Determinant of the Jacobian over the product of the lengths of its columns.
        sine: f64,
    },
    /// The mode ends on the way: two assembly modes meet there.
    DeadPoint {
        /// The group concerned.
        group: usize,
        /// The independent variables at the dead point.
        at: Vec<f64>,
        /// The independent variables that were asked for.
        wanted: Vec<f64>,
        /// The gap that is left where it was asked for, in the unit of the equations; NaN if that is not known.
        gap: f64,
    },
    /// Two assembly modes cannot be told apart, or a group turns freely.
    Ambiguous {
        /// The group concerned.
        group: usize,
        /// The independent variables.
        at: Vec<f64>,
        /// How far the modes lie from each other, in radians or lengths of a link.
        apart: f64,
    },
    /// An equation is not a finite number.
    NotFinite {
        /// The group concerned.
        group: usize,
        /// The independent variables.
        at: Vec<f64>,
    },
    /// A range or a position that makes no sense.
    BadRange {
        /// What was found and what was expected.
        reason: String,
    },
    /// The mode could not be followed with certainty, however short the steps.
    ModeLost {
        /// The group concerned.
        group: usize,
        /// The independent variables where it was last certain.
        at: Vec<f64>,
        /// The independent variables that were asked for.
        wanted: Vec<f64>,
        /// Sine of the transmission angle where it was last certain.
        sine: f64,
    },
}

impl fmt::Display for ClosureError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAssembled { group, at, gap } => write!(
                formatter,
                "group {group} does not assemble at {at:?}: a gap of {gap:e} is left; check the dimensions, \
                 or try another position or start value"
            ),
            Self::NotConverged { group, at, residual, iterations, sine } => write!(
                formatter,
                "group {group} was not closed at {at:?}: {residual:e} is left after {iterations} iterations (sine of \
                 the transmission angle {sine:.1e}); give start values nearer to the position"
            ),
            Self::DeadPoint { group, at, wanted, gap } => {
                write!(
                    formatter,
                    "group {group} has a dead point at {at:?} on the way to {wanted:?}"
                )?;
                if gap.is_finite() {
                    write!(formatter, ", where a gap of {gap:e} is left")?;
                }
                formatter.write_str(
                    "; shorten the range, or pass through onto the other mode by arc length",
                )
            }
            Self::Ambiguous { group, at, apart } => write!(
                formatter,
                "the modes of group {group} cannot be told apart at {at:?}: they differ by {apart:e}, or a link turns \
                 freely there; start at another position, or give a start value nearer to the mode that is meant"
            ),
            Self::NotFinite { group, at } => write!(
                formatter,
                "an equation of group {group} is not a finite number at {at:?}; check the values, and whether a square \
                 root, a division or a logarithm leaves its range there"
            ),
            Self::BadRange { reason } => formatter.write_str(reason),
            Self::ModeLost { group, at, wanted, sine } => write!(
                formatter,
                "the mode of group {group} was lost at {at:?} on the way to {wanted:?} (sine of the transmission angle \
                 {sine:.1e}); two modes come very near to each other there: take another way, or state the position \
                 beyond as a start of its own"
            ),
        }
    }
}

impl std::error::Error for ClosureError {}
