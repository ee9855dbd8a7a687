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
        let (entries, solution) = (self.entries.as_flattened_mut(), &mut self.solution);
        take(k, (matrix.as_flattened(), entries), solution, &mut rest);
        let factor = self.factor.get_or_insert_with(|| F::of(matrix));
        let found = factor.solution(rest);
        for (terms, value) in solution.iter_mut().zip(found) {
            terms[k] = value;
        }
        found
    }
}

/// Keeps the next terms of a matrix, and takes off a right-hand side what the terms so far make of it.
#[inline(always)]
fn take<S: Scalar>(
    k: usize,
    (matrix, entries): (&[S], &mut [Terms<S>]),
    solution: &[Terms<S>],
    rest: &mut [S],
) {
    let n = solution.len();
    for (i, rest) in rest.iter_mut().enumerate() {
        for j in 0..n {
            let terms = &mut entries[i * n + j];
            terms[k] = matrix[i * n + j];
            for term in 1..=k {
                *rest = *rest - terms[term] * solution[j][k - term];
            }
        }
    }
}

/// What [`Matrix`] is, of a size that is known at run time; its factors are kept by whoever solves.
#[derive(Clone, Debug)]
pub struct MatrixRows<S> {
    entries: Vec<Terms<S>>,
    solution: Vec<Terms<S>>,
}

impl<S: Scalar> MatrixRows<S> {
    /// Of so many rows.
    pub fn new(rows: usize) -> Self {
        Self { entries: vec![none(); rows * rows], solution: vec![none(); rows] }
    }

    /// The next term of the solution in place of the right-hand side; `solve` solves with the matrix at the begin.
    pub fn next(&mut self, k: usize, matrix: &[S], right: &mut [S], solve: impl FnOnce(&mut [S])) {
        take(k, (matrix, &mut self.entries), &self.solution, right);
        solve(right);
        for (terms, value) in self.solution.iter_mut().zip(right) {
            terms[k] = *value;
        }
    }
}
