//! Following the modes carefully, where one step is not certain to keep them.
//!
//! The way is divided until each part is certain. Where a mode ends on the way, the end is found as a zero of the margin
//! of its group; where two modes meet and both go on, [`super::crossing`] takes over.

use super::assembly::Assembly;
use super::crossing::{Crossing, Meeting};
use super::error::ClosureError;
use super::newton::Instant;
use super::problem::{Closure, GroupKind, Linkage};
use super::root::brent;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// First part of the way that is tried.
const FIRST: f64 = 1.0 / 64.0;
/// Smallest part of the way.
const SMALLEST: f64 = 1e-13;
/// Largest number of parts that are tried.
const ATTEMPTS: usize = 20_000;
/// Sine below which a group is on its way to a dead point ahead of it.
const ARRIVED: f64 = 1e-3;
/// Sine below which a meeting of modes is looked for.
const NEAR: f64 = 0.05;
/// Gap that rounding may leave, as a part of the longest link.
pub(super) const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A straight way of the independent variables, `t` from 0 to 1, and the change points found on it.
pub(super) struct Way {
    from: Vec<f64>,
    to: Vec<f64>,
    pub crossings: Vec<Crossing>,
}

impl Way {
    /// The place at `t`.
    pub fn at(&self, t: f64) -> Vec<f64> {
        let ends = self.from.iter().zip(&self.to);
        ends.map(|(from, to)| {
            if t == 1.0 {
                *to
            } else {
                from + t * (to - from)
            }
        })
        .collect()
    }
}

impl Way {
    /// From its begin to its end.
    pub fn heading(&self) -> Vec<f64> {
        self.to
            .iter()
            .zip(&self.from)
            .map(|(to, from)| to - from)
            .collect()
    }
}

/// What is known after an attempt.
#[derive(Clone, Copy, Debug)]
enum Verdict {
    /// The modes have been kept.
    Certain,
    /// This group closes, perhaps in another mode.
    Doubtful(usize),
    /// This group does not close.
    Open(usize),
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// Moves from the last position to other values of the independent variables.
    #[cold]
    #[inline(never)]
    pub(super) fn follow(&mut self, target: &[S]) -> Result<(), ClosureError> {
        self.position.clone_from(&self.last);
        let mut way = Way {
            from: self.place(),
            to: target.iter().map(|value| value.to_f64()).collect(),
            crossings: Vec::new(),
        };
        if let Some(bad) = way
            .from
            .iter()
            .chain(&way.to)
            .find(|value| !value.is_finite())
        {
            let reason = format!(
                "an independent variable is {bad}: start the linkage, and move it to finite values"
            );
            return Err(ClosureError::BadRange { reason });
        }
        let outcome = self
            .leave_stands(&mut way)
            .and_then(|()| self.walk(&mut way));
        if outcome.is_err() {
            self.position.clone_from(&self.last);
        }
        outcome
    }

    fn walk(&mut self, way: &mut Way) -> Result<(), ClosureError> {
        let (mut done, mut step) = (0.0, 1.0);
        let mut looked = f64::INFINITY;
        let mut end: Option<(usize, f64)> = None;
        for _ in 0..ATTEMPTS {
            let to = match end {
                Some((group, at)) if self.sine(group).abs() < ARRIVED || at - done < SMALLEST => {
                    return Err(self.dead_point(group, way, at));
                }
                Some((_, at)) => done + f64::min(step, 0.5 * (at - done)),
                None if done + 1.01 * step >= 1.0 => 1.0,
                None => done + step,
            };
            let verdict = self.attempt(way, to);
            match verdict {
                Verdict::Certain => {
                    self.take(way, to);
                    step = 2.0 * (to - done);
                    done = to;
                    if done == 1.0 {
                        return Ok(());
                    }
                    continue;
                }
                Verdict::Open(group) if L::GROUPS[group].kind != GroupKind::General => {
                    let gap = -self.margin_at(way, to, group);
                    if gap > self.allowance(way, done, group) {
                        end = Some((group, self.end_of_mode(way, group, done, to)));
                    } else {
                        let found = self.meet(way, done, Some(to), group);
                        end = self.heed(way, found, group, done, end);
                    }
                }
                Verdict::Open(group) | Verdict::Doubtful(group) => {
                    let sine = self.sine(group).abs();
                    if sine < NEAR && sine < 0.1 * looked && L::GROUPS[group].kind.has_modes() {
                        looked = sine;
                        let found = self.meet(way, done, None, group);
                        end = self.heed(way, found, group, done, end);
                    }
                }
            }
            step = f64::min(
                0.4 * (to - done),
                if done == 0.0 { 4.0 * FIRST } else { 1.0 },
            );
            if step < SMALLEST {
                return Err(self.lost(way, done, verdict));
            }
        }
        Err(self.lost(way, done, Verdict::Doubtful(0)))
    }

