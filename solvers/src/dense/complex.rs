//! General linear systems over the complex numbers.

use super::Singular;

/// A complex number: its real and its imaginary part.
pub type Complex = [f64; 2];

/// Factors a complex matrix of `n` rows and columns, stored row by row, as `P A = L U` in place; `pivots` has length `n`.
/// Nothing is allocated.
///
/// # Errors
/// [`Singular`] if a column has no pivot, with the column. The matrix is then partly overwritten.
pub fn factor_complex(
    matrix: &mut [Complex],
    n: usize,
    pivots: &mut [usize],
) -> Result<(), Singular> {
    debug_assert!(matrix.len() == n * n && pivots.len() == n);
    for column in 0..n {
        let mut best = (column, 0.0);
        for row in column..n {
            let size = size(matrix[row * n + column]);
            if !size.is_finite() {
                return Err(Singular { column });
            }
            if size > best.1 {
                best = (row, size);
            }
        }
        if best.1 == 0.0 {
            return Err(Singular { column });
        }
        pivots[column] = best.0;
        if best.0 != column {
            for k in 0..n {
                matrix.swap(column * n + k, best.0 * n + k);
            }
        }
        let (above, below) = matrix.split_at_mut((column + 1) * n);
        let pivot_row = &mut above[column * n..];
        // The diagonal keeps the reciprocal of its pivot: each solution needs it.
        pivot_row[column] = reciprocal(pivot_row[column]);
        for row in below.chunks_exact_mut(n) {
            let multiple = times(row[column], pivot_row[column]);
            row[column] = multiple;
            for (entry, pivot) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                *entry = less(*entry, times(multiple, *pivot));
            }
        }
    }
    Ok(())
}

/// Solves `A x = right` in place with what [`factor_complex`] left in `matrix` and `pivots`.
pub fn substitute_complex(matrix: &[Complex], pivots: &[usize], right: &mut [Complex]) {
    let n = pivots.len();
    debug_assert!(matrix.len() == n * n && right.len() == n);
    for (column, &best) in pivots.iter().enumerate() {
        right.swap(column, best);
    }
    for row in 1..n {
        for column in 0..row {
            right[row] = less(right[row], times(matrix[row * n + column], right[column]));
        }
    }
    for row in (0..n).rev() {
        for column in row + 1..n {
            right[row] = less(right[row], times(matrix[row * n + column], right[column]));
        }
        right[row] = times(right[row], matrix[row * n + row]);
    }
}

/// A size that is enough to compare pivots.
fn size([real, imaginary]: Complex) -> f64 {
    real.abs() + imaginary.abs()
}

fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn less(a: Complex, b: Complex) -> Complex {
    [a[0] - b[0], a[1] - b[1]]
}

/// `1 / z`, scaled so that no square overflows.
fn reciprocal(z: Complex) -> Complex {
    let scale = 1.0 / size(z);
    let [real, imaginary] = [z[0] * scale, z[1] * scale];
    let factor = scale / (real * real + imaginary * imaginary);
    [real * factor, -imaginary * factor]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn complex_systems_need_pivots() -> Result<(), Singular> {
        let matrix = [
            [0.0, 0.0],
            [2.0, 1.0],
            [1.0, -3.0],
            [1.0, 0.5],
            [1.0, 0.0],
            [0.0, 1e3],
            [4.0, 0.0],
            [-1.0, 1.0],
            [3.0, 0.0],
        ];
        let x = [[1.5, -1.0], [0.0, 2.0], [-0.25, 0.5]];
        let mut right = [[0.0; 2]; 3];
        for (row, target) in right.iter_mut().enumerate() {
            for (column, x) in x.iter().enumerate() {
                let [real, imaginary] = times(matrix[row * 3 + column], *x);
                *target = [target[0] + real, target[1] + imaginary];
            }
        }
        let (mut factors, mut pivots) = (matrix, [0; 3]);
        factor_complex(&mut factors, 3, &mut pivots)?;
        substitute_complex(&factors, &pivots, &mut right);
        for (found, expected) in right.iter().zip(x) {
            assert!(size(less(*found, expected)) < 1e-14, "{found:?}");
        }
        Ok(())
    }

    #[test]
    fn singular_complex_matrices_are_told() {
        let fails = |mut matrix: [Complex; 4]| factor_complex(&mut matrix, 2, &mut [0; 2]).err();
        let (one, i) = ([1.0, 0.0], [0.0, 1.0]);
        assert_eq!(fails([one, i, i, [-1.0, 0.0]]), Some(Singular { column: 1 }));
        assert_eq!(fails([one, one, [f64::NAN, 0.0], one]), Some(Singular { column: 0 }));
        assert_eq!(fails([one, i, i, one]), None);
    }
}
