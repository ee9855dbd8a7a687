//! Steps of several methods in one motion: the polynomials of all become powers.

use super::{Recorder, Trajectory};
use crate::ode::observer::{Basis, Step};
use crate::series::TERMS;

impl Recorder {
    /// Keeps a step whose polynomial is of another kind than those before it.
    #[cold]
    pub(super) fn step_of_another_kind(&mut self, step: &Step<'_>) {
        let trajectory = &mut self.trajectory;
        let states = step.before.len();
        let own = step.polynomial.len() / states.max(1);
        trajectory.become_powers(trajectory.degree.max(own));
        trajectory.times.push(step.to);
        trajectory.last = step.to - step.from;
        let begin = trajectory.coefficients.len();
        trajectory.coefficients[begin - states..].copy_from_slice(step.before);
        trajectory.coefficients.extend_from_slice(step.polynomial);
        if step.basis == Basis::Alternating {
            to_powers(&mut trajectory.coefficients[begin..], states);
        }
        trajectory.coefficients.resize(begin + trajectory.degree * states, 0.0);
        trajectory.coefficients.extend_from_slice(step.after);
    }
}

impl Trajectory {
    /// Makes all polynomials powers up to a degree that is not below their own.
    fn become_powers(&mut self, degree: usize) {
        if self.basis == Basis::Powers && self.degree == degree {
            return;
        }
        let states = self.states;
        let mut coefficients = Vec::with_capacity(self.times.len() * (2 + degree) * states);
        let steps = self.coefficients.chunks((1 + self.degree) * states.max(1));
        for (step, _) in steps.zip(1..self.times.len()) {
            let begin = coefficients.len();
            coefficients.extend_from_slice(step);
            if self.basis == Basis::Alternating {
                to_powers(&mut coefficients[begin + states..], states);
            }
            coefficients.resize(begin + (1 + degree) * states, 0.0);
        }
        coefficients.extend_from_slice(self.end());
        (self.coefficients, self.degree, self.basis) = (coefficients, degree, Basis::Powers);
    }
}

/// Coefficients of [`Basis::Alternating`], one row of all states behind the other, become those of [`Basis::Powers`].
fn to_powers(rows: &mut [f64], states: usize) {
    let degree = rows.len() / states.max(1);
    for index in 0..states {
        // By Horner's rule, as the polynomial is evaluated.
        let mut powers = [0.0; 1 + TERMS];
        for row in (1..=degree).rev() {
            powers[0] += rows[(row - 1) * states + index];
            let is_even = row % 2 == 0;
            for power in (0..=degree - row).rev() {
                let value = powers[power];
                powers[power + 1] = if is_even { powers[power + 1] - value } else { value };
            }
            if !is_even {
                powers[0] = 0.0;
            }
        }
        for (row, power) in powers[1..=degree].iter().enumerate() {
            rows[row * states + index] = *power;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ode::Observer;

    /// A polynomial of a degree for two states, whose coefficients are of a size like those of methods.
    fn polynomial(degree: usize) -> Vec<f64> {
        (0..2 * degree).map(|k| (1.0 + 0.7 * k as f64).sin()).collect()
    }

    fn recorded(steps: &[(usize, Basis)]) -> Trajectory {
        let mut recorder = Recorder::new(0.0, &[1.0, -1.0]);
        for (number, (degree, basis)) in steps.iter().enumerate() {
            let (from, polynomial) = (number as f64, polynomial(*degree));
            let (before, after) = (&[1.0, -1.0][..], &[1.0, -1.0][..]);
            let basis = *basis;
            recorder.step(&Step {
                from,
                to: from + 1.0,
                before,
                after,
                polynomial: &polynomial,
                basis,
            });
        }
        recorder.finish(crate::ode::Statistics::default())
    }

    #[test]
    fn a_motion_of_several_methods_is_what_each_of_them_says() {
        use Basis::{Alternating, Powers};
        let kinds =
            [(7, Alternating), (7, Alternating), (18, Powers), (4, Alternating), (20, Powers)];
        let together = recorded(&kinds);
        for (number, kind) in kinds.into_iter().enumerate() {
            let alone = recorded(&[kind]);
            for part in 0..10 {
                let part = 0.05 + 0.1 * f64::from(part);
                let (time, expected) = (number as f64 + part, alone.at(part));
                let slopes = alone.derivative_at(part);
                for index in 0..2 {
                    let off = together.at(time)[index] - expected[index];
                    let slope = together.derivative_at(time)[index] - slopes[index];
                    assert!(
                        off.abs() < 1e-14 && slope.abs() < 2e-13,
                        "{number} {part} {off:e} {slope:e}"
                    );
                }
            }
        }
    }
}
