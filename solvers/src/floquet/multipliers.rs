//! Floquet multipliers.

use nalgebra::DMatrix;
use nalgebra::linalg::balancing;
use std::fmt;

/// A Floquet multiplier: what one period makes of a small disturbance. Above 1 in modulus the motion is unstable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
    /// Its estimated error, from that of the matrix. Where two are almost the same it is about the square root of that.
    pub error: f64,
}

impl Multiplier {
    /// Its modulus.
    pub fn modulus(&self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Its distance from 1.
    pub fn distance(&self) -> f64 {
        (self.re - 1.0).hypot(self.im)
    }
}

impl fmt::Display for Multiplier {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:.6}{:+.6}i", self.re, self.im)
    }
}

/// The eigenvalues of a matrix, the largest modulus first. Another computation of the matrix, where there is one, and an
/// error relative to its norm say how well they are known.
pub(crate) fn of(
    matrix: &DMatrix<f64>,
    other: Option<&DMatrix<f64>>,
    relative: f64,
) -> Vec<Multiplier> {
    let mut all = eigenvalues(matrix);
    if !matrix.iter().all(|entry| entry.is_finite()) || matrix.is_empty() {
        return all;
    }
    // An error of the size of the norm means the same for all states only where they are balanced.
    let mut balanced = matrix.clone();
    let sizes = balancing::balance_parlett_reinsch(&mut balanced);
    let size = relative * balanced.norm();
    let error = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        let difference = other.map_or(0.0, |other| matrix[(row, column)] - other[(row, column)]);
        // In no direction that is special.
        let sign = if (row + 2 * column) % 3 == 0 { -1.0 } else { 1.0 };
        difference * sizes[column] / sizes[row] + sign * size
    });
    for disturbed in [&balanced + &error, &balanced - &error] {
        let mut left = eigenvalues(&disturbed);
        for one in &mut all {
            let off = |other: &Multiplier| (one.re - other.re).hypot(one.im - other.im);
            let nearest = (0..left.len()).min_by(|a, b| off(&left[*a]).total_cmp(&off(&left[*b])));
            if let Some(nearest) = nearest {
                one.error = one.error.max(off(&left.swap_remove(nearest)));
            }
        }
    }
    all
}

/// The eigenvalues of a matrix, the largest modulus first.
fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Multiplier> {
    if matrix.is_empty() {
        return Vec::new();
    }
    let values = matrix.complex_eigenvalues();
    let mut multipliers: Vec<_> =
        values.iter().map(|value| Multiplier { re: value.re, im: value.im, error: 0.0 }).collect();
    multipliers.sort_by(|first, second| {
        second.modulus().total_cmp(&first.modulus()).then(second.im.total_cmp(&first.im))
    });
    multipliers
}
