//! A motion for the stages of a step: registers are taken once for all of them.

use assur_solvers::problem::{Equations, Phase, Staged};
use assur_solvers::scalar::Scalar;

use super::equations::{Function, Prepare};
use super::functions::Prepared;
use super::room::room;
use crate::machine::{Calls, Columns};

/// A motion alone; nothing is written where there is no such mode.
pub struct Alone<'a, S: Scalar> {
    prepare: &'a Prepare<S>,
    phase: Phase<'a, S>,
    rates: Option<Calls<'a, S>>,
}

impl<'a, S: Scalar> Alone<'a, S> {
    pub fn new(prepare: &'a Prepare<S>, phase: Phase<'a, S>) -> Self {
        let mode = prepare.mode(phase.mode);
        Self { prepare, phase, rates: mode.map(|mode| mode.calls(Function::Rates)) }
    }
}

impl<S: Scalar> Staged<S> for Alone<'_, S> {
    fn length(&self) -> usize {
        self.prepare.states()
    }

    fn instant(&self) -> usize {
        self.prepare.instant()
    }

    fn instants(&mut self, times: &[S], rows: &mut [S]) {
        self.prepare.instants(self.phase, times, rows);
    }

    fn rates(&mut self, instant: &[S], state: &[S], rates: &mut [S]) {
        if let Some(calls) = &mut self.rates {
            calls.call(&[instant, state, self.phase.sides], rates);
        }
    }
}

/// A motion with its variations.
pub struct Beside<'a, S: Scalar> {
    prepare: &'a Prepare<S>,
    phase: Phase<'a, S>,
    way: Option<(&'a Prepared<S>, Way<'a, S>)>,
}

/// How products of the Jacobian with columns are found.
enum Way<'a, S: Scalar> {
    /// From its entries.
    Entries(Calls<'a, S>),
    /// As they are, where it has none.
    Products(Columns<'a, S>),
}

impl<'a, S: Scalar> Beside<'a, S> {
    pub fn new(prepare: &'a Prepare<S>, phase: Phase<'a, S>) -> Self {
        let way = prepare.mode(phase.mode).map(|mode| match mode.program().results.along[..] {
            [] => (mode, Way::Entries(mode.calls(Function::Slopes))),
            _ => (mode, Way::Products(mode.columns(Function::Along))),
        });
        Self { prepare, phase, way }
    }

    /// Writes the rates, and the products with columns.
    pub fn variation(
        &mut self,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    ) {
        let given = &[instant, state, self.phase.sides];
        match &mut self.way {
            None => {}
            Some((_, Way::Products(calls))) => {
                products.copy_from_slice(columns);
                calls.call(given, rates, products);
            }
            Some((mode, Way::Entries(calls))) => {
                let (states, entries) = (state.len(), mode.program().results.jacobian.len());
                room(states + entries, |all| {
                    calls.call(given, all);
                    let (own, entries) = all.split_at(states);
                    rates.copy_from_slice(own);
                    mode.functions.terms.multiply(entries, states, columns, products);
                });
            }
        }
    }
}

impl<S: Scalar> Staged<S> for Beside<'_, S> {
    fn length(&self) -> usize {
        let states = self.prepare.states();
        states * (1 + states)
    }

    fn instant(&self) -> usize {
        self.prepare.instant()
    }

    fn instants(&mut self, times: &[S], rows: &mut [S]) {
        self.prepare.instants(self.phase, times, rows);
    }

    fn rates(&mut self, instant: &[S], state: &[S], rates: &mut [S]) {
        let states = self.prepare.states();
        let (state, columns) = state.split_at(states);
        let (rates, products) = rates.split_at_mut(states);
        self.variation(instant, state, rates, columns, products);
    }
}
