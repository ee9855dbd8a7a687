//! The motion over one period, in states over their scales.

use super::error::PeriodicError;
use crate::dispatch::{Task, dispatch};
use crate::hybrid::{Cycle, CycleError, Motion, cycle_smooth, variations};
use crate::ode::{
    Bundle, Dop853, Method, Observer, OdeError, Options, Step, Trajectory, Tsit5, Varied,
    Workspace, bad_start, integrate, march_called, state_from,
};
use crate::problem::{Scene, Storage};
use crate::registry::{self, Settings};
use crate::scalar::Scalar;
use nalgebra::{DMatrix, DVector};
use std::marker::PhantomData;

/// What the search for a motion that repeats asks of a scene. The search itself is compiled once for all scenes.
pub(super) trait Flow {
    /// Whether the equations are affine in the state.
    fn is_linear(&self) -> bool;

    /// Sizes of the states.
    fn scales(&self) -> &'static [f64];

    /// The declared start values, or zeros if there are none.
    fn guess(&self) -> Result<DVector<f64>, PeriodicError>;

    /// Integrates the motion and its variations over one period.
    fn turn(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError>;

    /// Integrates the motion alone over one period.
    fn march(&self, start: &DVector<f64>, rtol: f64) -> Result<Trajectory, OdeError>;

    /// The motion that attracts the one from a start.
    fn attractor(&self, start: &DVector<f64>, rtol: f64) -> Result<Cycle, CycleError>;

    /// The same scene over several periods.
    fn over(&self, periods: usize) -> Box<dyn Flow + '_>;
}

/// A scene with its period.
pub(super) struct Period<'a, C: Scene> {
    /// The scene.
    pub scene: &'a C,
    /// The period.
    pub period: f64,
    /// The method, and its accuracy where nothing else is asked for.
    pub settings: &'a Settings,
}

/// What one period makes of a start. All vectors in states over their scales.
pub(super) struct Return {
    /// The start.
    pub start: DVector<f64>,
    /// The state after one period.
    pub end: DVector<f64>,
    /// `Φ = ∂end/∂start`.
    pub matrix: DMatrix<f64>,
    /// Largest absolute value of each state on the way.
    pub peak: DVector<f64>,
}

impl Return {
    /// What is missing to a motion that repeats, `end - start`.
    pub fn gap(&self) -> DVector<f64> {
        &self.end - &self.start
    }

    /// Size of the motion: 1 or more, as tolerances are relative to the scales at least.
    pub fn size(&self) -> f64 {
        1.0 + self.peak.iter().copied().fold(0.0, f64::max)
    }
}

impl<C: Scene> Flow for Period<'_, C> {
    fn is_linear(&self) -> bool {
        C::shape().is_linear
    }

    fn scales(&self) -> &'static [f64] {
        C::shape().scales
    }

    fn guess(&self) -> Result<DVector<f64>, PeriodicError> {
        let start = self.scene.start();
        match start.len() {
            0 => Ok(DVector::zeros(C::shape().states.len())),
            states if states == C::shape().states.len() => Ok(over_scales::<C, f64>(&start)),
            states => Err(bad_start(states, C::shape().states.len()).into()),
        }
    }

    fn turn(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError> {
        use registry::Method;
        match self.settings.method {
            // A steady state shows no transient that an automatic choice would have to look out for.
            Method::Tsit5 | Method::Dop853 | Method::Auto => dispatch(Turn {
                flow: self,
                start,
                rtol,
            }),
            Method::Radau | Method::Rosenbrock | Method::Taylor => self.turn_apart(start, rtol),
        }
    }

    fn march(&self, start: &DVector<f64>, rtol: f64) -> Result<Trajectory, OdeError> {
        let times = (0.0, self.period);
        march_called(
            self.scene,
            times,
            &unscaled::<C>(start),
            &self.settings.at(rtol),
        )
    }

    fn attractor(&self, start: &DVector<f64>, rtol: f64) -> Result<Cycle, CycleError> {
        let start = unscaled::<C>(start);
        cycle_smooth(self.scene, &start, self.period, &self.settings.at(rtol))
    }

    fn over(&self, periods: usize) -> Box<dyn Flow + '_> {
        Box::new(Self {
            period: self.period * periods as f64,
            ..*self
        })
    }
}

