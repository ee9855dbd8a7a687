//! Sizes of errors, measured in tolerances.

use super::options::Options;
use super::system::System;

/// The larger of two sizes. No number is larger than one that is not known.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    match a.is_nan() || b.is_nan() {
        true => f64::NAN,
        false => a.max(b),
    }
}

/// The largest part's root mean square of `values` over the tolerances at `before` and `after`; with a `second` vector
/// the value is damped as in DOP853: `e₅² / √(e₅² + 0.01 e₃²)`. NaN as soon as one value is NaN.
#[inline]
pub(super) fn scaled_size<Y: System + ?Sized>(
    system: &Y,
    options: &Options,
    (before, after): (&[f64], &[f64]),
    values: &[f64],
    second: Option<&[f64]>,
) -> f64 {
    let length = system.part();
    let mut largest = 0.0;
    for (part, values) in values.chunks(length.max(1)).enumerate() {
        let factor = system.part_scale(part);
        let begin = part * length;
        let (before, after) = (&before[begin..][..length], &after[begin..][..length]);
        let second = second.map(|second| &second[begin..][..length]);
        let (mut sum, mut damping) = (0.0, 0.0);
        for (index, value) in values.iter().enumerate() {
            let size = before[index].abs().max(after[index].abs());
            let tolerance = factor * options.atol.of(index) + options.rtol * size;
            let ratio = value / tolerance;
            sum += ratio * ratio;
            if let Some(second) = second {
                let ratio = second[index] / tolerance;
                damping += ratio * ratio;
            }
        }
        let damped: f64 = sum + 0.01 * damping;
        let size = if damped == 0.0 { 0.0 } else { sum / (damped * length as f64).sqrt() };
        if size.is_nan() {
            return f64::NAN;
        }
        largest = size.max(largest);
    }
    largest
}

/// The first component of the motion, or else of a further part, that is not a finite number.
#[inline]
pub(crate) fn first_bad(values: &[f64], part: usize) -> Option<usize> {
    // Zero, unless one is infinite or not a number.
    if values.iter().fold(0.0, |sum, value| sum + 0.0 * value) == 0.0 {
        return None;
    }
    let place = values.iter().position(|value| !value.is_finite());
    place.map(|place| place % part.max(1))
}

/// The component with the largest error.
#[cold]
pub(super) fn worst(options: &Options, state: &[f64], errors: &[f64]) -> usize {
    let mut worst = (0, 0.0);
    for (index, (value, error)) in state.iter().zip(errors).enumerate() {
        let tolerance = options.atol.of(index) + options.rtol * value.abs();
        let ratio = error.abs() / tolerance;
        if ratio > worst.1 {
            worst = (index, ratio);
        }
    }
    worst.0
}
