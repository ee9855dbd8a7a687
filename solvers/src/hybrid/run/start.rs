//! Whether a motion may begin where it is to.

use crate::hybrid::error::HybridError;
use crate::hybrid::event::room::Room;
use crate::hybrid::event::rounding::terms;
use crate::hybrid::{Direction, NOISE};
use crate::model::Flow;
use crate::shape::Shape;

/// Part of a start value that its rounding may change.
const ROUNDED: f64 = 1e-4;

/// Whether there is such a mode.
pub(in crate::hybrid) fn check_mode(shape: &Shape, mode: usize) -> Result<(), HybridError> {
    let count = shape.modes.len();
    match mode < count {
        true => Ok(()),
        false => refused(format!("there are {count} modes, and it is to begin in number {mode}")),
    }
}

/// Whether what the mode holds stands still, and no event that leads to another mode has happened already.
pub(in crate::hybrid) fn check(
    flow: &Flow<'_>,
    time: f64,
    state: &[f64],
) -> Result<(), HybridError> {
    let (shape, mode) = (flow.shape(), flow.mode());
    let held = shape.modes[mode].held.iter();
    for (name, value) in held.map(|place| (shape.states[*place].name, state[*place])) {
        if value != 0.0 {
            return refused(format!(
                "{name} is {value} in SI units, and the mode in which the motion begins holds it at zero"
            ));
        }
    }
    let leads_away = |(index, value): &(usize, f64)| {
        let entry = &shape.modes[mode].events[*index];
        (entry.target != mode).then_some((entry, *value))
    };
    let Some((entry, value)) = passed(flow, time, state).iter().find_map(leads_away) else {
        return Ok(());
    };
    let unit = if entry.unit.is_empty() { "" } else { " " };
    refused(format!(
        "it is to begin in the mode `{}`, where `{}` has happened already: what that watches is {}{unit}{}; begin in the \
         mode that follows, with `start {}` in the scene, or with other values",
        shape.modes[mode].name,
        entry.text,
        value / entry.factor,
        entry.unit,
        shape.modes[entry.target].name,
    ))
}

/// The events of the mode that have happened already at a state, as what they watch and permit says, with the values of
/// their guards.
pub(in crate::hybrid) fn passed(flow: &Flow<'_>, time: f64, state: &[f64]) -> Vec<(usize, f64)> {
    let mode = &flow.shape().modes[flow.mode()];
    let mut room = Room::default();
    room.resize(mode.written());
    room.begin.look(flow, time, state);
    let Room { begin, there, terms: sizes, .. } = &mut room;
    terms(flow, time, state, begin, there, sizes);
    let events = mode.events.iter().enumerate().filter(|(_, entry)| entry.surface.is_none());
    let passed = events.filter_map(|(index, entry)| {
        let (value, noise) = (begin.values()[index], NOISE * f64::EPSILON * sizes.values()[index]);
        let has_passed = match entry.direction {
            Direction::Rises => value > noise,
            Direction::Falls => value < -noise,
            Direction::Crosses => false,
        };
        let holds = has_passed && (!entry.conditional || flow.permits(index, time, state));
        holds.then_some((index, value))
    });
    passed.collect()
}

/// The start on the closures that hold it, if there are any; refused where it is farther from them than rounding.
pub(in crate::hybrid) fn closed(
    flow: &Flow<'_>,
    time: f64,
    state: &[f64],
) -> Result<Option<Vec<f64>>, HybridError> {
    if state.len() != flow.states() || !flow.is_held() {
        return Ok(None);
    }
    let mut closed = state.to_vec();
    let done = flow.correct(time, &mut closed);
    let names = flow.shape().states.iter().map(|state| state.name);
    let moved = state.iter().zip(&closed).zip(names).find(|((stated, closed), _)| {
        let off = (**stated - **closed).abs();
        off > ROUNDED * stated.abs().max(1.0) || off.is_nan()
    });
    let reason = match (done, moved) {
        (Err(error), _) => error.to_string(),
        (Ok(()), Some(((stated, closed), name))) => format!(
            "{name} is {stated} in SI units, and the closures next to that ask for {closed}; begin where they close"
        ),
        (Ok(()), None) => return Ok(Some(closed)),
    };
    Err(HybridError::Start { reason })
}

fn refused(reason: String) -> Result<(), HybridError> {
    Err(HybridError::Start { reason })
}
