//! Expressions: a graph of shared nodes.
//!
//! An [`Expression`] is a handle into a [`Graph`]; equal expressions have equal handles. Whatever is built is at once in
//! a normal form: numbers are folded, equal terms and factors are collected, operands are sorted. Sums inside sums stay
//! as they are, because what is shared must not be written out; [`Graph::simplify`] opens those that are used once.

mod breaks;
mod budget;
mod build;
mod cancel;
mod differentiate;
mod display;
mod evaluate;
mod function;
mod graph;
mod hash;
mod laws;
mod linear;
mod polynomial;
mod search;
mod simplify;
mod solve;
mod squares;
mod stable;
mod support;

pub use breaks::{Breaks, Course};
pub use budget::{Budget, STEPS, within};
pub use build::collect_like;
pub use function::{Function, Relation};
pub use graph::{Expression, Graph, Node, Real, Symbol};
pub use hash::{Map, Set};
pub use linear::{Form, solve};
pub use search::Search;

#[cfg(test)]
mod tests;
