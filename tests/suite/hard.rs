//! Hard cases: the naive way fails, and beside it stands ours.

mod absurd;
mod cancellation;
mod long;
mod masses;
mod resonance;
mod tolerances;
mod units;
