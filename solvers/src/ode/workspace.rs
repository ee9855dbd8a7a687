//! The memory of an integration and the parts of a step.

use super::combine::combine;
use super::error::OdeError;
use super::norm::{first_bad, scaled_size};
use super::options::Options;
use super::system::System;
use super::tableau::Method;
use crate::scalar::Scalar;

/// Roundings of the time that a first step has at least.
pub(crate) const SHORTEST: f64 = 1e3;

/// The memory of an integration. With states of fixed length nothing in it is on the heap.
pub struct Workspace<V, M: Method> {
    /// State at the begin of the step.
    pub(super) state: V,
    /// State at its end.
    pub(super) trial: V,
    /// State of an inner stage.
    pub(super) stage: V,
    /// The error estimate.
    pub(super) error: V,
    /// The second error estimate.
    pub(super) second: V,
    /// The slopes.
    pub(super) slopes: M::Slopes<V>,
    /// The coefficients of the continuous solution.
    pub(super) polynomial: M::Polynomial<V>,
}

impl<V: Clone, M: Method> Workspace<V, M> {
    /// Room for the states of a system.
    pub fn new<S: Scalar, Y: System<S, State = V>>(system: &Y) -> Self {
        Self {
            state: system.zeros(),
            trial: system.zeros(),
            stage: system.zeros(),
            error: system.zeros(),
            second: system.zeros(),
            slopes: M::slopes(|_| system.zeros()),
            polynomial: M::polynomial(|_| system.zeros()),
        }
    }

    /// The state where the last integration ended.
    pub fn state(&self) -> &V {
        &self.state
    }

