//! Why there is no answer.

use crate::closure::ClosureError;
use crate::hybrid::{CycleError, HybridError};
use crate::periodic::PeriodicError;
use crate::problem::Refused;
use crate::rest::RestError;
use crate::tolerance::ToleranceError;
use std::fmt;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The mechanism does not accept the values.
    Refused(Refused),
    /// The scene states no task, and none was given.
    NoTask,
    /// The motion could not be followed to its end. What was followed is in it.
    Stopped(HybridError),
    /// No motion that repeats was found.
    NoCycle(Box<CycleError>),
    /// No steady state was found.
    NotSteady(PeriodicError),
    /// No position of rest was found.
    NotAtRest(RestError),
    /// The scene has nothing of this name.
    Unknown {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
    /// A linkage does not assemble.
    Open(ClosureError),
    /// A question about tolerances makes no sense.
    Tolerance(ToleranceError),
    /// The run does not have this measure.
    Missing {
        /// Its name.
        name: &'static str,
        /// Why.
        reason: String,
    },
}

impl Error {
    /// Whether the motion comes to a place where nothing says how it goes on, such as a dead point.
    pub fn is_lost(&self) -> bool {
        let cycle = |error: &CycleError| match error {
            CycleError::Motion(error) => matches!(**error, HybridError::Lost { .. }),
            _ => false,
        };
        match self {
            Self::Stopped(error) => matches!(error, HybridError::Lost { .. }),
            Self::NoCycle(error) => cycle(error),
            Self::NotSteady(PeriodicError::NotSettled(error)) => cycle(error),
            Self::NotAtRest(error) => error.is_lost(),
            _ => false,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(refused) => write!(formatter, "{refused}"),
            Self::NoTask => formatter.write_str(
                "the scene has no task: say how long it moves, with `until`, or after what time it repeats",
            ),
            Self::Stopped(error) => write!(formatter, "{error}"),
            Self::NoCycle(error) => write!(formatter, "{error}"),
            Self::NotSteady(error) => write!(formatter, "{error}"),
            Self::NotAtRest(error) => write!(formatter, "{error}"),
            Self::Unknown { name, known } => {
                write!(formatter, "there is no `{name}`; there are {}", known.join(", "))
            }
            Self::Open(error) => write!(formatter, "{error}"),
            Self::Tolerance(error) => write!(formatter, "{error}"),
            Self::Missing { name, reason } => write!(formatter, "{name}: {reason}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<Refused> for Error {
    fn from(refused: Refused) -> Self {
        Self::Refused(refused)
    }
}

impl From<HybridError> for Error {
    fn from(error: HybridError) -> Self {
        Self::Stopped(error)
    }
}

impl From<CycleError> for Error {
    fn from(error: CycleError) -> Self {
        match error {
            CycleError::Motion(inner) => Self::Stopped(*inner),
            other => Self::NoCycle(Box::new(other)),
        }
    }
}

impl From<RestError> for Error {
    fn from(error: RestError) -> Self {
        Self::NotAtRest(error)
    }
}

impl From<PeriodicError> for Error {
    fn from(error: PeriodicError) -> Self {
        match error {
            PeriodicError::NotSettled(inner) => Self::from(*inner),
            other => Self::NotSteady(other),
        }
    }
}

/// The error for a name that there is not.
pub(super) fn unknown(name: &str, known: impl Iterator<Item = &'static str>) -> Error {
    Error::Unknown { name: name.to_owned(), known: known.collect() }
}
