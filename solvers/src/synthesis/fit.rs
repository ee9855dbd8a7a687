//! Values that follow from a condition: those for which the sum of its squares over a way is least.
//!
//! The condition is a polynomial in the unknowns whose coefficients move. All but one of them, and what does not move, enter
//! linearly once that one, `r`, is given: a linear least-squares problem, of which the sum `S(r)` is a quotient of polynomials,
//! `N/D`. The values sought are minima of `S` between the bounds of `r`: roots of the polynomial `N'D - ND'`, of degree 9 for the
//! coupler point of a dwell six-bar (V. O. Polotebnov, St Petersburg 2010). In powers of a length it loses all digits; here it is
//! a sum of Chebyshev polynomials over the bounds, through values that an orthogonal factorisation gives, and its roots are
//! eigenvalues of their colleague matrix (I. J. Good, Quart. J. Math. 12 (1961) 61).

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use crate::shape::{Solved, Term};

/// Roots that are further than this part of the bounds from the real line are none: a double one is found to the root of rounding.
const REAL: f64 = 1e-6;
/// Steps by which a root is improved.
const STEPS: usize = 8;

/// A condition at places of a way.
pub struct Fit<'a> {
    solved: &'a Solved,
    /// Bounds of the unknowns.
    bounds: &'a [(f64, f64)],
    /// Coefficients of the terms that move, and 1, as an orthogonal factorisation leaves them of all places.
    factor: DMatrix<f64>,
    /// Coefficients of all terms at the first place: of those that do not move.
    first: Vec<f64>,
    /// The unknowns that are solved for together.
    linear: Vec<usize>,
    /// Number of places.
    places: usize,
}

/// The linear unknowns, and what does not move, for a value of the one that is scanned.
struct There {
    values: DVector<f64>,
    /// Half the slope of the sum of squares.
    slope: f64,
    /// The sum of squares.
    sum: f64,
    /// The determinant of the linear problem.
    determinant: f64,
}

impl<'a> Fit<'a> {
    /// Of the coefficients of all terms at each place; none if one of them is no number.
    pub fn of(
        solved: &'a Solved,
        bounds: &'a [(f64, f64)],
        coefficients: &[Vec<f64>],
    ) -> Option<Self> {
        let moving: Vec<usize> =
            (0..solved.terms.len()).filter(|term| solved.terms[*term].moves).collect();
        let columns = moving.len() + 1;
        let rows = coefficients.len().max(columns);
        let entry = |row: usize, column: usize| match coefficients.get(row) {
            Some(there) => moving.get(column).map_or(1.0, |term| there[*term]),
            None => 0.0,
        };
        let all = DMatrix::from_fn(rows, columns, entry);
        let first = coefficients.first()?.clone();
        if !(all.iter().chain(&first).all(|one| one.is_finite())) {
            return None;
        }
        let is_linear = |unknown: &usize| {
            let mut terms = solved.terms.iter().filter(|term| term.moves);
            Some(*unknown) != solved.scanned && terms.any(|term| term.powers[*unknown] > 0)
        };
        let linear = (0..solved.unknowns.len()).filter(is_linear).collect();
        let places = coefficients.len();
        Some(Self { solved, bounds, factor: all.qr().r(), first, linear, places })
    }

    /// The terms that move, in the order of the columns of the factor.
    fn moving(&self) -> impl Iterator<Item = &'a Term> + use<'a> {
        self.solved.terms.iter().filter(|term| term.moves)
    }

    /// Values of the unknowns for which the sum of squares is least, the best first; within their bounds.
    pub fn candidates(&self) -> Vec<Vec<f64>> {
        let mut all: Vec<(f64, Vec<f64>)> = Vec::new();
        for scanned in self.minima() {
            if let Some(there) = self.there(scanned) {
                all.push((there.sum, self.unknowns(scanned, &there)));
            }
        }
        all.retain(|one| one.1.iter().all(|value| value.is_finite()));
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.into_iter().map(|one| one.1).collect()
    }

    /// Where the sum of squares is least: between the bounds of what is scanned, or at them.
    fn minima(&self) -> Vec<f64> {
        let Some(scanned) = self.solved.scanned else { return vec![0.0] };
        let (low, high) = self.bounds[scanned];
        let slope = |at: f64| self.there(at).map_or(0.0, |there| there.slope);
        let mut minima: Vec<f64> =
            self.stationary().into_iter().filter(|root| root.1 > 0.0).map(|root| root.0).collect();
        minima.extend((slope(low) > 0.0).then_some(low));
        minima.extend((slope(high) < 0.0).then_some(high));
        minima
    }

