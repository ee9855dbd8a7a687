//! Whether an explicit method will ever get to the end.
//!
//! A stiff motion holds its steps where it is only just stable, and millions of them lead nowhere. After many steps the
//! fastest rate of change is measured in some that follow each other. Where the steps that are left are more than are
//! permitted, and all that were measured are held by that rate, the integration ends and says so.

use super::error::OdeError;

/// Steps after which a motion is first doubted, and between one measurement and the next: a fraction of a second.
const EVERY: usize = 100_000;
/// Steps that are measured.
const MEASURED: usize = 20;
/// `h|λ|` from which on stability may hold a step: at its border it is some 6 by DOP853 and 3 by Tsit5, and by tight
/// tolerances, whose error estimate feels the border first, from 0.4 up.
const HELD: f64 = 0.25;

/// What has been measured.
pub(super) struct Doubt {
    /// Steps that are permitted in all.
    permitted: usize,
    /// Steps in a row that are held.
    held: usize,
}

impl Doubt {
    /// Nothing yet.
    #[inline(always)]
    pub fn new(permitted: usize) -> Self {
        Self { permitted, held: 0 }
    }

    /// Whether the step after so many is to be measured.
    #[inline(always)]
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
        match step.abs() * rate > HELD && left > self.permitted as f64 {
            true => self.held += 1,
            false => self.held = 0,
        }
        if self.held < MEASURED {
            return Ok(());
        }
        Err(OdeError::Stiff {
            time,
            step,
            rate,
            steps: left,
        })
    }
}
