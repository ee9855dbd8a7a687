//! One degree of freedom by hand: DOP853 around an acceleration.

use assur::scalar::Scalar;

use crate::hand_dop853::{self, Attempt, attempt};

/// What a run gives.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Position and speed at the end.
    pub end: [f64; 2],
    /// Evaluations of the derivative.
    pub evaluations: usize,
}

/// Integrates from time 0 to `end` with a first step; absolute tolerances `rtol·scale`.
#[inline(always)]
pub fn follow<S: Scalar>(
    acceleration: impl Fn(S, S) -> S,
    start: [f64; 2],
    (end, first): (f64, f64),
    (rtol, scale): (f64, f64),
) -> Run {
    let mut y = start.map(S::from_f64);
    let (mut t, mut h) = (0.0, first);
    let mut k1 = [y[1], acceleration(y[0], y[1])];
    let mut evaluations = 1;
    while t < end {
        if t + 1.01 * h >= end {
            h = end - t;
        }
        let at = hand_dop853::times(t, h);
        let Attempt { end: next, error, .. } = attempt(
            #[inline(always)]
            |_: &f64, y: &[S; 2]| [y[1], acceleration(y[0], y[1])],
            &at,
            (&y, &k1),
            h,
            (rtol, scale),
        );
        evaluations += 11;
        let factor = (0.9 * error.powf(-1.0 / 8.0)).clamp(1.0 / 3.0, 6.0);
        if error <= 1.0 {
            t = if t + h >= end { end } else { t + h };
            k1 = [next[1], acceleration(next[0], next[1])];
            evaluations += 1;
            y = next;
            h *= factor;
        } else {
            h *= factor.min(1.0);
        }
    }
    Run { end: y.map(S::to_f64), evaluations }
}
