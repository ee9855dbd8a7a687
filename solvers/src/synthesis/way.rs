//! The way of a polishing: one step after the other.

use super::bent::{Bends, Bent};
use super::curve::{Curve, dot};
use super::local::{Aim, Local, Look};
use super::polish::{End, Polished};
use super::problem::Sought;
use super::programme::{Model, Step};
use super::stand::Stand;

/// Largest step, as a part of each range.
const FARTHEST: f64 = 0.5;
/// A region, as a part of each range, in which something can be gained unless a design is the best.
const WIDE: f64 = 1e-6;
/// A gain that counts as none, over the value.
const GAIN: f64 = 1e-13;
/// What is promised over the value, and does not come true though the region would permit more, is what slopes are rounded by.
const TRUSTED: f64 = 1e-10;
/// A step is taken if so much of what it promises comes true.
const BELIEVED: f64 = 0.1;
/// Shares of what is promised below and above which the region changes.
const SHARES: (f64, f64) = (0.25, 0.75);
/// Largest weight of what conditions miss, over how steep the values are beside them.
const HEAVIEST: f64 = 1e6;
/// Conditions come nearer to hold if a step leaves less than so much of what is missed.
const NEARER: f64 = 0.9;
/// Steps after which it is looked at how a neighbourhood is bent.
const PATIENCE: u64 = 16;
/// Steps that it is learnt from at most, and steps that fail one after the other, until it is looked at again.
const AGE: (u64, u64) = (40, 2);
/// Part of a range over which it is seen.
const BESIDE: f64 = 1e-5;
/// A number so near to a bound, as a part of its range, is at it.
const AT_BOUND: f64 = 1e-6;
/// What of a change of conditions counts as none.
const NOTHING: f64 = 1e-6;

/// What does not change on the way.
pub(super) struct Way<'a> {
    pub local: &'a mut dyn Local,
    pub sought: Vec<Sought>,
    pub aim: Aim,
    pub looks: u64,
    /// Whether it may be looked at how neighbourhoods are bent.
    pub may_bend: bool,
}

