//! Dual numbers: a value and its derivative along one direction.

use super::Scalar;
use std::f64::consts::{FRAC_2_SQRT_PI, LN_10, PI};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with one derivative, which every operation carries along: what the tests hold derived Jacobians against.
///
/// Comparisons look at the values, so the derivative of a branch is that of the active one.
///
/// ```
/// use assur_solvers::scalar::{Dual, Scalar};
/// let x = Dual::variable(3.0);
/// assert_eq!((x * x + x.sqrt()).slope, 6.0 + 0.5 / 3f64.sqrt());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A value that does not change.
    pub const fn constant(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }

    /// The value along which the derivative is taken.
    pub const fn variable(value: f64) -> Self {
        Self { value, slope: 1.0 }
    }

    /// A function of this number, given its value and its derivative there.
    fn chain(self, value: f64, derivative: f64) -> Self {
        // Of what does not change any slope will do, an infinite one as well.
        let slope = if self.slope == 0.0 { 0.0 } else { derivative * self.slope };
        Self { value, slope }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

/// Functions of one argument: name, argument, value, and derivative from both.
macro_rules! functions {
    ($($name:ident: |$x:ident, $value:ident| $derivative:expr;)*) => {$(
        fn $name(self) -> Self {
            let $x = self.value;
            let $value = <f64 as Scalar>::$name($x);
            self.chain($value, $derivative)
        }
    )*};
}

impl Scalar for Dual {
    type Mask = bool;
    const ZERO: Self = Self::constant(0.0);
    const ONE: Self = Self::constant(1.0);

    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn mean(_: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        Self::mean_along(&near, &far)
    }
    fn root(_: &str, function: impl Fn(Self) -> Self) -> Self {
        Self::root_along(&function)
    }
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_along(&function)
    }
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_place_along(&function)
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    fn less(left: Self, right: Self) -> bool {
        left.value < right.value
    }
    fn less_equal(left: Self, right: Self) -> bool {
        left.value <= right.value
    }
    fn equal(left: Self, right: Self) -> bool {
        left.value == right.value
    }
    fn holds(mask: bool) -> bool {
        mask
    }
    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let mut both = (angles, angles);
        for (index, angle) in angles.into_iter().enumerate() {
            let (sine, cosine) = Scalar::sin_cos(angle.value);
            both.0[index] = angle.chain(sine, cosine);
            both.1[index] = angle.chain(cosine, -sine);
        }
        both
    }
    fn atan2(y: Self, x: Self) -> Self {
        let square = x.value * x.value + y.value * y.value;
        Self {
            value: f64::atan2(y.value, x.value),
            slope: (x.value * y.slope - y.value * x.slope) / square,
        }
    }
    fn hypot(self, other: Self) -> Self {
        let value = self.value.hypot(other.value);
        Self { value, slope: (self.value * self.slope + other.value * other.slope) / value }
    }
    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value, exponent.value);
        let value = x.powf(y);
        let power = self.chain(value, y * x.powf(y - 1.0));
        // A fixed exponent needs no logarithm, which a negative base does not have.
        match exponent.slope {
            0.0 => power,
            slope => Self { value, slope: power.slope + value * x.ln() * slope },
        }
    }

    functions! {
        tan:   |_x, value| 1.0 + value * value;
        asin:  |x, _value| 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
        acos:  |x, _value| -1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
        atan:  |x, _value| 1.0 / (1.0 + x * x);
        sinh:  |x, _value| x.cosh();
        cosh:  |x, _value| x.sinh();
        tanh:  |_x, value| (1.0 - value) * (1.0 + value);
        exp:   |_x, value| value;
        exp_m1: |_x, value| value + 1.0;
        ln:    |x, _value| 1.0 / x;
        ln_1p: |x, _value| 1.0 / (1.0 + x);
        log10: |x, _value| 1.0 / (x * LN_10);
        sqrt:  |_x, value| 0.5 / value;
        erf:   |x, _value| FRAC_2_SQRT_PI * (-x * x).exp();
        normal_cdf: |x, _value| (-0.5 * x * x).exp() / (2.0 * PI).sqrt();
        floor: |_x, _value| 0.0;
        abs:   |x, _value| Scalar::sign(x);
    }

    fn sign(self) -> Self {
        Self::constant(Scalar::sign(self.value))
    }
}

#[cfg(test)]
mod tests;
