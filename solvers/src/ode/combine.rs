//! Sums of slopes.

use super::tableau::Row;
use crate::scalar::Scalar;

/// Components that [`combine`] treats together: so many sums stay in registers.
const LANES: usize = 8;

/// `target = start + step · Σ aⱼ kⱼ` over a row of a tableau; slopes stand one behind the other, each as long as the target.
#[inline(always)]
pub(super) fn combine<S: Scalar>(
    target: &mut [S],
    start: Option<&[S]>,
    step: S,
    row: Row,
    slopes: &[S],
) {
    let mut first = 0;
    while first + LANES <= target.len() {
        lanes::<S, LANES>(target, start, step, row, slopes, first);
        first += LANES;
    }
    // What is left in groups whose lengths are known everywhere, not only where steps are compiled for one length.
    let left = target.len() - first;
    if left & 4 != 0 {
        lanes::<S, 4>(target, start, step, row, slopes, first);
        first += 4;
    }
    if left & 2 != 0 {
        lanes::<S, 2>(target, start, step, row, slopes, first);
        first += 2;
    }
    if left & 1 != 0 {
        lanes::<S, 1>(target, start, step, row, slopes, first);
    }
}

/// Some components of [`combine`], from a first one on.
#[inline(always)]
fn lanes<S: Scalar, const COUNT: usize>(
    target: &mut [S],
    start: Option<&[S]>,
    step: S,
    row: Row,
    slopes: &[S],
    first: usize,
) {
    let length = target.len();
    let mut sums = [S::ZERO; COUNT];
    for &(number, coefficient) in row {
        let coefficient = S::from_f64(coefficient);
        let slope = &slopes[number * length + first..][..COUNT];
        for (sum, slope) in sums.iter_mut().zip(slope) {
            *sum = slope.mul_add(coefficient, *sum);
        }
    }
    // All is read before anything is written, which lets the lanes be packed.
    match start {
        Some(start) => {
            for (sum, start) in sums.iter_mut().zip(&start[first..][..COUNT]) {
                *sum = sum.mul_add(step, *start);
            }
        }
        None => {
            for sum in &mut sums {
                *sum = *sum * step;
            }
        }
    }
    for (target, sum) in target[first..][..COUNT].iter_mut().zip(sums) {
        *target = sum;
    }
}
