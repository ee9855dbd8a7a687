//! A linkage put together and moved: its position, with the assembly mode of each group.
//!
//! [`Assembly::move_to`] closes the groups one after the other with the modes they have and then asks whether they can
//! have been left on the way. In closed form the sine of the transmission angle has the sign of the mode, so a mode can
//! only be left where that sine passes through zero. With `s₀`, `s₁` the sines before and after the step, `s*` what the
//! step before lets expect of `s₁`, and `Δ` the sum of the turns of the links of the group, the step is certain if
//!
//! ```text
//! |s₀ + s₁| > 2 Δ + 4 |s₁ - s*|    and    |s₀ + s₁| > 2 |s₁ - s₀|
//! ```
//!
//! The sine cannot have gone to zero while the links turned so little and it changed so little; and what returns from
//! zero on the wrong side, or from beyond a gap, with the same sine as before, is not what was expected.
//! Whatever is not certain goes the careful way of [`super::continuation`]. A group that is iterated must besides be found
//! near where its kinematic coefficients predicted it.

use super::error::ClosureError;
use super::newton::{Instant, Newton, Position};
use super::problem::{Closure, GroupKind, Linkage};
use super::stand::Stand;
use super::step::Passage;
use crate::scalar::Scalar;

/// Where the groups stand: an entry for each. There are no more groups than unknowns, so that a position holds them.
pub(super) struct Groups<V> {
    /// Assembly modes, ±1.
    pub modes: V,
    /// Sines of the transmission angles.
    pub sines: V,
    /// How much those changed in the last step.
    pub changes: V,
}

/// Something that happened while a mode was followed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// Two modes met and both went on. The smooth continuation has the other sign.
    ChangePoint {
        /// The group concerned.
        group: usize,
        /// The independent variables there.
        at: Vec<f64>,
        /// The assembly mode after it.
        mode: f64,
    },
    /// Two modes met and ended. The motion went back on the other one.
    DeadPoint {
        /// The group concerned.
        group: usize,
        /// The independent variables there.
        at: Vec<f64>,
        /// The assembly mode after it.
        mode: f64,
    },
}

/// A linkage with its dimensions fixed, its position and the modes it is assembled in. Moving it allocates nothing,
/// except near singular positions.
pub struct Assembly<L: Linkage, S: Scalar> {
    pub(super) linkage: L,
    pub(super) closure: L::Closure<S>,
    /// The independent variables.
    pub(super) independents: Vec<S>,
    /// What depends on them alone.
    pub(super) instant: Instant<L, S>,
    /// Their change in the last step.
    pub(super) heading: Vec<S>,
    pub(super) position: Position<L, S>,
    /// The position after a step that is not yet accepted.
    pub(super) trial: Position<L, S>,
    /// Whole turns that angles have made, in radians.
    pub(super) turns: Position<L, S>,
    pub(super) groups: Groups<Position<L, S>>,
    /// The same after a step that is not yet accepted.
    pub(super) next: Groups<Position<L, S>>,
    /// The kinematic coefficients; used only if a group is iterated.
    pub(super) columns: Vec<Position<L, S>>,
    pub(super) newton: Newton<L, S>,
    pub(super) events: Vec<Event>,
    /// The groups that stand exactly at a change point.
    pub(super) stands: Vec<Stand>,
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// Whether there is nothing to close: formulas over drivers. What closes loops is then not even compiled.
    pub(super) const LOOSE: bool = L::GROUPS.is_empty();

    /// A linkage that is not yet put together: call [`Assembly::start`] next.
    pub fn new(linkage: &L) -> Self {
        let values: Vec<S> = linkage.values().into_iter().map(S::from_f64).collect();
        let unknown = S::from_f64(f64::NAN);
        let independents = vec![unknown; L::INDEPENDENTS];
        let (closure, instant) = S::outline(
            #[inline(always)]
            || {
                let closure = L::prepare(&values);
                let instant = closure.instant(&independents);
                (closure, instant)
            },
        );
        let all = |value: S| {
            let mut all = closure.zeros();
            all.as_mut().fill(value);
            all
        };
        let groups = || Groups {
            modes: all(S::ONE),
            sines: all(unknown),
            changes: all(unknown),
        };
        Self {
            linkage: linkage.clone(),
            instant,
            independents,
            heading: vec![unknown; L::INDEPENDENTS],
            position: closure.zeros(),
            trial: closure.zeros(),
            turns: closure.zeros(),
            groups: groups(),
            next: groups(),
            columns: vec![closure.zeros(); L::INDEPENDENTS],
            newton: Newton::new(),
            events: Vec::new(),
            stands: Vec::new(),
            closure,
        }
    }

