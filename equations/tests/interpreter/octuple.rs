//! Numbers of 71 digits, to see what roundings do.

use std::ops::{Add, Div, Mul, Neg, Sub};

use assur::scalar::Scalar;
use f256::f256;

/// A number of 71 digits.
#[derive(Clone, Copy, Debug)]
pub struct Octuple(pub f256);

/// Terms of a power series, enough for arguments up to [`FAR`].
const TERMS: u32 = 400;
/// Beyond it the error function is one for doubles.
const FAR: f64 = 6.5;

macro_rules! operators {
    ($($operator:ident $method:ident;)*) => {$(
        impl $operator for Octuple {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }
    )*};
}

operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl Neg for Octuple {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! functions {
    ($($name:ident),*) => {$(
        fn $name(self) -> Self {
            Self(self.0.$name())
        }
    )*};
}

impl Scalar for Octuple {
    type Mask = bool;
    const ZERO: Self = Self(f256::ZERO);
    const ONE: Self = Self(f256::ONE);

    fn from_f64(value: f64) -> Self {
        Self(f256::from(value))
    }

    fn to_f64(self) -> f64 {
        // The crate has no way back but its digits.
        self.0.to_string().parse().unwrap_or(f64::NAN)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0))
    }

    fn less(left: Self, right: Self) -> bool {
        left.0 < right.0
    }

    fn less_equal(left: Self, right: Self) -> bool {
        left.0 <= right.0
    }

    fn equal(left: Self, right: Self) -> bool {
        left.0 == right.0
    }

    fn holds(mask: bool) -> bool {
        mask
    }

    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        (angles.map(|angle| Self(angle.0.sin())), angles.map(|angle| Self(angle.0.cos())))
    }

    functions!(tan, asin, acos, atan, exp, exp_m1, ln, ln_1p, log10, sqrt, floor, abs);

    fn atan2(y: Self, x: Self) -> Self {
        Self(y.0.atan2(&x.0))
    }

    fn sinh(self) -> Self {
        (self.exp() - (-self).exp()) / Self::from_f64(2.0)
    }

    fn cosh(self) -> Self {
        (self.exp() + (-self).exp()) / Self::from_f64(2.0)
    }

    fn tanh(self) -> Self {
        self.sinh() / self.cosh()
    }

    fn hypot(self, other: Self) -> Self {
        Self(self.0.hypot(other.0))
    }

    fn powf(self, exponent: Self) -> Self {
        Self(self.0.powf(&exponent.0))
    }

    fn erf(self) -> Self {
        if self.0.abs() > f256::from(FAR) {
            return Self(f256::ONE.copysign(self.0));
        }
        // 2/√π Σ (-1)ᵏ x²ᵏ⁺¹ / (k! (2k+1))
        let (mut sum, mut power) = (self, self);
        for k in 1..TERMS {
            let k = f64::from(k);
            power = -(power * self * self) / Self::from_f64(k);
            sum = sum + power / Self::from_f64(2.0 * k + 1.0);
        }
        let pi = Self(f256::ONE).atan() * Self::from_f64(4.0);
        sum * Self::from_f64(2.0) / pi.sqrt()
    }

    fn normal_cdf(self) -> Self {
        let two = Self::from_f64(2.0);
        (Self::ONE + (self / two.sqrt()).erf()) / two
    }
}

#[test]
fn digits_are_right() {
    let number = Octuple::from_f64;
    // erf(1) = 0.84270079294971486934122063508…
    let off = number(1.0).erf()
        - Octuple(
            "0.84270079294971486934122063508260925929606699796630".parse().expect("a number"),
        );
    assert!(off.to_f64().abs() < 1e-48, "{off:?}");
    let (sine, cosine) = number(0.7).sin_cos();
    assert!((sine * sine + cosine * cosine - Octuple::ONE).to_f64().abs() < 1e-68);
    assert_eq!(number(0.1).to_f64(), 0.1);
    assert!((number(2.0).ln().exp() - number(2.0)).to_f64().abs() < 1e-68);
}
