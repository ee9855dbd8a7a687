//! The Radau IIA method of order 5.
//!
//! E. Hairer, G. Wanner: *Solving Ordinary Differential Equations II*, 2nd edition, section IV.8 (program RADAU5). Three
//! stages that collocate at `c₁, c₂, 1` (table IV.5.6); it is L-stable and stiffly accurate. The letters are those of the
//! book: `Zᵢ = Yᵢ - y₀` are the stages, `W = T⁻¹Z` the transformed ones (8.5).
//!
//! The error estimate is of order 3 and so is the continuous solution, the collocation polynomial. The tolerances are
//! taken as they are, so that the continuous solution keeps them; RADAU5 itself replaces `rtol` by `0.1 rtol^(2/3)`, which
//! makes the ends of the steps just as accurate as asked for and all between them less.

mod newton;

use super::here::{Here, scaled_size};
use super::rounding::Rounding;
use super::stepper::{Attempt, Stepper};
use crate::dense::{Complex, Lu, factor_complex};
use crate::model::Flow;
use crate::ode::{OdeError, Options};
use newton::{ALPHA, BETA, GAMMA, ITERATIONS, Newton};

/// `√6`.
const ROOT_6: f64 = 2.449489742783178;
/// Times of the stages, in parts of the step (table IV.5.6).
const C: [f64; 3] = [(4.0 - ROOT_6) / 10.0, (4.0 + ROOT_6) / 10.0, 1.0];
/// Weights `e` of the error estimate over `γ₀` (8.19).
const E: [f64; 3] = [(-13.0 - 7.0 * ROOT_6) / 3.0, (-13.0 + 7.0 * ROOT_6) / 3.0, -1.0 / 3.0];
/// Smallest and largest factor from one step to the next.
const FACTORS: (f64, f64) = (0.2, 8.0);
/// Factors up to this are not worth new factors of the matrices.
const WORTH: f64 = 1.2;
/// Contraction of Newton's method above which the Jacobian is evaluated anew.
const CONTRACTION: f64 = 1e-3;
/// Relative change of the step that the factors of the matrices bear.
const SAME_STEP: f64 = 1e-5;

/// The Jacobian that there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Jacobian {
    /// None, or one that is no longer good enough.
    Missing,
    /// That of an earlier state.
    Earlier,
    /// That of this state.
    Fresh,
}

/// A matrix that is factored.
#[derive(Clone, Debug)]
struct Factors<T> {
    entries: Vec<T>,
    pivots: Vec<usize>,
}

impl<T: Clone> Factors<T> {
    /// Room for a square matrix.
    fn new(size: usize, zero: T) -> Self {
        Self { entries: vec![zero; size * size], pivots: vec![0; size] }
    }
}

/// The memory of the method.
#[derive(Clone, Debug)]
pub(super) struct Radau {
    /// `(γ/h) I - J`, factored.
    real: Factors<f64>,
    /// `((α + iβ)/h) I - J`, factored.
    complex: Factors<Complex>,
    /// The step for which they are factored.
    factored: Option<f64>,
    jacobian: Jacobian,
    newton: Newton,
    /// Length of the last step, whose continuous solution predicts the stages.
    before: Option<f64>,
    /// Length and error of the last accepted step.
    previous: Option<(f64, f64)>,
    /// Whether the last attempt was rejected.
    rejected: bool,
    rounding: Rounding,
}

