//! Whether an explicit method will ever get to the end.
//!
//! A stiff motion holds its steps where it is only just stable, and millions of them lead nowhere. After many steps the
//! fastest rate of change is measured in some that follow each other. Where the steps that are left are more than a fifth of those
//! that are permitted, and most that were measured are held by that rate, the integration ends and says so. Not all: what swings at
//! the border of stability is at times so small that the rate cannot be measured.

use super::error::OdeError;

/// Steps after which a motion is first doubted, and between one measurement and the next: a fraction of a second.
const EVERY: usize = 100_000;
/// Steps that are measured, and so many of them that it is most.
const MEASURED: usize = 20;
const MOST: usize = MEASURED / 2;
/// `h|λ|` from which on stability may hold a step: at its border it is some 6 by DOP853 and 3 by Tsit5, and by tight
/// tolerances, whose error estimate feels the border first, from 0.4 up.
const HELD: f64 = 0.25;
/// The share of the steps that are permitted which may be held.
const SHARE: f64 = 0.2;

/// What has been measured.
pub(crate) struct Doubt {
    /// Steps that may be held.
    permitted: f64,
    /// Steps that were measured in this row, and how many of them are held.
    measured: usize,
    held: usize,
}

impl Doubt {
    /// Nothing yet, where so many steps are permitted.
    #[inline]
    pub fn new(permitted: usize) -> Self {
        Self { permitted: SHARE * permitted as f64, measured: 0, held: 0 }
    }

    /// Whether the step after so many is to be measured.
    #[inline]
    pub fn is_due(&self, steps: usize) -> bool {
        steps >= EVERY && steps % EVERY < MEASURED
    }

    /// Judges a step to a time, of a length, in which the equations show a rate, where so many like it are left.
    #[cold]
    pub fn judge(
        &mut self,
        left: f64,
        (time, step, rate): (f64, f64, f64),
    ) -> Result<(), OdeError> {
        self.measured += 1;
        self.held += usize::from(step.abs() * rate > HELD && left > self.permitted);
        if self.measured < MEASURED {
            return Ok(());
        }
        self.measured = 0;
        if std::mem::take(&mut self.held) < MOST {
            return Ok(());
        }
        Err(OdeError::Stiff { time, step, rate, steps: left })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Judges twenty steps of which every so many is held.
    fn judged(every: usize, left: f64) -> Result<(), OdeError> {
        let mut doubt = Doubt::new(10_000);
        (0..MEASURED).try_for_each(|step| {
            let rate = if step % every == 0 { 2.0 } else { 0.1 };
            doubt.judge(left, (1.0, 1.0, rate))
        })
    }

    #[test]
    fn most_steps_have_to_be_held() {
        assert!(matches!(judged(2, 1e6), Err(OdeError::Stiff { .. })));
        assert_eq!(judged(3, 1e6), Ok(()));
        assert_eq!(judged(1, 900.0), Ok(()));
    }
}
