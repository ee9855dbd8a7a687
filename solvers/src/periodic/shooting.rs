//! Shooting: Newton's method for the start of a motion that repeats.

use super::error::PeriodicError;
use super::period::{Period, Return};
use crate::floquet::Closing;
use crate::ode::OdeError;
use nalgebra::DVector;

/// Largest number of Newton steps.
const STEPS: usize = 30;
/// Smallest part of a Newton step that is tried.
const SMALLEST_PART: f64 = 1.0 / 64.0;

/// Finds a start whose motion repeats within the tolerance.
///
/// A step is shortened until it passes the natural monotonicity test (P. Deuflhard: *Newton Methods for Nonlinear
/// Problems*, 2004, section 3.3). If it does not, the motion itself is followed for a period, which leads a
/// damped mechanism towards its steady state.
pub(super) fn shoot(
    period: &Period<'_>,
    guess: &DVector<f64>,
    rtol: f64,
    iterations: &mut usize,
) -> Result<Return, PeriodicError> {
    let mut candidate = guess.clone();
    let mut search = Search { best: None, part: 1.0, steps: 0 };
    loop {
        *iterations += 1;
        let back = period.turn(&candidate, rtol);
        match search.judge(back, rtol, *iterations)? {
            Verdict::Closed(back) => return Ok(back),
            Verdict::Try(next) => candidate = next,
        }
    }
}

/// What follows from a candidate.
enum Verdict {
    /// Its motion repeats.
    Closed(Return),
    /// The next candidate.
    Try(DVector<f64>),
}

/// The best candidate so far.
struct Best {
    /// Its motion.
    back: Return,
    /// Its matrix.
    closing: Closing,
    /// The Newton step from it.
    change: DVector<f64>,
}

/// Where the search stands.
struct Search {
    /// The best candidate so far.
    best: Option<Best>,
    /// The part of the step that was tried last.
    part: f64,
    /// Newton steps so far.
    steps: usize,
}

impl Search {
    /// Judges the motion of a candidate.
    fn judge(
        &mut self,
        back: Result<Return, OdeError>,
        rtol: f64,
        iterations: usize,
    ) -> Result<Verdict, PeriodicError> {
        let Some(best) = self.best.take() else {
            return self.advance(back?, rtol, iterations);
        };
        let gap = best.back.gap().amax();
        match back {
            Ok(back) if self.is_better(&best, &back, rtol)? => self.advance(back, rtol, iterations),
            _ if self.part > SMALLEST_PART => {
                self.part *= 0.5;
                let next = &best.back.start + self.part * &best.change;
                self.best = Some(best);
                Ok(Verdict::Try(next))
            }
            _ if gap <= 1e3 * rtol * best.back.size() => Ok(Verdict::Closed(best.back)),
            _ => {
                self.count(gap, iterations)?;
                Ok(Verdict::Try(best.back.end))
            }
        }
    }

    /// Whether a candidate is better by the natural test: its Newton step with the matrix of the best one is shorter.
    fn is_better(&self, best: &Best, back: &Return, rtol: f64) -> Result<bool, PeriodicError> {
        let change = best.closing.solve(&back.gap(), rtol, f64::INFINITY)?.change;
        Ok(change.norm() <= (1.0 - 0.25 * self.part) * best.change.norm())
    }

    /// Takes the next Newton step.
    fn advance(
        &mut self,
        back: Return,
        rtol: f64,
        iterations: usize,
    ) -> Result<Verdict, PeriodicError> {
        let gap = back.gap();
        let closing = Closing::new(&back.matrix);
        let change = closing.solve(&gap, rtol, f64::INFINITY)?.change;
        let size = back.size();
        if gap.amax() <= 10.0 * rtol * size && change.amax() <= rtol.sqrt() * size {
            return Ok(Verdict::Closed(back));
        }
        self.count(gap.amax(), iterations)?;
        self.part = 1.0;
        let next = &back.start + &change;
        self.best = Some(Best { back, closing, change });
        Ok(Verdict::Try(next))
    }

    /// Counts a step.
    fn count(&mut self, residual: f64, iterations: usize) -> Result<(), PeriodicError> {
        self.steps += 1;
        if self.steps > STEPS {
            return Err(PeriodicError::NotConverged { iterations, residual });
        }
        Ok(())
    }
}
