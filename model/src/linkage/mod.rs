//! Closures: the loop equations of a linkage, ordered into groups, solved in closed form where that is possible, and
//! differentiated.
//!
//! The dependent coordinates are symbols everywhere. What a group of equations makes of them is computed beside
//! ([`dyad`]), and their derivatives follow from the equations ([`crate::slopes`]), never from a solution: so they are the same
//! whichever way the loops are closed.

mod angles;
mod carried;
mod dyad;
mod follow;
mod geometry;
mod group;
mod loops;
mod order;
mod relative;
mod results;

pub use angles::expand;
pub use follow::follow;
pub use geometry::{Geometry, Ranges};
pub use group::Group;
pub use loops::Loops;
pub use order::Linkage;

use crate::expression::Expression;

/// An entry of a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slot {
    /// A dependent coordinate.
    Value(usize),
    /// Its cosine.
    Cosine(usize),
    /// Its sine.
    Sine(usize),
}

/// How a group is closed without iteration.
#[derive(Clone, Debug)]
pub struct Closed {
    /// What its unknowns become.
    pub values: Vec<(Slot, Expression)>,
    /// Sine of the transmission angle, with the sign of the mode.
    pub sine: Expression,
    /// By how much it assembles, in the unit of its equations.
    pub margin: Expression,
}