impl Radau {
    /// Coefficients of the continuous solution.
    pub const DEGREE: usize = 3;

    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        Self {
            real: Factors::new(states, 0.0),
            complex: Factors::new(states, [0.0; 2]),
            factored: None,
            jacobian: Jacobian::Missing,
            newton: Newton::new(states),
            before: None,
            previous: None,
            rejected: false,
            rounding: Rounding::new(states),
        }
    }

    /// Factors both matrices for a step unless they are. False if one has no inverse.
    fn factor(&mut self, here: &mut Here, length: f64) -> bool {
        if self.factored.is_some_and(|step| (step - length).abs() <= SAME_STEP * length.abs()) {
            return true;
        }
        self.factored = None;
        let n = here.state.len();
        for row in 0..n {
            for column in 0..n {
                let entry = -here.jacobian[column * n + row];
                let (mut real, mut complex) = (entry, [entry, 0.0]);
                if row == column {
                    real += GAMMA / length;
                    complex = [entry + ALPHA / length, BETA / length];
                }
                self.real.entries[row * n + column] = real;
                self.complex.entries[row * n + column] = complex;
            }
        }
        here.statistics.factorizations += 1;
        let is_done = Lu::factor(&mut self.real.entries, n, &mut self.real.pivots).is_ok()
            && factor_complex(&mut self.complex.entries, n, &mut self.complex.pivots).is_ok();
        if is_done {
            self.factored = Some(length);
        }
        is_done
    }

    /// The stages to begin with: the continuous solution of the last step goes on, or there is none and nothing moves.
    fn predict(&mut self, here: &Here, length: f64) {
        let n = here.state.len();
        for (stage, node) in C.iter().enumerate() {
            let target = &mut self.newton.stages[stage * n..(stage + 1) * n];
            let Some(before) = self.before else {
                target.fill(0.0);
                continue;
            };
            let part = 1.0 + node * length / before;
            let [first, second, third] =
                [0, 1, 2].map(|row: usize| &here.polynomial[row * n..][..n]);
            for (index, target) in target.iter_mut().enumerate() {
                let inner = second[index] + part * third[index];
                *target = part * (first[index] + (1.0 - part) * inner) - first[index];
            }
        }
    }

    /// Solves for the stages; false if Newton's method does not get there with a Jacobian of this state.
    fn stages(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        options: &Options,
        length: f64,
    ) -> Result<bool, OdeError> {
        loop {
            if self.jacobian == Jacobian::Missing {
                here.differentiate(flow)?;
                self.jacobian = Jacobian::Fresh;
                self.factored = None;
            }
            if self.factor(here, length) {
                self.predict(here, length);
                let matrices = (&self.real, &self.complex);
                if self.newton.solve(flow, here, options, length, matrices) {
                    return Ok(true);
                }
            }
            if self.jacobian == Jacobian::Fresh {
                let is_factored = self.factored.is_some();
                let rounding = if is_factored {
                    let system = (&self.real.entries[..], &self.real.pivots[..]);
                    self.rounding.of(here, options, system)
                } else {
                    0.0
                };
                return Ok(is_factored && self.newton.has_come_to(rounding));
            }
            self.jacobian = Jacobian::Missing;
        }
    }

    /// The error estimate (8.19): `((γ/h) I - J)⁻¹ (f(t, y₀) + (1/h) Σ eᵢ Zᵢ)`. RADAU5 puts (8.20) in its place at the first
    /// step and after a rejection, which forgives a start beside the slow motion. Here such a start is an impact, and how
    /// it goes on is asked for.
    fn estimate(&self, here: &mut Here, options: &Options, length: f64) -> f64 {
        let n = here.state.len();
        for index in 0..n {
            let stages = [0, 1, 2].map(|stage: usize| self.newton.stages[stage * n + index]);
            let sum = E[0] * stages[0] + E[1] * stages[1] + E[2] * stages[2];
            here.error[index] = here.rate[index] + sum / length;
        }
        Lu::substitute(&self.real.entries, &self.real.pivots, &mut here.error);
        here.scaled_error(options)
    }

    /// Factor to the optimal step, by the last two errors (8.21 and 8.25, after K. Gustafsson).
    fn optimal(&self, length: f64, error: f64) -> f64 {
        let error = error.max(1e-30);
        let alone = error.powf(-0.25);
        let factor = match self.previous {
            Some((before, previous)) => {
                let ratio = (length / before).abs() * (previous.max(1e-2) / error).powf(0.25);
                alone * ratio.min(1.0)
            }
            None => alone,
        };
        let iterations = self.newton.iterations as f64;
        let limit = ITERATIONS as f64;
        factor * 0.9 * (2.0 * limit + 1.0) / (2.0 * limit + iterations)
    }
}

impl Stepper for Radau {
    const ERROR_ORDER: f64 = 4.0;

    fn restart(&mut self) {
        self.factored = None;
        self.jacobian = Jacobian::Missing;
        self.before = None;
        self.previous = None;
        self.rejected = false;
    }

    fn attempt(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        options: &Options,
        length: f64,
    ) -> Result<Attempt, OdeError> {
        if !self.stages(flow, here, options, length)? {
            self.rejected = true;
            return Ok(Attempt::Failed(0.5));
        }
        let last = &self.newton.stages[2 * here.state.len()..];
        for (index, trial) in here.trial.iter_mut().enumerate() {
            *trial = here.state[index] + last[index];
        }
        if options.fixed_step.is_some() {
            return Ok(Attempt::Done(0.0));
        }
        let error = self.estimate(here, options, length);
        let system = (&self.real.entries[..], &self.real.pivots[..]);
        let judged = self.rounding.judge(error, here, options, system);
        Ok(Attempt::Done(judged))
    }

    /// The polynomial of degree 3 through the begin and the three stages, by divided differences.
    fn interpolate(&mut self, here: &mut Here) {
        let n = here.state.len();
        for index in 0..n {
            let [z1, z2, z3] = [0, 1, 2].map(|stage: usize| self.newton.stages[stage * n + index]);
            let first = (z1 / C[0] - z3) / (1.0 - C[0]);
            let second = (z2 / C[1] - z3) / (1.0 - C[1]);
            let slope = (second - first) / (C[1] - C[0]);
            here.polynomial[index] = z3;
            here.polynomial[n + index] = first - C[0] * slope;
            here.polynomial[2 * n + index] = slope;
        }
    }

    fn is_rounded(&self) -> bool {
        self.rounding.limits
    }

    fn accept(&mut self, length: f64, error: f64) -> f64 {
        let largest = if self.rejected { 1.0 } else { FACTORS.1 };
        let factor = self.optimal(length, error).clamp(FACTORS.0, largest);
        self.previous = Some((length, error));
        self.before = Some(length);
        self.rejected = false;
        // The Jacobian is now one of an earlier state, good enough if the iteration converged well with it.
        self.jacobian = match self.newton.contraction <= CONTRACTION {
            true => Jacobian::Earlier,
            false => Jacobian::Missing,
        };
        match self.jacobian == Jacobian::Earlier && (1.0..=WORTH).contains(&factor) {
            true => 1.0,
            false => factor,
        }
    }

    fn reject(&mut self, length: f64, error: f64) -> f64 {
        let is_first = self.previous.is_none();
        let factor = match error.is_finite() && error > 1.0 {
            true if is_first && !self.rejected => 0.1,
            true => self.optimal(length, error).clamp(FACTORS.0, 0.9),
            false => 0.5,
        };
        self.rejected = true;
        factor
    }
}

/// Size of a change of the stages in tolerances at the begin of a step.
fn change(options: &Options, here: &Here, changes: &[f64]) -> f64 {
    let n = here.state.len();
    let ends = (&here.state[..], &here.state[..]);
    let sum: f64 =
        changes.chunks_exact(n.max(1)).map(|part| scaled_size(options, ends, part).powi(2)).sum();
    (sum / 3.0).sqrt()
}
