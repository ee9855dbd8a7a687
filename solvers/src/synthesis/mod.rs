//! Dimensions from a wanted motion: designs sought everywhere, then polished.
//!
//! A design is a list of numbers, each between bounds or on a circle. What it is worth is a [`Score`]: by how much mandatory
//! conditions are missed, and, of designs that keep them all, a value that is to be small.

#[cfg(feature = "synthesis")]
mod bent;
#[cfg(feature = "synthesis")]
mod certificate;
mod crew;
#[cfg(feature = "synthesis")]
mod curve;
mod fit;
#[cfg(feature = "synthesis")]
mod local;
#[cfg(feature = "synthesis")]
mod polish;
mod population;
mod problem;
#[cfg(feature = "synthesis")]
mod programme;
mod search;
#[cfg(feature = "synthesis")]
mod stand;
#[cfg(test)]
mod tests;
#[cfg(feature = "synthesis")]
mod way;
#[cfg(feature = "synthesis")]
mod working;

#[cfg(feature = "synthesis")]
pub use certificate::{Certificate, certify};
pub use fit::Fit;
#[cfg(feature = "synthesis")]
pub use local::{Aim, Local, Look};
#[cfg(feature = "synthesis")]
pub use polish::{End, Polished, polish};
pub use population::Population;
pub use problem::{Judge, Score, Sought, SynthesisError};
pub use search::{Effort, Found, search};
