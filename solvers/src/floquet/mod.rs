//! What one period makes of small disturbances, by the matrix `Φ` of the variations at its end.

mod closing;
mod multipliers;

pub(crate) use closing::Closing;
pub use multipliers::Multiplier;
pub(crate) use multipliers::of as multipliers;
