//! Intervals: enclosures of all values that an expression takes while its arguments range over theirs.

use super::Scalar;
use assur_functions::Table;
use assur_functions::table::ORDERS;
use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `low` to `high`, rounded outwards.
///
/// What lies outside the domain of a function is left out; an argument wholly outside gives NaN. Functions of the
/// standard library are taken to be right within four units in the last place.
///
/// ```
/// use assur_solvers::scalar::{Interval, Scalar};
/// let x = Interval::new(-1.0, 2.0);
/// let square = x * x;
/// assert!(square.low <= -2.0 && square.high >= 4.0);
/// assert!(Interval::new(0.0, 4.0).sin_cos().0.high == 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// No number is smaller.
    pub low: f64,
    /// No number is greater.
    pub high: f64,
}

/// Whether a comparison of two intervals may hold and may fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Perhaps {
    /// It holds for some numbers.
    pub may_hold: bool,
    /// It fails for some numbers.
    pub may_fail: bool,
}

impl std::ops::BitAnd for Perhaps {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self {
            may_hold: self.may_hold && other.may_hold,
            may_fail: self.may_fail || other.may_fail,
        }
    }
}

impl std::ops::BitOr for Perhaps {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self {
            may_hold: self.may_hold || other.may_hold,
            may_fail: self.may_fail && other.may_fail,
        }
    }
}

impl std::ops::Not for Perhaps {
    type Output = Self;
    fn not(self) -> Self {
        Self { may_hold: self.may_fail, may_fail: self.may_hold }
    }
}

/// Relative error that a function of the standard library may have.
const LIBRARY: f64 = 4.0 * f64::EPSILON;
/// Largest angle of which the quadrant is told.
const LARGEST_ANGLE: f64 = 1e6;

impl Interval {
    /// All numbers.
    pub const ENTIRE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// No number.
    const NOTHING: Self = Self { low: f64::NAN, high: f64::NAN };

    /// The numbers between two of them.
    pub const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// One number.
    pub const fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// A number in the middle.
    pub fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// Distance of the ends.
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// Whether a number is among them.
    pub fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// The smallest interval with all numbers of both.
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// The numbers in both, if there are any.
    pub fn meet(self, other: Self) -> Option<Self> {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        (low <= high).then_some(Self { low, high })
    }

