//! Quantities along a run.

use std::collections::HashMap;

use super::GRID;
use crate::hybrid::{Motion, Piece};
use crate::ode::larger;
use crate::problem::Phase;

/// Halvings of a step at most where quantities do something that the state does not feel.
const DEEPEST: usize = 10;
/// Halvings of the steps that are looked at: so many, and as many for each step, but no more in all than the last. What is
/// nothing but rounding takes all.
const HALVINGS: (f64, f64, f64) = (128.0, 8.0, 50_000.0);
/// Halvings of integrals that are saved up at most, and how many more there are for each part of a step. A kink takes two
/// dozen; what is nothing but rounding, which no halving makes smooth, takes all.
const SPLITS: (usize, usize) = (2048, 8);
/// How far quantities may be from the quartic through every second point, over what they span. A step in which they are
/// farther is halved.
const DEVIATION: f64 = 0.05;
/// Parts of the first and the last step of a piece that are looked at by themselves. Elsewhere the next step shows whether
/// a quantity that bends turns there; next to an end nothing else would.
const ENDS: [f64; 2] = [1e-4, 1e-2];
/// Deviations that are rounding, over the size of a quantity.
const NOISE: f64 = 1e-12;
/// What is nothing but rounding deviates by no more than this over what it was seen to deviate by where no halving helped.
const SPREAD: f64 = 4.0;
/// Roundings of the time by which an event may be away from where it is found.
const BLUR: f64 = 64.0;
/// Evaluations that are kept while hills are climbed: quantities of one motion often turn in the same stretches.
const KEPT: usize = 4096;
/// Where in a step quantities are looked at: multiples of the golden section, which keep out of step with whatever swings.
const PLACES: [f64; GRID + 1] = [0.0, 0.09, 0.236, 0.382, 0.5, 0.618, 0.764, 0.91, 1.0];
/// For every second place what the others count in the quartic through them.
const QUARTIC: [[f64; GRID / 2 + 1]; GRID / 2] = quartic();

const fn quartic() -> [[f64; GRID / 2 + 1]; GRID / 2] {
    let mut weights = [[1.0; GRID / 2 + 1]; GRID / 2];
    let mut row = 0;
    while row < GRID / 2 {
        let at = PLACES[2 * row + 1];
        let mut own = 0;
        while own <= GRID / 2 {
            let mut other = 0;
            while other <= GRID / 2 {
                if other != own {
                    let beside = PLACES[2 * other];
                    weights[row][own] *= (at - beside) / (PLACES[2 * own] - beside);
                }
                other += 1;
            }
            own += 1;
        }
        row += 1;
    }
    weights
}

/// Writes the quantities in a phase at a time and state.
pub type Probe<'a> = dyn Fn(Phase<'_, f64>, f64, &[f64], &mut [f64]) + 'a;

