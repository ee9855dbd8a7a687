//! How a motion through events depends on where it begins.
//!
//! Between events the variations obey `C' = (∂f/∂y) C` along the motion. At an event with the guard `g(t, y)` and the
//! jump `R(t, y)`, from rates `f⁻` to rates `f⁺`, a disturbed motion meets the guard earlier or later, and
//!
//! `C⁺ = (R_y + (f⁺ - R_y f⁻ - R_t) g_yᵀ / ġ) C⁻`,
//!
//! the saltation matrix (M. di Bernardo, C. J. Budd, A. R. Champneys, P. Kowalczyk: *Piecewise-smooth Dynamical Systems*,
//! 2008, section 2.5). A guard that does not pass zero but jumps over it has no such slopes: there `g_yᵀ / ġ` is how much
//! earlier it jumps, by differences; nothing, where it jumps at a given time. Events at one instant, where one sets off the
//! next, are one: the first one's guard, and all jumps one after the other.

use std::cell::RefCell;

use nalgebra::{DMatrix, DVector};

use super::super::{Happened, Motion, Piece};
use super::error::CycleError;
use crate::model::{Flow, Model};
use crate::ode::{AbsoluteTolerance, Explicit, OdeError, Options, System, Workspace, integrate};
use crate::settings::Settings;

/// Change of a state by which it is found what closures leave of it, over its size.
const ASIDE: f64 = 1e-5;
/// Steps of the motion that variations may take at once, and by what factor these may differ in length.
const TOGETHER: usize = 4;
const ALIKE: f64 = 2.0;

/// The matrix of derivatives of the end of a motion by its begin, SI units. What closures do not allow counts as nothing.
pub(super) fn of(
    model: &dyn Model,
    motion: &Motion,
    settings: &Settings,
) -> Result<DMatrix<f64>, CycleError> {
    let states = model.shape().scales.len();
    let mut matrix = DMatrix::identity(states, states);
    if let Some(first) = motion.pieces.first() {
        let (time, local) =
            (first.trajectory.times()[0], Flow::on(model, first.mode, &first.sides));
        matrix =
            tangent(&local, time, &first.trajectory.at(time)).map_err(CycleError::Variation)?;
    }
    let mut events = motion.events.as_slice();
    let mut before: &[f64] = &[];
    for piece in &motion.pieces {
        let begin = piece.trajectory.times()[0];
        let due = events.partition_point(|event| event.time <= begin);
        if due > 0 {
            let after = Flow::on(model, piece.mode, &piece.sides);
            matrix = jump(model, &events[..due], motion.time, before, &after)? * matrix;
            let held = tangent(&after, begin, &piece.trajectory.at(begin));
            matrix = held.map_err(CycleError::Variation)? * matrix;
            events = &events[due..];
        }
        let local = Flow::on(model, piece.mode, &piece.sides);
        matrix = along(&local, piece, model.shape().scales, matrix, settings)
            .map_err(CycleError::Variation)?;
        before = &piece.sides;
    }
    if !events.is_empty() {
        let after = Flow::on(model, motion.mode, &[]);
        matrix = jump(model, events, motion.time, before, &after)? * matrix;
    }
    Ok(matrix)
}

/// What is left of a change of a state where closures hold it, by differences; the identity where none do.
fn tangent(flow: &Flow<'_>, time: f64, state: &[f64]) -> Result<DMatrix<f64>, OdeError> {
    let mut matrix = DMatrix::identity(state.len(), state.len());
    if !flow.is_held() {
        return Ok(matrix);
    }
    for (column, value) in state.iter().enumerate() {
        let step = ASIDE * value.abs().max(1.0);
        let beside = |step: f64| {
            let mut moved = state.to_vec();
            moved[column] += step;
            flow.correct(time, &mut moved).map(|()| DVector::from_vec(moved))
        };
        matrix.set_column(column, &((beside(step)? - beside(-step)?) / (2.0 * step)));
    }
    Ok(matrix)
}

