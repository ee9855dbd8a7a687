//! The linear equations `(I - Φ) δ = gap` that close a motion.
//!
//! States differ in size by more than their scales tell: the speeds of a stiff mechanism are its displacements times a
//! high frequency. So the matrix is balanced first (B. N. Parlett, C. Reinsch, Numer. Math. 13, 1969), and conditions
//! and errors are those of the balanced one.

use super::error::PeriodicError;
use super::multipliers::{self, Multiplier};
use nalgebra::linalg::{LU, SVD, balancing};
use nalgebra::{DMatrix, DVector, Dyn};

/// Largest relative error of the motion that is still worth returning.
const USEFUL_ERROR: f64 = 1e-2;
/// Number of refinements of a solution.
const REFINEMENTS: usize = 2;
/// Distance of a multiplier from +1 from which on a large error is not the fault of a resonance.
const FAR: f64 = 0.1;

/// The matrix `I - Φ` with its decompositions, balanced.
pub(crate) struct Closing {
    /// Sizes of the states; the matrix is `D⁻¹ (I - Φ) D`.
    sizes: DVector<f64>,
    /// The balanced matrix.
    matrix: DMatrix<f64>,
    /// `1 + ‖Φ‖`, the size that errors of the matrix are relative to.
    size: f64,
    /// Its triangular factors.
    factors: LU<f64, Dyn, Dyn>,
    /// Its singular values and vectors; `None` if there are no states.
    singular: Option<SVD<f64, Dyn, Dyn>>,
}

/// A solution.
pub(crate) struct Closed {
    /// `δ`.
    pub change: DVector<f64>,
    /// Directions that it leaves open: free motions which repeat after the period and are not driven.
    pub free: Vec<DVector<f64>>,
}

impl Closing {
    /// The matrix for `Φ`.
    pub fn new(phi: &DMatrix<f64>) -> Self {
        let mut balanced = phi.clone();
        let finite = !phi.is_empty() && phi.iter().all(|entry| entry.is_finite());
        let sizes = match finite {
            true => balancing::balance_parlett_reinsch(&mut balanced),
            false => DVector::from_element(phi.nrows(), 1.0),
        };
        let matrix = DMatrix::identity(phi.nrows(), phi.ncols()) - &balanced;
        Self {
            size: 1.0 + balanced.norm(),
            factors: matrix.clone().lu(),
            singular: (!matrix.is_empty()).then(|| matrix.clone().svd(true, true)),
            matrix,
            sizes,
        }
    }

    /// Amplification of relative errors of `Φ`: `(1 + ‖Φ‖) / σ`, `σ` the smallest singular value.
    pub fn condition(&self) -> f64 {
        self.singular.as_ref().map_or(1.0, |singular| self.size / singular.singular_values.min())
    }

    /// The determinant of `I - Φ`.
    pub fn determinant(&self) -> f64 {
        self.factors.determinant()
    }

    /// Relative size of a difference of two computations of `Φ`, as a measure of its error.
    pub fn uncertainty(&self, difference: &DMatrix<f64>) -> f64 {
        let balanced = DMatrix::from_fn(difference.nrows(), difference.ncols(), |row, column| {
            difference[(row, column)] * self.sizes[column] / self.sizes[row]
        });
        balanced.norm() / self.size
    }

    /// Size of a vector of states.
    pub fn length(&self, vector: &DVector<f64>) -> f64 {
        vector.component_div(&self.sizes).norm()
    }

    /// Solves for `δ` where `Φ` has a relative error `uncertainty`.
    ///
    /// A direction that is known too badly for a useful solution is left open if the gap has at most `load` in it: then
    /// nothing drives the free motion there, and the motion without it is a solution.
    ///
    /// # Errors
    /// [`PeriodicError::Resonance`] if such a direction is driven, [`PeriodicError::Inaccurate`] if no multiplier is
    /// near +1.
    pub fn solve(
        &self,
        gap: &DVector<f64>,
        uncertainty: f64,
        load: f64,
    ) -> Result<Closed, PeriodicError> {
        let closed =
            |change: DVector<f64>, free| Closed { change: change.component_mul(&self.sizes), free };
        let gap = gap.component_div(&self.sizes);
        let Some(singular) = &self.singular else {
            return Ok(closed(gap, Vec::new()));
        };
        let expected_error = uncertainty * self.condition();
        if expected_error <= USEFUL_ERROR
            && let Some(solution) = self.refined(&gap)
        {
            return Ok(closed(solution, Vec::new()));
        }
        let (Some(left), Some(right)) = (&singular.u, &singular.v_t) else {
            return Ok(closed(gap, Vec::new()));
        };
        let mut solution = DVector::zeros(gap.len());
        let mut free = Vec::new();
        for (number, &value) in singular.singular_values.iter().enumerate() {
            let part = left.column(number).dot(&gap);
            let direction = right.row(number).transpose();
            if uncertainty * self.size <= USEFUL_ERROR * value {
                solution += direction * (part / value);
            } else if part.is_nan() || part.abs() > load {
                return Err(self.failure(expected_error, direction.iamax()));
            } else {
                free.push(direction.component_mul(&self.sizes));
            }
        }
        Ok(closed(solution, free))
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

    /// Why there is no useful solution.
    fn failure(&self, expected_error: f64, state: usize) -> PeriodicError {
        let phi = DMatrix::identity(self.matrix.nrows(), self.matrix.ncols()) - &self.matrix;
        let nearest = multipliers::of(&phi, None, f64::EPSILON)
            .into_iter()
            .min_by(|a, b| a.distance().total_cmp(&b.distance()));
        let multiplier = nearest.unwrap_or(Multiplier { re: 1.0, im: 0.0, error: 0.0 });
        let (distance, condition) = (multiplier.distance(), self.condition());
        if distance > FAR {
            return PeriodicError::Inaccurate { condition, expected_error };
        }
        PeriodicError::Resonance { multiplier, distance, condition, expected_error, state }
    }
}
