//! General linear systems of run-time size.

/// A matrix without an inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Singular {
    /// Column without a usable pivot: all candidates are zero, or one is not finite.
    pub column: usize,
}

impl std::fmt::Display for Singular {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "singular matrix: no pivot in column {}", self.column + 1)
    }
}

impl std::error::Error for Singular {}

/// A square matrix of run-time size, factored as `P A = L U` with partial pivoting.
#[derive(Clone, Debug)]
pub struct Lu {
    size: usize,
    factors: Vec<f64>,
    pivots: Vec<usize>,
    /// 1-norm of the matrix itself.
    norm: f64,
}

impl Lu {
    /// Factors a matrix of `size` rows and columns, stored row by row.
    ///
    /// # Errors
    /// [`Singular`] if a column has no pivot, with the column.
    pub fn new(mut matrix: Vec<f64>, size: usize) -> Result<Self, Singular> {
        let norm = norm(&matrix, size);
        let mut pivots = vec![0; size];
        Self::factor(&mut matrix, size, &mut pivots)?;
        Ok(Self { size, factors: matrix, pivots, norm })
    }

    /// Factors a matrix of `n` rows and columns in place, without allocating; `pivots` has length `n`.
    ///
    /// # Errors
    /// [`Singular`] if a column has no pivot, with the column. The matrix is then partly overwritten.
    pub fn factor(matrix: &mut [f64], n: usize, pivots: &mut [usize]) -> Result<(), Singular> {
        debug_assert!(matrix.len() == n * n && pivots.len() == n);
        for column in 0..n {
            let mut best = column;
            for row in column..n {
                let size = matrix[row * n + column].abs();
                if !size.is_finite() {
                    return Err(Singular { column });
                }
                if size > matrix[best * n + column].abs() {
                    best = row;
                }
            }
            if matrix[best * n + column] == 0.0 {
                return Err(Singular { column });
            }
            pivots[column] = best;
            if best != column {
                for k in 0..n {
                    matrix.swap(column * n + k, best * n + k);
                }
            }
            let (above, below) = matrix.split_at_mut((column + 1) * n);
            let pivot_row = &above[column * n..];
            for row in below.chunks_exact_mut(n) {
                let multiple = row[column] / pivot_row[column];
                row[column] = multiple;
                for (entry, pivot) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                    *entry -= multiple * pivot;
                }
            }
        }
        Ok(())
    }

    /// Solves `A x = right` in place with what [`Lu::factor`] left in `matrix` and `pivots`.
    pub fn substitute(matrix: &[f64], pivots: &[usize], right: &mut [f64]) {
        let n = pivots.len();
        debug_assert!(matrix.len() == n * n && right.len() == n);
        for (column, &best) in pivots.iter().enumerate() {
            right.swap(column, best);
        }
        for row in 1..n {
            let (known, rest) = right.split_at_mut(row);
            rest[0] -= dot(&matrix[row * n..row * n + row], known);
        }
        for row in (0..n).rev() {
            let (rest, known) = right.split_at_mut(row + 1);
            rest[row] -= dot(&matrix[row * n + row + 1..(row + 1) * n], known);
            rest[row] /= matrix[row * n + row];
        }
    }

    /// Solves `A x = right` in place.
    pub fn solve(&self, right: &mut [f64]) {
        Self::substitute(&self.factors, &self.pivots, right);
    }

    /// Number of rows and columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Condition number in the 1-norm, `‖A‖ ‖A⁻¹‖`, from the whole inverse: about `2 n³` operations.
    ///
    /// About `log10` of it many decimal digits of the right-hand side are lost in the solution.
    pub fn condition(&self) -> f64 {
        let mut largest = 0.0;
        let mut column = vec![0.0; self.size];
        for j in 0..self.size {
            column.fill(0.0);
            column[j] = 1.0;
            self.solve(&mut column);
            largest = greater(largest, column.iter().map(|value| value.abs()).sum());
        }
        self.norm * largest
    }
}

/// Largest sum of absolute values in a column.
fn norm(matrix: &[f64], n: usize) -> f64 {
    (0..n)
        .map(|column| matrix.iter().skip(column).step_by(n).map(|value| value.abs()).sum())
        .fold(0.0, greater)
}

/// The greater of two numbers; NaN if one is NaN.
fn greater(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Sum of products.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn general_systems_need_pivots() -> Result<(), Singular> {
        let matrix = vec![0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 4.0, -1.0, 3.0];
        let lu = Lu::new(matrix.clone(), 3)?;
        let x = [1.5, -2.0, 0.25];
        let mut right: Vec<f64> = matrix.chunks(3).map(|row| dot(row, &x)).collect();
        lu.solve(&mut right);
        for (found, expected) in right.iter().zip(x) {
            assert!((found - expected).abs() < 1e-14);
        }
        assert_eq!(lu.size(), 3);
        Lu::new(Vec::new(), 0)?.solve(&mut []);
        Ok(())
    }

    #[test]
    fn singular_matrices_are_told() {
        let fails = |matrix: Vec<f64>| Lu::new(matrix, 2).err().map(|singular| singular.column);
        assert_eq!(fails(vec![1.0, 2.0, 2.0, 4.0]), Some(1));
        assert_eq!(fails(vec![0.0, 2.0, 0.0, 4.0]), Some(0));
        assert_eq!(fails(vec![1.0, f64::NAN, 2.0, 4.0]), Some(1));
        assert_eq!(fails(vec![1.0, 2.0, 3.0, 4.0]), None);
    }

    #[test]
    fn condition_number_of_the_hilbert_matrix() -> Result<(), Singular> {
        let hilbert: Vec<f64> = (0..16).map(|k| 1.0 / (k / 4 + k % 4 + 1) as f64).collect();
        let condition = Lu::new(hilbert, 4)?.condition();
        assert!((condition / 28375.0 - 1.0).abs() < 1e-10, "{condition}");
        let diagonal = Lu::new(vec![1e-3, 0.0, 0.0, 10.0], 2)?.condition();
        assert!((diagonal / 1e4 - 1.0).abs() < 1e-14);
        Ok(())
    }
}
