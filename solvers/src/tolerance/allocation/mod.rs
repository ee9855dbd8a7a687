//! Tolerances of least cost that keep an output within a band over the whole way of the drivers.
//!
//! A tolerance `t` costs `a + b/t^k`. The band is kept at a few places by a conic programme ([`cone`]); then the greatest
//! errors along the way are sought, between the places too ([`way`]), and are added until none exceeds the band.

mod band;
mod cone;
mod error;
#[cfg(test)]
mod tests;

pub use error::AllocationError;

use super::order::influence::influence_at;
use super::source::{Study, check_variables};
use crate::closure::{AnyLinkage, Linkage};
use crate::shape::Distribution;
use band::{Band, Influence, Peak};

/// Relative excess over the band that is taken off the tolerances afterwards.
const EXCESS: f64 = 1e-7;
/// Largest number of programmes.
const ROUNDS: usize = 30;
/// A tolerance this near to a limit, relatively, lies on it.
const ON_LIMIT: f64 = 1e-6;

/// What a tolerance `t` costs: `fixed + factor/t^exponent`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// What it costs however wide it is.
    pub fixed: f64,
    /// Cost of a tolerance of one, in SI units to the exponent.
    pub factor: f64,
    /// How fast it grows as the tolerance falls: 1 for a reciprocal cost.
    pub exponent: f64,
}

/// A tolerance that is to be chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Index of its variable.
    pub variable: usize,
    /// How the sizes will be distributed.
    pub distribution: Distribution,
    /// What it costs.
    pub cost: Cost,
    /// Lower limit.
    pub least: f64,
    /// Upper limit; may be infinite.
    pub most: f64,
}

/// How the error of the output is reckoned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// All errors at their worst, `Σ |K| t`.
    Worst,
    /// The root of the sum of squares of half-widths, `‖K t‖`.
    RootSumSquare,
    /// The standard deviation, with that of each distribution.
    Deviation,
}

/// Where a tolerance was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Between its limits.
    None,
    /// At the lower one: the band would permit less than what can be made.
    Least,
    /// At the upper one: the band would permit more.
    Most,
}

/// A place that keeps the tolerances from being wider.
#[derive(Clone, Debug, PartialEq)]
pub struct Active {
    /// Positions of the drivers.
    pub at: Vec<f64>,
    /// Its share in the price of the band.
    pub share: f64,
}

/// Tolerances of least cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Allocation {
    /// The tolerances, in the order of the candidates.
    pub tolerances: Vec<f64>,
    /// Which of them lie on a limit.
    pub limits: Vec<Limit>,
    /// What they cost.
    pub cost: f64,
    /// Greatest error over the way.
    pub greatest: f64,
    /// Where it is.
    pub greatest_at: Vec<f64>,
    /// Places that bind.
    pub active: Vec<Active>,
    /// What the cost falls by per relative widening of the band: a band wider by 1 % saves a hundredth of this.
    pub price: f64,
    /// Programmes that were solved.
    pub rounds: usize,
}

/// Finds tolerances of least cost that keep an output of a linkage within `band` along its places, which the drivers pass
/// in straight lines. What [`Study::sources`] says is not used.
///
/// # Errors
/// [`AllocationError`], with the place that cannot be kept if there is one.
pub fn allocate<L: Linkage>(
    linkage: &L,
    study: &Study,
    candidates: &[Candidate],
    rule: Rule,
    band: f64,
) -> Result<Allocation, AllocationError> {
    allocate_of(linkage, study, candidates, rule, band)
}

/// [`allocate`] of a linkage behind a pointer.
pub(crate) fn allocate_of(
    linkage: &dyn AnyLinkage,
    study: &Study,
    candidates: &[Candidate],
    rule: Rule,
    band: f64,
) -> Result<Allocation, AllocationError> {
    check(candidates, band)?;
    study.check_places(linkage.shape())?;
    check_variables(
        candidates.iter().map(|one| one.variable),
        linkage.shape().loops().variables.len(),
    )?;
    let mut assembly = linkage.assemble();
    assembly.guide().start()?;
    let places = &study.places;
    let mut influence = |part: f64| {
        let (_, all) = influence_at(&mut *assembly, study.output, &between(places, part))?;
        let weighed = candidates.iter().map(|one| rule.weigh(all[one.variable], one));
        Ok(weighed.collect())
    };
    let way = Band::new(&mut influence, rule, places.len())?;
    choose(way, candidates, band, &|part| between(places, part))
}

