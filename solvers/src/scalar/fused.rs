//! `f64` whose products and sums are fused.

use super::processor::is_fused;
use super::{Pack, Real, Scalar, angle, sine};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An `f64` whose [`Scalar::mul_add`] is rounded once.
///
/// That is one instruction in code that is compiled for it, and a slow library call elsewhere. So there are such numbers
/// inside of [`crate::dispatch::dispatch`] alone, which has asked the processor: no other crate can name the type.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused(pub(crate) f64);

/// Does work as a function of its own, compiled for those instructions.
#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
#[inline(never)]
unsafe fn apart<R>(mut work: impl FnMut() -> R) -> R {
    work()
}

/// Implements operators between two fused numbers.
macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// What a type does by calling the function of the same name on its value.
macro_rules! elementary {
    ($($name:ident),*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            Self(f64::$name(self.0))
        }
    )*};
}

impl Scalar for Fused {
    type Mask = bool;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);

    #[inline(always)]
    fn outline<R>(work: impl FnMut() -> R) -> R {
        debug_assert!(is_fused());
        // SAFETY: who computes with these numbers has asked the processor, see `Fused`.
        unsafe { apart(work) }
    }

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(value)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(f64::mul_add(self.0, factor.0, term.0))
    }
    #[inline(always)]
    fn less(left: Self, right: Self) -> bool {
        left.0 < right.0
    }
    #[inline(always)]
    fn less_equal(left: Self, right: Self) -> bool {
        left.0 <= right.0
    }
    #[inline(always)]
    fn equal(left: Self, right: Self) -> bool {
        left.0 == right.0
    }
    #[inline(always)]
    fn holds(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }
    #[inline(always)]
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        sine::sin_cos_all(angles)
    }
    #[inline(always)]
    fn atan2(y: Self, x: Self) -> Self {
        let [angle] = angle::atan2_all([y], [x]);
        angle
    }
    #[inline(always)]
    fn atan2_all<const K: usize>(y: [Self; K], x: [Self; K]) -> [Self; K] {
        angle::atan2_all(y, x)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        Self(f64::hypot(self.0, other.0))
    }
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        Self(f64::powf(self.0, exponent.0))
    }
    #[inline(always)]
    fn erf(self) -> Self {
        Self(assur_functions::erf(self.0))
    }
    #[inline(always)]
    fn normal_cdf(self) -> Self {
        Self(assur_functions::normal_cdf(self.0))
    }
    elementary!(
        tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, sqrt, floor, abs
    );
}

impl Real for Fused {
    #[inline(always)]
    fn of(numbers: &[f64]) -> &[Self] {
        // SAFETY: a fused number is an `f64` and nothing else (`repr(transparent)`).
        unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast(), numbers.len()) }
    }

    #[inline(always)]
    fn of_mut(numbers: &mut [f64]) -> &mut [Self] {
        // SAFETY: as above; the borrow of the numbers goes on.
        unsafe { std::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), numbers.len()) }
    }
}

impl Pack for Fused {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        Self(numbers[0])
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self.0;
    }
}

impl sine::Bits for Fused {
    type Word = u64;

    #[inline(always)]
    fn word(bits: u64) -> u64 {
        bits
    }
    #[inline(always)]
    fn of_bits(bits: u64) -> Self {
        Self(f64::from_bits(bits))
    }
    #[inline(always)]
    fn bits(self) -> u64 {
        self.0.to_bits()
    }
    #[inline(always)]
    fn raised<const PLACES: i32>(word: u64) -> u64 {
        word << PLACES
    }
    #[inline(always)]
    fn spread(word: u64) -> u64 {
        word.wrapping_neg()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_rounded_once() {
        let x = Fused(1.0 + 2f64.powi(-30));
        let term = Fused(-(1.0 + 2f64.powi(-29)));
        assert_eq!(x.mul_add(x, term), Fused(2f64.powi(-60)));
        assert_eq!(x * x + term, Fused(0.0));
    }

    #[test]
    fn operators_are_those_of_f64() {
        let (a, b) = (0.1, 0.7);
        assert_eq!(Fused(a) + Fused(b), Fused(a + b));
        assert_eq!(Fused(a) - Fused(b), Fused(a - b));
        assert_eq!(Fused(a) * Fused(b), Fused(a * b));
        assert_eq!(Fused(a) / Fused(b), Fused(a / b));
        assert_eq!(-Fused(a), Fused(-a));
    }
}
