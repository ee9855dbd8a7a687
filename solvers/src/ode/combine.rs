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
    // Whole groups of lanes have a length that is known everywhere, the rest one where steps are compiled.
    while first + LANES <= target.len() {
        lanes(target, start, step, row, slopes, (first, LANES));
        first += LANES;
    }
    if first < target.len() {
        let rest = (first, target.len() - first);
        lanes(target, start, step, row, slopes, rest);
    }
}

/// Some components of [`combine`], from a first one on, no more than [`LANES`].
#[inline(always)]
fn lanes<S: Scalar>(
    target: &mut [S],
    start: Option<&[S]>,
    step: S,
    row: Row,
    slopes: &[S],
    (first, count): (usize, usize),
) {
    let length = target.len();
    let mut sums = [S::ZERO; LANES];
    for &(number, coefficient) in row {
        let coefficient = S::from_f64(coefficient);
        let slope = &slopes[number * length + first..][..count];
        for (sum, slope) in sums.iter_mut().zip(slope) {
            *sum = slope.mul_add(coefficient, *sum);
        }
    }
    // All is read before anything is written, which lets the lanes be packed.
    match start {
        Some(start) => {
            for (sum, start) in sums.iter_mut().zip(&start[first..][..count]) {
                *sum = sum.mul_add(step, *start);
            }
        }
        None => {
            for sum in &mut sums[..count] {
                *sum = *sum * step;
            }
        }
    }
    for (target, sum) in target[first..][..count].iter_mut().zip(sums) {
        *target = sum;
    }
}