/// Tolerances of least cost where the influence of each candidate's variable along the way, from 0 to 1, is given by a
/// function.
///
/// # Errors
/// As [`allocate`].
pub fn allocate_along(
    influence: &mut dyn FnMut(f64) -> Vec<f64>,
    places: usize,
    candidates: &[Candidate],
    rule: Rule,
    band: f64,
) -> Result<Allocation, AllocationError> {
    check(candidates, band)?;
    let mut weighed = |part: f64| {
        let all = influence(part).into_iter().zip(candidates);
        Ok(all.map(|(k, one)| rule.weigh(k, one)).collect())
    };
    let weighed: &mut Influence<'_> = &mut weighed;
    choose(Band::new(weighed, rule, places)?, candidates, band, &|part| vec![part])
}

fn check(candidates: &[Candidate], band: f64) -> Result<(), AllocationError> {
    if !(band > 0.0 && band.is_finite()) {
        return Err(AllocationError::BadBand { band });
    }
    if candidates.is_empty() {
        return Err(super::ToleranceError::NoSource.into());
    }
    for (candidate, one) in candidates.iter().enumerate() {
        let (least, most) = (one.least, one.most);
        if !(least >= 0.0 && least <= most && most > 0.0 && least.is_finite()) {
            return Err(AllocationError::BadLimits { candidate, least, most });
        }
        let (factor, exponent) = (one.cost.factor, one.cost.exponent);
        let falls = factor > 0.0 && exponent > 0.0;
        if !(falls && factor.is_finite() && exponent.is_finite() && one.cost.fixed.is_finite()) {
            return Err(AllocationError::BadCost { candidate, factor, exponent });
        }
    }
    Ok(())
}

/// A part of the way through places, from 0 to 1.
fn between(places: &[Vec<f64>], part: f64) -> Vec<f64> {
    let at = part * (places.len() - 1) as f64;
    let index = (at as usize).min(places.len().saturating_sub(2));
    let (Some(from), Some(to)) = (places.get(index), places.get(index + 1)) else {
        return places[0].clone();
    };
    let share = at - index as f64;
    let pairs = from.iter().zip(to);
    pairs.map(|(from, to)| from + share * (to - from)).collect()
}

/// A programme that is not solved, with the place where the output errs most.
fn unsolved(
    error: AllocationError,
    kept: &[Peak],
    at: &dyn Fn(f64) -> Vec<f64>,
) -> AllocationError {
    let size = |peak: &Peak| peak.influence.iter().map(|one| one.abs()).fold(0.0, f64::max);
    let hardest = kept.iter().max_by(|one, other| size(one).total_cmp(&size(other)));
    match (error, hardest) {
        (AllocationError::NotSolved { status, iterations, .. }, Some(peak)) => {
            AllocationError::NotSolved { at: at(peak.part), status, iterations }
        }
        (error, _) => error,
    }
}

