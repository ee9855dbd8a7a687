//! A scene with its values behind [`Run`]: the names are gone, whole runs are left.

use super::{Run, Settings};
use crate::dispatch::{Task, dispatch};
use crate::hybrid::{self, Cycle, CycleError, HybridError, Motion};
use crate::measure::{self, Missing};
use crate::ode::{self, OdeError, Trajectory};
use crate::periodic::{self, Orbit, PeriodicError};
use crate::problem::{Equations, Refused, Scene, Span, Storage};
use crate::scalar::Scalar;
use crate::shape::Constant;

/// Checks the values of a scene and prepares it.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind<C: Scene + 'static>(scene: C) -> Result<Box<dyn Run>, Refused> {
    scene.check()?;
    let equations = scene.prepare::<f64>();
    Ok(Box::new(Bound { scene, equations }))
}

/// The scene with these values, SI units.
///
/// # Errors
/// If there are not as many as the scene has constants.
#[doc(hidden)]
pub fn with<C, const N: usize>(values: &[f64], make: fn(&[f64; N]) -> C) -> Result<C, Refused> {
    match values.try_into() {
        Ok(values) => Ok(make(values)),
        Err(_) => Err(Refused {
            name: "number of values".to_owned(),
            reason: format!("found {}, expected {N}", values.len()),
        }),
    }
}

/// Checks that values are finite and in their ranges.
///
/// # Errors
/// The first that is not, with the range in its unit.
pub fn check_values(constants: &[Constant], values: &[f64]) -> Result<(), Refused> {
    for (constant, value) in constants.iter().zip(values) {
        let quantity = &constant.quantity;
        let shown = |value: f64| match quantity.unit {
            "" => format!("{}", tidy(value)),
            unit => format!("{} {unit}", tidy(value / quantity.factor)),
        };
        let (low, high) = constant.range;
        let expected = match (low.is_finite(), high.is_finite()) {
            _ if !value.is_finite() => "a finite value".to_string(),
            _ if (low..=high).contains(value) => continue,
            (true, true) => format!("{} to {}", shown(low), shown(high)),
            (true, false) => format!("{} or more", shown(low)),
            _ => format!("{} or less", shown(high)),
        };
        return Err(Refused {
            name: quantity.name.to_string(),
            reason: format!("found {}, expected {expected}", shown(*value)),
        });
    }
    Ok(())
}

/// A number without the rounding of its unit's factor.
fn tidy(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value)
}

/// A scene with its values.
struct Bound<C: Scene> {
    scene: C,
    equations: C::Equations<f64>,
}

impl<C: Scene> Bound<C> {
    fn state(&self, values: &[f64]) -> <C::Equations<f64> as Equations<f64>>::State {
        let mut state =
            <C::Equations<f64> as Equations<f64>>::State::zeros(C::shape().states.len());
        for (slot, value) in state.as_mut().iter_mut().zip(values) {
            *slot = *value;
        }
        state
    }
}

impl<C: Scene + 'static> Run for Bound<C> {
    fn span(&self) -> Span {
        self.scene.span()
    }

    fn start(&self) -> Vec<f64> {
        self.scene.start()
    }

    fn drivers(&self, time: f64) -> Vec<f64> {
        let mut values = vec![0.0; C::shape().drivers.len()];
        self.equations.drivers(time, &mut values);
        values
    }

    fn margins(&self, time: f64, values: &mut [f64]) {
        self.equations.margins(time, values);
    }

    fn outputs_in(&self, _mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; C::shape().outputs.len()];
        self.equations
            .outputs(time, &self.state(state), &mut values);
        values
    }

    fn rates_in(&self, _mode: usize, time: f64, state: &[f64]) -> Vec<f64> {
        let mut rate = self.state(&[]);
        self.equations
            .derivative(&self.equations.instant(time), &self.state(state), &mut rate);
        rate.as_ref().to_vec()
    }

    fn periodic(&self, period: f64, settings: &Settings) -> Result<Orbit, PeriodicError> {
        periodic::solve(&self.scene, period, settings)
    }

    fn clock(&self, settings: &Settings) -> Result<Cycle, CycleError> {
        hybrid::clock_smooth(&self.scene, settings)
    }

    fn march(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Trajectory, OdeError> {
        ode::march_called(&self.scene, times, start, settings)
    }

    fn follow(
        &self,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        let integrated = ode::march_called(&self.scene, times, start, settings);
        Motion::smooth(integrated, times.0, start)
    }

    fn measure(&self, motion: &Motion) -> Vec<Result<f64, Missing>> {
        let sample = |_mode: usize, time: f64, state: &[f64], values: &mut [f64]| {
            self.equations.measured(time, &self.state(state), values);
        };
        let measures = |found: &[f64], values: &mut [f64]| self.equations.measures(found, values);
        measure::all(motion, C::shape(), &sample, &measures)
    }

    fn time_evaluation(&self, calls: usize) -> f64 {
        let scene = &self.scene;
        dispatch(Timing { scene, calls })
    }
}

/// The nanoseconds of one evaluation of the derivative.
pub(super) struct Timing<'a, C> {
    pub scene: &'a C,
    /// How many to measure.
    pub calls: usize,
}

impl<C: Scene> Task for Timing<'_, C> {
    type Output = f64;

    #[inline(always)]
    fn run<S: Scalar>(self) -> f64 {
        let equations = self.scene.prepare::<S>();
        let mut state = <C::Equations<S> as Equations<S>>::State::zeros(C::shape().states.len());
        for (slot, value) in state.as_mut().iter_mut().zip(self.scene.start()) {
            *slot = S::from_f64(value);
        }
        let mut rate = state.clone();
        let calls = self.calls.max(1);
        let clock = std::time::Instant::now();
        for call in 0..calls {
            let time = S::from_f64(call as f64 * 1e-6);
            let instant = equations.instant(std::hint::black_box(time));
            equations.derivative(&instant, std::hint::black_box(&state), &mut rate);
            std::hint::black_box(&rate);
        }
        clock.elapsed().as_secs_f64() * 1e9 / calls as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Quantity;

    const MASS: Constant = Constant {
        quantity: Quantity {
            name: "m",
            summary: "",
            unit: "g",
            factor: 1e-3,
            dimension: [(0, 1); 7],
        },
        is_dimension: false,
        default: 1e-3,
        tolerance: 0.0,
        distribution: crate::shape::Distribution::Normal,
        range: (1e-6, 10.0),
    };

    #[track_caller]
    fn check(value: f64, expected: &str) {
        let refused = check_values(&[MASS], &[value]).unwrap_err();
        assert_eq!(refused.to_string(), expected);
    }

    #[test]
    fn values_outside_their_range_are_refused_in_their_unit() {
        check(-1e-3, "m: found -1 g, expected 0.001 g to 10000 g");
        check(f64::NAN, "m: found NaN g, expected a finite value");
        check(f64::INFINITY, "m: found inf g, expected a finite value");
        assert_eq!(check_values(&[MASS], &[2e-3]), Ok(()));
    }
}
