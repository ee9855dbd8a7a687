//! A scene without its type: so the search is compiled once.

use super::super::march::Way;
use super::super::problem::{Hybrid, Sensitive, in_each_mode};
use super::super::{HybridError, Modes, Motion};
use crate::problem::{Equations, Storage};
use crate::registry::Settings;

/// A motion, to be followed and varied.
pub(super) trait Flow {
    /// Sizes of the states: absolute tolerances per unit of `rtol`.
    fn scales(&self) -> &'static [f64];

    /// The motion from a start in a mode.
    fn follow(
        &self,
        mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError>;

    /// The equations of a mode on these sides of its switching surfaces; none given leaves them to the values.
    fn local(&self, mode: usize, sides: &[f64]) -> Box<dyn Local + '_>;
}

/// The equations of a mode. What concerns events is asked only where one has happened.
pub(super) trait Local {
    /// Writes the rates of the state.
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]);

    /// Writes the derivatives of the rates by the state, column by column.
    fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]);

    /// Writes the derivatives of the guard of an event by the state, and gives its rate.
    fn guard(&self, _event: usize, _time: f64, _state: &[f64], _slopes: &mut [f64]) -> f64 {
        f64::NAN
    }

    /// The guard of an event.
    fn value(&self, _event: usize, _time: f64, _state: &[f64]) -> f64 {
        f64::NAN
    }

    /// Writes the derivatives of the state after an event by that before it, column by column, and its total time
    /// derivative. False where the event sets nothing.
    fn jump(
        &self,
        _event: usize,
        _time: f64,
        _state: &[f64],
        _columns: &mut [f64],
        _rate: &mut [f64],
    ) -> bool {
        false
    }
}

/// A scene with its values.
pub(super) struct Bound<'a, C: Hybrid> {
    scene: &'a C,
    modes: Vec<C::Modal<f64>>,
}

impl<'a, C: Hybrid> Bound<'a, C> {
    pub(super) fn new(scene: &'a C) -> Self {
        Self {
            scene,
            modes: in_each_mode(scene),
        }
    }
}

impl<C: Hybrid> Flow for Bound<'_, C>
where
    C::Modal<f64>: Sensitive<f64>,
{
    fn scales(&self) -> &'static [f64] {
        C::shape().scales
    }

    fn follow(
        &self,
        mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        // What an iteration tries may lie a little beyond the end of a mode.
        let way = Way {
            mode,
            times,
            start,
            settings,
            is_checked: false,
        };
        way.of(self.scene)
    }

    fn local(&self, mode: usize, sides: &[f64]) -> Box<dyn Local + '_> {
        if sides.is_empty() {
            return Box::new(In::<'_, C> {
                own: None,
                mode: &self.modes[mode],
            });
        }
        let mut equations = self.scene.modal::<f64>();
        equations.enter(mode);
        for (surface, side) in sides.iter().enumerate() {
            equations.side(surface, *side);
        }
        Box::new(In::<'_, C> {
            own: Some(equations),
            mode: &self.modes[mode],
        })
    }
}

/// The equations of a mode, or the same with sides of their own.
struct In<'a, C: Hybrid> {
    own: Option<C::Modal<f64>>,
    mode: &'a C::Modal<f64>,
}

type State<C> = <<C as Hybrid>::Modal<f64> as Equations<f64>>::State;
type Instant<C> = <<C as Hybrid>::Modal<f64> as Equations<f64>>::Instant;

impl<C: Hybrid> In<'_, C> {
    fn equations(&self) -> &C::Modal<f64> {
        self.own.as_ref().unwrap_or(self.mode)
    }

    /// Values and rates of the guards.
    fn guards(&self, instant: &Instant<C>, state: &State<C>) -> (Vec<f64>, Vec<f64>) {
        let equations = self.equations();
        let count = C::shape().modes[equations.mode()].written();
        let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
        equations.guards(instant, state, &mut values, &mut rates);
        (values, rates)
    }

    fn state(values: &[f64]) -> State<C> {
        let mut state = State::<C>::zeros(C::shape().states.len());
        state.as_mut().copy_from_slice(values);
        state
    }

    /// Columns of a matrix, one behind the other.
    fn columns() -> Vec<State<C>> {
        vec![State::<C>::zeros(C::shape().states.len()); C::shape().states.len()]
    }

    fn write(columns: &[State<C>], flat: &mut [f64]) {
        for (column, target) in columns
            .iter()
            .zip(flat.chunks_mut(C::shape().states.len().max(1)))
        {
            target.copy_from_slice(column.as_ref());
        }
    }
}

impl<C: Hybrid> Local for In<'_, C>
where
    C::Modal<f64>: Sensitive<f64>,
{
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let equations = self.equations();
        let mut rates = State::<C>::zeros(C::shape().states.len());
        equations.derivative(&equations.instant(time), &Self::state(state), &mut rates);
        rate.copy_from_slice(rates.as_ref());
    }

    fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]) {
        let equations = self.equations();
        let mut all = Self::columns();
        equations.jacobian(&equations.instant(time), &Self::state(state), &mut all);
        Self::write(&all, columns);
    }

    fn guard(&self, event: usize, time: f64, state: &[f64], slopes: &mut [f64]) -> f64 {
        let equations = self.equations();
        let (instant, state) = (equations.instant(time), Self::state(state));
        let mut all = State::<C>::zeros(C::shape().states.len());
        equations.guard_slopes(event, &instant, &state, &mut all);
        slopes.copy_from_slice(all.as_ref());
        self.guards(&instant, &state).1[event]
    }

    fn value(&self, event: usize, time: f64, state: &[f64]) -> f64 {
        let instant = self.equations().instant(time);
        self.guards(&instant, &Self::state(state)).0[event]
    }

    fn jump(
        &self,
        event: usize,
        time: f64,
        state: &[f64],
        columns: &mut [f64],
        rate: &mut [f64],
    ) -> bool {
        let equations = self.equations();
        let mut all = Self::columns();
        let mut rates = State::<C>::zeros(C::shape().states.len());
        let state = Self::state(state);
        let instant = equations.instant(time);
        let jumps = equations.jump_slopes(event, &instant, &state, &mut all, &mut rates);
        Self::write(&all, columns);
        rate.copy_from_slice(rates.as_ref());
        jumps
    }
}
