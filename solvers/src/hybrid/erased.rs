//! The equations of a motion with modes without their type: so what follows a motion is compiled once, for each length of
//! the state vector, and not for each scene.

use std::cell::RefCell;
use std::marker::PhantomData;

use super::problem::Modes;
use crate::ode::{Expand, System};
use crate::problem::{Equations, Stages, Storage};

/// What is asked of equations along a motion, in slices.
pub(super) trait Model {
    /// Length of the state vector.
    fn states(&self) -> usize;
    /// The mode.
    fn mode(&self) -> usize;
    /// Goes into a mode.
    fn enter(&mut self, mode: usize);
    /// Puts the equations on a side of a switching surface.
    fn side(&mut self, surface: usize, side: f64);
    /// Writes the rates of the state.
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]);
    /// Evaluates all stages of a step.
    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>);
    /// The same one by one, where it has given what is no number.
    fn sweep_again(&self, times: &[f64], stages: &mut dyn Stages<f64>);
    /// Writes the Taylor series of the motion, see [`Equations::series`].
    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool;
    /// Writes the derivatives of the rates by the state, column by column.
    fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]);
    /// Writes the guards and their rates.
    fn guards(&self, time: f64, state: &[f64], values: &mut [f64], rates: &mut [f64]);
    /// Whether what else an event asks for holds.
    fn permits(&self, event: usize, time: f64, state: &[f64]) -> bool;
    /// Writes the state after an event.
    fn jump(&self, event: usize, time: f64, state: &[f64], after: &mut [f64]);
}

/// A state of some equations.
fn state<E: Equations<f64>>(equations: &E, values: &[f64]) -> E::State {
    let mut state = E::State::zeros(equations.states());
    state.as_mut().copy_from_slice(values);
    state
}

/// Equations with room for the columns of their Jacobian.
pub(super) struct Own<E: Modes<f64>> {
    equations: E,
    columns: RefCell<Vec<E::State>>,
    /// How many branches are held on a side of their switching surface.
    sides: usize,
}

impl<E: Modes<f64> + Clone> Own<E> {
    pub(super) fn new(equations: E) -> Self {
        let states = equations.states();
        Self {
            columns: RefCell::new(vec![E::State::zeros(states); states]),
            equations,
            sides: 0,
        }
    }

    /// Whether numbers that the equations have computed do not exist though they might: a branch that is held beyond its
    /// surface, where the step that ends on the surface tries the equations, may not exist there, `sqrt(x)` of a negative
    /// number. They are those of the branch that does, then.
    #[inline(always)]
    fn are_lost(&self, numbers: &[f64]) -> bool {
        // Zero, unless one is infinite or not a number.
        let zero = |sum: f64, number: &f64| sum + 0.0 * number;
        self.sides > 0 && numbers.iter().fold(0.0, zero) != 0.0
    }

    /// The equations with their branches free.
    #[cold]
    fn free(&self) -> E {
        let mut one = self.equations.clone();
        (0..self.sides).for_each(|surface| one.side(surface, 0.0));
        one
    }
}

impl<E: Modes<f64> + Clone> Model for Own<E> {
    fn states(&self) -> usize {
        self.equations.states()
    }

    fn mode(&self) -> usize {
        self.equations.mode()
    }

    fn enter(&mut self, mode: usize) {
        self.equations.enter(mode);
        self.sides = 0;
    }

    fn side(&mut self, surface: usize, side: f64) {
        self.equations.side(surface, side);
        self.sides = self.sides.max(surface + 1);
    }

    fn rate(&self, time: f64, values: &[f64], rate: &mut [f64]) {
        let compute = |one: &E, rate: &mut [f64]| {
            let mut rates = E::State::zeros(rate.len());
            let [instant] = one.instants([time]);
            one.derivative(&instant, &state(one, values), &mut rates);
            rate.copy_from_slice(rates.as_ref());
        };
        compute(&self.equations, rate);
        if self.are_lost(rate) {
            compute(&self.free(), rate);
        }
    }

    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        if !self.equations.sweep(times, stages) {
            self.sweep_again(times, stages);
        }
    }

    #[cold]
    fn sweep_again(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        for (number, time) in times.iter().enumerate() {
            let (state, rate) = stages.next(number);
            self.rate(*time, state, rate);
        }
    }

    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        let has_series = self.equations.series(time, length, rows);
        if has_series && self.are_lost(rows) {
            self.free().series(time, length, rows);
        }
        has_series
    }

    fn jacobian(&self, time: f64, values: &[f64], columns: &mut [f64]) {
        let compute = |one: &E, columns: &mut [f64]| {
            let mut all = self.columns.borrow_mut();
            one.jacobian(&one.instant(time), &state(one, values), &mut all);
            let targets = columns.chunks_mut(values.len().max(1));
            for (target, column) in targets.zip(all.iter()) {
                target.copy_from_slice(column.as_ref());
            }
        };
        compute(&self.equations, columns);
        if self.are_lost(columns) {
            compute(&self.free(), columns);
        }
    }

    fn guards(&self, time: f64, at: &[f64], values: &mut [f64], rates: &mut [f64]) {
        let compute = |one: &E, values: &mut [f64], rates: &mut [f64]| match E::State::of(at) {
            Some(at) => one.look(time, at, values, rates),
            None => one.look(time, &state(one, at), values, rates),
        };
        compute(&self.equations, values, rates);
        if self.are_lost(values) || self.are_lost(rates) {
            compute(&self.free(), values, rates);
        }
    }

    fn permits(&self, event: usize, time: f64, values: &[f64]) -> bool {
        let one = &self.equations;
        one.permits(event, &one.instant(time), &state(one, values))
    }

    fn jump(&self, event: usize, time: f64, values: &[f64], after: &mut [f64]) {
        let one = &self.equations;
        let mut next = E::State::zeros(values.len());
        one.jump(event, &one.instant(time), &state(one, values), &mut next);
        after.copy_from_slice(next.as_ref());
    }
}