/// The matrix of events at one instant, of which each sets off the next, in a motion of some length.
fn jump(
    model: &dyn Model,
    events: &[Happened],
    span: f64,
    sides: &[f64],
    after: &Flow<'_>,
) -> Result<DMatrix<f64>, CycleError> {
    let states = model.shape().scales.len();
    let (first, last) = (&events[0], &events[events.len() - 1]);
    let mut slopes = DVector::zeros(states);
    let local = Flow::on(model, first.from, sides);
    local.guard_slopes(first.event, first.time, &first.before, slopes.as_mut_slice());
    let passing = local.guard(first.event, first.time, &first.before).1;
    let mut rate_before = DVector::zeros(states);
    local.rates(first.time, &first.before, rate_before.as_mut_slice());
    let (jumps, rate) = through(model, events, sides, rate_before.clone());
    let mut next = DVector::zeros(states);
    after.rates(last.time, &last.after, next.as_mut_slice());
    // A guard of the time alone is met by all motions together.
    if slopes.iter().all(|slope| *slope == 0.0) {
        return Ok(jumps);
    }
    let passage = Passage {
        local: &local,
        event: first,
        rate: rate_before,
        // Times are known to a few roundings of this.
        time: span.max(first.time.abs()),
    };
    let earlier = match passage.steps_over(&slopes, passing) {
        false => slopes / passing,
        true => passage.earlier(&slopes, model.shape().scales)?,
    };
    let matrix = jumps + (next - rate) * earlier.transpose();
    match matrix.iter().all(|entry| entry.is_finite()) {
        true => Ok(matrix),
        false => {
            Err(CycleError::Grazing { time: first.time, mode: first.from, event: first.event })
        }
    }
}

/// How a disturbance of the state, and its rate before them, pass through the settings of events at one instant.
fn through(
    model: &dyn Model,
    events: &[Happened],
    sides: &[f64],
    mut rate: DVector<f64>,
) -> (DMatrix<f64>, DVector<f64>) {
    let states = rate.len();
    let mut jumps = DMatrix::identity(states, states);
    for (index, event) in events.iter().enumerate() {
        let local = Flow::on(model, event.from, if index == 0 { sides } else { &[] });
        let mut columns = DMatrix::zeros(states, states);
        let mut total = DVector::zeros(states);
        let at = (event.time, &event.before[..]);
        if !local.jump_slopes(event.event, at, columns.as_mut_slice(), total.as_mut_slice()) {
            continue;
        }
        // `total` is along the motion of the mode that the event leaves, which is not that before all of them.
        let mut own = DVector::zeros(states);
        local.rates(event.time, &event.before, own.as_mut_slice());
        rate = total + &columns * (rate - own);
        jumps = columns * jumps;
    }
    (jumps, rate)
}

/// An event whose instant is looked at.
struct Passage<'a> {
    local: &'a Flow<'a>,
    event: &'a Happened,
    /// Rates of the state before it.
    rate: DVector<f64>,
    /// How long the times are that are compared.
    time: f64,
}

impl Passage<'_> {
    /// The guard where the motion without the event is at a time, with one of its states changed by so much.
    fn guard(&self, time: f64, (place, change): (usize, f64)) -> f64 {
        let before = DVector::from_column_slice(&self.event.before);
        let mut state = before + &self.rate * (time - self.event.time);
        state[place] += change;
        self.local.guard(self.event.event, time, state.as_slice()).0
    }

    /// The guard just before the event and just after it.
    fn sides(&self) -> [f64; 2] {
        let blur = 64.0 * f64::EPSILON * self.time;
        [-blur, blur].map(|part| self.guard(self.event.time + part, (0, 0.0)))
    }

    /// Whether the guard does not pass zero but jumps over it: one of its branches goes over to its other side there, in
    /// a mode whose motion does not depend on that branch. Its slopes then say nothing of when that happens.
    fn steps_over(&self, slopes: &DVector<f64>, passing: f64) -> bool {
        let [before, after] = self.sides();
        let terms = slopes.iter().zip(&self.event.before);
        let size: f64 = terms.map(|(slope, value)| (slope * value).abs()).sum();
        (after - before).abs() > 1e4 * f64::EPSILON * (size + (passing * self.time).abs())
    }

    /// By how much earlier the event happens per change of each state, by differences.
    fn earlier(&self, slopes: &DVector<f64>, scales: &[f64]) -> Result<DVector<f64>, CycleError> {
        let mut all = DVector::zeros(scales.len());
        for (place, one) in all.iter_mut().enumerate() {
            let size = 1e-5 * scales[place].max(self.event.before[place].abs());
            let times = [-size, size].map(|change| self.jumps((place, change), slopes[place]));
            let [Some(less), Some(more)] = times else {
                return Err(CycleError::Grazing {
                    time: self.event.time,
                    mode: self.event.from,
                    event: self.event.event,
                });
            };
            *one = (less - more) / (2.0 * size);
        }
        Ok(all)
    }

    /// When the guard jumps with one of the states changed, on which it has a slope: where it passes the middle of the
    /// jump, which the change moves along. None if not near.
    fn jumps(&self, change: (usize, f64), slope: f64) -> Option<f64> {
        let [before, after] = self.sides();
        let middle = 0.5 * (before + after) + slope * change.1;
        let has_passed = |time: f64| (self.guard(time, change) - middle) * (after - before) > 0.0;
        let mut width = 64.0 * f64::EPSILON * self.time;
        while has_passed(self.event.time - width) || !has_passed(self.event.time + width) {
            width *= 2.0;
            if width > 1e-3 * self.time {
                return None;
            }
        }
        let (mut low, mut high) = (self.event.time - width, self.event.time + width);
        loop {
            let middle = low + 0.5 * (high - low);
            if middle <= low || middle >= high {
                return Some(high);
            }
            match has_passed(middle) {
                true => high = middle,
                false => low = middle,
            }
        }
    }
}

