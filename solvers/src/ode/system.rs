//! What the explicit methods integrate.

use super::error::OdeError;
use super::step::{self, Dop853, Room, Tsit5};
use super::tableau::Explicit;
use crate::problem::Staged;

/// Right-hand sides `y' = f(t, y)`, behind a pointer where it need not be known which: the steps of a scene are compiled
/// for it ([`Flow`](crate::model::Flow)), those of anything else ask for one evaluation after the other.
///
/// The state may consist of several parts, the motion first, each of which has its own error.
pub trait System {
    /// Length of the state, all its parts together.
    fn length(&self) -> usize;

    /// Writes `f(t, y)`.
    fn rates(&self, time: f64, state: &[f64], rates: &mut [f64]);

    /// Length of a part of the state.
    fn part(&self) -> usize {
        self.length()
    }

    /// Factor from the absolute tolerances of the state to those of a part.
    fn part_scale(&self, _part: usize) -> f64 {
        1.0
    }

    /// Corrects a state that a step has reached, where closures hold it.
    ///
    /// # Errors
    /// [`OdeError::Open`]
    fn correct(&self, _time: f64, _state: &mut [f64]) -> Result<(), OdeError> {
        Ok(())
    }

    /// Evaluates the stages of a step, the state at its end and its errors.
    fn attempt(&self, method: Explicit, room: &mut Room) {
        attempt_each(&|time, state, rates| self.rates(time, state, rates), method, room);
    }

    /// Evaluates what is missing of a step that is accepted: the slope at its end and, if asked for, the continuous
    /// solution.
    fn finish(&self, method: Explicit, room: &mut Room, dense: bool) {
        finish_each(&|time, state, rates| self.rates(time, state, rates), method, room, dense);
    }
}

/// Rates at a time and state.
pub(crate) type Rates<'a> = dyn Fn(f64, &[f64], &mut [f64]) + 'a;

/// The stages of a step, one evaluation after the other.
pub(crate) fn attempt_each(rates: &Rates<'_>, method: Explicit, room: &mut Room) {
    let mut each = Each { rates, length: room.state.len() };
    attempt_any(&mut each, method, room);
}

/// What is missing of a step, likewise.
pub(crate) fn finish_each(rates: &Rates<'_>, method: Explicit, room: &mut Room, dense: bool) {
    let mut each = Each { rates, length: room.state.len() };
    // What has tried the step may have kept its instants in another way.
    room.keep_end(method.tableau());
    finish_any(&mut each, method, room, dense);
}

/// The stages of a step of anything, compiled once.
pub(crate) fn attempt_any(staged: &mut dyn Staged<f64>, method: Explicit, room: &mut Room) {
    match method {
        Explicit::Tsit5 => step::attempt::<f64, Tsit5, _, false>(staged, room),
        Explicit::Dop853 => step::attempt::<f64, Dop853, _, false>(staged, room),
    }
}

/// What is missing of a step of anything, compiled once.
pub(crate) fn finish_any(
    staged: &mut dyn Staged<f64>,
    method: Explicit,
    room: &mut Room,
    dense: bool,
) {
    match method {
        Explicit::Tsit5 => step::finish::<f64, Tsit5, _>(staged, room, dense),
        Explicit::Dop853 => step::finish::<f64, Dop853, _>(staged, room, dense),
    }
}

/// Rates of which the time is all that they need of an instant.
struct Each<'a> {
    rates: &'a Rates<'a>,
    length: usize,
}

impl Staged<f64> for Each<'_> {
    fn length(&self) -> usize {
        self.length
    }

    fn instant(&self) -> usize {
        1
    }

    fn instants(&mut self, times: &[f64], rows: &mut [f64]) {
        rows.copy_from_slice(times);
    }

    fn rates(&mut self, instant: &[f64], state: &[f64], rates: &mut [f64]) {
        (self.rates)(instant[0], state, rates);
    }
}
