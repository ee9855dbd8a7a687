//! Why a design has no measures.

use std::fmt;

use assur_solvers::answer;
use assur_solvers::closure::ClosureError;
use assur_solvers::problem::Refused;

/// Why a design has no measures.
#[derive(Debug)]
#[non_exhaustive]
pub enum Unmeasured {
    /// The mechanism does not accept its values.
    Refused(Refused),
    /// It does not get through its way.
    Stuck(ClosureError),
    /// It has no motion.
    Still(answer::Error),
    /// The scene has no task.
    NoTask,
}

impl fmt::Display for Unmeasured {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(why) => why.fmt(formatter),
            Self::Stuck(why) => why.fmt(formatter),
            Self::Still(why) => why.fmt(formatter),
            Self::NoTask => answer::Error::NoTask.fmt(formatter),
        }
    }
}

impl std::error::Error for Unmeasured {}
