//! A scene with modes and its values behind [`Run`].

use super::bind::Timing;
use super::{Run, Settings};
use crate::dispatch::Task;
use crate::hybrid::{
    self, Cycle, CycleError, Hybrid, HybridError, Motion, Sensitive, in_each_mode,
};
use crate::measure::{self, Missing};
use crate::ode::{OdeError, Trajectory};
use crate::periodic::{Orbit, PeriodicError};
use crate::problem::{Equations, Refused, Span, Storage};

/// Checks the values of a scene with modes and prepares it.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind_hybrid<C: Hybrid + 'static>(scene: C) -> Result<Box<dyn Run>, Refused> {
    scene.check()?;
    let modes = in_each_mode(&scene);
    Ok(Box::new(Bound {
        scene,
        modes,
        cycle: None,
    }))
}

/// The same for a scene whose task is a motion that repeats.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind_cycle<C: Hybrid + 'static>(scene: C) -> Result<Box<dyn Run>, Refused>
where
    C::Modal<f64>: Sensitive<f64>,
{
    scene.check()?;
    let modes = in_each_mode(&scene);
    let cycle: Finder<C> = |scene, period, settings| match period {
        Some(period) => hybrid::cycle(scene, period, settings),
        None => hybrid::clock(scene, settings),
    };
    let cycle = Some(cycle);
    Ok(Box::new(Bound {
        scene,
        modes,
        cycle,
    }))
}

/// Finds a motion that repeats, after a period or by itself.
type Finder<C> = fn(&C, Option<f64>, &Settings) -> Result<Cycle, CycleError>;

/// A scene with modes and its values.
struct Bound<C: Hybrid> {
    scene: C,
    /// The equations in each mode.
    modes: Vec<C::Modal<f64>>,
    /// What finds a motion that repeats, where that is the task.
    cycle: Option<Finder<C>>,
}

impl<C: Hybrid> Bound<C> {
    fn state(values: &[f64]) -> <C::Modal<f64> as Equations<f64>>::State {
        let mut state = <C::Modal<f64> as Equations<f64>>::State::zeros(C::shape().states.len());
        for (slot, value) in state.as_mut().iter_mut().zip(values) {
            *slot = *value;
        }
        state
    }
}

impl<C: Hybrid + 'static> Run for Bound<C> {
    fn span(&self) -> Span {
        self.scene.span()
    }

    fn start(&self) -> Vec<f64> {
        self.scene.start()
    }

    fn first_mode(&self) -> usize {
        C::shape().first
    }

    fn mode_count(&self) -> usize {
        C::shape().modes.len()
    }

    fn drivers(&self, time: f64) -> Vec<f64> {
        let mut values = vec![0.0; C::shape().drivers.len()];
        self.modes[C::shape().first].drivers(time, &mut values);
        values
    }

    fn margins(&self, time: f64, values: &mut [f64]) {
        self.modes[C::shape().first].margins(time, values);
    }

    fn outputs_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; C::shape().outputs.len()];
        self.modes[mode].outputs(time, &Self::state(state), &mut values);
        values
    }

    fn rates_in(&self, mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let equations = &self.modes[mode];
        let mut rate = Self::state(&[]);
        equations.derivative(&equations.instant(time), &Self::state(state), &mut rate);
        rate.as_ref().to_vec()
    }

    fn periodic(&self, _period: f64, _settings: &Settings) -> Result<Orbit, PeriodicError> {
        Err(PeriodicError::Ode(has_modes()))
    }

    fn cycle(&self, period: f64, settings: &Settings) -> Result<Cycle, CycleError> {
        match self.cycle {
            Some(find) => find(&self.scene, Some(period), settings),
            None => Err(CycleError::NoTask),
        }
    }

    fn clock(&self, settings: &Settings) -> Result<Cycle, CycleError> {
        match self.cycle {
            Some(find) => find(&self.scene, None, settings),
            None => Err(CycleError::NoTask),
        }
    }

    fn march(
        &self,
        _times: (f64, f64),
        _start: &[f64],
        _settings: &Settings,
    ) -> Result<Trajectory, OdeError> {
        Err(has_modes())
    }

    fn follow(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        hybrid::march(&self.scene, times, start, settings)
    }

    fn follow_in(
        &self,
        mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        hybrid::march_in(&self.scene, mode, times, start, settings)
    }

    fn measure(&self, motion: &Motion) -> Vec<Result<f64, Missing>> {
        let sample = |mode: usize, time: f64, state: &[f64], values: &mut [f64]| {
            self.modes[mode].measured(time, &Self::state(state), values);
        };
        let measures = |found: &[f64], values: &mut [f64]| {
            self.modes[C::shape().first].measures(found, values)
        };
        measure::all(motion, C::shape(), &sample, &measures)
    }

    fn time_evaluation(&self, calls: usize) -> f64 {
        // Motions with events are followed on plain numbers.
        let scene = &self.scene;
        Timing { scene, calls }.run::<f64>()
    }
}

/// The motion of a scene with modes is no single trajectory.
fn has_modes() -> OdeError {
    OdeError::BadOption {
        name: "scene",
        reason: "it has modes, so its motion has to be followed from event to event".to_string(),
    }
}
