//! The nearest design of which no neighbour is better, with what holds it there.
//!
//! Sequential quadratic programmes in a region that is trusted, with an exact penalty on the conditions and a second-order
//! correction (R. Fletcher: *Practical methods of optimization*, 2nd ed., 1987, sections 14.4 and 14.5). Each programme makes
//! the largest of the linearised values small; the curvature of the Lagrangian is learnt from step to step. Where as many
//! values and conditions meet as there are numbers and one, the linear parts alone determine the design, and convergence is
//! quadratic. Everything is in units of the ranges.
//!
//! Where that takes long, in a valley that is flat and winds, each value and condition is bent in its own way, and
//! all of them together leave only short steps to what is linear. Then every one is taken as a quadratic, see [`super::bent`].

use super::local::{Aim, Local};
use super::problem::{SynthesisError, check};
use super::stand::Stand;
use super::way::Way;

/// First step, as a part of each range.
const REGION: f64 = 0.02;
/// Shortest step that is tried.
const SHORTEST: f64 = 1e-14;

/// How a polishing ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// No step promises to gain anything.
    Settled,
    /// Steps as short as can be do not keep what they promise: slopes are not those of the values, or jump.
    Stuck,
    /// As many looks as were permitted, or it was stopped.
    Looks,
}

/// A polished design.
#[derive(Clone, Debug, PartialEq)]
pub struct Polished {
    /// The design.
    pub design: Vec<f64>,
    /// What was made small.
    pub value: f64,
    /// By how much the condition that is missed most is missed.
    pub missed: f64,
    /// How it ended.
    pub end: End,
    /// What holds it there: multipliers of the values, which sum up to one where the largest was made small, then of the
    /// conditions: what the value would fall by per unit of each.
    pub multipliers: Vec<f64>,
    /// What the value would fall by per range beyond the upper bound of each number, or below zero beyond its lower one.
    pub bounds: Vec<f64>,
    /// The largest slope of the Lagrangian that is left, per range: nothing at a best design.
    pub slope: f64,
    /// Looks that were taken.
    pub looks: u64,
}

/// Polishes a design, with so many looks at most.
///
/// # Errors
/// [`SynthesisError`] if the design that it begins with cannot be judged, is one of another problem, or there is none.
pub fn polish(
    local: &mut dyn Local,
    aim: Aim,
    from: &[f64],
    looks: u64,
) -> Result<Polished, SynthesisError> {
    from_region(local, aim, from, (looks, REGION, true))
}

/// Polishes with so many looks and a first region. How neighbourhoods are bent is looked at if it may.
pub(super) fn from_region(
    local: &mut dyn Local,
    aim: Aim,
    from: &[f64],
    (looks, region, may_bend): (u64, f64, bool),
) -> Result<Polished, SynthesisError> {
    let sought = local.sought().to_vec();
    check(&sought)?;
    if from.len() != sought.len() {
        return Err(SynthesisError::OtherProblem { found: from.len(), expected: sought.len() });
    }
    let start = sought.iter().zip(from).map(|(one, value)| (value - one.low) / one.width());
    let place = start.collect::<Vec<f64>>();
    let mut way = Way { local, sought, aim, looks: 0, may_bend };
    let here = way.look(&place).ok_or(SynthesisError::NotJudged)?;
    let mut stand = Stand::new(place, here, region);
    let end = loop {
        if way.looks >= looks || way.local.is_stopped() {
            break End::Looks;
        }
        match way.advance(&mut stand) {
            Some(end) => break end,
            None if stand.region < SHORTEST => break End::Stuck,
            None => {}
        }
    };
    Ok(way.judged(&stand, end))
}
