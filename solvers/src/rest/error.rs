//! Why there is no position of rest.

use std::fmt;

/// Why there is no position of rest.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RestError {
    /// It cannot begin there.
    Start {
        /// Why not.
        reason: String,
    },
    /// It moves with the time.
    Driven {
        /// The speed or state that is pushed in another way later.
        name: &'static str,
        /// When, in seconds.
        time: f64,
    },
    /// Nothing balances what moves it.
    Unbalanced {
        /// The speed or state concerned.
        name: &'static str,
        /// How fast it changes wherever the mechanism is, SI units.
        rate: f64,
    },
    /// Newton's method comes to no position of rest.
    Unsettled {
        /// The speed or state that changes fastest at the last position.
        name: &'static str,
        /// How fast, SI units; not a number where the equations have no value.
        rate: f64,
        /// Steps.
        iterations: usize,
    },
    /// On the way to the position an event happens.
    Beyond {
        /// The event, as it is stated.
        event: &'static str,
        /// The mode that it leads to; empty where there is but one.
        next: &'static str,
        /// Whether nothing says how it goes on from there, as at a dead point.
        is_lost: bool,
    },
    /// What moves it jumps at the position: it rests all over a stretch.
    Sticks {
        /// What jumps.
        surface: &'static str,
    },
}

impl RestError {
    /// Whether loops do not close, or come to a dead point, on the way to where it may rest.
    pub fn is_lost(&self) -> bool {
        match self {
            Self::Beyond { is_lost, .. } => *is_lost,
            Self::Unsettled { rate, .. } => rate.is_nan(),
            _ => false,
        }
    }
}

impl fmt::Display for RestError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { reason } => write!(formatter, "the search cannot begin there: {reason}"),
            Self::Driven { name, time } => write!(
                formatter,
                "it moves with the time and never rests: {name} is pushed in another way at {time} s than at 0 s"
            ),
            Self::Unbalanced { name, rate } => write!(
                formatter,
                "nothing balances {name}: it changes by {rate:e} per second, in SI units, wherever the mechanism is"
            ),
            Self::Unsettled { name, rate, iterations } if rate.is_nan() => write!(
                formatter,
                "after {iterations} steps the equations have no value: {name} is not a number"
            ),
            Self::Unsettled { name, rate, iterations } => write!(
                formatter,
                "after {iterations} steps there is no position of rest: {name} still changes by {rate:e} per second, in SI \
                 units, and no step makes that less"
            ),
            Self::Beyond { event, is_lost: true, .. } => write!(
                formatter,
                "on the way to where it would rest the loops come to a dead point: `{event}`"
            ),
            Self::Beyond { event, next: "", .. } => {
                write!(formatter, "on the way to where it would rest `{event}` happens")
            }
            Self::Beyond { event, next, .. } => write!(
                formatter,
                "on the way to where it would rest `{event}` happens, after which it is in the mode `{next}`: begin there, \
                 with `start {next}` in the scene"
            ),
            Self::Sticks { surface } => write!(
                formatter,
                "it rests all over a stretch, because what moves it jumps there: {surface}"
            ),
        }
    }
}

impl std::error::Error for RestError {}
