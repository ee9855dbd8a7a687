//! Floquet multipliers.

use nalgebra::DMatrix;
use std::fmt;

/// A Floquet multiplier: what one period makes of a small disturbance. Above 1 in modulus the motion is unstable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
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

/// The eigenvalues of a matrix, the largest modulus first.
pub(crate) fn of(matrix: &DMatrix<f64>) -> Vec<Multiplier> {
    if matrix.is_empty() {
        return Vec::new();
    }
    let values = matrix.complex_eigenvalues();
    let mut multipliers: Vec<_> = values
        .iter()
        .map(|value| Multiplier {
            re: value.re,
            im: value.im,
        })
        .collect();
    multipliers.sort_by(|first, second| {
        second
            .modulus()
            .total_cmp(&first.modulus())
            .then(second.im.total_cmp(&first.im))
    });
    multipliers
}