/// Equations without their type, with states of a type of our own.
pub(super) struct Erased<'a, V> {
    model: &'a mut dyn Model,
    /// Room for a Jacobian.
    slopes: RefCell<Vec<f64>>,
    state: PhantomData<V>,
}

impl<'a, V> Erased<'a, V> {
    pub(super) fn new(model: &'a mut dyn Model) -> Self {
        let states = model.states();
        Self {
            model,
            slopes: RefCell::new(vec![0.0; states * states]),
            state: PhantomData,
        }
    }
}

impl<V> Expand for Erased<'_, V> {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.model.rate(time, state, rate);
    }

    fn series(&self, time: f64, length: f64, rows: &mut [f64]) -> bool {
        self.model.series(time, length, rows)
    }
}

impl<V: Storage<f64>> Equations<f64> for Erased<'_, V> {
    type State = V;
    type Instant = f64;

    fn states(&self) -> usize {
        self.model.states()
    }

    fn instant(&self, time: f64) -> f64 {
        time
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [f64; K] {
        times
    }

    #[inline(always)]
    fn derivative(&self, time: &f64, state: &V, rate: &mut V) {
        self.model.rate(*time, state.as_ref(), rate.as_mut());
    }

    fn variation(&self, time: &f64, state: &V, rate: &mut V, columns: &[V], products: &mut [V]) {
        self.derivative(time, state, rate);
        let states = self.states();
        let mut slopes = self.slopes.borrow_mut();
        self.model.jacobian(*time, state.as_ref(), &mut slopes);
        for (column, product) in columns.iter().zip(products) {
            for (row, entry) in product.as_mut().iter_mut().enumerate() {
                let terms = column.as_ref().iter().enumerate();
                *entry = terms
                    .map(|(j, value)| slopes[j * states + row] * value)
                    .sum();
            }
        }
    }

    fn jacobian(&self, time: &f64, state: &V, columns: &mut [V]) {
        let states = self.states();
        let mut slopes = self.slopes.borrow_mut();
        self.model.jacobian(*time, state.as_ref(), &mut slopes);
        for (column, slopes) in columns.iter_mut().zip(slopes.chunks(states.max(1))) {
            column.as_mut().copy_from_slice(slopes);
        }
    }

    fn outputs(&self, _time: f64, _state: &V, _values: &mut [f64]) {}

    fn drivers(&self, _time: f64, _positions: &mut [f64]) {}
}

/// The same as what the explicit methods integrate.
pub(super) struct Called<'a, 'b, V>(pub &'b Erased<'a, V>);

impl<V: Storage<f64>> System<f64> for Called<'_, '_, V> {
    type State = V;
    type Instant = f64;

    const CALLED: bool = true;

    fn zeros(&self) -> V {
        V::zeros(self.0.states())
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [f64; K] {
        times
    }

    fn rate(&self, time: &f64, state: &V, rate: &mut V) {
        self.0.derivative(time, state, rate);
    }

    #[inline(always)]
    fn sweep(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        self.0.model.sweep(times, stages);
    }

    fn sweep_again(&self, times: &[f64], stages: &mut dyn Stages<f64>) {
        self.0.model.sweep_again(times, stages);
    }

    #[inline(always)]
    fn parts(_state: &V) -> usize {
        1
    }

    #[inline(always)]
    fn part(state: &V, _number: usize) -> &[f64] {
        state.as_ref()
    }

    #[inline(always)]
    fn part_mut(state: &mut V, _number: usize) -> &mut [f64] {
        state.as_mut()
    }
}

impl<V: Storage<f64>> Modes<f64> for Erased<'_, V> {
    fn mode(&self) -> usize {
        self.model.mode()
    }

    fn enter(&mut self, mode: usize) {
        self.model.enter(mode);
    }

    fn side(&mut self, surface: usize, side: f64) {
        self.model.side(surface, side);
    }

    #[inline(always)]
    fn guards(&self, time: &f64, state: &V, values: &mut [f64], rates: &mut [f64]) {
        self.model.guards(*time, state.as_ref(), values, rates);
    }

    #[inline(always)]
    fn look(&self, time: f64, state: &V, values: &mut [f64], rates: &mut [f64]) {
        self.model.guards(time, state.as_ref(), values, rates);
    }

    fn permits(&self, event: usize, time: &f64, state: &V) -> bool {
        self.model.permits(event, *time, state.as_ref())
    }

    fn jump(&self, event: usize, time: &f64, state: &V, after: &mut V) {
        self.model
            .jump(event, *time, state.as_ref(), after.as_mut());
    }
}