    /// Values of what is scanned for which the slope of the sum of squares is zero, each with the slope of that.
    pub fn stationary(&self) -> Vec<(f64, f64)> {
        let Some(scanned) = self.solved.scanned else { return Vec::new() };
        let (low, high) = self.bounds[scanned];
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let series = chebyshev(self.degree(), &|place| {
            let there = self.there(middle + half * place)?;
            Some(there.slope * there.determinant * there.determinant)
        });
        let roots = series.map(|series| roots(&series)).unwrap_or_default();
        let improved =
            roots.into_iter().filter_map(|root| self.improved(middle + half * root, half));
        let mut all: Vec<(f64, f64)> =
            improved.filter(|(root, _)| (low..=high).contains(root)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by(|a, b| (a.0 - b.0).abs() <= 1e-12 * half);
        all
    }

    /// The degree of the polynomial whose roots are sought.
    fn degree(&self) -> usize {
        let power = |term: &Term| self.solved.scanned.map_or(0, |scanned| term.powers[scanned]);
        let power = self.moving().map(power).max().unwrap_or(0) as usize;
        (4 * power * self.linear.len() + 2 * power).saturating_sub(1)
    }

    /// A root to the last digits that the slope leaves, and the slope there of that.
    fn improved(&self, root: f64, half: f64) -> Option<(f64, f64)> {
        let (mut at, beside) = (root, 1e-6 * half);
        let slope = |at: f64| self.there(at).map(|there| there.slope);
        let rise = |at: f64| Some((slope(at + beside)? - slope(at - beside)?) / (2.0 * beside));
        let mut here = slope(at)?;
        for _ in 0..STEPS {
            let next = at - here / rise(at)?;
            match slope(next) {
                Some(there) if there.abs() < here.abs() => (at, here) = (next, there),
                _ => break,
            }
        }
        Some((at, rise(at)?))
    }

    /// The linear problem for a value of what is scanned; none where it has no solution.
    fn there(&self, scanned: f64) -> Option<There> {
        let rows = self.factor.nrows();
        let constant = usize::from(self.solved.free.is_some());
        let mut left = DMatrix::zeros(rows, self.linear.len() + constant);
        let (mut right, mut slope) = (DVector::zeros(rows), DVector::zeros(rows));
        let mut slopes = DMatrix::zeros(rows, left.ncols());
        for (column, term) in self.moving().enumerate() {
            let power = self.solved.scanned.map_or(0, |one| term.powers[one]) as i32;
            let factor = scanned.powi(power);
            let rise = if power > 0 { f64::from(power) * scanned.powi(power - 1) } else { 0.0 };
            let own = self.factor.column(column);
            match self.linear.iter().position(|unknown| term.powers[*unknown] > 0) {
                Some(unknown) => {
                    left.column_mut(unknown).axpy(factor, &own, 1.0);
                    slopes.column_mut(unknown).axpy(rise, &own, 1.0);
                }
                None => {
                    right.axpy(-factor, &own, 1.0);
                    slope.axpy(rise, &own, 1.0);
                }
            }
        }
        let ones = self.factor.column(self.factor.ncols() - 1);
        if constant > 0 {
            left.column_mut(self.linear.len()).copy_from(&ones);
        } else {
            // What does not move depends on no unknown then.
            right.axpy(-self.still(&vec![0.0; self.bounds.len()]), &ones, 1.0);
        }
        let solver = left.clone().qr();
        let mut image = right.clone();
        solver.q_tr_mul(&mut image);
        let triangle = solver.r();
        let values = triangle.solve_upper_triangular(&image.rows(0, left.ncols()).into_owned())?;
        let residual = &left * &values - &right;
        let moved = &slopes * &values + slope;
        let determinant: f64 = triangle.diagonal().iter().map(|one| one * one).product();
        let sum = residual.norm_squared();
        let there = There { slope: residual.dot(&moved), sum, determinant, values };
        there.values.iter().all(|one| one.is_finite()).then_some(there)
    }

    /// The terms that do not move.
    fn still(&self, unknowns: &[f64]) -> f64 {
        let terms = self.solved.terms.iter().zip(&self.first).filter(|one| !one.0.moves);
        terms.map(|(term, coefficient)| coefficient * power(term, unknowns)).sum()
    }

    /// All unknowns, within their bounds.
    fn unknowns(&self, scanned: f64, there: &There) -> Vec<f64> {
        let mut unknowns = vec![0.0; self.bounds.len()];
        let bounded = |unknown: usize, value: f64| {
            let (low, high) = self.bounds[unknown];
            value.clamp(low, high)
        };
        if let Some(one) = self.solved.scanned {
            unknowns[one] = scanned;
        }
        for (place, unknown) in self.linear.iter().enumerate() {
            unknowns[*unknown] = bounded(*unknown, there.values[place]);
        }
        if let Some(free) = self.solved.free {
            // What does not move has to make up for the mean of what moves.
            let moving = self.moving().map(|term| power(term, &unknowns));
            let column = DVector::from_iterator(self.factor.ncols(), moving.chain([0.0]));
            let ones = self.factor.column(self.factor.ncols() - 1);
            let wanted = -(&self.factor * column).dot(&ones) / self.places as f64;
            unknowns[free] = bounded(free, self.freed(free, wanted, &unknowns));
        }
        unknowns
    }

    /// The value of the free unknown for which what does not move is what it has to be; zero where there is none.
    fn freed(&self, free: usize, wanted: f64, unknowns: &[f64]) -> f64 {
        let mut unit = unknowns.to_vec();
        unit[free] = 0.0;
        let rest = self.still(&unit);
        unit[free] = 1.0;
        let scale = self.still(&unit) - rest;
        let own = self.solved.terms.iter().map(|term| term.powers[free]).max().unwrap_or(1);
        let power = (wanted - rest) / scale;
        let root = power.abs().powf(1.0 / f64::from(own));
        let is_odd = own % 2 == 1;
        match power < 0.0 {
            true if is_odd => -root,
            true => 0.0,
            false if !is_odd && self.bounds[free].1 <= 0.0 => -root,
            false => root,
        }
    }
}

/// The product of the powers of a term.
fn power(term: &Term, unknowns: &[f64]) -> f64 {
    let powers = unknowns.iter().zip(term.powers);
    powers.map(|(value, power)| value.powi(*power as i32)).product()
}

/// The coefficients of the Chebyshev polynomials up to a degree of what is a polynomial of that degree between -1 and 1.
fn chebyshev(degree: usize, of: &dyn Fn(f64) -> Option<f64>) -> Option<Vec<f64>> {
    let count = degree + 1;
    let angle = |k: usize| PI * (k as f64 + 0.5) / count as f64;
    let values: Option<Vec<f64>> = (0..count).map(|k| of(angle(k).cos())).collect();
    let values = values?;
    let coefficient = |order: usize| {
        let terms =
            values.iter().enumerate().map(|(k, value)| value * (order as f64 * angle(k)).cos());
        terms.sum::<f64>() * if order == 0 { 1.0 } else { 2.0 } / count as f64
    };
    Some((0..count).map(coefficient).collect())
}

/// The real roots between -1 and 1 of a sum of Chebyshev polynomials.
fn roots(series: &[f64]) -> Vec<f64> {
    let largest = series.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    // Leading coefficients that are rounding are none: a root at infinity is no root.
    let Some(degree) = series.iter().rposition(|one| one.abs() > 1e-14 * largest) else {
        return Vec::new();
    };
    if degree == 0 || series.iter().any(|one| !one.is_finite()) {
        return Vec::new();
    }
    let colleague = DMatrix::from_fn(degree, degree, |row, column| {
        let neighbours = match (row, column) {
            (0, 1) => 1.0,
            _ if row + 1 == column || column + 1 == row => 0.5,
            _ => 0.0,
        };
        match (row + 1 == degree, degree) {
            (true, 1) => -series[0] / series[1],
            (true, _) => neighbours - series[column] / (2.0 * series[degree]),
            _ => neighbours,
        }
    });
    let all = colleague.complex_eigenvalues();
    let is_real =
        |one: &&nalgebra::Complex<f64>| one.im.abs() <= REAL && one.re.abs() <= 1.0 + REAL;
    all.iter().filter(is_real).map(|one| one.re.clamp(-1.0, 1.0)).collect()
}

#[cfg(test)]
mod tests;
