//! Linear systems: those of fixed size inside equations, symmetric ones and any others, and those of run-time size in
//! solvers.

mod bound;
mod complex;
mod lu;
mod pivoted;

use crate::scalar::Scalar;
pub use bound::{Bound, BoundRows, Writing, factor_bound};
pub(crate) use bound::{Order, Parts, Reading, Scan};
pub use complex::{Complex, factor_complex, substitute_complex};
pub use lu::{Lu, Singular};
pub use pivoted::{Pivoted, factor_pivoted, pivot_rows, solve_pivoted};

/// A symmetric positive definite matrix, factored as `L D Lᵀ` without square roots.
#[derive(Clone, Copy, Debug)]
pub struct Factor<S, const N: usize> {
    /// `L` below its diagonal of ones.
    lower: [[S; N]; N],
    /// Reciprocals of the diagonal of `D`.
    reciprocals: [S; N],
}

/// Factors a symmetric positive definite matrix, of which the lower triangle is read.
///
/// There is no pivoting. A matrix that is not positive definite gives a large, infinite or NaN solution, never a panic.
#[inline(always)]
pub fn factor<S: Scalar, const N: usize>(matrix: [[S; N]; N]) -> Factor<S, N> {
    let (mut lower, mut reciprocals) = (matrix, [S::ZERO; N]);
    factor_rows(lower.as_flattened_mut(), &mut reciprocals, &mut [S::ZERO; N]);
    Factor { lower, reciprocals }
}

/// [`factor`] of a matrix that is given row by row, in its place; with room for as many numbers as it has rows.
#[inline(always)]
pub fn factor_rows<S: Scalar>(lower: &mut [S], reciprocals: &mut [S], scaled: &mut [S]) {
    let n = reciprocals.len();
    for j in 0..n {
        // Row j of L D, whose entries are needed twice.
        let mut pivot = lower[j * n + j];
        for k in 0..j {
            let mut entry = lower[j * n + k];
            for i in 0..k {
                entry = scaled[i].mul_add(-lower[k * n + i], entry);
            }
            scaled[k] = entry;
            lower[j * n + k] = entry * reciprocals[k];
            pivot = lower[j * n + k].mul_add(-entry, pivot);
        }
        reciprocals[j] = S::ONE / pivot;
    }
}

/// Solves in place with what [`factor_rows`] has left.
#[inline(always)]
pub fn solve_rows<S: Scalar>(lower: &[S], reciprocals: &[S], x: &mut [S]) {
    let n = reciprocals.len();
    for j in 1..n {
        for k in 0..j {
            x[j] = lower[j * n + k].mul_add(-x[k], x[j]);
        }
    }
    for (value, reciprocal) in x.iter_mut().zip(reciprocals) {
        *value = *value * *reciprocal;
    }
    for j in (0..n).rev() {
        for k in j + 1..n {
            x[j] = lower[k * n + j].mul_add(-x[k], x[j]);
        }
    }
}

/// A matrix inside equations, factored.
pub trait Factored<S, const N: usize>: Copy {
    /// Factors a matrix.
    fn of(matrix: [[S; N]; N]) -> Self;
    /// Solves `A x = right` for `x`.
    fn solution(&self, right: [S; N]) -> [S; N];
}

impl<S: Scalar, const N: usize> Factored<S, N> for Factor<S, N> {
    #[inline(always)]
    fn of(matrix: [[S; N]; N]) -> Self {
        factor(matrix)
    }

    #[inline(always)]
    fn solution(&self, right: [S; N]) -> [S; N] {
        self.solve(right)
    }
}

impl<S: Scalar, const N: usize> Factor<S, N> {
    /// Solves `A x = right` for `x`.
    #[inline(always)]
    pub fn solve(&self, right: [S; N]) -> [S; N] {
        let mut x = right;
        solve_rows(self.lower.as_flattened(), &self.reciprocals, &mut x);
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Fused;

    /// Entry of a positive definite matrix: of Hilbert's kind, with a heavier diagonal.
    fn entry(row: usize, column: usize) -> f64 {
        1.0 / (row + column + 1) as f64 + if row == column { 0.25 } else { 0.0 }
    }

    /// Largest residual of a system of size `N` whose upper triangle is NaN.
    fn residual<S: Scalar, const N: usize>() -> f64 {
        let full: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let lower = std::array::from_fn(|i| {
            std::array::from_fn(|j| S::from_f64(if j <= i { full[i][j] } else { f64::NAN }))
        });
        let right: [f64; N] = std::array::from_fn(|i| 1.0 - i as f64 * 0.7);
        let x = factor::<S, N>(lower).solve(right.map(S::from_f64));
        (0..N).map(|i| (0..N).map(|j| full[i][j] * x[j].to_f64()).sum::<f64>() - right[i]).fold(
            0.0,
            |worst: f64, value| {
                if value.is_nan() { value } else { worst.max(value.abs()) }
            },
        )
    }

    #[test]
    fn symmetric_systems_are_solved_from_the_lower_triangle() {
        assert!(residual::<f64, 0>() == 0.0);
        assert!(residual::<f64, 1>() < 1e-15);
        assert!(residual::<f64, 2>() < 1e-14);
        assert!(residual::<f64, 6>() < 1e-14);
        assert!(residual::<Fused, 6>() < 1e-14);
        assert!(residual::<f32, 6>() < 1e-5);
    }

    #[test]
    fn symmetric_factor_is_the_known_one() {
        // L = [[1, 0, 0], [2, 1, 0], [3, 4, 1]], D = diag(4, 2, 1).
        let all = factor([[4.0, 0.0, 0.0], [8.0, 18.0, 0.0], [12.0, 32.0, 69.0]]);
        assert_eq!(all.reciprocals, [0.25, 0.5, 1.0]);
        assert_eq!((all.lower[1][0], all.lower[2][0], all.lower[2][1]), (2.0, 3.0, 4.0));
        assert_eq!(all.solve([24.0, 58.0, 113.0]), [1.0, 1.0, 1.0]);
        let singular = factor([[1.0f64, 1.0], [1.0, 1.0]]).solve([1.0, 2.0]);
        assert!(!singular[0].is_finite());
    }
}
