//! Where free motions repeat with what drives them, and where they grow, over a range of one value.
//!
//! The Floquet multipliers are followed over the range, in steps so small that each is known again. Where one comes nearest to 1
//! there is a resonance, where it comes nearest to -1 a free motion repeats after two periods; both, and where two multipliers
//! meet, are where motions may begin to grow (V. A. Yakubovich, V. M. Starzhinskii, Linear Differential Equations with Periodic
//! Coefficients, 1975). A range in which they grow may be far narrower than any step, so these places are looked at.

mod nearest;
mod track;

use assur_solvers::answer::{Error, Question, Settings};
use assur_solvers::periodic::Multiplier;
use assur_solvers::problem::Span;

use super::each;
use crate::registry::Bind;
use track::Track;

/// Nearer than this to 1 or -1 a multiplier counts as there, or two as one.
pub const NEAR: f64 = 0.1;
/// By more than this, and than its error, a modulus exceeds 1 where motions grow.
pub const GROWTH: f64 = 1e-6;
/// Part of a value to which the ends of a range are found in which motions grow.
const END: f64 = 1e-10;

/// The multipliers at a value.
#[derive(Clone, Debug)]
pub struct Spectrum {
    /// The value, SI units.
    pub value: f64,
    /// The multipliers.
    pub multipliers: Vec<Multiplier>,
    /// Periods after which the motion repeats, and over which the multipliers are.
    pub periods: usize,
}

/// What a multiplier meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meets {
    /// 1: the free motion repeats with what drives it, a resonance.
    One,
    /// -1: the free motion repeats after twice the time.
    MinusOne,
    /// Another multiplier.
    Another,
}

/// Where a multiplier is nearest to what it meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resonance {
    /// The value, SI units.
    pub value: f64,
    /// How well it is known, SI units.
    pub error: f64,
    /// What is met.
    pub meets: Meets,
    /// How near.
    pub distance: f64,
    /// The multiplier there.
    pub multiplier: Multiplier,
    /// The largest modulus of all multipliers there.
    pub growth: f64,
}

/// A range in which motions grow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unstable {
    /// Its ends, SI units.
    pub range: (f64, f64),
    /// Whether the range that was looked at ends before.
    pub is_cut: (bool, bool),
    /// The largest modulus of the multipliers that was found in it.
    pub growth: f64,
    /// At what value.
    pub at: f64,
}

/// What a range has.
#[derive(Clone, Debug)]
pub struct Resonances {
    /// Where multipliers come nearer than [`NEAR`] to 1 or -1, and where two meet and grow; in the order of the values.
    pub all: Vec<Resonance>,
    /// The smallest distance of a multiplier from 1, and at what value.
    pub nearest: (f64, f64),
    /// Where motions grow.
    pub unstable: Vec<Unstable>,
    /// All multipliers that were computed on the way, in the order of the values.
    pub spectra: Vec<Spectrum>,
    /// Values between which multipliers could not be followed, as they change too fast or are not known.
    pub gaps: Vec<(f64, f64)>,
    /// Why there are none at a value, for each that has none.
    pub lost: Vec<(f64, String)>,
}

/// The multipliers of a scene with these values (SI units), `value` being the one that is gone through.
///
/// # Errors
/// Why there are none, with the figures.
pub fn spectrum(
    bind: &Bind,
    values: &[f64],
    value: f64,
    settings: &Settings,
) -> Result<Spectrum, String> {
    let model = bind.motion(values).map_err(|refused| refused.to_string())?;
    let question = Question::of(model.into());
    let found = match question.model().span() {
        Span::Periodic(_) | Span::Autonomous => question.multipliers(settings),
        _ => Err(Error::NoTask),
    };
    let (multipliers, periods) = found.map_err(|error| error.to_string())?;
    Ok(Spectrum { value, multipliers, periods })
}