/// Solves programmes until no place along the way leaves the band.
fn choose(
    mut way: Band<'_>,
    candidates: &[Candidate],
    band: f64,
    at: &dyn Fn(f64) -> Vec<f64>,
) -> Result<Allocation, AllocationError> {
    let bounded = |(p, one): (usize, &Candidate)| one.most.is_finite() || way.largest(p) > 0.0;
    if let Some(candidate) = candidates.iter().enumerate().position(|one| !bounded(one)) {
        return Err(AllocationError::Unbounded { candidate });
    }
    reachable(&mut way, candidates, band, at)?;
    let ones: Vec<f64> = (0..candidates.len())
        .map(|p| match way.largest(p) > 0.0 {
            true => 1.0 / way.largest(p),
            false => 0.0,
        })
        .collect();
    let mut kept = way.peaks(&ones)?;
    for round in 1..=ROUNDS {
        let rows: Vec<Vec<f64>> = kept.iter().map(|one| one.influence.clone()).collect();
        let optimum = cone::solve(candidates, way.rule, band, &rows);
        let optimum = optimum.map_err(|error| unsolved(error, &kept, at))?;
        let peaks = way.peaks(&optimum.tolerances)?;
        let excess = greatest(&peaks).error / band;
        if excess <= 1.0 + EXCESS {
            return finish(&mut way, candidates, &optimum, &kept, excess, at, round);
        }
        if round == ROUNDS {
            return Err(AllocationError::NotSettled { rounds: round, excess });
        }
        let beyond = peaks.into_iter().filter(|one| one.error > band * (1.0 + 0.5 * EXCESS));
        kept.extend(beyond);
    }
    unreachable!("the last round returns")
}

fn greatest(peaks: &[Peak]) -> &Peak {
    let mut best = &peaks[0];
    for peak in peaks {
        if peak.error > best.error {
            best = peak;
        }
    }
    best
}

/// The errors grow with the tolerances: the band can be kept if it is kept with all of them at their lower limits.
fn reachable(
    way: &mut Band<'_>,
    candidates: &[Candidate],
    band: f64,
    at: &dyn Fn(f64) -> Vec<f64>,
) -> Result<(), AllocationError> {
    let least: Vec<f64> = candidates.iter().map(|one| one.least).collect();
    let peaks = way.peaks(&least)?;
    let worst = greatest(&peaks);
    if worst.error <= band {
        return Ok(());
    }
    let part = |p: usize| {
        let part = (worst.influence[p] * least[p]).abs() / worst.error;
        match way.rule {
            Rule::Worst => part,
            Rule::RootSumSquare | Rule::Deviation => part * part,
        }
    };
    let mut candidate = 0;
    for p in 0..least.len() {
        if part(p) > part(candidate) {
            candidate = p;
        }
    }
    Err(AllocationError::OutOfReach {
        at: at(worst.part),
        reached: worst.error,
        band,
        candidate,
        share: part(candidate),
    })
}

/// Takes the last excess off, and says what binds.
fn finish(
    way: &mut Band<'_>,
    candidates: &[Candidate],
    optimum: &cone::Optimum,
    kept: &[Peak],
    excess: f64,
    at: &dyn Fn(f64) -> Vec<f64>,
    rounds: usize,
) -> Result<Allocation, AllocationError> {
    let scale = f64::max(1.0, excess);
    let chosen = optimum.tolerances.iter().zip(candidates);
    let tolerances: Vec<f64> = chosen
        .map(|(one, candidate)| (one / scale).clamp(candidate.least, candidate.most))
        .collect();
    let near = |value: f64, limit: f64| (value / limit - 1.0).abs() <= ON_LIMIT;
    let limits = tolerances.iter().zip(candidates).map(|(one, candidate)| {
        match (near(*one, candidate.most), near(*one, candidate.least)) {
            (true, _) => Limit::Most,
            (_, true) => Limit::Least,
            _ => Limit::None,
        }
    });
    let costs = tolerances.iter().zip(candidates);
    let price: f64 = optimum.prices.iter().sum();
    let active = kept.iter().zip(&optimum.prices).map(|(peak, price)| (peak, *price));
    let peaks = way.peaks(&tolerances)?;
    let worst = greatest(&peaks);
    Ok(Allocation {
        limits: limits.collect(),
        cost: costs.map(|(one, candidate)| candidate.cost.of(*one)).sum(),
        greatest: worst.error,
        greatest_at: at(worst.part),
        active: active
            .filter(|(_, own)| *own > 1e-6 * price)
            .map(|(peak, own)| Active { at: at(peak.part), share: own / price })
            .collect(),
        price,
        rounds,
        tolerances,
    })
}

impl Cost {
    /// What a tolerance costs.
    pub fn of(&self, tolerance: f64) -> f64 {
        self.fixed + self.factor * tolerance.powf(-self.exponent)
    }
}
