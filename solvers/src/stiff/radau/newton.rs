//! Simplified Newton iteration for the stages of a Radau step.
//!
//! Hairer, Wanner II, section IV.8, (8.4) to (8.11). The eigenvalues of `A⁻¹` are `γ` and `α ± iβ`; in the basis `T` of
//! their vectors the iteration is one real and one complex linear system.

use super::super::here::Here;
use super::{C, Factors, change};
use crate::dense::{Complex, Lu, substitute_complex};
use crate::model::Flow;
use crate::ode::Options;
use crate::ode::first_bad;

/// The real eigenvalue of `A⁻¹`: `3 + ∛9 - ∛3` (section IV.8).
pub(super) const GAMMA: f64 = 3.637834252744496;
/// The real part of the complex ones: `3 + (∛3 - ∛9) / 2`.
pub(super) const ALPHA: f64 = 2.6810828736277523;
/// Their imaginary part, negative for the half of the pair that goes with `T`: `-(3^(5/6) + 3^(7/6)) / 2`.
pub(super) const BETA: f64 = -3.0504301992474105;
/// Largest number of iterations.
pub(super) const ITERATIONS: usize = 7;

/// Changes in tolerances with which an iteration that gets no nearer is done.
const ROUNDING: f64 = 0.03;
/// Contraction from which on it gets no nearer.
const STALLED: f64 = 0.5;

/// `T` of RADAU5: the eigenvectors of `A⁻¹`, their last row `1, 1, 0`.
const T: [[f64; 3]; 3] = [
    [0.09443876248897524, -0.1412552950209542, 0.03002919410514742],
    [0.2502131229653333, 0.2041293522937999, -0.3829421127572619],
    [1.0, 1.0, 0.0],
];
/// Its inverse.
const INVERSE: [[f64; 3]; 3] = [
    [4.178718591551905, 0.3276828207610624, 0.5233764454994495],
    [-4.178718591551905, -0.3276828207610624, 0.4766235545005505],
    [0.5028726349457868, -2.571926949855605, 0.5960392048282249],
];

/// Stages under iteration.
#[derive(Clone, Debug)]
pub(super) struct Newton {
    /// `Z₁, Z₂, Z₃`.
    pub stages: Vec<f64>,
    /// Iterations of the last solution.
    pub iterations: usize,
    /// How much each brought it nearer.
    pub contraction: f64,
    /// Size of the last change, in tolerances.
    last: f64,
    /// `W₁, W₂, W₃`.
    transformed: Vec<f64>,
    /// The rates at the stages.
    rates: Vec<f64>,
    /// The changes of `W`.
    changes: Vec<f64>,
    /// Right-hand side of the complex system.
    right: Vec<Complex>,
    /// A state.
    state: Vec<f64>,
}

