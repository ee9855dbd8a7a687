//! The equations of a scene as what the stages of a step ask for.

use super::{Equations, Phase};
use crate::scalar::Scalar;

/// What the stages of a step ask for, one behind the other: what a call has made ready is there for the next.
pub trait Staged<S> {
    /// Length of the state.
    fn length(&self) -> usize;

    /// Length of what depends on the time alone.
    fn instant(&self) -> usize;

    /// Writes that for several times, a row each.
    fn instants(&mut self, times: &[S], rows: &mut [S]);

    /// Writes the rates of a state.
    fn rates(&mut self, instant: &[S], state: &[S], rates: &mut [S]);
}

/// A motion alone, one call for each evaluation.
#[derive(Debug)]
pub struct Alone<'a, S, E: ?Sized> {
    /// Its equations.
    pub equations: &'a E,
    /// Where they hold.
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
    fn instants(&mut self, times: &[S], rows: &mut [S]) {
        self.equations.instants(self.phase, times, rows);
    }

    #[inline(always)]
    fn rates(&mut self, instant: &[S], state: &[S], rates: &mut [S]) {
        self.equations.rates(self.phase, instant, state, rates);
    }
}

/// A motion, and behind it one column of its variation for each state.
#[derive(Debug)]
pub struct Beside<'a, S, E: ?Sized> {
    /// Its equations.
    pub equations: &'a E,
    /// Where they hold.
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
    fn instants(&mut self, times: &[S], rows: &mut [S]) {
        self.equations.instants(self.phase, times, rows);
    }

    #[inline(always)]
    fn rates(&mut self, instant: &[S], state: &[S], rates: &mut [S]) {
        let states = self.equations.states();
        let (state, columns) = state.split_at(states);
        let (rates, products) = rates.split_at_mut(states);
        self.equations.variation(self.phase, instant, state, rates, columns, products);
    }
}