/// Carries the columns of a matrix along a piece of the motion.
pub(super) fn along(
    local: &Flow<'_>,
    piece: &Piece,
    scales: &[f64],
    start: DMatrix<f64>,
    settings: &Settings,
) -> Result<DMatrix<f64>, OdeError> {
    let times = piece.trajectory.times();
    let (from, to) = (times[0], times[times.len() - 1]);
    if to - from <= 4.0 * f64::EPSILON * from.abs() {
        return Ok(start);
    }
    let states = scales.len();
    let columns = Columns {
        local,
        piece,
        scales,
        room: RefCell::new((vec![0.0; states], vec![0.0; states * states])),
    };
    // In states over their scales: entry `i` of column `j` is a change of `scales[i]` per `scales[j]`.
    let scaled = |matrix: &DMatrix<f64>, up: bool| {
        DMatrix::from_fn(states, states, |i, j| {
            let factor = scales[j] / scales[i];
            matrix[(i, j)] * if up { factor } else { 1.0 / factor }
        })
    };
    let mut end: Vec<f64> = scaled(&start, true).as_slice().to_vec();
    let tolerance = settings.rtol.max(1e-12);
    let mut workspace = Workspace::new(Explicit::Dop853, &columns);
    for stretch in stretches(times) {
        let options = Options {
            rtol: tolerance,
            atol: AbsoluteTolerance::Same(tolerance),
            first_step: Some(stretch.1 - stretch.0),
            ..Options::default()
        };
        integrate(&columns, stretch, &end, &options, &mut workspace, &mut ())?;
        end.copy_from_slice(workspace.state());
    }
    let end = DMatrix::from_column_slice(states, states, &end);
    Ok(scaled(&end, false))
}

/// Stretches of a motion that variations may go through in one step: some of its own steps, about alike in length. Where forces
/// change steeply, as friction does where it changes its sense, the motion takes small steps; the slopes of these forces are all
/// but zero elsewhere, so that variations by themselves would step over the place.
fn stretches(times: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let mut from = 0;
    std::iter::from_fn(move || {
        let length = |step: usize| times[step + 1] - times[step];
        let last = times.len() - 1;
        if from >= last {
            return None;
        }
        let begin = from;
        let is_like = |step: usize| {
            let ratio = length(step) / length(begin);
            (1.0 / ALIKE..=ALIKE).contains(&ratio)
        };
        from += 1;
        while from < last && from - begin < TOGETHER && is_like(from) {
            from += 1;
        }
        Some((times[begin], times[from]))
    })
}

/// The variational equations along a piece of a motion.
struct Columns<'a> {
    local: &'a Flow<'a>,
    piece: &'a Piece,
    scales: &'a [f64],
    /// Room for a state and a matrix.
    room: RefCell<(Vec<f64>, Vec<f64>)>,
}

impl System for Columns<'_> {
    fn length(&self) -> usize {
        self.scales.len() * self.scales.len()
    }

    fn rates(&self, time: f64, columns: &[f64], rates: &mut [f64]) {
        let states = self.scales.len();
        let mut room = self.room.borrow_mut();
        let (state, matrix) = &mut *room;
        self.piece.trajectory.at_into(time, state);
        self.local.jacobian(time, state, matrix);
        rates.fill(0.0);
        for (column, rate) in columns.chunks(states).zip(rates.chunks_mut(states)) {
            for (inner, value) in column.iter().enumerate() {
                let value = value * self.scales[inner];
                let slopes = &matrix[inner * states..][..states];
                for ((rate, slope), scale) in rate.iter_mut().zip(slopes).zip(self.scales) {
                    *rate += slope * value / scale;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::stretches;

    #[test]
    fn stretches_are_of_steps_that_are_alike() {
        let times = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 6.1, 6.2, 8.0];
        let found: Vec<_> = stretches(&times).collect();
        assert_eq!(found, [(0.0, 4.0), (4.0, 6.0), (6.0, 6.2), (6.2, 8.0)]);
        assert_eq!(stretches(&[1.0, 2.0]).collect::<Vec<_>>(), [(1.0, 2.0)]);
        assert_eq!(stretches(&[1.0]).count(), 0);
    }
}
