//! What the steps of the explicit method say about the stiffness.

use crate::ode::{Observer, Step};

/// `h|λ|` below which a motion is not suspected to be stiff.
pub(super) const STIFF: f64 = 0.3;
/// Suspicious steps, not interrupted by [`CALM`] others (program DOP853), that lead to the first trial and, at most, to a
/// later one.
const STEPS: (usize, usize) = (15, 1000);
const CALM: usize = 6;
/// What the explicit steps say about the stiffness.
pub(super) struct Suspicion {
    /// Suspicious steps and the sum of their lengths, and others since the last of them.
    steps: usize,
    lengths: f64,
    calm: usize,
    /// So many are to be explained.
    limit: usize,
}

impl Suspicion {
    pub fn new() -> Self {
        Self { steps: 0, lengths: 0.0, calm: 0, limit: STEPS.0 }
    }

    /// Begins to count.
    pub fn clear(&mut self) {
        (self.steps, self.lengths, self.calm) = (0, 0.0, 0);
    }

    /// It will take longer until the next trial.
    pub fn was_wrong(&mut self) {
        self.clear();
        self.limit = (2 * self.limit).min(STEPS.1);
    }

    /// Mean length of the steps.
    pub fn step(&self) -> f64 {
        self.lengths / self.steps as f64
    }

    fn is_enough(&self) -> bool {
        self.steps >= self.limit
    }

    /// Counts a step.
    fn count(&mut self, length: f64, product: f64) {
        if product > STIFF {
            self.steps += 1;
            self.lengths += length;
            self.calm = 0;
            return;
        }
        self.calm += 1;
        if self.calm >= CALM {
            self.clear();
        }
    }
}

/// An observer that notes where the motion is, and measures the stiffness on the way.
pub(super) struct Gauge<'a> {
    pub inner: &'a mut dyn Observer,
    pub suspicion: Option<&'a mut Suspicion>,
    /// End and length of the last step.
    pub last: (f64, f64),
}

impl Observer for Gauge<'_> {
    fn wants_dense(&mut self, from: f64, to: f64) -> bool {
        self.inner.wants_dense(from, to)
    }

    fn wants_stiffness(&self) -> bool {
        self.suspicion.is_some()
    }

    fn stiffness(&mut self, length: f64, rate: f64) {
        if let Some(suspicion) = &mut self.suspicion {
            suspicion.count(length.abs(), length.abs() * rate);
        }
    }

    fn step(&mut self, step: &Step<'_>) {
        self.last = (step.to, step.to - step.from);
        self.inner.step(step);
    }

    fn has_enough(&self) -> bool {
        self.suspicion.as_ref().is_some_and(|one| one.is_enough()) || self.inner.has_enough()
    }
}
