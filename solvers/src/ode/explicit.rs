//! The stepper.

use super::controller::Controller;
use super::doubt::Doubt;
use super::error::OdeError;
use super::norm::{first_bad, worst};
use super::observer::{Basis, Observer, Step};
use super::options::{Options, bad, bad_start};
use super::system::System;
use super::workspace::Workspace;

/// What an integration took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// Accepted steps.
    pub steps: usize,
    /// Rejected steps.
    pub rejected: usize,
    /// Evaluations of the derivative, or of the derivative with its variations.
    pub evaluations: usize,
    /// Evaluations of the Jacobian; none by an explicit method.
    pub jacobians: usize,
    /// Times that the matrices of a stiff method were factored.
    pub factorizations: usize,
    /// Those of the accepted steps that a stiff method took.
    pub stiff_steps: usize,
    /// Those of the accepted steps that the Taylor series took.
    pub series_steps: usize,
    /// Those of the accepted steps whose error is that of rounding and above the tolerance: how large the state is leaves
    /// no room for so many digits. A smaller tolerance changes nothing there.
    pub rounded_steps: usize,
    /// Length of the longest step, in seconds.
    pub largest_step: f64,
    /// Length of the shortest step but the last one, in seconds.
    pub smallest_step: f64,
    /// Sum of the error estimates of the steps, in tolerances: about the error at the end, in tolerances, of a motion
    /// that neither damps nor amplifies errors. Zero with fixed steps.
    pub estimated_error: f64,
}

impl Default for Statistics {
    fn default() -> Self {
        Self {
            steps: 0,
            rejected: 0,
            evaluations: 0,
            jacobians: 0,
            factorizations: 0,
            stiff_steps: 0,
            series_steps: 0,
            rounded_steps: 0,
            largest_step: 0.0,
            smallest_step: f64::INFINITY,
            estimated_error: 0.0,
        }
    }
}

impl Statistics {
    /// Counts an accepted step, with its error in tolerances.
    #[inline]
    pub(crate) fn count(&mut self, length: f64, error: f64, is_last: bool) {
        self.steps += 1;
        self.estimated_error += error;
        self.largest_step = self.largest_step.max(length.abs());
        if !is_last || self.steps == 1 {
            self.smallest_step = self.smallest_step.min(length.abs());
        }
    }

    /// Adds what another integration took.
    pub(crate) fn add(&mut self, more: &Self) {
        self.steps += more.steps;
        self.rejected += more.rejected;
        self.evaluations += more.evaluations;
        self.jacobians += more.jacobians;
        self.factorizations += more.factorizations;
        self.stiff_steps += more.stiff_steps;
        self.series_steps += more.series_steps;
        self.rounded_steps += more.rounded_steps;
        self.largest_step = self.largest_step.max(more.largest_step);
        self.smallest_step = self.smallest_step.min(more.smallest_step);
        self.estimated_error += more.estimated_error;
    }
}

/// Where an integration stands.
pub(crate) struct Clock {
    /// Begin and end.
    times: (f64, f64),
    /// The time.
    pub now: f64,
    /// Number of equal steps, if the steps are fixed.
    pub fixed: Option<f64>,
}

impl Clock {
    /// At the begin of a stretch.
    pub fn new(times: (f64, f64), options: &Options) -> Self {
        let span = (times.1 - times.0).abs();
        let fixed = options.fixed_step.map(|step| (span / step * (1.0 - 1e-12)).ceil().max(1.0));
        Self { times, now: times.0, fixed }
    }

    /// Where a step of this length leads, after a number of steps. The last step lands exactly on the end.
    #[inline]
    pub fn target(&self, step: f64, steps: usize) -> f64 {
        if let Some(count) = self.fixed {
            return self.even(count, steps);
        }
        let to = self.times.1;
        let left = to - self.now;
        if left.abs() <= 1.01 * step.abs() { to } else { self.now + step }
    }

    /// Where one of so many even steps leads. A call, or else the compiler divides beforehand, by what is no number where
    /// steps are not even.
    #[cold]
    #[inline(never)]
    fn even(&self, count: f64, steps: usize) -> f64 {
        let ((from, to), number) = (self.times, (steps + 1) as f64);
        match number >= count {
            true => to,
            false => from + (to - from) * (number / count),
        }
    }

