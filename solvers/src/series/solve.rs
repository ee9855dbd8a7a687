//! Linear systems of series.

use super::{Terms, none};
use crate::dense::{Factor, factor};
use crate::scalar::Scalar;

/// A symmetric positive matrix with its factors at the begin, `N` rows.
#[derive(Clone, Debug)]
pub struct Matrix<S, const N: usize> {
    entries: [[Terms<S>; N]; N],
    factor: Option<Factor<S, N>>,
    solution: [Terms<S>; N],
}

impl<S: Scalar, const N: usize> Default for Matrix<S, N> {
    fn default() -> Self {
        Self {
            entries: [[none(); N]; N],
            factor: None,
            solution: [none(); N],
        }
    }
}

impl<S: Scalar, const N: usize> Matrix<S, N> {
    /// The next term of the solution of `M x = b`: that of `M₀ x_k = b_k - Σ M_j x_(k-j)`.
    #[inline(always)]
    pub fn next(&mut self, k: usize, matrix: [[S; N]; N], right: [S; N]) -> [S; N] {
        let mut rest = right;
        for (i, rest) in rest.iter_mut().enumerate() {
            for (j, entry) in matrix[i].into_iter().enumerate() {
                self.entries[i][j][k] = entry;
                for term in 1..=k {
                    *rest = *rest - self.entries[i][j][term] * self.solution[j][k - term];
                }
            }
        }
        let factor = self.factor.get_or_insert_with(|| factor(matrix));
        let solution = factor.solve(rest);
        for (terms, value) in self.solution.iter_mut().zip(solution) {
            terms[k] = value;
        }
        solution
    }
}
