//! Sine and cosine of several angles at once.
//!
//! The kernel has no branches and no calls, so that the compiler packs the lanes. An angle is brought into
//! `[-π/4, π/4]` with π/2 in three parts, then the polynomials of fdlibm (Sun Microsystems, 1993) are evaluated and
//! exchanged by quadrant. Angles beyond [`LIMIT`] take the standard library's path, lane by lane.

use std::ops::{BitAnd, BitOr, BitXor};

use super::{Pack, Scalar};

/// Scalars that are `f64` with the bits of them.
pub(super) trait Bits: Pack {
    /// The bits of a number.
    type Word: Copy
        + BitAnd<Output = Self::Word>
        + BitOr<Output = Self::Word>
        + BitXor<Output = Self::Word>;
    /// The same bits in all lanes.
    fn word(bits: u64) -> Self::Word;
    /// The number with these bits.
    fn of_bits(bits: Self::Word) -> Self;
    /// The bits of the number.
    fn bits(self) -> Self::Word;
    /// All bits moved up by so many places.
    fn raised<const PLACES: i32>(word: Self::Word) -> Self::Word;
    /// All bits set of a word that is one, none of zero.
    fn spread(word: Self::Word) -> Self::Word;
}

/// A function of the standard library, lane by lane.
#[cold]
#[inline(never)]
pub(super) fn each<S: Pack>(number: S, value: fn(f64) -> f64) -> S {
    number.each(number, |lane, _| value(lane))
}

/// Largest absolute angle of the branch-free kernel. A quarter turn number below it has at most 16 bits.
const LIMIT: f64 = 1.0e5;

/// 1.5 · 2⁵²: adding it rounds to a whole number, whose last bits are then the last bits of the sum.
const MAGIC: f64 = 6_755_399_441_055_744.0;

/// First 37 bits of π/2: their product with a quarter turn number is exact.
const QUARTER_1: f64 = 1.5707963267923333;
/// The next 37 bits.
const QUARTER_2: f64 = 2.5633441515839558e-12;
/// The rest, rounded.
const QUARTER_3: f64 = 1.0562999066987428e-23;

/// Coefficients of `(sin x - x) / x³` in powers of `x²`.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-6,
    -2.5050760253406863e-8,
    1.58969099521155e-10,
];
/// Coefficients of `(cos x - 1 + x²/2) / x⁴` in powers of `x²`.
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-5,
    -2.7557314351390663e-7,
    2.087572321298175e-9,
    -1.1359647557788195e-11,
];

/// Sines and cosines of all the angles.
#[inline(always)]
pub(super) fn sin_cos_all<S: Bits, const K: usize>(angles: [S; K]) -> ([S; K], [S; K]) {
    let mut sines = [S::ZERO; K];
    let mut cosines = [S::ZERO; K];
    // Whole packs of four, the last one filled up with its first angle, come out faster than odd numbers of lanes.
    for start in (0..K).step_by(4) {
        if K - start < 3 || S::WIDTH > 1 {
            for k in start..K {
                (sines[k], cosines[k]) = lane(angles[k]);
            }
        } else {
            let mut results = [(S::ZERO, S::ZERO); 4];
            for (k, result) in results.iter_mut().enumerate() {
                let filled = if start + k < K { start + k } else { start };
                *result = lane(angles[filled]);
            }
            for k in start..K.min(start + 4) {
                (sines[k], cosines[k]) = results[k - start];
            }
        }
    }
    let within = |angle: S| S::less_equal(angle.abs(), S::from_f64(LIMIT));
    let mut all = S::equal(S::ZERO, S::ZERO);
    for angle in angles {
        all = S::and(all, within(angle));
    }
    if S::any(S::not(all)) {
        for (k, angle) in angles.into_iter().enumerate() {
            let far = |value: fn(f64) -> f64| each(angle, value);
            sines[k] = S::select(within(angle), sines[k], far(f64::sin));
            cosines[k] = S::select(within(angle), cosines[k], far(f64::cos));
        }
    }
    (sines, cosines)
}

/// The kernel for one angle within the limit.
#[inline(always)]
fn lane<S: Bits>(angle: S) -> (S, S) {
    let constant = S::from_f64;
    let magic = constant(MAGIC);
    let shifted = angle.mul_add(constant(std::f64::consts::FRAC_2_PI), magic);
    let turns = shifted - magic;

    // The remainder as an unevaluated sum: the first two products are exact, `lost` is what `second` rounded away.
    let first = turns.mul_add(constant(-QUARTER_1), angle);
    let second = turns.mul_add(constant(-QUARTER_2), first);
    let lost = turns.mul_add(constant(-QUARTER_2), first - second);
    let third = turns.mul_add(constant(QUARTER_3), -lost);
    let high = second - third;
    let low = (second - high) - third;

    let (sine, cosine) = (sine_near_zero(high, low), cosine_near_zero(high, low));

    let quadrant = shifted.bits();
    let swap = S::spread(quadrant & S::word(1));
    let (s, c) = (sine.bits(), cosine.bits());
    let exchanged = (s ^ c) & swap;
    // The second bit of the quarter turns is the sign of the sine, that of one more the sign of the cosine.
    let sine_sign = S::raised::<62>(quadrant & S::word(2));
    let cosine_sign = sine_sign ^ S::raised::<63>(quadrant);
    (S::of_bits((s ^ exchanged) ^ sine_sign), S::of_bits((c ^ exchanged) ^ cosine_sign))
}

/// A polynomial, its coefficients from the lowest on. They are taken one by one: arrays of packs would go through memory.
#[inline(always)]
pub(super) fn horner<S: Scalar, const N: usize>(z: S, coefficients: [f64; N]) -> S {
    let mut sum = S::ZERO;
    for k in (0..N).rev() {
        let coefficient = S::from_f64(coefficients[k]);
        sum = if k + 1 == N { coefficient } else { sum.mul_add(z, coefficient) };
    }
    sum
}

/// Sine of `x + y` for `|x| <= π/4`, where `y` is a correction below the last digit of `x`.
#[inline(always)]
fn sine_near_zero<S: Scalar>(x: S, y: S) -> S {
    let [first, rest @ ..] = SINE;
    let z = x * x;
    let cube = z * x;
    let tail = horner(z, rest);
    let bent = cube.mul_add(-tail, S::from_f64(0.5) * y).mul_add(z, -y);
    x - cube.mul_add(S::from_f64(-first), bent)
}

/// Cosine of `x + y` for `|x| <= π/4`, where `y` is a correction below the last digit of `x`.
#[inline(always)]
fn cosine_near_zero<S: Scalar>(x: S, y: S) -> S {
    let z = x * x;
    let series = horner(z, COSINE);
    let half = S::from_f64(0.5) * z;
    let chord = S::ONE - half;
    let rounding = (S::ONE - chord) - half;
    chord + (rounding + (z * z).mul_add(series, -(x * y)))
}

#[cfg(test)]
pub(super) mod tests;
