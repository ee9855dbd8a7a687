//! Errors of a linkage from the tolerances of its dimensions, and tolerances that cost least.
//!
//! A [`Source`] is an independent error of a variable: a tolerance, or play in a joint. A [`Study`] asks how an output
//! errs by all of them at places of the drivers.
//!
//! | file | what it finds |
//! |---|---|
//! | `influence`, [`linear`](fn@linear) | greatest error and standard deviation to first order, what each source contributes |
//! | `normal`, `distribution` | moments of the sources |

mod distribution;
mod error;
mod influence;
mod linear;
mod normal;
#[cfg(test)]
mod small;
mod source;
#[cfg(test)]
mod tests;

pub use error::ToleranceError;
pub use influence::{Influences, influences};
pub use linear::{Contribution, Linear, Rank, linear, ranking, worst_place};
pub use source::{Source, Study};
