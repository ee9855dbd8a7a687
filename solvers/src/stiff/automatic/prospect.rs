//! When the Taylor series of a motion is worth it.
//!
//! A step of the series takes more work than one of Runge and Kutta, and is longer. How much more work is known: it is counted
//! in operations of the equations, so that the choice is the same on any machine. How much longer follows from the accuracy and
//! from how far the series of this motion converges. So where the work alone does not decide it, both are measured: the steps of
//! the explicit method, and the step that the series permits where the motion then stands. Afterwards the steps of the series have
//! to stay so long.
//!
//! Where something stiff holds back the explicit method, stability holds back the series too, though not as much: its errors grow
//! in steps that are ten times as long. So it takes longer until a stiff method is tried.

use crate::model::Flow;
use crate::ode::Options;
use crate::shape::Operations;
use crate::stiff::here::Here;
use crate::taylor::{Taylor, order};

/// Least and most steps of the explicit method after which the series is looked at. The second half of them is measured. After
/// the series was not worth it, it takes twice as many, and so on.
const STEPS: (f64, f64) = (8.0, 4096.0);
/// As many of them take this many times as long as a look at the series.
const LOOK: f64 = 8.0;
/// Steps of the series over which it is looked whether they are still long enough,
const WINDOW: usize = 24;
/// and after which the explicit method is measured, if it has not been.
const UNMEASURED: usize = 48;
/// The series must promise to be faster by this factor,
const BETTER: f64 = 1.1;
/// and is left where it is slower by this one.
const WORSE: f64 = 0.9;
/// Steps of the series are at least so many times as long as those of the explicit method at a relative tolerance of 1e-4, and
/// ten times longer for nine digits more: motions without tables and branches differ in that by no more than a factor of 4.
const LONGER: f64 = 0.35;
/// `h|λ|` over the order of the series at the border of stability is about 0.4; that of a resolved oscillation about 0.15.
const BORDER: f64 = 0.33;
/// Measurements in a row beyond it, one in sixteen steps, that lead to the first trial of a stiff method and, at most, to a later
/// one.
const HELD: (usize, usize) = (2, 256);

/// What is known of the series.
pub(super) struct Prospect {
    /// The memory of the method, once it is looked at.
    pub taylor: Option<Taylor>,
    /// Its order; none before the begin, and where the equations have no series.
    order: Option<usize>,
    /// Work of a step of the series over that of a step of the explicit method.
    work: f64,
    /// Steps so far by the method that goes on, the sum of the lengths that count, and the last one.
    steps: usize,
    lengths: f64,
    last: f64,
    /// Steps of the explicit method after which the series is looked at.
    limit: usize,
    /// The shortest mean step at which the series is worth it; infinite while the explicit method was not measured.
    worth: f64,
    /// Measurements in a row that found its steps held back, and how many of them are to be explained.
    held: usize,
    explained: usize,
}

impl Prospect {
    /// Nothing is known yet.
    pub fn new() -> Self {
        Self {
            taylor: None,
            order: None,
            work: 0.0,
            steps: 0,
            lengths: 0.0,
            last: 0.0,
            limit: 0,
            worth: f64::INFINITY,
            held: 0,
            explained: HELD.0,
        }
    }

    /// Estimates the work, once. Whether to begin with the series: it takes so little that nothing needs to be measured.
    pub fn begin(&mut self, flow: &Flow<'_>, options: &Options) -> bool {
        let (operations, states) = (&flow.shape().operations, flow.states());
        if self.order.is_some() || operations.term == 0 {
            return false;
        }
        let order = *self.order.insert(order(options.rtol));
        self.work = series(operations, states, order) / explicit(operations);
        self.limit = (LOOK * self.work).clamp(STEPS.0, STEPS.1) as usize;
        let is_cheap = self.work < LONGER * (1e-4 / options.rtol).powf(1.0 / 9.0);
        if is_cheap {
            self.taylor = Some(Taylor::new(states, options.rtol));
        }
        is_cheap
    }

