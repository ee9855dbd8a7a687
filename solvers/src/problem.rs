//! What the solvers ask of a model: a family of traits, layered by what an algorithm needs.
//!
//! A [`Scene`] is a set of parameter values, the type that a user fills in. Preparing it for a scalar type gives its
//! [`Equations`], with everything computed that depends on the parameters alone; beside them stand what a position says
//! ([`Reports`]) and, where equations change on the way, [`Events`]. All of them work on slices, so that a pointer may stand
//! for any of them. Its task is a [`Span`].
//!
//! Nothing in them allocates or panics; all quantities are in SI units; a value that does not exist (a square root of a
//! negative number) is NaN, which the solvers report. Slices have the lengths that [`Equations`] and the shape state.

mod exact;
mod span;
mod staged;

pub use span::Span;
pub use staged::{Alone, Beside, Staged};

use crate::scalar::Scalar;
use crate::shape::Shape;

/// A vector of scalars whose length its type says, as a rule an array.
pub trait Storage<S>: Clone + AsRef<[S]> + AsMut<[S]> {
    /// A vector of `length` zeros. An array has its own length and ignores the argument.
    fn zeros(length: usize) -> Self;
}

impl<S: Scalar, const N: usize> Storage<S> for [S; N] {
    #[inline(always)]
    fn zeros(length: usize) -> Self {
        debug_assert_eq!(length, N);
        [S::ZERO; N]
    }
}

impl<S: Scalar> Storage<S> for Vec<S> {
    fn zeros(length: usize) -> Self {
        vec![S::ZERO; length]
    }
}

/// The discrete part of a position: which equations hold.
#[derive(Clone, Copy, Debug)]
pub struct Phase<'a, S> {
    /// The mode; 0 where there is but one.
    pub mode: usize,
    /// On which side of each switching surface of the mode the motion is, 1 or −1. Where it is 0, or none is given, the
    /// values say it.
    pub sides: &'a [S],
}

impl<S: Scalar> Phase<'_, S> {
    /// A mode, with all sides left to the values.
    #[inline(always)]
    pub const fn of(mode: usize) -> Self {
        Self { mode, sides: &[] }
    }

    /// The side of a switching surface, 0 where the values say it.
    #[inline(always)]
    pub fn side(&self, surface: usize) -> S {
        match self.sides.get(surface) {
            Some(side) => *side,
            None => S::ZERO,
        }
    }
}

/// First-order equations `y' = f(t, y)` of one scene with its parameters fixed.
///
/// The state is `[coordinates, speeds, first-order states]`. All modes have the same; what a mode does not have stands
/// still in it. What depends on the time alone is computed apart, a row of numbers for each instant.
pub trait Equations<S: Scalar>: Send + Sync {
    /// Length of the state vector.
    fn states(&self) -> usize;

    /// Length of a row of what depends on the time alone.
    fn instant(&self) -> usize {
        0
    }

    /// Writes what the rates and their slopes need of several times, a row for each: computed together, so that sines are
    /// packed calls.
    fn instants(&self, _phase: Phase<'_, S>, _times: &[S], _rows: &mut [S]) {}

    /// Writes `f(t, y)`.
    fn rates(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], rates: &mut [S]);

    /// Writes `f(t, y)` and the products of `∂f/∂y` with columns, which stand one behind the other.
    fn variation(
        &self,
        phase: Phase<'_, S>,
        instant: &[S],
        state: &[S],
        rates: &mut [S],
        columns: &[S],
        products: &mut [S],
    );

    /// Writes `∂f/∂y` column by column: `columns[j * states + i] = ∂f_i/∂y_j`.
    fn jacobian(&self, phase: Phase<'_, S>, instant: &[S], state: &[S], columns: &mut [S]);

    /// Writes the Taylor series of the motion from a state on, which is the first row: row `k` is `length^k / k!` times
    /// the `k`-th time derivative, and rows have the length of the state. False, and nothing is written, where the
    /// equations have none, and for scalars that are not [`Scalar::SINGLE`].
    fn series(&self, _phase: Phase<'_, S>, _time: S, _length: S, _rows: &mut [S]) -> bool {
        false
    }

    /// The motion in a phase, for the stages of a step.
    #[inline(always)]
    fn alone<'a>(&'a self, phase: Phase<'a, S>) -> impl Staged<S>
    where
        Self: Sized,
    {
        Alone { equations: self, phase }
    }

    /// The same with its variations behind it.
    #[inline(always)]
    fn beside<'a>(&'a self, phase: Phase<'a, S>) -> impl Staged<S>
    where
        Self: Sized,
    {
        Beside { equations: self, phase }
    }
}

/// What a position says.
pub trait Reports<S: Scalar>: Send + Sync {
    /// Writes the outputs of the scene. Shape: [`Shape::outputs`].
    fn outputs(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _values: &mut [S]) {}

    /// Writes the positions of the drivers at a time. Shape: [`Shape::drivers`].
    fn drivers(&self, _time: S, _values: &mut [S]) {}