    /// Remembers what a look ahead has found.
    fn heed(
        &mut self,
        way: &mut Way,
        found: Meeting,
        group: usize,
        done: f64,
        end: Option<(usize, f64)>,
    ) -> Option<(usize, f64)> {
        match found {
            Meeting::Point(crossing) => way.crossings.push(crossing),
            Meeting::Gap(beyond) => {
                return Some((group, self.end_of_mode(way, group, done, beyond)));
            }
            Meeting::None => {}
        }
        end
    }

    /// Closes all groups at `t` near the last position. Stops at the first group that is not certain.
    fn attempt(&mut self, way: &Way, t: f64) -> Verdict {
        let independents = scalars::<S>(&way.at(t));
        let instant = self.closure.instant(&independents);
        let ratio = self.ratio(&independents).to_f64();
        self.position.clone_from(&self.last);
        for group in 0..L::GROUPS.len() {
            let now = self.groups[group];
            let crossing = way
                .crossings
                .iter()
                .find(|crossing| crossing.group == group);
            if crossing.is_some_and(|crossing| crossing.is_beyond(t)) {
                return Verdict::Doubtful(group);
            }
            let mode = crossing.map_or(now.mode.to_f64(), |crossing| crossing.mode_at(t));
            let (sine, turned) = self.close_near(group, &independents, &instant, mode);
            let sine = match crossing {
                Some(crossing) if crossing.is_at(t) => self.interpolate(crossing, t, &instant),
                _ => sine,
            };
            if sine.is_nan() {
                return Verdict::Open(group);
            }
            let change = sine - now.sine.to_f64();
            if crossing.is_none()
                && !is_certain(sine, now.sine.to_f64(), now.change.to_f64() * ratio, turned)
            {
                return Verdict::Doubtful(group);
            }
            self.next[group].mode = S::from_f64(mode);
            self.next[group].sine = S::from_f64(sine);
            self.next[group].change = S::from_f64(change);
        }
        Verdict::Certain
    }

    /// Closes one group with its angles nearest to the last ones. Gives the sine and the largest turn.
    pub(super) fn close_near(
        &mut self,
        group: usize,
        independents: &[S],
        instant: &Instant<L, S>,
        mode: f64,
    ) -> (f64, f64) {
        let kind = L::GROUPS[group].kind;
        if kind == GroupKind::General {
            let (sine, moved) = self.iterate(group, independents, instant);
            return (sine.to_f64(), moved.to_f64());
        }
        let mode = S::from_f64(mode);
        let sine = self.closure.close(group, instant, mode, &mut self.position);
        let mut turned = 0.0;
        for &j in L::GROUPS[group].unknowns {
            if L::ANGLES[j] && kind.has_modes() {
                let angle = self.position.as_ref()[j].to_f64();
                let last = self.last.as_ref()[j].to_f64();
                self.turns[j] = S::from_f64(TAU * ((last - angle) / TAU).round());
                self.position.as_mut()[j] = self.position.as_ref()[j] + self.turns[j];
                turned = f64::max(turned, (self.position.as_ref()[j].to_f64() - last).abs());
            }
        }
        (sine.to_f64(), turned)
    }