    /// Counts a step of the explicit method. The first half does not count: its length is being found.
    pub fn count_explicit(&mut self, length: f64) {
        self.count(length);
        if self.steps == self.limit / 2 {
            self.lengths = 0.0;
        }
    }

    /// Counts a step of the series.
    pub fn count(&mut self, length: f64) {
        self.steps += 1;
        self.lengths += length;
        self.last = length;
    }

    /// Hears of `h|λ|` of a step of the series.
    pub fn feel(&mut self, product: f64) {
        let is_held = self.order.is_some_and(|order| product > BORDER * order as f64);
        self.held = if is_held { self.held + 1 } else { 0 };
    }

    /// Whether a stiff method may be faster.
    pub fn is_held(&self) -> bool {
        self.held >= self.explained
    }

    /// The mean length of the steps of the series.
    pub fn mean(&self) -> f64 {
        self.lengths / self.steps as f64
    }

    /// A stiff method is not faster: it takes longer until one is tried again.
    pub fn was_wrong(&mut self) {
        self.explained = (2 * self.explained).min(HELD.1);
        self.clear();
    }

    /// Whether it is time to look at the series.
    pub fn is_due(&self) -> bool {
        self.order.is_some() && self.steps >= self.limit
    }

    /// Whether the series is worth it from here on.
    pub fn is_worth_it(&mut self, flow: &Flow<'_>, here: &mut Here, options: &Options) -> bool {
        let mean = self.lengths / (self.steps - self.limit / 2) as f64;
        self.worth = self.work * mean.max(self.last);
        let taylor = self.taylor.get_or_insert_with(|| Taylor::new(flow.states(), options.rtol));
        let reach = taylor.reach(flow, (here.time, mean), &here.state, options).unwrap_or(0.0);
        here.statistics.evaluations += 1;
        let is_worth_it = reach > BETTER * self.worth;
        if is_worth_it {
            self.clear();
        } else {
            self.leave();
        }
        is_worth_it
    }

    /// Whether the series is not worth it any more, or not known to be.
    pub fn is_over(&self) -> bool {
        let window = if self.worth == f64::INFINITY { UNMEASURED } else { WINDOW };
        self.is_held() || self.steps >= window && self.mean() < WORSE * self.worth
    }

    /// The series is not worth it: it will take longer until it is looked at again.
    pub fn leave(&mut self) {
        if self.worth < f64::INFINITY {
            self.limit = (2 * self.limit).min(STEPS.1 as usize);
        }
        self.clear();
    }

    /// Begins to count.
    pub fn clear(&mut self) {
        (self.steps, self.lengths, self.held) = (0, 0.0, 0);
    }
}

/// Evaluations in a step of the explicit method whose continuous solution is kept.
const EVALUATIONS: f64 = 16.5;
/// What a step takes beside them, and beside a series.
const KEPT: f64 = 250.0;

/// About the nanoseconds of an evaluation. The figures here were measured with all scenes that come with Assur; of which
/// processor, hardly matters to their ratios.
fn evaluation(operations: &Operations) -> f64 {
    let Operations { instant, derivative, functions, .. } = *operations;
    5.0 + 0.2 * (instant + derivative) as f64 + 17.0 * functions as f64
}

/// About those of a step of the explicit method of order 8.
fn explicit(operations: &Operations) -> f64 {
    EVALUATIONS * evaluation(operations) + KEPT
}

/// About those of a step of the series: within 30 % of what was measured.
fn series(operations: &Operations, states: usize, order: usize) -> f64 {
    let [term, sums] = [operations.term, operations.sums].map(|count| count as f64);
    let (states, order) = (states as f64, order as f64);
    let term = 1.2 + 0.3 * states + 0.08 * term + sums * (4.3 + 0.1 * order);
    order * term + evaluation(operations) + KEPT
}
