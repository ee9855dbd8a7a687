//! What the solvers ask of a motion with modes.

use crate::problem::{Equations, Scene};
use crate::scalar::Scalar;

/// Equations of a motion that is in one of several modes. All modes have the same state vector; what a mode does not
/// have stands still in it.
pub trait Modes<S: Scalar>: Equations<S> {
    /// The mode.
    fn mode(&self) -> usize;

    /// Goes into a mode.
    fn enter(&mut self, mode: usize);

    /// Puts the equations of this mode on a side of a switching surface, 1 or −1; 0 leaves it to their values.
    fn side(&mut self, surface: usize, side: S);

    /// Writes the guards of the events of this mode, behind them its kinks ([`ModeEntry::kinks`](crate::shape::ModeEntry::kinks)) and its
    /// angles ([`ModeEntry::turns`](crate::shape::ModeEntry::turns)), and the time derivatives of all.
    fn guards(
        &self,
        instant: &Self::Instant,
        state: &Self::State,
        values: &mut [S],
        rates: &mut [S],
    );

    /// The same at a time.
    fn look(&self, time: S, state: &Self::State, values: &mut [S], rates: &mut [S]) {
        self.guards(&self.instant(time), state, values, rates);
    }

    /// Whether what else an event of this mode asks for holds; asked of those that ask for more than their guard.
    fn permits(&self, event: usize, instant: &Self::Instant, state: &Self::State) -> bool;

    /// Writes the state after an event of this mode; asked of those that set something.
    fn jump(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        after: &mut Self::State,
    );
}

/// What the equations of one mode say of its events, as emitted code states it; [`composite!`](crate::composite) makes
/// [`Modes`] of them. What a mode does not have is left out.
#[doc(hidden)]
pub trait InMode<S: Scalar>: Equations<S> {
    /// See [`Modes::side`].
    #[inline(always)]
    fn side(&mut self, _surface: usize, _side: S) {}

    /// See [`Modes::guards`].
    #[inline(always)]
    fn guards(
        &self,
        _instant: &Self::Instant,
        _state: &Self::State,
        _values: &mut [S],
        _rates: &mut [S],
    ) {
    }

    /// See [`Modes::permits`].
    #[inline(always)]
    fn permits(&self, _event: usize, _instant: &Self::Instant, _state: &Self::State) -> bool {
        true
    }

    /// See [`Modes::jump`].
    #[inline(always)]
    fn jump(
        &self,
        _event: usize,
        _instant: &Self::Instant,
        state: &Self::State,
        after: &mut Self::State,
    ) {
        after.clone_from(state);
    }

    /// See [`Sensitive::guard_slopes`].
    #[inline(always)]
    fn guard_slopes(
        &self,
        _event: usize,
        _instant: &Self::Instant,
        _state: &Self::State,
        _slopes: &mut Self::State,
    ) {
    }

    /// See [`Sensitive::jump_slopes`].
    #[inline(always)]
    fn jump_slopes(
        &self,
        _event: usize,
        _instant: &Self::Instant,
        _state: &Self::State,
        _columns: &mut [Self::State],
        _rate: &mut Self::State,
    ) -> bool {
        false
    }
}

/// Equations whose variations pass through their events.
pub trait Sensitive<S: Scalar>: Modes<S> {
    /// Writes the derivatives of the guard of an event of this mode by the state.
    fn guard_slopes(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        slopes: &mut Self::State,
    );

    /// Writes the derivatives of the state after an event of this mode by the state before it, column by column, and its
    /// total time derivative along the motion in this mode. False, and nothing is written, where the event sets nothing.
    fn jump_slopes(
        &self,
        event: usize,
        instant: &Self::Instant,
        state: &Self::State,
        columns: &mut [Self::State],
        rate: &mut Self::State,
    ) -> bool;
}

/// A scene whose motion has modes, or events.
pub trait Hybrid: Scene {
    /// The equations, prepared for a scalar type.
    type Modal<S: Scalar>: Modes<S> + Clone + Send + Sync;

    /// Computes what depends on the parameters alone.
    fn modal<S: Scalar>(&self) -> Self::Modal<S>;
}

/// The equations of a scene in each of its modes.
pub(crate) fn in_each_mode<C: Hybrid>(scene: &C) -> Vec<C::Modal<f64>> {
    let modes = (0..C::shape().modes.len()).map(|mode| {
        let mut equations = scene.modal::<f64>();
        equations.enter(mode);
        equations
    });
    modes.collect()
}
