//! Harmonics over the turns of an angle.

use std::f64::consts::{PI, TAU};

use super::grid::Sampler;
use super::primitive::Missing;

/// How far the turns may be from a whole number.
const WHOLE: f64 = 1e-6;

/// The turns that an angle makes during the run.
pub(super) fn turns(angle: usize, sampler: &mut Sampler<'_>) -> Result<f64, Missing> {
    let motion = sampler.motion;
    let (Some(first), Some(last)) = (motion.pieces.first(), motion.pieces.last()) else {
        return Err(Missing::Empty);
    };
    let times = (first.trajectory.times()[0], motion.time);
    let from = sampler.at(first, times.0)[angle];
    let to = sampler.at(last, times.1)[angle];
    let turns = (to - from) / TAU;
    match (turns - turns.round()).abs() <= WHOLE && turns.round() != 0.0 {
        true => Ok(turns.round()),
        false => Err(Missing::NotWhole(turns)),
    }
}

/// A coefficient from its integral over all turns.
pub(super) fn scaled(integral: f64, order: u32, turns: f64) -> f64 {
    let norm = if order == 0 { TAU } else { PI };
    integral / (norm * turns)
}
