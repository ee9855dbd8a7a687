//! Runs functions on numbers of any kind.

mod lanes;
mod memory;
mod run;
pub(crate) mod series;
mod systems;

pub use lanes::{Lanes, WIDTH};
pub use memory::{Image, Kept};
