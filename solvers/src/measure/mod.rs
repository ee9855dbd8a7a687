//! Numbers of a whole run: peaks, means, durations, values at events, harmonics.
//!
//! A measure looks at the continuous solution between the steps, not at samples of it: extremes lie where the slope is zero, to
//! the last digits that this leaves, integrals are taken by a Gauss–Kronrod rule on every step and halved until
//! both its orders agree, and where a condition begins and ends to hold is bisected to neighbouring numbers. Every
//! stretch between events is looked at in its own mode up to its very ends, so that a force that jumps at an event has
//! both its values.
//!
//! Each step is looked at in eight parts, and in halves where every second of these points does not say where the others are;
//! what lies within one of them is found as long as it shows there: as a change of sign or as a point that its neighbours
//! surround. The steps of an integration are short against whatever the motion does; a function of the time alone that the
//! motion does not feel, and that is zero to all digits at all these points, is not seen.

mod extreme;
mod grid;
mod harmonic;
mod moment;
mod passage;
mod primitive;
mod quadrature;
mod straight;
mod travel;
mod window;

pub use crate::shape::{Kind, Moment, NamedEvent, Primitive};
pub use assur_functions::Sense;
pub use extreme::{Extreme, Extremes};
pub use grid::Probe;
pub use primitive::Missing;

use crate::hybrid::Motion;
use crate::model::{Bound, Model};
use crate::periodic::Multiplier;
use crate::problem::Scene;
use crate::rest::Vibration;
use crate::shape::Shape;
use extreme::Hunt;
use grid::Sampler;

/// From the begin of a run to its end.
pub const ALWAYS: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
/// Parts of a step at whose ends quantities are looked at.
const GRID: usize = 8;

/// Finds numbers of a run.
///
/// `sample` gives the quantities that the primitives speak of (by index) in a mode at a time and state; `count` is
/// their number. The results are in the order of the primitives, SI units.
pub fn find(
    motion: &Motion,
    primitives: &[Primitive],
    count: usize,
    sample: &Probe<'_>,
) -> Vec<Result<f64, Missing>> {
    let mut sampler = Sampler::new(motion, count, sample);
    let tallies = primitives.iter().map(primitive::Tally::new);
    let mut tallies: Vec<_> = tallies.collect();
    sampler.walk(ALWAYS, &mut |grid, sampler| {
        for (primitive, tally) in primitives.iter().zip(&mut tallies) {
            tally.add(primitive, grid, sampler);
        }
    });
    let found = primitives.iter().zip(tallies);
    found
        .map(|(primitive, tally)| {
            let value = match primitive.kind {
                Kind::Value(Moment::Passes { .. }) | Kind::Count(Moment::Passes { .. }) => {
                    tally.result(primitive, &mut sampler)?
                }
                Kind::Value(moment) => moment::value(moment, primitive.argument, &mut sampler)?,
                Kind::Count(moment) => moment::count(moment, motion),
                Kind::Frequency(number) => vibration(motion, number)?.frequency(),
                Kind::Damping(number) => vibration(motion, number)?.damping(),
                kind => match of_multipliers(kind) {
                    Some(asked) => multiplier(motion, asked)?.0,
                    None => tally.result(primitive, &mut sampler)?,
                },
            };
            match value.is_finite() {
                true => Ok(value),
                false => Err(Missing::NotFinite),
            }
        })
        .collect()
}

/// The times between which a quantity, by its index, is positive along a run.
pub fn stretches(
    motion: &Motion,
    quantity: usize,
    count: usize,
    sample: &Probe<'_>,
) -> Vec<(f64, f64)> {
    let mut sampler = Sampler::new(motion, count, sample);
    let mut all: Vec<(f64, f64)> = Vec::new();
    sampler.walk(ALWAYS, &mut |grid, sampler| {
        for (from, to) in window::windows(Some(quantity), grid, sampler) {
            match all.last_mut().filter(|last| last.1 == from) {
                Some(last) => last.1 = to,
                None => all.push((from, to)),
            }
        }
    });
    all
}

/// The first and the last time at which a quantity, by its index, passes zero along a run; none where it does not.
pub fn passages(
    motion: &Motion,
    quantity: usize,
    count: usize,
    sample: &Probe<'_>,
) -> Option<(f64, f64)> {
    let mut sampler = Sampler::new(motion, count, sample);
    let mut passages = passage::Passages::default();
    sampler.walk(ALWAYS, &mut |grid, sampler| passages.look(quantity, grid, sampler));
    let ((_, first), (_, last)) = passages.finish().1?;
    Some((first, last))
}

/// A vibration about a position of rest.
fn vibration(motion: &Motion, number: u32) -> Result<&Vibration, Missing> {
    let rest = motion.rest.as_ref().ok_or(Missing::Moves)?;
    rest.vibration(number as usize).ok_or_else(|| {
        let vibrations = rest.vibrations.iter().filter(|one| one.vibrates());
        Missing::NoVibration { number, count: vibrations.count() }
    })
}

/// What is asked of Floquet multipliers: which number of one, by its rank, and whether the least one is the first.
type OfMultipliers = (u32, fn(&Multiplier) -> f64, bool);

/// What a primitive asks of them; none if it asks something else.
fn of_multipliers(kind: Kind) -> Option<OfMultipliers> {
    match kind {
        Kind::Multiplier(rank) => Some((rank, Multiplier::modulus, false)),
        Kind::Detuning(rank) => Some((rank, Multiplier::distance, true)),
        _ => None,
    }
}

