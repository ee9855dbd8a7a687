//! Motions that repeat after a period.
//!
//! A motion from `v` repeats if `y(T; v) = v`. With `Φ = ∂y(T)/∂v`, integrated beside the motion, one step of Newton's
//! method is `(I - Φ) δ = y(T; v) - v`. For equations that are affine in the state one such step from rest is exact:
//! this is the *method of initial parameters* (superposition of `N` free motions and a forced one). For others the step
//! is repeated, *shooting*. All of it in states over their scales.
//!
//! Equations that are not affine may have several motions that repeat, and Newton's method finds one near enough only. So
//! with losses the motion from the start values is followed until it repeats, after the period or after several
//! ([`crate::hybrid::cycle`] does it): they pick the motion among those that attract. Without losses nothing attracts, and
//! shooting begins at the start values.
//!
//! Everything is computed twice, at `rtol` and at `rtol / 30`. The second result is returned; its difference from the
//! first is the error estimate, and the difference of the two `Φ` says how well `I - Φ` is known. Where that is not well
//! enough for the solution, near a resonance, the solver says so instead of returning numbers.

mod closing;
mod error;
mod period;
mod shooting;
mod smallest;

pub use crate::floquet::Multiplier;
pub use error::PeriodicError;

use crate::floquet::{Closing, multipliers};
use crate::model::{Bound, Model};
use crate::ode::Trajectory;
use crate::problem::Smooth;
use crate::settings::Settings;
use nalgebra::DVector;
use period::{Period, Return};

/// Factor between the tolerances of the two computations.
const REFINEMENT: f64 = 30.0;
/// Smallest tolerance of the second computation.
const SMALLEST_RTOL: f64 = 1e-14;
/// Difference of the determinant of `Φ` from 1 that counts as none,
const LOSSLESS: f64 = 1e-6;
/// and the same in tolerances.
const LOSSLESS_TOLERANCES: f64 = 100.0;

/// A motion that repeats.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    /// The motion from time 0 until it repeats. One of several periods begins in the period at whose begin the first
    /// state is largest; the next state decides where that is the same in several of them.
    pub trajectory: Trajectory,
    /// Periods after which it repeats.
    pub multiple: usize,
    /// Periods that the motion from the start values was followed until it repeats: they pick it where several attract.
    /// None where nothing attracts, or the equations are affine and have one motion.
    pub followed: Option<usize>,
    /// The Floquet multipliers, eigenvalues of `Φ`, the largest modulus first.
    pub multipliers: Vec<Multiplier>,
    /// Amplification of relative errors of `Φ` into the motion, `(1 + ‖Φ‖) / σ` with the smallest singular value `σ`
    /// of `I - Φ`, in states over their scales. It grows without bound at a resonance.
    pub condition: f64,
    /// Largest change of a state after one period, over its scale.
    pub residual: f64,
    /// Integrations of the variational equations.
    pub iterations: usize,
    /// Free motions that repeat after the same period and are not driven: any amount of them could be added. The
    /// motion here is the smallest, in the mean square over the period.
    pub free: usize,
    /// For each state the largest difference over the period between the computations at `rtol` and at `rtol / 30`,
    /// SI units. The motion is that of the second, so this is an estimate from above.
    pub estimated_error: Vec<f64>,
    /// State at time 0, SI units.
    pub start: Vec<f64>,
    /// Determinant of `I - Φ`.
    pub determinant: f64,
}

impl Orbit {
    /// The state at any time.
    pub fn at(&self, time: f64) -> Vec<f64> {
        let times = self.trajectory.times();
        let period = times[times.len() - 1] - times[0];
        self.trajectory.at(times[0] + (time - times[0]).rem_euclid(period))
    }
}

/// The motion of a scene without events that repeats after a period.
///
/// # Errors
/// See [`PeriodicError`].
pub fn solve<C: Smooth>(
    scene: &C,
    period: f64,
    settings: &Settings,
) -> Result<Orbit, PeriodicError> {
    of(&Bound::new(scene), &scene.start(), period, settings)
}

/// [`solve`] of a model behind a pointer that has no events.
pub(crate) fn of(
    model: &dyn Model,
    start: &[f64],
    period: f64,
    settings: &Settings,
) -> Result<Orbit, PeriodicError> {
    if !(period.is_finite() && period > 0.0) {
        return Err(PeriodicError::BadPeriod { period });
    }
    let period = Period { model, start, period, settings };
    begin(&period, settings.rtol)
}

/// The multipliers of the motion that repeats after a period where the equations are affine: they are those of all motions, so
/// there are some at a resonance too.
///
/// # Errors
/// See [`PeriodicError`].
pub(crate) fn multipliers_of(
    model: &dyn Model,
    period: f64,
    settings: &Settings,
) -> Result<Vec<Multiplier>, PeriodicError> {
    let period = Period { model, start: &[], period, settings };
    let rest = DVector::zeros(period.scales().len());
    let [coarse, fine] = tolerances(settings.rtol).map(|rtol| period.turn(&rest, rtol));
    Ok(multipliers(&fine?.matrix, Some(&coarse?.matrix), SMALLEST_RTOL))
}

