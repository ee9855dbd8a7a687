//! What the expressions of a file may cost.
//!
//! A few lines can ask for more than any machine has: each derivative of a derivative doubles, and so does a function that
//! calls another one twice. So steps are counted, nodes built and nodes visited, and when a file has taken too many the
//! work is unwound to where the file is compiled. Steps are the same on every machine and in every build, times are not.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use crate::token::Span;

/// Steps that a file may take: six seconds of a release build, twenty where sums are long; more than what the largest
/// mechanism of `equations/` takes.
pub const STEPS: u64 = 64_000_000;

/// The steps that are left, and which statement has taken most of them.
#[derive(Debug)]
pub struct Budget {
    steps: u64,
    left: Cell<u64>,
    /// The statement that is read, and what was left when it was begun.
    open: Cell<(Option<Span>, u64)>,
    largest: Cell<(Option<Span>, u64)>,
}

impl Default for Budget {
    fn default() -> Self {
        Self::new(u64::MAX)
    }
}

/// Thrown where no step is left.
struct Exhausted;

impl Budget {
    /// So many steps.
    pub fn new(steps: u64) -> Self {
        Self {
            steps,
            left: Cell::new(steps),
            open: Cell::new((None, steps)),
            largest: Cell::new((None, 0)),
        }
    }

    /// Takes some steps. Without enough of them left the work is unwound to [`within`].
    pub fn spend(&self, steps: usize) {
        match self.left.get().checked_sub(steps as u64) {
            Some(left) => self.left.set(left),
            None => self.exhaust(),
        }
    }

    /// Takes all steps that are left, and unwinds.
    pub fn exhaust(&self) -> ! {
        self.left.set(0);
        self.begin(None);
        // Unlike a panic this calls no hook: nothing is printed.
        resume_unwind(Box::new(Exhausted))
    }

    /// From now on steps are taken for a statement, or for none.
    pub fn begin(&self, statement: Option<Span>) {
        let left = self.left.get();
        let (open, before) = self.open.replace((statement, left));
        if open.is_some() && before - left > self.largest.get().1 {
            self.largest.set((open, before - left));
        }
    }

    /// Whether a step has been wanted that was not left.
    pub fn is_exhausted(&self) -> bool {
        self.left.get() == 0
    }

    /// Steps taken so far.
    pub fn spent(&self) -> u64 {
        self.steps - self.left.get()
    }

    /// The statement that has taken most steps, if it has taken a good part of all.
    pub fn largest(&self) -> Option<Span> {
        let (statement, steps) = self.largest.get();
        statement.filter(|_| steps >= self.spent() / 10)
    }
}

/// The result of some work, or nothing if its budget did not suffice.
pub fn within<T>(work: impl FnOnce() -> T) -> Option<T> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(result) => Some(result),
        Err(thrown) if thrown.is::<Exhausted>() => None,
        Err(panic) => resume_unwind(panic),
    }
}