/// Follows the multipliers through these values, at first in these steps. `progress` hears
/// of some four parts of the work for each of these.
pub fn resonances(
    at: &(dyn Fn(f64) -> Result<Spectrum, String> + Sync),
    values: &[f64],
    threads: usize,
    progress: &(dyn Fn(u64) + Sync),
) -> Resonances {
    let track = Track::follow(at, values, threads, progress);
    let sections = track.sections();
    // As much again as the values have taken.
    let share = |index: usize| (2 * index * values.len() / sections.len()) as u64;
    let found = each(sections.len(), threads, &|_| {}, &|index| {
        let found = nearest::find(at, &sections[index]);
        progress(share(index + 1) - share(index));
        found
    });
    let mut spectra: Vec<&Spectrum> = track.spectra.iter().collect();
    spectra.extend(found.iter().flatten().map(|(_, spectrum)| spectrum));
    spectra.sort_by(|a, b| a.value.total_cmp(&b.value));
    let unstable = unstable(at, &spectra);
    let mut all: Vec<Resonance> = found.iter().flatten().map(|(one, _)| *one).collect();
    all.sort_by(|a, b| a.value.total_cmp(&b.value));
    all.dedup_by(|a, b| a.meets == b.meets && a.value - b.value <= 4.0 * (a.error + b.error));
    let grows = |one: &Resonance| one.growth > 1.0 + GROWTH.max(one.multiplier.error);
    all.retain(|one| one.distance <= NEAR && (one.meets != Meets::Another || grows(one)));
    let distances = spectra.iter().map(|one| {
        let distances = one.multipliers.iter().map(Multiplier::distance);
        (distances.fold(f64::INFINITY, f64::min), one.value)
    });
    let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0));
    Resonances {
        all,
        nearest: nearest.unwrap_or((f64::NAN, f64::NAN)),
        unstable,
        gaps: track.gaps,
        lost: track.lost,
        spectra: track.spectra,
    }
}

impl Spectrum {
    /// The largest modulus, a period.
    pub fn growth(&self) -> f64 {
        let largest = self.multipliers.iter().map(Multiplier::modulus).fold(0.0, f64::max);
        largest.powf(1.0 / self.periods as f64)
    }

    /// Whether motions grow by more than what is not known.
    pub fn grows(&self) -> bool {
        let exceeds = |one: &Multiplier| one.modulus() > 1.0 + GROWTH.max(2.0 * one.error);
        self.multipliers.iter().any(exceeds)
    }
}

/// The ranges in which motions grow, of neighbouring values.
fn unstable(
    at: &(dyn Fn(f64) -> Result<Spectrum, String> + Sync),
    spectra: &[&Spectrum],
) -> Vec<Unstable> {
    let mut found = Vec::new();
    let mut index = 0;
    while index < spectra.len() {
        let length = spectra[index..].iter().take_while(|one| one.grows()).count();
        if length == 0 {
            index += 1;
            continue;
        }
        let inside = &spectra[index..index + length];
        let end = |place: Option<usize>, inside: f64| {
            place
                .and_then(|place| spectra.get(place))
                .map_or(inside, |outside| onset(at, outside.value, inside))
        };
        let before = index.checked_sub(1);
        let largest = inside.iter().max_by(|a, b| a.growth().total_cmp(&b.growth()));
        let largest = largest.unwrap_or(&inside[0]);
        found.push(Unstable {
            range: (
                end(before, inside[0].value),
                end(Some(index + length), inside[length - 1].value),
            ),
            is_cut: (before.is_none(), index + length == spectra.len()),
            growth: largest.growth(),
            at: largest.value,
        });
        index += length;
    }
    found
}

/// Where motions begin to grow between a value at which they do not and one at which they do.
fn onset(
    at: &(dyn Fn(f64) -> Result<Spectrum, String> + Sync),
    mut outside: f64,
    mut inside: f64,
) -> f64 {
    while (inside - outside).abs() > END * inside.abs().max(outside.abs()) {
        let middle = 0.5 * (outside + inside);
        match at(middle) {
            Ok(found) if found.grows() => inside = middle,
            Ok(_) => outside = middle,
            Err(_) => break,
        }
    }
    0.5 * (outside + inside)
}

#[cfg(test)]
mod tests;