/// Looks at quantities along a run.
pub(super) struct Sampler<'a> {
    /// The run.
    pub(super) motion: &'a Motion,
    sample: &'a Probe<'a>,
    state: Vec<f64>,
    values: Vec<f64>,
    /// Halvings that are left, and how many more there are for each step.
    halvings: (f64, f64),
    /// Halvings of integrals that are left.
    splits: usize,
    /// The step in which was looked last.
    step: usize,
    /// By how much each quantity deviates where no halving makes it smooth.
    noise: Vec<f64>,
    /// Evaluations by the number of the piece and the bits of the time.
    kept: HashMap<(usize, u64), Vec<f64>>,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(motion: &'a Motion, count: usize, sample: &'a Probe<'a>) -> Self {
        let times = motion.pieces.iter().map(|piece| piece.trajectory.times());
        let steps: usize = times.map(<[f64]>::len).sum();
        Self {
            motion,
            sample,
            state: motion.end.clone(),
            values: vec![0.0; count],
            halvings: (HALVINGS.0, HALVINGS.1.min(HALVINGS.2 / steps.max(1) as f64)),
            splits: SPLITS.0,
            step: 0,
            noise: vec![0.0; count],
            kept: HashMap::new(),
        }
    }

    /// By how much a quantity deviates where no halving makes it smooth: rises that are no larger are none.
    pub(super) fn noise(&self, index: usize) -> f64 {
        self.noise[index]
    }

    /// A quantity at a time in a piece. All of them are kept there for the others.
    pub(super) fn one(&mut self, number: usize, time: f64, index: usize) -> f64 {
        if self.values.len() == 1 {
            return self.at(&self.motion.pieces[number], time)[0];
        }
        let key = (number, time.to_bits());
        if let Some(kept) = self.kept.get(&key) {
            return kept[index];
        }
        if self.kept.len() == KEPT {
            self.kept.clear();
        }
        let values = self.at(&self.motion.pieces[number], time).to_vec();
        let value = values[index];
        self.kept.insert(key, values);
        value
    }

    /// All quantities at a time in a piece, in the mode of that piece even at its ends. Where an event ends it the quantities
    /// are those a few roundings inside, where conditions on what the event watches hold as they do in the piece.
    pub(super) fn at(&mut self, piece: &Piece, time: f64) -> &[f64] {
        let time = self.inside(piece, time);
        piece.trajectory.at_beside(&mut self.step, time, &mut self.state);
        let phase = Phase { mode: piece.mode, sides: &piece.sides };
        (self.sample)(phase, time, &self.state, &mut self.values);
        &self.values
    }

    /// A time in a piece, away from events at its ends.
    fn inside(&self, piece: &Piece, time: f64) -> f64 {
        let times = piece.trajectory.times();
        let (begin, end) = (times[0], times[times.len() - 1]);
        let blur = BLUR * f64::EPSILON * begin.abs().max(end.abs());
        if time > begin + blur && time < end - blur || end - begin < 4.0 * blur {
            return time;
        }
        let first = self.motion.pieces.first().map_or(begin, |one| one.trajectory.times()[0]);
        let least = if begin > first { begin + blur } else { begin };
        let most = if end < self.motion.time { end - blur } else { end };
        time.clamp(least, most)
    }

    /// All quantities at a time and state beside a piece that ends there or begins there, in the mode of an event.
    pub(super) fn of(&mut self, mode: usize, (time, begins): (f64, bool), state: &[f64]) -> &[f64] {
        let sides = self.motion.sides_beside(mode, time, begins);
        (self.sample)(Phase { mode, sides }, time, state, &mut self.values);
        &self.values
    }

    /// Whether a part of an integral may be halved, which is counted.
    pub(super) fn may_split(&mut self) -> bool {
        let may = self.splits > 0;
        self.splits = self.splits.saturating_sub(1);
        may
    }

    /// Goes through the run between two times, step by step. One in which quantities are more than smooth is gone through
    /// in parts.
    pub(super) fn walk(
        &mut self,
        (from, to): (f64, f64),
        visit: &mut dyn FnMut(&Grid<'a>, &mut Self),
    ) {
        for (number, piece) in self.motion.pieces.iter().enumerate() {
            let times = piece.trajectory.times();
            let first = times.partition_point(|time| *time <= from).saturating_sub(1);
            for step in times[first..].windows(2) {
                let part = (step[0].max(from), step[1].min(to));
                if part.0 < part.1 {
                    self.halvings.0 += self.halvings.1;
                    let ends = (part.0 == times[0], Some(&part.1) == times.last());
                    for part in parts(part, ends).windows(2) {
                        self.walk_step((number, piece), (part[0], part[1]), 0, visit);
                    }
                } else if step[0] > to {
                    break;
                }
            }
        }
    }

    fn walk_step(
        &mut self,
        piece: (usize, &'a Piece),
        (from, to): (f64, f64),
        depth: usize,
        visit: &mut dyn FnMut(&Grid<'a>, &mut Self),
    ) {
        let grid = self.grid(piece, (from, to));
        let middle = grid.times[GRID / 2];
        let may_halve = depth < DEEPEST && self.halvings.0 >= 1.0 && from < middle && middle < to;
        if may_halve && !grid.is_resolved(&self.noise) {
            self.halvings.0 -= 1.0;
            let halves = [(from, middle), (middle, to)];
            if depth + 1 == DEEPEST {
                let both = halves.map(|half| self.grid(piece, half));
                self.learn_noise(&both);
            }
            for half in halves {
                self.walk_step(piece, half, depth + 1, visit);
            }
        } else {
            self.splits = SPLITS.0.min(self.splits + SPLITS.1);
            visit(&grid, self);
        }
    }

    /// What deviates in both halves of the narrowest stretch does so by rounding. What jumps or has a kink does in one of them.
    fn learn_noise(&mut self, halves: &[Grid<'a>; 2]) {
        for (index, noise) in self.noise.iter_mut().enumerate() {
            let both = halves.each_ref().map(|half| {
                let column = half.column(index);
                if is_smooth(&column, *noise) { 0.0 } else { deviation(&column) }
            });
            *noise = noise.max(SPREAD * both[0].min(both[1]));
        }
    }

    /// The quantities along a part of a step.
    fn grid(&mut self, (number, piece): (usize, &'a Piece), (from, to): (f64, f64)) -> Grid<'a> {
        let time = |index: usize| match index {
            GRID => to,
            _ => from + (to - from) * PLACES[index],
        };
        let times: [f64; GRID + 1] = std::array::from_fn(time);
        let mut values = Vec::with_capacity(times.len() * self.values.len());
        for time in times {
            values.extend_from_slice(self.at(piece, time));
        }
        Grid { piece, number, count: self.values.len(), values, times }
    }
}

/// The ends of the parts of a step that may be the first or the last of its piece.
fn parts((from, to): (f64, f64), (first, last): (bool, bool)) -> Vec<f64> {
    let length = to - from;
    let begins = ENDS.iter().filter(|_| first).map(|part| from + part * length);
    let ends = ENDS.iter().rev().filter(|_| last).map(|part| to - part * length);
    let mut all: Vec<f64> = begins.chain(ends).filter(|time| from < *time && *time < to).collect();
    all.insert(0, from);
    all.push(to);
    all.dedup();
    all
}

/// The quantities along a step, or along a part of it.
pub(super) struct Grid<'a> {
    /// The piece that the step belongs to.
    pub(super) piece: &'a Piece,
    /// Its number.
    pub(super) number: usize,
    /// Times from the begin of the step to its end.
    pub(super) times: [f64; GRID + 1],
    count: usize,
    /// For each time all quantities.
    values: Vec<f64>,
}

impl Grid<'_> {
    /// Begin and end.
    pub(super) fn ends(&self) -> (f64, f64) {
        (self.times[0], self.times[GRID])
    }

    /// A quantity along the step.
    pub(super) fn column(&self, index: usize) -> [f64; GRID + 1] {
        std::array::from_fn(|row| self.values[row * self.count + index])
    }

    /// Whether every second point of each quantity says where the others lie, but for its noise.
    fn is_resolved(&self, noise: &[f64]) -> bool {
        (0..self.count).all(|index| is_smooth(&self.column(index), noise[index]))
    }
}

/// Whether every second value says where the others lie. What is no number cannot be resolved any further.
fn is_smooth(values: &[f64; GRID + 1], noise: f64) -> bool {
    let (low, high) = values
        .iter()
        .fold((f64::MAX, f64::MIN), |(low, high), one| (low.min(*one), high.max(*one)));
    let permitted =
        f64::max(DEVIATION * (high - low), NOISE * high.abs().max(low.abs())).max(noise);
    let deviation = deviation(values);
    deviation <= permitted || deviation.is_nan()
}

/// How far the values lie from the quartic through every second of them; NaN where one is.
fn deviation(values: &[f64; GRID + 1]) -> f64 {
    let rows = QUARTIC.iter().enumerate();
    let deviations = rows.map(|(row, weights)| {
        let terms = weights.iter().enumerate();
        let said: f64 = terms.map(|(own, weight)| weight * values[2 * own]).sum();
        (said - values[2 * row + 1]).abs()
    });
    deviations.fold(0.0, larger)
}
