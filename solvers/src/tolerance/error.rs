//! Why a question about tolerances has no answer.

use crate::closure::ClosureError;
use std::fmt;

/// Why a question about tolerances has no answer. Sources, variables, outputs and places are counted from zero.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ToleranceError {
    /// Nothing has a tolerance.
    NoSource,
    /// There is no place to look at.
    NoPlace,
    /// A half-width that is negative or not finite.
    BadHalfWidth {
        /// The source concerned.
        source: usize,
        /// What was found.
        half_width: f64,
    },
    /// A source of error in a variable that does not exist.
    NoVariable {
        /// The source concerned.
        source: usize,
        /// What was found.
        variable: usize,
        /// How many there are.
        variables: usize,
    },
    /// An output that does not exist.
    NoOutput {
        /// What was found.
        output: usize,
        /// How many there are.
        outputs: usize,
    },
    /// A number of samples out of range.
    BadSamples {
        /// What was found.
        samples: u64,
        /// The fewest that say anything.
        least: u64,
        /// The most that can be drawn.
        most: u64,
    },
    /// A level of confidence or of a quantile that does not lie between 0 and 1.
    BadLevel {
        /// What was found.
        level: f64,
    },
    /// Too many sources to try all their extremes.
    TooManyCorners {
        /// How many there are.
        sources: usize,
        /// How many can be tried.
        most: usize,
    },
    /// The nominal linkage does not get to a place.
    Closure(ClosureError),
    /// The output or its derivatives are no finite numbers at a place.
    NotFinite {
        /// The place concerned.
        place: usize,
        /// The independent variables there.
        at: Vec<f64>,
    },
}

impl fmt::Display for ToleranceError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSource => {
                formatter.write_str("nothing has a tolerance; state one, or play in a joint")
            }
            Self::NoPlace => {
                formatter.write_str("there is no place to look at; state at least one")
            }
            Self::BadHalfWidth { source, half_width } => write!(
                formatter,
                "source {source} has a half-width of {half_width}; it must be finite and not negative"
            ),
            Self::NoVariable { source, variable, variables } => write!(
                formatter,
                "source {source} is an error of variable {variable}, but there are {variables}"
            ),
            Self::NoOutput { output, outputs } => {
                write!(formatter, "there is no output {output}: there are {outputs}")
            }
            Self::BadSamples { samples, least, most } => write!(
                formatter,
                "{samples} samples cannot be drawn: choose from {least} to {most}"
            ),
            Self::BadLevel { level } => {
                write!(formatter, "a level of {level} does not lie between 0 and 1")
            }
            Self::TooManyCorners { sources, most } => write!(
                formatter,
                "the extremes of {sources} sources are 2^{sources} linkages; at most {most} sources can be combined"
            ),
            Self::Closure(error) => error.fmt(formatter),
            Self::NotFinite { place, at } => write!(
                formatter,
                "the output or its derivatives are no finite numbers at place {place}, {at:?}; a dead point may be there"
            ),
        }
    }
}

impl std::error::Error for ToleranceError {}

impl From<ClosureError> for ToleranceError {
    fn from(error: ClosureError) -> Self {
        Self::Closure(error)
    }
}
