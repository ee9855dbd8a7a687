//! What the steppers integrate: the equations of a model, alone or beside their variations.

use crate::problem::{Equations, Stages, Storage};
use crate::scalar::Scalar;

/// Right-hand sides `y' = f(t, y)`.
///
/// [`Plain`] makes such a system of any [`Equations`]; [`Varied`] adds their variational equations. The state consists
/// of one vector or of several parts, the motion first.
pub trait System<S: Scalar> {
    /// The state.
    type State: Clone;
    /// What depends on the time alone.
    type Instant: Clone;

    /// Whether all stages of a step are asked for in one call, with [`System::sweep`].
    const CALLED: bool = false;

    /// A state of zeros.
    fn zeros(&self) -> Self::State;

    /// Values that depend on the time alone, at several times at once.
    fn instants<const K: usize>(&self, times: [S; K]) -> [Self::Instant; K];

    /// Writes `f(t, y)` into `rate`.
    fn rate(&self, instant: &Self::Instant, state: &Self::State, rate: &mut Self::State);

    /// Evaluates all stages of a step, which lie at these times: of systems that are [`System::CALLED`].
    fn sweep(&self, _times: &[S], _stages: &mut dyn Stages<S>) {}

    /// The same where it has given what is no number.
    fn sweep_again(&self, times: &[S], stages: &mut dyn Stages<S>) {
        self.sweep(times, stages);
    }

    /// Number of parts of a state.
    fn parts(state: &Self::State) -> usize;

    /// One part of a state.
    fn part(state: &Self::State, number: usize) -> &[S];

    /// One part of a state, to be written.
    fn part_mut(state: &mut Self::State, number: usize) -> &mut [S];

    /// Factor from the absolute tolerances of the state to those of a part; `None` keeps the part out of the control
    /// of the step size.
    #[inline(always)]
    fn part_scale(&self, _part: usize) -> Option<f64> {
        Some(1.0)
    }
}

/// Equations as they are.
#[derive(Clone, Copy, Debug)]
pub struct Plain<'a, E>(pub &'a E);

impl<S: Scalar, E: Equations<S>> System<S> for Plain<'_, E> {
    type State = E::State;
    type Instant = E::Instant;

    #[inline(always)]
    fn zeros(&self) -> E::State {
        E::State::zeros(self.0.states())
    }

    #[inline(always)]
    fn instants<const K: usize>(&self, times: [S; K]) -> [E::Instant; K] {
        self.0.instants(times)
    }

    #[inline(always)]
    fn rate(&self, instant: &E::Instant, state: &E::State, rate: &mut E::State) {
        self.0.derivative(instant, state, rate);
    }

    #[inline(always)]
    fn parts(_state: &E::State) -> usize {
        1
    }

    #[inline(always)]
    fn part(state: &E::State, _number: usize) -> &[S] {
        state.as_ref()
    }

    #[inline(always)]
    fn part_mut(state: &mut E::State, _number: usize) -> &mut [S] {
        state.as_mut()
    }
}

/// A motion and columns beside it. Room for the columns is taken once, when it is made.
#[derive(Clone, Debug)]
pub struct Bundle<Y> {
    /// The motion.
    pub motion: Y,
    /// Its variations, one column for each direction.
    pub columns: Vec<Y>,
}

/// Equations beside their variational equations `c' = ∂f/∂y · c`, one column for each state.
///
/// Started from the unit columns, the columns end as the matrix `Φ = ∂y(T)/∂y(0)`.
#[derive(Clone, Copy, Debug)]
pub struct Varied<'a, E> {
    /// The equations.
    pub equations: &'a E,
    /// Sizes of the states. Column `j` is a change of `scales[j]` in state `j` per `scales[j]`, so its entry `i` has
    /// the size `scales[i] / scales[j]`: the absolute tolerances of the column are those of the state over `scales[j]`.
    /// `None` keeps the columns out of the control of the step size.
    pub scales: Option<&'a [f64]>,
}

impl<E> Varied<'_, E> {
    /// The start `start` with the unit columns.
    pub fn start<S: Scalar>(&self, start: &E::State) -> Bundle<E::State>
    where
        E: Equations<S>,
    {
        let states = self.equations.states();
        let column = |number: usize| {
            let mut column = E::State::zeros(states);
            column.as_mut()[number] = S::ONE;
            column
        };
        Bundle {
            motion: start.clone(),
            columns: (0..states).map(column).collect(),
        }
    }
}

impl<S: Scalar, E: Equations<S>> System<S> for Varied<'_, E> {
    type State = Bundle<E::State>;
    type Instant = E::Instant;

    fn zeros(&self) -> Self::State {
        let states = self.equations.states();
        Bundle {
            motion: E::State::zeros(states),
            columns: vec![E::State::zeros(states); states],
        }
    }

    #[inline(always)]
    fn instants<const K: usize>(&self, times: [S; K]) -> [E::Instant; K] {
        self.equations.instants(times)
    }

    #[inline(always)]
    fn rate(&self, instant: &E::Instant, state: &Self::State, rate: &mut Self::State) {
        self.equations.variation(
            instant,
            &state.motion,
            &mut rate.motion,
            &state.columns,
            &mut rate.columns,
        );
    }

    #[inline(always)]
    fn parts(state: &Self::State) -> usize {
        1 + state.columns.len()
    }

    #[inline(always)]
    fn part(state: &Self::State, number: usize) -> &[S] {
        match number {
            0 => state.motion.as_ref(),
            _ => state.columns[number - 1].as_ref(),
        }
    }

    #[inline(always)]
    fn part_mut(state: &mut Self::State, number: usize) -> &mut [S] {
        match number {
            0 => state.motion.as_mut(),
            _ => state.columns[number - 1].as_mut(),
        }
    }

    #[inline(always)]
    fn part_scale(&self, part: usize) -> Option<f64> {
        match (part, self.scales) {
            (0, _) => Some(1.0),
            (_, Some(scales)) => Some(1.0 / scales[part - 1]),
            (_, None) => None,
        }
    }
}
