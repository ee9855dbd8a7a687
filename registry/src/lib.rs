//! Mechanisms as data, above the solvers of Assur, which know numbers only.
//!
//! | module | what it is |
//! |---|---|
//! | [`registry`] | the tables that emitted code fills: mechanisms with their scenes, and what fixes the values of a scene |
//! | [`check`] | what the generated tests of a mechanism ask of it |
//! | [`study`] | many runs of a scene with different values |

pub mod check;
pub mod registry;
pub mod study;
