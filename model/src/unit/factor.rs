//! Size of a unit in SI units: an exact ratio times a power of π.

/// `numerator/denominator · π^pi · rest`; `rest` is 1 unless the ratio is irrational or too long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    numerator: u64,
    denominator: u64,
    pi: i8,
    rest: f64,
}

/// Whole numbers up to here are exact as floating-point numbers.
const EXACT: u64 = 1 << 53;

impl Factor {
    /// 1
    pub const ONE: Factor = Factor::ratio(1, 1);

    /// An exact ratio.
    pub const fn ratio(numerator: u64, denominator: u64) -> Self {
        Self { numerator, denominator, pi: 0, rest: 1.0 }
    }

    /// An exact ratio times π.
    pub const fn ratio_pi(numerator: u64, denominator: u64) -> Self {
        Self { numerator, denominator, pi: 1, rest: 1.0 }
    }

    /// The product.
    pub fn times(self, other: Self) -> Self {
        let (a, d) = reduced(self.numerator, other.denominator);
        let (c, b) = reduced(other.numerator, self.denominator);
        let exact =
            a.checked_mul(c).zip(b.checked_mul(d)).filter(|(p, q)| *p <= EXACT && *q <= EXACT);
        let pi = self.pi.saturating_add(other.pi);
        match exact {
            Some((numerator, denominator)) => {
                Self { numerator, denominator, pi, rest: self.rest * other.rest }
            }
            None => {
                Self { numerator: 1, denominator: 1, pi: 0, rest: self.scale() * other.scale() }
            }
        }
    }

    /// A power with the exponent `numerator/denominator`.
    pub fn pow(self, numerator: i8, denominator: i8) -> Self {
        if denominator != 1 {
            let exponent = f64::from(numerator) / f64::from(denominator);
            return Self { rest: self.scale().powf(exponent), ..Self::ONE };
        }
        let base = if numerator < 0 { self.inverse() } else { self };
        (0..numerator.unsigned_abs()).fold(Self::ONE, |power, _| power.times(base))
    }

    fn inverse(self) -> Self {
        Self {
            numerator: self.denominator,
            denominator: self.numerator,
            pi: -self.pi,
            rest: 1.0 / self.rest,
        }
    }

    /// A value in SI units, given in units of this size. Rounded once wherever the factor is a whole number or the
    /// inverse of one.
    pub fn to_si(self, value: f64) -> f64 {
        let (numerator, denominator) = (self.numerator as f64, self.denominator as f64);
        let other = self.rest * std::f64::consts::PI.powi(i32::from(self.pi));
        match (other == 1.0, self.numerator, self.denominator) {
            (true, _, 1) => value * numerator,
            (true, 1, _) => value / denominator,
            (true, ..) => value * numerator / denominator,
            // π is rounded as it is: one multiplication by the best value of the factor.
            (false, ..) => value * (other * numerator / denominator),
        }
    }

    /// The size as a floating-point number.
    pub fn scale(self) -> f64 {
        self.to_si(1.0)
    }
}

fn reduced(mut a: u64, mut b: u64) -> (u64, u64) {
    let (above, below) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let divisor = a.max(1);
    (above / divisor, below / divisor)
}

#[cfg(test)]
mod tests {
    use super::Factor;

    #[test]
    fn a_millimetre_is_divided_not_multiplied() {
        let millimetre = Factor::ratio(1, 1000);
        assert_eq!(millimetre.to_si(75.0), 0.075);
        // Multiplying by the rounded 1e-3 is wrong in the last place for some of these.
        let wrong = (1..1000).filter(|k| f64::from(*k) * 1e-3 != f64::from(*k) / 1000.0).count();
        assert!(wrong > 0);
        for k in 1..1000 {
            assert_eq!(millimetre.to_si(f64::from(k)), f64::from(k) / 1000.0);
        }
    }

    #[test]
    fn prefixes_cancel_exactly() {
        let per = Factor::ratio(1_000_000, 1).times(Factor::ratio(1, 1000).pow(2, 1));
        assert_eq!(per, Factor::ONE);
    }

    #[test]
    fn a_ratio_that_is_too_long_is_rounded() {
        let long = Factor::ratio(3, 7).pow(60, 1);
        assert!((long.scale() / (3.0_f64 / 7.0).powi(60) - 1.0).abs() < 1e-13);
    }
}
