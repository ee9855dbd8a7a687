//! The conic programme: least cost for a band at some places.
//!
//! In units of a guess the unknowns are the tolerances `τ` and `σ ≥ τ^-k`, to which the costs are proportional. `σ τ ≥ 1`
//! is a second-order cone, `‖(2, σ - τ)‖ ≤ σ + τ`; for other exponents `σ^α τ^(1-α) ≥ 1`, `α = 1/(1 + k)`, a power cone.
//! A worst case is a linear row, a root of a sum of squares a second-order cone.

use super::error::AllocationError;
use super::{Candidate, Rule};
use crate::conic::{Rows, minimise};
use clarabel::solver::{NonnegativeConeT, PowerConeT, SecondOrderConeT};

/// The solution.
pub(super) struct Optimum {
    /// The tolerances.
    pub tolerances: Vec<f64>,
    /// What the cost falls by for each place, per relative widening of the band there.
    pub prices: Vec<f64>,
}

/// Solves it. `influences` holds, for each place, the error per unit of each tolerance.
pub(super) fn solve(
    candidates: &[Candidate],
    rule: Rule,
    band: f64,
    influences: &[Vec<f64>],
) -> Result<Optimum, AllocationError> {
    let units = guess(candidates, band, influences);
    let mut rows = Rows::default();
    let marks: Vec<usize> = influences
        .iter()
        .map(|influence| {
            let mark = rows.count();
            let scaled = influence.iter().zip(&units).map(|(k, unit)| k * unit / band);
            keep(&mut rows, rule, &scaled.enumerate().collect::<Vec<_>>());
            mark
        })
        .collect();
    limit(&mut rows, candidates, &units);
    let n = candidates.len();
    for (p, candidate) in candidates.iter().enumerate() {
        charge(&mut rows, p, n + p, candidate.cost.exponent);
    }
    let costs: Vec<f64> = candidates
        .iter()
        .zip(&units)
        .map(|(one, unit)| one.cost.factor * unit.powf(-one.cost.exponent))
        .collect();
    let most = costs.iter().copied().fold(0.0, f64::max);
    let zeros = std::iter::repeat_n(0.0, n);
    let objective: Vec<f64> = zeros.chain(costs.iter().map(|cost| cost / most)).collect();
    let (x, z) = minimise(&objective, &[], rows).map_err(|stop| AllocationError::NotSolved {
        at: Vec::new(),
        status: stop.status,
        iterations: stop.iterations,
    })?;
    Ok(Optimum {
        tolerances: x.iter().zip(&units).map(|(x, unit)| x * unit).collect(),
        prices: marks.iter().map(|mark| z[*mark] * most).collect(),
    })
}

/// Tolerances of which each uses an equal part of the band where it has most influence.
fn guess(candidates: &[Candidate], band: f64, influences: &[Vec<f64>]) -> Vec<f64> {
    let one = |(p, candidate): (usize, &Candidate)| {
        let most = influences.iter().map(|row| row[p].abs()).fold(0.0, f64::max);
        let part = band / (most * candidates.len() as f64);
        part.clamp(candidate.least, candidate.most)
    };
    candidates.iter().enumerate().map(one).collect()
}

/// The band at a place.
fn keep(rows: &mut Rows, rule: Rule, scaled: &[(usize, f64)]) {
    match rule {
        Rule::Worst => {
            let negative: Vec<_> = scaled.iter().map(|(p, k)| (*p, -k.abs())).collect();
            rows.row(1.0, &negative);
            rows.cones.push(NonnegativeConeT(1));
        }
        Rule::RootSumSquare | Rule::Deviation => {
            rows.row(1.0, &[]);
            for part in scaled {
                rows.row(0.0, &[*part]);
            }
            rows.cones.push(SecondOrderConeT(1 + scaled.len()));
        }
    }
}

fn limit(rows: &mut Rows, candidates: &[Candidate], units: &[f64]) {
    for (p, (candidate, unit)) in candidates.iter().zip(units).enumerate() {
        if candidate.least > 0.0 {
            rows.row(-candidate.least / unit, &[(p, 1.0)]);
            rows.cones.push(NonnegativeConeT(1));
        }
        if candidate.most.is_finite() {
            rows.row(candidate.most / unit, &[(p, -1.0)]);
            rows.cones.push(NonnegativeConeT(1));
        }
    }
}

/// `σ τ^k ≥ 1`
fn charge(rows: &mut Rows, tau: usize, sigma: usize, exponent: f64) {
    if exponent == 1.0 {
        rows.row(0.0, &[(tau, 1.0), (sigma, 1.0)]);
        rows.row(0.0, &[(tau, -1.0), (sigma, 1.0)]);
        rows.row(2.0, &[]);
        rows.cones.push(SecondOrderConeT(3));
    } else {
        rows.row(0.0, &[(sigma, 1.0)]);
        rows.row(0.0, &[(tau, 1.0)]);
        rows.row(1.0, &[]);
        rows.cones.push(PowerConeT(1.0 / (1.0 + exponent)));
    }
}
