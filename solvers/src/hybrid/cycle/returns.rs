//! After how many periods a motion comes near to its past.

use std::collections::VecDeque;

use super::MULTIPLES;

/// The last states at the ends of periods.
pub(super) struct Past {
    /// Mode and state, the latest first.
    states: VecDeque<(usize, Vec<f64>)>,
    /// The largest size of each state so far, its scale at least.
    sizes: Vec<f64>,
}

impl Past {
    pub(super) fn new(scales: &[f64]) -> Self {
        Self { states: VecDeque::with_capacity(MULTIPLES + 1), sizes: scales.to_vec() }
    }

    /// Adds the state at the end of a period. Gives after how many periods it is nearest to the past, and how near: the
    /// largest change of a state over its size. The fewest periods within a factor of ten of the nearest.
    pub(super) fn add(&mut self, mode: usize, state: &[f64]) -> Option<(usize, f64)> {
        for (size, value) in self.sizes.iter_mut().zip(state) {
            *size = size.max(value.abs());
        }
        let distance = |past: &(usize, Vec<f64>)| {
            let pairs = past.1.iter().zip(state).zip(&self.sizes);
            let changes = pairs.map(|((a, b), size)| (a - b).abs() / size);
            match past.0 == mode {
                true => changes.fold(0.0, f64::max),
                false => f64::INFINITY,
            }
        };
        let distances: Vec<f64> = self.states.iter().map(distance).collect();
        self.states.push_front((mode, state.to_vec()));
        self.states.truncate(MULTIPLES);
        let nearest = distances.iter().copied().fold(f64::INFINITY, f64::min);
        let near = distances.iter().position(|one| *one <= 10.0 * nearest)?;
        nearest.is_finite().then(|| (near + 1, distances[near]))
    }

    /// Sizes of the states.
    pub(super) fn sizes(&self) -> &[f64] {
        &self.sizes
    }
}
