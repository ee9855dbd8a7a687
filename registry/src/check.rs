//! What the generated tests of a mechanism ask of it: that its derivatives are those of its equations, that energy
//! stays where it cannot go, that it moves in the same way when it is stated in other units, that published facts come
//! out.
//!
//! Energy is asked of a scene that conserves it. Other units are asked of a scene whose equations and outputs hold no number
//! with a length, mass or time in its unit: a `3 mm` there, unlike the value of a constant, cannot be restated. The
//! documentation of such a scene names the first of these numbers.
//!
//! Each check gives back what it found instead of panicking, so that the command may run it too.

mod derivatives;
mod facts;
mod linkage;
mod positions;
mod resolve;
mod scaling;
#[cfg(test)]
mod tests;

pub use derivatives::jacobian;
pub use facts::fact;
pub use linkage::closure;
pub use scaling::{closure_scaling, scaling};

use assur_solvers::answer::{Method, Settings};
use assur_solvers::problem::{Equations, Phase, Reports, Scene, Smooth};
use assur_solvers::scalar::Scalar;
use assur_solvers::smooth;

/// Largest drift of the energy, as a share of what is exchanged.
const DRIFT: f64 = 1e-9;

/// Places that are tried.
const PLACES: usize = 6;

/// Why a check failed. It prints as its text in both formats, because a test prints its error with `{:?}`.
#[derive(Clone, PartialEq, Eq)]
pub struct Failed(pub String);

impl std::fmt::Display for Failed {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl std::fmt::Debug for Failed {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl std::error::Error for Failed {}

/// Follows the motion of a scene that neither loses nor gains energy, and checks that the sum of its energies stays.
///
/// # Errors
/// The drift and its time, or that the motion could not be followed.
pub fn energy<C: Smooth>(scene: &C) -> Result<(), Failed> {
    // Where a table has its points a method loses digits, which it finds again with shorter steps; equations do not.
    drift(scene, 1e-12).or_else(|_| drift(scene, 1e-14))
}

/// Checks that the sum of the energies stays in a motion at a tolerance.
fn drift<C: Smooth>(scene: &C, rtol: f64) -> Result<(), Failed> {
    let equations = scene.prepare::<f64>();
    let (from, to) = scene.span().limits();
    let start = moving_start(scene, &equations, from);
    let settings = Settings::new(Method::Dop853).rtol(rtol);
    let motion = smooth::march(scene, (from, to), &start, &settings)
        .map_err(|error| Failed(format!("the motion could not be followed: {error}")))?;
    let at = |time: f64| {
        let energies = equations.energy(Phase::of(0), time, &motion.at(time));
        let (kinetic, potential) = energies.unwrap_or((f64::NAN, f64::NAN));
        (time, kinetic, potential)
    };
    let all: Vec<(f64, f64, f64)> = motion.times().iter().map(|time| at(*time)).collect();
    let (_, kinetic, potential) = at(from);
    let exchanged =
        all.iter().map(|(_, now, level)| now.abs() + (level - potential).abs()).fold(0.0, f64::max);
    let drift = |entry: &(f64, f64, f64)| entry.1 - kinetic + (entry.2 - potential);
    match all.iter().find(|entry| drift(entry).is_nan() || drift(entry).abs() > DRIFT * exchanged) {
        None => Ok(()),
        Some(entry) => Err(Failed(format!(
            "at {} s the energy has changed by {:e} J, while {exchanged:e} J are exchanged; expected a change of at most {:e} J",
            entry.0,
            drift(entry),
            DRIFT * exchanged
        ))),
    }
}

/// The derivative of the state at a time, with what depends on the time alone.
fn rates<S: Scalar>(
    equations: &(impl Equations<S> + ?Sized),
    mode: usize,
    time: S,
    state: &[S],
) -> (Vec<S>, Vec<S>) {
    let phase = Phase::of(mode);
    let mut instant = vec![S::ZERO; equations.instant()];
    equations.instants(phase, &[time], &mut instant);
    let mut rates = vec![S::ZERO; state.len()];
    equations.rates(phase, &instant, state, &mut rates);
    (rates, instant)
}

/// Times and states at which a scene is tried: all over its task, near its start and far from it.
fn places<C: Scene>(scene: &C) -> impl Iterator<Item = (f64, Vec<f64>)> {
    let ((from, to), start) = (scene.span().limits(), scene.start());
    (0..PLACES).map(move |index| {
        // Never the start itself: at rest two branches may meet there, which have two derivatives.
        let size = [1.0, 30.0, 300.0][index % 3];
        let time = from + (to - from) * (index as f64 * 0.618 + 0.137).fract();
        (time, beside(&start, scene.shape().scales, index, size))
    })
}

/// The declared start, or where nothing moves from there, one a little beside it.
fn moving_start<C: Scene>(scene: &C, equations: &C::Equations<f64>, time: f64) -> Vec<f64> {
    let start = scene.start();
    let (rates, _) = rates(equations, scene.shape().first, time, &start);
    match rates.iter().all(|value| *value == 0.0) {
        true => beside(&start, scene.shape().scales, 1, 100.0),
        false => start,
    }
}

/// A deterministic state around another, each component off by at most so many of its scales.
fn beside(state: &[f64], scales: &[f64], index: usize, size: f64) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    let offset = |component: usize| {
        let share = ((index * state.len() + component) as f64 + 0.3) * golden;
        2.0 * share.fract() - 1.0
    };
    state
        .iter()
        .zip(scales)
        .enumerate()
        .map(|(component, (value, scale))| value + size * scale * offset(component))
        .collect()
}
