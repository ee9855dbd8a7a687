//! Eight `f64` side by side in two registers, for x86-64 processors that have AVX2 and fused products.
//!
//! [`Lanes`](super::Lanes) leave it to the compiler to find what goes into one instruction, which it takes long for and does not always do;
//! here each operation says so itself.

use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use super::sine::Bits;
use super::{Fused, Pack, Scalar, Table, WIDTH, angle, sine};

/// Eight numbers. As [`Fused`], there are such numbers inside of [`crate::dispatch::dispatch_packs`] alone, which has asked
/// the processor; what is said to be safe here rests on that.
#[derive(Clone, Copy, Debug)]
pub struct F64x8(__m256d, __m256d);

/// What is true of each: all bits of it or none.
#[derive(Clone, Copy, Debug)]
pub struct Masks8(__m256d, __m256d);

/// The bits of each.
#[derive(Clone, Copy, Debug)]
pub struct Words8(__m256i, __m256i);

/// Implements operators that are one instruction for each half.
macro_rules! operators {
    ($($type:ident: $($operator:ident $method:ident $instruction:ident),*;)*) => {$($(
        impl $operator for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the processor has the instruction, see `F64x8`.
                unsafe { Self($instruction(self.0, other.0), $instruction(self.1, other.1)) }
            }
        }
    )*)*};
}

operators! {
    F64x8: Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd;
    Masks8: BitAnd bitand _mm256_and_pd, BitOr bitor _mm256_or_pd;
    Words8: BitAnd bitand _mm256_and_si256, BitOr bitor _mm256_or_si256, BitXor bitxor _mm256_xor_si256;
}

impl Neg for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Self(_mm256_xor_pd(self.0, sign), _mm256_xor_pd(self.1, sign))
        }
    }
}

impl Not for Masks8 {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            let all = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
            Self(_mm256_xor_pd(self.0, all), _mm256_xor_pd(self.1, all))
        }
    }
}

impl Masks8 {
    /// A bit for each.
    #[inline(always)]
    fn bits(self) -> i32 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { _mm256_movemask_pd(self.0) | _mm256_movemask_pd(self.1) << 4 }
    }
}

impl F64x8 {
    /// A search in each by itself; what is searched is a function of all.
    fn found(find: impl Fn(&dyn Fn(Self) -> f64) -> f64) -> Self {
        let mut all = [0.0; WIDTH];
        for (lane, value) in all.iter_mut().enumerate() {
            *value = find(&|found| found.lane(lane));
        }
        Self::load(&all)
    }

    fn lane(self, lane: usize) -> f64 {
        let mut all = [0.0; WIDTH];
        self.store(&mut all);
        all[lane]
    }
}

impl Pack for F64x8 {
    const WIDTH: usize = WIDTH;

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        let numbers: &[f64; WIDTH] = numbers.first_chunk().expect("as many as there are lanes");
        // SAFETY: there are eight numbers, and the processor has the instruction.
        unsafe {
            let from = numbers.as_ptr();
            Self(_mm256_loadu_pd(from), _mm256_loadu_pd(from.add(4)))
        }
    }

    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        let numbers: &mut [f64; WIDTH] =
            numbers.first_chunk_mut().expect("as many as there are lanes");
        // SAFETY: as above.
        unsafe {
            let to = numbers.as_mut_ptr();
            _mm256_storeu_pd(to, self.0);
            _mm256_storeu_pd(to.add(4), self.1);
        }
    }
}

/// Functions of one number, one by one.
macro_rules! each {
    ($($name:ident),*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            self.each(self, |lane, _| Fused(lane).$name().0)
        }
    )*};
}

/// A comparison, one instruction for each half.
macro_rules! comparison {
    ($($name:ident $which:ident),*) => {$(
        #[inline(always)]
        fn $name(left: Self, right: Self) -> Masks8 {
            // SAFETY: the processor has the instruction, see `F64x8`.
            unsafe {
                Masks8(
                    _mm256_cmp_pd::<$which>(left.0, right.0),
                    _mm256_cmp_pd::<$which>(left.1, right.1),
                )
            }
        }
    )*};
}

