//! Hard cases: the naive way fails, and beside it stands ours.

mod absurd;
mod cancellation;
mod long;
mod loops;
mod masses;
mod resonance;
mod stiff;
mod tolerances;
mod units;
