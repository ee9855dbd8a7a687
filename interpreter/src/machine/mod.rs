//! Runs functions on numbers of any kind.

mod calls;
mod files;
mod idle;
mod memory;
mod run;
pub(crate) mod series;
mod systems;

pub use calls::{Calls, Columns};
pub use memory::{Image, Kept};