/// The tolerances of the two computations.
fn tolerances(rtol: f64) -> [f64; 2] {
    [rtol, (rtol / REFINEMENT).max(SMALLEST_RTOL)]
}

/// Finds where to begin, and closes the motion.
fn begin(period: &Period<'_>, rtol: f64) -> Result<Orbit, PeriodicError> {
    if period.is_linear() {
        return close(period, DVector::zeros(period.scales().len()), rtol);
    }
    let guess = period.guess()?;
    let turn = period.turn(&guess, rtol);
    if turn.is_ok_and(|back| is_lossless(&back, rtol)) {
        return close(period, guess, rtol);
    }
    match period.attractor(&guess, rtol) {
        Ok(cycle) => {
            let start = DVector::from_vec(cycle.start());
            let start = start.component_div(&DVector::from_column_slice(period.scales()));
            let orbit = close(&period.over(cycle.multiple), start, rtol)?;
            Ok(Orbit { multiple: cycle.multiple, followed: Some(cycle.followed), ..orbit })
        }
        // One that is not stable, or hardly, may be there all the same.
        Err(error) => close(period, guess, rtol).map_err(|failure| match failure {
            PeriodicError::NotConverged { .. } => PeriodicError::NotSettled(Box::new(error)),
            _ => failure,
        }),
    }
}

/// Whether a turn keeps volumes in the space of states (Liouville): then nothing is lost, and nothing attracts.
fn is_lossless(back: &Return, rtol: f64) -> bool {
    (back.matrix.determinant() - 1.0).abs() <= LOSSLESS.max(LOSSLESS_TOLERANCES * rtol)
}

/// The motion that repeats, by superposition or by shooting from a guess.
fn close(period: &Period<'_>, mut guess: DVector<f64>, rtol: f64) -> Result<Orbit, PeriodicError> {
    let scales = period.scales();
    let tolerances = tolerances(rtol);
    let mut iterations = 0;
    let mut returns = Vec::with_capacity(tolerances.len());
    for rtol in tolerances {
        let back = if period.is_linear() {
            iterations += 1;
            period.turn(&guess, rtol)?
        } else {
            shooting::shoot(period, &guess, rtol, &mut iterations)?
        };
        guess.copy_from(&back.start);
        returns.push(back);
    }
    let [coarse, fine] = returns.as_slice() else {
        return Err(PeriodicError::BadPeriod { period: f64::NAN });
    };
    let closing = Closing::new(&fine.matrix);
    let uncertainty = rtol.max(closing.uncertainty(&(&fine.matrix - &coarse.matrix)));
    let noise = closing.length(&(fine.gap() - coarse.gap()));
    let load = 10.0 * (noise + rtol * closing.length(&fine.peak.add_scalar(1.0)));
    let closed = |back: &Return, closing: &Closing| {
        let found = closing.solve(&back.gap(), uncertainty, load)?;
        Ok::<_, PeriodicError>((&back.start + found.change, found.free))
    };
    let (first, _) = closed(coarse, &Closing::new(&coarse.matrix))?;
    let (second, free) = closed(fine, &closing)?;
    let mut starts = [first, second];
    if period.is_linear() && !free.is_empty() {
        starts = smallest::settle(period, starts, &free, tolerances)?;
    }
    let mut motions = Vec::with_capacity(starts.len());
    for (start, rtol) in starts.iter().zip(tolerances) {
        motions.push(period.march(start, rtol)?);
    }
    let (Some(trajectory), Some(other)) = (motions.pop(), motions.pop()) else {
        return Err(PeriodicError::BadPeriod { period: f64::NAN });
    };
    let start = trajectory.at(0.0);
    let changes = trajectory.end().iter().zip(&start).zip(scales);
    Ok(Orbit {
        residual: changes
            .map(|((end, start), scale)| (end - start).abs() / scale)
            .fold(0.0, f64::max),
        estimated_error: largest_differences(&trajectory, &other, closing.condition()),
        trajectory,
        multiple: 1,
        followed: None,
        multipliers: multipliers(&fine.matrix, Some(&coarse.matrix), SMALLEST_RTOL),
        condition: closing.condition(),
        iterations,
        free: free.len(),
        start,
        determinant: closing.determinant(),
    })
}

/// For each state the largest difference between two motions, at least what rounding makes of it.
fn largest_differences(first: &Trajectory, second: &Trajectory, condition: f64) -> Vec<f64> {
    let mut largest = vec![0.0; first.states()];
    let mut amplitudes = largest.clone();
    let ends = second.times().iter().copied();
    let middles = second.times().windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    for time in ends.chain(middles) {
        let states = first.at(time).into_iter().zip(second.at(time));
        for ((largest, amplitude), (first, second)) in
            largest.iter_mut().zip(&mut amplitudes).zip(states)
        {
            *largest = f64::max(*largest, (first - second).abs());
            *amplitude = f64::max(*amplitude, first.abs());
        }
    }
    let rounding = f64::EPSILON * if condition.is_finite() { condition } else { 1.0 };
    for (largest, amplitude) in largest.iter_mut().zip(amplitudes) {
        *largest = f64::max(*largest, rounding * amplitude);
    }
    largest
}

#[cfg(test)]
mod tests;
