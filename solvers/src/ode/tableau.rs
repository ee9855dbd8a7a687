//! What distinguishes one explicit Runge–Kutta method from another: its coefficients.

use super::dop853::DOP853;
use super::tsit5::TSIT5;

/// A row of a tableau without its zeros: number of the slope (from 0) and its coefficient.
pub type Row = &'static [(usize, f64)];

/// An explicit Runge–Kutta method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Explicit {
    /// Tsitouras' pair of order 5(4), with dense output of order 4 that needs no further stages.
    Tsit5,
    /// The method of order 8 of Dormand and Prince with error estimates of order 5 and 3, and dense output of order 7.
    Dop853,
}

impl Explicit {
    /// Its coefficients.
    pub const fn tableau(self) -> &'static Tableau {
        match self {
            Self::Tsit5 => &TSIT5,
            Self::Dop853 => &DOP853,
        }
    }
}

/// An explicit Runge–Kutta method as data.
///
/// Slope 0 belongs to the begin of the step, slopes 1 to `stages - 1` to the inner stages, slope `stages` to the new
/// state (it is slope 0 of the next step), and the slopes after it to the stages that only the dense output needs. The
/// last inner stage lies at the end of the step, so that the new state shares its instant.
///
/// The continuous solution over a step, with `θ` from 0 to 1, is
/// `y(θ) = y₀ + θ(F₁ + (1-θ)(F₂ + θ(F₃ + (1-θ)(F₄ + …))))`, where `F₁ = y₁ - y₀`, `F₂ = h k₀ - F₁`,
/// `F₃ = 2F₁ - h(k₀ + k₁)` make the cubic Hermite polynomial (`k₀`, `k₁` the slopes at both ends) and the others are
/// combinations of all slopes.
#[derive(Clone, Copy, Debug)]
pub struct Tableau {
    /// Order of the solution that is carried on.
    pub order: usize,
    /// Stages from which the new state is formed.
    pub stages: usize,
    /// Times of the inner stages 1 to `stages - 1`, in parts of the step; the last is 1.
    pub nodes: &'static [f64],
    /// Times of the stages for the dense output.
    pub extra_nodes: &'static [f64],
    /// Coefficients of the inner stages.
    pub rows: &'static [Row],
    /// Weights of the new state.
    pub weights: Row,
    /// Coefficients of the stages for the dense output.
    pub extra_rows: &'static [Row],
    /// Weights of the error estimate.
    pub error: Row,
    /// Weights of the second error estimate, of lower order, which damps the first; empty if there is none.
    pub second_error: Row,
    /// Whether the error estimate needs the slope at the new state.
    pub error_uses_last: bool,
    /// Weights of the coefficients `F₄` and up of the dense output.
    pub dense_rows: &'static [Row],
    /// Weight of the previous error in the step-size control.
    pub beta: f64,
    /// Smallest and largest factor from one step size to the next.
    pub factors: (f64, f64),
}

impl Tableau {
    /// Number of slopes.
    pub const fn slopes(&self) -> usize {
        self.stages + 1 + self.extra_rows.len()
    }

    /// Number of coefficients of the continuous solution beside the state at the begin.
    pub const fn degree(&self) -> usize {
        3 + self.dense_rows.len()
    }

    /// Evaluations of a step that is tried.
    pub(super) const fn tried(&self) -> usize {
        self.stages - 1 + self.error_uses_last as usize
    }

    /// Evaluations that finish it.
    pub(super) const fn finished(&self, dense: bool) -> usize {
        let extra = if dense { self.extra_rows.len() } else { 0 };
        extra + !self.error_uses_last as usize
    }
}