    /// Moves to other values of the independent variables without leaving the modes, by one step where that is certain
    /// and carefully elsewhere. For numbers of one lane.
    ///
    /// # Errors
    /// [`ClosureError`], with the place. The linkage then stays at the last position that was reached with certainty.
    #[inline(always)]
    pub fn move_to(&mut self, independents: &[S]) -> Result<(), ClosureError> {
        if Self::LOOSE {
            return self.put(independents);
        }
        if !Self::iterates() {
            return match self.step(independents) {
                true => Ok(()),
                false => self.follow(independents),
            };
        }
        let instant = self.closure.instant(independents);
        let ratio = self.ratio(independents);
        if self.close(independents, &instant, ratio) {
            self.accept(independents, &instant);
            return Ok(());
        }
        self.follow(independents)
    }

    /// Goes anywhere, where there is nothing to close.
    pub(super) fn put(&mut self, independents: &[S]) -> Result<(), ClosureError> {
        if let Some(bad) = independents.iter().find(|one| !one.to_f64().is_finite()) {
            let reason = format!("an independent variable is {}", bad.to_f64());
            return Err(ClosureError::BadRange { reason });
        }
        let instant = self.instant_at(independents);
        S::outline(
            #[inline(always)]
            || self.accept(independents, &instant),
        );
        Ok(())
    }

    /// What depends on the independent variables alone, for code that is not compiled for the instructions of the numbers.
    pub(super) fn instant_at(&self, independents: &[S]) -> Instant<L, S> {
        S::outline(
            #[inline(always)]
            || self.closure.instant(independents),
        )
    }

    /// Closes all groups and says whether they have certainly kept their modes. The last step goes into this one `ratio`
    /// times.
    #[inline(always)]
    fn close(&mut self, independents: &[S], instant: &Instant<L, S>, ratio: S) -> bool {
        /// Written out for the first groups, so that what is known of each is known to the compiler.
        macro_rules! written_out {
            ($($index:literal)*) => {{
                let mut certain = true;
                $(if L::GROUPS.len() > $index {
                    certain &= self.close_one($index, independents, instant, ratio);
                })*
                certain
            }};
        }
        let mut certain = written_out!(0 1 2 3 4 5);
        for index in 6..L::GROUPS.len() {
            certain &= self.close_one(index, independents, instant, ratio);
        }
        certain
    }

    /// Closes one group.
    #[inline(always)]
    fn close_one(
        &mut self,
        index: usize,
        independents: &[S],
        instant: &Instant<L, S>,
        ratio: S,
    ) -> bool {
        let group = &L::GROUPS[index];
        let before = self.groups.sines.as_ref()[index];
        let expected = self.groups.changes.as_ref()[index].mul_add(ratio, before);
        let (sine, mut turned) = if let GroupKind::General = group.kind {
            self.iterate(index, independents, instant)
        } else {
            let mode = self.groups.modes.as_ref()[index];
            let sine = self.closure.close(index, instant, mode, &mut self.trial);
            (sine, S::ZERO)
        };
        if group.kind.has_modes() {
            let (trial, position) = (self.trial.as_mut(), self.position.as_ref());
            for &j in group.unknowns {
                if L::ANGLES[j] {
                    trial[j] = trial[j] + self.turns.as_ref()[j];
                    turned = turned + (trial[j] - position[j]).abs();
                }
            }
        }
        self.next.sines.as_mut()[index] = sine;
        self.next.changes.as_mut()[index] = sine - before;
        let passage = Passage {
            before,
            sine,
            expected,
            turned,
        };
        passage.certainly_keeps(group.kind)
    }

