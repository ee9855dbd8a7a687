//! An assembly as whatever is not one certain step sees it: compiled once for all linkages.

use super::assembly::{Event, Groups};
use super::newton::Newton;
use super::step::Passage;
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::loops::Loops;
use crate::closure::passage::stand::Stand;
use crate::scalar::Scalar;
use crate::shape::{GroupKind, LinkageEntry, Shape};

/// What an assembly has besides what a certain step needs.
pub(super) struct Rest<S: Scalar> {
    /// The position after a step that is not yet accepted.
    pub trial: Vec<S>,
    /// Where its groups stand.
    pub next: Groups<Vec<S>>,
    /// What depends on the independent variables alone there.
    pub ahead: Vec<S>,
    /// The kinematic coefficients; used only if a group is iterated.
    pub columns: Vec<S>,
    pub newton: Newton<S>,
    pub events: Vec<Event>,
    /// The groups that stand exactly at a change point.
    pub stands: Vec<Stand>,
}

impl<S: Scalar> Rest<S> {
    /// Of a linkage whose position and whose instant have these lengths.
    pub fn new(shape: &'static Shape, position: usize, instant: usize) -> Self {
        let entry = shape.loops();
        let unknown = || vec![S::from_f64(f64::NAN); position];
        Self {
            trial: vec![S::ZERO; position],
            next: Groups { modes: vec![S::ONE; position], sines: unknown(), changes: unknown() },
            ahead: vec![S::ZERO; instant],
            columns: vec![S::ZERO; shape.drivers.len() * entry.dependents.len()],
            newton: Newton::new(shape),
            events: Vec::new(),
            stands: Vec::new(),
        }
    }
}

/// All of an assembly, whichever linkage it is of.
pub struct Guide<'a, S: Scalar> {
    pub(crate) linkage: &'a dyn AnyLinkage,
    /// Its loops.
    pub loops: &'a dyn Loops<S>,
    pub(in crate::closure) entry: &'static LinkageEntry,
    /// The independent variables.
    pub independents: &'a mut [S],
    /// What depends on them alone.
    pub(in crate::closure) instant: &'a mut [S],
    /// Their change in the last step.
    pub(super) heading: &'a mut [S],
    /// The position: the dependent coordinates first, angles continued over whole turns.
    pub position: &'a mut [S],
    /// Whole turns that angles have made, in radians.
    pub(in crate::closure) turns: &'a mut [S],
    pub(in crate::closure) groups: Groups<&'a mut [S]>,
    pub(in crate::closure) trial: &'a mut Vec<S>,
    pub(in crate::closure) next: &'a mut Groups<Vec<S>>,
    pub(super) ahead: &'a mut Vec<S>,
    pub(super) columns: &'a mut Vec<S>,
    pub(in crate::closure) newton: &'a mut Newton<S>,
    pub(in crate::closure) events: &'a mut Vec<Event>,
    pub(in crate::closure) stands: &'a mut Vec<Stand>,
}

/// An assembly behind a pointer.
pub trait Moves {
    /// All of it.
    fn guide(&mut self) -> Guide<'_, f64>;

    /// See [`Assembly::move_to`](crate::closure::Assembly::move_to).
    ///
    /// # Errors
    /// As there.
    fn move_to(&mut self, independents: &[f64]) -> Result<(), ClosureError>;

    /// See [`Assembly::travel`](crate::closure::Assembly::travel).
    ///
    /// # Errors
    /// As there.
    fn travel(&mut self, independents: &[f64]) -> Result<(), ClosureError>;
}

