//! Plain `f64` and `f32`: every operation is rounded by itself, on every machine.

use super::{Pack, Real, Scalar, angle, sine};

/// What a type does by calling the function of the same name on its value.
macro_rules! elementary {
    ($($name:ident),*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            self.$name()
        }
    )*};
}

impl Real for f64 {
    #[inline(always)]
    fn of(numbers: &[f64]) -> &[Self] {
        numbers
    }

    #[inline(always)]
    fn of_mut(numbers: &mut [f64]) -> &mut [Self] {
        numbers
    }
}

/// Implements [`Scalar`] for a primitive number; the last arguments are the bodies of `sin_cos_all` and
/// `atan2_all`.
macro_rules! plain {
    ($float:ident, |$angles:ident| $sine:expr, |$y:ident, $x:ident| $angle:expr) => {
        impl Scalar for $float {
            type Mask = bool;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const SINGLE: bool = true;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                self * factor + term
            }
            #[inline(always)]
            fn less(left: Self, right: Self) -> bool {
                left < right
            }
            #[inline(always)]
            fn less_equal(left: Self, right: Self) -> bool {
                left <= right
            }
            #[inline(always)]
            fn equal(left: Self, right: Self) -> bool {
                left == right
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
            fn sin_cos_all<const K: usize>($angles: [Self; K]) -> ([Self; K], [Self; K]) {
                $sine
            }
            #[inline(always)]
            fn atan2(y: Self, x: Self) -> Self {
                let [angle] = Self::atan2_all([y], [x]);
                angle
            }
            #[inline(always)]
            fn atan2_all<const K: usize>($y: [Self; K], $x: [Self; K]) -> [Self; K] {
                $angle
            }
            #[inline(always)]
            fn hypot(self, other: Self) -> Self {
                $float::hypot(self, other)
            }
            #[inline(always)]
            fn powf(self, exponent: Self) -> Self {
                $float::powf(self, exponent)
            }
            #[inline(always)]
            fn erf(self) -> Self {
                assur_functions::erf(f64::from(self)) as $float
            }
            #[inline(always)]
            fn normal_cdf(self) -> Self {
                assur_functions::normal_cdf(f64::from(self)) as $float
            }
            elementary!(
                tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, sqrt,
                floor, abs
            );
        }
    };
}

plain!(f64, |angles| sine::sin_cos_all(angles), |y, x| angle::atan2_all(y, x));
plain!(
    f32,
    |angles| {
        let (sines, cosines) = sine::sin_cos_all(angles.map(f64::from));
        (sines.map(|s| s as f32), cosines.map(|c| c as f32))
    },
    |y, x| {
        let angles = angle::atan2_all(y.map(f64::from), x.map(f64::from));
        angles.map(|angle| angle as f32)
    }
);

/// Does work as a function of its own.
#[inline(never)]
pub(super) fn apart<R>(mut work: impl FnMut() -> R) -> R {
    work()
}

impl Pack for f64 {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        numbers[0]
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self;
    }
}

impl sine::Bits for f64 {
    type Word = u64;

    #[inline(always)]
    fn word(bits: u64) -> u64 {
        bits
    }
    #[inline(always)]
    fn of_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }
    #[inline(always)]
    fn bits(self) -> u64 {
        self.to_bits()
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
    fn products_are_rounded_before_the_sum() {
        // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰, whose last term is lost in a rounded product.
        let x = 1.0 + 2f64.powi(-30);
        let term = -(1.0 + 2f64.powi(-29));
        assert_eq!(<f64 as Scalar>::mul_add(x, x, term), 0.0);
        let x = 1.0 + 2f32.powi(-15);
        let term = -(1.0 + 2f32.powi(-14));
        assert_eq!(<f32 as Scalar>::mul_add(x, x, term), 0.0);
    }

    #[test]
    fn single_precision_rounds_the_double_result() {
        for k in 0..1000 {
            let x = k as f32 * 0.37 - 150.0;
            let (sine, cosine) = Scalar::sin_cos(x);
            assert_eq!(sine, f64::from(x).sin() as f32);
            assert_eq!(cosine, f64::from(x).cos() as f32);
        }
        assert_eq!(Scalar::erf(0.5f32), 0.520_499_9);
    }
}