    /// Makes the position that was tried the position.
    #[inline(always)]
    pub(super) fn accept(&mut self, independents: &[S], instant: &Instant<L, S>) {
        self.head(independents);
        self.accept_groups(instant);
    }

    /// Takes other independent variables, and how they have changed.
    #[inline(always)]
    pub(super) fn head(&mut self, independents: &[S]) {
        if L::INDEPENDENTS == 1 {
            self.heading[0] = independents[0] - self.independents[0];
            self.independents[0] = independents[0];
            return;
        }
        let known = self.independents.iter_mut().zip(&mut self.heading);
        for (value, (kept, heading)) in independents.iter().zip(known) {
            *heading = *value - *kept;
            *kept = *value;
        }
    }

    #[inline(always)]
    fn accept_groups(&mut self, instant: &Instant<L, S>) {
        self.position.clone_from(&self.trial);
        for index in 0..L::GROUPS.len() {
            self.groups.sines.as_mut()[index] = self.next.sines.as_ref()[index];
            self.groups.changes.as_mut()[index] = self.next.changes.as_ref()[index];
        }
        self.instant.clone_from(instant);
        if Self::iterates() {
            self.closure
                .coefficients(instant, &self.position, &mut self.columns);
        }
    }

    /// How often the last step goes into the one to these independent variables; NaN if its direction is another.
    #[inline(always)]
    pub(super) fn ratio(&self, independents: &[S]) -> S {
        if let ([to], [from], [heading]) = (independents, &self.independents[..], &self.heading[..])
        {
            return (*to - *from) / *heading;
        }
        self.ratio_of_many(independents)
    }

    /// The same for several independent variables.
    fn ratio_of_many(&self, independents: &[S]) -> S {
        let (mut square, mut along, mut size) = (0.0, 0.0, 0.0);
        for (k, to) in independents.iter().enumerate() {
            let heading = self.heading[k].to_f64();
            let change = (*to - self.independents[k]).to_f64();
            square += heading * heading;
            along += heading * change;
            size += change * change;
        }
        let aligned = along.abs() >= (1.0 - 1e-12) * (square * size).sqrt();
        S::from_f64(match (independents.is_empty(), aligned) {
            (true, _) => 0.0,
            (false, true) => along / square,
            (false, false) => f64::NAN,
        })
    }

    /// Whether a group is iterated.
    #[inline(always)]
    pub(super) fn iterates() -> bool {
        L::GROUPS
            .iter()
            .any(|group| group.kind == GroupKind::General)
    }

    /// The position: the dependent coordinates first, angles continued over whole turns.
    #[inline(always)]
    pub fn position(&self) -> &Position<L, S> {
        &self.position
    }

    /// The loops, prepared.
    #[inline(always)]
    pub fn closure(&self) -> &L::Closure<S> {
        &self.closure
    }

    /// The independent variables.
    #[inline(always)]
    pub fn independents(&self) -> &[S] {
        &self.independents
    }

    /// The assembly mode of a group, ±1; without meaning for groups that have none.
    pub fn mode(&self, group: usize) -> f64 {
        self.groups.modes.as_ref()[group].to_f64()
    }

    /// Sine of the transmission angle of a group; its smallness says how near a dead point is.
    pub fn sine(&self, group: usize) -> f64 {
        self.groups.sines.as_ref()[group].to_f64()
    }

    /// Writes the outputs at the position.
    #[inline(always)]
    pub fn outputs(&self, values: &mut [S]) {
        self.closure.outputs(&self.instant, &self.position, values);
    }

    /// Writes the influence coefficients at the position: outputs by [`Linkage::VARIABLES`].
    #[inline(always)]
    pub fn influence(&self, values: &mut [S]) {
        self.closure
            .influence(&self.instant, &self.position, values);
    }

    /// What happened since this was asked last.
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }

    /// The independent variables as plain numbers.
    pub(super) fn place(&self) -> Vec<f64> {
        self.independents
            .iter()
            .map(|value| value.to_f64())
            .collect()
    }
}