    /// Whether a step is too short to advance the time.
    #[inline]
    pub fn is_lost(&self, step: f64) -> bool {
        let span = (self.times.1 - self.times.0).abs();
        step.abs() <= 10.0 * f64::EPSILON * self.now.abs() + 1e-30 * span
    }
}

/// Integrates a system from one time to another, forwards or backwards.
///
/// The end state is [`Workspace::state`]. Nothing is allocated here.
///
/// # Errors
/// [`OdeError`], with the time that was reached.
#[inline]
pub fn integrate<Y: System + ?Sized, O: Observer + ?Sized>(
    system: &Y,
    times: (f64, f64),
    start: &[f64],
    options: &Options,
    workspace: &mut Workspace,
    observe: &mut O,
) -> Result<Statistics, OdeError> {
    let (method, tableau, part) = (workspace.method, workspace.tableau(), system.part());
    options.check(times, part)?;
    if start.len() != workspace.room.state.len() {
        return Err(bad_start(start.len(), workspace.room.state.len()));
    }
    if let Some(component) = first_bad(start, part) {
        return bad("start", format!("state {component} is not a finite number"));
    }
    let mut statistics = Statistics::default();
    workspace.room.state.copy_from_slice(start);
    if times.0 == times.1 {
        return Ok(statistics);
    }
    let max_step = options.max_step.unwrap_or(f64::INFINITY);
    let mut controller = Controller::new(tableau.order, tableau.beta, tableau.factors);
    let mut clock = Clock::new(times, options);
    let mut step = workspace.begin(system, times, options)?;
    let mut doubt = Doubt::new(options.max_steps);
    statistics.evaluations = 2;
    while clock.now != times.1 {
        let tried = statistics.steps + statistics.rejected;
        if tried >= options.max_steps {
            return Err(OdeError::TooManySteps { time: clock.now, steps: tried });
        }
        let to = clock.target(step, statistics.steps);
        let length = to - clock.now;
        (workspace.room.time, workspace.room.step) = (clock.now, length);
        system.attempt(method, &mut workspace.room);
        statistics.evaluations += tableau.tried();
        let bad = first_bad(&workspace.room.trial, part);
        let error = match clock.fixed {
            Some(_) => 0.0,
            None => workspace.estimate(system, options),
        };
        if error > 1.0 || error.is_nan() || bad.is_some() {
            let error = if bad.is_some() { f64::NAN } else { error };
            step = length * controller.reject(error);
            statistics.rejected += 1;
            if clock.fixed.is_some() || clock.is_lost(step) {
                return Err(failure(options, workspace, (clock.now, step), part));
            }
            continue;
        }
        system.correct(to, &mut workspace.room.trial)?;
        let dense = observe.wants_dense(clock.now, to);
        let is_doubted = doubt.is_due(statistics.steps);
        let gauged = is_doubted || observe.wants_stiffness();
        if gauged {
            workspace.keep_last_stage();
        }
        system.finish(method, &mut workspace.room, dense);
        statistics.evaluations += tableau.finished(dense);
        if gauged {
            let rate = workspace.fastest_rate(system, options);
            observe.stiffness(length, rate);
            if is_doubted && clock.fixed.is_none() {
                doubt.judge((times.1 - to) / length, (to, length, rate))?;
            }
        }
        let room = &mut workspace.room;
        observe.step(&Step {
            from: clock.now,
            to,
            before: &room.state,
            after: &room.trial,
            basis: Basis::Alternating,
            polynomial: if dense { &room.polynomial } else { &[] },
        });
        statistics.count(length, error, to == times.1);
        std::mem::swap(&mut room.state, &mut room.trial);
        let (first, last) = (start.len(), tableau.stages * start.len());
        room.slopes.copy_within(last..last + first, 0);
        clock.now = to;
        if observe.has_enough() {
            break;
        }
        step = (length * controller.accept(error)).clamp(-max_step, max_step);
    }
    Ok(statistics)
}

/// Why no step is short enough.
#[cold]
fn failure(
    options: &Options,
    workspace: &Workspace,
    (time, step): (f64, f64),
    part: usize,
) -> OdeError {
    let slopes = (0..workspace.tableau().stages).map(|number| workspace.slope(number));
    let mut states = std::iter::once(&workspace.room.trial[..]).chain(slopes);
    match states.find_map(|state| first_bad(state, part)) {
        Some(component) => OdeError::NotFinite { time, component },
        None => OdeError::StepTooSmall {
            time,
            step,
            component: worst(options, &workspace.room.state[..part], &workspace.room.error),
        },
    }
}
