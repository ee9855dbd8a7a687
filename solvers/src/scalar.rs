//! Numbers that equations are evaluated on.
//!
//! Equations are written once, for any [`Scalar`]. A comparison gives a mask and a branch becomes [`Scalar::select`],
//! so that several lanes of a pack may take different sides.

mod angle;
mod bounded;
mod dual;
mod found;
mod fused;
mod interval;
mod lanes;
mod plain;
pub(crate) mod processor;
mod sine;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use assur_functions::Table;
pub use assur_functions::fault;
use assur_functions::fault::Why;
use assur_functions::table::ORDERS;
pub use bounded::Bounded;
pub use dual::Dual;
pub(crate) use fused::Fused;
pub use interval::{Interval, Perhaps};
pub use lanes::{Lanes, Masks, WIDTH};
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::F64x8;

/// A number that is an `f64` in memory, so that plain slices can be read as slices of it.
pub(crate) trait Real: Scalar {
    /// A list of numbers as numbers of this type.
    fn of(numbers: &[f64]) -> &[Self];
    /// A list of numbers as numbers of this type, to be written.
    fn of_mut(numbers: &mut [f64]) -> &mut [Self];
}

/// Some `f64` side by side, or one.
pub trait Pack: Scalar {
    /// How many.
    const WIDTH: usize;
    /// The first ones of a list.
    fn load(numbers: &[f64]) -> Self;
    /// Writes them to the begin of a list.
    fn store(self, numbers: &mut [f64]);

    /// A function of two numbers, one by one.
    #[doc(hidden)]
    #[inline(never)]
    fn each(self, other: Self, value: impl Fn(f64, f64) -> f64) -> Self {
        let (mut all, mut others) = ([0.0; WIDTH], [0.0; WIDTH]);
        self.store(&mut all);
        other.store(&mut others);
        for (lane, other) in all.iter_mut().zip(others).take(Self::WIDTH) {
            *lane = value(*lane, other);
        }
        Self::load(&all)
    }
}