    /// The greatest absolute value.
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Ends that have been rounded to nearest, one step outwards.
    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::NOTHING;
        }
        Self::new(low.next_down(), high.next_up())
    }

    /// Ends that come from the standard library.
    fn library(low: f64, high: f64) -> Self {
        let down = low - LIBRARY * low.abs();
        let up = high + LIBRARY * high.abs();
        Self::outward(down, up)
    }

    /// A function that grows.
    fn growing(self, f: impl Fn(f64) -> f64) -> Self {
        Self::library(f(self.low), f(self.high))
    }

    /// The part within a domain.
    fn within(self, low: f64, high: f64) -> Self {
        self.meet(Self::new(low, high)).unwrap_or(Self::NOTHING)
    }

    /// Sine or cosine, whose greatest value is at `top` and whose smallest half a turn on.
    fn wave(self, f: impl Fn(f64) -> f64, top: f64) -> Self {
        if self.low.is_nan() || self.high.is_nan() {
            return Self::NOTHING;
        }
        if self.width() >= TAU || self.magnitude() > LARGEST_ANGLE {
            return Self::new(-1.0, 1.0);
        }
        let (a, b) = (f(self.low), f(self.high));
        let ends = Self::library(a.min(b), a.max(b));
        let high = if self.meets_turn(top) { 1.0 } else { ends.high.min(1.0) };
        let low = if self.meets_turn(top + PI) { -1.0 } else { ends.low.max(-1.0) };
        Self { low, high }
    }

    /// Whether an angle, or one a number of turns from it, may be among them.
    fn meets_turn(self, angle: f64) -> bool {
        let slack = 1e-9;
        let (low, high) = ((self.low - angle) / TAU - slack, (self.high - angle) / TAU + slack);
        low.ceil() <= high
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.low.is_nan() || other.low.is_nan() {
            return Self::NOTHING;
        }
        // Zero times infinity is zero here: infinite ends are not values.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let all = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        let low = all.into_iter().fold(f64::INFINITY, f64::min);
        let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
        if low == 0.0 && high == 0.0 && (self.magnitude() == 0.0 || other.magnitude() == 0.0) {
            return Self::point(0.0);
        }
        Self::outward(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.low.is_nan() || other.low.is_nan() {
            return Self::NOTHING;
        }
        if other.contains(0.0) {
            return Self::ENTIRE;
        }
        let all = [
            self.low / other.low,
            self.low / other.high,
            self.high / other.low,
            self.high / other.high,
        ];
        if all.into_iter().any(f64::is_nan) {
            return Self::ENTIRE;
        }
        let low = all.into_iter().fold(f64::INFINITY, f64::min);
        let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self::outward(low, high)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

/// Growing functions, with the domain that each has.
macro_rules! growing {
    ($($name:ident: $low:expr, $high:expr;)*) => {$(
        fn $name(self) -> Self {
            self.within($low, $high).growing(<f64 as Scalar>::$name)
        }
    )*};
}

impl Scalar for Interval {
    type Mask = Perhaps;
    const ZERO: Self = Self::point(0.0);
    const ONE: Self = Self::point(1.0);

    fn from_f64(value: f64) -> Self {
        Self::point(value)
    }
    /// The middle.
    fn to_f64(self) -> f64 {
        self.middle()
    }
    fn mean(_: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        Self::mean_over(&near, &far)
    }
    fn root(_: &str, function: impl Fn(Self) -> Self) -> Self {
        Self::root_over(&function)
    }
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_over(&function)
    }
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        Self::highest_place_over(&function)
    }
    fn table(self, table: &Table<'_>) -> [Self; ORDERS] {
        [0, 1, 2, 3].map(|order| self.over_pieces(table, order))
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    fn less(left: Self, right: Self) -> Perhaps {
        Perhaps {
            may_hold: left.low < right.high,
            may_fail: left.high.partial_cmp(&right.low) != Some(Ordering::Less),
        }
    }
    fn less_equal(left: Self, right: Self) -> Perhaps {
        Perhaps {
            may_hold: left.low <= right.high,
            may_fail: left.high.partial_cmp(&right.low).is_none_or(Ordering::is_gt),
        }
    }
    fn equal(left: Self, right: Self) -> Perhaps {
        let same = left.low == left.high && left == right;
        Perhaps { may_hold: left.low <= right.high && right.low <= left.high, may_fail: !same }
    }
    /// Whether it certainly holds.
    fn holds(mask: Perhaps) -> bool {
        mask.may_hold && !mask.may_fail
    }
    /// The hull of both where the mask is uncertain.
    fn select(mask: Perhaps, then: Self, otherwise: Self) -> Self {
        match (mask.may_hold, mask.may_fail) {
            (true, true) => then.hull(otherwise),
            (true, false) => then,
            _ => otherwise,
        }
    }
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let sines = angles.map(|angle| angle.wave(f64::sin, FRAC_PI_2));
        let cosines = angles.map(|angle| angle.wave(f64::cos, 0.0));
        (sines, cosines)
    }
    fn tan(self) -> Self {
        let pole = self.width() >= PI || self.magnitude() > LARGEST_ANGLE;
        if pole || self.meets_turn(FRAC_PI_2) || self.meets_turn(-FRAC_PI_2) {
            return Self::ENTIRE;
        }
        self.growing(f64::tan)
    }
    fn acos(self) -> Self {
        let part = self.within(-1.0, 1.0);
        Self::library(part.high.acos(), part.low.acos())
    }
    /// The whole circle where the half line to the left is met.
    fn atan2(y: Self, x: Self) -> Self {
        if y.contains(0.0) && x.low <= 0.0 {
            let pi = PI.next_up();
            return Self::new(-pi, pi);
        }
        let corners =
            [y.low.atan2(x.low), y.low.atan2(x.high), y.high.atan2(x.low), y.high.atan2(x.high)];
        let low = corners.into_iter().fold(f64::INFINITY, f64::min);
        let high = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self::library(low, high)
    }
    fn cosh(self) -> Self {
        self.abs().growing(f64::cosh)
    }
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.abs(), other.abs());
        Self::library(a.low.hypot(b.low).max(0.0), a.high.hypot(b.high))
    }
    fn powf(self, exponent: Self) -> Self {
        let n = exponent.low;
        let whole = n == exponent.high && n == n.floor() && n.abs() <= 64.0;
        if !whole {
            return (self.within(0.0, f64::INFINITY).ln() * exponent).exp();
        }
        let base = if n % 2.0 == 0.0 { self.abs() } else { self };
        let power = Self::library(base.low.powf(n.abs()), base.high.powf(n.abs()));
        if n < 0.0 { Self::ONE / power } else { power }
    }
    fn floor(self) -> Self {
        Self::new(self.low.floor(), self.high.floor())
    }
    fn abs(self) -> Self {
        let low = if self.contains(0.0) { 0.0 } else { self.low.abs().min(self.high.abs()) };
        Self::new(low, self.magnitude())
    }
    fn sign(self) -> Self {
        Self::new(Scalar::sign(self.low), Scalar::sign(self.high))
    }
    fn max(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.max(other.high))
    }
    fn min(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.min(other.high))
    }
    fn erf(self) -> Self {
        Self::library(assur_functions::erf(self.low), assur_functions::erf(self.high))
    }
    fn normal_cdf(self) -> Self {
        let f = assur_functions::normal_cdf;
        Self::library(f(self.low), f(self.high))
    }

    growing! {
        asin:   -1.0, 1.0;
        atan:   f64::NEG_INFINITY, f64::INFINITY;
        sinh:   f64::NEG_INFINITY, f64::INFINITY;
        tanh:   f64::NEG_INFINITY, f64::INFINITY;
        exp:    f64::NEG_INFINITY, f64::INFINITY;
        exp_m1: f64::NEG_INFINITY, f64::INFINITY;
        ln:     0.0, f64::INFINITY;
        ln_1p:  -1.0, f64::INFINITY;
        log10:  0.0, f64::INFINITY;
        sqrt:   0.0, f64::INFINITY;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Functions of one argument, on any scalar.
    fn functions<S: Scalar>(x: S) -> [S; 17] {
        let (sine, cosine) = x.sin_cos();
        let half = S::from_f64(0.5);
        [
            sine,
            cosine,
            x.tan(),
            x.atan(),
            x.sinh(),
            x.cosh(),
            x.tanh(),
            x.exp(),
            x.exp_m1(),
            x.erf(),
            x.floor(),
            x.abs(),
            x.sign(),
            x * x - x / (x * x + S::ONE),
            x.max(half) - x.min(half),
            S::select(S::less(x, half), x * half, -x),
            S::atan2(x, half - x) + x.hypot(half) + x.powf(S::from_f64(3.0)),
        ]
    }

    /// Functions of an argument above zero.
    fn positive<S: Scalar>(x: S) -> [S; 6] {
        [
            x.sqrt(),
            x.ln(),
            x.ln_1p(),
            x.log10(),
            x.powf(S::from_f64(-1.5)),
            (x / (x + S::ONE)).acos(),
        ]
    }

    #[test]
    fn values_lie_within() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for _ in 0..3000 {
            let low = 20.0 * random() - 10.0;
            let x = Interval::new(low, low + 10f64.powf(-8.0 * random()) * 3.0);
            let enclosures = functions(x);
            let above = Interval::new(x.low.abs(), x.low.abs() + x.width());
            for k in 0..=4 {
                let inside = (x.low + x.width() * 0.25 * f64::from(k)).min(x.high);
                for (n, (value, enclosure)) in
                    functions(inside).into_iter().zip(enclosures).enumerate()
                {
                    assert!(enclosure.contains(value), "{n}: {value} of {inside} in {enclosure:?}");
                }
                let inside = (above.low + x.width() * 0.25 * f64::from(k)).min(above.high);
                for (value, enclosure) in positive(inside).into_iter().zip(positive(above)) {
                    assert!(enclosure.contains(value), "{value} of {inside} in {enclosure:?}");
                }
            }
        }
    }

    #[test]
    fn enclosures_are_narrow() {
        let x = Interval::new(0.3, 0.3);
        for (value, enclosure) in functions(0.3).into_iter().zip(functions(x)) {
            assert!(enclosure.width() <= 1e-13 * (1.0 + value.abs()), "{enclosure:?}");
        }
    }

    #[test]
    fn zero_divides_into_everything() {
        assert_eq!(Interval::ONE / Interval::new(-1.0, 1.0), Interval::ENTIRE);
        assert!(Interval::new(-2.0, -1.0).sqrt().low.is_nan());
        assert_eq!(Interval::new(-2.0, 4.0).sqrt().low, 0.0f64.next_down());
        assert_eq!(Interval::point(1e300).sin_cos().0, Interval::new(-1.0, 1.0));
    }

    #[test]
    fn comparisons_say_when_they_do_not_know() {
        let (a, b) = (Interval::new(0.0, 2.0), Interval::new(1.0, 3.0));
        assert_eq!(Interval::less(a, b), Perhaps { may_hold: true, may_fail: true });
        assert!(!Interval::holds(Interval::less(a, b)));
        assert!(Interval::holds(Interval::less(a, Interval::point(2.5))));
        assert_eq!(Interval::select(Interval::less(a, b), a, b), Interval::new(0.0, 3.0));
    }
}
