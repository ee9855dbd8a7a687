//! Closures: the loop equations of a linkage, ordered into groups, solved in closed form where that is possible, and
//! differentiated.
//!
//! The dependent coordinates are symbols everywhere. What a group of equations makes of them is computed beside
//! ([`dyad`]), and their derivatives follow from the equations ([`crate::slopes`]), never from a solution: so they are the same
//! whichever way the loops are closed.

mod angles;
mod assembly;
mod augmented;
mod carried;
mod dead;
mod dyad;
mod eliminate;
mod follow;
mod forms;
mod geometry;
mod group;
mod independent;
mod loops;
mod order;
mod places;
mod relative;
mod results;

pub use angles::{expand, period};
pub use augmented::{Augmented, named};
pub use carried::Carried;
pub use follow::follow;
pub use geometry::{Geometry, Ranges};
pub use group::Group;
pub use independent::bound;
pub use loops::Loops;
pub use order::Linkage;
pub use places::{Places, compare};

use crate::expression::Expression;
use relative::Links;

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
    /// The directions of the links, where they are sums of angles.
    pub links: Option<Links>,
    /// Sine of the transmission angle, with the sign of the mode.
    pub sine: Expression,
    /// By how much it assembles, in the unit of its equations.
    pub margin: Expression,
}
