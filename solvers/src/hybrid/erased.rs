//! The equations of a motion with modes without their type: so what follows a motion is compiled once, for each length of
//! the state vector, and not for each scene.

use std::cell::RefCell;
use std::marker::PhantomData;

use super::problem::{EventEntry, Hybrid, Modes};
use crate::problem::{Equations, Storage};

/// Instants that are kept. A step asks for 14 at most.
const KEPT: usize = 32;
/// Instants that are prepared together.
const PACKED: usize = 4;

/// A time, and where what the equations need of it is kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    time: f64,
    place: Option<usize>,
}

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
    /// Prepares instants at several times, together. Gives the place of the first; the next [`KEPT`] less twice their
    /// number do not displace them.
    fn prepare(&self, times: &[f64]) -> usize;
    /// Writes the rates of the state.
    fn rate(&self, at: At, state: &[f64], rate: &mut [f64]);
    /// Writes the derivatives of the rates by the state, column by column.
    fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]);
    /// Writes the guards and their rates.
    fn guards(&self, time: f64, state: &[f64], values: &mut [f64], rates: &mut [f64]);
    /// Writes the positions of the drivers.
    fn drivers(&self, time: f64, positions: &mut [f64]);
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
    /// What they need of the times of a step, and where the next ones go.
    instants: RefCell<(Vec<E::Instant>, usize)>,
    /// How many branches are held on a side of their switching surface.
    sides: usize,
}

impl<E: Modes<f64> + Clone> Own<E> {
    pub(super) fn new(equations: E) -> Self {
        let states = equations.states();
        Self {
            columns: RefCell::new(vec![E::State::zeros(states); states]),
            instants: RefCell::new((vec![equations.instant(0.0); KEPT], 0)),
            equations,
            sides: 0,
        }
    }

    /// Whether numbers that the equations have computed do not exist though they might: a branch that is held beyond its
    /// surface, where the step that ends on the surface tries the equations, may not exist there, `sqrt(x)` of a negative
    /// number. They are those of the branch that does, then.
    #[inline(always)]
    fn are_lost(&self, numbers: &[f64]) -> bool {
        self.sides > 0 && numbers.iter().any(|number| !number.is_finite())
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

    fn prepare(&self, times: &[f64]) -> usize {
        let one = &self.equations;
        let (kept, next) = &mut *self.instants.borrow_mut();
        if *next + times.len() > KEPT {
            *next = 0;
        }
        let first = *next;
        *next += times.len();
        let places = kept[first..*next].chunks_mut(PACKED);
        for (places, times) in places.zip(times.chunks(PACKED)) {
            if let [time] = times {
                places[0] = one.instant(*time);
                continue;
            }
            let packed: [f64; PACKED] = std::array::from_fn(|k| times[k.min(times.len() - 1)]);
            for (place, instant) in places.iter_mut().zip(one.instants(packed)) {
                *place = instant;
            }
        }
        first
    }

    fn rate(&self, at: At, values: &[f64], rate: &mut [f64]) {
        let compute = |one: &E, instant: &E::Instant, rate: &mut [f64]| {
            let mut rates = E::State::zeros(rate.len());
            one.derivative(instant, &state(one, values), &mut rates);
            rate.copy_from_slice(rates.as_ref());
        };
        let one = &self.equations;
        match at.place {
            Some(place) => compute(one, &self.instants.borrow().0[place], rate),
            None => compute(one, &one.instant(at.time), rate),
        }
        if self.are_lost(rate) {
            let one = self.free();
            compute(&one, &one.instant(at.time), rate);
        }
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
        let compute = |one: &E, values: &mut [f64], rates: &mut [f64]| {
            one.guards(&one.instant(time), &state(one, at), values, rates);
        };
        compute(&self.equations, values, rates);
        if self.are_lost(values) || self.are_lost(rates) {
            compute(&self.free(), values, rates);
        }
    }

    fn drivers(&self, time: f64, positions: &mut [f64]) {
        self.equations.drivers(time, positions);
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

/// The tables of a scene.
#[derive(Clone, Copy)]
pub(super) struct Table {
    /// The events of each mode.
    pub(super) events: &'static [&'static [EventEntry]],
    /// For each mode the speeds that are zero in it.
    pub(super) held: &'static [&'static [usize]],
    /// Absolute tolerances per unit of `rtol`.
    pub(super) scales: &'static [f64],
    /// Number of drivers, and those of them that are angles.
    pub(super) drivers: (usize, &'static [usize]),
    /// Names of the states.
    pub(super) names: &'static [&'static str],
    /// Names of the modes.
    pub(super) modes: &'static [&'static str],
}

impl Table {
    pub(super) fn of<C: Hybrid>() -> Self {
        Self {
            events: C::EVENTS,
            held: C::HELD,
            scales: C::SCALES,
            drivers: (C::DRIVERS, C::ANGLES),
            names: C::STATE_NAMES,
            modes: C::MODE_NAMES,
        }
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

impl<V: Storage<f64>> Equations<f64> for Erased<'_, V> {
    type State = V;
    type Instant = At;

    const CALLED: bool = true;

    fn states(&self) -> usize {
        self.model.states()
    }

    fn instant(&self, time: f64) -> At {
        At { time, place: None }
    }

    fn instants<const K: usize>(&self, times: [f64; K]) -> [At; K] {
        let first = self.model.prepare(&times);
        std::array::from_fn(|k| At {
            time: times[k],
            place: Some(first + k),
        })
    }

    #[inline(always)]
    fn derivative(&self, at: &At, state: &V, rate: &mut V) {
        self.model.rate(*at, state.as_ref(), rate.as_mut());
    }

    fn variation(&self, at: &At, state: &V, rate: &mut V, columns: &[V], products: &mut [V]) {
        self.derivative(at, state, rate);
        let states = self.states();
        let mut slopes = self.slopes.borrow_mut();
        self.model.jacobian(at.time, state.as_ref(), &mut slopes);
        for (column, product) in columns.iter().zip(products) {
            for (row, entry) in product.as_mut().iter_mut().enumerate() {
                let terms = column.as_ref().iter().enumerate();
                *entry = terms
                    .map(|(j, value)| slopes[j * states + row] * value)
                    .sum();
            }
        }
    }

    fn jacobian(&self, at: &At, state: &V, columns: &mut [V]) {
        let states = self.states();
        let mut slopes = self.slopes.borrow_mut();
        self.model.jacobian(at.time, state.as_ref(), &mut slopes);
        for (column, slopes) in columns.iter_mut().zip(slopes.chunks(states.max(1))) {
            column.as_mut().copy_from_slice(slopes);
        }
    }

    fn outputs(&self, _time: f64, _state: &V, _values: &mut [f64]) {}

    fn drivers(&self, time: f64, positions: &mut [f64]) {
        self.model.drivers(time, positions);
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
    fn guards(&self, at: &At, state: &V, values: &mut [f64], rates: &mut [f64]) {
        self.model.guards(at.time, state.as_ref(), values, rates);
    }

    fn permits(&self, event: usize, at: &At, state: &V) -> bool {
        self.model.permits(event, at.time, state.as_ref())
    }

    fn jump(&self, event: usize, at: &At, state: &V, after: &mut V) {
        self.model
            .jump(event, at.time, state.as_ref(), after.as_mut());
    }
}
