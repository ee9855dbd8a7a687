//! The functions of scenes that move.

use std::sync::Arc;

use assur::problem::{Equations, Phase, Reports, Scene};
use assur::registry::SceneEntry;
use assur::scalar::Scalar;
use assur::shape::Shape;
use assur_interpreter::scene::{Motion, Moving};
use assur_model::checked::SceneModel;

use super::{Error, Functions, PLACES, disturbed, judged, share, turns};
use crate::octuple::Octuple;

/// Scenes of more states take too long.
const MOST: usize = 30;

/// A place in a mode.
struct Here<'a, S> {
    shape: &'a Shape,
    mode: usize,
    time: S,
    state: Vec<S>,
}

impl<S: Scalar> Here<'_, S> {
    /// The functions of a scene with their values.
    fn functions(&self, scene: &Moving<false>) -> Functions<S> {
        let prepared = scene.prepare::<S>();
        let (shape, n, phase) = (self.shape, self.state.len(), Phase::of(self.mode));
        let (time, state) = (self.time, &self.state[..]);
        let zeros = |count| vec![S::ZERO; count];
        let mut row = zeros(prepared.instant());
        prepared.instants(phase, &[time], &mut row);
        let mut found = Vec::new();
        let mut take = |name, count, write: &dyn Fn(&mut [S])| {
            let mut values = zeros(count);
            write(&mut values);
            found.push((name, values));
        };
        take("rate", n, &|values| prepared.rates(phase, &row, state, values));
        take("slope", n * n, &|values| prepared.jacobian(phase, &row, state, values));
        take("output", shape.outputs.len(), &|values| prepared.outputs(phase, time, state, values));
        take("energy", 2, &|values| {
            if let Some(energy) = prepared.energy(phase, time, state) {
                (values[0], values[1]) = energy;
            }
        });
        let masses = shape.coordinates * shape.coordinates;
        take("mass", masses, &|values| {
            prepared.mass(phase, time, state, values);
        });
        if let Some(events) = Moving::<false>::events(&prepared) {
            let count = shape.modes[self.mode].written();
            take("guard", 2 * count, &|values| {
                let (values, rates) = values.split_at_mut(count);
                events.guards(phase, time, state, values, rates);
            });
        }
        found
    }
}

/// The errors of all functions in a mode at a place. The first scene is the one that is meant, the others have parameters a little
/// off.
fn errors(of: (&'static str, &str), scenes: &[Moving<false>], here: &Here<'_, f64>) -> Vec<Error> {
    let exact = scenes.iter().enumerate().map(|(turn, scene)| {
        let off = |index, value| Octuple::from_f64(disturbed(value, turn, index));
        let state = here.state.iter().enumerate();
        let state = state.map(|(index, value)| off(index, *value)).collect();
        Here { shape: here.shape, mode: here.mode, time: off(777, here.time), state }
            .functions(scene)
    });
    let named = |what: &str, index: usize| format!("mode {}, {what} {index}", here.mode);
    judged(of, &named, here.functions(&scenes[0]), exact.collect())
}

/// The errors of all functions of a scene.
pub fn of_scene(mechanism: &'static str, entry: &SceneEntry, scene: &SceneModel) -> Vec<Error> {
    if entry.states.is_empty() || entry.states.len() > MOST {
        return Vec::new();
    }
    let motion = Arc::new(Motion::new(scene, entry.shape, None));
    let scenes: Vec<_> =
        turns(entry).map(|values| Moving::<false>::new(&motion, &values)).collect();
    let moving = &scenes[0];
    let (from, to) = moving.span().limits();
    let mut found = Vec::new();
    for mode in 0..entry.modes.len().max(1) {
        for place in 0..PLACES {
            let near = |(index, (value, scale)): (usize, (f64, &f64))| {
                let width = [1.0, 30.0][place % 2] * scale;
                value + width * (2.0 * share(place, index) - 1.0)
            };
            let state = moving.start().into_iter().zip(entry.scales).enumerate().map(near);
            let time = from + (to - from) * share(place, 55);
            let here = Here { shape: entry.shape, mode, time, state: state.collect() };
            found.extend(errors((mechanism, entry.name), &scenes, &here));
        }
    }
    found
}
