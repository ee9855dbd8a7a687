//! Values at moments.

use super::grid::Sampler;
use super::primitive::Missing;
use crate::hybrid::{Happened, Motion};
use crate::shape::Moment;

/// A quantity at a moment.
pub(super) fn value(
    moment: Moment,
    index: usize,
    sampler: &mut Sampler<'_>,
) -> Result<f64, Missing> {
    let motion = sampler.motion;
    match moment {
        Moment::Start => {
            let piece = motion.pieces.first().ok_or(Missing::Empty)?;
            Ok(sampler.at(piece, piece.trajectory.times()[0])[index])
        }
        Moment::End => Ok(sampler.of(motion.mode, (motion.time, false), &motion.end)[index]),
        // Where that is the run has been looked through for.
        Moment::Passes { .. } => Err(Missing::NeverPasses),
        Moment::Enter { mode, last } => {
            let event = pick(events(moment, motion), last).ok_or(Missing::NeverEntered(mode))?;
            Ok(sampler.of(event.to, (event.time, true), &event.after)[index])
        }
        Moment::After { event: named, last } => {
            let event = pick(events(moment, motion), last);
            let event = event.ok_or(Missing::NeverHappens(named.name))?;
            Ok(sampler.of(event.to, (event.time, true), &event.after)[index])
        }
        Moment::Before { event: named, last } => {
            let event = pick(events(moment, motion), last);
            let event = event.ok_or(Missing::NeverHappens(named.name))?;
            Ok(sampler.of(event.from, (event.time, false), &event.before)[index])
        }
        Moment::Leave { mode, last } => {
            let event = pick(events(moment, motion), last).ok_or(Missing::NeverLeft(mode))?;
            Ok(sampler.of(event.from, (event.time, false), &event.before)[index])
        }
    }
}

/// How often a moment comes.
pub(super) fn count(moment: Moment, motion: &Motion) -> f64 {
    match moment {
        Moment::Start | Moment::End => 1.0,
        _ => events(moment, motion).count() as f64,
    }
}

fn pick<'a>(mut events: impl Iterator<Item = &'a Happened>, last: bool) -> Option<&'a Happened> {
    match last {
        true => events.last(),
        false => events.next(),
    }
}

/// The events that enter or leave a mode, or have a name. One that leads back into its own mode enters and leaves none.
fn events(moment: Moment, motion: &Motion) -> impl Iterator<Item = &Happened> {
    motion.events.iter().filter(move |event| {
        let leads_on = event.from != event.to;
        match moment {
            Moment::Enter { mode, .. } => leads_on && event.to == mode,
            Moment::Leave { mode, .. } => leads_on && event.from == mode,
            Moment::Before { event: named, .. } | Moment::After { event: named, .. } => {
                named.places.contains(&(event.from, event.event))
            }
            Moment::Start | Moment::End | Moment::Passes { .. } => false,
        }
    })
}
