//! A motion through several modes.

use super::numbers::Numbers;
use crate::floquet::Multiplier;
use crate::ode::{Basis, Observer, Recorder, Statistics, Step, Trajectory};
use crate::rest::Rest;
use crate::stiff::Switch;

/// Steps of what has no state.
pub const STILL: usize = 180;

/// A stretch of the motion in one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The mode.
    pub mode: usize,
    /// The motion.
    pub trajectory: Trajectory,
    /// On which side of each switching surface of the mode it is, 1 or −1.
    pub sides: Numbers,
}

/// An event that has happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Happened {
    /// When, in seconds.
    pub time: f64,
    /// Mode before it.
    pub from: usize,
    /// Which event of that mode.
    pub event: usize,
    /// Mode after it.
    pub to: usize,
    /// State before it, SI units.
    pub before: Numbers,
    /// State after it, SI units.
    pub after: Numbers,
    /// Value of the guard, SI units: how well the event is located.
    pub guard: f64,
}

/// A motion through several modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// The stretches between events. Between events at one instant there is none.
    pub pieces: Vec<Piece>,
    /// The events, in their order.
    pub events: Vec<Happened>,
    /// Mode at the end.
    pub mode: usize,
    /// State at the end, SI units.
    pub end: Vec<f64>,
    /// Time at the end.
    pub time: f64,
    /// What the integrations took together.
    pub statistics: Statistics,
    /// What is known of a position of rest; none of what moves.
    pub rest: Option<Rest>,
    /// The Floquet multipliers of a motion that repeats.
    pub multipliers: Vec<Multiplier>,
}

impl Motion {
    /// A motion that has not begun.
    pub fn unbegun(time: f64, start: &[f64]) -> Self {
        Self {
            pieces: Vec::new(),
            events: Vec::new(),
            mode: 0,
            end: start.to_vec(),
            time,
            statistics: Statistics::default(),
            rest: None,
            multipliers: Vec::new(),
        }
    }

    /// A position of rest in a mode.
    pub fn resting(mode: usize, rest: Rest) -> Self {
        let motion = Self { mode, ..Self::unbegun(0.0, &rest.state) };
        let (evaluations, jacobians) = rest.evaluations;
        let statistics = Statistics { evaluations, jacobians, ..motion.statistics };
        Self { rest: Some(rest), statistics, ..motion }
    }

    /// A motion in one mode.
    pub fn of(trajectory: Trajectory) -> Self {
        let times = trajectory.times();
        Self {
            events: Vec::new(),
            mode: 0,
            end: trajectory.end().to_vec(),
            time: times[times.len() - 1],
            statistics: trajectory.statistics,
            pieces: vec![Piece { mode: 0, trajectory, sides: Numbers::default() }],
            rest: None,
            multipliers: Vec::new(),
        }
    }

    /// What moves with the time alone: nothing has a state. It is as if it had been integrated in so many even steps.
    pub fn without_states(mode: usize, (from, to): (f64, f64), steps: usize) -> Self {
        let mut recorder = Recorder::new(from, &[]);
        let time = |index: usize| from + (to - from) * (index as f64 / steps as f64);
        for index in 0..steps {
            recorder.step(&Step {
                from: time(index),
                to: time(index + 1),
                before: &[],
                after: &[],
                polynomial: &[],
                basis: Basis::Alternating,
            });
        }
        let trajectory = recorder.finish(Statistics::default());
        let mut motion = Self::of(trajectory);
        motion.mode = mode;
        motion.pieces[0].mode = mode;
        motion
    }

    /// The mode and the state at a time; at an event, those after it. Beyond the ends those at the nearest end.
    pub fn at(&self, time: f64) -> (usize, Vec<f64>) {
        let passed = self.pieces.partition_point(|piece| piece.trajectory.times()[0] <= time);
        match self.pieces.get(passed.saturating_sub(1)) {
            _ if time >= self.time => (self.mode, self.end.clone()),
            Some(piece) => (piece.mode, piece.trajectory.at(time)),
            None => (self.mode, self.end.clone()),
        }
    }

    /// The sides of the switching surfaces on which it is at a time; at an event, those after it. None where that is not known:
    /// after the last event of all.
    pub fn sides(&self, time: f64) -> &[f64] {
        let passed = self.pieces.partition_point(|piece| piece.trajectory.times()[0] <= time);
        match self.pieces.get(passed.saturating_sub(1)) {
            _ if time >= self.time => self.sides_beside(self.mode, self.time, false),
            Some(piece) => &piece.sides,
            None => &[],
        }
    }

    /// The sides of the piece in a mode that begins at a time, or ends at it; none where there is none.
    pub(crate) fn sides_beside(&self, mode: usize, time: f64, begins: bool) -> &[f64] {
        let is_there = |piece: &&Piece| {
            let (from, to) = Self::ends(piece);
            piece.mode == mode && time == if begins { from } else { to }
        };
        self.pieces.iter().find(is_there).map_or(&[], |piece| &piece.sides)
    }

    /// The last time in a piece.
    pub fn ends(piece: &Piece) -> (f64, f64) {
        let times = piece.trajectory.times();
        (times[0], times[times.len() - 1])
    }

    /// Where an automatic choice changed between the explicit and the stiff method.
    pub fn switches(&self) -> impl Iterator<Item = Switch> {
        let pieces = self.pieces.iter();
        pieces.flat_map(|piece| piece.trajectory.switches.iter().copied())
    }
}
