//! A motion that was computed, as a function of time.

mod powers;

use super::explicit::Statistics;
use super::observer::{Basis, Observer, Step};
use crate::settings::Method;

/// Steps for which there is room at first.
const FIRST_STEPS: usize = 12;
/// Numbers of them for which there is room.
const FIRST_NUMBERS: usize = 192;
/// Most numbers of a motion that is copied where it is finished.
const SHORT: usize = 512;

/// Where an automatic choice changed the method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// When, in seconds.
    pub time: f64,
    /// To which one.
    pub to: Method,
}

/// A motion that was computed: a polynomial for each step.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// What the integration took.
    pub statistics: Statistics,
    /// Where an automatic choice changed the method.
    pub switches: Vec<Switch>,
    /// Number of states.
    states: usize,
    /// Number of coefficients of each polynomial beside the state at its begin.
    degree: usize,
    /// What the coefficients belong to.
    basis: Basis,
    /// Times of the steps, the begin first.
    times: Vec<f64>,
    /// For each step the state at its begin and the coefficients, `(1 + degree) * states` numbers; then the state at the
    /// end.
    coefficients: Vec<f64>,
    /// Length of the last step as it was computed: the motion may end within it.
    last: f64,
}

impl Trajectory {
    /// The state at a time; beyond the ends of the motion, the state at the nearest end.
    pub fn at(&self, time: f64) -> Vec<f64> {
        let mut state = vec![0.0; self.states];
        self.at_into(time, &mut state);
        state
    }

    /// Writes the state at a time into `state`.
    pub fn at_into(&self, time: f64, state: &mut [f64]) {
        self.at_beside(&mut 0, time, state);
    }

    /// Writes the state at a time, looked for at a step first, which is left where the time has been found.
    pub(crate) fn at_beside(&self, near: &mut usize, time: f64, state: &mut [f64]) {
        let Some((step, part)) = self.locate_beside(*near, time) else {
            state.copy_from_slice(self.end());
            return;
        };
        *near = step;
        for (index, value) in state.iter_mut().enumerate() {
            *value = self.coefficient(step, 0, index) + self.change(step, index, part).0;
        }
    }

    /// The time derivative of the continuous solution at a time, one order less accurate than the state.
    pub fn derivative_at(&self, time: f64) -> Vec<f64> {
        let Some((step, part)) = self.locate(time) else {
            return vec![0.0; self.states];
        };
        let length = self.length(step);
        (0..self.states).map(|index| self.change(step, index, part).1 / length).collect()
    }

    /// The times of the steps, the begin first.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The state at the end.
    pub fn end(&self) -> &[f64] {
        &self.coefficients[self.coefficients.len() - self.states..]
    }

    /// None yet, with room.
    fn empty(times: Vec<f64>, coefficients: Vec<f64>) -> Self {
        Self {
            statistics: Statistics::default(),
            switches: Vec::new(),
            states: 0,
            degree: 0,
            basis: Basis::Alternating,
            times,
            coefficients,
            last: 0.0,
        }
    }

    /// Makes room for more steps, of each of which so many numbers are kept.
    #[cold]
    fn grow(&mut self, numbers: usize) {
        let steps = self.times.len().max(FIRST_NUMBERS / numbers.max(1));
        self.coefficients.reserve(steps * numbers);
    }

    /// Number of states.
    pub fn states(&self) -> usize {
        self.states
    }

    /// The step in which a time lies, if it is one or the next one.
    fn locate_beside(&self, near: usize, time: f64) -> Option<(usize, f64)> {
        let begins = self.times.get(near..near + 3);
        match begins
            .and_then(|begins| begins.windows(2).position(|step| step[0] <= time && time < step[1]))
        {
            Some(more) => Some((near + more, self.part(near + more, time))),
            None => self.locate(time),
        }
    }

    /// Where in a step a time lies, from 0 to 1.
    fn part(&self, step: usize, time: f64) -> f64 {
        let (from, to) = (self.times[step], self.times[step + 1]);
        let length = self.length(step);
        ((time - from) / length).clamp(0.0, (to - from) / length)
    }

    /// The step in which a time lies, and where in it, from 0 to 1. `None` if there are no steps.
    fn locate(&self, time: f64) -> Option<(usize, f64)> {
        let steps = self.times.len() - 1;
        let is_forward = self.times[steps] >= self.times[0];
        let passed = self
            .times
            .partition_point(|begin| if is_forward { *begin <= time } else { *begin >= time });
        let step = passed.saturating_sub(1).min(steps.checked_sub(1)?);
        Some((step, self.part(step, time)))
    }

