//! What the stiff methods integrate.

use crate::ode::System;
use crate::problem::{Equations, Storage};
use std::cell::RefCell;

/// Right-hand sides `y' = f(t, y)` with their Jacobian, behind a pointer: the stiff methods are compiled once for all of
/// them. Beside the linear systems of a stiff step, what a call costs is nothing.
///
/// The methods neither allocate nor panic; a value that does not exist is NaN.
pub trait Rates {
    /// Length of the state vector.
    fn states(&self) -> usize;

    /// Writes `f(t, y)` into `rate`.
    fn rate(&mut self, time: f64, state: &[f64], rate: &mut [f64]);

    /// Writes `∂f/∂y`, column after column: `columns[j * states + i] = ∂f_i/∂y_j`.
    fn jacobian(&mut self, time: f64, state: &[f64], columns: &mut [f64]);
}

/// [`Rates`] of any equations.
#[derive(Clone, Debug)]
pub struct Emitted<'a, E: Equations<f64>> {
    /// The equations.
    equations: &'a E,
    /// Room for a state and its rate.
    state: E::State,
    rate: E::State,
    /// Room for the columns of the Jacobian.
    columns: Vec<E::State>,
}

impl<'a, E: Equations<f64>> Emitted<'a, E> {
    /// Takes the room that evaluations need.
    pub fn new(equations: &'a E) -> Self {
        let states = equations.states();
        let zeros = E::State::zeros(states);
        Self {
            equations,
            state: zeros.clone(),
            rate: zeros.clone(),
            columns: vec![zeros; states],
        }
    }
}

impl<E: Equations<f64>> Rates for Emitted<'_, E> {
    fn states(&self) -> usize {
        self.columns.len()
    }

    fn rate(&mut self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.state.as_mut().copy_from_slice(state);
        let instant = self.equations.instant(time);
        self.equations
            .derivative(&instant, &self.state, &mut self.rate);
        rate.copy_from_slice(self.rate.as_ref());
    }

    fn jacobian(&mut self, time: f64, state: &[f64], columns: &mut [f64]) {
        self.state.as_mut().copy_from_slice(state);
        let instant = self.equations.instant(time);
        self.equations
            .jacobian(&instant, &self.state, &mut self.columns);
        let targets = columns.chunks_exact_mut(self.columns.len().max(1));
        for (target, column) in targets.zip(&self.columns) {
            target.copy_from_slice(column.as_ref());
        }
    }
}

/// [`Rates`] as a system of the explicit methods, so that those too are compiled once where they take turns with the
/// stiff ones.
pub(super) struct Erased<'a>(pub RefCell<&'a mut dyn Rates>);

impl System<f64> for Erased<'_> {
    type State = Vec<f64>;
    type Instant = f64;

    fn zeros(&self) -> Vec<f64> {
        vec![0.0; self.0.borrow().states()]
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [f64; K] {
        times
    }

    fn rate(&self, instant: &f64, state: &Vec<f64>, rate: &mut Vec<f64>) {
        self.0.borrow_mut().rate(*instant, state, rate);
    }

    fn parts(_state: &Vec<f64>) -> usize {
        1
    }

    fn part(state: &Vec<f64>, _number: usize) -> &[f64] {
        state
    }

    fn part_mut(state: &mut Vec<f64>, _number: usize) -> &mut [f64] {
        state
    }
}
