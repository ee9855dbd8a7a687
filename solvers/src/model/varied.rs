//! A motion beside its variations.

use super::Flow;
use crate::ode::{Explicit, Room, System};

/// A flow beside its variational equations `c' = ∂f/∂y · c`, one column for each state: the state is the motion, and behind it
/// one column after the other.
///
/// Started from the unit columns, the columns end as the matrix `Φ = ∂y(T)/∂y(0)`.
pub struct Varied<'a> {
    /// The motion.
    pub flow: &'a Flow<'a>,
    /// Sizes of the states. Column `j` is a change of `scales[j]` in state `j` per `scales[j]`, so its entry `i` has
    /// the size `scales[i] / scales[j]`: the absolute tolerances of the column are those of the state over `scales[j]`.
    pub scales: &'a [f64],
}

impl Varied<'_> {
    /// The start `start` with the unit columns.
    pub fn start(&self, start: &[f64]) -> Vec<f64> {
        let states = start.len();
        let mut all = vec![0.0; states * (1 + states)];
        all[..states].copy_from_slice(start);
        for column in 0..states {
            all[states * (1 + column) + column] = 1.0;
        }
        all
    }
}

impl System for Varied<'_> {
    fn length(&self) -> usize {
        let states = self.scales.len();
        states * (1 + states)
    }

    fn part(&self) -> usize {
        self.scales.len()
    }

    fn part_scale(&self, part: usize) -> f64 {
        match part {
            0 => 1.0,
            _ => 1.0 / self.scales[part - 1],
        }
    }

    fn rates(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        self.flow.variation(time, state, rates);
    }

    fn attempt(&self, method: Explicit, room: &mut Room) {
        self.flow.attempt_varied(method, room);
    }

    fn finish(&self, method: Explicit, room: &mut Room, dense: bool) {
        self.flow.finish_varied(method, room, dense);
    }
}
