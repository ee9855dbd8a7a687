//! Lyapunov exponents: how fast motions from neighbouring starts part, or come together, in the long run.
//!
//! With the matrix `M` of each period, events included (see [`super::variation`]), a frame of as many directions as there
//! are states is carried along: `M Q = Q' R`, where `Q` and `Q'` are orthonormal and `R` is triangular. The exponents are
//! the means of `ln |R_ii|` over the time (G. Benettin, L. Galgani, A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980) 9).
//! The first is above zero where the motion is irregular; of a motion that repeats they are `ln |μ|` of its Floquet
//! multipliers over its length.

use nalgebra::{DMatrix, DVector};

use super::error::CycleError;
use super::{check, follow, variation};
use crate::model::{Bound, Model};
use crate::problem::Scene;
use crate::settings::Settings;

/// Lyapunov exponents, and where the motion has come to.
#[derive(Clone, Debug, PartialEq)]
pub struct Lyapunov {
    /// The exponents per second: the largest first, as far as the time was long enough to tell them apart. A direction
    /// that is lost, as at a stop that holds, has −∞.
    pub exponents: Vec<f64>,
    /// The mode at the end.
    pub mode: usize,
    /// The state at the end.
    pub end: Vec<f64>,
}

/// How long a motion is followed, in periods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Periods {
    /// At first, until it shows what attracts it, and the frame where it is drawn to.
    pub settling: usize,
    /// Over which the mean is taken.
    pub counted: usize,
}

/// The exponents of the motion from a mode and state at time 0. What drives it repeats after the period.
///
/// # Errors
/// [`CycleError`], where the motion cannot be followed or does not depend smoothly on where it is.
pub fn lyapunov<C: Scene>(
    scene: &C,
    (mode, start): (usize, &[f64]),
    period: f64,
    periods: Periods,
    settings: &Settings,
) -> Result<Lyapunov, CycleError> {
    if !(period.is_finite() && period > 0.0) {
        return Err(CycleError::BadPeriod { period });
    }
    let model = &Bound::new(scene);
    check(model, (mode, start))?;
    let mut stretch = Stretch {
        model,
        period,
        sizes: scene.shape().scales,
        settings,
        mode,
        state: start.to_vec(),
        frame: frame(scene.shape().states.len()),
    };
    stretch.advance(periods.settling)?;
    let grown = stretch.advance(periods.counted)?;
    let time = period * periods.counted as f64;
    Ok(Lyapunov {
        exponents: grown.iter().map(|one| one / time).collect(),
        mode: stretch.mode,
        end: stretch.state,
    })
}

/// A frame whose first direction has part in all states.
pub(super) fn frame(states: usize) -> DMatrix<f64> {
    let mut all = DMatrix::identity(states, states);
    all.column_mut(0).fill(1.0);
    all.qr().q()
}

/// A motion under way, and a frame of directions in states over their sizes.
pub(super) struct Stretch<'a> {
    pub(super) model: &'a dyn Model,
    pub(super) period: f64,
    pub(super) sizes: &'a [f64],
    pub(super) settings: &'a Settings,
    pub(super) mode: usize,
    pub(super) state: Vec<f64>,
    pub(super) frame: DMatrix<f64>,
}

impl Stretch<'_> {
    /// So many periods further. Gives the logarithms of the growth along the directions of the frame.
    pub(super) fn advance(&mut self, periods: usize) -> Result<DVector<f64>, CycleError> {
        let mut grown = DVector::zeros(self.sizes.len());
        for _ in 0..periods {
            let motion =
                follow(self.model, self.mode, (0.0, self.period), &self.state, self.settings)?;
            let matrix = variation::of(self.model, &motion, self.settings)?;
            let (sizes, states) = (self.sizes, self.sizes.len());
            let scaled =
                DMatrix::from_fn(states, states, |i, j| matrix[(i, j)] * sizes[j] / sizes[i]);
            let (next, upper) = (scaled * &self.frame).qr().unpack();
            for (sum, one) in grown.iter_mut().zip(upper.diagonal().iter()) {
                *sum += one.abs().ln();
            }
            self.frame = next;
            self.mode = motion.mode;
            self.state = motion.end;
        }
        Ok(grown)
    }
}
