//! Plain numbers whose functions are those of the standard library.

use assur::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A plain number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standard(pub f64);

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Standard {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Standard {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! elementary {
    ($source:ty: $($name:ident),*) => {$(
        fn $name(self) -> Self {
            Self(<$source>::$name(self.0))
        }
    )*};
}

impl Scalar for Standard {
    type Mask = bool;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);

    fn from_f64(value: f64) -> Self {
        Self(value)
    }
    fn to_f64(self) -> f64 {
        self.0
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
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
    fn atan2(y: Self, x: Self) -> Self {
        Self(y.0.atan2(x.0))
    }
    fn hypot(self, other: Self) -> Self {
        Self(self.0.hypot(other.0))
    }
    fn powf(self, exponent: Self) -> Self {
        Self(self.0.powf(exponent.0))
    }
    fn erf(self) -> Self {
        Self(Scalar::erf(self.0))
    }
    fn normal_cdf(self) -> Self {
        Self(Scalar::normal_cdf(self.0))
    }
    elementary!(f64: tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, sqrt, floor, abs);
}
