//! All motions that attract at each of many values: from the start of the scene, from starts made at random about the motion
//! that it leads to, and from those that attract at the neighbouring values, from below and from above.
//!
//! No finite number of starts finds everything that attracts; what is found does attract. Where no motion repeats, that from a
//! start is irregular if small disturbances grow in it, and all irregular motions at a value count as one.

use std::sync::Arc;

use assur_solvers::answer::{Error, Motion, Question, Settings};
use assur_solvers::hybrid::{CycleError, HybridError};
use assur_solvers::measure::{self, Missing};
use assur_solvers::model::Model;
use assur_solvers::problem::Span;
use assur_solvers::shape::Subject;
use assur_solvers::tolerance::Random;

use super::each;
use crate::registry::Bind;

/// Starts made at random lie so many amplitudes about the middle of the motion that the scene leads to.
const WIDE: f64 = 2.0;
/// Motions whose states are nearer to each other, over their amplitudes, are one.
const SAME: f64 = 1e-4;
/// Periods for which an irregular motion settles, and over which it is measured.
const IRREGULAR: (f64, f64) = (200.0, 200.0);

/// A mode and a state.
type Place = (usize, Vec<f64>);

/// A motion that attracts.
#[derive(Clone, Debug)]
pub struct Attractor {
    /// Periods after which it repeats; none if it is irregular.
    pub periods: Option<usize>,
    /// By what factor small disturbances change in a period of what drives it; below 1 where it attracts by more than nothing.
    pub growth: f64,
    /// The largest Lyapunov exponent, 1/s.
    pub exponent: f64,
    /// The measures over its periods; of an irregular motion over many.
    pub measures: Vec<Result<f64, Missing>>,
    /// How many of the starts lead to it.
    pub starts: usize,
    /// Where it is at the beginning of each period.
    places: Vec<Place>,
    /// Amplitudes of its states.
    sizes: Vec<f64>,
    /// After what time it repeats.
    length: f64,
}

/// What attracts at a value.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// The motions, that from the start of the scene first.
    pub attractors: Vec<Attractor>,
    /// Starts that were tried.
    pub starts: usize,
    /// Why a start leads to none of them, for each that does not.
    pub lost: Vec<String>,
}

/// How to look.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a> {
    /// Starts made at random at each value.
    pub starts: usize,
    /// Which: the same seed gives the same ones.
    pub seed: u64,
    /// How motions are found.
    pub settings: &'a Settings,
    /// Number of threads, zero for as many as the machine has.
    pub threads: usize,
}

/// Finds what attracts at each of some sets of values (SI units), of which each is near the next. `progress` hears of each set
/// that is done, three times: from its own starts, from those below and from those above.
pub fn attractors(
    bind: &Bind,
    values: &[Vec<f64>],
    look: Look<'_>,
    progress: &(dyn Fn(u64) + Sync),
) -> Vec<Found> {
    let mut all = each(values.len(), look.threads, progress, &|index| {
        let mut found = Found::default();
        match bind.motion(&values[index]) {
            Ok(model) => found.begin(&model.into(), look, index),
            Err(refused) => found.lost.push(refused.to_string()),
        }
        found
    });
    let up: Vec<usize> = (1..values.len()).collect();
    let down: Vec<usize> = (0..values.len().saturating_sub(1)).rev().collect();
    for (order, from) in [(up, -1), (down, 1)] {
        progress(1);
        for index in order {
            let beside = &all[index.wrapping_add_signed(from)];
            let places: Vec<Place> =
                beside.attractors.iter().filter_map(|one| one.places.first().cloned()).collect();
            if let Ok(model) = bind.motion(&values[index]) {
                let model: Arc<dyn Model> = model.into();
                for place in places {
                    all[index].from(&model, Some(place), look.settings);
                }
            }
            progress(1);
        }
    }
    all
}

impl Found {
    /// From the start of the scene, and from starts made at random about the motion that it leads to.
    fn begin(&mut self, model: &Arc<dyn Model>, look: Look<'_>, index: usize) {
        self.from(model, None, look.settings);
        let Some(first) = self.attractors.first() else { return };
        let (sizes, place) = (first.sizes.clone(), first.places[0].clone());
        let mut random = Random::new(look.seed, (index * look.starts * sizes.len()) as u64);
        for _ in 0..look.starts {
            let about = place.1.iter().zip(&sizes);
            let state = about.map(|(at, size)| at + WIDE * size * (2.0 * random.uniform() - 1.0));
            let state = state.collect();
            self.from(model, Some((place.0, state)), look.settings);
        }
    }

    /// Takes up the motion to which a start leads.
    fn from(&mut self, model: &Arc<dyn Model>, start: Option<Place>, settings: &Settings) {
        self.starts += 1;
        match attracted(model, start, settings) {
            Ok(found) => match self.attractors.iter_mut().find(|one| one.is(&found)) {
                Some(known) => known.starts += 1,
                None => self.attractors.push(found),
            },
            Err(reason) => self.lost.push(reason),
        }
    }
}

