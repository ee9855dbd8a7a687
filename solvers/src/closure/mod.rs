//! Positions of a linkage: its loops closed.

mod problem;

pub use problem::{Closure, Group, GroupKind, Linkage, Range, Variable};
