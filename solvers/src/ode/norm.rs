//! Sizes of errors, measured in tolerances.

use super::options::Options;
use super::system::System;
use crate::scalar::Scalar;

/// The largest part's root mean square of `values` over the tolerances at `before` and `after`; with a `second` vector
/// the value is damped as in DOP853: `e₅² / √(e₅² + 0.01 e₃²)`. NaN as soon as one value is NaN.
#[inline(always)]
pub(super) fn scaled_size<S: Scalar, Y: System<S>>(
    system: &Y,
    options: &Options,
    (before, after): (&Y::State, &Y::State),
    values: &Y::State,
    second: Option<&Y::State>,
) -> f64 {
    let mut largest = 0.0;
    for part in 0..Y::parts(values) {
        let Some(factor) = system.part_scale(part) else {
            continue;
        };
        let (before, after, values) = (
            Y::part(before, part),
            Y::part(after, part),
            Y::part(values, part),
        );
        let second = second.map(|second| Y::part(second, part));
        let (mut sum, mut damping) = (0.0, 0.0);
        for (index, value) in values.iter().enumerate() {
            let size = before[index]
                .to_f64()
                .abs()
                .max(after[index].to_f64().abs());
            let tolerance = factor * options.atol.of(index) + options.rtol * size;
            let ratio = value.to_f64() / tolerance;
            sum += ratio * ratio;
            if let Some(second) = second {
                let ratio = second[index].to_f64() / tolerance;
                damping += ratio * ratio;
            }
        }
        let damped: f64 = sum + 0.01 * damping;
        let size = if damped == 0.0 {
            0.0
        } else {
            sum / (damped * values.len() as f64).sqrt()
        };
        if size.is_nan() {
            return f64::NAN;
        }
        largest = size.max(largest);
    }
    largest
}

/// The first component of the motion, or else of a column, that is not a finite number.
pub(super) fn first_bad<S: Scalar, Y: System<S>>(values: &Y::State) -> Option<usize> {
    (0..Y::parts(values)).find_map(|part| {
        Y::part(values, part)
            .iter()
            .position(|value| !value.to_f64().is_finite())
    })
}

/// The component with the largest error.
#[cold]
pub(super) fn worst<S: Scalar, Y: System<S>>(
    options: &Options,
    state: &Y::State,
    errors: &Y::State,
) -> usize {
    let mut worst = (0, 0.0);
    for (index, (value, error)) in Y::part(state, 0).iter().zip(Y::part(errors, 0)).enumerate() {
        let tolerance = options.atol.of(index) + options.rtol * value.to_f64().abs();
        let ratio = error.to_f64().abs() / tolerance;
        if ratio > worst.1 {
            worst = (index, ratio);
        }
    }
    worst.0
}
