//! The equations of one group at one trial position, with their rows and columns scaled.

use crate::dense::Lu;

/// Smallest scale of an equation, as a part of the largest.
const SMALLEST_ROW: f64 = 1e-3;
/// Residual that rounding may leave, as a part of the largest entry.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Residual `F` and Jacobian `J` of a group, its steps, and the memory for both.
///
/// An unknown counts in units of a radian, or of the displacement that moves the equations as far as a radian of the
/// longest link does.
pub(super) struct Scaled {
    size: usize,
    residual: Vec<f64>,
    jacobian: Vec<f64>,
    /// Lengths of the columns of the Jacobian.
    columns: Vec<f64>,
    /// Units of the unknowns.
    units: Vec<f64>,
    /// Scales of the equations.
    rows: Vec<f64>,
    /// Largest entry of the Jacobian with its columns scaled.
    largest: f64,
    step: Vec<f64>,
    matrix: Vec<f64>,
    pivots: Vec<usize>,
}

impl Scaled {
    /// Room for groups of up to this size.
    pub fn new(size: usize) -> Self {
        let zeros = || vec![0.0; size];
        Self {
            size,
            residual: zeros(),
            jacobian: vec![0.0; size * size],
            columns: zeros(),
            units: zeros(),
            rows: zeros(),
            largest: 0.0,
            step: zeros(),
            matrix: vec![0.0; size * size],
            pivots: vec![0; size],
        }
    }

    /// Takes the equations over. Of each unknown it must be known whether it is an angle, and its value.
    pub fn set(
        &mut self,
        residual: impl Iterator<Item = f64>,
        jacobian: impl Iterator<Item = f64>,
        unknowns: impl ExactSizeIterator<Item = (bool, f64)> + Clone,
    ) {
        let n = unknowns.len();
        self.size = n;
        for (kept, value) in self.residual[..n].iter_mut().zip(residual) {
            *kept = value;
        }
        for (kept, value) in self.jacobian[..n * n].iter_mut().zip(jacobian) {
            *kept = value;
        }
        for j in 0..n {
            let squares = (0..n).map(|i| self.jacobian[i * n + j].powi(2));
            self.columns[j] = squares.sum::<f64>().sqrt();
        }
        self.choose_units(unknowns);
        self.choose_rows();
    }

    fn choose_units(&mut self, unknowns: impl Iterator<Item = (bool, f64)> + Clone) {
        let mut reach: f64 = 0.0;
        for ((is_angle, value), length) in unknowns.clone().zip(&self.columns) {
            reach = reach.max(length * if is_angle { 1.0 } else { value.abs() });
        }
        for (j, (is_angle, _)) in unknowns.enumerate() {
            let unit = reach / self.columns[j];
            let scaled = !is_angle && unit.is_finite() && unit > 0.0;
            self.units[j] = if scaled { unit } else { 1.0 };
        }
    }

    fn choose_rows(&mut self) {
        let n = self.size;
        self.largest = 0.0;
        for i in 0..n {
            let row = &self.jacobian[i * n..(i + 1) * n];
            let entries = row.iter().zip(&self.units).map(|(entry, unit)| entry * unit);
            self.rows[i] = entries.fold(0.0, |most, entry| most.max(entry.abs()));
            self.largest = self.largest.max(self.rows[i]);
        }
        let least = (SMALLEST_ROW * self.largest).max(f64::MIN_POSITIVE);
        for row in &mut self.rows[..n] {
            *row = row.max(least);
        }
    }

    /// Whether all values are finite.
    pub fn is_finite(&self) -> bool {
        let n = self.size;
        let mut all = self.residual[..n].iter().chain(&self.jacobian[..n * n]);
        all.all(|value| value.is_finite())
    }

    /// Size of the equilibrated residual.
    pub fn merit(&self) -> f64 {
        let scaled = self.residual[..self.size].iter().zip(&self.rows);
        scaled.map(|(f, row)| (f / row).powi(2)).sum::<f64>().sqrt()
    }

    /// Whether the residual is down to rounding.
    pub fn is_closed(&self) -> bool {
        self.largest_residual() <= ROUNDING * self.largest
    }

    /// Largest residual, in the unit of its equation.
    pub fn largest_residual(&self) -> f64 {
        let all = self.residual[..self.size].iter();
        all.fold(0.0, |most, value| if most >= value.abs() { most } else { value.abs() })
    }

    /// Lengths of the columns of the Jacobian.
    pub fn columns(&self) -> &[f64] {
        &self.columns[..self.size]
    }

    /// Units of the unknowns.
    pub fn units(&self) -> &[f64] {
        &self.units[..self.size]
    }

    /// The last step, in the units of the unknowns themselves.
    pub fn step(&self) -> &[f64] {
        &self.step[..self.size]
    }

    /// Finds the Newton step and gives its length, the largest part of it in scaled units. None if there is none.
    pub fn newton_step(&mut self) -> Option<f64> {
        let n = self.size;
        for i in 0..n {
            for j in 0..n {
                self.matrix[i * n + j] = self.entry(i, j);
            }
            self.step[i] = -self.residual[i] / self.rows[i];
        }
        self.solve()
    }

    /// Finds the step that is least in the sense of Levenberg and Marquardt, and gives its length.
    pub fn damped_step(&mut self, damping: f64) -> Option<f64> {
        let n = self.size;
        for i in 0..n {
            for j in 0..n {
                let products = (0..n).map(|k| self.entry(k, i) * self.entry(k, j));
                self.matrix[i * n + j] = products.sum::<f64>() + if i == j { damping } else { 0.0 };
            }
            let products = (0..n).map(|k| self.entry(k, i) * self.residual[k] / self.rows[k]);
            self.step[i] = -products.sum::<f64>();
        }
        self.solve()
    }

    /// Determinant of the Jacobian over the product of the lengths of its columns.
    pub fn sine(&mut self) -> f64 {
        let n = self.size;
        for i in 0..n {
            for j in 0..n {
                self.matrix[i * n + j] = self.jacobian[i * n + j] / self.columns[j];
            }
        }
        if Lu::factor(&mut self.matrix[..n * n], n, &mut self.pivots[..n]).is_err() {
            return if self.is_finite() { 0.0 } else { f64::NAN };
        }
        (0..n)
            .map(|k| {
                let pivot = self.matrix[k * n + k];
                if self.pivots[k] == k { pivot } else { -pivot }
            })
            .product()
    }

    /// Entry of the scaled Jacobian.
    fn entry(&self, i: usize, j: usize) -> f64 {
        self.jacobian[i * self.size + j] * self.units[j] / self.rows[i]
    }

    /// Solves for the step in place.
    fn solve(&mut self) -> Option<f64> {
        let n = self.size;
        Lu::factor(&mut self.matrix[..n * n], n, &mut self.pivots[..n]).ok()?;
        Lu::substitute(&self.matrix[..n * n], &self.pivots[..n], &mut self.step[..n]);
        let length = self.step[..n].iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        for (part, unit) in self.step.iter_mut().zip(&self.units) {
            *part *= unit;
        }
        length.is_finite().then_some(length)
    }
}
