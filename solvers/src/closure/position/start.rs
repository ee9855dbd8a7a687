//! Putting a linkage together: which assembly mode the start values mean.

use super::guide::Guide;
use super::newton::{Failure, Stop};
use crate::closure::error::ClosureError;
use crate::scalar::Scalar;
use crate::shape::GroupKind;
use std::f64::consts::{PI, TAU};

/// AssemblyModes that lie nearer to each other than this, in radians or lengths of a link, are not told apart.
const COINCIDENT: f64 = 1e-6;
/// A start value as far from one mode as from the other, but for this part of their distance, picks neither.
const UNDECIDED: f64 = 1e-3;
/// Gap that rounding may leave, as a part of the longest link.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// What had to be assumed to put a linkage together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Start {
    /// Groups without any start value: mode +1 was taken, or −1 where +1 does not lead to an assembled linkage. Groups
    /// that are iterated began at zero.
    pub assumed: Vec<usize>,
    /// Start values that are far from where the linkage has been put together.
    pub contradicted: Vec<Contradiction>,
}

/// A start value far from the position that the linkage has been put together in: by more than a radian, or than what
/// moves the equations as far as a radian of the longest link does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contradiction {
    /// The dependent coordinate.
    pub dependent: usize,
    /// Its start value.
    pub declared: f64,
    /// Its value in the position, of an angle that nearest to the start value.
    pub assembled: f64,
}

