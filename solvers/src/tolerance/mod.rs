//! Errors of a linkage from the tolerances of its dimensions, and tolerances that cost least.
//!
//! A [`Source`] is an independent error of a variable: a tolerance, or play in a joint. A [`Study`] asks how an output
//! errs by all of them at places of the drivers.
//!
//! | folder or file | what it finds |
//! |---|---|
//! | `order` | errors to first order, [`linear`](fn@linear), to second order, extremes |
//! | `sample` | linkages made at random, [`monte_carlo`](fn@monte_carlo) |
//! | [`allocate`](fn@allocate) | tolerances of least cost that keep a band over the whole way of the drivers |
//! | [`elastic`](fn@elastic) | what a load does to links that are not rigid |
//! | `made` | how made linkages are closed in the mode of the nominal one, or found not to |
//! | `random` | their dimensions |
//! | `asked` | the same of any linkage |

#[cfg(feature = "allocation")]
mod allocation;
mod asked;
mod elastic;
mod error;
pub(crate) mod made;
mod order;
mod random;
mod sample;
mod source;
#[cfg(test)]
mod tests;

#[cfg(feature = "allocation")]
pub use allocation::{
    Active, Allocation, AllocationError, Candidate, Cost, Limit, Rule, allocate, allocate_along,
};
pub use elastic::{Bar, Loaded, elastic};
pub use error::ToleranceError;
pub use order::corners::{Corners, Extremes, corners};
pub use order::differences::{Difference, Differences, differences};
pub use order::influence::{Influences, influences};
pub use order::linear::{Contribution, Linear, Rank, linear, ranking, worst_place};
pub use order::rounding::Rounding;
pub use order::second::{Moments, Quadratic, quadratics};
pub use random::Random;
#[doc(hidden)]
pub use random::normal::quantile as normal_quantile;
pub(crate) use sample::drawing::{Block, Blocks, Drawing, Run};
#[doc(hidden)]
pub use sample::estimate::share;
pub use sample::estimate::{Estimate, Quantile, Sampled, Status};
pub use sample::monte_carlo::{MonteCarlo, Sampling, monte_carlo};
pub(crate) use sample::tally::Counts;
pub use source::{Source, Study};
