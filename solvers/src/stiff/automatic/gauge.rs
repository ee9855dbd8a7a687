//! What the steps of the explicit method say about the stiffness.

use super::prospect::Prospect;
use crate::ode::{Observer, Options, Step};
use crate::stiff::here::tolerance;

/// `h|λ|` below which a motion is not suspected to be stiff.
pub(super) const STIFF: f64 = 0.3;
/// Suspicious steps, not interrupted by [`CALM`] others (program DOP853), that lead to the first trial and, at most, to a
/// later one.
const STEPS: (usize, usize) = (15, 1000);
const CALM: usize = 6;
/// The last of them, over which it is looked whether a state goes to and fro:
const WINDOW: usize = 30;
/// by how much of its size,
const WIDE: f64 = 0.05;
/// and of its tolerance, as errors at the border of stability go to and fro too.
const SEEN: f64 = 100.0;

/// What the explicit steps say about the stiffness.
pub(super) struct Suspicion {
    /// Suspicious steps and the sum of their lengths, and others since the last of them.
    steps: usize,
    lengths: f64,
    calm: usize,
    /// So many are to be explained.
    limit: usize,
    /// States at the begin and in the middle of the last of them.
    places: [Vec<f64>; 2],
}

impl Suspicion {
    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        let places = [vec![0.0; states], vec![0.0; states]];
        Self { steps: 0, lengths: 0.0, calm: 0, limit: STEPS.0, places }
    }

    /// Forgets what was wrong.
    pub fn restart(&mut self) {
        self.clear();
        self.limit = STEPS.0;
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

    /// Whether there are enough for a trial.
    pub fn is_enough(&self) -> bool {
        self.steps >= self.limit
    }

    /// Looks at the state after a step. Where one goes to and fro nothing is to be explained.
    fn look(&mut self, state: &[f64], options: &Options) {
        if self.is_enough() && self.is_fast(state, options) {
            self.clear();
            return;
        }
        let left = self.limit.saturating_sub(self.steps);
        let window = WINDOW.min(self.limit);
        for (place, at) in self.places.iter_mut().zip([window - 1, window / 2]) {
            if left == at {
                place.copy_from_slice(state);
            }
        }
    }

    /// Whether a state has gone to and fro in the last steps up to here. One that comes to rest has not, however fast it does.
    fn is_fast(&self, here: &[f64], options: &Options) -> bool {
        let [begin, middle] = &self.places;
        here.iter().zip(begin.iter().zip(middle)).enumerate().any(
            |(index, (end, (begin, middle)))| {
                let size = end.abs().max(begin.abs()).max(middle.abs());
                let (first, second) = (middle - begin, end - middle);
                let bend = (second - first).abs();
                let comes_to_rest = first * second > 0.0 && second.abs() < first.abs();
                !comes_to_rest
                    && bend > WIDE * size
                    && bend > SEEN * tolerance(options, index, size)
            },
        )
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

/// What is looked at beside where the motion is.
pub(super) enum Look<'a> {
    /// Nothing.
    Nothing,
    /// What the explicit method says about the stiffness, and how long its steps are.
    Explicit(&'a mut Suspicion, &'a mut Prospect, &'a Options),
    /// Whether the series is still worth it.
    Series(&'a mut Prospect),
}

/// An observer that notes where the motion is, and measures the stiffness on the way.
pub(super) struct Gauge<'a> {
    pub inner: &'a mut dyn Observer,
    pub look: Look<'a>,
    /// End and length of the last step.
    pub last: (f64, f64),
}

impl Observer for Gauge<'_> {
    fn wants_dense(&mut self, from: f64, to: f64) -> bool {
        self.inner.wants_dense(from, to)
    }

    fn wants_stiffness(&self) -> bool {
        !matches!(self.look, Look::Nothing)
    }

    fn stiffness(&mut self, length: f64, rate: f64) {
        let (length, product) = (length.abs(), length.abs() * rate);
        match &mut self.look {
            Look::Nothing => {}
            Look::Explicit(suspicion, ..) => suspicion.count(length, product),
            Look::Series(prospect) => prospect.feel(product),
        }
    }

    fn step(&mut self, step: &Step<'_>) {
        let length = step.to - step.from;
        self.last = (step.to, length);
        match &mut self.look {
            Look::Nothing => {}
            Look::Explicit(suspicion, prospect, options) => {
                suspicion.look(step.after, options);
                prospect.count_explicit(length.abs());
            }
            Look::Series(prospect) => prospect.count(length.abs()),
        }
        self.inner.step(step);
    }

    fn has_enough(&self) -> bool {
        let is_over = match &self.look {
            Look::Nothing => false,
            Look::Explicit(suspicion, prospect, _) => suspicion.is_enough() || prospect.is_due(),
            Look::Series(prospect) => prospect.is_over(),
        };
        is_over || self.inner.has_enough()
    }
}
