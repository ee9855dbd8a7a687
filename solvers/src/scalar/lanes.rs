//! Several numbers that are computed alike, side by side.

// Iterators over several arrays side by side are not packed by the compiler; places are.
#![allow(clippy::needless_range_loop)]

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Scalar, Table};

/// Most numbers side by side, in a pack or in lanes.
pub const WIDTH: usize = 8;

/// Some numbers side by side.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Lanes<S>(pub [S; WIDTH]);

/// What is true of each.
#[derive(Clone, Copy, Debug)]
pub struct Masks<M>([M; WIDTH]);

impl<M: Copy> Masks<M> {
    /// The same in all lanes.
    #[inline(always)]
    pub fn splat(mask: M) -> Self {
        Self([mask; WIDTH])
    }
}

impl<S: Scalar> Lanes<S> {
    /// The same number in all lanes.
    #[inline(always)]
    pub fn splat(value: S) -> Self {
        Self([value; WIDTH])
    }

    #[inline(always)]
    fn map(self, value: impl Fn(S) -> S) -> Self {
        let mut all = self;
        for lane in &mut all.0 {
            *lane = value(*lane);
        }
        all
    }

    #[inline(always)]
    fn zip(self, other: Self, value: impl Fn(S, S) -> S) -> Self {
        let mut all = self;
        for lane in 0..WIDTH {
            all.0[lane] = value(self.0[lane], other.0[lane]);
        }
        all
    }

    #[inline(always)]
    fn compare(self, other: Self, holds: impl Fn(S, S) -> S::Mask) -> Masks<S::Mask> {
        let mut masks = [holds(self.0[0], other.0[0]); WIDTH];
        for lane in 0..WIDTH {
            masks[lane] = holds(self.0[lane], other.0[lane]);
        }
        Masks(masks)
    }

    /// A search in each lane by itself; what is searched is a function of all lanes.
    #[inline(always)]
    fn found(find: impl Fn(usize) -> S) -> Self {
        let mut all = [S::ZERO; WIDTH];
        for (lane, value) in all.iter_mut().enumerate() {
            *value = find(lane);
        }
        Self(all)
    }
}

/// Implements operators between two values.
macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl<S: Scalar> $operator for Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a.$method(b))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<S: Scalar> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|lane| -lane)
    }
}

impl<M: Copy + BitAnd<Output = M>> BitAnd for Masks<M> {
    type Output = Self;
    #[inline(always)]
    fn bitand(mut self, other: Self) -> Self {
        for lane in 0..WIDTH {
            self.0[lane] = self.0[lane] & other.0[lane];
        }
        self
    }
}

impl<M: Copy + BitOr<Output = M>> BitOr for Masks<M> {
    type Output = Self;
    #[inline(always)]
    fn bitor(mut self, other: Self) -> Self {
        for lane in 0..WIDTH {
            self.0[lane] = self.0[lane] | other.0[lane];
        }
        self
    }
}

impl<M: Copy + Not<Output = M>> Not for Masks<M> {
    type Output = Self;
    #[inline(always)]
    fn not(mut self) -> Self {
        for own in &mut self.0 {
            *own = !*own;
        }
        self
    }
}

/// Functions of one number, lane by lane.
macro_rules! elementary {
    ($($name:ident),*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            self.map(S::$name)
        }
    )*};
}

impl<S: Scalar> Scalar for Lanes<S> {
    type Mask = Masks<S::Mask>;
    const ZERO: Self = Self([S::ZERO; WIDTH]);
    const ONE: Self = Self([S::ONE; WIDTH]);

    #[inline(always)]
    fn outline<R>(work: impl FnMut() -> R) -> R {
        S::outline(work)
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::splat(S::from_f64(value))
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0[0].to_f64()
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        let mut all = self;
        for lane in 0..WIDTH {
            all.0[lane] = self.0[lane].mul_add(factor.0[lane], term.0[lane]);
        }
        all
    }
    #[inline(always)]
    fn less(left: Self, right: Self) -> Self::Mask {
        left.compare(right, S::less)
    }
    #[inline(always)]
    fn less_equal(left: Self, right: Self) -> Self::Mask {
        left.compare(right, S::less_equal)
    }
    #[inline(always)]
    fn equal(left: Self, right: Self) -> Self::Mask {
        left.compare(right, S::equal)
    }
    #[inline(always)]
    fn holds(mask: Self::Mask) -> bool {
        S::holds(mask.0[0])
    }
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        mask.0.iter().any(|mask| S::holds(*mask))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self {
        let mut all = then;
        for lane in 0..WIDTH {
            all.0[lane] = S::select(mask.0[lane], then.0[lane], otherwise.0[lane]);
        }
        all
    }
    #[inline(always)]
    fn sin_cos_all<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let (mut sines, mut cosines) = (angles, angles);
        for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
            (sine.0, cosine.0) = S::sin_cos_all(sine.0);
        }
        (sines, cosines)
    }
    #[inline(always)]
    fn atan2(y: Self, x: Self) -> Self {
        Self(S::atan2_all(y.0, x.0))
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.zip(other, S::hypot)
    }
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.zip(exponent, S::powf)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, S::max)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, S::min)
    }
    elementary!(
        tan, asin, acos, atan, sinh, cosh, tanh, exp, exp_m1, ln, ln_1p, log10, sqrt, erf,
        normal_cdf, floor, abs, sign
    );

    fn mean(what: &str, near: impl Fn(Self) -> Self, far: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| {
            S::mean(what, |x| near(Self::splat(x)).0[lane], |x| far(Self::splat(x)).0[lane])
        })
    }
    fn root(what: &str, function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| S::root(what, |x| function(Self::splat(x)).0[lane]))
    }
    fn highest(function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| S::highest(|x| function(Self::splat(x)).0[lane]))
    }
    fn highest_place(function: impl Fn(Self) -> Self) -> Self {
        Self::found(|lane| S::highest_place(|x| function(Self::splat(x)).0[lane]))
    }
    #[inline(always)]
    fn table(self, table: &Table<'_>) -> [Self; 4] {
        let mut all = [self; 4];
        for (lane, place) in self.0.into_iter().enumerate() {
            for (order, value) in all.iter_mut().zip(place.table(table)) {
                order.0[lane] = value;
            }
        }
        all
    }
}
