//! The loop over the steps, which all stiff methods share.

use super::here::{Here, scaled_size};
use super::spectrum::Calm;
use crate::model::Flow;
use crate::ode::{
    Basis, Clock, Observer, OdeError, Options, SHORTEST, Statistics, Step, first_bad,
};

/// What came of a step that was tried.
pub(super) enum Attempt {
    /// It was computed; its error in tolerances.
    Done(f64),
    /// It could not be computed; the factor to the next attempt.
    Failed(f64),
}

/// A stiff method.
pub(super) trait Stepper {
    /// Order of its error estimate, plus one.
    const ERROR_ORDER: f64;

    /// Forgets what it knows of an earlier motion.
    fn restart(&mut self);

    /// Computes a step of a length from where the motion stands to [`Here::trial`], and unless the steps are fixed the
    /// error estimate [`Here::error`].
    fn attempt(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        options: &Options,
        length: f64,
    ) -> Result<Attempt, OdeError>;

    /// Writes the continuous solution of the step into [`Here::polynomial`].
    fn interpolate(&mut self, here: &mut Here);

    /// Whether the error of the last step is that of rounding, and above the tolerance.
    fn is_rounded(&self) -> bool {
        false
    }

    /// Factor to the next step after a step of this length and error.
    fn accept(&mut self, length: f64, error: f64) -> f64;

    /// Factor to the next attempt after a step with this error, above 1 or not a number.
    fn reject(&mut self, length: f64, error: f64) -> f64;
}

/// Integrates from one time to another, forwards or backwards. Ends early where the observer has enough, or where the
/// motion has been calm for long.
pub(super) fn drive<M: Stepper>(
    method: &mut M,
    flow: &Flow<'_>,
    here: &mut Here,
    times: (f64, f64),
    options: &Options,
    observe: &mut dyn Observer,
    mut calm: Option<&mut Calm>,
) -> Result<(), OdeError> {
    here.statistics = Statistics::default();
    here.time = times.0;
    method.restart();
    if times.0 == times.1 {
        return Ok(());
    }
    let max_step = options.max_step.unwrap_or(f64::INFINITY);
    let mut clock = Clock::new(times, options);
    let mut step = first_step(flow, here, times, options, M::ERROR_ORDER)?;
    while clock.now != times.1 {
        let tried = here.statistics.steps + here.statistics.rejected;
        if tried >= options.max_steps {
            return Err(OdeError::TooManySteps { time: clock.now, steps: tried });
        }
        let to = clock.target(step, here.statistics.steps);
        let length = to - clock.now;
        let error = match method.attempt(flow, here, options, length)? {
            Attempt::Done(error) => match has_rate(flow, here, to, error)? {
                true => Ok(error),
                false => Err(method.reject(length, error)),
            },
            Attempt::Failed(factor) => Err(factor),
        };
        let error = match error {
            Ok(error) => error,
            Err(factor) => {
                step = length * factor;
                here.statistics.rejected += 1;
                if clock.fixed.is_some() || clock.is_lost(step) {
                    return Err(here.failure(options, step));
                }
                continue;
            }
        };
        method.interpolate(here);
        observe.step(&Step {
            from: clock.now,
            to,
            before: &here.state,
            after: &here.trial,
            basis: Basis::Alternating,
            polynomial: &here.polynomial,
        });
        here.statistics.count(length, error, to == times.1);
        here.statistics.stiff_steps += 1;
        here.statistics.rounded_steps += usize::from(method.is_rounded());
        std::mem::swap(&mut here.state, &mut here.trial);
        std::mem::swap(&mut here.rate, &mut here.next);
        (clock.now, here.time) = (to, to);
        if observe.has_enough() {
            break;
        }
        step = (length * method.accept(length, error)).clamp(-max_step, max_step);
        if let Some(calm) = &mut calm
            && calm.is_enough(here, length)
        {
            break;
        }
    }
    Ok(())
}

/// Whether a step is accurate enough and its end, corrected, has a rate, which is evaluated.
fn has_rate(flow: &Flow<'_>, here: &mut Here, to: f64, error: f64) -> Result<bool, OdeError> {
    here.bad = first_bad(&here.trial, here.trial.len());
    if here.bad.is_some() || error.is_nan() || error > 1.0 {
        return Ok(false);
    }
    flow.correct(to, &mut here.trial)?;
    flow.rates(to, &here.trial, &mut here.next);
    here.statistics.evaluations += 1;
    here.bad = first_bad(&here.next, here.next.len());
    Ok(here.bad.is_none())
}

/// The rate at the start, and the length of a first step (Hairer, Nørsett, Wanner, *Solving Ordinary Differential
/// Equations I*, II.4, "Starting step size"). One that is given is an upper bound: stiff methods are so stable that a step
/// much too long passes over what begins at an event, and nothing of the error shows.
fn first_step(
    flow: &Flow<'_>,
    here: &mut Here,
    (from, to): (f64, f64),
    options: &Options,
    order: f64,
) -> Result<f64, OdeError> {
    flow.rates(from, &here.state, &mut here.rate);
    here.statistics.evaluations += 1;
    if let Some(component) = first_bad(&here.rate, here.rate.len()) {
        let time = from;
        return Err(OdeError::NotFinite { time, component });
    }
    let direction = (to - from).signum();
    let limit = (to - from).abs().min(options.max_step.unwrap_or(f64::INFINITY));
    if let Some(step) = options.fixed_step {
        return Ok(direction * step.min(limit));
    }
    let limit = limit.min(options.first_step.unwrap_or(f64::INFINITY));
    let ends =
        |here: &Here, values: &[f64]| scaled_size(options, (&here.state, &here.state), values);
    let (size, rate) = (ends(here, &here.state), ends(here, &here.rate));
    // Where nothing of the error determines it, a smaller tolerance takes a shorter one all the same: else solutions with
    // different ones would take the same steps, and err alike.
    let probe = match size < 1e-5 || rate < 1e-5 {
        true => 1e-6 * (1e6 * options.rtol).powf(1.0 / order),
        false => 0.01 * size / rate,
    };
    // A state that is next to nothing asks for a step that the time does not feel.
    let probe = probe.max(SHORTEST * f64::EPSILON * from.abs().max(to.abs()));
    let probe = direction * limit.min(probe);
    for (index, trial) in here.trial.iter_mut().enumerate() {
        *trial = here.state[index] + probe * here.rate[index];
    }
    flow.rates(from + probe, &here.trial, &mut here.next);
    here.statistics.evaluations += 1;
    for (index, error) in here.error.iter_mut().enumerate() {
        *error = (here.next[index] - here.rate[index]) / probe;
    }
    let steepest = rate.max(ends(here, &here.error));
    let step = match steepest <= 1e-15 {
        true => (1e-3 * probe.abs()).max(1e-6),
        false => (0.01 / steepest).powf(1.0 / order),
    };
    let step = step.min(100.0 * probe.abs()).min(limit);
    Ok(direction
        * match step.is_finite() && step > 0.0 {
            true => step,
            false => limit.min(1e-6),
        })
}
