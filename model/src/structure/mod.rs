//! Structure of a system of equations: which equation determines which unknown, what is determined too often or not at
//! all, and in which order the rest can be solved.

mod blocks;
mod matching;

pub use blocks::{Block, blocks};
pub use matching::{Imbalance, Matching};

/// Which unknowns occur in which equations.
#[derive(Clone, Debug, Default)]
pub struct Incidence {
    /// For each equation its unknowns, rising.
    pub rows: Vec<Vec<usize>>,
    /// Number of unknowns.
    pub columns: usize,
}

#[cfg(test)]
mod tests;
