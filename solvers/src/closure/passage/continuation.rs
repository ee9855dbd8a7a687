//! Following the modes carefully, where one step is not certain to keep them.
//!
//! The way is divided until each part is certain. Where a mode ends on the way, the end is found as a zero of the margin
//! of its group; where two modes meet and both go on, [`super::crossing`] takes over.

use super::crossing::Crossing;
use super::meeting::Meeting;
use crate::closure::error::ClosureError;
use crate::closure::extent::root::brent;
use crate::closure::position::guide::Guide;
use crate::scalar::Scalar;
use crate::shape::GroupKind;
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
/// How often the last step may go into one of which it lets something be expected.
const FARTHEST: f64 = 1e10;
/// Gap that rounding may leave, as a part of the longest link.
pub(in crate::closure) const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A straight way of the independent variables, `t` from 0 to 1, and the change points found on it.
pub(in crate::closure) struct Segment {
    from: Vec<f64>,
    to: Vec<f64>,
    pub crossings: Vec<Crossing>,
}

impl Segment {
    /// A way without change points.
    pub fn new(from: Vec<f64>, to: Vec<f64>) -> Self {
        Self { from, to, crossings: Vec::new() }
    }

    /// The place at `t`.
    pub fn at(&self, t: f64) -> Vec<f64> {
        let ends = self.from.iter().zip(&self.to);
        ends.map(|(from, to)| if t == 1.0 { *to } else { from + t * (to - from) }).collect()
    }
}

impl Segment {
    /// The change point of a group.
    fn crossing_of(&self, group: usize) -> Option<&Crossing> {
        self.crossings.iter().find(|crossing| crossing.group == group)
    }

    /// From its begin to its end.
    pub fn heading(&self) -> Vec<f64> {
        self.to.iter().zip(&self.from).map(|(to, from)| to - from).collect()
    }
}

/// How far a way has been gone.
struct Progress {
    /// As far as this all is certain.
    done: f64,
    /// The next step.
    step: f64,
    /// The group that was last looked ahead for, and its sine then.
    looked: (usize, f64),
    /// The group whose mode ends ahead, and where.
    end: Option<(usize, f64)>,
}

