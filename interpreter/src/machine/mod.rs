//! Runs functions on numbers of any kind.

mod lanes;
mod memory;
mod run;
mod systems;

pub use lanes::{Lanes, WIDTH};
pub use memory::{Image, Kept};
