//! Modes of a motion and the events that lead from one to another.
//!
//! | file | what it does |
//! |---|---|
//! | `phases` | which statements hold in each mode |
//! | `events` | where an event leads, and what it sets |
//! | `guard` | what an event may watch |
//! | `idle` | events that are never carried out |
//! | `turning` | coordinates that turn and are set back |

mod events;
mod guard;
mod idle;
mod phases;
mod turning;

pub use events::{check_holds, read, still};
pub use phases::{Phase, Phases};
pub use turning::events as turning;
