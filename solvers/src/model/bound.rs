//! A scene of emitted code behind the pointer.

use super::{Model, Steps, attempt_each, finish_each};
use crate::dispatch::is_fused;
use crate::ode::step::{self, Coefficients, Dop853, Tsit5};
use crate::ode::{Explicit, Room};
use crate::problem::{Equations, Events, Phase, Reports, Scene, Span};
use crate::scalar::{Fused, Real};
use crate::shape::Shape;

/// Whether stages are written out one by one, see [`step::attempt`]. What is compiled for finding mistakes need not be as
/// fast as that.
const WRITTEN: bool = !cfg!(debug_assertions);

/// A scene with its values: on plain numbers for all that asks for one evaluation at a time, on fused ones for the steps of
/// the explicit methods where the processor has them. Elsewhere these ask for one evaluation after the other too, and take
/// some 1.8 times as long.
pub struct Bound<C: Scene> {
    scene: C,
    plain: C::Equations<f64>,
    fused: Option<C::Equations<Fused>>,
}

impl<C: Scene> Bound<C> {
    /// Prepares a scene, whose values have been checked or need not be.
    pub fn new(scene: &C) -> Self {
        Self {
            scene: scene.clone(),
            plain: scene.prepare(),
            // SAFETY: it has been asked whether the processor has the instructions.
            fused: is_fused().then(|| unsafe { prepare(scene) }),
        }
    }

    /// The scene.
    pub fn scene(&self) -> &C {
        &self.scene
    }
}

impl<C: Scene> Model for Bound<C> {
    fn shape(&self) -> &Shape {
        self.scene.shape()
    }

    fn equations(&self) -> &dyn Equations<f64> {
        &self.plain
    }

    fn reports(&self) -> &dyn Reports<f64> {
        &self.plain
    }

    fn events(&self) -> Option<&dyn Events<f64>> {
        C::events(&self.plain)
    }

    fn span(&self) -> Span {
        self.scene.span()
    }

    fn start(&self) -> Vec<f64> {
        self.scene.start()
    }

    fn unreduced(&self) -> Option<Box<dyn Model>> {
        let other = self.scene.unreduced()?;
        Some(Box::new(Bound::new(&other)))
    }

    fn attempt(&self, steps: Steps, phase: Phase<'_, f64>, room: &mut Room) {
        let Some(equations) = &self.fused else {
            return attempt_each(&self.plain, steps, phase, room);
        };
        let own = fused(phase);
        // SAFETY: there are fused equations only where the processor has the instructions.
        unsafe {
            match (steps.method, steps.varied) {
                (Explicit::Tsit5, false) => attempt::<C, Tsit5>(equations, own, room),
                (Explicit::Dop853, false) => attempt::<C, Dop853>(equations, own, room),
                (_, true) if !C::SMOOTH => attempt_each(&self.plain, steps, phase, room),
                (Explicit::Tsit5, true) => attempt_beside::<C, Tsit5>(equations, own, room),
                (Explicit::Dop853, true) => attempt_beside::<C, Dop853>(equations, own, room),
            }
        }
    }

    fn finish(&self, steps: Steps, phase: Phase<'_, f64>, room: &mut Room, dense: bool) {
        let Some(equations) = &self.fused else {
            return finish_each(&self.plain, steps, phase, room, dense);
        };
        let own = fused(phase);
        // SAFETY: as above.
        unsafe {
            match (steps.method, steps.varied) {
                (Explicit::Tsit5, false) => finish::<C, Tsit5>(equations, own, room, dense),
                (Explicit::Dop853, false) => finish::<C, Dop853>(equations, own, room, dense),
                (_, true) if dense || !C::SMOOTH => {
                    finish_each(&self.plain, steps, phase, room, dense);
                }
                (Explicit::Tsit5, true) => finish_beside::<C, Tsit5>(equations, own, room),
                (Explicit::Dop853, true) => finish_beside::<C, Dop853>(equations, own, room),
            }
        }
    }
}

/// A phase on fused numbers.
fn fused(phase: Phase<'_, f64>) -> Phase<'_, Fused> {
    Phase { mode: phase.mode, sides: Fused::of(phase.sides) }
}

/// The equations of a scene on fused numbers.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn prepare<C: Scene>(scene: &C) -> C::Equations<Fused> {
    scene.prepare()
}

/// The stages of a step of a scene.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn attempt<C: Scene, T: Coefficients>(
    equations: &C::Equations<Fused>,
    phase: Phase<'_, Fused>,
    room: &mut Room,
) {
    step::attempt::<Fused, T, _, WRITTEN>(&mut equations.alone(phase), room);
}

/// A step of a motion with its variations, all its stages.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn attempt_beside<C: Scene, T: Coefficients>(
    equations: &C::Equations<Fused>,
    phase: Phase<'_, Fused>,
    room: &mut Room,
) {
    // Without events alone is a motion integrated with its variations.
    if C::SMOOTH {
        step::attempt::<Fused, T, _, false>(&mut equations.beside(phase), room);
    }
}

/// What is missing of a step of a scene.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn finish<C: Scene, T: Coefficients>(
    equations: &C::Equations<Fused>,
    phase: Phase<'_, Fused>,
    room: &mut Room,
    dense: bool,
) {
    step::finish::<Fused, T, _>(&mut equations.alone(phase), room, dense);
}

/// The slope at the end of a step of a motion with its variations.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn finish_beside<C: Scene, T: Coefficients>(
    equations: &C::Equations<Fused>,
    phase: Phase<'_, Fused>,
    room: &mut Room,
) {
    if C::SMOOTH {
        step::finish::<Fused, T, _>(&mut equations.beside(phase), room, false);
    }
}
