//! A scene with its values behind a pointer: what follows a motion is compiled once for all scenes.
//!
//! What is compiled for each is a step of an explicit method, one call for all its stages ([`Model::attempt`]), on fused
//! numbers where the processor has them. Everything else asks for one evaluation at a time ([`Flow`]).

mod bound;
mod correction;
mod flow;
#[cfg(test)]
pub(crate) mod hand;
mod varied;

pub use bound::Bound;
use correction::Correction;
pub(crate) use correction::assemble_beside;
pub use correction::{assemble, begin};
pub use flow::Flow;
pub(crate) use flow::held;
pub use varied::Varied;

use crate::ode::{Explicit, Room, system};
use crate::problem::{Alone, Beside, Equations, Events, Phase, Reports, Span};
use crate::shape::Shape;

/// The steps of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps {
    /// The method.
    pub method: Explicit,
    /// Whether the state is a motion and behind it one column of its variation for each state.
    pub varied: bool,
}

/// A scene with its values.
pub trait Model: Send + Sync {
    /// What the scene is made of.
    fn shape(&self) -> &Shape;

    /// Its equations.
    fn equations(&self) -> &dyn Equations<f64>;

    /// What a position says.
    fn reports(&self) -> &dyn Reports<f64>;

    /// What changes the equations on the way; none where nothing does.
    fn events(&self) -> Option<&dyn Events<f64>> {
        None
    }

    /// The task of the scene.
    fn span(&self) -> Span;

    /// The declared start values of the state, SI units.
    fn start(&self) -> Vec<f64>;

    /// The same motion with all positions as coordinates, which goes on where loops of this one come to a dead point; none
    /// where that does not happen.
    fn unreduced(&self) -> Option<Box<dyn Model>> {
        None
    }

    /// Evaluates all stages of a step, the state at its end and its errors.
    fn attempt(&self, steps: Steps, phase: Phase<'_, f64>, room: &mut Room) {
        attempt_each(self.equations(), steps, phase, room);
    }

    /// Evaluates what is missing of a step that is accepted: the slope at its end and, if asked for, the continuous
    /// solution.
    fn finish(&self, steps: Steps, phase: Phase<'_, f64>, room: &mut Room, dense: bool) {
        finish_each(self.equations(), steps, phase, room, dense);
    }
}

/// [`Model::attempt`] by one evaluation after the other.
fn attempt_each(
    equations: &dyn Equations<f64>,
    steps: Steps,
    phase: Phase<'_, f64>,
    room: &mut Room,
) {
    match steps.varied {
        false => system::attempt_any(&mut Alone { equations, phase }, steps.method, room),
        true => system::attempt_any(&mut Beside { equations, phase }, steps.method, room),
    }
}

/// [`Model::finish`] likewise.
fn finish_each(
    equations: &dyn Equations<f64>,
    steps: Steps,
    phase: Phase<'_, f64>,
    room: &mut Room,
    dense: bool,
) {
    match steps.varied {
        false => system::finish_any(&mut Alone { equations, phase }, steps.method, room, dense),
        true => system::finish_any(&mut Beside { equations, phase }, steps.method, room, dense),
    }
}
