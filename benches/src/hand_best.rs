//! The loop of DOP853 by hand, for the elastic batten, with all that is known to make it fast: fused products and sums, the
//! sines of a step packed, and what depends on the time taken over from the end of one step to the begin of the next.

use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;

use crate::hand::Batten;
use crate::hand_dop853::{self, Attempt, attempt};
use crate::hand_loop::Run;

/// Integrates from 0 to `end` from `start`; absolute tolerances `rtol·scale`.
#[inline(never)]
pub fn run(batten: &Batten, end: f64, start: [f64; 6], rtol: f64, scale: f64) -> Run {
    dispatch(Revolutions { batten, end, start, rtol, scale })
}

struct Revolutions<'a> {
    batten: &'a Batten,
    end: f64,
    start: [f64; 6],
    rtol: f64,
    scale: f64,
}

impl Task for Revolutions<'_> {
    type Output = Run;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Run {
        let Self { batten, end, start, rtol, scale } = self;
        let mut y = [S::ZERO; 6];
        for (slot, value) in y.iter_mut().zip(start) {
            *slot = S::from_f64(value);
        }
        let (mut t, mut h) = (0.0, 1e-4);
        let mut k1 = [S::ZERO; 6];
        let [begin] = batten.instants([S::ZERO]);
        batten.derivative(&begin, &y, &mut k1);
        let mut evaluations = 1;
        while t < end {
            if t + 1.01 * h >= end {
                h = end - t;
            }
            let mut times = [S::ZERO; 11];
            for (slot, time) in times.iter_mut().zip(hand_dop853::times(t, h)) {
                *slot = S::from_f64(time);
            }
            let at = batten.instants(times);
            let Attempt { end: next, error, .. } = attempt(
                #[inline(always)]
                |at, y| {
                    let mut rate = [S::ZERO; 6];
                    batten.derivative(at, y, &mut rate);
                    rate
                },
                &at,
                (&y, &k1),
                h,
                (rtol, scale),
            );
            evaluations += 11;
            let factor = (0.9 * error.powf(-1.0 / 8.0)).clamp(1.0 / 3.0, 6.0);
            if error <= 1.0 {
                t = if t + h >= end { end } else { t + h };
                batten.derivative(&at[10], &next, &mut k1);
                evaluations += 1;
                y = next;
                h *= factor;
            } else {
                h *= factor.min(1.0);
            }
        }
        let mut numbers = [0.0; 6];
        for (number, y) in numbers.iter_mut().zip(y) {
            *number = y.to_f64();
        }
        Run { end: numbers, evaluations }
    }
}
