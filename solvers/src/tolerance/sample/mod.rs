//! Linkages made at random.
//!
//! | file | what it finds |
//! |---|---|
//! | `drawing`, [`monte_carlo`](fn@super::monte_carlo) | moments, quantiles, failures, each with its interval |
//! | `tally`, `estimate` | what is kept of them |

pub(super) mod drawing;
pub(super) mod estimate;
pub(super) mod monte_carlo;
pub(super) mod tally;