impl<S: Scalar> Guide<'_, S> {
    /// Goes anywhere, where there is nothing to close.
    pub(super) fn put(&mut self, independents: &[S]) -> Result<(), ClosureError> {
        if let Some(bad) = independents.iter().find(|one| !one.to_f64().is_finite()) {
            let reason = format!("an independent variable is {}", bad.to_f64());
            return Err(ClosureError::BadRange { reason });
        }
        self.loops.instant(independents, &[], self.instant);
        self.position.copy_from_slice(self.trial);
        self.head(independents);
        Ok(())
    }

    /// Moves a linkage of which a group is iterated, by one step where that is certain and carefully elsewhere.
    pub(super) fn advance(&mut self, independents: &[S]) -> Result<(), ClosureError> {
        let mut instant = std::mem::take(self.ahead);
        self.loops.instant(independents, &[], &mut instant);
        let ratio = self.ratio(independents);
        let mut certain = true;
        for group in 0..self.entry.groups.len() {
            certain &= S::outline(
                #[inline(always)]
                || self.close_one(group, independents, &instant, ratio),
            );
        }
        if certain {
            self.accept(independents, &instant);
        }
        *self.ahead = instant;
        match certain {
            true => Ok(()),
            false => self.follow(independents),
        }
    }

    /// Closes one group, and says whether it has certainly kept its mode. The last step goes into this one `ratio` times.
    #[inline(always)]
    fn close_one(&mut self, index: usize, independents: &[S], instant: &[S], ratio: S) -> bool {
        let group = &self.entry.groups[index];
        let before = self.groups.sines[index];
        let expected = self.groups.changes[index].mul_add(ratio, before);
        let (sine, mut turned) = if group.kind == GroupKind::General {
            self.iterate(index, independents, instant)
        } else {
            let mode = self.groups.modes[index];
            (self.loops.close(index, instant, mode, self.trial), S::ZERO)
        };
        if group.kind.has_modes() {
            for &j in group.unknowns {
                if self.entry.angles[j] {
                    self.trial[j] = self.trial[j] + self.turns[j];
                    turned = turned + (self.trial[j] - self.position[j]).abs();
                }
            }
        }
        self.next.sines[index] = sine;
        self.next.changes[index] = sine - before;
        let passage = Passage { before, sine, expected, turned };
        passage.certainly_keeps(group.kind)
    }

    /// Makes the position that was tried the position.
    pub(in crate::closure) fn accept(&mut self, independents: &[S], instant: &[S]) {
        self.head(independents);
        self.position.copy_from_slice(self.trial);
        for index in 0..self.entry.groups.len() {
            self.groups.sines[index] = self.next.sines[index];
            self.groups.changes[index] = self.next.changes[index];
        }
        self.instant.copy_from_slice(instant);
        if self.entry.is_iterated() {
            self.loops.coefficients(instant, self.position, self.columns);
        }
    }

    /// Takes other independent variables, and how they have changed.
    fn head(&mut self, independents: &[S]) {
        let known = self.independents.iter_mut().zip(&mut *self.heading);
        for (value, (kept, heading)) in independents.iter().zip(known) {
            *heading = *value - *kept;
            *kept = *value;
        }
    }

    /// How often the last step goes into the one to these independent variables; NaN if its direction is another.
    pub(in crate::closure) fn ratio(&self, independents: &[S]) -> S {
        super::step::ratio(independents, self.independents, self.heading)
    }

    /// What depends on the independent variables alone.
    pub(in crate::closure) fn instant_at(&self, independents: &[S]) -> Vec<S> {
        self.loops.instant_row(independents, &[])
    }

    /// The assembly mode of a group, ±1; without meaning for groups that have none.
    pub fn mode(&self, group: usize) -> f64 {
        self.groups.modes[group].to_f64()
    }

    /// Sine of the transmission angle of a group.
    pub fn sine(&self, group: usize) -> f64 {
        self.groups.sines[group].to_f64()
    }

    /// Writes the outputs at the position.
    pub fn outputs(&self, values: &mut [S]) {
        self.loops.outputs(self.instant, self.position, values);
    }

    /// What happened since this was asked last.
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(self.events)
    }

    /// The independent variables as plain numbers.
    pub(in crate::closure) fn place(&self) -> Vec<f64> {
        plain(self.independents)
    }

    /// The dependent coordinates as plain numbers.
    pub fn coordinates(&self) -> Vec<f64> {
        plain(&self.position[..self.entry.dependents.len()])
    }

    /// The group nearest to a dead point, and its sine.
    pub fn weakest(&self) -> (usize, f64) {
        weakest(&self.groups.sines[..self.entry.groups.len()])
    }
}

/// Scalars as plain numbers.
pub(super) fn plain<S: Scalar>(values: &[S]) -> Vec<f64> {
    values.iter().map(|value| value.to_f64()).collect()
}

/// The smallest of some sines, with the number of its group.
#[inline(always)]
pub(super) fn weakest<S: Scalar>(sines: &[S]) -> (usize, f64) {
    let mut least = (0, f64::INFINITY);
    for (group, sine) in sines.iter().enumerate() {
        if sine.to_f64().abs() < least.1.abs() {
            least = (group, sine.to_f64());
        }
    }
    least
}
