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
//! Whatever is not certain goes the careful way of [`crate::closure::passage::continuation`]. A group that is iterated
//! must besides be found near where its kinematic coefficients predicted it.

use super::guide::{Guide, Moves, Rest, plain, weakest};
use super::start::Start;
use crate::closure::error::ClosureError;
use crate::closure::linkage::loops::Apart;
use crate::closure::linkage::problem::{Closure, Linkage};
use crate::scalar::Scalar;

/// Position of a linkage.
pub(super) type Position<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Position;
/// What depends on the independent variables of a linkage alone.
type Instant<L, S> = <<L as Linkage>::Closure<S> as Closure<S>>::Instant;

/// Where the groups stand: an entry for each. There are no more groups than unknowns, so that a position holds them.
pub(in crate::closure) struct Groups<V> {
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
    linkage: L,
    pub(super) closure: Apart<L::Closure<S>>,
    /// The independent variables.
    pub(super) independents: Vec<S>,
    /// What depends on them alone.
    pub(in crate::closure) instant: Instant<L, S>,
    /// Their change in the last step.
    pub(super) heading: Vec<S>,
    pub(super) position: Position<L, S>,
    /// Whole turns that angles have made, in radians.
    pub(in crate::closure) turns: Position<L, S>,
    pub(in crate::closure) groups: Groups<Position<L, S>>,
    rest: Rest<S>,
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// A linkage that is not yet put together: call [`Assembly::start`] next.
    pub fn new(linkage: &L) -> Self {
        let values: Vec<S> = Linkage::values(linkage).into_iter().map(S::from_f64).collect();
        let (unknown, shape) = (S::from_f64(f64::NAN), Linkage::shape(linkage));
        let independents = vec![unknown; shape.drivers.len()];
        let (closure, instant) = S::outline(
            #[inline(always)]
            || {
                let closure = linkage.prepare(&values);
                let instant = closure.instant(&independents);
                (closure, instant)
            },
        );
        let all = |value: S| {
            let mut all = closure.zeros();
            all.as_mut().fill(value);
            all
        };
        let length = closure.zeros().as_ref().len();
        Self {
            linkage: linkage.clone(),
            rest: Rest::new(shape, length, instant.as_ref().len()),
            instant,
            heading: independents.clone(),
            independents,
            position: closure.zeros(),
            turns: closure.zeros(),
            groups: Groups { modes: all(S::ONE), sines: all(unknown), changes: all(unknown) },
            closure: Apart(closure),
        }
    }