impl<S: Scalar> Guide<'_, S> {
    /// Puts the linkage together where the start values of the mechanism are meant: where the drivers start, or, if they
    /// move in time and no start is stated, where they are when the task begins.
    ///
    /// # Errors
    /// [`ClosureError`] if it does not assemble there, or if the start values do not tell which mode is meant.
    pub fn start(&mut self) -> Result<Start, ClosureError> {
        let (at, near) = (self.declared(), self.linkage.start());
        self.start_at(&at, &near)
    }

    /// Where the independent variables are declared to start; what moves, where its task begins unless that is said.
    pub(in crate::closure) fn declared(&self) -> Vec<f64> {
        let moving = self.linkage.drive(self.linkage.span().limits().0);
        let ranges = self.linkage.ranges();
        let at = ranges.iter().enumerate().map(|(index, range)| {
            let first = moving.as_ref().and_then(|place| place.get(index).copied());
            match first.filter(|_| range.start.is_nan()) {
                Some(first) => first,
                None => range.start,
            }
        });
        at.collect()
    }

    /// Puts the linkage together at these values of the independent variables, in the modes nearest to rough values of
    /// the dependent coordinates (NaN where nothing is known).
    ///
    /// # Errors
    /// As [`Assembly::start`].
    pub fn start_at(&mut self, at: &[f64], near: &[f64]) -> Result<Start, ClosureError> {
        if at.len() != self.independents.len() || at.iter().any(|value| !value.is_finite()) {
            return Err(ClosureError::BadRange {
                reason: format!(
                    "a start at {at:?}: expected {} finite values",
                    self.independents.len()
                ),
            });
        }
        let independents: Vec<S> = at.iter().map(|value| S::from_f64(*value)).collect();
        if self.entry.groups.is_empty() {
            self.put(&independents)?;
            return Ok(Start::default());
        }
        let instant = self.instant_at(&independents);
        let unknown = |group: &usize| {
            let unknowns = self.entry.groups[*group].unknowns;
            unknowns.iter().all(|&j| near[j].is_nan())
        };
        let free: Vec<usize> = (0..self.entry.groups.len()).filter(unknown).collect();
        let choices: Vec<usize> = free
            .iter()
            .copied()
            .filter(|&group| self.entry.groups[group].kind.has_modes())
            .collect();
        let kept = self.groups.modes.to_vec();
        let outcome = self.place_freely(at, &instant, near, &choices);
        let is_near = outcome.is_ok() && self.is_near(&instant, near);
        if !is_near && !self.place_nearest(at, &instant, near, outcome.is_ok()) {
            outcome.inspect_err(|_| self.groups.modes.copy_from_slice(&kept))?;
        }
        let contradicted = self.contradicted(&instant, near);
        self.settle(&independents, &instant);
        let assumed =
            free.into_iter().filter(|&group| self.entry.groups[group].kind != GroupKind::Linear);
        Ok(Start { assumed: assumed.collect(), contradicted })
    }

    /// Closes all groups near rough values, those without any in the first modes that lead to an assembled linkage.
    fn place_freely(
        &mut self,
        at: &[f64],
        instant: &[S],
        near: &[f64],
        choices: &[usize],
    ) -> Result<(), ClosureError> {
        let mut first = Ok(());
        for bits in 0..1u64 << choices.len().min(16) {
            for (k, &group) in choices.iter().enumerate() {
                self.groups.modes[group] = S::from_f64(if bits >> k & 1 == 0 { 1.0 } else { -1.0 });
            }
            let outcome = self.place_all(at, instant, near);
            if outcome.is_ok() {
                return outcome;
            }
            first = first.and(outcome);
        }
        first
    }

    /// Closes all groups near rough values.
    pub(super) fn place_all(
        &mut self,
        at: &[f64],
        instant: &[S],
        near: &[f64],
    ) -> Result<(), ClosureError> {
        self.place_some(0..self.entry.groups.len(), at, instant, near)
    }

    /// Closes some groups near rough values, each after those that it needs.
    pub(in crate::closure) fn place_some(
        &mut self,
        groups: impl IntoIterator<Item = usize>,
        at: &[f64],
        instant: &[S],
        near: &[f64],
    ) -> Result<(), ClosureError> {
        for group in groups {
            let sine = match self.entry.groups[group].kind {
                GroupKind::General => self.place_iterated(group, at, instant, near)?,
                GroupKind::Linear => self.closed(group, instant, 1.0),
                _ => self.place_dyad(group, at, instant, near)?,
            };
            if sine.is_nan() || sine == 0.0 {
                return Err(self.explain(group, at, instant));
            }
            self.next.sines[group] = S::from_f64(sine);
            self.unwrap_towards(group, near);
        }
        Ok(())
    }

    /// Closes a group in closed form in a mode.
    pub(in crate::closure) fn closed(&mut self, group: usize, instant: &[S], mode: f64) -> f64 {
        let mode = S::from_f64(mode);
        self.loops.close(group, instant, mode, self.trial).to_f64()
    }

    /// Closes a group in the mode nearest to rough values, or in the mode that is set if there are none.
    fn place_dyad(
        &mut self,
        group: usize,
        at: &[f64],
        instant: &[S],
        near: &[f64],
    ) -> Result<f64, ClosureError> {
        let unknowns = self.entry.groups[group].unknowns;
        let mut candidates = [Vec::new(), Vec::new()];
        for (candidate, mode) in candidates.iter_mut().zip([1.0, -1.0]) {
            if self.closed(group, instant, mode).is_nan() {
                return Err(self.explain(group, at, instant));
            }
            candidate.extend(unknowns.iter().map(|&j| self.trial[j].to_f64()));
        }
        self.newton.sine(self.loops, group, instant, self.trial);
        let wanted: Vec<f64> = unknowns.iter().map(|&j| near[j]).collect();
        let [plus, minus] = &candidates;
        let apart = self.distance(group, plus, minus);
        if apart < COINCIDENT {
            return Err(ClosureError::Ambiguous { group, at: at.to_vec(), apart });
        }
        let (to_plus, to_minus) =
            (self.distance(group, plus, &wanted), self.distance(group, minus, &wanted));
        let stated = wanted.iter().any(|value| !value.is_nan());
        if stated && (to_plus - to_minus).abs() <= UNDECIDED * apart {
            return Err(ClosureError::Ambiguous { group, at: at.to_vec(), apart });
        }
        if stated {
            self.groups.modes[group] = S::from_f64(if to_plus < to_minus { 1.0 } else { -1.0 });
        }
        let mode = self.mode(group);
        Ok(self.closed(group, instant, mode))
    }

    /// Distance between unknowns of a group, in radians or lengths of its longest link. What is NaN does not count.
    fn distance(&self, group: usize, from: &[f64], to: &[f64]) -> f64 {
        let unknowns = self.entry.groups[group].unknowns;
        let units = self.newton.units();
        let parts = unknowns.iter().enumerate().map(|(k, &j)| {
            let change = from[k] - to[k];
            if self.entry.angles[j] {
                (change + PI).rem_euclid(TAU) - PI
            } else {
                change / units[k]
            }
        });
        parts.filter(|part| !part.is_nan()).map(|part| part * part).sum::<f64>().sqrt()
    }

    /// Closes a group by iteration from rough values.
    fn place_iterated(
        &mut self,
        group: usize,
        at: &[f64],
        instant: &[S],
        near: &[f64],
    ) -> Result<f64, ClosureError> {
        for &j in self.entry.groups[group].unknowns {
            let value = if near[j].is_nan() { 0.0 } else { near[j] };
            self.trial[j] = S::from_f64(value);
        }
        let closed = self.newton.close(self.loops, group, instant, self.trial);
        match closed {
            Ok(closed) => Ok(closed.sine),
            Err(failure) => Err(failure_at(failure, group, at)),
        }
    }

    /// Adds whole turns to the angles of a group, so that they are nearest to rough values.
    fn unwrap_towards(&mut self, group: usize, near: &[f64]) {
        for &j in self.entry.groups[group].unknowns {
            let angle = self.trial[j].to_f64();
            let turns = if self.entry.angles[j]
                && self.entry.groups[group].kind.has_modes()
                && near[j].is_finite()
            {
                TAU * ((near[j] - angle) / TAU).round()
            } else {
                0.0
            };
            self.turns[j] = S::from_f64(turns);
            self.trial[j] = S::from_f64(angle + turns);
        }
    }

    /// Begins the motion where the groups have been closed.
    fn settle(&mut self, independents: &[S], instant: &[S]) {
        let unknown = S::from_f64(f64::NAN);
        self.next.changes.fill(unknown);
        self.independents.copy_from_slice(independents);
        self.accept(independents, instant);
        self.heading.fill(unknown);
        self.stands.clear();
        self.events.clear();
    }

    /// Says why a group in closed form has no position where the groups before it are closed.
    pub(super) fn explain(&mut self, group: usize, at: &[f64], instant: &[S]) -> ClosureError {
        let at = at.to_vec();
        if self.entry.groups[group].kind == GroupKind::General {
            return ClosureError::Ambiguous { group, at, apart: 0.0 };
        }
        let margin = self.loops.margin(group, instant, self.trial).to_f64();
        if margin < -ROUNDING * self.reach(group, instant) {
            return ClosureError::NotAssembled { group, at, gap: -margin };
        }
        if margin.is_nan() {
            return ClosureError::NotFinite { group, at };
        }
        ClosureError::Ambiguous { group, at, apart: 0.0 }
    }

    /// Length of the longest link of a group, as its equations see it.
    pub(in crate::closure) fn reach(&mut self, group: usize, instant: &[S]) -> f64 {
        for &j in self.entry.groups[group].unknowns {
            if !self.trial[j].to_f64().is_finite() {
                self.trial[j] = S::ZERO;
            }
        }
        self.newton.sine(self.loops, group, instant, self.trial);
        self.newton.columns().iter().fold(0.0, |most: f64, length| most.max(*length))
    }
}

/// The error for an iteration that did not close a group.
pub(super) fn failure_at(failure: Failure, group: usize, at: &[f64]) -> ClosureError {
    let at = at.to_vec();
    match failure.stop {
        Stop::Stalled => ClosureError::NotAssembled { group, at, gap: failure.reached.residual },
        Stop::NotFinite => ClosureError::NotFinite { group, at },
        Stop::Exhausted => ClosureError::NotConverged {
            group,
            at,
            residual: failure.reached.residual,
            iterations: failure.reached.iterations,
            sine: failure.reached.sine,
        },
    }
}
