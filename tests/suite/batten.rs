//! The batten of a shuttle loom: laws, limits and digits of an independent computation.

mod laws;
mod limits;
mod losses;
mod reference;
mod untwisted;

pub use laws::bending_alone;
