//! The nearest design of which no neighbour is better, with what holds it there.
//!
//! Sequential quadratic programmes in a region that is trusted, with an exact penalty on the conditions and a second-order
//! correction (R. Fletcher: *Practical methods of optimization*, 2nd ed., 1987, sections 14.4 and 14.5). Each programme makes
//! the largest of the linearised values small; the curvature of the Lagrangian is learnt from step to step. Where as many
//! values and conditions meet as there are numbers and one, the linear parts alone determine the design, and convergence is
//! quadratic. Everything is in units of the ranges.

use super::curve::{Curve, dot};
use super::local::{Aim, Local, Look};
use super::problem::{Sought, SynthesisError, check};
use super::programme::{Model, Step};

/// First and largest step, as a part of each range.
const REGION: (f64, f64) = (0.02, 0.5);
/// Shortest step that is tried.
const SHORTEST: f64 = 1e-14;
/// A region, as a part of each range, in which something can be gained unless a design is the best.
const WIDE: f64 = 1e-6;
/// A gain that counts as none, over the value.
const GAIN: f64 = 1e-13;
/// A step is taken if so much of what it promises comes true.
const BELIEVED: f64 = 0.1;
/// Shares of what is promised below and above which the region changes.
const SHARES: (f64, f64) = (0.25, 0.75);
/// Largest weight of what conditions miss, over how steep the values are beside them.
const HEAVIEST: f64 = 1e6;
/// Conditions come nearer to hold if a step leaves less than so much of what is missed.
const NEARER: f64 = 0.9;
/// Steps after which curvature is looked at.
const PATIENCE: u64 = 30;
/// Steps between two such looks.
const BETWEEN: u64 = 4;
/// Part of a range over which it is seen.
const BESIDE: f64 = 1e-5;
/// A number so near to a bound, as a part of its range, is at it.
const AT_BOUND: f64 = 1e-6;
/// What of a change of conditions counts as none.
const NOTHING: f64 = 1e-6;

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
    let sought = local.sought().to_vec();
    check(&sought)?;
    if from.len() != sought.len() {
        return Err(SynthesisError::OtherProblem { found: from.len(), expected: sought.len() });
    }
    let start = sought.iter().zip(from).map(|(one, value)| (value - one.low) / one.width());
    let (place, count) = (start.collect::<Vec<f64>>(), sought.len());
    let mut way = Way { local, sought, aim, looks: 0 };
    let here = way.look(&place).ok_or(SynthesisError::NotJudged)?;
    let weight = here.steepness(count);
    let mut stand =
        Stand { place, here, region: REGION.0, weight, curve: Curve::new(count), taken: 0 };
    let mut last = None;
    let end = loop {
        if way.looks >= looks || way.local.is_stopped() {
            break End::Looks;
        }
        match way.advance(&mut stand, &mut last) {
            Some(end) => break end,
            None if stand.region < SHORTEST => break End::Stuck,
            None => {}
        }
    };
    Ok(way.judged(&stand, last, end))
}

/// Where a polishing stands.
struct Stand {
    /// In units of the ranges.
    place: Vec<f64>,
    here: Look,
    region: f64,
    /// Of what conditions miss.
    weight: f64,
    curve: Curve,
    /// Steps that were taken.
    taken: u64,
}

impl Stand {
    /// The size of what is made small.
    fn size(&self, aim: Aim) -> f64 {
        let size = match aim {
            Aim::Largest => {
                self.here.values.iter().fold(0.0, |most, one| f64::max(most, one.abs()))
            }
            Aim::Squares => aim.of(&self.here.values),
        };
        size.max(1e-300)
    }
}

/// What does not change on the way.
struct Way<'a> {
    local: &'a mut dyn Local,
    sought: Vec<Sought>,
    aim: Aim,
    looks: u64,
}