/// A number: `f64`, `f32`, fused `f64`, a pack of lanes, a dual number, an interval, a number with the bound of its
/// error.
///
/// A function of an argument outside its domain gives NaN. Nothing here panics.
pub trait Scalar:
    Copy
    + std::fmt::Debug
    + Send
    + Sync
    + 'static
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Div<Output = Self>
    + std::ops::Neg<Output = Self>
{
    /// Result of a comparison; [`Scalar::and`], [`Scalar::or`] and [`Scalar::not`] are its operators.
    type Mask: Copy
        + Send
        + Sync
        + std::fmt::Debug
        + std::ops::BitAnd<Output = Self::Mask>
        + std::ops::BitOr<Output = Self::Mask>
        + std::ops::Not<Output = Self::Mask>;
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// Whether Taylor series are computed on these numbers: on one real number, of which zero is nothing (no lane beside it,
    /// no derivative), and which needs no instructions of its own.
    const SINGLE: bool = false;

    /// The number, in all lanes.
    fn from_f64(value: f64) -> Self;
    /// The number (that of the first lane, or the value part).
    fn to_f64(self) -> f64;
    /// `self * factor + term`, rounded once where the type is fused.
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// Whether `left < right`.
    fn less(left: Self, right: Self) -> Self::Mask;
    /// Whether `left <= right`.
    fn less_equal(left: Self, right: Self) -> Self::Mask;
    /// Whether `left == right`; a NaN equals nothing, itself included.
    fn equal(left: Self, right: Self) -> Self::Mask;
    /// Whether both hold.
    #[inline(always)]
    fn and(left: Self::Mask, right: Self::Mask) -> Self::Mask {
        left & right
    }
    /// Whether at least one holds.
    #[inline(always)]
    fn or(left: Self::Mask, right: Self::Mask) -> Self::Mask {
        left | right
    }
    /// Whether it does not hold.
    #[inline(always)]
    fn not(mask: Self::Mask) -> Self::Mask {
        !mask
    }
    /// The mask as a truth value (that of the first lane).
    fn holds(mask: Self::Mask) -> bool;
    /// Whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool {
        Self::holds(mask)
    }
    /// `then` where the mask holds, `otherwise` elsewhere.
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// Does work as a function of its own, compiled for the instructions of these numbers: what a long function that is
    /// generic over its numbers has instead of `#[inline(never)]`, which would compile it without them.
    ///
    /// Write `S::outline(#[inline(always)] || …)`, since the work itself has to be inlined there.
    #[inline(always)]
    fn outline<R>(work: impl FnMut() -> R) -> R {
        plain::apart(work)
    }

    /// Sines and cosines of several angles in radians, computed together.
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]);

    /// Sine and cosine of an angle in radians: the same values as from [`Scalar::sin_cos_all`], bit for bit.
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let ([sine], [cosine]) = Self::sin_cos_all([self]);
        (sine, cosine)
    }

    /// Tangent.
    fn tan(self) -> Self;
    /// Angle in `[-π/2, π/2]` with this sine.
    fn asin(self) -> Self;
    /// Angle in `[0, π]` with this cosine.
    fn acos(self) -> Self;
    /// Angle in `[-π/2, π/2]` with this tangent.
    fn atan(self) -> Self;
    /// Angle in `[-π, π]` of the point `(x, y)`.
    fn atan2(y: Self, x: Self) -> Self;
    /// Angles of several points, computed together: the same values as from [`Scalar::atan2`], bit for bit.
    #[inline(always)]
    fn atan2_all<const K: usize>(y: [Self; K], x: [Self; K]) -> [Self; K] {
        let mut angles = y;
        for (angle, x) in angles.iter_mut().zip(x) {
            *angle = Self::atan2(*angle, x);
        }
        angles
    }
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// `e` to this power.
    fn exp(self) -> Self;
    /// `e` to this power, less one, accurate near zero.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Natural logarithm of one plus the number, accurate near zero.
    fn ln_1p(self) -> Self;
    /// Logarithm to base 10.
    fn log10(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Square root of the sum of two squares, without overflow.
    fn hypot(self, other: Self) -> Self;
    /// The number to a power.
    fn powf(self, exponent: Self) -> Self;
    /// Error function.
    fn erf(self) -> Self;
    /// Distribution function of the standard normal distribution, accurate in its lower tail.
    fn normal_cdf(self) -> Self;
    /// The mean of a function over a range, which is given by its distances from both ends, up to a half, as shares of the range;
    /// NaN where it does not settle, which is kept as a [`fault`] of what is looked for.
    #[inline(always)]
    fn mean(what: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        let found = found::mean_of_values(&near, &far);
        match found.fault {
            Some(why) => fault::keep(what, Why::Mean(why)),
            None => fault::doubt(found.error / found.size),
        }
        Self::from_f64(found.value)
    }
    /// Where a function passes zero between 0 and 1; NaN where it does not.
    #[inline(always)]
    fn root(what: &str, function: impl Fn(Self) -> Self) -> Self {
        let mut value = |place: f64| found::value(&function, place);
        Self::from_f64(found::root_or_fault(what, &mut value))
    }
    /// The largest value of a function between 0 and 1.
    #[inline(always)]
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        let mut value = |place: f64| found::value(&function, place);
        Self::from_f64(assur_functions::highest(&mut value).value)
    }
    /// Where that is.
    #[inline(always)]
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        let mut value = |place: f64| found::value(&function, place);
        Self::from_f64(assur_functions::highest(&mut value).place)
    }
    /// A sampled curve and its first three derivatives; NaN outside of its range, which is kept as a fault.
    #[inline(always)]
    fn table(self, table: &Table<'_>) -> [Self; ORDERS] {
        let (begin, [a, b, c, d]) = table.at(self.to_f64());
        let number = Self::from_f64;
        let t = self - number(begin);
        let (twist, bend) = (number(3.0 * d), number(2.0 * c));
        [
            number(d).mul_add(t, number(c)).mul_add(t, number(b)).mul_add(t, number(a)),
            twist.mul_add(t, bend).mul_add(t, number(b)),
            number(6.0 * d).mul_add(t, bend),
            number(6.0 * d),
        ]
    }
    /// Largest whole number that is not greater.
    fn floor(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;

    /// −1, 0 or 1 with the sign of the number; zero of either sign and NaN give themselves.
    #[inline(always)]
    fn sign(self) -> Self {
        let below = Self::select(Self::less(self, Self::ZERO), -Self::ONE, self);
        Self::select(Self::less(Self::ZERO, self), Self::ONE, below)
    }

    /// The greater of two numbers; NaN if either is NaN.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let first = Self::or(Self::less_equal(other, self), Self::not(Self::equal(self, self)));
        Self::select(first, self, other)
    }

    /// The smaller of two numbers; NaN if either is NaN.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        let first = Self::or(Self::less_equal(self, other), Self::not(Self::equal(self, self)));
        Self::select(first, self, other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks what every real scalar type must do, with values that all of them hold exactly.
    fn check<S: Scalar>() {
        let number = S::from_f64;
        let three = number(3.0);
        assert_eq!(three.mul_add(number(5.0), number(-7.0)).to_f64(), 8.0);
        assert!(S::holds(S::less(number(1.0), number(2.0))));
        assert!(!S::holds(S::less(number(2.0), number(2.0))));
        assert!(S::holds(S::less_equal(number(2.0), number(2.0))));
        assert!(!S::holds(S::equal(number(f64::NAN), number(f64::NAN))));
        let (yes, no) = (S::equal(three, three), S::less(three, three));
        assert!(S::holds(S::or(yes, no)) && S::holds(S::or(no, yes)));
        assert!(!S::holds(S::and(yes, no)) && !S::holds(S::and(no, yes)));
        assert!(S::holds(S::not(no)) && S::holds(S::and(yes, yes)));
        assert_eq!(S::select(yes, three, S::ONE).to_f64(), 3.0);
        assert_eq!(S::select(no, three, S::ONE).to_f64(), 1.0);
        for (value, sign) in [(-2.5, -1.0), (0.0, 0.0), (-0.0, 0.0), (1e-30, 1.0)] {
            assert_eq!(number(value).sign().to_f64(), sign);
        }
        for (left, right) in [(1.0, 2.0), (2.0, 1.0), (-3.0, -3.0)] {
            let (a, b) = (number(left), number(right));
            assert_eq!(a.max(b).to_f64(), f64::max(left, right));
            assert_eq!(a.min(b).to_f64(), f64::min(left, right));
        }
        let nan = number(f64::NAN);
        for value in [nan.max(three), three.max(nan), nan.min(three), three.min(nan), nan.sign()] {
            assert!(value.to_f64().is_nan());
        }
        assert_eq!(number(-2.5).floor().to_f64(), -3.0);
        assert_eq!(number(-2.5).abs().to_f64(), 2.5);
        assert_eq!(three.hypot(number(4.0)).to_f64(), 5.0);
        assert!(number(-1.0).sqrt().to_f64().is_nan());
    }

    /// Largest error of the functions at one argument against plain `f64`, in units of the type's precision.
    fn functions<S: Scalar>(x: f64) -> f64 {
        let s = S::from_f64(x);
        let half = S::from_f64(0.5);
        let (sine, cosine) = s.sin_cos();
        [
            (sine, x.sin()),
            (cosine, x.cos()),
            (s.tan(), x.tan()),
            (s.asin(), x.asin()),
            (s.acos(), x.acos()),
            (s.atan(), x.atan()),
            (S::atan2(-s, -half), (-x).atan2(-0.5)),
            (s.sinh(), x.sinh()),
            (s.cosh(), x.cosh()),
            (s.tanh(), x.tanh()),
            (s.exp(), x.exp()),
            (s.exp_m1(), x.exp_m1()),
            (s.ln(), x.ln()),
            (s.ln_1p(), x.ln_1p()),
            (s.log10(), x.log10()),
            (s.sqrt(), x.sqrt()),
            (s.powf(half), x.powf(0.5)),
        ]
        .into_iter()
        .map(|(found, expected)| (found.to_f64() / expected - 1.0).abs())
        .fold(0.0, f64::max)
    }

    #[test]
    fn real_types_agree() {
        check::<f64>();
        check::<f32>();
        check::<Fused>();
        check::<Bounded>();
        for x in [0.125, 0.375, 0.75, 0.875] {
            assert!(functions::<f64>(x) < 5e-16);
            assert!(functions::<Fused>(x) < 5e-16);
            assert!(functions::<Bounded>(x) < 5e-16);
            assert!(functions::<f32>(x) < 5e-7);
        }
    }
}
