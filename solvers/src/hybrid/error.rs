//! Why a motion with events ended early.

use super::motion::Motion;
use crate::ode::OdeError;
use std::fmt;

/// Why a motion with events ended early. The motion so far is in it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum HybridError {
    /// An integration ended early.
    Ode {
        /// Why.
        error: OdeError,
        /// Mode in which it did.
        mode: usize,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// Events at one instant follow each other without end.
    Loop {
        /// When, in seconds.
        time: f64,
        /// The modes that follow each other, from one back to itself or as far as they were followed.
        modes: Vec<usize>,
        /// How many events were followed.
        turns: usize,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// Events follow each other ever more quickly.
    Chatter {
        /// When it was given up, in seconds.
        time: f64,
        /// When it began, in seconds.
        since: f64,
        /// How many events there were since.
        events: usize,
        /// Modes that were passed through.
        modes: Vec<usize>,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// The motion is driven onto a switching surface from both sides: dry friction that holds, for instance.
    Held {
        /// When, in seconds.
        time: f64,
        /// The mode.
        mode: usize,
        /// The surface, by the index of its event.
        event: usize,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// What an event watches is not a number: a root of something negative, a division by zero.
    Guard {
        /// When, in seconds.
        time: f64,
        /// The mode.
        mode: usize,
        /// The event.
        event: usize,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// Nothing says how the motion goes on after an event: what it sets is not a number. A dead point of a loop is such a
    /// one.
    Lost {
        /// When, in seconds.
        time: f64,
        /// The mode.
        mode: usize,
        /// The event.
        event: usize,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// An angle that guards depend on turns so far in one step that the guards cannot be looked at so often.
    Turns {
        /// When, in seconds.
        time: f64,
        /// The mode.
        mode: usize,
        /// How far it turns, in radians.
        turned: f64,
        /// The motion so far.
        motion: Box<Motion>,
    },
    /// What the mode holds moves at the start, or an event that ends the mode has happened before.
    Start {
        /// What was found and what was expected.
        reason: String,
    },
}

impl HybridError {
    /// The motion so far.
    pub fn motion(&self) -> Option<&Motion> {
        match self {
            Self::Ode { motion, .. }
            | Self::Loop { motion, .. }
            | Self::Held { motion, .. }
            | Self::Guard { motion, .. }
            | Self::Lost { motion, .. }
            | Self::Turns { motion, .. }
            | Self::Chatter { motion, .. } => Some(motion),
            Self::Start { .. } => None,
        }
    }
}

impl fmt::Display for HybridError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let listed = |modes: &[usize]| {
            let all: Vec<String> = modes.iter().map(usize::to_string).collect();
            all.join(" -> ")
        };
        match self {
            Self::Ode { error, mode, .. } => write!(formatter, "in mode {mode}: {error}"),
            Self::Loop { time, modes, turns, .. } => write!(
                formatter,
                "at t = {time} s events lead from mode to mode without end ({turns} were followed): {}; let one of them \
                 ask for more with `if`, or set something that keeps the others from happening at once",
                listed(modes)
            ),
            Self::Chatter { time, since, events, modes, .. } => write!(
                formatter,
                "{events} events between t = {since} s and {time} s, ever sooner after each other, in modes {}; a mode \
                 in which the parts stay together would take their place, reached `if` a speed is small enough",
                listed(modes)
            ),
            Self::Held { time, mode, event, .. } => write!(
                formatter,
                "in mode {mode} at t = {time} s the motion is driven onto the switching surface of event {event} from both \
                 sides, so that it stays there; state what holds on it as a mode, with `hold`"
            ),
            Self::Guard { time, mode, event, .. } => write!(
                formatter,
                "in mode {mode} after t = {time} s what event {event} watches is not a number: a root of something negative, \
                 or a division by zero"
            ),
            Self::Lost { time, mode, event, .. } => write!(
                formatter,
                "in mode {mode} at t = {time} s event {event} ends the motion: what it sets is not a number, as at a dead point of \
                 a loop"
            ),
            Self::Turns { time, mode, turned, .. } => write!(
                formatter,
                "in mode {mode} after t = {time} s an angle that events depend on turns by {turned:.3e} rad within one step, too \
                 often to look for events; give speeds in rad/s, or take a shorter time"
            ),
            Self::Start { reason } => write!(formatter, "start: {reason}"),
        }
    }
}

impl std::error::Error for HybridError {}
