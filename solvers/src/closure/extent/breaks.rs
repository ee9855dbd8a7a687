//! Where a function of one variable jumps, passes through infinity, or ceases to have a value.
//!
//! What the function tends to on one side is told from values at distances that shrink by the same factor each time: their
//! differences shrink towards a limit, and do not towards a pole, were it that of a logarithm.

use super::extremes::{Node, Search};
use crate::closure::error::ClosureError;

/// Distances from a break, in parts of the range, at which it is looked what the function tends to.
const DISTANCES: [f64; 3] = [NEAREST, 1e2 * NEAREST, 1e4 * NEAREST];
/// The smallest of them.
pub(super) const NEAREST: f64 = 1e-10;
/// Differences that shrink by less than this do not lead to a limit.
const SHRINKING: f64 = 0.5;
/// Differences smaller than this part of the values are rounding.
const NOISE: f64 = 1e-9;

/// A place where an output jumps, goes beyond all bounds, or ceases to have a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Break {
    /// The independent variable.
    pub at: f64,
    /// What the output tends to below: infinite at a pole, NaN where there is no value.
    pub before: f64,
    /// What it tends to above.
    pub after: f64,
}

impl Break {
    /// Whether the output goes beyond all bounds on either side.
    pub fn is_unbounded(&self) -> bool {
        self.before.is_infinite() || self.after.is_infinite()
    }
}

impl<F: FnMut(f64) -> Result<Node, ClosureError>> Search<F> {
    /// The break between two places near to each other whose values contradict their rates; none if there is no gap.
    pub(super) fn break_between(
        &mut self,
        before: Node,
        after: Node,
    ) -> Result<Option<Break>, ClosureError> {
        let (below, above) = self.narrow(before, after)?;
        let found = Break {
            at: if above.is_known() { above.at } else { below.at },
            before: self.limit_towards(below.at, below.value, -1.0)?,
            after: self.limit_towards(above.at, above.value, 1.0)?,
        };
        let gap = (found.after - found.before).abs();
        let noise = 4.0 * self.noise.at(found.before, found.after);
        // A steep passage is the narrower, the lower; a jump is not.
        let is_gap = gap > noise && gap >= SHRINKING * (after.value - before.value).abs();
        Ok((gap.is_nan() || gap.is_infinite() || is_gap).then_some(found))
    }

    /// The last place on one side of a break and the first on the other, neighbouring numbers or nearly.
    fn narrow(&mut self, mut below: Node, mut above: Node) -> Result<(Node, Node), ClosureError> {
        loop {
            let middle = 0.5 * (below.at + above.at);
            let is_inside = below.at < middle && middle < above.at;
            if !is_inside || above.at - below.at < f64::EPSILON * (self.range.1 - self.range.0) {
                return Ok((below, above));
            }
            let middle = (self.look)(middle)?;
            let is_below = match (below.is_known(), above.is_known()) {
                (true, true) => {
                    (middle.value - below.value).abs() <= (middle.value - above.value).abs()
                }
                (known, _) => middle.is_known() == known,
            };
            match is_below {
                true => below = middle,
                false => above = middle,
            }
        }
    }

    /// What the function tends to at a place where it has this value, coming from one side.
    pub(super) fn limit_towards(
        &mut self,
        at: f64,
        value: f64,
        side: f64,
    ) -> Result<f64, ClosureError> {
        let width = self.range.1 - self.range.0;
        let places = DISTANCES.map(|distance| at + side * distance * width);
        let inside = |place: &f64| self.range.0 <= *place && *place <= self.range.1;
        if !places.iter().all(inside) {
            return Ok(value);
        }
        let mut values = [0.0; 3];
        for (value, place) in values.iter_mut().zip(places) {
            *value = (self.look)(place)?.value;
        }
        Ok(match unbounded(values) {
            Some(infinite) => infinite,
            // There may be a limit where there is no value, `sin(x)/x` at zero.
            None if !value.is_finite() => values[0],
            None => value,
        })
    }
}

/// The infinity that a function tends to that has these values at distances of which each is a hundred times the one
/// before; none if it tends to a value.
pub(super) fn unbounded([first, second, third]: [f64; 3]) -> Option<f64> {
    let (last, before) = (first - second, second - third);
    let noise = NOISE * first.abs().max(third.abs());
    let grows =
        last * before > 0.0 && last.abs() > SHRINKING * before.abs() && before.abs() > noise;
    grows.then(|| f64::INFINITY.copysign(last))
}
