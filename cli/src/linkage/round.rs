//! Positions at round numbers.

use crate::show::number;
use crate::show::unit;
use assur::shape::Quantity;

/// Steps of an angle in degrees that divide a turn.
const DEGREES: [f64; 13] =
    [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 360.0];
/// Most positions that are made.
const MOST: usize = 100_000;

/// Positions between two at round numbers of the unit, both ends included, SI units. The step is the coarsest that
/// gives at least so many parts.
pub fn positions(quantity: &Quantity, from: f64, to: f64, parts: usize) -> Vec<f64> {
    let (first, last) = (unit::stated(from, quantity.factor), unit::stated(to, quantity.factor));
    let width = (last - first).abs();
    if !(width.is_finite() && width > 0.0) {
        return vec![from];
    }
    let step = step(width / parts as f64, quantity.unit == "deg");
    let (low, high) = (first.min(last), first.max(last));
    // What lies within rounding of an end is the end.
    let slack = 1e-6 * step;
    let index = |value: f64| (value / step).ceil() as i64;
    let between = (index(low + slack)..index(high - slack)).take(MOST);
    let mut list: Vec<f64> = between
        .map(|index| unit::si(number::rounded(index as f64 * step, 12), quantity.factor))
        .collect();
    if first > last {
        list.reverse();
    }
    list.insert(0, from);
    list.push(to);
    list
}

/// The coarsest round step that is not above the one that is wanted.
fn step(wanted: f64, degrees: bool) -> f64 {
    if degrees && wanted >= 1.0 {
        let coarsest = DEGREES.into_iter().rev().find(|step| *step <= wanted);
        let turns = 360.0 * (wanted / 360.0).floor();
        return coarsest.unwrap_or(1.0).max(turns);
    }
    // Rounding must not lose a power of ten.
    let power = 10f64.powf((wanted * (1.0 + 1e-12)).log10().floor());
    let factor = [5.0, 2.0, 1.0].into_iter().find(|factor| factor * power <= wanted * (1.0 + 1e-9));
    factor.unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::values::TIME;

    #[track_caller]
    fn check(unit: &'static str, ends: (f64, f64), parts: usize, expected: &[f64]) {
        let quantity = Quantity { unit, ..TIME };
        let found = positions(&quantity, ends.0, ends.1, parts);
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }

    #[test]
    fn angles_divide_a_turn() {
        let turn = [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0];
        check("deg", (0.0, 360.0), 8, &turn);
        check("deg", (60.0, 90.0), 6, &[60.0, 65.0, 70.0, 75.0, 80.0, 85.0, 90.0]);
    }

    #[test]
    fn ends_that_are_not_round_are_kept() {
        check("s", (0.3, 3.3), 3, &[0.3, 1.0, 2.0, 3.0, 3.3]);
        check("s", (0.0, 0.1), 1, &[0.0, 0.1]);
    }

    #[test]
    fn a_way_may_run_backwards_or_be_no_way() {
        check("s", (3.0, 0.0), 3, &[3.0, 2.0, 1.0, 0.0]);
        check("s", (3.0, 3.0), 3, &[3.0]);
        check("s", (3.0, f64::NAN), 3, &[3.0]);
    }
}