impl Newton {
    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        Self {
            stages: vec![0.0; 3 * states],
            iterations: 0,
            contraction: 0.0,
            last: f64::INFINITY,
            transformed: vec![0.0; 3 * states],
            rates: vec![0.0; 3 * states],
            changes: vec![0.0; 3 * states],
            right: vec![[0.0; 2]; states],
            state: vec![0.0; states],
        }
    }

    /// Whether an iteration that did not converge came to changes that small and no smaller, in tolerances: those of
    /// rounding, if the Jacobian is that of this state.
    pub fn has_come_to(&self, rounding: f64) -> bool {
        self.last <= rounding || self.last <= ROUNDING && self.contraction >= STALLED
    }

    /// Iterates from the stages that stand there; false if they do not converge.
    pub fn solve(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        options: &Options,
        length: f64,
        (real, complex): (&Factors<f64>, &Factors<Complex>),
    ) -> bool {
        let n = here.state.len();
        // The error of the iteration is to be small beside that of the step, and not below rounding (IV.8, (8.10)).
        let limit = (10.0 * f64::EPSILON / options.rtol).max(options.rtol.sqrt().min(0.03));
        let mut before: Option<f64> = None;
        self.contraction = 0.0;
        self.last = f64::INFINITY;
        multiply(&INVERSE, &self.stages, &mut self.transformed, n);
        for iteration in 0..ITERATIONS {
            self.iterations = iteration + 1;
            if !self.evaluate(flow, here, length) {
                return false;
            }
            self.improve(length, real, complex);
            let size = change(options, here, &self.changes);
            self.last = size;
            if !size.is_finite() {
                here.bad = first_bad(&self.changes, n);
                return false;
            }
            let contraction = before.map(|before| size / before);
            if let Some(contraction) = contraction {
                self.contraction = self.contraction.max(contraction);
                let left = (ITERATIONS - 1 - iteration) as i32;
                // The error that will be left after all iterations (8.11).
                if contraction >= 1.0 || contraction.powi(left) / (1.0 - contraction) * size > limit
                {
                    here.error.copy_from_slice(&self.changes[..n]);
                    return false;
                }
            }
            for (target, change) in self.transformed.iter_mut().zip(&self.changes) {
                *target += change;
            }
            multiply(&T, &self.transformed, &mut self.stages, n);
            let left = contraction.map(|contraction| contraction / (1.0 - contraction) * size);
            if size == 0.0 || left.is_some_and(|left| left < limit) {
                return true;
            }
            before = Some(size);
        }
        here.error.copy_from_slice(&self.changes[..n]);
        false
    }

    /// The rates at the stages; false if one is not finite.
    fn evaluate(&mut self, flow: &Flow<'_>, here: &mut Here, length: f64) -> bool {
        let n = here.state.len();
        for (stage, node) in C.iter().enumerate() {
            let range = stage * n..(stage + 1) * n;
            for (index, state) in self.state.iter_mut().enumerate() {
                *state = here.state[index] + self.stages[range.start + index];
            }
            let rate = &mut self.rates[range];
            flow.rates(here.time + node * length, &self.state, rate);
            here.statistics.evaluations += 1;
            here.bad = first_bad(rate, n);
            if here.bad.is_some() {
                return false;
            }
        }
        true
    }

    /// The changes of `W` by the two linear systems.
    fn improve(&mut self, length: f64, real: &Factors<f64>, complex: &Factors<Complex>) {
        let n = self.state.len();
        let [gamma, alpha, beta] = [GAMMA, ALPHA, BETA].map(|value| value / length);
        multiply(&INVERSE, &self.rates, &mut self.changes, n);
        let (first, others) = self.changes.split_at_mut(n);
        let (second, third) = others.split_at_mut(n);
        for index in 0..n {
            let [w1, w2, w3] = [0, 1, 2].map(|row: usize| self.transformed[row * n + index]);
            first[index] -= gamma * w1;
            self.right[index] =
                [second[index] - (alpha * w2 - beta * w3), third[index] - (alpha * w3 + beta * w2)];
        }
        Lu::substitute(&real.entries, &real.pivots, first);
        substitute_complex(&complex.entries, &complex.pivots, &mut self.right);
        for (index, [real, imaginary]) in self.right.iter().enumerate() {
            (second[index], third[index]) = (*real, *imaginary);
        }
    }
}

/// A matrix times three vectors that stand one after the other.
fn multiply(matrix: &[[f64; 3]; 3], from: &[f64], to: &mut [f64], n: usize) {
    for (row, factors) in matrix.iter().enumerate() {
        for index in 0..n {
            to[row * n + index] = factors[0] * from[index]
                + factors[1] * from[n + index]
                + factors[2] * from[2 * n + index];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `A` of Radau IIA (table IV.5.6).
    fn tableau() -> [[f64; 3]; 3] {
        let s = 6.0_f64.sqrt();
        [
            [(88.0 - 7.0 * s) / 360.0, (296.0 - 169.0 * s) / 1800.0, (-2.0 + 3.0 * s) / 225.0],
            [(296.0 + 169.0 * s) / 1800.0, (88.0 + 7.0 * s) / 360.0, (-2.0 - 3.0 * s) / 225.0],
            [(16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0],
        ]
    }

    fn product(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    }

    #[test]
    fn the_transformation_makes_blocks_of_the_tableau() {
        // T⁻¹ A T times the blocks of its inverse is the unit matrix.
        let blocks = [[GAMMA, 0.0, 0.0], [0.0, ALPHA, -BETA], [0.0, BETA, ALPHA]];
        let inner = product(&product(&INVERSE, &tableau()), &T);
        let unit = product(&inner, &blocks);
        for (i, row) in unit.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let expected = f64::from(u8::from(i == j));
                assert!((entry - expected).abs() < 1e-14, "{i} {j} {entry}");
            }
        }
        assert_eq!(C[0], (4.0 - 6.0_f64.sqrt()) / 10.0);
    }
}
