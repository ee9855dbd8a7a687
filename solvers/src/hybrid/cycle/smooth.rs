//! A scene without modes or events, for the search.

use super::super::{HybridError, Motion};
use super::flow::{Flow, Local};
use crate::ode::march_called;
use crate::problem::{Equations, Scene, Storage};
use crate::registry::Settings;

/// A scene without events, with its values.
pub(super) struct Smooth<'a, C: Scene> {
    scene: &'a C,
    equations: C::Equations<f64>,
}

impl<'a, C: Scene> Smooth<'a, C> {
    pub(super) fn new(scene: &'a C) -> Self {
        Self {
            scene,
            equations: scene.prepare(),
        }
    }
}

impl<C: Scene> Flow for Smooth<'_, C> {
    fn scales(&self) -> &'static [f64] {
        C::shape().scales
    }

    fn follow(
        &self,
        _mode: usize,
        times: (f64, f64),
        start: &[f64],
        settings: &Settings,
    ) -> Result<Motion, HybridError> {
        Motion::smooth(
            march_called(self.scene, times, start, settings),
            times.0,
            start,
        )
    }

    fn local(&self, _mode: usize, _sides: &[f64]) -> Box<dyn Local + '_> {
        Box::new(Only::<C>(&self.equations))
    }
}

/// The only equations of a scene.
struct Only<'a, C: Scene>(&'a C::Equations<f64>);

type State<C> = <<C as Scene>::Equations<f64> as Equations<f64>>::State;

impl<C: Scene> Only<'_, C> {
    fn state(values: &[f64]) -> State<C> {
        let mut state = State::<C>::zeros(C::shape().states.len());
        state.as_mut().copy_from_slice(values);
        state
    }
}

impl<C: Scene> Local for Only<'_, C> {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let mut rates = Self::state(rate);
        self.0
            .derivative(&self.0.instant(time), &Self::state(state), &mut rates);
        rate.copy_from_slice(rates.as_ref());
    }

    fn jacobian(&self, time: f64, state: &[f64], columns: &mut [f64]) {
        let mut all = vec![State::<C>::zeros(C::shape().states.len()); C::shape().states.len()];
        self.0
            .jacobian(&self.0.instant(time), &Self::state(state), &mut all);
        for (column, target) in all
            .iter()
            .zip(columns.chunks_mut(C::shape().states.len().max(1)))
        {
            target.copy_from_slice(column.as_ref());
        }
    }
}
