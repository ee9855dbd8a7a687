//! What the solvers ask of a model: the two traits that emitted code implements.
//!
//! A [`Scene`] is a set of parameter values, the type that a user fills in. Preparing it for a scalar type gives
//! [`Equations`]: everything that depends on the parameters alone is computed there, once. Its task is a [`Span`].

mod span;

pub use span::Span;

use crate::scalar::Scalar;
use crate::shape::Shape;

/// A vector of scalars, of fixed or of run-time length: one text of each algorithm serves both.
pub trait Storage<S>: Clone + AsRef<[S]> + AsMut<[S]> {
    /// A vector of `length` zeros. A fixed array has its own length and ignores the argument.
    fn zeros(length: usize) -> Self;

    /// These numbers as such a vector, in their place; none where that is not how they lie.
    #[inline(always)]
    fn of(_numbers: &[S]) -> Option<&Self> {
        None
    }

    /// The same, to be written.
    #[inline(always)]
    fn of_mut(_numbers: &mut [S]) -> Option<&mut Self> {
        None
    }
}

impl<S: Scalar, const N: usize> Storage<S> for [S; N] {
    #[inline(always)]
    fn zeros(length: usize) -> Self {
        debug_assert_eq!(length, N);
        [S::ZERO; N]
    }

    #[inline(always)]
    fn of(numbers: &[S]) -> Option<&Self> {
        numbers.try_into().ok()
    }

    #[inline(always)]
    fn of_mut(numbers: &mut [S]) -> Option<&mut Self> {
        numbers.try_into().ok()
    }
}

impl<S: Scalar> Storage<S> for Vec<S> {
    fn zeros(length: usize) -> Self {
        vec![S::ZERO; length]
    }
}

/// The stages of a step of which equations are asked for the rates, one after the other.
pub trait Stages<S> {
    /// The state of a stage, which the rates of those before it give, and where its own go.
    fn next(&mut self, stage: usize) -> (&[S], &mut [S]);
}

/// Times of stages that [`Equations::sweep`] treats together: so many sines are packed well.
const PACKED: usize = 4;

/// First-order equations `y' = f(t, y)` of one scene with its parameters fixed.
///
/// The state is `[coordinates, speeds, first-order states]`. All quantities are in SI units. The methods neither
/// allocate nor panic; a value that does not exist (a square root of a negative number) is NaN, which the solvers report.
pub trait Equations<S: Scalar> {
    /// The state vector `y`.
    type State: Storage<S>;
    /// What depends on the time alone, computed once per instant.
    type Instant: Clone;

    /// Length of the state vector.
    fn states(&self) -> usize;

    /// Values that depend on the time alone, at one time.
    fn instant(&self, time: S) -> Self::Instant;

    /// The same at several times at once, so that their sines and cosines are packed calls; only what the rates and their
    /// slopes need ([`Equations::derivative`], [`Equations::variation`], [`Equations::jacobian`]).
    fn instants<const K: usize>(&self, times: [S; K]) -> [Self::Instant; K];

    /// Writes `f(t, y)` into `rate`.
    fn derivative(&self, instant: &Self::Instant, state: &Self::State, rate: &mut Self::State);

    /// Evaluates all stages of a step, which lie at these times. False, and nothing is evaluated, where the states are
    /// not such that they can be read in their place.
    #[inline(always)]
    fn sweep(&self, times: &[S], stages: &mut dyn Stages<S>) -> bool {
        let mut number = 0;
        for times in times.chunks(PACKED) {
            let packed: [S; PACKED] = std::array::from_fn(|k| times[k.min(times.len() - 1)]);
            let instants = self.instants(packed);
            for instant in &instants[..times.len()] {
                let (state, rate) = stages.next(number);
                match (Self::State::of(state), Self::State::of_mut(rate)) {
                    (Some(state), Some(rate)) => self.derivative(instant, state, rate),
                    _ => return false,
                }
                number += 1;
            }
        }
        true
    }

    /// Writes the Taylor series of the motion from a state on, which is the first row: row `k` is `length^k / k!` times
    /// the `k`-th time derivative, and rows have the length of the state. False, and nothing is written, where the
    /// equations have none, and for scalars that are not [`Scalar::SINGLE`].
    fn series(&self, _time: S, _length: S, _rows: &mut [S]) -> bool {
        false
    }

    /// Writes `f(t, y)` into `rate` and the products `∂f/∂y · columns[k]` into `products[k]`.
    fn variation(
        &self,
        instant: &Self::Instant,
        state: &Self::State,
        rate: &mut Self::State,
        columns: &[Self::State],
        products: &mut [Self::State],
    );

    /// Writes the columns of `∂f/∂y`: `columns[j].as_ref()[i] = ∂f_i/∂y_j`.
    fn jacobian(&self, instant: &Self::Instant, state: &Self::State, columns: &mut [Self::State]);

    /// Writes the outputs of the scene, in their declared order. Shape: [`Shape::outputs`].
    fn outputs(&self, _time: S, _state: &Self::State, _values: &mut [S]) {}

    /// Writes the positions of the drivers at a time, in their declared order.
    fn drivers(&self, _time: S, _values: &mut [S]) {}

    /// Writes by how much the loops that the motion carries along close at a time, see
    /// [`Run::margins`](crate::registry::Run::margins).
    fn margins(&self, _time: S, _values: &mut [S]) {}

    /// Writes what the measures of the scene look at. Length: [`Shape::measured`].
    fn measured(&self, _time: S, _state: &Self::State, _values: &mut [S]) {}

    /// Writes the measures, from what has been found for [`Shape::primitives`]. Shape: [`Shape::measures`].
    fn measures(&self, _found: &[S], _values: &mut [S]) {}
}

/// A scene of a mechanism with its parameter values: the type that a user fills in and hands to a solver.
pub trait Scene: Clone + Send + Sync {
    /// The equations, prepared for a scalar type.
    type Equations<S: Scalar>: Equations<S> + Send + Sync;

    /// What the scene is made of.
    fn shape() -> &'static Shape;

    /// Computes what depends on the parameters alone.
    fn prepare<S: Scalar>(&self) -> Self::Equations<S>;

    /// Checks the conditions that the mechanism puts on its values (`require`, finite values, positive masses).
    ///
    /// # Errors
    /// The first condition that does not hold, with the values concerned.
    fn check(&self) -> Result<(), Refused>;

    /// The task of the scene with these parameter values.
    fn span(&self) -> Span;

    /// The declared start values of the state, SI units. Shape: [`Shape::states`].
    fn start(&self) -> Vec<f64>;
}

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
