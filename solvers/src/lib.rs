//! The numerical solvers of Assur: what they ask of a model, and the numbers they work on.

pub mod problem;
pub mod scalar;
