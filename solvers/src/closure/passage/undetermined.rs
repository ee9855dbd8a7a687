//! What has no value where two modes of a group meet: rates through the group are there zero over zero.

use crate::closure::position::guide::Guide;

/// Sine of a transmission angle below which less than half of the digits of a rate are left.
const SINGULAR: f64 = 1e-5;
/// Move of the unknowns of such a group, in radians or metres, that hangs together with rounding.
const MOVE: f64 = 1e-9;
/// Relative change by that move that only a rate can have.
const LOST: f64 = 1e-3;

impl Guide<'_, f64> {
    /// The groups that stand so near to where two modes meet that rates through them are rounding.
    fn singular(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.entry.groups.len()).filter(|&group| self.sine(group).abs() < SINGULAR)
    }

    /// Whether rates of the dependent coordinates are rounding, because two modes of a group meet.
    pub fn is_singular(&self) -> bool {
        self.singular().next().is_some()
    }

    /// Makes NaN of those outputs that hang on rates which are rounding. The others do not change when the unknowns of the
    /// group do by very little.
    pub(crate) fn strike_undetermined(&mut self, instant: &[f64], outputs: &mut [f64]) {
        let groups: Vec<usize> = self.singular().collect();
        let mut moved = vec![0.0; outputs.len()];
        for group in groups {
            let mut position = self.position.to_vec();
            for &j in self.entry.groups[group].unknowns {
                position[j] += MOVE;
            }
            // What the position holds beside the unknowns follows from them.
            self.newton.sine(self.loops, group, instant, &mut position);
            self.loops.outputs(instant, &position, &mut moved);
            for (value, moved) in outputs.iter_mut().zip(&moved) {
                let is_kept = (*moved - *value).abs() <= LOST * value.abs() + MOVE.sqrt();
                if !is_kept {
                    *value = f64::NAN;
                }
            }
        }
    }
}