impl Progress {
    /// The end of the next step.
    fn next(&self) -> f64 {
        match self.end {
            Some((_, at)) => self.done + f64::min(self.step, 0.5 * (at - self.done)),
            None if self.done + 1.01 * self.step >= 1.0 => 1.0,
            None => self.done + self.step,
        }
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

impl<S: Scalar> Guide<'_, S> {
    /// Moves from the last position to other values of the independent variables.
    #[cold]
    #[inline(never)]
    pub(in crate::closure) fn follow(&mut self, target: &[S]) -> Result<(), ClosureError> {
        let mut way =
            Segment::new(self.place(), target.iter().map(|value| value.to_f64()).collect());
        if let Some(bad) = way.from.iter().chain(&way.to).find(|value| !value.is_finite()) {
            let reason = format!(
                "an independent variable is {bad}: start the linkage, and move it to finite values"
            );
            return Err(ClosureError::BadRange { reason });
        }
        self.leave_stands(&mut way)?;
        self.walk(&mut way)
    }

    fn walk(&mut self, way: &mut Segment) -> Result<(), ClosureError> {
        let mut progress = Progress { done: 0.0, step: 1.0, looked: (0, f64::INFINITY), end: None };
        for _ in 0..ATTEMPTS {
            if let Some((group, at)) = progress.end
                && (self.sine(group).abs() < ARRIVED || at - progress.done < SMALLEST)
            {
                return Err(self.dead_point(group, way, at));
            }
            let to = progress.next();
            let verdict = self.attempt(way, to);
            match verdict {
                Verdict::Certain if to == 1.0 => {
                    self.take(way, to);
                    return Ok(());
                }
                Verdict::Certain => {
                    self.take(way, to);
                    progress.step = 2.0 * (to - progress.done);
                    progress.done = to;
                    continue;
                }
                Verdict::Open(group) => self.look_behind(way, &mut progress, group, to),
                Verdict::Doubtful(group) => self.look_ahead(way, &mut progress, group),
            }
            let longest = if progress.done == 0.0 { FIRST } else { 1.0 };
            progress.step = f64::min(0.4 * (to - progress.done), longest);
            if progress.step < SMALLEST {
                return Err(self.lost(way, progress.done, verdict));
            }
        }
        Err(self.lost(way, progress.done, Verdict::Certain))
    }

    /// Looks why a group does not close at `to`.
    fn look_behind(&mut self, way: &mut Segment, progress: &mut Progress, group: usize, to: f64) {
        if self.entry.groups[group].kind == GroupKind::General {
            return self.look_ahead(way, progress, group);
        }
        let gap = -self.margin_at(way, to, group);
        if gap > self.allowance(way, progress.done, group) {
            progress.end = Some((group, self.end_of_mode(way, group, progress.done, to)));
        } else {
            let found = self.meet(way, progress.done, Some(to), group);
            self.heed(way, progress, group, found);
        }
    }

    /// Looks for a meeting of modes ahead of a group that comes near one.
    fn look_ahead(&mut self, way: &mut Segment, progress: &mut Progress, group: usize) {
        let sine = self.sine(group).abs();
        let known = progress.end.is_some() || way.crossing_of(group).is_some();
        let looked = progress.looked.0 == group && sine > 0.1 * progress.looked.1;
        if known || looked || sine > NEAR {
            return;
        }
        progress.looked = (group, sine);
        if self.entry.groups[group].kind == GroupKind::General {
            progress.end = self.turn_ahead(way, progress.done).map(|at| (group, at));
            if progress.end.is_none() {
                way.crossings.extend(self.cross_ahead(way, progress.done, group));
            }
        } else {
            let found = self.meet(way, progress.done, None, group);
            self.heed(way, progress, group, found);
        }
    }

    /// Remembers what a look has found.
    fn heed(&mut self, way: &mut Segment, progress: &mut Progress, group: usize, found: Meeting) {
        match found {
            Meeting::Point(crossing) => way.crossings.push(crossing),
            Meeting::Gap(beyond) => {
                let at = self.end_of_mode(way, group, progress.done, beyond);
                progress.end = (at <= 1.0).then_some((group, at));
            }
            Meeting::None => {}
        }
    }

    /// Closes all groups at `t` near the last position. Stops at the first group that is not certain.
    fn attempt(&mut self, way: &Segment, t: f64) -> Verdict {
        let independents = scalars::<S>(&way.at(t));
        let instant = self.instant_at(&independents);
        // What changed in a step so much shorter, or in one that led nowhere, is rounding.
        let ratio = Some(self.ratio(&independents).to_f64()).filter(|ratio| ratio.abs() < FARTHEST);
        let ratio = ratio.unwrap_or(f64::NAN);
        self.trial.copy_from_slice(self.position);
        for group in 0..self.entry.groups.len() {
            let before = self.sine(group);
            let crossing = way.crossing_of(group);
            if crossing.is_some_and(|crossing| crossing.is_beyond(t)) {
                return Verdict::Doubtful(group);
            }
            let mode = crossing.map_or(self.mode(group), |crossing| crossing.mode_at(t));
            let (sine, turned) = self.close_near(group, &independents, &instant, mode);
            let iterated = self.entry.groups[group].kind == GroupKind::General;
            let near = crossing.filter(|crossing| crossing.surrounds(t));
            let sine = match near {
                Some(crossing) if crossing.is_at(t) => self.interpolate(crossing, t, &instant),
                Some(crossing) if iterated => self.close_between(crossing, t, &instant),
                _ => sine,
            };
            let sure = if iterated { near } else { crossing };
            if sine.is_nan() {
                return Verdict::Open(group);
            }
            let change = sine - before;
            let expected = self.groups.changes[group].to_f64() * ratio;
            if sure.is_none() && !is_certain(sine, before, expected, turned) {
                return Verdict::Doubtful(group);
            }
            self.next.modes[group] = S::from_f64(mode);
            self.next.sines[group] = S::from_f64(sine);
            self.next.changes[group] = S::from_f64(change);
        }
        Verdict::Certain
    }

    /// Closes one group with its angles nearest to the last ones. Gives the sine and the sum of the turns.
    pub(super) fn close_near(
        &mut self,
        group: usize,
        independents: &[S],
        instant: &[S],
        mode: f64,
    ) -> (f64, f64) {
        let kind = self.entry.groups[group].kind;
        if kind == GroupKind::General {
            let (sine, moved) = self.iterate(group, independents, instant);
            return (sine.to_f64(), moved.to_f64());
        }
        let sine = self.closed(group, instant, mode);
        let mut turned = 0.0;
        for &j in self.entry.groups[group].unknowns {
            let angle = self.trial[j].to_f64();
            if !angle.is_finite() {
                return (f64::NAN, f64::NAN);
            }
            if self.entry.angles[j] && kind.has_modes() {
                let last = self.position[j].to_f64();
                self.turns[j] = S::from_f64(TAU * ((last - angle) / TAU).round());
                self.trial[j] = self.trial[j] + self.turns[j];
                turned += (self.trial[j].to_f64() - last).abs();
            }
        }
        (sine, turned)
    }

    /// Closes the groups up to this one at `t`, in a mode of the last one, and gives the sine of that.
    pub(super) fn probe(&mut self, way: &Segment, t: f64, group: usize, mode: f64) -> f64 {
        let independents = scalars::<S>(&way.at(t));
        let instant = self.instant_at(&independents);
        self.trial.copy_from_slice(self.position);
        for before in 0..group {
            let crossing = way.crossing_of(before);
            let own = crossing.map_or(self.mode(before), |crossing| crossing.mode_at(t));
            if self.close_near(before, &independents, &instant, own).0.is_nan() {
                return f64::NAN;
            }
        }
        self.close_near(group, &independents, &instant, mode).0
    }

    /// The margin of a group at `t`, NaN if one before it does not close.
    pub(super) fn margin_at(&mut self, way: &Segment, t: f64, group: usize) -> f64 {
        if group > 0 && self.probe(way, t, group - 1, self.mode(group - 1)).is_nan() {
            return f64::NAN;
        }
        let instant = self.instant_at(&scalars::<S>(&way.at(t)));
        if group == 0 {
            self.trial.copy_from_slice(self.position);
        }
        self.loops.margin(group, &instant, self.trial).to_f64()
    }

    /// Gap that rounding may leave in a group.
    pub(super) fn allowance(&mut self, way: &Segment, t: f64, group: usize) -> f64 {
        let instant = self.instant_at(&scalars::<S>(&way.at(t)));
        self.trial.copy_from_slice(self.position);
        ROUNDING * self.reach(group, &instant)
    }

    /// Where a group ceases to assemble between two places.
    fn end_of_mode(&mut self, way: &Segment, group: usize, done: f64, beyond: f64) -> f64 {
        let ends = (self.margin_at(way, done, group), self.margin_at(way, beyond, group));
        brent(|t| self.margin_at(way, t, group), (done, ends.0), (beyond, ends.1))
    }

    /// Makes what was tried at `t` the position.
    fn take(&mut self, way: &mut Segment, t: f64) {
        let place = way.at(t);
        let independents = scalars::<S>(&place);
        let instant = self.instant_at(&independents);
        self.pass_crossings(way, t);
        self.groups.modes.copy_from_slice(&self.next.modes);
        self.accept(&independents, &instant);
    }

    fn dead_point(&mut self, group: usize, way: &Segment, at: f64) -> ClosureError {
        let gap = if self.entry.groups[group].kind == GroupKind::General {
            self.gap_at(way, 1.0, group)
        } else {
            -self.margin_at(way, 1.0, group)
        };
        ClosureError::DeadPoint { group, at: way.at(at), wanted: way.at(1.0), gap }
    }

    /// The gap that is left in an iterated group at `t`, as far as the iteration can tell.
    fn gap_at(&mut self, way: &Segment, t: f64, group: usize) -> f64 {
        if group > 0 && self.margin_at(way, t, group - 1).is_nan() {
            return f64::NAN;
        }
        let instant = self.instant_at(&scalars::<S>(&way.at(t)));
        if group == 0 {
            self.trial.copy_from_slice(self.position);
        }
        match self.newton.close(self.loops, group, &instant, self.trial) {
            Ok(_) => f64::NAN,
            Err(failure) => failure.reached.residual,
        }
    }

    /// The error for a group whose smooth continuation cannot be told.
    pub(super) fn lost_at(&self, way: &Segment, group: usize) -> ClosureError {
        ClosureError::ModeLost {
            group,
            at: self.place(),
            wanted: way.to.clone(),
            sine: self.sine(group),
        }
    }

    /// The error for a way that could not be divided any further.
    fn lost(&mut self, way: &Segment, done: f64, verdict: Verdict) -> ClosureError {
        let group = match verdict {
            Verdict::Doubtful(group) | Verdict::Open(group) => group,
            Verdict::Certain => 0,
        };
        let (at, wanted, sine) = (way.at(done), way.to.clone(), self.sine(group));
        ClosureError::ModeLost { group, at, wanted, sine }
    }
}

/// Whether a group has certainly kept its mode, see [`crate::closure::position::assembly`]; without a step before, only a
/// small change is certain.
fn is_certain(sine: f64, before: f64, expected_change: f64, turned: f64) -> bool {
    let sum = (sine + before).abs();
    let change = (sine - before).abs();
    if expected_change.is_nan() {
        return 16.0 * change < sum && 16.0 * turned < sum;
    }
    let missed = (sine - before - expected_change).abs();
    2.0 * turned + 4.0 * missed < sum && 2.0 * change < sum
}

/// The numbers as scalars.
pub(super) fn scalars<S: Scalar>(values: &[f64]) -> Vec<S> {
    values.iter().map(|value| S::from_f64(*value)).collect()
}
