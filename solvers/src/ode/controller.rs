//! Control of the step size.
//!
//! Hairer, Nørsett, Wanner, sections II.4 and IV.2: the next step is `h · safety · err^(-α) · err_previous^β`, a
//! proportional-integral control after K. Gustafsson (1991).

/// Part of the optimal step that is taken.
const SAFETY: f64 = 0.9;
/// Smallest error that the control remembers.
const SMALLEST_ERROR: f64 = 1e-4;

/// Control of the step size from the scaled errors of the steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Controller {
    /// Exponent of the error.
    alpha: f64,
    /// Exponent of the previous error.
    beta: f64,
    /// Smallest and largest factor from one step to the next.
    factors: (f64, f64),
    /// Whether the factor is an eighth root of the error alone, which is three square roots.
    is_eighth: bool,
    /// Logarithm of the error of the last accepted step.
    previous: f64,
    /// Whether the last attempt was rejected.
    rejected: bool,
}

impl Controller {
    /// A control for a method of an order.
    pub fn new(order: usize, beta: f64, factors: (f64, f64)) -> Self {
        let alpha = 1.0 / order as f64 - 0.75 * beta;
        Self {
            alpha,
            beta,
            factors,
            is_eighth: order == 8 && beta == 0.0,
            previous: SMALLEST_ERROR.ln(),
            rejected: false,
        }
    }

    /// Factor to the next step after a step with an error of at most 1. A step does not grow right after a rejection.
    #[inline]
    pub fn accept(&mut self, error: f64) -> f64 {
        let (smallest, largest) = self.factors;
        let largest = if self.rejected { 1.0 } else { largest };
        self.rejected = false;
        if self.is_eighth {
            let wanted = SAFETY / error.sqrt().sqrt().sqrt();
            return wanted.clamp(smallest, largest);
        }
        let logarithm = error.ln();
        let wanted = SAFETY * (self.beta * self.previous - self.alpha * logarithm).exp();
        self.previous = logarithm.max(SMALLEST_ERROR.ln());
        wanted.clamp(smallest, largest)
    }

    /// Factor to the next attempt after a step with an error above 1, or one that is not a number.
    #[inline]
    pub fn reject(&mut self, error: f64) -> f64 {
        self.rejected = true;
        let wanted = SAFETY / error.powf(self.alpha);
        // An error that is not a number gives the smallest factor.
        wanted.max(self.factors.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Controller;

    #[test]
    fn steps_shrink_with_the_error_and_grow_within_bounds() {
        let mut controller = Controller::new(5, 0.04, (0.2, 10.0));
        assert_eq!(controller.accept(0.0), 10.0);
        assert!(controller.accept(1.0) < 1.0);
        assert_eq!(controller.reject(1e20), 0.2);
        assert_eq!(controller.reject(f64::NAN), 0.2);
        assert_eq!(controller.reject(f64::INFINITY), 0.2);
    }

    #[test]
    fn the_eighth_root_is_that_of_the_power() {
        for error in [1e-9f64, 0.003, 0.4, 1.0] {
            let step = Controller::new(8, 0.0, (0.0, 1e9)).accept(error);
            let power = 0.9 * error.powf(-0.125);
            assert!((step - power).abs() < 4e-16 * power, "{step} {power}");
        }
    }

    #[test]
    fn a_step_does_not_grow_right_after_a_rejection() {
        let mut controller = Controller::new(8, 0.0, (0.333, 6.0));
        controller.reject(2.0);
        assert_eq!(controller.accept(1e-12), 1.0);
        assert_eq!(controller.accept(1e-12), 6.0);
    }
}