impl<C: Scene> Period<'_, C> {
    /// [`Flow::turn`] by a method that integrates no variations: they follow along the motion.
    fn turn_apart(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError> {
        let motion = Motion::of(self.march(start, rtol)?);
        let matrix = variations(self.scene, &motion, &self.settings.at(rtol))?;
        let trajectory = motion.pieces.iter().map(|piece| &piece.trajectory);
        let mut peak = start.abs();
        for (trajectory, time) in
            trajectory.flat_map(|one| one.times().iter().map(move |t| (one, *t)))
        {
            let state = over_scales::<C, f64>(&trajectory.at(time));
            peak.zip_apply(&state, |size, value| *size = size.max(value.abs()));
        }
        let scaled = |row: usize, column: usize| {
            matrix[(row, column)] * (C::shape().scales[column] / C::shape().scales[row])
        };
        Ok(Return {
            start: start.clone(),
            end: over_scales::<C, f64>(&motion.end),
            matrix: DMatrix::from_fn(C::shape().states.len(), C::shape().states.len(), scaled),
            peak,
        })
    }
}

/// The task of [`Flow::turn`].
struct Turn<'a, 'b, C: Scene> {
    flow: &'a Period<'b, C>,
    start: &'a DVector<f64>,
    rtol: f64,
}

impl<C: Scene> Task for Turn<'_, '_, C> {
    type Output = Result<Return, OdeError>;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Self::Output {
        match self.flow.settings.method {
            registry::Method::Tsit5 => self.turn::<S, Tsit5>(),
            _ => self.turn::<S, Dop853>(),
        }
    }
}

impl<C: Scene> Turn<'_, '_, C> {
    #[inline(always)]
    fn turn<S: Scalar, M: Method>(&self) -> Result<Return, OdeError> {
        let equations = self.flow.scene.prepare::<S>();
        let varied = Varied {
            equations: &equations,
            scales: Some(C::shape().scales),
        };
        let state = state_from::<S, _>(&equations, &unscaled::<C>(self.start))?;
        let begin = varied.start::<S>(&state);
        let options = Options::of(&self.flow.settings.at(self.rtol), C::shape().scales);
        let mut workspace = Workspace::<Bundle<_>, M>::new::<S, _>(&varied);
        let mut peak = Peak::<C, S> {
            sizes: self.start.abs(),
            types: PhantomData,
        };
        integrate(
            &varied,
            (0.0, self.flow.period),
            &begin,
            &options,
            &mut workspace,
            &mut peak,
        )?;
        let Bundle { motion, columns } = workspace.state();
        let scaled = |row: usize, column: usize| {
            columns[column].as_ref()[row].to_f64()
                * (C::shape().scales[column] / C::shape().scales[row])
        };
        Ok(Return {
            start: self.start.clone(),
            end: over_scales::<C, S>(motion.as_ref()),
            matrix: DMatrix::from_fn(C::shape().states.len(), C::shape().states.len(), scaled),
            peak: peak.sizes,
        })
    }
}

/// A state from a vector over its scales.
fn unscaled<C: Scene>(scaled: &DVector<f64>) -> Vec<f64> {
    let states = scaled.iter().zip(C::shape().scales);
    states.map(|(value, scale)| value * scale).collect()
}

/// A state over its scales.
fn over_scales<C: Scene, S: Scalar>(state: &[S]) -> DVector<f64> {
    DVector::from_iterator(
        state.len(),
        state
            .iter()
            .zip(C::shape().scales)
            .map(|(value, scale)| value.to_f64() / scale),
    )
}

/// Keeps the largest absolute value of each state of a motion, over its scale.
struct Peak<C, S> {
    /// The largest so far.
    sizes: DVector<f64>,
    /// The scene and the scalar type.
    types: PhantomData<(C, S)>,
}

impl<C: Scene, S: Scalar, Y: Storage<S>> Observer<Bundle<Y>> for Peak<C, S> {
    #[inline(always)]
    fn step(&mut self, step: &Step<'_, Bundle<Y>>) {
        let states = step.after.motion.as_ref().iter().zip(C::shape().scales);
        for (size, (value, scale)) in self.sizes.iter_mut().zip(states) {
            *size = size.max(value.to_f64().abs() / scale);
        }
    }
}
