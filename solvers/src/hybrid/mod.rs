//! Motions that change their equations on the way: gaps close, parts lift off, friction sticks.
//!
//! In each mode the equations are smooth. An event is where a guard, a function of time and state, passes zero; it sets
//! coordinates anew and leads to a mode. [`march`] carries the motion from event to event:
//!
//! | folder or file | what it finds |
//! |---|---|
//! | `event` | events within the steps of a mode |
//! | `run` | the motion that is asked for, from event to event |
//! | `cycle` | motions that repeat: [`cycle()`]; growth of disturbances: [`lyapunov`] |
//! | `rest` | rest that no event keeps a motion from |
//! | `motion` | the result: pieces between events, and a record of each event |
//! | `numbers` | a few numbers without an allocation |
//!
//! **What is found.** Within a step a guard is the cubic through its values and rates at both ends, as far as that agrees
//! with the value in the middle; where it does not, or where the cubic may vanish, the step is halved. Methods step far
//! over what the state does not feel: so a step is taken in parts in which no angle of which a guard has the sine turns
//! by more than a radian, and it is looked into at some places besides where it is longer than those that were looked
//! into, and where the guard, by its rates in the last steps, has the time to swing. A pair of crossings is overlooked
//! only if the guard, between two points that are compared, leaves its cubic by more than four times what it does in
//! their middle. Each crossing is then narrowed down until its rate says that it has passed within two roundings of the
//! time, or neighbouring numbers of the time enclose it. Where a branch within a guard goes over to its other side
//! (`max`, `abs`, `if`) the guard bends or jumps. These kinks are functions too, of which the zeros are found first;
//! between them the guard is smooth, and in a jump it passes zero at the kink.
//!
//! **What is zero.** A guard of less than [`NOISE`] roundings of its terms, or of the largest value that it has had,
//! counts as zero: what is left where a difference vanishes says nothing. One that is zero when a mode begins passes
//! zero there if it leaves zero in the direction of the event, unless it is the event that has just happened: that one
//! has to come back first, except where the event has stopped its guard and something pushes on. It leaves zero by its
//! rate, or where that is no more than rounding, by where it is found next. If it says there that it goes the other way,
//! and within the step it does, it has not left zero: the continuous solutions of stiff methods do not begin with the
//! rates of the motion, and what they are wrong by is far less than the tolerance but no rounding.
//!
//! **What ends a motion.** More than [`TURNS`] events at one instant; [`CHATTER`] events in a row, each sooner after
//! the last than the part [`SOON`] of the time to be covered; or one event twice, between which its guard has not left
//! zero by more than its rounding. These are errors that carry the motion so far.

mod cycle;
mod error;
mod event;
mod motion;
mod numbers;
mod rest;
mod run;

pub use crate::shape::{Direction, EventEntry};
pub use cycle::{Cycle, CycleError, Lyapunov, Periods, clock, cycle, cycle_from, lyapunov};
pub(crate) use cycle::{clock_of, cycle_of, variations};
pub use error::HybridError;
pub use motion::{Happened, Motion, Piece, STILL};
pub use numbers::Numbers;
pub(crate) use rest::rest_of;
pub(crate) use run::march::Request;
pub use run::march::{march, march_in};

/// Roundings of its terms that a guard may have where it counts as zero.
pub const NOISE: f64 = 16.0;
/// Largest number of events at one instant.
pub const TURNS: usize = 64;
/// Number of events in quick succession that are chatter.
pub const CHATTER: usize = 200;
/// Part of the time to be covered below which events follow each other quickly.
pub const SOON: f64 = 1e-7;