/// That number, with its error.
fn multiplier(motion: &Motion, (rank, of, rises): OfMultipliers) -> Result<(f64, f64), Missing> {
    let all = motion.multipliers.iter();
    let mut all: Vec<_> = all.map(|multiplier| (of(multiplier), multiplier.error)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    if !rises {
        all.reverse();
    }
    let count = all.len();
    let found = all.get((rank as usize).wrapping_sub(1)).copied();
    found.ok_or(Missing::NoMultiplier { number: rank, count })
}

/// Smallest and largest value between two times of a run, of each quantity that `sample` gives, `count` of them; SI units. None
/// where there is no time between.
pub fn extremes(
    motion: &Motion,
    times: (f64, f64),
    count: usize,
    sample: &Probe<'_>,
) -> Vec<Option<Extremes>> {
    let mut sampler = Sampler::new(motion, count, sample);
    let hunt = |index| [Sense::Smallest, Sense::Largest].map(|sense| Hunt::new(index, sense));
    let mut hunts: Vec<_> = (0..count).map(hunt).collect();
    sampler.walk(times, &mut |grid, sampler| {
        for hunt in hunts.iter_mut().flatten() {
            hunt.look(grid.ends(), grid, sampler);
        }
    });
    let found = hunts.into_iter().map(|[lowest, highest]| {
        let (lowest, low_rivals) = lowest.finish(&mut sampler)?;
        let (highest, high_rivals) = highest.finish(&mut sampler)?;
        Some(Extremes { lowest, highest, low_rivals, high_rivals })
    });
    found.collect()
}

/// The lowest and the highest value of each quantity near the windows in which they lie in another motion of the same task. None
/// where a window has no time in it.
pub fn extremes_near(
    motion: &Motion,
    windows: &[[(f64, f64); 2]],
    sample: &Probe<'_>,
) -> Vec<[Option<Extreme>; 2]> {
    let mut sampler = Sampler::new(motion, windows.len(), sample);
    let hunt = |index| [Sense::Smallest, Sense::Largest].map(|sense| Hunt::new(index, sense));
    let mut hunts: Vec<_> = (0..windows.len()).flat_map(hunt).collect();
    let windows: Vec<_> = windows.iter().flatten().copied().collect();
    for together in union(&windows) {
        sampler.walk(together, &mut |grid, sampler| {
            let (from, to) = grid.ends();
            for (hunt, window) in hunts.iter_mut().zip(&windows) {
                if from < window.1 && to > window.0 {
                    hunt.look((from, to), grid, sampler);
                }
            }
        });
    }
    let mut found = hunts.into_iter().map(|hunt| Some(hunt.finish(&mut sampler)?.0));
    (0..windows.len() / 2).map(|_| [found.next().flatten(), found.next().flatten()]).collect()
}

/// Stretches that cover the same times without overlapping.
fn union(stretches: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted = stretches.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut all: Vec<(f64, f64)> = Vec::new();
    for (from, to) in sorted {
        match all.last_mut() {
            Some(last) if from <= last.1 => last.1 = last.1.max(to),
            _ => all.push((from, to)),
        }
    }
    all
}

/// The measures of a run: what `measures` makes of the primitives that are found. A measure that needs one which the
/// run does not have says why it is missing.
pub fn all(
    motion: &Motion,
    shape: &Shape,
    sample: &Probe<'_>,
    measures: &dyn Fn(&[f64], &mut [f64]),
) -> Vec<Result<f64, Missing>> {
    made(shape, &find(motion, shape.primitives, shape.measured, sample), measures)
}

/// The measures that `measures` makes of primitives.
pub(crate) fn made(
    shape: &Shape,
    found: &[Result<f64, Missing>],
    measures: &dyn Fn(&[f64], &mut [f64]),
) -> Vec<Result<f64, Missing>> {
    let measures = shape.uses.iter().zip(of_primitives(shape, found, measures));
    measures
        .map(|(uses, value)| {
            if let Some(missing) = uses.iter().find_map(|index| found[*index].err()) {
                return Err(missing);
            }
            match value.is_finite() {
                true => Ok(value),
                false => Err(Missing::NotFinite),
            }
        })
        .collect()
}

/// By how much each measure of a run differs where one of its primitives is off by a part of itself, a multiplier besides by its
/// error, for the one that makes the most of it.
pub fn disturbed(
    motion: &Motion,
    shape: &Shape,
    sample: &Probe<'_>,
    measures: &dyn Fn(&[f64], &mut [f64]),
    part: f64,
) -> Vec<f64> {
    let mut found = find(motion, shape.primitives, shape.measured, sample);
    let right = of_primitives(shape, &found, measures);
    let mut most = vec![0.0; right.len()];
    for index in 0..found.len() {
        let Ok(value) = found[index] else { continue };
        let asked = of_multipliers(shape.primitives[index].kind);
        let own = asked.and_then(|asked| multiplier(motion, asked).ok()).map_or(0.0, |one| one.1);
        found[index] = Ok(value * (1.0 + part) + own);
        let other = of_primitives(shape, &found, measures);
        for ((most, right), other) in most.iter_mut().zip(&right).zip(other) {
            *most = f64::max(*most, (right - other).abs());
        }
        found[index] = Ok(value);
    }
    most
}

/// The measures, not a number where a primitive is missing.
fn of_primitives(
    shape: &Shape,
    found: &[Result<f64, Missing>],
    measures: &dyn Fn(&[f64], &mut [f64]),
) -> Vec<f64> {
    let numbers: Vec<f64> = found.iter().map(|one| one.unwrap_or(f64::NAN)).collect();
    let mut values = vec![0.0; shape.uses.len()];
    measures(&numbers, &mut values);
    values
}

/// The measures of a run of a scene, in the order of its file, SI units.
pub fn of<C: Scene>(scene: &C, motion: &Motion) -> Vec<Result<f64, Missing>> {
    let model: &dyn Model = &Bound::new(scene);
    model.measure(motion)
}

#[cfg(test)]
mod tests;