/// The motion to which a start leads.
fn attracted(
    model: &Arc<dyn Model>,
    start: Option<Place>,
    settings: &Settings,
) -> Result<Attractor, String> {
    let question = || {
        let question = Question::of(model.clone());
        match &start {
            Some((mode, state)) => question.in_mode(*mode).from(state.clone()),
            None => question,
        }
    };
    let mut solved = question().solve(settings);
    if let (Some((first, state)), Err(error)) = (&start, &solved)
        && begins_elsewhere(error)
    {
        // The state is one of another mode.
        let modes = (0..model.shape().modes.len()).filter(|mode| mode != first);
        let others =
            modes.map(|mode| Question::of(model.clone()).in_mode(mode).from(state.clone()));
        let mut others = others.map(|question| question.solve(settings));
        let other = others.find(|one| !one.as_ref().is_err_and(begins_elsewhere));
        solved = other.unwrap_or(solved);
    }
    match solved {
        Ok(motion) => Attractor::repeating(&motion).ok_or_else(|| Error::NoTask.to_string()),
        Err(Error::NoCycle(error)) => match (&*error, model.span()) {
            (CycleError::NoneStable { growth, .. }, Span::Periodic(period)) if *growth > 1.0 => {
                let settled = question().until(IRREGULAR.0 * period).solve(settings);
                let settled = settled.map_err(|error| error.to_string())?;
                let (mode, state) = settled.place(IRREGULAR.0 * period);
                let goes_on = Question::of(model.clone()).in_mode(mode).from(state);
                let motion = goes_on.until(IRREGULAR.1 * period).solve(settings);
                let motion = motion.map_err(|error| error.to_string())?;
                Ok(Attractor::irregular(&motion, *growth, period))
            }
            _ => Err(error.to_string()),
        },
        Err(error) => Err(error.to_string()),
    }
}

/// Whether a motion cannot begin in its mode.
fn begins_elsewhere(error: &Error) -> bool {
    match error {
        Error::Stopped(error) => matches!(error, HybridError::Start { .. }),
        Error::NoCycle(error) => match &**error {
            CycleError::Motion(error) => matches!(**error, HybridError::Start { .. }),
            _ => false,
        },
        _ => false,
    }
}

impl Attractor {
    fn repeating(motion: &Motion) -> Option<Self> {
        let length = motion.length()?;
        let multiple = motion.multiple();
        let period = length / multiple as f64;
        let largest = motion.multipliers().first().map_or(0.0, |one| one.modulus());
        Some(Self {
            periods: Some(multiple),
            growth: largest.powf(1.0 / multiple as f64),
            exponent: largest.ln() / length,
            places: (0..multiple).map(|one| motion.place(one as f64 * period)).collect(),
            ..Self::of(motion, length)
        })
    }

    fn irregular(motion: &Motion, growth: f64, period: f64) -> Self {
        Self {
            periods: None,
            growth,
            exponent: growth.ln() / period,
            ..Self::of(motion, IRREGULAR.1 * period)
        }
    }

    /// What both have in common.
    fn of(motion: &Motion, length: f64) -> Self {
        let states: Vec<Subject> = (0..motion.shape().states.len()).map(Subject::State).collect();
        let extremes = motion.extremes(&states, measure::ALWAYS);
        let size = |one: &measure::Extremes| (one.highest.value - one.lowest.value) / 2.0;
        Self {
            periods: None,
            growth: f64::NAN,
            exponent: f64::NAN,
            measures: motion.measures(),
            starts: 1,
            places: vec![motion.place(0.0)],
            sizes: extremes.iter().map(size).collect(),
            length,
        }
    }

    /// Whether another motion is this one, perhaps some periods later. Where nothing drives a motion it may be anywhere on its
    /// way: then all of its measures agree, and the time after which it repeats.
    fn is(&self, other: &Self) -> bool {
        if self.periods != other.periods {
            return false;
        }
        if self.periods.is_none() {
            return true;
        }
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs());
        if !same(self.length, other.length) {
            return false;
        }
        let near = |place: &Place| {
            let states = place.1.iter().zip(&other.places[0].1).zip(&self.sizes);
            place.0 == other.places[0].0 && { states }
                .all(|((a, b), size)| (a - b).abs() <= SAME * size.max(f64::MIN_POSITIVE))
        };
        let measured = || {
            let pairs = self.measures.iter().zip(&other.measures);
            !self.measures.is_empty() && { pairs }.all(|pair| match pair {
                (Ok(a), Ok(b)) => same(*a, *b) || (a - b).abs() < SAME,
                (a, b) => a.is_err() && b.is_err(),
            })
        };
        self.places.iter().any(near) || measured()
    }
}
