//! When a stiff method is no longer needed.

use super::here::Here;
use crate::model::Flow;
use crate::ode::OdeError;

/// Squarings of the Jacobian. Of its power 2⁶ the 64th root of the norm is left, so that a badly scaled Jacobian
/// (of a mass and a spring: entries 1 and `ω²`, eigenvalues `±iω`) is measured by its eigenvalues.
const SQUARINGS: u32 = 6;
/// Steps that are so many times longer are far longer,
const NEAR: f64 = 4.0;
/// unless the Jacobian has been evaluated so often since it was measured.
const OLD: usize = 16;
/// Steps in a row after which it is believed.
const STEPS: usize = 20;

/// Counts steps that are no longer than those of the explicit method would be.
#[derive(Clone, Debug)]
pub(super) struct Calm {
    /// Spectral radius of the Jacobian, 1/s.
    radius: f64,
    /// `h ρ(J)` of the explicit method.
    product: f64,
    /// Jacobians evaluated when the radius was measured.
    jacobians: usize,
    /// Steps in a row.
    steps: usize,
    /// Room for two matrices.
    power: Vec<f64>,
    square: Vec<f64>,
}

impl Calm {
    /// Room for so many states.
    pub fn new(states: usize) -> Self {
        Self {
            radius: 0.0,
            product: 0.0,
            jacobians: 0,
            steps: 0,
            power: vec![0.0; states * states],
            square: vec![0.0; states * states],
        }
    }

    /// Measures `h ρ(J)` of the explicit method, whose steps have a length, and begins to count.
    pub fn begin(
        &mut self,
        flow: &Flow<'_>,
        here: &mut Here,
        length: f64,
    ) -> Result<f64, OdeError> {
        here.differentiate(flow)?;
        self.radius = self.spectral_radius(&here.jacobian, here.state.len());
        self.product = length * self.radius;
        self.steps = 0;
        Ok(self.product)
    }

    /// The Jacobians are counted from zero again.
    pub fn restart(&mut self) {
        self.jacobians = 0;
    }

    /// Counts a step; whether there were enough that are no longer than those of the explicit method would be.
    pub fn is_enough(&mut self, here: &Here, length: f64) -> bool {
        // Where the steps are far longer it need not be known better.
        let is_near = length.abs() * self.radius < NEAR * self.product;
        let is_old = here.statistics.jacobians >= self.jacobians + OLD;
        if is_old || is_near && self.jacobians != here.statistics.jacobians {
            self.jacobians = here.statistics.jacobians;
            self.radius = self.spectral_radius(&here.jacobian, here.state.len());
        }
        match length.abs() * self.radius < self.product {
            true => self.steps += 1,
            false => self.steps = 0,
        }
        self.steps >= STEPS
    }

    /// An upper bound of the spectral radius by I. Gelfand's formula `ρ(J) = lim ‖Jᵏ‖^(1/k)`.
    fn spectral_radius(&mut self, jacobian: &[f64], n: usize) -> f64 {
        self.power.copy_from_slice(jacobian);
        let (mut logarithm, mut root) = (0.0, 1.0);
        for turn in 0..=SQUARINGS {
            let norm = self.power.iter().map(|one| one * one).sum::<f64>().sqrt();
            if norm == 0.0 {
                return 0.0;
            }
            // Squares overflow otherwise.
            self.power.iter_mut().for_each(|one| *one /= norm);
            logarithm += root * norm.ln();
            root /= 2.0;
            if turn < SQUARINGS {
                multiply(&self.power, &mut self.square, n);
                std::mem::swap(&mut self.power, &mut self.square);
            }
        }
        logarithm.exp()
    }
}

/// The square of a matrix.
fn multiply(matrix: &[f64], square: &mut [f64], n: usize) {
    for row in 0..n {
        for column in 0..n {
            square[row * n + column] =
                (0..n).map(|k| matrix[row * n + k] * matrix[k * n + column]).sum();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check_radius(matrix: &[f64], n: usize, expected: f64) {
        let found = Calm::new(n).spectral_radius(matrix, n);
        assert!(found >= expected * (1.0 - 1e-12), "{found:e}");
        assert!(found <= expected * 1.5, "{found:e}");
    }

    #[test]
    fn the_spectral_radius_is_bounded_closely() {
        check_radius(&[3.0], 1, 3.0);
        check_radius(&[-1.0, 0.0, 0.0, -1e9], 2, 1e9);
        check_radius(&[0.0, 1.0, -1e12, 0.0], 2, 1e6);
        check_radius(&[0.0, -1e18, 1.0, -2e3], 2, 1e9);
        assert_eq!(Calm::new(2).spectral_radius(&[0.0, 0.0, 5.0, 0.0], 2), 0.0);
    }
}
