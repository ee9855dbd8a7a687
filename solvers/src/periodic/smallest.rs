//! Where free motions repeat after the period and nothing drives them, any amount of them may be added. Of all these
//! motions the smallest is taken: the one that losses, however weak, would leave.

use super::error::PeriodicError;
use super::period::Period;
use crate::ode::Trajectory;
use nalgebra::{DMatrix, DVector};

/// Samples over the period.
const SAMPLES: usize = 512;

/// Adds to the starts, one for each tolerance, what makes the mean square of the motion smallest.
pub(super) fn settle(
    period: &Period<'_>,
    starts: [DVector<f64>; 2],
    free: &[DVector<f64>],
    tolerances: [f64; 2],
) -> Result<[DVector<f64>; 2], PeriodicError> {
    let mut settled = Vec::with_capacity(starts.len());
    for (start, rtol) in starts.into_iter().zip(tolerances) {
        // Variations of the size of the motion, so that their differences keep their digits.
        let scale = start.amax().max(1.0);
        let steps: Vec<DVector<f64>> = free.iter().map(|one| one * (scale / one.amax())).collect();
        let mut motions = Vec::with_capacity(free.len() + 1);
        motions.push(samples(&period.march(&start, rtol)?, period.scales()));
        for step in &steps {
            motions.push(samples(&period.march(&(&start + step), rtol)?, period.scales()));
        }
        let amounts = least_squares(&motions);
        let mut start = start;
        for (step, amount) in steps.iter().zip(&amounts) {
            start += step * *amount;
        }
        settled.push(start);
    }
    match settled.try_into() {
        Ok(starts) => Ok(starts),
        Err(_) => Err(PeriodicError::BadPeriod { period: f64::NAN }),
    }
}

/// The states over their scales at equal times over the period, one after the other.
fn samples(motion: &Trajectory, scales: &[f64]) -> DVector<f64> {
    let times = motion.times();
    let (from, to) = (times[0], times[times.len() - 1]);
    let mut values = Vec::with_capacity(SAMPLES * scales.len());
    for number in 0..SAMPLES {
        let state = motion.at(from + (to - from) * number as f64 / SAMPLES as f64);
        values.extend(state.iter().zip(scales).map(|(value, scale)| value / scale));
    }
    DVector::from_vec(values)
}

/// The amounts of the differences from the first motion that make it smallest.
fn least_squares(motions: &[DVector<f64>]) -> Vec<f64> {
    let Some((motion, others)) = motions.split_first() else {
        return Vec::new();
    };
    let free: Vec<DVector<f64>> = others.iter().map(|other| other - motion).collect();
    let gram = DMatrix::from_fn(free.len(), free.len(), |i, j| free[i].dot(&free[j]));
    let right = DVector::from_iterator(free.len(), free.iter().map(|one| -one.dot(motion)));
    let amounts = gram.lu().solve(&right);
    amounts.map_or_else(|| vec![0.0; free.len()], |amounts| amounts.iter().copied().collect())
}
