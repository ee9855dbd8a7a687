//! The Rosenbrock method Rodas5P.
//!
//! G. Steinebach: *Construction of Rosenbrock–Wanner method Rodas5P and numerical benchmarks within the Julia
//! Differential Equations package*, BIT Numerical Mathematics 63 (2023) 27. Eight stages, order 5 with an error estimate
//! of order 4, continuous output of order 4; L-stable and stiffly accurate, and its order hardly suffers where the
//! Prothero–Robinson problem reduces that of others. Each step takes one Jacobian and one factorization, and no iteration.
//!
//! The stages are those of Hairer, Wanner II, section IV.7, (7.25): with `Uᵢ = Σ γᵢⱼ kⱼ` no product with the Jacobian is
//! left. The partial derivative `∂f/∂t` is a difference quotient of second order, of two evaluations within the step.

mod tableau;

use super::here::Here;
use super::rounding::Rounding;
use super::stepper::{Attempt, Stepper};
use crate::dense::Lu;
use crate::model::Flow;
use crate::ode::{Controller, OdeError, Options, first_bad};
use tableau::{A, C, DENSE, GAMMA, NODES, STAGES, TIME_WEIGHTS};

/// Parts of the step over which the time derivative of the rates is measured: so short that the error of the quotient
/// does not show beside that of the method, so long that rounding does not either.
const PROBE: f64 = 1e-3;

/// The memory of the method.
#[derive(Clone, Debug)]
pub(super) struct Rosenbrock {
    /// `I / (γh) - J`, factored, and its pivots.
    matrix: (Vec<f64>, Vec<usize>),
    /// The stages `Uᵢ`, one after the other.
    stages: Vec<f64>,
    /// `∂f/∂t` at the begin of the step.
    drift: Vec<f64>,
    /// Room for the state and the rate of a stage.
    state: Vec<f64>,
    rate: Vec<f64>,
    controller: Controller,
    rounding: Rounding,
    /// Whether Jacobian and time derivative are those of this state.
    is_fresh: bool,
}

impl Rosenbrock {
    /// Coefficients of the continuous solution.
    pub const DEGREE: usize = 4;

    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        Self {
            matrix: (vec![0.0; states * states], vec![0; states]),
            stages: vec![0.0; STAGES * states],
            drift: vec![0.0; states],
            state: vec![0.0; states],
            rate: vec![0.0; states],
            controller: control(),
            rounding: Rounding::new(states),
            is_fresh: false,
        }
    }

    /// Factors the matrix of a step; false if it has no inverse.
    fn factor(&mut self, here: &mut Here, length: f64) -> bool {
        let n = here.state.len();
        for row in 0..n {
            for column in 0..n {
                self.matrix.0[row * n + column] = -here.jacobian[column * n + row];
            }
            self.matrix.0[row * n + row] += 1.0 / (GAMMA * length);
        }
        here.statistics.factorizations += 1;
        Lu::factor(&mut self.matrix.0, n, &mut self.matrix.1).is_ok()
    }

    /// `∂f/∂t` from the rates at the begin and at two later times, by divided differences. Rates that do not change with
    /// the time show it at the first of them.
    fn differentiate_time(&mut self, flow: &Flow<'_>, here: &mut Here, length: f64) {
        let times = [here.time + PROBE * length, here.time + 2.0 * PROBE * length];
        let [first, second] = times.map(|time| time - here.time);
        flow.rates(times[0], &here.state, &mut self.drift);
        here.statistics.evaluations += 1;
        if self.drift == here.rate || first == 0.0 || first == second {
            self.drift.fill(0.0);
            return;
        }
        flow.rates(times[1], &here.state, &mut self.rate);
        here.statistics.evaluations += 1;
        for (index, drift) in self.drift.iter_mut().enumerate() {
            let near = (*drift - here.rate[index]) / first;
            let far = (self.rate[index] - here.rate[index]) / second;
            *drift = (second * near - first * far) / (second - first);
        }
    }

    /// Computes the stages; false if a rate is not finite.
    fn stages(&mut self, flow: &Flow<'_>, here: &mut Here, length: f64) -> bool {
        let n = here.state.len();
        for stage in 0..STAGES {
            let (known, unknown) = self.stages.split_at_mut(stage * n);
            let target = &mut unknown[..n];
            self.state.copy_from_slice(&here.state);
            add(&mut self.state, known, A[stage], 1.0);
            // At the first stage the rate is known.
            match stage {
                0 => self.rate.copy_from_slice(&here.rate),
                _ => {
                    let time = here.time + NODES[stage] * length;
                    flow.rates(time, &self.state, &mut self.rate);
                    here.statistics.evaluations += 1;
                }
            }
            here.bad = first_bad(&self.rate, self.rate.len());
            if here.bad.is_some() {
                return false;
            }
            for (index, target) in target.iter_mut().enumerate() {
                *target = self.rate[index] + TIME_WEIGHTS[stage] * length * self.drift[index];
            }
            add(target, known, C[stage], 1.0 / length);
            Lu::substitute(&self.matrix.0, &self.matrix.1, target);
        }
        // The method is stiffly accurate: the last stage is the error, and with it the last state is the result.
        let last = &self.stages[(STAGES - 1) * n..];
        here.error.copy_from_slice(last);
        for (index, trial) in here.trial.iter_mut().enumerate() {
            *trial = self.state[index] + last[index];
        }
        true
    }
}

