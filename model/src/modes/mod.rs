//! Modes of a motion and the events that lead from one to another.
//!
//! | file | what it does |
//! |---|---|
//! | `phases` | which statements hold in each mode |
//! | `events` | what an event watches, and what it sets |
//! | `compile` | a scene with its modes: each is compiled like a scene of its own, over one state vector |

mod compile;
mod events;
mod phases;

pub use compile::{Compiled, compile, only};
pub use events::{Event, EventInfo, check_holds, read, still};
pub use phases::{Phase, Phases};
