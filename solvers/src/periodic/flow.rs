//! The motion over one period, in states over their scales.

use super::error::PeriodicError;
use crate::ode::{
    Bundle, Method, Observer, OdeError, Options, Step, Trajectory, Varied, Workspace, integrate,
    march, state_from,
};
use crate::problem::{Equations, Scene, Storage};
use crate::registry::Settings;
use crate::scalar::Scalar;
use nalgebra::{DMatrix, DVector};
use std::marker::PhantomData;

/// A scene with its period, ready to be integrated by a method on a scalar type.
pub(super) struct Flow<'a, C: Scene, S: Scalar, M> {
    /// The scene.
    scene: &'a C,
    /// Its equations.
    equations: C::Equations<S>,
    /// The period.
    period: f64,
    /// The method.
    method: PhantomData<M>,
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

impl<'a, C: Scene, S: Scalar, M: Method> Flow<'a, C, S, M> {
    /// A scene with its period.
    #[inline(always)]
    pub fn new(scene: &'a C, period: f64) -> Self {
        Self {
            scene,
            equations: scene.prepare(),
            period,
            method: PhantomData,
        }
    }

    /// The declared start values, or zeros if there are none.
    pub fn guess(&self, scene: &C) -> Result<DVector<f64>, PeriodicError> {
        let start = scene.start();
        if start.is_empty() {
            return Ok(DVector::zeros(C::STATES));
        }
        let state = state_from::<S, _>(&self.equations, &start)?;
        Ok(over_scales::<C, S>(state.as_ref()))
    }

    /// Integrates the motion and its variations over one period.
    #[inline(always)]
    pub fn turn(&self, start: &DVector<f64>, rtol: f64) -> Result<Return, OdeError> {
        let varied = Varied {
            equations: &self.equations,
            scales: Some(C::SCALES),
        };
        let state = self.state(start)?;
        let begin = varied.start::<S>(&state);
        let options = Options::scaled(rtol, C::SCALES);
        let mut workspace = Workspace::<Bundle<_>, M>::new::<S, _>(&varied);
        let mut peak = Peak::<C, S> {
            sizes: start.abs(),
            types: PhantomData,
        };
        integrate(
            &varied,
            (0.0, self.period),
            &begin,
            &options,
            &mut workspace,
            &mut peak,
        )?;
        let Bundle { motion, columns } = workspace.state();
        let scaled = |row: usize, column: usize| {
            columns[column].as_ref()[row].to_f64() * (C::SCALES[column] / C::SCALES[row])
        };
        Ok(Return {
            start: start.clone(),
            end: over_scales::<C, S>(motion.as_ref()),
            matrix: DMatrix::from_fn(C::STATES, C::STATES, scaled),
            peak: peak.sizes,
        })
    }

    /// Integrates the motion alone over one period. It goes the way of every motion, through the choice of the
    /// instruction set, so that its code is there once.
    pub fn march(&self, start: &DVector<f64>, rtol: f64) -> Result<Trajectory, OdeError> {
        let values: Vec<f64> = start
            .iter()
            .zip(C::SCALES)
            .map(|(value, scale)| value * scale)
            .collect();
        let settings = Settings {
            method: M::NAME,
            rtol,
        };
        march(self.scene, (0.0, self.period), &values, &settings)
    }

    /// The state of the equations from a vector over its scales.
    fn state(
        &self,
        scaled: &DVector<f64>,
    ) -> Result<<C::Equations<S> as Equations<S>>::State, OdeError> {
        let values: Vec<f64> = scaled
            .iter()
            .zip(C::SCALES)
            .map(|(value, scale)| value * scale)
            .collect();
        state_from::<S, _>(&self.equations, &values)
    }
}

/// A state over its scales.
fn over_scales<C: Scene, S: Scalar>(state: &[S]) -> DVector<f64> {
    DVector::from_iterator(
        state.len(),
        state
            .iter()
            .zip(C::SCALES)
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
        let states = step.after.motion.as_ref().iter().zip(C::SCALES);
        for (size, (value, scale)) in self.sizes.iter_mut().zip(states) {
            *size = size.max(value.to_f64().abs() / scale);
        }
    }
}
