//! Sums of slopes.

use super::system::System;
use super::tableau::Row;
use crate::scalar::Scalar;

/// `target = start + step · Σ aⱼ kⱼ` over a row of a tableau.
///
/// The sums are formed for a few components at a time, so that they stay in registers.
#[inline(always)]
pub(super) fn combine<S: Scalar, Y: System<S>>(
    target: &mut Y::State,
    start: Option<&Y::State>,
    step: f64,
    row: Row,
    slopes: &[Y::State],
) {
    for part in 0..Y::parts(target) {
        let length = Y::part(target, part).len();
        let blocks = length / LANES * LANES;
        for first in (0..blocks).step_by(LANES) {
            combine_block::<LANES, S, Y>(target, start, step, row, slopes, (part, first));
        }
        for first in blocks..length {
            combine_block::<1, S, Y>(target, start, step, row, slopes, (part, first));
        }
    }
}

/// Components that [`combine`] treats together.
const LANES: usize = 4;

/// The part of [`combine`] for `K` components from `first` of a part.
#[inline(always)]
fn combine_block<const K: usize, S: Scalar, Y: System<S>>(
    target: &mut Y::State,
    start: Option<&Y::State>,
    step: f64,
    row: Row,
    slopes: &[Y::State],
    (part, first): (usize, usize),
) {
    let mut sums = [S::ZERO; K];
    for &(number, coefficient) in row {
        let coefficient = S::from_f64(coefficient);
        for (sum, slope) in sums
            .iter_mut()
            .zip(&Y::part(&slopes[number], part)[first..first + K])
        {
            *sum = slope.mul_add(coefficient, *sum);
        }
    }
    let step = S::from_f64(step);
    match start {
        Some(start) => {
            for (sum, start) in sums.iter_mut().zip(&Y::part(start, part)[first..first + K]) {
                *sum = sum.mul_add(step, *start);
            }
        }
        None => {
            for sum in &mut sums {
                *sum = *sum * step;
            }
        }
    }
    Y::part_mut(target, part)[first..first + K].copy_from_slice(&sums);
}
