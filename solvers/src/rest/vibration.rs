//! Small disturbances of a position of rest.

use super::place::Place;
use crate::floquet::multipliers;
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// How well the slopes are known, over the size of their balanced matrix.
const KNOWN: f64 = 8.0 * f64::EPSILON;
/// How far the position is moved at least, over its size, to see what rounding makes of its slopes.
const ROUNDED: f64 = 3.0 * f64::EPSILON;
/// How far an eigenvalue is moved, over the size of the matrix, so that the equations for its vector have a solution.
const MOVED: f64 = 1e-11;
/// Repetitions that find a vector.
const TURNS: usize = 4;
/// Eigenvalues nearer to each other, over the size of the matrix, have vectors that are made to differ.
const ALIKE: f64 = 1e-7;

/// How a small disturbance moves: as `e^{rate t} cos(angular t)`, in a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibration {
    /// How fast it grows, 1/s; less than zero where it dies out.
    pub rate: f64,
    /// Its angular frequency, rad/s; zero where it does not vibrate.
    pub angular: f64,
    /// The estimated error of both.
    pub error: f64,
    /// For each component of the state its complex amplitude, SI units. That which is largest over its scale is real, and as
    /// large as its scale.
    pub shape: Vec<(f64, f64)>,
}

impl Vibration {
    /// Cycles per second, as they are seen: of the damped vibration.
    pub fn frequency(&self) -> f64 {
        self.angular / TAU
    }

    /// The share of critical damping: 0 without losses, 1 and more where it does not vibrate, less than zero where it grows.
    pub fn damping(&self) -> f64 {
        match self.rate.hypot(self.angular) {
            0.0 => 0.0,
            size => -self.rate / size,
        }
    }

    /// Whether it vibrates, beyond its error.
    pub fn vibrates(&self) -> bool {
        self.angular > self.error
    }

    /// Whether it grows, beyond its error.
    pub fn grows(&self) -> bool {
        self.rate > self.error
    }

    /// Whether it dies out, beyond its error.
    pub fn dies_out(&self) -> bool {
        self.rate < -self.error
    }
}

/// All of them at a position that is known up to errors.
pub fn all(place: &Place<'_>, state: &[f64], errors: &[f64]) -> Vec<Vibration> {
    let allowed = place.allowed(state);
    let matrix = reduced(place, &allowed, state);
    if matrix.is_empty() || matrix.iter().any(|value| !value.is_finite()) {
        return Vec::new();
    }
    let asides = [1.0, -1.0].map(|sign| {
        let off = |(y, error): (&f64, &f64)| y + sign * (error + ROUNDED * y.abs());
        let aside: Vec<f64> = state.iter().zip(errors).map(off).collect();
        reduced(place, &allowed, &aside)
    });
    let [a, b] = &asides;
    let other = if (a - &matrix).norm() > (b - &matrix).norm() { a } else { b };
    let values = multipliers(&matrix, Some(other), KNOWN);
    let values = values.iter().filter(|value| value.im >= 0.0);
    let mut found: Vec<(Complex<f64>, DVector<Complex<f64>>)> = Vec::new();
    let mut list = Vec::new();
    for value in values {
        let eigenvalue = Complex::new(value.re, value.im);
        let vector = eigenvector(&matrix, eigenvalue, &found);
        let shape =
            scaled(&allowed.map(Complex::from) * &vector, &place.sizes(), place.coordinates);
        let (rate, angular, error) = (value.re, value.im, value.error);
        list.push(Vibration { rate, angular, error, shape });
        found.push((eigenvalue, vector));
    }
    list.sort_by(|a, b| {
        b.vibrates()
            .cmp(&a.vibrates())
            .then(a.angular.total_cmp(&b.angular))
            .then(b.rate.total_cmp(&a.rate))
    });
    list
}

/// `∂f/∂y` on what is allowed of the state.
fn reduced(place: &Place<'_>, allowed: &DMatrix<f64>, state: &[f64]) -> DMatrix<f64> {
    let scales = place.sizes();
    let over = |columns: &DMatrix<f64>| {
        DMatrix::from_fn(columns.nrows(), columns.ncols(), |row, column| {
            columns[(row, column)] / scales[row]
        })
    };
    // The columns over the scales of coordinates: orthonormal, and of speeds so up to a factor.
    let columns = over(allowed);
    let sizes = DVector::from_iterator(
        columns.ncols(),
        columns.column_iter().map(|one| one.norm_squared()),
    );
    let products = columns.transpose() * over(&(place.jacobian(state) * allowed));
    DMatrix::from_fn(products.nrows(), products.ncols(), |row, column| {
        products[(row, column)] / sizes[row]
    })
}

/// The vector of an eigenvalue, by inverse iteration; another one than those of eigenvalues next to it.
fn eigenvector(
    matrix: &DMatrix<f64>,
    value: Complex<f64>,
    others: &[(Complex<f64>, DVector<Complex<f64>>)],
) -> DVector<Complex<f64>> {
    let (count, size) = (matrix.nrows(), matrix.norm().max(f64::MIN_POSITIVE));
    let moved = value + Complex::new(MOVED * size, 0.0);
    let shifted = matrix.map(Complex::from) - DMatrix::from_diagonal_element(count, count, moved);
    let factors = shifted.lu();
    let begin = |index: usize| {
        Complex::new(1.0 + (index as f64 * 0.618).fract(), (index as f64 * 0.414).fract())
    };
    let mut vector = DVector::from_fn(count, |index, _| begin(index));
    for _ in 0..TURNS {
        let near = others.iter().filter(|(other, _)| (other - value).norm() <= ALIKE * size);
        for (_, other) in near {
            let share = other.dotc(&vector);
            vector.axpy(-share, other, Complex::new(1.0, 0.0));
        }
        vector /= Complex::from(vector.norm().max(f64::MIN_POSITIVE));
        if let Some(next) = factors.solve(&vector) {
            vector = next;
        }
        vector /= Complex::from(vector.norm().max(f64::MIN_POSITIVE));
    }
    vector
}

/// A shape whose largest coordinate or state, over its size, is as large as that.
fn scaled(vector: DVector<Complex<f64>>, sizes: &[f64], coordinates: usize) -> Vec<(f64, f64)> {
    let over = |index: usize| vector[index].norm() / sizes[index];
    let places = (0..coordinates).chain(2 * coordinates..vector.len());
    let largest = places.max_by(|a, b| over(*a).total_cmp(&over(*b)));
    let unit = largest.map_or(Complex::ZERO, |index| vector[index] / sizes[index]);
    let share = if unit.norm() > 0.0 { unit.inv() } else { Complex::ZERO };
    vector.iter().map(|value| value * share).map(|value| (value.re, value.im)).collect()
}
