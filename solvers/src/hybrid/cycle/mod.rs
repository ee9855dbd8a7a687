//! Motions through events that repeat: after the period, or after several of them.
//!
//! A motion from `x` repeats after `n` periods if `P(x) = x`, where `P` follows it that long. The way there has two
//! parts. First the motion is simply followed, period after period, and compared with its past: what attracts it shows.
//! Then Newton's method closes it, with the matrix `M = ∂P/∂x`: the variational equations along the pieces between
//! events, and at each event the jump of the variations (the saltation matrix, see [`variation`]), because a disturbed
//! motion meets the event earlier or later. The eigenvalues of `M` are the Floquet multipliers. What Newton's method comes
//! to is returned only where it is near the motion that was followed: it may have left what attracts that one.
//!
//! | file | what it does |
//! |---|---|
//! | `variation` | the matrix `M` of a motion |
//! | `returns` | after how many periods a motion comes near to its past |
//! | `newton` | closes a motion |
//! | `phase` | where a motion begins that may be begun in several places |
//! | `clock` | motions whose period is not known |
//! | `search` | follows, compares, closes; and what is said if nothing repeats |
//! | `lyapunov` | what becomes of disturbances in the long run, whether the motion repeats or not |

mod clock;
mod error;
mod lyapunov;
mod newton;
mod phase;
mod returns;
mod search;
mod variation;

pub use error::CycleError;
pub use lyapunov::{Lyapunov, Periods, lyapunov};

use super::run::march::Request;
use super::run::start;
use super::{HybridError, Motion};
use crate::floquet::Multiplier;
use crate::model::{Bound, Flow, Model};
use crate::ode::OdeError;
use crate::problem::Scene;
use crate::settings::Settings;
use nalgebra::DMatrix;

/// Periods that a motion is followed before it is closed, unless it closes by itself.
pub const FOLLOWED: usize = 80;
/// Periods that it is followed further where what was found is unstable, or nothing was.
pub const PATIENCE: usize = 400;
/// Most periods after which a motion is looked for to repeat.
pub const MULTIPLES: usize = 12;

/// A motion through events that repeats.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    /// The motion from time 0 until it repeats. One of several periods begins in the period at whose begin the first
    /// state is largest; the next state decides where that is the same in several of them.
    pub motion: Motion,
    /// Periods after which it repeats.
    pub multiple: usize,
    /// The Floquet multipliers over that time, the largest modulus first.
    pub multipliers: Vec<Multiplier>,
    /// Amplification of relative errors of `M` into the motion.
    pub condition: f64,
    /// Largest change of a state after it has repeated, over its scale.
    pub residual: f64,
    /// Steps of Newton's method.
    pub iterations: usize,
    /// Periods that the motion was followed before it was closed.
    pub followed: usize,
}

impl Cycle {
    /// The period, in seconds.
    pub fn period(&self) -> f64 {
        self.motion.time / self.multiple as f64
    }

    /// The state at time 0, SI units.
    pub fn start(&self) -> Vec<f64> {
        self.motion.at(0.0).1
    }

    /// Whether small disturbances die out.
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|one| one.modulus() < 1.0)
    }
}

/// The stable motion of a scene that repeats after the period, or after several.
///
/// It begins to look at the declared start: where several motions attract, it is the one that this start leads to.
///
/// # Errors
/// [`CycleError`]; [`CycleError::NoneStable`] with what was found instead.
pub fn cycle<C: Scene>(scene: &C, period: f64, settings: &Settings) -> Result<Cycle, CycleError> {
    cycle_from(scene, (scene.shape().first, &scene.start()), period, settings)
}

/// The motion that repeats, sought from another mode and state at time 0.
///
/// # Errors
/// As [`cycle`].
pub fn cycle_from<C: Scene>(
    scene: &C,
    start: (usize, &[f64]),
    period: f64,
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    cycle_of(&Bound::new(scene), start, period, settings)
}

/// [`cycle_from`] of a model behind a pointer.
pub(crate) fn cycle_of(
    model: &dyn Model,
    start: (usize, &[f64]),
    period: f64,
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    check(model, start)?;
    search::search(model, start, period, settings)
}

/// The motion of a scene that nothing drives and that repeats, such as that of a clock. Its period is a result,
/// [`Cycle::period`]. It begins where the first state is largest, or, where that only rises between events, passes the middle of its range. Its multipliers are those beside the one of the
/// phase, which is 1.
///
/// # Errors
/// [`CycleError`]; [`CycleError::Driven`] if the equations depend on the time, [`CycleError::Rest`] if the motion from the
/// declared start comes to rest.
pub fn clock<C: Scene>(scene: &C, settings: &Settings) -> Result<Cycle, CycleError> {
    let start = (scene.shape().first, &scene.start()[..]);
    clock_of(&Bound::new(scene), start, settings)
}

/// [`clock`] of a model behind a pointer.
pub(crate) fn clock_of(
    model: &dyn Model,
    start: (usize, &[f64]),
    settings: &Settings,
) -> Result<Cycle, CycleError> {
    check(model, start)?;
    clock::find(model, start, settings)
}

/// Refuses a model of which it is not known how its events depend on the state, and a start that no motion has: beyond the
/// end of its mode, Newton's method would find motions that none comes to.
fn check(model: &dyn Model, (mode, state): (usize, &[f64])) -> Result<(), CycleError> {
    let Some(events) = model.events() else {
        return Ok(());
    };
    if !events.has_slopes() {
        return Err(CycleError::NoTask);
    }
    start::check_mode(model.shape(), mode)?;
    // A start of another length is refused where it is followed.
    match state.len() == model.shape().states.len() {
        true => Ok(start::check(&Flow::new(model, mode), 0.0, state)?),
        false => Ok(()),
    }
}

/// A motion. What an iteration tries may begin a little beyond the end of a mode.
fn follow(
    model: &dyn Model,
    mode: usize,
    times: (f64, f64),
    start: &[f64],
    settings: &Settings,
) -> Result<Motion, HybridError> {
    let way = Request { mode, times, start, settings, is_checked: false };
    way.of(model)
}

/// The derivatives of the end of a motion without events by its begin, SI units.
pub(crate) fn variations(
    model: &dyn Model,
    motion: &Motion,
    settings: &Settings,
) -> Result<DMatrix<f64>, OdeError> {
    let (local, shape) = (Flow::new(model, motion.mode), model.shape());
    let start = DMatrix::identity(shape.states.len(), shape.states.len());
    motion.pieces.iter().try_fold(start, |matrix, piece| {
        variation::along(&local, piece, shape.scales, matrix, settings)
    })
}

#[cfg(test)]
mod tests;
