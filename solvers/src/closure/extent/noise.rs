//! What of the values and rates of a function is rounding, and whether they agree with each other between two samples.

use super::extremes::Node;

/// Rates this much smaller than usual ones are noise: until such a rate vanishes and comes back, the function changes by
/// no more than its rounding.
const SLOW: f64 = 1e-10;
/// Rounding of a value, relative to the largest one.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Values so many times larger than usual ones lie beside a pole and say nothing about the rounding of the others.
const FAR: f64 = 1e3;
/// By so much of its change a rate, and of itself, the mean rate between two samples may differ from that at its ends.
const SMOOTH: (f64, f64) = (0.25, 1e-3);

/// What of values and rates is rounding.
#[derive(Clone, Copy)]
pub(super) struct Noise {
    value: f64,
    rate: f64,
}

impl Noise {
    pub fn of(samples: &[Node]) -> Self {
        // Neither rests nor poles make a value or a rate usual.
        let usual = |sizes: &mut Vec<f64>| {
            sizes.retain(|one| one.is_finite());
            sizes.sort_by(f64::total_cmp);
            sizes.get(sizes.len() * 3 / 4).copied().unwrap_or(0.0)
        };
        let mut values: Vec<_> = samples.iter().map(|sample| sample.value.abs()).collect();
        let most = match usual(&mut values) {
            0.0 => f64::INFINITY,
            usual => FAR * usual,
        };
        let largest = values.iter().rev().find(|value| **value <= most);
        let value = ROUNDING * largest.copied().unwrap_or(0.0);
        let width = match samples {
            [first, .., last] => last.at - first.at,
            _ => f64::INFINITY,
        };
        let mut rates = samples.iter().map(|sample| sample.rate.abs()).collect();
        Self { value, rate: (SLOW * usual(&mut rates)).max(value / width) }
    }

    /// The sign of a rate; zero if it is noise, or none.
    pub fn sign(self, rate: f64) -> f64 {
        match rate.abs() > self.rate {
            true => rate.signum(),
            false => 0.0,
        }
    }

    /// Rounding of values as large as these.
    pub fn at(self, one: f64, other: f64) -> f64 {
        self.value.max(ROUNDING * one.abs().max(other.abs()))
    }

    /// Whether a function turns between two places without a change of sign.
    pub fn hides(self, before: Node, after: Node) -> bool {
        let rise = after.value - before.value;
        let is_known = before.is_known() && after.is_known() && rise.abs() > self.value;
        let slope = rise / (after.at - before.at);
        let mean = self.sign(slope);
        let ends = [before, after].map(|end| self.sign(end.rate));
        // The mean rate is taken somewhere; the function must turn before or after that if neither end has its sign.
        let contradicts = mean != 0.0 && !ends.contains(&mean);
        is_known && (contradicts || (ends == [mean; 2] && sags(before.rate, slope, after.rate)))
    }

    /// Whether the rise between two places is not what the rates there lead to, or there is a value at one of them only.
    pub fn is_torn(self, before: Node, after: Node) -> bool {
        if !before.is_known() || !after.is_known() {
            return before.is_known() != after.is_known();
        }
        let width = after.at - before.at;
        let missed = (after.value - before.value - 0.5 * width * (before.rate + after.rate)).abs();
        let bend = (after.rate - before.rate).abs();
        let fastest = before.rate.abs().max(after.rate.abs());
        missed > width * (SMOOTH.0 * bend + SMOOTH.1 * fastest) + self.at(before.value, after.value)
    }
}

/// Whether the cubic with these rates at its ends and this mean rate, all of one sign, turns in between: whether the
/// parabola of its rate changes its sign.
fn sags(before: f64, mean: f64, after: f64) -> bool {
    let (a, b) = (3.0 * (before + after - 2.0 * mean), 2.0 * (3.0 * mean - 2.0 * before - after));
    let vertex = -0.5 * b / a;
    vertex > 0.0 && vertex < 1.0 && (before + 0.5 * b * vertex) * mean < 0.0
}
