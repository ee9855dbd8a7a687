//! The cubic through the values and slopes of a guard at two parts of a step.

/// How much farther than a cubic through its ends a guard may move in a step that is resolved. A cubic itself moves up to
/// three times as far as its coefficients.
const SWING: f64 = 4.0;
/// By how many times the largest slope that was found may be too small.
const SAFETY: f64 = 3.0;
/// A zero of a cubic that moves by less is known to twice as many digits.
const CLOSE: f64 = 1e-6;
/// To divide instead took 4 % of the time of a motion with many events.
const THIRD: f64 = 1.0 / 3.0;

/// A guard at a part of the step, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::hybrid) struct Reading {
    pub part: f64,
    pub value: f64,
    /// Derivative by the part.
    pub slope: f64,
}

/// The coefficients of the cubic through two samples, between which it lies.
pub(super) fn hull(from: &Reading, to: &Reading) -> [f64; 4] {
    let width = to.part - from.part;
    [
        from.value,
        from.value + THIRD * width * from.slope,
        to.value - THIRD * width * to.slope,
        to.value,
    ]
}

/// Whether a guard that changes at most so fast is a cubic between two samples, as far as these say: it is too slow to get
/// to zero and back, or its values and slopes at both ends have much to do with its speed. Where they have not it may
/// have swung meanwhile: methods step far over what the state does not feel.
pub(super) fn is_resolved(from: &Reading, to: &Reading, slope: f64) -> bool {
    let reach = slope * (to.part - from.part);
    let (low, high) = range(&hull(from, to));
    from.value.abs() + to.value.abs() > SAFETY * reach || reach <= SWING * (high - low)
}

/// Whether a cubic through two samples stays away from zero by more than it changes.
pub(super) fn is_far(from: &Reading, to: &Reading) -> bool {
    let (low, high) = range(&hull(from, to));
    f64::max(low, -high) > high - low
}

/// A cubic at a part, from 0 to 1.
pub(super) fn cubic(hull: &[f64; 4], part: f64) -> f64 {
    let [a, b, c, d] = *hull;
    let rest = 1.0 - part;
    let (square, rest_square) = (part * part, rest * rest);
    a * rest * rest_square + 3.0 * part * rest * (b * rest + c * part) + d * part * square
}

/// About where a cubic of which the ends have different signs is zero, from 0 to 1.
pub(super) fn root(hull: &[f64; 4]) -> f64 {
    let [a, b, c, d] = *hull;
    // Where the tangent at the end is zero that is nearer to zero, or the chord.
    let tangent = match a.abs() < d.abs() {
        true => a / (3.0 * (a - b)),
        false => 1.0 - d / (3.0 * (d - c)),
    };
    let mut part = match tangent > 0.0 && tangent < 1.0 {
        true => tangent,
        false => a / (a - d),
    };
    for _ in 0..4 {
        let rest = 1.0 - part;
        let (first, last) = (
            (a * rest + b * part) * rest + (b * rest + c * part) * part,
            (b * rest + c * part) * rest + (c * rest + d * part) * part,
        );
        let next = part - (first * rest + last * part) / (3.0 * (last - first));
        if !(next > 0.0 && next < 1.0) {
            break;
        }
        let is_near = (next - part).abs() < CLOSE;
        part = next;
        if is_near {
            break;
        }
    }
    part
}

/// The smallest and the largest of some values.
#[inline(always)]
pub(super) fn range(&[a, b, c, d]: &[f64; 4]) -> (f64, f64) {
    let low = smaller(smaller(a, b), smaller(c, d));
    (low, larger(larger(a, b), larger(c, d)))
}

/// The smaller of two numbers by one instruction: `f64::min` also looks for what is not a number.
#[inline(always)]
fn smaller(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
}

/// The larger of two numbers by one instruction.
#[inline(always)]
pub(super) fn larger(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}
