//! The linear equations `(I - Φ) δ = gap` that close a motion.

use super::error::PeriodicError;
use super::multipliers::{self, Multiplier};
use nalgebra::linalg::{LU, SVD};
use nalgebra::{DMatrix, DVector, Dyn};

/// Largest relative error of the motion that is still worth returning.
const USEFUL_ERROR: f64 = 1e-2;
/// Number of refinements of a solution.
const REFINEMENTS: usize = 2;

/// The matrix `I - Φ` with its decompositions.
pub(super) struct Closing {
    /// `I - Φ`.
    matrix: DMatrix<f64>,
    /// `1 + ‖Φ‖`, the size that errors of the matrix are relative to.
    size: f64,
    /// Its triangular factors.
    factors: LU<f64, Dyn, Dyn>,
    /// Its singular values and vectors; `None` if there are no states.
    singular: Option<SVD<f64, Dyn, Dyn>>,
}

impl Closing {
    /// The matrix for `Φ`.
    pub fn new(phi: &DMatrix<f64>) -> Self {
        let matrix = DMatrix::identity(phi.nrows(), phi.ncols()) - phi;
        let singular = (!matrix.is_empty()).then(|| matrix.clone().svd(true, true));
        Self {
            size: 1.0 + phi.norm(),
            factors: matrix.clone().lu(),
            singular,
            matrix,
        }
    }

    /// Amplification of relative errors of `Φ`: `(1 + ‖Φ‖) / σ`, `σ` the smallest singular value.
    pub fn condition(&self) -> f64 {
        self.singular
            .as_ref()
            .map_or(1.0, |singular| self.size / singular.singular_values.min())
    }

    /// The determinant of `I - Φ`.
    pub fn determinant(&self) -> f64 {
        self.factors.determinant()
    }

    /// Solves for `δ` where `Φ` has a relative error `uncertainty`.
    ///
    /// A direction that is known too badly for a useful solution is left out if the gap has at most `load` in it: then
    /// nothing drives the free motion there, and the motion without it is a solution.
    ///
    /// # Errors
    /// [`PeriodicError::Resonance`] if such a direction is driven.
    pub fn solve(
        &self,
        gap: &DVector<f64>,
        uncertainty: f64,
        load: f64,
    ) -> Result<DVector<f64>, PeriodicError> {
        let Some(singular) = &self.singular else {
            return Ok(gap.clone());
        };
        let expected_error = uncertainty * self.condition();
        if expected_error <= USEFUL_ERROR
            && let Some(solution) = self.refined(gap)
        {
            return Ok(solution);
        }
        let (Some(left), Some(right)) = (&singular.u, &singular.v_t) else {
            return Ok(gap.clone());
        };
        let mut solution = DVector::zeros(gap.len());
        for (number, &value) in singular.singular_values.iter().enumerate() {
            let part = left.column(number).dot(gap);
            let direction = right.row(number).transpose();
            if uncertainty * self.size <= USEFUL_ERROR * value {
                solution += direction * (part / value);
            } else if part.is_nan() || part.abs() > load {
                return Err(self.resonance(expected_error, direction.iamax()));
            }
        }
        Ok(solution)
    }

    /// The solution by triangular factors with iterative refinement; `None` if the matrix is singular.
    fn refined(&self, gap: &DVector<f64>) -> Option<DVector<f64>> {
        let mut solution = self.factors.solve(gap)?;
        for _ in 0..REFINEMENTS {
            let rest = gap - &self.matrix * &solution;
            solution += self.factors.solve(&rest)?;
        }
        Some(solution)
    }

    /// The facts of a resonance.
    fn resonance(&self, expected_error: f64, state: usize) -> PeriodicError {
        let phi = DMatrix::identity(self.matrix.nrows(), self.matrix.ncols()) - &self.matrix;
        let nearest = multipliers::of(&phi)
            .into_iter()
            .min_by(|a, b| a.distance().total_cmp(&b.distance()));
        let multiplier = nearest.unwrap_or(Multiplier { re: 1.0, im: 0.0 });
        let (distance, condition) = (multiplier.distance(), self.condition());
        PeriodicError::Resonance {
            multiplier,
            distance,
            condition,
            expected_error,
            state,
        }
    }
}
