//! Error bands to first order.
//!
//! An output errs by `Σ K_p δ_p`. At the worst all errors have the sign of their coefficient: `Σ |K_p| T_p`. Independent
//! errors add up by their variances: `σ² = Σ K_p² σ_p²`.

use super::influence::Influences;
use crate::tolerance::error::ToleranceError;
use crate::tolerance::source::{Source, check_sources};

/// The error of an output at one place, to first order.
#[derive(Clone, Debug, PartialEq)]
pub struct Linear {
    /// The output without any error.
    pub value: f64,
    /// Greatest error.
    pub worst: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// What each source contributes, in their order.
    pub contributions: Vec<Contribution>,
}

/// What one source contributes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// Influence coefficient of its variable.
    pub influence: f64,
    /// Greatest error by it alone.
    pub worst: f64,
    /// Standard deviation by it alone.
    pub deviation: f64,
    /// Share of the greatest error.
    pub share: f64,
    /// Share of the variance.
    pub variance_share: f64,
}

/// How a source ranks over all places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rank {
    /// Index of the source.
    pub source: usize,
    /// Mean share of the greatest error.
    pub mean: f64,
    /// Largest share of it.
    pub largest: f64,
    /// Place of that.
    pub place: usize,
}

/// The error at every place.
///
/// # Errors
/// [`ToleranceError`] if the sources make no sense.
pub fn linear(influences: &Influences, sources: &[Source]) -> Result<Vec<Linear>, ToleranceError> {
    check_sources(sources, influences.variables)?;
    let places = 0..influences.places();
    Ok(places
        .map(|place| at_place(influences.values[place], influences.at(place), sources))
        .collect())
}

fn at_place(value: f64, influence: &[f64], sources: &[Source]) -> Linear {
    let alone = sources.iter().map(|source| {
        let influence = influence[source.variable];
        Contribution {
            influence,
            worst: influence.abs() * source.half_width,
            deviation: influence.abs() * source.deviation(),
            share: 0.0,
            variance_share: 0.0,
        }
    });
    let mut contributions: Vec<Contribution> = alone.collect();
    let worst: f64 = contributions.iter().map(|one| one.worst).sum();
    let variance: f64 = contributions.iter().map(|one| one.deviation.powi(2)).sum();
    for one in &mut contributions {
        one.share = share(one.worst, worst);
        one.variance_share = share(one.deviation.powi(2), variance);
    }
    Linear { value, worst, deviation: variance.sqrt(), contributions }
}

/// Nothing has no share in nothing.
fn share(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.0 }
}

/// The sources by their mean share of the greatest error over all places, the largest first.
pub fn ranking(places: &[Linear]) -> Vec<Rank> {
    let sources = places.first().map_or(0, |one| one.contributions.len());
    let mut ranks: Vec<Rank> = (0..sources).map(|source| rank(places, source)).collect();
    ranks.sort_by(|a, b| b.mean.total_cmp(&a.mean));
    ranks
}

fn rank(places: &[Linear], source: usize) -> Rank {
    let shares = places.iter().map(|one| one.contributions[source].share);
    let mean = shares.clone().sum::<f64>() / places.len() as f64;
    let mut rank = Rank { source, mean, largest: f64::NEG_INFINITY, place: 0 };
    for (place, share) in shares.enumerate() {
        if share > rank.largest {
            (rank.largest, rank.place) = (share, place);
        }
    }
    rank
}

/// The place with the greatest error.
pub fn worst_place(places: &[Linear]) -> usize {
    let greater = |best: usize, place: usize| match places[place].worst > places[best].worst {
        true => place,
        false => best,
    };
    (0..places.len()).fold(0, greater)
}