impl Way<'_> {
    pub fn look(&mut self, place: &[f64]) -> Option<Look> {
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

    /// What values and conditions come to.
    fn worth(&self, look: &Look, weight: f64) -> f64 {
        self.aim.of(&look.values) + weight * look.missed()
    }

    /// Tries a step, and takes it if it keeps what it promises. Whether, and how, that was the last one.
    pub fn advance(&mut self, stand: &mut Stand) -> Option<End> {
        self.bend(stand);
        let (region, weight) = (stand.region, stand.weight);
        let Some((mut step, after)) = self.proposed(stand) else {
            return Some(End::Stuck);
        };
        let steepness = stand.here.steepness(stand.place.len());
        let nothing = NOTHING * stand.here.reach(stand.place.len(), region);
        let least = NEARER * stand.here.missed() + nothing;
        if step.missed > least && weight < HEAVIEST * steepness {
            stand.weight *= 10.0;
            return None;
        }
        let (size, before) = (stand.size(self.aim), self.worth(&stand.here, weight));
        let promised = before - after;
        stand.last = Some(step.clone());
        if promised <= GAIN * size + stand.rounding(self.aim) {
            // In a wide region small gains are lost in what the programme rounds, and within a small one nothing can be gained,
            // wherever it lies.
            let is_decided = region == WIDE || stand.is_judged;
            (stand.region, stand.is_judged) = (WIDE, true);
            return is_decided.then_some(if region >= WIDE { End::Settled } else { End::Stuck });
        }
        let (tried, share) = self.tried_out(stand, &mut step, (before, promised));
        let length = step.way.iter().fold(0.0, |most, one| f64::max(most, one.abs()));
        if share < SHARES.0 {
            stand.region = 0.5 * length.min(region);
        } else if share > SHARES.1 && length > 0.99 * region {
            stand.region = (2.0 * region).min(FARTHEST);
        }
        let is_taken = share >= BELIEVED;
        let is_rounding = share < SHARES.0 && promised <= TRUSTED * size;
        let is_settled = is_rounding && (region >= WIDE || length < 0.5 * region);
        if let Some(there) = tried.as_ref().filter(|_| stand.is_squares(self.aim)) {
            let actual = self.aim.of(&there.values);
            let straight = self.aim.of(&stand.here.along(&step.way).values);
            let bent = straight + 0.5 * dot(&step.way, &stand.curve.times(&step.way));
            stand.is_bent = (actual - bent).abs() < (actual - straight).abs();
        }
        stand.failed += 1;
        if let Some(there) = tried.filter(|_| is_taken) {
            // What is heavier than it needs to be makes steps along bent conditions short.
            if step.missed <= nothing {
                let held: f64 = step.multipliers[there.values.len()..].iter().sum();
                stand.weight = weight.min(f64::max(steepness, 4.0 * held));
            }
            stand.go(&step, there);
        }
        is_settled.then_some(End::Settled)
    }

    /// A step, and what is expected of it. Where it is known how the neighbourhood is bent, the best of its quadratics.
    fn proposed(&mut self, stand: &mut Stand) -> Option<(Step, f64)> {
        let (aim, room, weight) = (self.aim, self.room(stand), stand.weight);
        if let Some((bends, _)) = &stand.bends {
            let mut bent = Bent::new(&stand.here, bends, &room);
            if let Some(step) = bent.step(aim) {
                let after = self.worth(&bent.at(&step.way), weight);
                return Some((step, after));
            }
        }
        if let (Some(last), true) = (&stand.last, stand.taken > 0)
            && let Some(curve) = self.curvature(&last.multipliers)
        {
            stand.curve = curve;
        }
        let curve = match stand.is_bent || !stand.is_squares(self.aim) {
            true => stand.curve.clone(),
            false => Curve::new(stand.place.len()),
        };
        let (look, region) = (&stand.here, stand.region);
        let model = Model { aim, look, curve: &curve, room: &room, region, weight };
        let step = model.solve()?;
        let after = model.cost(&step.way);
        Some((step, after))
    }

    /// The curvature of the Lagrangian, in units of the ranges, where that is known.
    fn curvature(&mut self, multipliers: &[f64]) -> Option<Curve> {
        let count = self.sought.len();
        let mut entries = self.local.curvature(multipliers)?;
        for (row, entries) in entries.chunks_exact_mut(count).enumerate() {
            for (column, entry) in entries.iter_mut().enumerate() {
                *entry *= self.sought[row].width() * self.sought[column].width();
            }
        }
        Some(Curve::seen(count, &entries))
    }

    /// Looks at the design that a step leads to, and what of its promise it keeps. What bends what was taken as linear
    /// corrects it.
    fn tried_out(
        &mut self,
        stand: &Stand,
        step: &mut Step,
        (before, promised): (f64, f64),
    ) -> (Option<Look>, f64) {
        let weight = stand.weight;
        let mut tried = self.beside(stand, &step.way);
        let kept = |way: &Self, look: &Option<Look>| {
            let after = look.as_ref().map_or(f64::INFINITY, |look| way.worth(look, weight));
            (before - after) / promised
        };
        let mut share = kept(self, &tried);
        if share < SHARES.0
            && stand.bends.is_none()
            && let Some(there) = &tried
        {
            let look = &shifted(&stand.here, there, &step.way);
            let (room, region) = (self.room(stand), stand.region);
            let (aim, curve) = (self.aim, &stand.curve);
            let again = Model { aim, look, curve, room: &room, region, weight }.solve();
            if let Some(way) = again.map(|step| step.way) {
                let other = self.beside(stand, &way);
                let other_share = kept(self, &other);
                if other_share > share {
                    (tried, share, step.way) = (other, other_share, way);
                }
            }
        }
        (tried, share)
    }

    /// Looks at how the neighbourhood is bent, where it takes long.
    fn bend(&mut self, stand: &mut Stand) {
        let is_known = stand
            .bends
            .as_ref()
            .is_some_and(|(_, age)| *age == 0 || (*age < AGE.0 && stand.failed < AGE.1));
        if !self.may_bend || stand.is_squares(self.aim) || stand.taken < PATIENCE || is_known {
            return;
        }
        let count = stand.place.len();
        let beside = (0..count).map(|column| {
            let way = if stand.place[column] < 0.5 { BESIDE } else { -BESIDE };
            let mut all = vec![0.0; count];
            all[column] = way;
            Some((way, self.beside(stand, &all)?))
        });
        let beside: Option<Vec<_>> = beside.collect();
        stand.bends = beside.map(|beside| (Bends::seen(&stand.here, &beside), 0));
    }

    fn beside(&mut self, stand: &Stand, way: &[f64]) -> Option<Look> {
        let place: Vec<f64> = stand.place.iter().zip(way).map(|(a, b)| a + b).collect();
        self.look(&place)
    }

    /// What was come to.
    pub fn judged(&self, stand: &Stand, end: End) -> Polished {
        let (design, here, count) = (self.design(&stand.place), &stand.here, stand.place.len());
        let (multipliers, mut bounds) = match &stand.last {
            Some(step) => (step.multipliers.clone(), step.bounds.clone()),
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
