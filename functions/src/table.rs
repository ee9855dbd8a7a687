//! Sampled curves: cubic splines whose first and second derivatives are continuous.

mod profile;
mod smooth;
mod spline;

pub use spline::{Ends, Spline, TableFault};

use crate::fault::{Why, keep};

/// A curve and the derivatives that its pieces have.
pub const ORDERS: usize = 4;

/// Part of the range by which an argument may lie outside of it: rounding.
const SLACK: f64 = 1e-12;

/// A cubic spline that is ready to be looked up in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<'a> {
    /// It in the words of the file.
    pub what: &'a str,
    /// Abscissas, rising.
    pub knots: &'a [f64],
    /// Between two knots the factors of the powers of the distance from the left one, lowest first.
    pub pieces: &'a [[f64; 4]],
    /// Equal parts in a unit of the abscissa: as many as there are pieces where the knots are evenly apart.
    pub density: f64,
    /// The piece at the begin of each of these parts, and the last one; empty where the knots are evenly apart.
    pub starts: &'a [u32],
    /// Whether it goes on over its ends.
    pub is_periodic: bool,
}

impl Table<'_> {
    /// Where its range begins and ends.
    pub fn range(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.pieces.len()])
    }

    /// The left end of the piece that an abscissa lies in, moved by whole periods, and its factors. Outside of the range they
    /// are NaN, which is kept as a fault.
    #[inline(always)]
    pub fn at(&self, x: f64) -> (f64, [f64; 4]) {
        let (mut x, mut shift) = (x, 0.0);
        let (first, last) = self.range();
        if !(first..=last).contains(&x) {
            match self.inside(x) {
                // Rounding may have left it outside.
                Some(whole) => (x, shift) = ((x - whole).clamp(first, last), whole),
                None => return (0.0, [f64::NAN; 4]),
            }
        }
        let index = self.index(x);
        (self.knots[index] + shift, self.pieces[index])
    }

    /// The value of a derivative at an abscissa.
    pub fn value(&self, x: f64, order: u32) -> f64 {
        let (begin, factors) = self.at(x);
        let ([a, b, c, d], t) = (derivative(factors, order), x - begin);
        ((d * t + c) * t + b) * t + a
    }

    /// The piece that an abscissa in the range lies in.
    #[inline(always)]
    fn index(&self, x: f64) -> usize {
        let last = self.pieces.len() - 1;
        let part = whole((x - self.knots[0]) * self.density);
        if self.starts.is_empty() {
            return part.min(last);
        }
        let part = part.min(self.starts.len() - 2);
        let (low, high) = (self.starts[part] as usize, self.starts[part + 1] as usize);
        if high - low > 1 {
            return low + self.knots[low + 1..=high].partition_point(|knot| *knot <= x);
        }
        low + usize::from(self.knots[high] <= x && high > low)
    }

    /// How far an abscissa outside of the range has to be moved to lie inside.
    #[cold]
    #[inline(never)]
    fn inside(&self, x: f64) -> Option<f64> {
        let (first, last) = self.range();
        let length = last - first;
        if self.is_periodic && x.is_finite() {
            return Some(((x - first) / length).floor() * length);
        }
        let beyond = (first - x).max(x - last);
        if beyond <= SLACK * length {
            return Some(0.0);
        }
        if !x.is_nan() {
            keep(self.what, Why::Outside { at: x, range: (first, last) });
        }
        None
    }

    /// The pieces between two abscissas, each with its part of them, counted from its left end.
    pub fn parts(&self, low: f64, high: f64) -> impl Iterator<Item = ([f64; 4], f64, f64)> + '_ {
        let (first, last) = self.range();
        let period = if self.is_periodic { last - first } else { 0.0 };
        let begin = if self.is_periodic { ((low - first) / period).floor() * period } else { 0.0 };
        // Over more than one period it takes all values anyhow.
        let high = if self.is_periodic { high.min(low + period) } else { high };
        let rounds = if self.is_periodic && high - begin > last { 2 } else { 1 };
        (0..rounds).flat_map(move |round| {
            let shift = begin + f64::from(round) * period;
            let (low, high) = ((low - shift).max(first), (high - shift).min(last));
            let pieces = if low <= high { self.index(low)..self.index(high) + 1 } else { 0..0 };
            pieces.map(move |index| {
                let knot = self.knots[index];
                let far = if high < self.knots[index + 1] { high } else { self.knots[index + 1] };
                (self.pieces[index], low.max(knot) - knot, far - knot)
            })
        })
    }
}

/// The whole number below a number from 0 to 2³¹, or where that is whole itself perhaps the one before: for a number of that
/// size the sum has its bits at its end. A cast would look at what it may not be.
#[inline(always)]
fn whole(number: f64) -> usize {
    /// 1.5·2⁵²: a number plus this has no fraction.
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    (number - 0.5 + SHIFT).to_bits() as u32 as usize
}

/// The factors of a derivative of a cubic.
pub fn derivative([a, b, c, d]: [f64; 4], order: u32) -> [f64; 4] {
    match order {
        0 => [a, b, c, d],
        1 => [b, 2.0 * c, 3.0 * d, 0.0],
        2 => [2.0 * c, 6.0 * d, 0.0, 0.0],
        3 => [6.0 * d, 0.0, 0.0, 0.0],
        _ => [0.0; 4],
    }
}