    /// All of it, whichever linkage it is of.
    #[inline]
    pub fn guide(&mut self) -> Guide<'_, S> {
        let (groups, rest) = (&mut self.groups, &mut self.rest);
        Guide {
            linkage: &self.linkage,
            loops: &self.closure,
            entry: self.closure.0.shape().loops(),
            independents: &mut self.independents,
            instant: self.instant.as_mut(),
            heading: &mut self.heading,
            position: self.position.as_mut(),
            turns: self.turns.as_mut(),
            groups: Groups {
                modes: groups.modes.as_mut(),
                sines: groups.sines.as_mut(),
                changes: groups.changes.as_mut(),
            },
            trial: &mut rest.trial,
            next: &mut rest.next,
            ahead: &mut rest.ahead,
            columns: &mut rest.columns,
            newton: &mut rest.newton,
            events: &mut rest.events,
            stands: &mut rest.stands,
        }
    }

    /// Puts the linkage together where the start values of the mechanism are meant: where the drivers start, or, if they
    /// move in time and no start is stated, where they are when the task begins.
    ///
    /// # Errors
    /// [`ClosureError`] if it does not assemble there, or if the start values do not tell which mode is meant.
    pub fn start(&mut self) -> Result<Start, ClosureError> {
        self.guide().start()
    }

    /// Puts the linkage together at these values of the independent variables, in the modes nearest to rough values of
    /// the dependent coordinates (NaN where nothing is known).
    ///
    /// # Errors
    /// As [`Assembly::start`].
    pub fn start_at(&mut self, at: &[f64], near: &[f64]) -> Result<Start, ClosureError> {
        self.guide().start_at(at, near)
    }

    /// Moves to other values of the independent variables without leaving the modes, by one step where that is certain
    /// and carefully elsewhere. For numbers of one lane.
    ///
    /// # Errors
    /// [`ClosureError`], with the place. The linkage then stays at the last position that was reached with certainty.
    #[inline(always)]
    pub fn move_to(&mut self, independents: &[S]) -> Result<(), ClosureError> {
        let entry = self.closure.0.shape().loops();
        if entry.groups.is_empty() {
            return self.guide().put(independents);
        }
        if entry.is_iterated() {
            return self.guide().advance(independents);
        }
        match self.step(independents) {
            true => Ok(()),
            false => self.guide().follow(independents),
        }
    }

    /// Moves a long way in several steps, so that nothing on it is missed.
    ///
    /// # Errors
    /// As [`Assembly::move_to`].
    pub fn travel(&mut self, target: &[S]) -> Result<(), ClosureError> {
        let (count, from) = (self.guide().parts(target), self.guide().place());
        let mut moved = |place: &[S]| {
            S::outline(
                #[inline(always)]
                || self.move_to(place),
            )
        };
        let mut place = target.to_vec();
        let mut number = 1.0;
        while number < count {
            for ((value, to), from) in place.iter_mut().zip(target).zip(&from) {
                *value = S::from_f64(from + (to.to_f64() - from) * (number / count));
            }
            moved(&place)?;
            number += 1.0;
        }
        moved(target)
    }

    /// Passes through the dead point on the way to these independent variables, by the length of the curve of positions,
    /// back to where the linkage stands, on the other mode.
    ///
    /// # Errors
    /// [`ClosureError::ModeLost`] if there is no dead point on this way, or the curve could not be followed.
    pub fn pass_dead_point(&mut self, wanted: &[f64]) -> Result<(), ClosureError> {
        self.guide().pass_dead_point(wanted)
    }

    /// The position: the dependent coordinates first, angles continued over whole turns.
    #[inline(always)]
    pub fn position(&self) -> &Position<L, S> {
        &self.position
    }

    /// The loops, prepared.
    #[inline(always)]
    pub fn closure(&self) -> &L::Closure<S> {
        &self.closure.0
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

    /// The group nearest to a dead point, and its sine.
    #[inline(always)]
    pub fn weakest(&self) -> (usize, f64) {
        let groups = self.closure.0.shape().loops().groups.len();
        weakest(&self.groups.sines.as_ref()[..groups])
    }

    /// The dependent coordinates as plain numbers.
    pub fn coordinates(&self) -> Vec<f64> {
        let dependents = self.closure.0.shape().loops().dependents.len();
        plain(&self.position.as_ref()[..dependents])
    }

    /// Writes the outputs at the position.
    #[inline(always)]
    pub fn outputs(&self, values: &mut [S]) {
        self.closure.0.outputs(&self.instant, &self.position, values);
    }

    /// Writes the influence coefficients at the position: outputs by
    /// [`LinkageEntry::variables`](crate::shape::LinkageEntry::variables).
    #[inline(always)]
    pub fn influence(&self, values: &mut [S]) {
        self.closure.0.influence(&self.instant, &self.position, values);
    }

    /// What happened since this was asked last.
    pub fn take_events(&mut self) -> Vec<Event> {
        self.guide().take_events()
    }
}

impl<L: Linkage> Moves for Assembly<L, f64> {
    fn guide(&mut self) -> Guide<'_, f64> {
        Self::guide(self)
    }

    fn move_to(&mut self, independents: &[f64]) -> Result<(), ClosureError> {
        Self::move_to(self, independents)
    }

    fn travel(&mut self, target: &[f64]) -> Result<(), ClosureError> {
        Self::travel(self, target)
    }
}
