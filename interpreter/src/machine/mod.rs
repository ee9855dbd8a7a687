//! Runs functions on numbers of any kind.

mod memory;
mod run;
mod systems;

pub use memory::{Image, Kept};
