//! Moments and deviates of the distributions, for a half-width of one.

use super::normal;
use crate::shape::Distribution;

/// Half-widths are this many standard deviations of the normal distribution.
const SPREAD: f64 = 3.0;
/// Share of the normal distribution beyond one end of the half-width, `Φ(-3)`.
const TAIL: f64 = 1.349_898_031_630_094_6e-3;
/// Density of the normal distribution there, `φ(3)`.
const DENSITY: f64 = 4.431_848_411_938_008e-3;

impl Distribution {
    /// Variance for a half-width of one.
    pub fn variance(self) -> f64 {
        match self {
            Self::Uniform => 1.0 / 3.0,
            Self::Normal => 1.0 / (SPREAD * SPREAD),
            Self::Truncated => {
                let missing = 2.0 * SPREAD * DENSITY / (1.0 - 2.0 * TAIL);
                (1.0 - missing) / (SPREAD * SPREAD)
            }
            Self::Lognormal { .. } => 1.0 / (SPREAD * SPREAD),
        }
    }

    /// Standard deviation for a half-width of one.
    pub fn deviation(self) -> f64 {
        self.variance().sqrt()
    }

    /// Fourth central moment for a half-width of one.
    pub fn fourth_moment(self) -> f64 {
        let fourth = SPREAD.powi(4);
        match self {
            Self::Uniform => 1.0 / 5.0,
            Self::Normal => 3.0 / fourth,
            Self::Truncated => {
                let missing = 2.0 * (SPREAD.powi(3) + 3.0 * SPREAD) * DENSITY / (1.0 - 2.0 * TAIL);
                (3.0 - missing) / fourth
            }
            Self::Lognormal { ratio } => {
                let growth = 1.0 + (ratio / SPREAD).powi(2);
                (growth.powi(4) + 2.0 * growth.powi(3) + 3.0 * growth * growth - 3.0) / fourth
            }
        }
    }

    /// Third central moment for a half-width of one; zero of what errs to both sides alike.
    pub fn third_moment(self) -> f64 {
        match self {
            Self::Uniform | Self::Normal | Self::Truncated => 0.0,
            Self::Lognormal { ratio } => {
                let part = ratio / SPREAD;
                part * (3.0 + part * part) / SPREAD.powi(3)
            }
        }
    }

    /// The error below which a share lies, for a half-width of one: turns a uniform random number into an error.
    #[inline(always)]
    pub fn quantile(self, share: f64) -> f64 {
        match self {
            Self::Uniform => 2.0 * share - 1.0,
            Self::Normal => normal::quantile(share) * (1.0 / SPREAD),
            Self::Truncated => normal::quantile(TAIL + share * (1.0 - 2.0 * TAIL)) * (1.0 / SPREAD),
            Self::Lognormal { ratio } => {
                let variance = (ratio / SPREAD).powi(2).ln_1p();
                (variance.sqrt() * normal::quantile(share) - 0.5 * variance).exp_m1() / ratio
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;
    use std::f64::consts::TAU;

    /// A mean over the distribution: by the trapezoidal rule over the normal deviate of which the share is that below, which is
    /// exact to rounding but for what lies beyond seven standard deviations.
    fn mean(of: Distribution, power: i32) -> f64 {
        let (step, ends) = (0.01, 700);
        let part = |k: i32| {
            let deviate = f64::from(k) * step;
            let density = (-0.5 * deviate * deviate).exp() / TAU.sqrt();
            of.quantile(Scalar::normal_cdf(deviate)).powi(power) * density * step
        };
        (-ends..=ends).map(part).sum()
    }

    #[test]
    fn moments_are_those_of_the_deviates() {
        use Distribution::{Lognormal, Normal, Truncated, Uniform};
        let slight = Lognormal { ratio: 0.3 };
        let much = Lognormal { ratio: 1.5 };
        let all =
            [(Uniform, 1e-10), (Normal, 1e-10), (Truncated, 1e-10), (slight, 1e-9), (much, 1e-6)];
        for (of, error) in all {
            let moments = [0.0, of.variance(), of.third_moment(), of.fourth_moment()];
            for (power, expected) in (1..).zip(moments) {
                let found = mean(of, power);
                assert!((found - expected).abs() < error, "{of:?}, {power}: {found}, {expected}");
            }
        }
    }

    #[test]
    fn what_is_above_zero_stays_there() {
        let of = Distribution::Lognormal { ratio: 3.0 };
        for share in [1e-15, 1e-3, 0.5, 0.999] {
            assert!(1.0 + 3.0 * of.quantile(share) > 0.0, "{share}");
        }
    }

    #[test]
    fn truncated_errors_keep_within_the_half_width() {
        assert!((Distribution::Truncated.quantile(0.0) + 1.0).abs() < 1e-14);
        assert!((Distribution::Truncated.quantile(1.0) - 1.0).abs() < 1e-14);
        assert!((Distribution::Truncated.deviation() * 3.0 - 0.986_578_1).abs() < 1e-6);
    }
}