    /// Length of a step as it was computed.
    fn length(&self, step: usize) -> f64 {
        match step + 2 == self.times.len() {
            true => self.last,
            false => self.times[step + 1] - self.times[step],
        }
    }

    /// Number `row` of the coefficients of a state in a step.
    #[inline]
    fn coefficient(&self, step: usize, row: usize, index: usize) -> f64 {
        self.coefficients[(step * (1 + self.degree) + row) * self.states + index]
    }

    /// What the polynomial adds to the begin, and its derivative, by Horner's rule.
    #[inline]
    fn change(&self, step: usize, index: usize, part: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for row in (1..=self.degree).rev() {
            let (factor, change) = match self.basis {
                Basis::Alternating if row % 2 == 0 => (1.0 - part, -1.0),
                _ => (part, 1.0),
            };
            let sum = value + self.coefficient(step, row, index);
            slope = slope * factor + sum * change;
            value = sum * factor;
        }
        (value, slope)
    }
}

/// An observer that keeps all steps for a [`Trajectory`].
#[derive(Clone, Debug)]
pub struct Recorder {
    /// The motion so far.
    trajectory: Trajectory,
}

impl Recorder {
    /// Starts at a time and state.
    pub fn new(time: f64, start: &[f64]) -> Self {
        let times = Vec::with_capacity(1 + FIRST_STEPS);
        let coefficients = Vec::with_capacity(FIRST_NUMBERS + start.len());
        let mut recorder = Self { trajectory: Trajectory::empty(times, coefficients) };
        recorder.restart(time, start);
        recorder
    }

    /// Starts again at a time and state, in the room that there is.
    pub(crate) fn restart(&mut self, time: f64, start: &[f64]) {
        let trajectory = &mut self.trajectory;
        trajectory.states = start.len();
        trajectory.degree = 0;
        trajectory.basis = Basis::Alternating;
        trajectory.last = 0.0;
        trajectory.times.clear();
        trajectory.times.push(time);
        trajectory.coefficients.clear();
        trajectory.coefficients.extend_from_slice(start);
    }

    /// Ends the motion at a time within the last step.
    pub fn cut(&mut self, time: f64, state: &[f64]) {
        let trajectory = &mut self.trajectory;
        if let Some(end) = trajectory.times.last_mut() {
            *end = time;
        }
        let begin = trajectory.coefficients.len() - trajectory.states;
        trajectory.coefficients[begin..].copy_from_slice(state);
    }

    /// The motion, with what it took.
    pub fn finish(mut self, statistics: Statistics) -> Trajectory {
        self.trajectory.statistics = statistics;
        self.trajectory
    }

    /// The trajectory that is recorded; what records the next motion is left. A short motion is copied into room of its
    /// own size, so that many of
    /// them take no more memory than they need.
    pub(crate) fn take(&mut self, statistics: Statistics) -> Trajectory {
        let mut trajectory = match self.trajectory.coefficients.len() <= SHORT {
            true => self.trajectory.clone(),
            false => {
                let empty = Trajectory::empty(Vec::new(), Vec::new());
                std::mem::replace(&mut self.trajectory, empty)
            }
        };
        trajectory.statistics = statistics;
        trajectory
    }
}

impl Observer for Recorder {
    #[inline]
    fn wants_dense(&mut self, _from: f64, _to: f64) -> bool {
        true
    }

    #[inline]
    fn step(&mut self, step: &Step<'_>) {
        let trajectory = &mut self.trajectory;
        let states = step.before.len();
        let degree = step.polynomial.len() / states.max(1);
        if trajectory.times.len() == 1 {
            (trajectory.degree, trajectory.basis) = (degree, step.basis);
        } else if (trajectory.degree, trajectory.basis) != (degree, step.basis) {
            return self.step_of_another_kind(step);
        }
        trajectory.times.push(step.to);
        trajectory.last = step.to - step.from;
        let begin = trajectory.coefficients.len() - states;
        let more = step.polynomial.len() + states;
        if trajectory.coefficients.capacity() < trajectory.coefficients.len() + more {
            trajectory.grow(more);
        }
        // An event may have cut the step before short of where this one begins.
        trajectory.coefficients[begin..].copy_from_slice(step.before);
        trajectory.coefficients.extend_from_slice(step.polynomial);
        trajectory.coefficients.extend_from_slice(step.after);
    }
}
