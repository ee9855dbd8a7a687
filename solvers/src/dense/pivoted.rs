//! General linear systems of fixed size inside equations.

use super::Factored;
use crate::scalar::Scalar;

/// A square matrix, factored as `P A = L U` with partial pivoting, in each lane by itself.
#[derive(Clone, Copy, Debug)]
pub struct Pivoted<S, const N: usize> {
    /// `L` below its diagonal of ones, `U` above.
    factors: [[S; N]; N],
    /// Reciprocals of the diagonal of `U`.
    reciprocals: [S; N],
    /// The row of `A` that has become each row, as a number: lanes may differ.
    origins: [S; N],
}

/// Factors a matrix.
///
/// One without an inverse gives a large, infinite or NaN solution, never a panic.
#[inline(always)]
pub fn factor_pivoted<S: Scalar, const N: usize>(matrix: [[S; N]; N]) -> Pivoted<S, N> {
    let mut factors = matrix;
    let mut reciprocals = [S::ZERO; N];
    let mut origins = [S::ZERO; N];
    pivot_rows(factors.as_flattened_mut(), &mut reciprocals, &mut origins);
    Pivoted { factors, reciprocals, origins }
}

/// [`factor_pivoted`] of a matrix that is given row by row, in its place.
#[inline(always)]
pub fn pivot_rows<S: Scalar>(factors: &mut [S], reciprocals: &mut [S], origins: &mut [S]) {
    let n = reciprocals.len();
    for (row, origin) in origins.iter_mut().enumerate() {
        *origin = S::from_f64(row as f64);
    }
    for column in 0..n {
        // The largest entry comes to the diagonal by exchanges, because the lanes exchange different rows.
        for row in column + 1..n {
            let (own, other) = (factors[column * n + column], factors[row * n + column]);
            let is_larger = S::less(own.abs(), other.abs());
            let (above, below) = factors.split_at_mut(row * n);
            for (upper, lower) in above[column * n..][..n].iter_mut().zip(below) {
                let (a, b) = (*upper, *lower);
                *upper = S::select(is_larger, b, a);
                *lower = S::select(is_larger, a, b);
            }
            let (upper, lower) = (origins[column], origins[row]);
            origins[column] = S::select(is_larger, lower, upper);
            origins[row] = S::select(is_larger, upper, lower);
        }
        reciprocals[column] = S::ONE / factors[column * n + column];
        for row in column + 1..n {
            let multiple = factors[row * n + column] * reciprocals[column];
            let (above, below) = factors.split_at_mut(row * n);
            let pairs = above[column * n..][..n].iter().zip(below);
            for (upper, lower) in pairs.skip(column + 1) {
                *lower = upper.mul_add(-multiple, *lower);
            }
            factors[row * n + column] = multiple;
        }
    }
}

/// Solves for `x` with what [`pivot_rows`] has left.
#[inline(always)]
pub fn solve_pivoted<S: Scalar>(
    (factors, reciprocals, origins): (&[S], &[S], &[S]),
    right: &[S],
    x: &mut [S],
) {
    let n = reciprocals.len();
    x.fill(S::ZERO);
    for (value, origin) in x.iter_mut().zip(origins) {
        for (row, right) in right.iter().enumerate() {
            let is_origin = S::equal(*origin, S::from_f64(row as f64));
            *value = S::select(is_origin, *right, *value);
        }
    }
    for row in 1..n {
        for k in 0..row {
            x[row] = factors[row * n + k].mul_add(-x[k], x[row]);
        }
    }
    for row in (0..n).rev() {
        for k in row + 1..n {
            x[row] = factors[row * n + k].mul_add(-x[k], x[row]);
        }
        x[row] = x[row] * reciprocals[row];
    }
}

impl<S: Scalar, const N: usize> Pivoted<S, N> {
    /// Solves `A x = right` for `x`.
    #[inline(always)]
    pub fn solve(&self, right: [S; N]) -> [S; N] {
        let mut x = [S::ZERO; N];
        let factored = (self.factors.as_flattened(), &self.reciprocals[..], &self.origins[..]);
        solve_pivoted(factored, &right, &mut x);
        x
    }
}

impl<S: Scalar, const N: usize> Factored<S, N> for Pivoted<S, N> {
    #[inline(always)]
    fn of(matrix: [[S; N]; N]) -> Self {
        factor_pivoted(matrix)
    }

    #[inline(always)]
    fn solution(&self, right: [S; N]) -> [S; N] {
        self.solve(right)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Fused;

    /// Largest residual of a system that has no solution without exchanges: the diagonal is zero.
    fn residual<S: Scalar, const N: usize>() -> f64 {
        let entry = |i: usize, j: usize| match i == j {
            true => 0.0,
            false => 1.0 / (i + 2 * j + 1) as f64 - if j == i + 1 { 3.0 } else { 0.0 },
        };
        let matrix = std::array::from_fn(|i| std::array::from_fn(|j| S::from_f64(entry(i, j))));
        let right: [f64; N] = std::array::from_fn(|i| 1.0 - i as f64 * 0.7);
        let x = factor_pivoted::<S, N>(matrix).solve(right.map(S::from_f64));
        (0..N)
            .map(|i| {
                let row: f64 = (0..N).map(|j| entry(i, j) * x[j].to_f64()).sum();
                (row - right[i]).abs()
            })
            .fold(0.0, |worst: f64, value| if value <= worst { worst } else { value })
    }

    #[test]
    fn systems_with_zeros_on_the_diagonal_are_solved() {
        for (residual, most) in [
            (residual::<f64, 2>(), 1e-14),
            (residual::<f64, 7>(), 1e-14),
            (residual::<Fused, 13>(), 1e-13),
            (residual::<f32, 7>(), 1e-5),
        ] {
            assert!(residual < most, "{residual}");
        }
    }

    #[test]
    fn a_matrix_without_an_inverse_gives_no_number() {
        let solution = factor_pivoted([[1.0, 2.0], [2.0, 4.0_f64]]).solve([1.0, 0.0]);
        assert!(!solution[0].is_finite());
    }
}
