//! Angles of several points at once.
//!
//! The kernel has no branches and no calls, so that the compiler packs the lanes. A point is brought into the first
//! eighth of the plane; with `t` its tangent, `atan t` up to `t = 1/2` is a polynomial, and beyond it is
//! `π/4 + atan((t - 1)/(t + 1))`, where the difference is exact, with one division in both cases. What is added then are
//! multiples of π/4 whose digits end in zeros, so that their sums are exact. The error is below 1.8 units in the last
//! place. Points whose longer coordinate is zero, infinite or NaN, or near the limits of the numbers, take the standard
//! library's path.

use super::Scalar;
use super::sine::{Bits, horner};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Largest longer coordinate: sums of two are finite.
const LARGEST: f64 = 1e300;
/// Smallest longer coordinate: what is lost of the shorter one is beyond its last digit.
const SMALLEST: f64 = 1e-300;

/// The bit of the sign.
const SIGN: u64 = 1 << 63;

/// What the digits of [`FRAC_PI_4`] leave out of π/4, as a part of it. It is the same part of its multiples.
const LEFT_OUT: f64 = 3.061616997868383e-17 / FRAC_PI_4;

/// Coefficients of `(atan t - t) / t³` in powers of `t²` for `t <= 1/2`, the even and the odd ones: minimax, relative error below
/// 2⁻⁵⁷.
const ARC: [[f64; 6]; 2] = [
    [
        -0.3333333333333298,
        -0.14285714276389902,
        -0.0909089624819324,
        -0.06663811070287798,
        -0.05122017336797078,
        -0.02743540141743454,
    ],
    [
        0.19999999999903162,
        0.11111110659790925,
        0.07692073961349852,
        0.05858301728673895,
        0.04186534423204164,
        0.010117144756717556,
    ],
];

/// Angles in `[-π, π]` of all the points.
#[inline(always)]
pub(super) fn atan2_all<S: Bits, const K: usize>(y: [S; K], x: [S; K]) -> [S; K] {
    let mut angles = [S::ZERO; K];
    for k in 0..K {
        angles[k] = lane(y[k], x[k]);
    }
    let mut all = S::equal(S::ZERO, S::ZERO);
    for k in 0..K {
        all = S::and(all, is_within(y[k], x[k]));
    }
    if S::any(S::not(all)) {
        for k in 0..K {
            angles[k] = S::select(is_within(y[k], x[k]), angles[k], by_library(y[k], x[k]));
        }
    }
    angles
}

/// Whether the kernel serves for a point.
#[inline(always)]
fn is_within<S: Bits>(y: S, x: S) -> S::Mask {
    let (width, height) = (x.abs(), y.abs());
    let longer = S::select(S::less(width, height), height, width);
    let small = S::less(longer, S::from_f64(SMALLEST));
    S::and(S::not(small), S::less_equal(longer, S::from_f64(LARGEST)))
}

/// For points that the kernel does not serve.
#[cold]
#[inline(never)]
fn by_library<S: Bits>(y: S, x: S) -> S {
    y.each(x, f64::atan2)
}

/// The sign of a number, as 1 or -1, and 1 of zero unless it is negative.
#[inline(always)]
fn sense_of<S: Bits>(number: S) -> S {
    S::of_bits(S::word(1.0f64.to_bits()) | (number.bits() & S::word(SIGN)))
}

/// The kernel for one point within the limits. Which eighth it is in comes as signs that are multiplied, because the
/// compiler makes jumps of what is selected.
#[inline(always)]
fn lane<S: Bits>(y: S, x: S) -> S {
    let (one, half) = (S::ONE, S::from_f64(0.5));
    let (width, height) = (x.abs(), y.abs());
    let is_steep = S::less(width, height);
    let longer = S::select(is_steep, height, width);
    let shorter = S::select(is_steep, width, height);
    let right = sense_of(x);
    // The sense in which the angle grows with the tangent of the first eighth.
    let sense = right * sense_of(width - height);
    let near = sense_of(half.mul_add(longer, -shorter));
    let near = half.mul_add(near, half);
    let far = one - near;

    let up = shorter - far * longer;
    let along = longer + far * shorter;
    let turn = arc(sense * up / along);
    // From the y axis, in eighths.
    let eighths = sense.mul_add(near, right);
    let middle = S::from_f64(FRAC_PI_2) - S::from_f64(FRAC_PI_4) * eighths;
    let angle = middle + middle.mul_add(S::from_f64(LEFT_OUT), turn);
    S::of_bits(angle.bits() | (y.bits() & S::word(SIGN)))
}

/// The angle with this tangent, up to 1/2.
#[inline(always)]
fn arc<S: Scalar>(t: S) -> S {
    let z = t * t;
    let w = z * z;
    let (even, odd) = (horner(w, ARC[0]), horner(w, ARC[1]));
    (t * z).mul_add(odd.mul_add(z, even), t)
}

#[cfg(test)]
mod tests;
