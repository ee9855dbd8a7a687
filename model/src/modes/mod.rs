//! Modes of a motion and the events that lead from one to another.
//!
//! | file | what it does |
//! |---|---|
//! | `phases` | which statements hold in each mode |
//! | `events` | what an event watches, and what it sets |

mod events;
mod phases;

pub use events::{Event, EventInfo, Slopes, check_holds, read, still};
pub use phases::{Phase, Phases};