impl Stepper for Rosenbrock {
    const ERROR_ORDER: f64 = 5.0;

    fn restart(&mut self) {
        self.controller = control();
        self.is_fresh = false;
    }

    fn attempt(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        options: &Options,
        length: f64,
    ) -> Result<Attempt, OdeError> {
        if !self.is_fresh {
            here.differentiate(flow)?;
            self.differentiate_time(flow, here, length);
            self.is_fresh = true;
        }
        if !self.factor(here, length) || !self.stages(flow, here, length) {
            return Ok(Attempt::Failed(0.5));
        }
        if options.fixed_step.is_some() {
            return Ok(Attempt::Done(0.0));
        }
        let error = here.scaled_error(options);
        let system = (&self.matrix.0[..], &self.matrix.1[..]);
        let judged = self.rounding.judge(error, here, options, system);
        Ok(Attempt::Done(judged))
    }

    fn is_rounded(&self) -> bool {
        self.rounding.limits
    }

    fn interpolate(&mut self, here: &mut Here) {
        let n = here.state.len();
        for index in 0..n {
            let [first, second, third] = DENSE.map(|row| {
                let terms = row.iter().enumerate();
                terms.map(|(stage, weight)| weight * self.stages[stage * n + index]).sum::<f64>()
            });
            // Published is θ(F₁ + (1-θ)(a + θ(b + θ c))).
            here.polynomial[index] = here.trial[index] - here.state[index];
            here.polynomial[n + index] = first;
            here.polynomial[2 * n + index] = second + third;
            here.polynomial[3 * n + index] = -third;
        }
    }

    fn accept(&mut self, _length: f64, error: f64) -> f64 {
        self.is_fresh = false;
        self.controller.accept(error)
    }

    fn reject(&mut self, _length: f64, error: f64) -> f64 {
        match error.is_finite() && error <= 1.0 {
            true => 0.5,
            false => self.controller.reject(error),
        }
    }
}

/// The control of the step size.
fn control() -> Controller {
    Controller::new(5, 0.0, (0.2, 6.0))
}

/// Adds multiples of the stages that are known.
fn add(target: &mut [f64], stages: &[f64], weights: &[f64], factor: f64) {
    for (stage, weight) in stages.chunks_exact(target.len().max(1)).zip(weights) {
        let weight = weight * factor;
        for (target, stage) in target.iter_mut().zip(stage) {
            *target += weight * stage;
        }
    }
}
