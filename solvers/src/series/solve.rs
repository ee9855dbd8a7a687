//! Linear systems of series.

use super::{Terms, none};
use crate::dense::Factored;
use crate::scalar::Scalar;

/// A matrix of `N` rows with its factors `F` at the begin.
#[derive(Clone, Debug)]
pub struct Matrix<S, F, const N: usize> {
    entries: [[Terms<S>; N]; N],
    factor: Option<F>,
    solution: [Terms<S>; N],
}

impl<S: Scalar, F, const N: usize> Default for Matrix<S, F, N> {
    fn default() -> Self {
        Self { entries: [[none(); N]; N], factor: None, solution: [none(); N] }
    }
}

impl<S: Scalar, F: Factored<S, N>, const N: usize> Matrix<S, F, N> {
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
        let factor = self.factor.get_or_insert_with(|| F::of(matrix));
        let solution = factor.solution(rest);
        for (terms, value) in self.solution.iter_mut().zip(solution) {
            terms[k] = value;
        }
        solution
    }
}
