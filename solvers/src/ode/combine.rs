//! Sums of slopes.

use super::system::System;
use super::tableau::Row;
use crate::scalar::Scalar;

/// Components that [`combine`] treats together: so many sums stay in registers.
const LANES: usize = 8;

/// `target = start + step · Σ aⱼ kⱼ` over a row of a tableau.
#[inline(always)]
pub(super) fn combine<S: Scalar, Y: System<S>>(
    target: &mut Y::State,
    start: Option<&Y::State>,
    step: f64,
    row: Row,
    slopes: &[Y::State],
) {
    let step = S::from_f64(step);
    for part in 0..Y::parts(target) {
        let length = Y::part(target, part).len();
        let mut first = 0;
        // The length of an array is known to the compiler, so that the inner loops vanish.
        while first < length {
            let count = (length - first).min(LANES);
            let mut sums = [S::ZERO; LANES];
            for &(number, coefficient) in row {
                let coefficient = S::from_f64(coefficient);
                let slope = &Y::part(&slopes[number], part)[first..first + count];
                for (sum, slope) in sums.iter_mut().zip(slope) {
                    *sum = slope.mul_add(coefficient, *sum);
                }
            }
            // All is read before anything is written, which lets the lanes be packed.
            match start {
                Some(start) => {
                    let start = &Y::part(start, part)[first..first + count];
                    for (sum, start) in sums.iter_mut().zip(start) {
                        *sum = sum.mul_add(step, *start);
                    }
                }
                None => {
                    for sum in &mut sums[..count] {
                        *sum = *sum * step;
                    }
                }
            }
            let target = &mut Y::part_mut(target, part)[first..first + count];
            for (target, sum) in target.iter_mut().zip(sums) {
                *target = sum;
            }
            first += count;
        }
    }
}
