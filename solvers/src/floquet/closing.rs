//! The matrix `I - Φ` of the linear equations that close a motion.
//!
//! States differ in size by more than their scales tell: the speeds of a stiff mechanism are its displacements times a
//! high frequency. So the matrix is balanced first (B. N. Parlett, C. Reinsch, Numer. Math. 13, 1969), and conditions
//! and errors are those of the balanced one.

use nalgebra::linalg::{LU, SVD, balancing};
use nalgebra::{DMatrix, DVector, Dyn};

/// The matrix `I - Φ` with its decompositions, balanced.
pub(crate) struct Closing {
    /// Sizes of the states; the matrix is `D⁻¹ (I - Φ) D`.
    pub sizes: DVector<f64>,
    /// The balanced matrix.
    pub matrix: DMatrix<f64>,
    /// `1 + ‖Φ‖`, the size that errors of the matrix are relative to.
    pub size: f64,
    /// Its triangular factors.
    pub factors: LU<f64, Dyn, Dyn>,
    /// Its singular values and vectors; `None` if there are no states.
    pub singular: Option<SVD<f64, Dyn, Dyn>>,
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
}
