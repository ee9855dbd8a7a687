//! The linear equations `(I - Φ) δ = gap` that close a motion, solved as far as they are known.

use super::error::PeriodicError;
use crate::floquet::{Closing, Multiplier, multipliers};
use nalgebra::{DMatrix, DVector};

/// Largest relative error of the motion that is still worth returning.
const USEFUL_ERROR: f64 = 1e-2;
/// Number of refinements of a solution.
const REFINEMENTS: usize = 2;
/// Distance of a multiplier from +1 from which on a large error is not the fault of a resonance.
const FAR: f64 = 0.1;

/// A solution.
pub(crate) struct Closed {
    /// `δ`.
    pub change: DVector<f64>,
    /// Directions that it leaves open: free motions which repeat after the period and are not driven.
    pub free: Vec<DVector<f64>>,
}

impl Closing {
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
        let nearest = multipliers(&phi, None, f64::EPSILON)
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
