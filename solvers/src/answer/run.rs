//! What is asked of a scene with its values, whichever it is.

use crate::hybrid::{self, Cycle, CycleError, HybridError, Motion, Request};
use crate::measure::{self, Missing, Probe};
use crate::model::{Flow, Model, held};
use crate::ode::{self, OdeError, Trajectory};
use crate::periodic::{self, Orbit, PeriodicError};
use crate::problem::Phase;
use crate::settings::Settings;
use crate::shape::Shape;
use crate::smooth;

impl dyn Model + '_ {
    /// Positions of the drivers at a time.
    pub fn drivers(&self, time: f64) -> Vec<f64> {
        let mut values = vec![0.0; self.shape().drivers.len()];
        self.reports().drivers(time, &mut values);
        values
    }

    /// By how much the loops that the motion carries along close in a mode at a time and state, in SI units: less than zero
    /// where they do not, not a number where one before does not. Shape:
    /// [`Shape::carried`](crate::shape::Shape::carried).
    pub fn margins_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.shape().carried.len()];
        self.reports().margins(Phase::of(mode), time, state, &mut values);
        values
    }

    /// The first time of the task at which a driver has a position, see
    /// [`Span::time_of`](crate::problem::Span::time_of).
    ///
    /// # Errors
    /// The lowest and the highest position that it has; neither is a number where there is no such driver.
    pub fn time_of(&self, driver: usize, position: f64) -> Result<f64, (f64, f64)> {
        let at = |time| self.drivers(time).get(driver).copied();
        self.span().time_of(|time| at(time).unwrap_or(f64::NAN), position)
    }

    /// All outputs in a mode at a time and state.
    pub fn outputs_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        self.outputs_on(Phase::of(mode), time, state)
    }

    /// All outputs in a phase at a time and state: on which side of a switching surface that is, values beside it do not say.
    pub(super) fn outputs_on(&self, phase: Phase<'_, f64>, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.shape().outputs.len()];
        held(phase, &mut values, |phase, values| {
            self.reports().outputs(phase, time, state, values);
        });
        values
    }

    /// All outputs at a time and state, in the first mode.
    pub fn outputs(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.outputs_in(self.shape().first, time, state)
    }

    /// Time derivative of the state in a mode.
    pub fn rates_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        self.rates_on(Phase::of(mode), time, state)
    }

    /// Time derivative of the state in a phase.
    pub(super) fn rates_on(&self, phase: Phase<'_, f64>, time: f64, state: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; state.len()];
        Flow::on(self, phase.mode, phase.sides).rates(time, state, &mut rates);
        rates
    }

    /// Time derivative of the state, in the first mode.
    pub fn rates(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.rates_in(self.shape().first, time, state)
    }

    /// The periodic steady state of a scene without events.
    ///
    /// # Errors
    /// See [`PeriodicError`].
    pub fn periodic(&self, period: f64, settings: &Settings) -> Result<Orbit, PeriodicError> {
        match self.events() {
            Some(_) => Err(PeriodicError::Ode(has_modes())),
            None => periodic::of(self, &self.start(), period, settings),
        }
    }

    /// The motion that repeats, through all its events.
    ///
    /// # Errors
    /// See [`CycleError`]; [`CycleError::NoTask`] where it is not known how events depend on the state.
    pub fn cycle(&self, period: f64, settings: &Settings) -> Result<Cycle, CycleError> {
        let start = (self.shape().first, &self.start()[..]);
        hybrid::cycle_of(self, start, period, settings)
    }

    /// The motion that repeats by itself, with its period.
    ///
    /// # Errors
    /// See [`CycleError`]; [`CycleError::NoTask`] where it is not known how events depend on the state.
    pub fn clock(&self, settings: &Settings) -> Result<Cycle, CycleError> {
        let start = (self.shape().first, &self.start()[..]);
        hybrid::clock_of(self, start, settings)
    }

    /// The motion of a scene without events from a start.
    ///
    /// # Errors
    /// See [`OdeError`].
    pub fn march(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Trajectory, OdeError> {
        match self.events() {
            Some(_) => Err(has_modes()),
            None => smooth::follow(self, times, start, settings),
        }
    }

    /// The motion from a start, through all its events; in one piece where there are none.
    ///
    /// # Errors
    /// See [`HybridError`].
    pub fn follow(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        self.follow_in(self.shape().first, times, start, settings)
    }

    /// The motion through all its events, from a start in another mode than the first.
    ///
    /// # Errors
    /// See [`HybridError`].
    pub fn follow_in(
        &self,
        mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        let way = Request { mode, times, start, settings, is_checked: true };
        way.of(self)
    }

    /// The measures of a run, in the order of the file, SI units.
    pub fn measure(&self, motion: &Motion) -> Vec<Result<f64, Missing>> {
        self.measured(|shape, sample, measures| measure::all(motion, shape, sample, measures))
    }

    /// By how much each measure differs where one of its primitives is off by a part of itself, see [`measure::disturbed`].
    pub fn disturbed(&self, motion: &Motion, part: f64) -> Vec<f64> {
        self.measured(|shape, sample, measures| {
            measure::disturbed(motion, shape, sample, measures, part)
        })
    }

    /// Something of the measures: from the shape, what they look at, and what they make of it.
    fn measured<T>(
        &self,
        of: impl FnOnce(&Shape, &Probe<'_>, &dyn Fn(&[f64], &mut [f64])) -> T,
    ) -> T {
        let reports = self.reports();
        let sample = |phase: Phase<'_, f64>, time: f64, state: &[f64], values: &mut [f64]| {
            held(phase, values, |phase, values| reports.measured(phase, time, state, values));
        };
        of(self.shape(), &sample, &|found, values| reports.measures(found, values))
    }

    /// Nanoseconds of one evaluation of the derivative with its time-only values, as the steps of the explicit methods make
    /// them, measured over this many calls.
    pub fn time_evaluation(&self, calls: usize) -> f64 {
        ode::time_evaluation(&Flow::new(self, self.shape().first), &self.start(), calls)
    }
}

/// The motion of a scene with modes is no single trajectory.
fn has_modes() -> OdeError {
    OdeError::BadOption {
        name: "scene",
        reason: "it has modes, so its motion has to be followed from event to event".to_string(),
    }
}
