//! Errors of a linkage from the tolerances of its dimensions, and tolerances that cost least.
//!
//! A [`Source`] is an independent error of a variable: a tolerance, or play in a joint. A [`Study`] asks how an output
//! errs by all of them at places of the drivers.
//!
//! | file | what it finds |
//! |---|---|
//! | `influence`, [`linear`](fn@linear) | greatest error and standard deviation to first order, what each source contributes |
//! | `drawing`, [`monte_carlo`](fn@monte_carlo) | linkages made at random: moments, quantiles, failures, each with its interval |
//! | `second`, [`corners`](fn@corners), [`differences`](fn@differences) | the same to second order, extremes, and when it matters |
//! | [`allocate`](fn@allocate) | tolerances of least cost that keep a band over the whole way of the drivers |
//! | [`elastic`](fn@elastic) | what a load does to links that are not rigid |
//! | `nominal`, `varied`, `made`, `place`, `lead`, `exact`, `small` | how they are closed in the mode of the nominal linkage, or found not to |
//! | `random`, `normal`, `distribution` | their dimensions |
//! | `tally`, `estimate` | what is kept of them |
//! | `variation` | derivatives by dual numbers |

#[cfg(feature = "allocation")]
mod allocation;
mod asked;
mod corners;
mod differences;
mod distribution;
mod drawing;
mod elastic;
mod error;
mod estimate;
mod exact;
mod influence;
mod lead;
mod linear;
mod made;
mod monte_carlo;
mod nominal;
mod normal;
mod place;
mod random;
mod second;
mod small;
mod source;
mod tally;
#[cfg(test)]
mod tests;
mod variation;
mod varied;

#[cfg(feature = "allocation")]
pub use allocation::{
    Active, Allocation, AllocationError, Candidate, Cost, Limit, Rule, allocate, allocate_along,
};
pub use corners::{Corners, Extremes, corners};
pub use differences::{Difference, Differences, differences};
pub(crate) use drawing::{Block, Drawing, Run};
pub use elastic::{Bar, Loaded, elastic};
pub use error::ToleranceError;
#[doc(hidden)]
pub use estimate::share;
pub use estimate::{Estimate, Quantile, Sampled, Status};
pub use influence::{Influences, influences};
pub use linear::{Contribution, Linear, Rank, linear, ranking, worst_place};
pub use monte_carlo::{MonteCarlo, Sampling, monte_carlo};
#[doc(hidden)]
pub use normal::quantile as normal_quantile;
pub use random::Random;
pub use second::{Moments, Quadratic, quadratics};
pub use source::{Source, Study};
