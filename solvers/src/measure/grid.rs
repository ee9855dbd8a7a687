//! Quantities along a run.

use super::GRID;
use crate::hybrid::{Motion, Piece};

/// Writes the quantities in a mode at a time and state.
pub type Sample<'a> = dyn Fn(usize, f64, &[f64], &mut [f64]) + 'a;

/// Looks at quantities along a run.
pub(super) struct Sampler<'a> {
    /// The run.
    pub(super) motion: &'a Motion,
    sample: &'a Sample<'a>,
    state: Vec<f64>,
    values: Vec<f64>,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(motion: &'a Motion, count: usize, sample: &'a Sample<'a>) -> Self {
        Self {
            motion,
            sample,
            state: motion.end.clone(),
            values: vec![0.0; count],
        }
    }

    /// All quantities at a time in a piece, in the mode of that piece even at its ends.
    pub(super) fn at(&mut self, piece: &Piece, time: f64) -> &[f64] {
        piece.trajectory.at_into(time, &mut self.state);
        (self.sample)(piece.mode, time, &self.state, &mut self.values);
        &self.values
    }

    /// All quantities in a mode at a time and state.
    pub(super) fn of(&mut self, mode: usize, time: f64, state: &[f64]) -> &[f64] {
        (self.sample)(mode, time, state, &mut self.values);
        &self.values
    }

    /// The quantities along a step.
    pub(super) fn grid(&mut self, piece: &'a Piece, (from, to): (f64, f64)) -> Grid<'a> {
        let time = |index: usize| match index {
            GRID => to,
            _ => from + (to - from) * (index as f64 / GRID as f64),
        };
        let times: [f64; GRID + 1] = std::array::from_fn(time);
        let rows = times.iter().map(|time| self.at(piece, *time).to_vec());
        Grid {
            piece,
            rows: rows.collect(),
            times,
        }
    }
}

/// The quantities along a step.
pub(super) struct Grid<'a> {
    /// The piece that the step belongs to.
    pub(super) piece: &'a Piece,
    /// Times from the begin of the step to its end.
    pub(super) times: [f64; GRID + 1],
    /// For each time all quantities.
    rows: Vec<Vec<f64>>,
}

impl Grid<'_> {
    /// Begin and end.
    pub(super) fn ends(&self) -> (f64, f64) {
        (self.times[0], self.times[GRID])
    }

    /// A quantity along the step.
    pub(super) fn column(&self, index: usize) -> [f64; GRID + 1] {
        std::array::from_fn(|row| self.rows[row][index])
    }
}
