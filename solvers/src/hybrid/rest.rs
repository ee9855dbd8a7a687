//! Rest that no event keeps a motion from.

use super::Direction;
use super::motion::Motion;
use super::run::start::passed;
use crate::model::{Flow, Model};
use crate::rest::{self, RestError};

/// The position at which a model rests in a mode, found from a start.
///
/// # Errors
/// See [`RestError`].
pub(crate) fn rest_of(model: &dyn Model, mode: usize, start: &[f64]) -> Result<Motion, RestError> {
    let rest = rest::of(model, mode, start)?;
    check(&Flow::new(model, mode), start, &rest.state)?;
    Ok(Motion::resting(mode, rest))
}

/// Whether what is watched in both directions has changed its sign.
fn crosses(flow: &Flow<'_>, index: usize, start: &[f64], state: &[f64]) -> bool {
    let event = &flow.shape().modes[flow.mode()].events[index];
    let is_watched = event.surface.is_none() && event.direction == Direction::Crosses;
    is_watched
        && flow.guard(index, 0.0, start).0 * flow.guard(index, 0.0, state).0 < 0.0
        && (!event.conditional || flow.permits(index, 0.0, state))
}

/// Whether an event happens between the start and where the mechanism would rest.
fn check(flow: &Flow<'_>, start: &[f64], state: &[f64]) -> Result<(), RestError> {
    let (shape, mode) = (flow.shape(), flow.mode());
    let Some(entry) = shape.modes.get(mode) else {
        return Ok(());
    };
    let before = passed(flow, 0.0, start);
    let happens = |index: &usize| {
        entry.events[*index].target != mode || before.iter().all(|(other, _)| other != index)
    };
    let there = passed(flow, 0.0, state).into_iter().map(|(index, _)| index).filter(happens);
    let crossed = (0..entry.events.len()).filter(|index| crosses(flow, *index, start, state));
    let Some(index) = there.chain(crossed).next() else {
        return Ok(());
    };
    let event = &entry.events[index];
    let mut after = state.to_vec();
    flow.jump(index, 0.0, state, &mut after);
    let is_lost = event.sets && after.iter().any(|value| value.is_nan());
    let next = if event.target == mode { "" } else { shape.modes[event.target].name };
    Err(RestError::Beyond { event: event.text, next, is_lost })
}
