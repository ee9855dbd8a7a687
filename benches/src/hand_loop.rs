//! The loop of DOP853 by hand, for the elastic batten.

use crate::hand::Batten;
use crate::hand_dop853::{self, Attempt, attempt};

/// What a run gives.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// State at the end.
    pub end: [f64; 6],
    /// Evaluations of the derivative.
    pub evaluations: usize,
}

/// Integrates from 0 to `end` from `y`; absolute tolerances `rtol·scale`. `KERNEL` says which sine, see
/// [`Batten::instant_by`].
#[inline(never)]
pub fn run<const KERNEL: bool>(
    batten: &Batten,
    end: f64,
    mut y: [f64; 6],
    rtol: f64,
    scale: f64,
) -> Run {
    let f = |t: &f64, y: &[f64; 6]| {
        let mut rate = [0.0; 6];
        batten.derivative(&batten.instant_by::<KERNEL>(*t), y, &mut rate);
        rate
    };
    let (mut t, mut h) = (0.0, 1e-4);
    let mut k1 = f(&t, &y);
    let mut evaluations = 1;
    while t < end {
        if t + 1.01 * h >= end {
            h = end - t;
        }
        let at = hand_dop853::times(t, h);
        let Attempt { end: next, error, .. } = attempt(f, &at, (&y, &k1), h, (rtol, scale));
        evaluations += 11;
        let factor = (0.9 * error.powf(-1.0 / 8.0)).clamp(1.0 / 3.0, 6.0);
        if error <= 1.0 {
            t = if t + h >= end { end } else { t + h };
            k1 = f(&t, &next);
            evaluations += 1;
            y = next;
            h *= factor;
        } else {
            h *= factor.min(1.0);
        }
    }
    Run { end: y, evaluations }
}