    /// The slope at the start, and the length of a first step unless one is given (Hairer, Nørsett, Wanner, II.4,
    /// "Starting step size"). Both evaluations share one place in the code, which inlining would otherwise double.
    #[inline(always)]
    pub(super) fn begin<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        (from, to): (f64, f64),
        options: &Options,
    ) -> Result<f64, OdeError> {
        let limit = (to - from)
            .abs()
            .min(options.max_step.unwrap_or(f64::INFINITY));
        let direction = (to - from).signum();
        let (mut time, mut probe, mut rate) = (from, 0.0, 0.0);
        self.stage.clone_from(&self.state);
        for number in 0..2 {
            let [instant] = system.instants([S::from_f64(time)]);
            system.rate(&instant, &self.stage, &mut self.slopes.as_mut()[number]);
            if number == 1 {
                break;
            }
            if let Some(component) = first_bad::<S, Y>(&self.slopes.as_ref()[0]) {
                return Err(OdeError::NotFinite { time, component });
            }
            if let Some(step) = options.first_step.or(options.fixed_step) {
                return Ok(direction * step.min(limit));
            }
            let state = (&self.state, &self.state);
            let size = scaled_size(system, options, state, &self.state, None);
            rate = scaled_size(system, options, state, &self.slopes.as_ref()[0], None);
            probe = if size < 1e-5 || rate < 1e-5 {
                1e-6
            } else {
                0.01 * size / rate
            };
            // A state that is next to nothing asks for a step that the time does not feel.
            probe = probe.max(SHORTEST * f64::EPSILON * from.abs().max(to.abs()));
            probe = direction * limit.min(probe);
            time = from + probe;
            combine::<S, Y>(
                &mut self.stage,
                Some(&self.state),
                probe,
                &[(0, 1.0)],
                self.slopes.as_ref(),
            );
        }
        combine::<S, Y>(
            &mut self.error,
            None,
            1.0 / probe,
            &[(0, -1.0), (1, 1.0)],
            self.slopes.as_ref(),
        );
        let change = scaled_size(
            system,
            options,
            (&self.state, &self.state),
            &self.error,
            None,
        );
        let steepest = rate.max(change);
        let step = if steepest <= 1e-15 {
            (1e-3 * probe.abs()).max(1e-6)
        } else {
            (0.01 / steepest).powf(1.0 / M::ORDER as f64)
        };
        let step = step.min(100.0 * probe.abs()).min(limit);
        Ok(direction
            * if step.is_finite() {
                step
            } else {
                limit.min(1e-6)
            })
    }

    /// Evaluates the stages of a step and its end state, and gives the instants of the stages.
    #[inline(always)]
    pub(super) fn attempt<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        time: f64,
        step: f64,
    ) -> M::Nodes<Y::Instant> {
        let instants = M::instants(system, S::from_f64(time), S::from_f64(step));
        if Y::CALLED {
            self.sweep_stages(system, (time, step), false);
            return instants;
        }
        let slopes = self.slopes.as_mut();
        let end = if M::ERROR_USES_LAST {
            M::STAGES + 1
        } else {
            M::STAGES
        };
        for number in 1..end {
            let is_end = number == M::STAGES;
            let row = if is_end {
                M::WEIGHTS
            } else {
                M::ROWS[number - 1]
            };
            let stage = if is_end {
                &mut self.trial
            } else {
                &mut self.stage
            };
            combine::<S, Y>(stage, Some(&self.state), step, row, slopes);
            let instant = &instants.as_ref()[number.min(M::STAGES - 1) - 1];
            system.rate(instant, stage, &mut slopes[number]);
        }
        if !M::ERROR_USES_LAST {
            combine::<S, Y>(&mut self.trial, Some(&self.state), step, M::WEIGHTS, slopes);
        }
        instants
    }

    /// The error of the attempt in tolerances.
    #[inline(always)]
    pub(super) fn estimate<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        step: f64,
        options: &Options,
    ) -> f64 {
        // A sweep has computed the errors.
        if !Y::CALLED {
            let slopes = self.slopes.as_ref();
            combine::<S, Y>(&mut self.error, None, step, M::ERROR, slopes);
            if !M::SECOND_ERROR.is_empty() {
                combine::<S, Y>(&mut self.second, None, step, M::SECOND_ERROR, slopes);
            }
        }
        let second = match M::SECOND_ERROR {
            [] => None,
            _ => Some(&self.second),
        };
        scaled_size(
            system,
            options,
            (&self.state, &self.trial),
            &self.error,
            second,
        )
    }

    /// Keeps the state of the last inner stage, which the stages of the dense output would overwrite.
    #[inline(always)]
    pub(super) fn keep_last_stage(&mut self) {
        std::mem::swap(&mut self.stage, &mut self.second);
    }

    /// `|λ|` of the fastest change that the equations show in a step that is finished: the rates of its end and of the last
    /// inner stage, which lies at its end too, over what these two states differ by (Hairer, Wanner II, section IV.2,
    /// (2.25)). Needs [`Workspace::keep_last_stage`].
    #[inline(always)]
    pub(super) fn fastest_rate<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        options: &Options,
    ) -> f64 {
        let ends = (&self.state, &self.trial);
        let slopes = self.slopes.as_ref();
        for part in 0..Y::parts(&self.trial) {
            for index in 0..Y::part(&self.trial, part).len() {
                let end = Y::part(&slopes[M::STAGES], part)[index];
                let last = Y::part(&slopes[M::STAGES - 1], part)[index];
                Y::part_mut(&mut self.error, part)[index] = end - last;
                let state = Y::part(&self.trial, part)[index];
                let stage = &mut Y::part_mut(&mut self.second, part)[index];
                *stage = state - *stage;
            }
        }
        let change = scaled_size(system, options, ends, &self.second, None);
        match change > 0.0 {
            true => scaled_size(system, options, ends, &self.error, None) / change,
            false => 0.0,
        }
    }

    /// Evaluates what is still missing of an accepted step: the slope at its end and, if asked for, the stages and
    /// coefficients of the continuous solution. Gives the number of evaluations.
    #[inline(always)]
    pub(super) fn finish<S: Scalar, Y: System<S, State = V>>(
        &mut self,
        system: &Y,
        instants: &M::Nodes<Y::Instant>,
        (time, step): (f64, f64),
        dense: bool,
    ) -> usize {
        if Y::CALLED {
            return self.sweep_rest(system, time, step, dense);
        }
        let extra = if dense {
            Some(M::extra_instants(
                system,
                S::from_f64(time),
                S::from_f64(step),
            ))
        } else {
            None
        };
        let slopes = self.slopes.as_mut();
        let first = if M::ERROR_USES_LAST {
            M::STAGES + 1
        } else {
            M::STAGES
        };
        let end = M::STAGES + 1 + if dense { M::EXTRA_ROWS.len() } else { 0 };
        for number in first..end {
            let (row, instant) = match &extra {
                Some(extra) if number > M::STAGES => {
                    let index = number - M::STAGES - 1;
                    (M::EXTRA_ROWS[index], &extra.as_ref()[index])
                }
                _ => (M::WEIGHTS, &instants.as_ref()[M::STAGES - 2]),
            };
            combine::<S, Y>(&mut self.stage, Some(&self.state), step, row, slopes);
            system.rate(instant, &self.stage, &mut slopes[number]);
        }
        if dense {
            self.interpolate::<S, Y>(step);
        }
        end - first
    }

    /// The coefficients of the continuous solution.
    #[inline(always)]
    pub(super) fn interpolate<S: Scalar, Y: System<S, State = V>>(&mut self, step: f64) {
        let (slopes, polynomial) = (self.slopes.as_ref(), self.polynomial.as_mut());
        for part in 0..Y::parts(&self.state) {
            let scale = S::from_f64(step);
            for index in 0..Y::part(&self.state, part).len() {
                let change = Y::part(&self.trial, part)[index] - Y::part(&self.state, part)[index];
                let begin = scale * Y::part(&slopes[0], part)[index] - change;
                let end = change - scale * Y::part(&slopes[M::STAGES], part)[index];
                Y::part_mut(&mut polynomial[0], part)[index] = change;
                Y::part_mut(&mut polynomial[1], part)[index] = begin;
                Y::part_mut(&mut polynomial[2], part)[index] = end - begin;
            }
        }
        // Written out, so that the coefficients are constants where this is a function of its own.
        macro_rules! rows {
            ($($row:literal)*) => {
                $(if $row < M::DENSE_ROWS.len() {
                    combine::<S, Y>(&mut polynomial[3 + $row], None, step, M::DENSE_ROWS[$row], slopes);
                })*
            };
        }
        if Y::CALLED {
            rows!(0 1 2 3);
            return;
        }
        for (target, row) in polynomial.iter_mut().skip(3).zip(M::DENSE_ROWS) {
            combine::<S, Y>(target, None, step, row, slopes);
        }
    }
}
