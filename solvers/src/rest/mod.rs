//! Where a mechanism rests, whether it stays there, and how it vibrates about it.
//!
//! At rest all speeds are zero and so are all accelerations: Newton's method finds such a position from the start values,
//! in steps that are shortened until the next one would be shorter (the natural monotonicity test of P. Deuflhard: *Newton
//! Methods for Nonlinear Problems*, 2004, section 3.3). Directions in which nothing changes, of a wheel that turns freely,
//! are left where they start. Closures that hold the coordinates are equations beside the others, of which there are then
//! more than unknowns; they agree with each other, and the steps solve them by singular values.
//!
//! A small disturbance of the rest obeys `δy' = (∂f/∂y) δy` on what the closures allow: eigenvalues say how it grows,
//! vibrates and dies out, eigenvectors in which shape ([`Vibration`]).

mod error;
mod kinks;
mod place;
mod slopes;
mod vibration;

pub use error::RestError;
pub use vibration::Vibration;

use crate::model::Model;
use crate::ode::larger;
use place::Place;

/// Most steps.
const MOST: usize = 200;
/// Shortest part of a step that is tried.
const SHORTEST: f64 = 1e-6;
/// Longest step, over the scales of the states, that may be one of rounding.
const SMALL: f64 = 1e-5;
/// Errors are so many times what these say.
const SAFETY: f64 = 4.0;

/// A position of rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Rest {
    /// The state, SI units; all speeds are zero.
    pub state: Vec<f64>,
    /// The estimated error of each component of the state.
    pub errors: Vec<f64>,
    /// How disturbances move: those that vibrate, the slowest first, and behind them the others, the one that lasts longest
    /// first.
    pub vibrations: Vec<Vibration>,
    /// Newton steps.
    pub iterations: usize,
    /// Evaluations of the rates and of their slopes, those that show what rounding does among them.
    pub evaluations: (usize, usize),
    /// Directions in which it would rest as well a little aside.
    pub free: usize,
    /// A switching surface of the mode on which it rests, by the event that it is: the vibrations are those of one of its
    /// sides, and a disturbance comes to both.
    pub kink: Option<usize>,
}

impl Rest {
    /// The disturbance that grows fastest, if one grows.
    pub fn growing(&self) -> Option<&Vibration> {
        let growing = self.vibrations.iter().filter(|one| one.grows());
        growing.max_by(|a, b| a.rate.total_cmp(&b.rate))
    }

    /// The vibration of a number, counted from 1, the slowest first.
    pub fn vibration(&self, number: usize) -> Option<&Vibration> {
        let mut vibrations = self.vibrations.iter().filter(|one| one.vibrates());
        vibrations.nth(number.checked_sub(1)?)
    }

    /// What errors make of it: the same with one component of the state, or all vibrations, as far off as they may be.
    pub(crate) fn disturbed(&self) -> Vec<Self> {
        let components = (0..self.state.len()).filter(|index| self.errors[*index] > 0.0);
        // Several, because what a position says has roundings of its own.
        let shares =
            components.flat_map(|index| [1.0, -1.0, 0.6, -0.3].map(|share| (index, share)));
        let states = shares.map(|(index, share)| {
            let mut other = self.clone();
            other.state[index] += share * self.errors[index];
            other
        });
        let mut other = self.clone();
        for one in other.vibrations.iter_mut().filter(|one| one.vibrates()) {
            (one.rate, one.angular) = (one.rate + one.error, one.angular + one.error);
        }
        states.chain([other]).collect()
    }
}

/// The position at which a model rests in a mode, found from a start.
///
/// # Errors
/// See [`RestError`].
pub(crate) fn of(model: &dyn Model, mode: usize, start: &[f64]) -> Result<Rest, RestError> {
    let place = Place::new(model, mode, start)?;
    place.check_time(start)?;
    let mut state = place.still(start);
    let mut slopes = place.slopes(&state);
    let mut change = slopes.solve(&place.residual(&state));
    let mut iterations = 0;
    while iterations < MOST && place.length(&change) > f64::EPSILON {
        let length = place.length(&change);
        let mut part = 1.0;
        let next = loop {
            let moved: Vec<f64> = state.iter().zip(&change).map(|(y, by)| y + part * by).collect();
            let left = place.length(&slopes.solve(&place.residual(&moved)));
            if left <= (1.0 - part / 4.0) * length {
                break Some(moved);
            }
            part *= 0.5;
            if part < SHORTEST {
                break None;
            }
        };
        let Some(next) = next else { break };
        iterations += 1;
        state = next;
        slopes = place.slopes(&state);
        change = slopes.solve(&place.residual(&state));
    }
    let errors = errors(&place, &state, &change);
    let worst = place.length(&errors);
    slopes.check(&place.residual(&state), place.names())?;
    if worst.is_nan() || worst > SAFETY * SMALL {
        return Err(place.unsettled(&state, iterations));
    }
    let kink = kinks::at(&place, &state, &errors)?;
    let vibrations = vibration::all(&place, &state, &errors);
    let (free, evaluations) = (slopes.free(), place.evaluations());
    Ok(Rest { vibrations, free, state, errors, iterations, evaluations, kink })
}

/// How far off each component may be: steps from a few roundings beside the position.
fn errors(place: &Place<'_>, state: &[f64], change: &[f64]) -> Vec<f64> {
    let mut errors: Vec<f64> = change.iter().map(|change| change.abs()).collect();
    for aside in Place::around(state) {
        let change = place.slopes(&aside).solve(&place.residual(&aside));
        for (error, change) in errors.iter_mut().zip(change) {
            *error = larger(*error, change.abs());
        }
    }
    errors.iter().map(|error| SAFETY * error).collect()
}

#[cfg(test)]
mod tests;
