//! The equations of a scene as what the stages of a step ask for.

use crate::ode::step::Staged;
use crate::problem::{Equations, Phase};
use crate::scalar::Scalar;

/// A motion alone.
pub(super) struct Alone<'a, S, E: ?Sized> {
    pub equations: &'a E,
    pub phase: Phase<'a, S>,
}

impl<S: Scalar, E: Equations<S> + ?Sized> Staged<S> for Alone<'_, S, E> {
    #[inline(always)]
    fn length(&self) -> usize {
        self.equations.states()
    }

    #[inline(always)]
    fn instant(&self) -> usize {
        self.equations.instant()
    }

    #[inline(always)]
    fn instants(&self, times: &[S], rows: &mut [S]) {
        self.equations.instants(self.phase, times, rows);
    }

    #[inline(always)]
    fn rates(&self, instant: &[S], state: &[S], rates: &mut [S]) {
        self.equations.rates(self.phase, instant, state, rates);
    }
}

/// A motion, and behind it one column of its variation for each state.
pub(super) struct Beside<'a, S, E: ?Sized> {
    pub equations: &'a E,
    pub phase: Phase<'a, S>,
}

impl<S: Scalar, E: Equations<S> + ?Sized> Staged<S> for Beside<'_, S, E> {
    #[inline(always)]
    fn length(&self) -> usize {
        let states = self.equations.states();
        states * (1 + states)
    }

    #[inline(always)]
    fn instant(&self) -> usize {
        self.equations.instant()
    }

    #[inline(always)]
    fn instants(&self, times: &[S], rows: &mut [S]) {
        self.equations.instants(self.phase, times, rows);
    }

    #[inline(always)]
    fn rates(&self, instant: &[S], state: &[S], rates: &mut [S]) {
        let states = self.equations.states();
        let (state, columns) = state.split_at(states);
        let (rates, products) = rates.split_at_mut(states);
        self.equations.variation(self.phase, instant, state, rates, columns, products);
    }
}
