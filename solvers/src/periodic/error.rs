//! Why no repeating motion was found.

use crate::floquet::Multiplier;
use crate::hybrid::CycleError;
use crate::ode::OdeError;
use std::fmt;

/// Why no repeating motion was found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PeriodicError {
    /// A free motion repeats after (nearly) this period and is driven: the motion grows without bound, or its size
    /// depends on less than the integration can tell.
    Resonance {
        /// The Floquet multiplier nearest to 1.
        multiplier: Multiplier,
        /// Its distance from 1.
        distance: f64,
        /// Amplification of relative errors into the motion, see [`super::Orbit::condition`].
        condition: f64,
        /// Relative error of the motion that is to be expected.
        expected_error: f64,
        /// Index of the state with the largest part in the free motion.
        state: usize,
    },
    /// The tolerance is too loose for a useful result, though no resonance is near.
    Inaccurate {
        /// Amplification of relative errors into the motion, see [`super::Orbit::condition`].
        condition: f64,
        /// Relative error of the motion that is to be expected.
        expected_error: f64,
    },
    /// Shooting did not find a repeating motion.
    NotConverged {
        /// Integrations of the variational equations.
        iterations: usize,
        /// Largest change of a state after one period that remained, over its scale.
        residual: f64,
    },
    /// The motion from the start values does not settle into one that repeats, and shooting from there finds none.
    NotSettled(Box<CycleError>),
    /// The integration ended early.
    Ode(OdeError),
    /// The period is not a finite number above zero.
    BadPeriod {
        /// The period, in seconds.
        period: f64,
    },
}

impl fmt::Display for PeriodicError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Resonance { multiplier, distance, condition, expected_error, state } => write!(
                formatter,
                "resonance: the multiplier {multiplier} lies {distance:.2e} from 1, and errors would be amplified \
                 {condition:.2e} times, to {expected_error:.0e} of the motion, mostly in state {state}; change the \
                 speed, add damping, or try a smaller rtol if the motion is known to exist"
            ),
            Self::Inaccurate { condition, expected_error } => write!(
                formatter,
                "the tolerance is too loose: the motion would be known to a relative error of {expected_error:.1e} only \
                 (condition number {condition:.1e}); choose a smaller one"
            ),
            Self::NotConverged { iterations, residual } => write!(
                formatter,
                "no repeating motion was found in {iterations} integrations, a change of {residual:.2e} scales per \
                 period remained; try other start values, or approach the wanted speed in steps"
            ),
            Self::NotSettled(error) => error.fmt(formatter),
            Self::Ode(error) => error.fmt(formatter),
            Self::BadPeriod { period } => {
                write!(formatter, "a period of {period} s is not a finite time above 0")
            }
        }
    }
}

impl std::error::Error for PeriodicError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::NotSettled(error) => Some(error),
            Self::Ode(error) => Some(error),
            _ => None,
        }
    }
}

impl From<OdeError> for PeriodicError {
    fn from(error: OdeError) -> Self {
        Self::Ode(error)
    }
}
