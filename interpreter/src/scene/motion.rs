//! A scene that moves by its equations of motion.

use std::sync::Arc;

use assur_model::checked::{SceneModel, SpanKind};
use assur_model::program::Idle;
use assur_solvers::model;
use assur_solvers::problem::{Events, Refused, Scene, Smooth, Span};
use assur_solvers::scalar::Scalar;
use assur_solvers::shape::Shape;

use super::equations::{Function, Prepare};
use super::functions::Functions;
use super::values::{OfValues, too_large};

/// What all sets of values of a scene have in common.
pub struct Motion {
    pub(super) shape: &'static Shape,
    /// Each mode; the scene itself where it has none.
    pub(super) modes: Vec<Arc<Functions>>,
    /// When no mode needs its instants.
    pub(super) idle: Vec<Idle>,
    pub(super) first: usize,
    /// Length of a row of an instant.
    pub(super) row: usize,
    pub(super) has_slopes: bool,
    values: OfValues,
    unreduced: Option<Arc<Motion>>,
}

impl Motion {
    /// A scene with its shape, and that of the same with all positions as coordinates.
    pub fn new(
        scene: &SceneModel,
        shape: &'static Shape,
        unreduced: Option<&'static Shape>,
    ) -> Self {
        let split = scene.split();
        let each = if split.is_empty() { std::slice::from_ref(scene) } else { &split };
        let functions = |one: &SceneModel| {
            let count = Function::count(&one.program);
            Arc::new(Functions::new(one.program.clone(), scene.drivers.len(), count))
        };
        let modes: Vec<Arc<Functions>> = each.iter().map(functions).collect();
        let other = scene.unreduced.as_deref().zip(unreduced);
        Self {
            shape,
            idle: each.iter().map(|one| one.program.idle()).collect(),
            first: scene.first,
            row: modes.iter().map(|mode| mode.storage.length).max().unwrap_or(0),
            modes,
            has_slopes: scene.span == SpanKind::Periodic,
            values: OfValues::new(scene, shape),
            unreduced: other.map(|(scene, shape)| Arc::new(Self::new(scene, shape, None))),
        }
    }

    /// Whether nothing changes the equations on the way.
    pub fn is_smooth(&self) -> bool {
        self.shape.modes.is_empty()
    }
}

/// A scene with values of its constants. `SMOOTH` says whether nothing changes the equations on the way.
#[derive(Clone)]
pub struct Moving<const SMOOTH: bool> {
    motion: Arc<Motion>,
    values: Vec<f64>,
}

impl Smooth for Moving<true> {}

impl<const SMOOTH: bool> Moving<SMOOTH> {
    /// The scene with these values, of which there are as many as it has constants.
    pub fn new(motion: &Arc<Motion>, values: &[f64]) -> Self {
        Self { motion: motion.clone(), values: values.to_vec() }
    }

    fn is_held(&self) -> bool {
        self.motion.shape.augmented.is_some()
    }
}

impl<const SMOOTH: bool> Scene for Moving<SMOOTH> {
    type Equations<S: Scalar> = Prepare<S>;
    type Unreduced = Moving<false>;
    const SMOOTH: bool = SMOOTH;

    fn shape(&self) -> &'static Shape {
        self.motion.shape
    }

    fn prepare<S: Scalar>(&self) -> Prepare<S> {
        Prepare::new(&self.motion, &self.values)
    }

    fn events<S: Scalar>(equations: &Prepare<S>) -> Option<&dyn Events<S>> {
        // What goes on for a smooth motion at a dead point is smooth too, which its type does not say.
        match SMOOTH || equations.motion.is_smooth() {
            true => None,
            false => Some(equations),
        }
    }

    fn check(&self) -> Result<(), Refused> {
        for mode in &self.motion.modes {
            let checked = mode.check(Function::all(&mode.program));
            checked.map_err(|cannot| too_large(self.motion.shape, cannot))?;
        }
        self.motion.values.check(&self.values)?;
        match self.is_held() {
            true => model::assemble(self, self.motion.values.start(&self.values)).map(|_| ()),
            false => Ok(()),
        }
    }

    fn span(&self) -> Span {
        self.motion.values.span(&self.values)
    }

    fn start(&self) -> Vec<f64> {
        let start = self.motion.values.start(&self.values);
        match self.is_held() {
            true => model::begin(self, start),
            false => start,
        }
    }

    fn unreduced(&self) -> Option<Moving<false>> {
        let other = self.motion.unreduced.as_ref()?;
        let own = self.motion.shape.constants.iter().zip(&self.values);
        let values = other.shape.constants.iter().map(|constant| {
            let mut known = own.clone();
            let known = known.find(|(one, _)| one.quantity.name == constant.quantity.name);
            known.map_or(constant.default, |(_, value)| *value)
        });
        Some(Moving { motion: other.clone(), values: values.collect() })
    }
}
