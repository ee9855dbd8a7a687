//! What accuracy costs of how an output errs by the tolerances: mean and standard deviation of its error, to first and to
//! second order and by linkages made at random.
//!
//! A standard deviation differs from that of another error by no more than the root of the mean square of their difference,
//! and so does a mean. That says how well the second order is known, which is the reference unless linkages made at random tell
//! more, or some of them do not assemble.

use std::hint::black_box;
use std::time::Instant;

use assur_solvers::closure::AnyLinkage;
use assur_solvers::tolerance::{Sampling, Study, ToleranceError, linear};

use super::times::{Times, in_turns};

/// Linkages made at random of each trial.
const SAMPLES: [u64; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];
/// Those of a reference, and over which the orders are looked at.
const MOST: u64 = 4_000_000;
const COMPARED: u64 = 10_000;
/// Seeds of the trials and of a reference.
const SEEDS: (u64, u64) = (1, 2);

/// A way to find them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// By the influence coefficients.
    First,
    /// With their slopes.
    Second,
    /// From so many linkages made at random.
    Made(u64),
}

/// What a way gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Mean of the error, SI units.
    pub mean: f64,
    /// Standard deviation of the error.
    pub deviation: f64,
    /// By how much both may be off for want of linkages, with 95 % confidence; zero where none are made.
    pub confidence: f64,
}

/// One way, what it takes and gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// The way.
    pub way: Way,
    /// What it gives.
    pub found: Found,
    /// Its error, the larger one of mean and standard deviation; of linkages made at random at least their confidence, as luck is
    /// no accuracy. SI units.
    pub error: f64,
    /// How long it takes.
    pub times: Times,
}

/// All of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// What errors are differences from.
    pub reference: (Way, Found),
    /// By how much that is not known, SI units.
    pub doubt: f64,
    /// What was tried.
    pub trials: Vec<Trial>,
    /// Rounds of times.
    pub rounds: usize,
}

impl Way {
    /// Finds mean and standard deviation at the one place of a study.
    ///
    /// # Errors
    /// [`ToleranceError`].
    pub fn find(
        self,
        linkage: &dyn AnyLinkage,
        study: &Study,
        seed: u64,
    ) -> Result<Found, ToleranceError> {
        match self {
            Self::First => {
                let found = linear(&linkage.influences(study)?, &study.sources)?;
                Ok(Found { mean: 0.0, deviation: found[0].deviation, confidence: 0.0 })
            }
            Self::Second => {
                let moments = linkage.quadratics(study)?[0].moments(&study.sources);
                let (mean, deviation) = (moments.mean, moments.deviation);
                Ok(Found { mean, deviation, confidence: 0.0 })
            }
            Self::Made(samples) => {
                let sampling =
                    Sampling { samples, seed, levels: Vec::new(), ..Sampling::default() };
                let made = linkage.monte_carlo(study, &sampling, &|_| ())?;
                let (mean, deviation) = (made.places[0].mean, made.places[0].deviation);
                let confidence = [mean, deviation].map(|one| (one.high - one.low) / 2.0);
                let confidence = f64::max(confidence[0], confidence[1]);
                Ok(Found { mean: mean.value, deviation: deviation.value, confidence })
            }
        }
    }
}

/// Finds what accuracy costs at the one place of a study. `progress` hears of each way; it says whether to go on.
///
/// # Errors
/// [`ToleranceError`].
pub fn made(
    linkage: &dyn AnyLinkage,
    study: &Study,
    seconds: f64,
    progress: &dyn Fn() -> bool,
) -> Result<Made, ToleranceError> {
    let differences = linkage.differences(study, COMPARED, SEEDS.1)?[0];
    let second = Way::Second.find(linkage, study, SEEDS.1)?;
    let quick = Way::Made(COMPARED).find(linkage, study, SEEDS.1)?;
    let expected = quick.confidence * (COMPARED as f64 / MOST as f64).sqrt();
    let (reference, doubt) = match differences.failed == 0 && differences.quadratic.rms < expected {
        true => ((Way::Second, second), differences.quadratic.rms),
        false => {
            let made = Way::Made(MOST).find(linkage, study, SEEDS.1)?;
            ((Way::Made(MOST), made), made.confidence)
        }
    };
    let exact = reference.1;
    let ways = [Way::First, Way::Second].into_iter().chain(SAMPLES.map(Way::Made));
    let (mut tried, mut first) = (Vec::new(), Vec::new());
    for way in ways {
        let clock = Instant::now();
        let found = way.find(linkage, study, SEEDS.0)?;
        first.push(clock.elapsed().as_secs_f64());
        let off = (found.mean - exact.mean).abs().max((found.deviation - exact.deviation).abs());
        tried.push((way, found, off.max(found.confidence)));
        if !progress() {
            break;
        }
    }
    let again = |index: usize| {
        let _ = black_box(tried[index].0.find(linkage, study, SEEDS.0));
    };
    let (times, rounds) = in_turns(&first, seconds, &again, progress);
    let trials = tried.iter().zip(times);
    let trials = trials.map(|(&(way, found, error), times)| Trial { way, found, error, times });
    Ok(Made { reference, doubt, trials: trials.collect(), rounds })
}
