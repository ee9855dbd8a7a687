//! Numbers that know how far they may be off.

use super::{Dual, Scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Largest relative error of one rounded operation.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// Largest relative error of a function: two units in the last place, more than any of ours or of a good library has.
const FUNCTION: f64 = 4.0 * ROUNDING;

/// A value with a bound of its error, which every operation carries along: how exactly two ways to the same value have
/// to agree, cancellation included.
///
/// The bound is that of a running error analysis (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
/// section 3.3), to first order where a function is applied. A value from outside is off by [`Bounded::GIVEN`].
/// Comparisons look at the values.
///
/// ```
/// use assur_solvers::scalar::{Bounded, Scalar};
/// let [large, small] = [1.0, 1e-9].map(Bounded::from_f64);
/// let lost = (large + small) - large;
/// assert!((lost.value - 1e-9).abs() < lost.bound && lost.bound < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounded {
    /// The value.
    pub value: f64,
    /// Largest error of the value.
    pub bound: f64,
}

impl Bounded {
    /// Largest relative error of a value from outside: that of stating it in other units. The value is multiplied by a
    /// power of ten and a root of one, two products; the exponent of the root is rounded, which moves it by at most
    /// `ln 10 < 2.4` roundings, and the root is right to one unit in the last place, two roundings.
    pub const GIVEN: f64 = 7.0 * ROUNDING;

    /// A value without an error.
    pub const fn exact(value: f64) -> Self {
        Self { value, bound: 0.0 }
    }

    /// A value that is rounded once, given what the errors of its operands make of it.
    fn rounded(value: f64, carried: f64) -> Self {
        Self { value, bound: carried + ROUNDING * value.abs() }
    }

    /// A function of this number that rises in steps.
    fn step(self, function: impl Fn(f64) -> f64) -> Self {
        Self {
            value: function(self.value),
            bound: function(self.value + self.bound) - function(self.value - self.bound),
        }
    }

    /// A function of this number.
    fn function(self, function: impl Fn(Dual) -> Dual) -> Self {
        let Dual { value, slope } = function(Dual::variable(self.value));
        Self { value, bound: carried(slope, self) + FUNCTION * value.abs() }
    }

    /// A function of this number and another.
    fn function_with(self, other: Self, function: impl Fn(Dual, Dual) -> Dual) -> Self {
        let (x, y) = (Dual::constant(self.value), Dual::constant(other.value));
        let along = self.function(|x| function(x, y));
        let across = function(x, Dual::variable(other.value)).slope;
        Self { value: along.value, bound: along.bound + carried(across, other) }
    }
}

/// What the error of an argument makes of a function with this slope. Without an error any slope will do.
fn carried(slope: f64, argument: Bounded) -> f64 {
    match argument.bound {
        0.0 => 0.0,
        bound => slope.abs() * bound,
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.bound + other.bound)
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.bound + other.bound)
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value.abs(), other.value.abs());
        let carried = a * other.bound + b * self.bound + self.bound * other.bound;
        Self::rounded(self.value * other.value, carried)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = other.value.abs() - other.bound;
        let carried = match least > 0.0 {
            true => (self.bound + value.abs() * other.bound) / least,
            false => f64::INFINITY,
        };
        Self::rounded(value, carried)
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// Functions of one argument, by way of their derivatives.
macro_rules! functions {
    ($($name:ident),*) => {$(
        fn $name(self) -> Self {
            self.function(Scalar::$name)
        }
    )*};
}

impl Scalar for Bounded {
    type Mask = bool;
    const ZERO: Self = Self::exact(0.0);
    const ONE: Self = Self::exact(1.0);

    fn from_f64(value: f64) -> Self {
        Self { value, bound: Self::GIVEN * value.abs() }
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn mean(_: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        Self::mean_within(&near, &far)
    }
    fn root(_: &str, function: impl Fn(Self) -> Self) -> Self {
        Self::root_within(&function)
    }
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_within(&function)
    }
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_place_within(&function)
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
    fn and(left: bool, right: bool) -> bool {
        left & right
    }
    fn or(left: bool, right: bool) -> bool {
        left | right
    }
    fn not(mask: bool) -> bool {
        !mask
    }
    fn holds(mask: bool) -> bool {
        mask
    }
    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        (
            angles.map(|angle| angle.function(|x| x.sin_cos().0)),
            angles.map(|angle| angle.function(|x| x.sin_cos().1)),
        )
    }
    fn atan2(y: Self, x: Self) -> Self {
        y.function_with(x, Dual::atan2)
    }
    fn hypot(self, other: Self) -> Self {
        self.function_with(other, Dual::hypot)
    }
    fn powf(self, exponent: Self) -> Self {
        // The logarithm in the slope along the exponent exists for positive bases; others have fixed exponents.
        match self.value > 0.0 {
            true => self.function_with(exponent, Dual::powf),
            false => self.function(|x| x.powf(Dual::constant(exponent.value))),
        }
    }
    functions!(
        tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, sqrt, erf,
        normal_cdf
    );
    fn floor(self) -> Self {
        self.step(f64::floor)
    }
    fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
    fn sign(self) -> Self {
        self.step(Scalar::sign)
    }
}

#[cfg(test)]
mod tests;
