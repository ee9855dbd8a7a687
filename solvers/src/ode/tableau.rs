//! What distinguishes one explicit Runge–Kutta method from another: its coefficients.

use super::system::System;
use crate::scalar::Scalar;

/// A row of a tableau without its zeros: number of the slope (from 0) and its coefficient.
pub type Row = &'static [(usize, f64)];

/// An explicit Runge–Kutta method as data.
///
/// Slope 0 belongs to the begin of the step, slopes 1 to `STAGES - 1` to the inner stages, slope `STAGES` to the new
/// state (it is slope 0 of the next step), and the slopes after it to the stages that only the dense output needs. The
/// last inner stage lies at the end of the step, so that the new state shares its instant.
///
/// The continuous solution over a step, with `θ` from 0 to 1, is
/// `y(θ) = y₀ + θ(F₁ + (1-θ)(F₂ + θ(F₃ + (1-θ)(F₄ + …))))`, where `F₁ = y₁ - y₀`, `F₂ = h k₀ - F₁`,
/// `F₃ = 2F₁ - h(k₀ + k₁)` make the cubic Hermite polynomial (`k₀`, `k₁` the slopes at both ends) and the others are
/// combinations of all slopes.
pub trait Method {
    /// As many as there are slopes.
    type Slopes<T>: AsRef<[T]> + AsMut<[T]>;
    /// As many as there are times of inner stages.
    type Nodes<T>: AsRef<[T]>;
    /// As many as there are times of stages for the dense output.
    type ExtraNodes<T>: AsRef<[T]>;
    /// As many as the polynomial of the dense output has coefficients beside `y₀`.
    type Polynomial<T>: AsRef<[T]> + AsMut<[T]>;

    /// Order of the solution that is carried on.
    const ORDER: usize;
    /// Stages from which the new state is formed.
    const STAGES: usize;
    /// Times of the inner stages 1 to `STAGES - 1`, in parts of the step; the last is 1.
    const NODES: &'static [f64];
    /// Times of the stages for the dense output.
    const EXTRA_NODES: &'static [f64];
    /// Coefficients of the inner stages.
    const ROWS: &'static [Row];
    /// Weights of the new state.
    const WEIGHTS: Row;
    /// Coefficients of the stages for the dense output.
    const EXTRA_ROWS: &'static [Row];
    /// Weights of the error estimate.
    const ERROR: Row;
    /// Weights of the second error estimate, of lower order, which damps the first; empty if there is none.
    const SECOND_ERROR: Row;
    /// Whether the error estimate needs the slope at the new state.
    const ERROR_USES_LAST: bool;
    /// Weights of the coefficients `F₄` and up of the dense output.
    const DENSE_ROWS: &'static [Row];
    /// Weight of the previous error in the step-size control.
    const BETA: f64;
    /// Smallest and largest factor from one step size to the next.
    const FACTORS: (f64, f64);

    /// Makes room for the slopes.
    fn slopes<T>(make: impl FnMut(usize) -> T) -> Self::Slopes<T>;

    /// Makes room for the polynomial of the dense output.
    fn polynomial<T>(make: impl FnMut(usize) -> T) -> Self::Polynomial<T>;

    /// The instants of the inner stages of a step, all in one call.
    fn instants<S: Scalar, Y: System<S>>(system: &Y, time: S, step: S) -> Self::Nodes<Y::Instant>;

    /// The instants of the stages for the dense output.
    fn extra_instants<S: Scalar, Y: System<S>>(
        system: &Y,
        time: S,
        step: S,
    ) -> Self::ExtraNodes<Y::Instant>;
}

/// The times of stages. A loop, since arithmetic in a closure would escape a copy of the code for newer processors.
#[inline(always)]
pub(super) fn stage_times<S: Scalar, const K: usize>(nodes: [f64; K], time: S, step: S) -> [S; K] {
    let mut times = [time; K];
    for (stage, node) in times.iter_mut().zip(nodes) {
        *stage = S::from_f64(node).mul_add(step, time);
    }
    times
}
