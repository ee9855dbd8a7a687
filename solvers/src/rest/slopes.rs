//! The linear equations of a Newton step, of which there may be more than unknowns.

use super::error::RestError;
use nalgebra::linalg::SVD;
use nalgebra::{DMatrix, DVector, Dyn};

/// Singular values below this, over the largest, are none: in roundings of each row,
const ROUNDED: f64 = 32.0 * f64::EPSILON;
/// and where closures hold the coordinates, whose reaction forces are known to so much only.
const HELD: f64 = 1e-9;
/// Slopes and residuals of so many times what rounding makes of them are no more than that.
const ROUNDINGS: f64 = 64.0;
/// What a step leaves of the residual of a row, over all that its terms make of a change by the scales: more is a force
/// that nothing balances.
const LEFT: f64 = 1e-6;

/// What rounding makes of slopes and residuals.
pub struct Noise {
    pub slopes: DMatrix<f64>,
    pub residual: DVector<f64>,
}

/// The slopes of the equations of rest, each row over its size.
pub struct Slopes {
    factors: Option<SVD<f64, Dyn, Dyn>>,
    matrix: DMatrix<f64>,
    /// What rounding makes of the residual.
    noise: DVector<f64>,
    /// Sizes of the rows; zero where one depends on nothing.
    sizes: Vec<f64>,
    /// Places of the unknowns in the state vector, with their scales.
    places: Vec<(usize, f64)>,
    states: usize,
    cutoff: f64,
}

impl Slopes {
    /// Of a matrix whose columns are changes by the scales.
    pub fn new(
        mut matrix: DMatrix<f64>,
        noise: Noise,
        places: Vec<(usize, f64)>,
        states: usize,
        is_held: bool,
    ) -> Self {
        let mut sizes: Vec<f64> = matrix.row_iter().map(|row| row.norm()).collect();
        // What is nothing but rounding is nothing, as of weights that springs balance wherever they are.
        for (row, size) in sizes.iter_mut().enumerate() {
            if *size <= ROUNDINGS * noise.slopes.row(row).norm() {
                *size = 0.0;
                matrix.row_mut(row).fill(0.0);
            }
        }
        for (mut row, size) in matrix.row_iter_mut().zip(&sizes) {
            if *size > 0.0 {
                row /= *size;
            }
        }
        let is_finite = !matrix.is_empty() && matrix.iter().all(|value| value.is_finite());
        let factors = is_finite.then(|| matrix.clone().svd(true, true));
        let largest = factors.as_ref().map_or(0.0, |factors| factors.singular_values.max());
        let share = if is_held { HELD } else { ROUNDED * places.len() as f64 };
        Self {
            factors,
            matrix,
            noise: noise.residual,
            sizes,
            places,
            states,
            cutoff: share * largest,
        }
    }

    /// The shortest change of the state that takes a residual away; not numbers where there is none.
    pub fn solve(&self, residual: &DVector<f64>) -> Vec<f64> {
        let mut change = vec![0.0; self.states];
        let right = -over(residual, &self.sizes);
        let solved =
            self.factors.as_ref().and_then(|factors| factors.solve(&right, self.cutoff).ok());
        for (index, (place, scale)) in self.places.iter().enumerate() {
            change[*place] = solved.as_ref().map_or(f64::NAN, |solved| solved[index] * scale);
        }
        change
    }

    /// Number of directions that change nothing.
    pub fn free(&self) -> usize {
        let values = self.factors.iter().flat_map(|factors| factors.singular_values.iter());
        self.places.len() - values.filter(|value| **value > self.cutoff).count()
    }

    /// Whether the residual, of rows of these names, can be taken away at all.
    pub fn check(
        &self,
        residual: &DVector<f64>,
        names: impl Iterator<Item = &'static str>,
    ) -> Result<(), RestError> {
        let step = DVector::from_vec(self.solve(residual));
        let step = DVector::from_iterator(
            self.places.len(),
            self.places.iter().map(|(place, scale)| step[*place] / scale),
        );
        let left = &self.matrix * step + over(residual, &self.sizes);
        for (index, name) in names.enumerate() {
            let alone = if self.sizes[index] == 0.0 { residual[index].abs() } else { 0.0 };
            let (noise, size) = (ROUNDINGS * self.noise[index], self.sizes[index]);
            if alone > noise || left[index].abs() * size > LEFT * size + noise {
                return Err(RestError::Unbalanced { name, rate: residual[index] });
            }
        }
        Ok(())
    }
}

/// A residual with each row over its size; that of a row without slopes as it is not taken away by any step.
fn over(residual: &DVector<f64>, sizes: &[f64]) -> DVector<f64> {
    let parts = residual.iter().zip(sizes);
    let parts = parts.map(|(value, size)| if *size > 0.0 { value / size } else { 0.0 });
    DVector::from_iterator(residual.len(), parts)
}

/// Orthonormal columns that a matrix makes nothing of, rows of any size.
pub fn nullspace(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let columns = matrix.ncols();
    if matrix.nrows() == 0 || columns == 0 {
        return DMatrix::identity(columns, columns);
    }
    let sizes: Vec<f64> = matrix.row_iter().map(|row| row.norm().max(f64::MIN_POSITIVE)).collect();
    let matrix =
        DMatrix::from_fn(matrix.nrows(), columns, |row, column| matrix[(row, column)] / sizes[row]);
    // The singular vectors of a wide matrix leave out those that it makes nothing of.
    let gram = matrix.transpose() * &matrix;
    let parts = gram.symmetric_eigen();
    let largest = parts.eigenvalues.max();
    let none = (0..columns).filter(|index| parts.eigenvalues[*index] <= HELD * largest);
    let none: Vec<usize> = none.collect();
    parts.eigenvectors.select_columns(&none)
}