    /// Writes by how much the loops that the motion carries along close, in SI units: less than zero where they do not, not
    /// a number where one before does not. Shape: [`Shape::carried`].
    fn margins(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _values: &mut [S]) {}

    /// Writes the closures that hold the coordinates of a motion: their residuals, the time derivatives of these, and row by
    /// row their slopes by the coordinates, SI units. Shape: [`Shape::augmented`]. Nothing is written where there are none.
    fn closures(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _values: &mut [S]) {}

    /// Writes the places of points, and behind them of forces, x and y of each. Length: [`Shape::places`].
    fn points(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _values: &mut [S]) {}

    /// Kinetic and potential energy, in joules; none where the scene states forces instead.
    fn energy(&self, _phase: Phase<'_, S>, _time: S, _state: &[S]) -> Option<(S, S)> {
        None
    }

    /// Writes the symmetric mass matrix row by row, in the order of the coordinates. False, and nothing is written, where the
    /// equations do not have one.
    fn mass(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _rows: &mut [S]) -> bool {
        false
    }

    /// Writes what the measures of the scene look at. Length: [`Shape::measured`].
    fn measured(&self, _phase: Phase<'_, S>, _time: S, _state: &[S], _values: &mut [S]) {}

    /// Writes the measures, from what has been found for [`Shape::primitives`]. Shape: [`Shape::measures`].
    fn measures(&self, _found: &[S], _values: &mut [S]) {}
}

/// What changes the equations of a motion on its way.
pub trait Events<S: Scalar>: Send + Sync {
    /// Writes the guards of the events of the mode, behind them its kinks
    /// ([`ModeEntry::kinks`](crate::shape::ModeEntry::kinks)) and its angles
    /// ([`ModeEntry::turns`](crate::shape::ModeEntry::turns)), and the time derivatives of all.
    fn guards(&self, phase: Phase<'_, S>, time: S, state: &[S], values: &mut [S], rates: &mut [S]);

    /// Whether what else an event of the mode asks for holds; asked of those that ask for more than their guard.
    fn permits(&self, _phase: Phase<'_, S>, _event: usize, _time: S, _state: &[S]) -> bool {
        true
    }

    /// Writes the state after an event of the mode; asked of those that set something.
    fn jump(&self, _phase: Phase<'_, S>, _event: usize, _time: S, state: &[S], after: &mut [S]) {
        after.copy_from_slice(state);
    }

    /// Whether it is known how events depend on the state: [`Events::guard_slopes`], [`Events::jump_slopes`].
    fn has_slopes(&self) -> bool {
        false
    }

    /// Writes the derivatives of the guard of an event of the mode by the state.
    fn guard_slopes(
        &self,
        _phase: Phase<'_, S>,
        _event: usize,
        _time: S,
        _state: &[S],
        slopes: &mut [S],
    ) {
        slopes.fill(S::ZERO);
    }

    /// Writes the derivatives of the state after an event of the mode by the state before it, column by column, and its
    /// total time derivative along the motion in the mode. False, and nothing is written, where the event sets nothing.
    fn jump_slopes(
        &self,
        _phase: Phase<'_, S>,
        _event: usize,
        _time: S,
        _state: &[S],
        _columns: &mut [S],
        _rates: &mut [S],
    ) -> bool {
        false
    }
}

/// A scene of a mechanism with its parameter values: the type that a user fills in and hands to a solver.
pub trait Scene: Clone + Send + Sync + 'static {
    /// The equations, prepared for a scalar type.
    type Equations<S: Scalar>: Equations<S> + Reports<S>;

    /// The same motion with all positions as coordinates; the scene itself where there is no such form.
    type Unreduced: Scene;

    /// Whether nothing changes the equations on the way, so that the scene is [`Smooth`].
    const SMOOTH: bool;

    /// What the scene is made of.
    fn shape(&self) -> &'static Shape;

    /// Computes what depends on the parameters alone.
    fn prepare<S: Scalar>(&self) -> Self::Equations<S>;

    /// The events; none where the scene is smooth.
    fn events<S: Scalar>(_equations: &Self::Equations<S>) -> Option<&dyn Events<S>> {
        None
    }

    /// Checks the conditions that the mechanism puts on its values (`require`, finite values, positive masses).
    ///
    /// # Errors
    /// The first condition that does not hold, with the values concerned.
    fn check(&self) -> Result<(), Refused>;

    /// The task of the scene with these parameter values.
    fn span(&self) -> Span;

    /// The declared start values of the state, SI units. Shape: [`Shape::states`].
    fn start(&self) -> Vec<f64>;

    /// The same motion with all positions as coordinates, which goes on where loops of this one come to a dead point; none
    /// where that does not happen.
    fn unreduced(&self) -> Option<Self::Unreduced> {
        None
    }
}

/// A scene without modes or events. Whatever would not see these asks for such a one.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has modes or events, which this does not follow",
    note = "`hybrid::march` follows them"
)]
pub trait Smooth: Scene {}

/// A set of values that the mechanism does not accept.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// Parameter or condition concerned.
    pub name: String,
    /// What was found and what was expected.
    pub reason: String,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}: {}", self.name, self.reason)
    }
}

impl std::error::Error for Refused {}