impl Way<'_> {
    fn look(&mut self, place: &[f64]) -> Option<Look> {
        self.looks += 1;
        let look = self.local.look(&self.design(place))?;
        look.is_sound(self.sought.len()).then(|| look.scaled(&self.sought))
    }

    fn design(&self, place: &[f64]) -> Vec<f64> {
        let one = |(one, share): (&Sought, &f64)| match one.is_turn {
            true => one.low + share.rem_euclid(1.0) * one.width(),
            false => (one.low + share * one.width()).clamp(one.low, one.high),
        };
        self.sought.iter().zip(place).map(one).collect()
    }

    /// How far each number may go down and up.
    fn room(&self, stand: &Stand) -> Vec<(f64, f64)> {
        let region = stand.region;
        let one = |(one, place): (&Sought, &f64)| match one.is_turn {
            true => (-region, region),
            false => ((-place).max(-region), (1.0 - place).min(region)),
        };
        self.sought.iter().zip(&stand.place).map(one).collect()
    }

    /// Tries a step, and takes it if it keeps what it promises. Whether, and how, that was the last one.
    fn advance(&mut self, stand: &mut Stand, last: &mut Option<Step>) -> Option<End> {
        let (aim, size, room) = (self.aim, stand.size(self.aim), self.room(stand));
        let weight = stand.weight;
        let (look, curve, region) = (&stand.here, &stand.curve, stand.region);
        let model = Model { aim, look, curve, room: &room, region, weight };
        let Some(mut step) = model.solve() else {
            return Some(End::Stuck);
        };
        let least = NEARER * stand.here.missed() + NOTHING * step.reach;
        let steepness = stand.here.steepness(stand.place.len());
        if step.missed > least && weight < HEAVIEST * steepness {
            stand.weight *= 10.0;
            return None;
        }
        let worth = |look: &Look| aim.of(&look.values) + weight * look.missed();
        let before = worth(&stand.here);
        let promised = before - model.cost(&step.way);
        *last = Some(step.clone());
        if promised <= GAIN * size {
            // Within a small region nothing can be gained, wherever it lies.
            return Some(if region >= WIDE { End::Settled } else { End::Stuck });
        }
        let kept = |look: &Option<Look>| {
            look.as_ref().map_or(f64::NEG_INFINITY, |look| (before - worth(look)) / promised)
        };
        let mut tried = self.tried(stand, &step.way);
        if kept(&tried) < SHARES.0
            && let Some(there) = &tried
        {
            let shifted = shifted(&stand.here, there, &step.way);
            let again = Model { look: &shifted, ..model }.solve();
            if let Some(way) = again.map(|step| step.way) {
                let other = self.tried(stand, &way);
                if kept(&other) > kept(&tried) {
                    (tried, step.way) = (other, way);
                }
            }
        }
        let length = step.way.iter().fold(0.0, |most, one| f64::max(most, one.abs()));
        let share = kept(&tried);
        if share < SHARES.0 {
            stand.region = 0.5 * length.min(region);
        } else if share > SHARES.1 && length > 0.99 * region {
            stand.region = (2.0 * region).min(REGION.1);
        }
        let is_taken = share >= BELIEVED;
        if let Some(there) = tried.filter(|_| is_taken) {
            // What is heavier than it needs to be makes steps along bent conditions short.
            if step.missed <= NOTHING * step.reach {
                let held: f64 = step.multipliers[there.values.len()..].iter().sum();
                stand.weight = weight.min(f64::max(steepness, 4.0 * held));
            }
            stand.go(&step, there);
            stand.taken += 1;
            // Where curvature cannot be learnt from steps, it is looked at.
            if stand.taken >= PATIENCE
                && stand.taken.is_multiple_of(BETWEEN)
                && let Some(curve) = self.curve(stand, &step.multipliers)
            {
                stand.curve = curve;
            }
        }
        None
    }

    /// The curvature of the Lagrangian where a design stands; none where a neighbour cannot be judged.
    fn curve(&mut self, stand: &Stand, multipliers: &[f64]) -> Option<Curve> {
        let (count, aim) = (stand.place.len(), self.aim);
        let pull = |look: &Look| {
            let mut multipliers = multipliers.to_vec();
            if aim == Aim::Squares {
                // What slopes alone make of squares stands in the programme by itself.
                multipliers[..look.values.len()].copy_from_slice(&stand.here.values);
            }
            look.pull(&multipliers, count)
        };
        let here = pull(&stand.here);
        let columns = (0..count).map(|column| {
            let mut way = vec![0.0; count];
            way[column] = if stand.place[column] < 0.5 { BESIDE } else { -BESIDE };
            let there = pull(&self.tried(stand, &way)?);
            Some(there.iter().zip(&here).map(|(a, b)| (a - b) / way[column]).collect())
        });
        let columns: Vec<Vec<f64>> = columns.collect::<Option<_>>()?;
        Some(Curve::seen(&columns))
    }

    fn tried(&mut self, stand: &Stand, way: &[f64]) -> Option<Look> {
        let place: Vec<f64> = stand.place.iter().zip(way).map(|(a, b)| a + b).collect();
        self.look(&place)
    }

    fn judged(&self, stand: &Stand, last: Option<Step>, end: End) -> Polished {
        let (design, here, count) = (self.design(&stand.place), &stand.here, stand.place.len());
        let (multipliers, mut bounds) = match last {
            Some(step) => (step.multipliers, step.bounds),
            None => (vec![0.0; here.values.len() + here.conditions.len()], vec![0.0; count]),
        };
        // What kept a step short may have been the region alone.
        for ((bound, place), one) in bounds.iter_mut().zip(&stand.place).zip(&self.sought) {
            let is_at_bound = place.min(1.0 - place) <= AT_BOUND;
            *bound = if is_at_bound && !one.is_turn { *bound } else { 0.0 };
        }
        let pull = here.pull(&multipliers, count);
        let left = pull.iter().zip(&bounds).map(|(pull, bound)| (pull + bound).abs());
        Polished {
            design,
            value: self.aim.of(&here.values),
            missed: here.missed(),
            end,
            slope: left.fold(0.0, f64::max),
            multipliers,
            bounds,
            looks: self.looks,
        }
    }
}

impl Stand {
    fn go(&mut self, step: &Step, there: Look) {
        let count = self.place.len();
        let [old, new] = [&self.here, &there].map(|look| look.pull(&step.multipliers, count));
        let change: Vec<f64> = new.iter().zip(old).map(|(new, old)| new - old).collect();
        self.curve.learn(&step.way, &change);
        for (place, way) in self.place.iter_mut().zip(&step.way) {
            *place += way;
        }
        self.here = there;
    }
}

/// Values and conditions as a step finds them, less what their slopes explain of it: what bends them is then in them.
fn shifted(here: &Look, there: &Look, way: &[f64]) -> Look {
    let count = way.len();
    let mut rows = here.slopes.chunks_exact(count);
    let mut shift = |all: &[f64]| -> Vec<f64> {
        let one = |(one, row): (&f64, &[f64])| one - dot(row, way);
        all.iter().zip(rows.by_ref()).map(one).collect()
    };
    let values = shift(&there.values);
    let conditions = shift(&there.conditions);
    Look { values, conditions, slopes: here.slopes.clone() }
}