    /// Closes the groups up to this one at `t`, in a mode of the last one, and gives the sine of that.
    pub(super) fn probe(&mut self, way: &Way, t: f64, group: usize, mode: f64) -> f64 {
        let independents = scalars::<S>(&way.at(t));
        let instant = self.closure.instant(&independents);
        self.position.clone_from(&self.last);
        for before in 0..group {
            let crossing = way
                .crossings
                .iter()
                .find(|crossing| crossing.group == before);
            let own = crossing.map_or(self.groups[before].mode.to_f64(), |crossing| {
                crossing.mode_at(t)
            });
            if self
                .close_near(before, &independents, &instant, own)
                .0
                .is_nan()
            {
                return f64::NAN;
            }
        }
        self.close_near(group, &independents, &instant, mode).0
    }

    /// The margin of a group at `t`, NaN if one before it does not close.
    pub(super) fn margin_at(&mut self, way: &Way, t: f64, group: usize) -> f64 {
        if group > 0
            && self
                .probe(way, t, group - 1, self.groups[group - 1].mode.to_f64())
                .is_nan()
        {
            return f64::NAN;
        }
        let instant = self.closure.instant(&scalars::<S>(&way.at(t)));
        if group == 0 {
            self.position.clone_from(&self.last);
        }
        self.closure
            .margin(group, &instant, &self.position)
            .to_f64()
    }

    /// Gap that rounding may leave in a group.
    pub(super) fn allowance(&mut self, way: &Way, t: f64, group: usize) -> f64 {
        let instant = self.closure.instant(&scalars::<S>(&way.at(t)));
        self.position.clone_from(&self.last);
        ROUNDING * self.reach(group, &instant)
    }

    /// Where a group ceases to assemble between two places.
    fn end_of_mode(&mut self, way: &Way, group: usize, done: f64, beyond: f64) -> f64 {
        let ends = (
            self.margin_at(way, done, group),
            self.margin_at(way, beyond, group),
        );
        brent(
            |t| self.margin_at(way, t, group),
            (done, ends.0),
            (beyond, ends.1),
        )
    }

    /// Makes what was tried at `t` the position.
    fn take(&mut self, way: &mut Way, t: f64) {
        let place = way.at(t);
        let independents = scalars::<S>(&place);
        let instant = self.closure.instant(&independents);
        self.pass_crossings(way, t);
        self.accept(&independents, &instant);
        self.last.clone_from(&self.position);
    }

    fn dead_point(&mut self, group: usize, way: &Way, at: f64) -> ClosureError {
        ClosureError::DeadPoint {
            group,
            at: way.at(at),
            wanted: way.to.clone(),
            gap: -self.margin_at(way, 1.0, group),
        }
    }

    /// The error for a group whose smooth continuation cannot be told.
    pub(super) fn lost_at(&self, way: &Way, group: usize) -> ClosureError {
        ClosureError::ModeLost {
            group,
            at: self.place(),
            wanted: way.to.clone(),
            sine: self.sine(group),
        }
    }

    /// The error for a way that could not be divided any further.
    fn lost(&mut self, way: &Way, done: f64, verdict: Verdict) -> ClosureError {
        let group = match verdict {
            Verdict::Doubtful(group) | Verdict::Open(group) => group,
            Verdict::Certain => 0,
        };
        let (at, wanted, sine) = (way.at(done), way.to.clone(), self.sine(group));
        if L::GROUPS[group].kind == GroupKind::General && sine.abs() < ARRIVED {
            return ClosureError::DeadPoint {
                group,
                at,
                wanted,
                gap: f64::NAN,
            };
        }
        ClosureError::ModeLost {
            group,
            at,
            wanted,
            sine,
        }
    }
}

/// Whether a group has certainly kept its mode; without a step before, only a small change is certain.
fn is_certain(sine: f64, before: f64, expected_change: f64, turned: f64) -> bool {
    let sum = sine.abs() + before.abs();
    let change = (sine - before).abs();
    let bound = f64::max(2.0 * change, 4.0 * turned);
    if expected_change.is_nan() {
        return 8.0 * bound < sum;
    }
    bound < sum && 4.0 * (sine - before - expected_change).abs() < sum
}

/// The numbers as scalars.
pub(super) fn scalars<S: Scalar>(values: &[f64]) -> Vec<S> {
    values.iter().map(|value| S::from_f64(*value)).collect()
}
