//! Small linear systems of any scalar, without branches up to three unknowns.

use crate::scalar::Scalar;

/// Solves `A x = right` in place for a matrix of `n` rows, stored row by row, and gives its determinant. A singular one
/// gives zero and no number.
#[inline(always)]
pub(crate) fn solve<S: Scalar>(n: usize, matrix: &mut [S], right: &mut [S]) -> S {
    match n {
        0 => S::ONE,
        1 => {
            right[0] = right[0] / matrix[0];
            matrix[0]
        }
        2 => two(matrix, right),
        3 => three(matrix, right),
        _ => S::outline(
            #[inline(always)]
            || eliminate(n, matrix, right),
        ),
    }
}

/// `a*d - b*c`
#[inline(always)]
fn minor<S: Scalar>(a: S, b: S, c: S, d: S) -> S {
    a.mul_add(d, -(b * c))
}

#[inline(always)]
fn two<S: Scalar>(m: &[S], right: &mut [S]) -> S {
    let determinant = minor(m[0], m[1], m[2], m[3]);
    let inverse = S::ONE / determinant;
    let (x, y) = (right[0], right[1]);
    right[0] = minor(x, m[1], y, m[3]) * inverse;
    right[1] = minor(m[0], x, m[2], y) * inverse;
    determinant
}

/// By cross products: the rows of the inverse are those of pairs of columns over the determinant.
#[inline(always)]
fn three<S: Scalar>(m: &[S], right: &mut [S]) -> S {
    let first = [
        minor(m[4], m[5], m[7], m[8]),
        minor(m[2], m[1], m[8], m[7]),
        minor(m[1], m[2], m[4], m[5]),
    ];
    let second = [
        minor(m[5], m[3], m[8], m[6]),
        minor(m[0], m[2], m[6], m[8]),
        minor(m[2], m[0], m[5], m[3]),
    ];
    let third = [
        minor(m[3], m[4], m[6], m[7]),
        minor(m[1], m[0], m[7], m[6]),
        minor(m[0], m[1], m[3], m[4]),
    ];
    let product = |row: [S; 3], x: S, y: S, z: S| row[0].mul_add(x, row[1].mul_add(y, row[2] * z));
    let determinant = product(first, m[0], m[3], m[6]);
    let inverse = S::ONE / determinant;
    let (x, y, z) = (right[0], right[1], right[2]);
    right[0] = product(first, x, y, z) * inverse;
    right[1] = product(second, x, y, z) * inverse;
    right[2] = product(third, x, y, z) * inverse;
    determinant
}

/// Elimination with partial pivoting.
#[inline(always)]
fn eliminate<S: Scalar>(n: usize, matrix: &mut [S], right: &mut [S]) -> S {
    let mut determinant = S::ONE;
    for column in 0..n {
        // Each lane chooses for itself: a row that is larger comes to the place of the pivot.
        for row in column + 1..n {
            let (here, there) = (matrix[row * n + column], matrix[column * n + column]);
            let larger = S::less(there.abs(), here.abs());
            let swap = |a: &mut S, b: &mut S| {
                (*a, *b) = (S::select(larger, *b, *a), S::select(larger, *a, *b));
            };
            if !S::any(larger) {
                continue;
            }
            let (above, below) = matrix.split_at_mut(row * n);
            let pivots = &mut above[column * n..][..n];
            pivots.iter_mut().zip(below).for_each(|(a, b)| swap(a, b));
            let (above, below) = right.split_at_mut(row);
            swap(&mut above[column], &mut below[0]);
            determinant = S::select(larger, -determinant, determinant);
        }
        let pivot = matrix[column * n + column];
        determinant = determinant * pivot;
        for row in column + 1..n {
            let multiple = matrix[row * n + column] / pivot;
            for k in column + 1..n {
                matrix[row * n + k] =
                    multiple.mul_add(-matrix[column * n + k], matrix[row * n + k]);
            }
            right[row] = multiple.mul_add(-right[column], right[row]);
        }
    }
    for row in (0..n).rev() {
        for k in row + 1..n {
            right[row] = matrix[row * n + k].mul_add(-right[k], right[row]);
        }
        right[row] = right[row] / matrix[row * n + row];
    }
    determinant
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dense::Lu;

    #[test]
    fn agrees_with_the_general_factors() {
        for n in 1..=5 {
            let entry = |k: usize| ((k * k + 3 * k + 1) as f64 * 1.7).sin();
            let mut matrix: Vec<f64> = (0..n * n).map(entry).collect();
            let mut right: Vec<f64> = (0..n).map(|k| 1.0 + k as f64).collect();
            let mut expected = right.clone();
            Lu::new(matrix.clone(), n).unwrap().solve(&mut expected);
            let determinant = solve(n, &mut matrix, &mut right);
            assert!(determinant != 0.0);
            for (found, expected) in right.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0));
            }
        }
    }

    #[test]
    fn determinants_have_their_sign() {
        let mut swap = [0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 2.0];
        assert_eq!(solve(3, &mut swap, &mut [1.0, 2.0, 3.0]), -2.0);
        let mut four = [0.0; 16];
        for (row, column) in [(0, 1), (1, 0), (2, 2), (3, 3)] {
            four[4 * row + column] = 1.0;
        }
        assert_eq!(solve(4, &mut four, &mut [0.0; 4]), -1.0);
        assert_eq!(solve(2, &mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]), 0.0);
    }
}
