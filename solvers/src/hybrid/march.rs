//! The motion of a scene with modes: what is asked for, by which method.

use super::carry::{Carry, Explicit, Stiff};
use super::erased::{Erased, Model, Own};
use super::error::HybridError;
use super::motion::Motion;
use super::problem::{Hybrid, Modes};
use super::run::Run;
use super::start;
use crate::ode::{Dop853, OdeError, Options, Taylor, Tsit5, state_from};
use crate::problem::Storage;
use crate::registry::{self, Settings};
use crate::shape::Shape;

/// The motion of a scene with modes from a start.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march<C: Hybrid>(
    scene: &C,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    march_in(scene, C::shape().first, times, start, settings)
}

/// The same from a start in any mode.
///
/// # Errors
/// [`HybridError`], with the motion so far.
pub fn march_in<C: Hybrid>(
    scene: &C,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    Way {
        mode,
        times,
        start,
        settings,
        is_checked: true,
    }
    .of(scene)
}

/// What is asked for.
pub(super) struct Way<'a> {
    pub mode: usize,
    pub times: (f64, f64),
    pub start: &'a [f64],
    pub settings: &'a Settings,
    /// Whether the start has to fit to the mode.
    pub is_checked: bool,
}

impl Way<'_> {
    /// The motion of a scene.
    pub fn of<C: Hybrid>(&self, scene: &C) -> Result<Motion, HybridError> {
        self.follow(&mut Own::new(scene.modal::<f64>()), C::shape())
    }

    /// The motion of any equations. States of a usual length, one to three coordinates with their speeds, are arrays.
    #[inline(never)]
    fn follow(&self, model: &mut dyn Model, shape: &Shape) -> Result<Motion, HybridError> {
        match model.states() {
            2 => self.by_method::<[f64; 2]>(model, shape),
            4 => self.by_method::<[f64; 4]>(model, shape),
            6 => self.by_method::<[f64; 6]>(model, shape),
            _ => self.by_method::<Vec<f64>>(model, shape),
        }
    }

    fn by_method<V: Storage<f64>>(
        &self,
        model: &mut dyn Model,
        shape: &Shape,
    ) -> Result<Motion, HybridError> {
        match self.settings.method {
            registry::Method::Tsit5 => self.march::<V, Explicit<V, Tsit5>>(model, shape),
            registry::Method::Dop853 => self.march::<V, Explicit<V, Dop853>>(model, shape),
            registry::Method::Taylor => self.march::<V, Taylor<V>>(model, shape),
            _ => self.march::<V, Stiff>(model, shape),
        }
    }

    fn march<'a, V: Storage<f64>, M: Carry<Erased<'a, V>>>(
        &self,
        model: &'a mut dyn Model,
        shape: &Shape,
    ) -> Result<Motion, HybridError> {
        let (mode, times, settings) = (self.mode, self.times, self.settings);
        let mut equations = Erased::<V>::new(model);
        start::check_mode(shape, mode)?;
        equations.enter(mode);
        let mut motion = Motion {
            mode,
            ..Motion::at_rest(times.0, self.start)
        };
        let options = Options::of(settings, shape.scales);
        let begun = (|| {
            options.check(times, shape.scales.len())?;
            if times.1 < times.0 {
                return Err(OdeError::BadOption {
                    name: "times",
                    reason: format!(
                        "from {} s to {} s runs backwards, and events happen forwards",
                        times.0, times.1
                    ),
                });
            }
            state_from::<f64, _>(&equations, self.start)
        })();
        let state = match begun {
            Ok(state) => state,
            Err(error) => {
                return Err(HybridError::Ode {
                    error,
                    mode,
                    motion: Box::new(motion),
                });
            }
        };
        if self.is_checked {
            start::check(&equations, shape, times.0, &state)?;
        }
        let mut method = M::new(&equations, settings);
        let mut run = Run::new(equations, shape, state, options, times);
        match run.through(&mut motion, &mut method) {
            Ok(()) => Ok(motion),
            Err(end) => Err(end.with(motion)),
        }
    }
}
