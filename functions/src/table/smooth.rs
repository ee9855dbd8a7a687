//! Natural and closed splines through points, or near points that are known within an error.
//!
//! C. H. Reinsch, "Smoothing by spline functions", Numerische Mathematik 10 (1967): of all curves whose squares of the
//! distances from the points come to what the error lets expect, that with the least integral of its squared second derivative.
//! Notation of P. J. Green, B. W. Silverman, "Nonparametric Regression and Generalized Linear Models" (1994), section 2.3:
//! `(R + α·Qᵀ·Q)·γ = Qᵀ·y`, `g = y - α·Q·γ`, with the second derivatives `γ` and the ordinates `g` at the knots.

use super::profile::Profile;
use crate::root::root;

/// Steps between knots, and which knots have a second derivative that is not zero by itself.
pub struct Smoothing<'a> {
    /// Distance of each knot from the next one.
    pub steps: &'a [f64],
    /// Whether the last knot is the first one again, one period later.
    pub is_closed: bool,
}

impl Smoothing<'_> {
    /// Knots that have an ordinate of their own.
    fn knots(&self) -> usize {
        self.steps.len() + usize::from(!self.is_closed)
    }

    /// The unknown of a knot, if it has one; before the first knot of a closed curve comes the last one.
    fn unknown(&self, knot: usize) -> Option<usize> {
        match self.is_closed {
            true => Some(knot % self.knots()),
            false => (1..self.knots() - 1).contains(&knot).then(|| knot - 1),
        }
    }

    /// A knot with those before and behind it, and the steps to them.
    fn around(&self, knot: usize) -> ([usize; 3], [f64; 2]) {
        let before = if knot == 0 { self.knots() - 1 } else { knot - 1 };
        ([before, knot, knot + 1], [self.steps[before], self.steps[knot]])
    }

    /// Knots with an unknown.
    fn inner(&self) -> std::ops::Range<usize> {
        if self.is_closed { 0..self.knots() } else { 1..self.knots() - 1 }
    }

    /// The column of `Q` of a knot: what it takes of the ordinates around.
    fn column(&self, knot: usize) -> [(usize, f64); 3] {
        let ([before, here, behind], [left, right]) = self.around(knot);
        [
            (before, 1.0 / left),
            (here, -1.0 / left - 1.0 / right),
            (behind % self.knots(), 1.0 / right),
        ]
    }

    /// Second derivatives and ordinates at the knots.
    fn solve(&self, y: &[f64], alpha: f64) -> (Vec<f64>, Vec<f64>) {
        let knots = self.knots();
        let mut matrix = Profile::new(self.inner().len());
        let mut right = vec![0.0; self.inner().len()];
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); knots];
        for (unknown, knot) in self.inner().enumerate() {
            let ([_, _, behind], [left, step]) = self.around(knot);
            matrix.add(unknown, unknown, (left + step) / 3.0);
            match self.unknown(behind) {
                Some(next) if next == unknown => matrix.add(unknown, next, step / 3.0),
                Some(next) => matrix.add(unknown, next, step / 6.0),
                None => {}
            }
            for (row, factor) in self.column(knot) {
                right[unknown] += factor * y[row];
                rows[row].push((unknown, factor));
            }
        }
        for row in &rows {
            for (at, (i, a)) in row.iter().enumerate() {
                for (other, (j, b)) in row[..=at].iter().enumerate() {
                    // Mirror images are one entry, on the diagonal two products.
                    let twice = if other < at && i == j { 2.0 } else { 1.0 };
                    matrix.add(*i, *j, twice * alpha * a * b);
                }
            }
        }
        let gamma = matrix.solve(right);
        let mut moments = vec![0.0; knots];
        for (unknown, knot) in self.inner().enumerate() {
            moments[knot] = gamma[unknown];
        }
        let moved = |row: &Vec<(usize, f64)>| row.iter().map(|(j, q)| q * gamma[*j]).sum::<f64>();
        let ordinates = y.iter().zip(&rows).map(|(y, row)| y - alpha * moved(row)).collect();
        (moments, ordinates)
    }

    /// Second derivatives of the curve through points.
    pub fn through(&self, y: &[f64]) -> Vec<f64> {
        self.solve(y, 0.0).0
    }

    /// Second derivatives and ordinates of the curve near points whose ordinates have a standard error.
    pub fn near(&self, y: &[f64], error: f64) -> (Vec<f64>, Vec<f64>) {
        /// Powers of ten of the weight of the curvature, over the cube of the range: from next to nothing to a straight line.
        const POWERS: (f64, f64) = (-20.0, 6.0);
        let length: f64 = self.steps.iter().sum();
        let alpha =
            |share: f64| length.powi(3) * 10f64.powf(POWERS.0 + share * (POWERS.1 - POWERS.0));
        let expected = self.knots() as f64 * error * error;
        let excess = |share: f64| {
            let squares: f64 = self
                .solve(y, alpha(share))
                .1
                .iter()
                .zip(y)
                .map(|(smooth, y)| (smooth - y).powi(2))
                .sum();
            squares / expected - 1.0
        };
        // A straight line, or a level one, may be near enough.
        let share = if excess(1.0) <= 0.0 { 1.0 } else { root(&mut |share| excess(share)).place() };
        self.solve(y, alpha(share))
    }
}
