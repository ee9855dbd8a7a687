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
//! | `flow` | a scene, without its type |
//! | `variation` | the matrix `M` of a motion |
//! | `returns` | after how many periods a motion comes near to its past |
//! | `newton` | closes a motion |
//! | `search` | follows, compares, closes; and what is said if nothing repeats |
//! | `lyapunov` | what becomes of disturbances in the long run, whether the motion repeats or not |

mod error;
mod flow;
mod lyapunov;
mod newton;
mod returns;
mod search;
mod variation;

pub use error::CycleError;
pub use lyapunov::{Lyapunov, Periods, lyapunov};

use super::Motion;
use super::problem::{Hybrid, Sensitive};
use crate::periodic::Multiplier;
use crate::registry::Settings;
use flow::Bound;

/// Periods that a motion is followed before it is closed, unless it closes by itself.
pub const FOLLOWED: usize = 80;
/// Periods that it is followed further where what was found is unstable, or nothing was.
pub const PATIENCE: usize = 400;
/// Most periods after which a motion is looked for to repeat.
pub const MULTIPLES: usize = 12;

/// A motion through events that repeats.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    /// The motion from time 0 until it repeats.
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
pub fn cycle<C: Hybrid>(scene: &C, period: f64, settings: &Settings) -> Result<Cycle, CycleError>
where
    C::Modal<f64>: Sensitive<f64>,
{
    cycle_from(scene, (C::FIRST, &scene.start()), period, settings)
}

/// The same from another mode and state at time 0.
///
/// # Errors
/// As [`cycle`].
pub fn cycle_from<C: Hybrid>(
    scene: &C,
    start: (usize, &[f64]),
    period: f64,
    settings: &Settings,
) -> Result<Cycle, CycleError>
where
    C::Modal<f64>: Sensitive<f64>,
{
    search::search(&Bound::new(scene), start, period, settings)
}
