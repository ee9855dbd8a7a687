//! Why a motion ends early.

use crate::hybrid::TURNS;
use crate::hybrid::error::HybridError;
use crate::hybrid::motion::Motion;
use crate::ode::OdeError;

/// Why the motion ends early.
pub(in crate::hybrid) enum End {
    Ode(OdeError),
    Loop(Vec<usize>),
    Chatter { since: f64, events: usize },
    Held(usize),
    Guard(usize),
    Lost(usize),
    Turns(f64),
}

impl End {
    #[cold]
    pub(super) fn with(self, motion: Motion) -> HybridError {
        let (time, mode) = (motion.time, motion.mode);
        let motion = Box::new(motion);
        match self {
            Self::Ode(error) => HybridError::Ode { error, mode, motion },
            Self::Held(event) => HybridError::Held { time, mode, event, motion },
            Self::Turns(turned) => HybridError::Turns { time, mode, turned, motion },
            Self::Guard(event) => HybridError::Guard { time, mode, event, motion },
            Self::Lost(event) => HybridError::Lost { time, mode, event, motion },
            Self::Loop(modes) => HybridError::Loop { time, modes, turns: TURNS, motion },
            Self::Chatter { since, events } => {
                let last = motion.events.iter().rev().take(8);
                let mut modes: Vec<usize> = last.map(|one| one.to).collect();
                modes.sort_unstable();
                modes.dedup();
                HybridError::Chatter { time, since, events, modes, motion }
            }
        }
    }
}