impl Scalar for F64x8 {
    type Mask = Masks8;
    // SAFETY: all bits zero are the number zero.
    const ZERO: Self = unsafe { std::mem::transmute([0.0f64; WIDTH]) };
    // SAFETY: eight numbers are two registers of four.
    const ONE: Self = unsafe { std::mem::transmute([1.0f64; WIDTH]) };

    #[inline(always)]
    fn outline<R>(work: impl FnMut() -> R) -> R {
        Fused::outline(work)
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        let half = unsafe { _mm256_set1_pd(value) };
        Self(half, half)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { _mm256_cvtsd_f64(self.0) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            Self(
                _mm256_fmadd_pd(self.0, factor.0, term.0),
                _mm256_fmadd_pd(self.1, factor.1, term.1),
            )
        }
    }
    comparison!(less _CMP_LT_OQ, less_equal _CMP_LE_OQ, equal _CMP_EQ_OQ);
    #[inline(always)]
    fn holds(mask: Masks8) -> bool {
        mask.bits() & 1 != 0
    }
    #[inline(always)]
    fn any(mask: Masks8) -> bool {
        mask.bits() != 0
    }
    #[inline(always)]
    fn select(mask: Masks8, then: Self, otherwise: Self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            Self(
                _mm256_blendv_pd(otherwise.0, then.0, mask.0),
                _mm256_blendv_pd(otherwise.1, then.1, mask.1),
            )
        }
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
    fn sqrt(self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { Self(_mm256_sqrt_pd(self.0), _mm256_sqrt_pd(self.1)) }
    }
    #[inline(always)]
    fn floor(self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { Self(_mm256_floor_pd(self.0), _mm256_floor_pd(self.1)) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Self(_mm256_andnot_pd(sign, self.0), _mm256_andnot_pd(sign, self.1))
        }
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.each(other, f64::hypot)
    }
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.each(exponent, f64::powf)
    }
    each!(tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, erf, normal_cdf);

    fn mean(what: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| {
            let near = |x| lane(near(Self::from_f64(x)));
            f64::mean(what, near, |x| lane(far(Self::from_f64(x))))
        })
    }
    fn root(what: &str, function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| f64::root(what, |x| lane(function(Self::from_f64(x)))))
    }
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| f64::highest(|x| lane(function(Self::from_f64(x)))))
    }
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| f64::highest_place(|x| lane(function(Self::from_f64(x)))))
    }
    fn table(self, table: &Table<'_>) -> [Self; 4] {
        let mut places = [0.0; WIDTH];
        self.store(&mut places);
        let mut all = [[0.0; WIDTH]; 4];
        for (lane, place) in places.into_iter().enumerate() {
            for (order, value) in all.iter_mut().zip(Fused(place).table(table)) {
                order[lane] = value.0;
            }
        }
        all.map(|order| Self::load(&order))
    }
}

impl Bits for F64x8 {
    type Word = Words8;

    #[inline(always)]
    fn word(bits: u64) -> Words8 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        let half = unsafe { _mm256_set1_epi64x(bits.cast_signed()) };
        Words8(half, half)
    }
    #[inline(always)]
    fn of_bits(bits: Words8) -> Self {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { Self(_mm256_castsi256_pd(bits.0), _mm256_castsi256_pd(bits.1)) }
    }
    #[inline(always)]
    fn bits(self) -> Words8 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { Words8(_mm256_castpd_si256(self.0), _mm256_castpd_si256(self.1)) }
    }
    #[inline(always)]
    fn raised<const PLACES: i32>(word: Words8) -> Words8 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe { Words8(_mm256_slli_epi64::<PLACES>(word.0), _mm256_slli_epi64::<PLACES>(word.1)) }
    }
    #[inline(always)]
    fn spread(word: Words8) -> Words8 {
        // SAFETY: the processor has the instruction, see `F64x8`.
        unsafe {
            let zero = _mm256_setzero_si256();
            Words8(_mm256_sub_epi64(zero, word.0), _mm256_sub_epi64(zero, word.1))
        }
    }
}

#[cfg(test)]
mod tests;
