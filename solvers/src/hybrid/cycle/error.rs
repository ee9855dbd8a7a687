//! Why no stable motion that repeats was found.

use std::fmt;

use super::super::HybridError;
use super::Cycle;
use crate::ode::OdeError;

/// Why no stable motion that repeats was found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CycleError {
    /// The scene has no events, or its task is not a motion that repeats.
    NoTask,
    /// The period is not a finite number above zero.
    BadPeriod {
        /// The period, in seconds.
        period: f64,
    },
    /// A motion was to repeat by itself, and the equations depend on the time.
    Driven {
        /// The state whose rate does.
        component: usize,
    },
    /// A motion was to repeat by itself, and comes to rest.
    Rest {
        /// When, in seconds.
        time: f64,
    },
    /// A motion was to repeat by itself, and did not come back to where it has been.
    NoReturn {
        /// Seconds that it was followed.
        time: f64,
        /// How near it came to a state that it had been in, over the sizes of the states; none if it never passed near.
        nearest: Option<f64>,
    },
    /// The motion could not be followed.
    Motion(Box<HybridError>),
    /// The variational equations could not be integrated.
    Variation(OdeError),
    /// A guard is touched and not passed: the motion does not depend smoothly on where it begins.
    Grazing {
        /// When, in seconds.
        time: f64,
        /// The mode.
        mode: usize,
        /// The event of that mode.
        event: usize,
    },
    /// No motion that repeats attracts this one.
    NoneStable {
        /// Periods that it was followed.
        followed: usize,
        /// After how many periods it was last nearest to its past, and how near: the largest change of a state over
        /// its size. None if its modes differ.
        nearest: Option<(usize, f64)>,
        /// By what factor small disturbances grow in a period; above 1 the motion is irregular.
        growth: f64,
        /// A motion that repeats and is not stable, if one was found.
        unstable: Option<Box<Cycle>>,
    },
}

impl From<HybridError> for CycleError {
    fn from(error: HybridError) -> Self {
        Self::Motion(Box::new(error))
    }
}

impl fmt::Display for CycleError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoTask => write!(
                formatter,
                "a motion that repeats is sought where a scene with events says `periodic over`"
            ),
            Self::BadPeriod { period } => write!(
                formatter,
                "the period is {period} s; it has to be a finite number above zero"
            ),
            Self::Driven { component } => write!(
                formatter,
                "the rate of state {component} depends on the time, so that the motion cannot repeat by itself; state its \
                 period, `periodic over …`"
            ),
            Self::Rest { time } => write!(
                formatter,
                "the motion from the start values comes to rest within {time} s; give it other start values, or more to \
                 drive it"
            ),
            Self::NoReturn { time, nearest } => {
                write!(
                    formatter,
                    "the motion from the start values was followed for {time} s and does not repeat"
                )?;
                match nearest {
                    Some(distance) => write!(
                        formatter,
                        "; it came back to where it had been to {distance:.1e} of its size"
                    ),
                    None => write!(formatter, "; it never came back to where it had been"),
                }
            }
            Self::Motion(error) => error.fmt(formatter),
            Self::Variation(error) => write!(formatter, "the variations along the motion: {error}"),
            Self::Grazing { time, mode, event } => write!(
                formatter,
                "at time {time} s event {event} of mode {mode} is touched and not passed, so that the motion does not \
                 depend smoothly on where it begins; change a value a little"
            ),
            Self::NoneStable { followed, nearest, growth, unstable } => {
                write!(
                    formatter,
                    "no stable motion that repeats was found in {followed} periods; small disturbances change by the \
                     factor {growth:.4} a period"
                )?;
                if let Some((multiple, distance)) = nearest {
                    write!(
                        formatter,
                        "; it came nearest to its past after {multiple} periods, to {distance:.1e} of its size"
                    )?;
                }
                match unstable.as_deref() {
                    Some(cycle) => write!(
                        formatter,
                        "; a motion that repeats after {} periods is unstable, its largest multiplier is {}",
                        cycle.multiple,
                        cycle.multipliers.first().map_or(0.0, |one| one.modulus())
                    ),
                    None => Ok(()),
                }
            }
        }
    }
}

impl std::error::Error for CycleError {}
