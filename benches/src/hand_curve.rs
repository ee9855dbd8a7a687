//! The curves of [`crate::sheets`] by hand: a cubic spline through a thousand points, looked up.
//!
//! Where points are evenly apart, the place times a factor is the number of the piece and the place in it. Elsewhere the
//! range is cut into so many equal buckets that none holds two points: the piece is that at the begin of the bucket, or the
//! next one, which one comparison tells. A sum with [`ROUND`] rounds to a whole number and has it in its lowest bits. Outside
//! of the range there are pieces with nothing in them, so that nobody asks for its ends.

use std::marker::PhantomData;
use std::sync::LazyLock;

use assur::scalar::Scalar;

use crate::sheets::{Code, Sheet};

/// Adding it leaves a whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// There is room for as many pieces, and for as many buckets: powers of two.
const PIECES: usize = 1024;
const BUCKETS: usize = 4096;

/// A curve with the factors of its pieces.
struct Spline {
    x: Vec<f64>,
    pieces: Vec<[f64; 4]>,
}

impl Spline {
    /// The curve through the points in a text.
    fn read(text: &str) -> Self {
        let number = |text: &str| text.trim().parse::<f64>().ok();
        let lines = text.lines().filter_map(|line| line.split_once(','));
        let numbers = lines.filter_map(|(x, y)| Some((number(x)?, number(y)?)));
        let (x, y): (Vec<f64>, Vec<f64>) = numbers.unzip();
        let slopes = slopes(&x, &y);
        let pieces = (0..x.len() - 1).map(|i| {
            let h = x[i + 1] - x[i];
            let d = (y[i + 1] - y[i]) / h;
            let c = (3.0 * d - 2.0 * slopes[i] - slopes[i + 1]) / h;
            [y[i], slopes[i], c, (slopes[i] + slopes[i + 1] - 2.0 * d) / (h * h)]
        });
        Self { pieces: pieces.collect(), x }
    }

    fn range(&self) -> (f64, f64) {
        (self.x[0], self.x[self.x.len() - 1])
    }
}

/// Slopes at the points, "not a knot" at the ends (de Boor, A Practical Guide to Splines, chapter IV).
fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let d: Vec<f64> = (0..last).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    let end = |h0: f64, h1: f64, d0: f64, d1: f64| {
        let span = h0 + h1;
        ((h1, span), ((h0 + 2.0 * span) * h1 * d0 + h0 * h0 * d1) / span)
    };
    let (begin, right) = end(h[0], h[1], d[0], d[1]);
    let mut rows = vec![(0.0, begin.0, begin.1, right)];
    rows.extend((1..last).map(|i| {
        let right = 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
        (h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1], right)
    }));
    let (finish, right) = end(h[last - 1], h[last - 2], d[last - 1], d[last - 2]);
    rows.push((finish.1, finish.0, 0.0, right));
    for i in 1..=last {
        let factor = rows[i].0 / rows[i - 1].1;
        rows[i].1 -= factor * rows[i - 1].2;
        rows[i].3 -= factor * rows[i - 1].3;
    }
    let mut slopes = vec![0.0; last + 1];
    slopes[last] = rows[last].3 / rows[last].1;
    for i in (0..last).rev() {
        slopes[i] = (rows[i].3 - rows[i].2 * slopes[i + 1]) / rows[i].1;
    }
    slopes
}

/// A curve that is looked up.
pub trait Lookup<S: Scalar> {
    /// The place in a piece and the factors there; NaN outside.
    fn at(&self, x: S) -> (S, [S; 4]);
    /// What a slope in the piece has to be multiplied with.
    fn slope(&self, slope: S) -> S;
}

/// A curve through points that are evenly apart. A piece is as long as 1 and counts from its middle.
pub struct Even {
    density: f64,
    shift: f64,
    /// Nothing behind the last one.
    pieces: Box<[[f64; 4]; PIECES]>,
}

impl Even {
    fn new() -> Self {
        let spline = Spline::read(include_str!("sheets/even.csv"));
        let (first, last) = spline.range();
        let count = spline.pieces.len();
        let step = (last - first) / count as f64;
        let powers = [1.0, step, step * step, step * step * step];
        let mut pieces = Box::new([[f64::NAN; 4]; PIECES]);
        for (target, piece) in pieces.iter_mut().zip(&spline.pieces) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| piece[k] * powers[k]);
            let middle = ((0.5 * d + c) * 0.5 + b) * 0.5 + a;
            *target = [middle, (0.75 * d + c) + b, 1.5 * d + c, d];
        }
        // The end itself is in the last piece.
        let density = (1.0 - 2.0 * f64::EPSILON) / step;
        Self { density, shift: -first * density - 0.5, pieces }
    }
}

impl<S: Scalar> Lookup<S> for Even {
    #[inline(always)]
    fn at(&self, x: S) -> (S, [S; 4]) {
        let place = x.mul_add(S::from_f64(self.density), S::from_f64(self.shift));
        let (index, whole) = rounded(place);
        let piece = self.pieces.get(index).unwrap_or(&[f64::NAN; 4]);
        (place - whole, numbers(*piece))
    }

    #[inline(always)]
    fn slope(&self, slope: S) -> S {
        slope * S::from_f64(self.density)
    }
}

/// A curve through other points.
pub struct Uneven {
    density: f64,
    shift: f64,
    /// Where pieces begin. The first one comes before the range, the last ones behind it; there is nothing in them.
    begins: Box<[f64; PIECES]>,
    pieces: Box<[[f64; 4]; PIECES]>,
    /// The piece at the begin of each bucket.
    starts: Box<[u16; BUCKETS]>,
}

impl Uneven {
    fn new() -> Self {
        let spline = Spline::read(include_str!("sheets/uneven.csv"));
        let (first, last) = spline.range();
        let density = (BUCKETS - 1) as f64 / (last - first);
        let shift = -first * density;
        let count = spline.pieces.len();
        let mut begins = Box::new([f64::INFINITY; PIECES]);
        begins[0] = f64::NEG_INFINITY;
        begins[1..=count].copy_from_slice(&spline.x[..count]);
        begins[count + 1] = last.next_up();
        let mut pieces = Box::new([[f64::NAN; 4]; PIECES]);
        pieces[1..=count].copy_from_slice(&spline.pieces);
        let buckets = begins[1..count + 2].iter().map(|x| rounded(x * density + shift).0);
        let buckets: Vec<usize> = buckets.collect();
        assert!(buckets.windows(2).all(|pair| pair[0] < pair[1]), "a bucket holds two points");
        let mut starts = Box::new([0; BUCKETS]);
        for (at, start) in starts.iter_mut().enumerate() {
            *start = buckets.partition_point(|bucket| *bucket < at) as u16;
        }
        Self { density, shift, begins, pieces, starts }
    }
}

/// The nearest whole number, as an index and as a number.
#[inline(always)]
fn rounded<S: Scalar>(place: S) -> (usize, S) {
    let sum = place + S::from_f64(ROUND);
    let index = sum.to_f64().to_bits().wrapping_sub(ROUND.to_bits());
    (index as usize, sum - S::from_f64(ROUND))
}

impl<S: Scalar> Lookup<S> for Uneven {
    #[inline(always)]
    fn at(&self, x: S) -> (S, [S; 4]) {
        let place = x.mul_add(S::from_f64(self.density), S::from_f64(self.shift));
        let start = usize::from(*self.starts.get(rounded(place).0).unwrap_or(&0)) % PIECES;
        let next = (start + 1) % PIECES;
        let piece = if self.begins[next] <= x.to_f64() { next } else { start };
        (x - S::from_f64(self.begins[piece]), numbers(self.pieces[piece]))
    }

    #[inline(always)]
    fn slope(&self, slope: S) -> S {
        slope
    }
}

/// What is wanted of a curve.
pub trait Wanted<const O: usize>: 'static {
    /// It from the place in a piece and its factors.
    fn of<S: Scalar>(curve: &impl Lookup<S>, place: S, factors: [S; 4]) -> [S; O];
}

/// The value.
pub struct Value;
/// The derivative.
pub struct Slope;
/// Both.
pub struct Both;

#[inline(always)]
fn value<S: Scalar>(t: S, [a, b, c, d]: [S; 4]) -> S {
    d.mul_add(t, c).mul_add(t, b).mul_add(t, a)
}

#[inline(always)]
fn slope<S: Scalar>(t: S, [_, b, c, d]: [S; 4]) -> S {
    let three = S::from_f64(3.0);
    (three * d).mul_add(t, c + c).mul_add(t, b)
}

impl Wanted<1> for Value {
    #[inline(always)]
    fn of<S: Scalar>(_: &impl Lookup<S>, t: S, factors: [S; 4]) -> [S; 1] {
        [value(t, factors)]
    }
}

impl Wanted<1> for Slope {
    #[inline(always)]
    fn of<S: Scalar>(curve: &impl Lookup<S>, t: S, factors: [S; 4]) -> [S; 1] {
        [curve.slope(slope(t, factors))]
    }
}

impl Wanted<2> for Both {
    #[inline(always)]
    fn of<S: Scalar>(curve: &impl Lookup<S>, t: S, factors: [S; 4]) -> [S; 2] {
        [value(t, factors), curve.slope(slope(t, factors))]
    }
}

#[inline(always)]
fn numbers<S: Scalar>([a, b, c, d]: [f64; 4]) -> [S; 4] {
    [S::from_f64(a), S::from_f64(b), S::from_f64(c), S::from_f64(d)]
}

/// A curve and what is wanted of it.
pub struct Read<C: 'static, W>(&'static C, PhantomData<W>);

impl<S: Scalar, C: Lookup<S>, W: Wanted<O>, const O: usize> Sheet<S, 1, O> for Read<C, W> {
    #[inline(always)]
    fn row(&self, [x]: [S; 1]) -> [S; O] {
        let (place, factors) = self.0.at(x);
        W::of(self.0, place, factors)
    }
}

impl<W: Wanted<O>, const O: usize> Code<1, O> for Read<Even, W> {
    type Sheet<S: Scalar> = Self;

    fn prepare<S: Scalar>() -> Self {
        static CURVE: LazyLock<Even> = LazyLock::new(Even::new);
        Self(&CURVE, PhantomData)
    }
}

impl<W: Wanted<O>, const O: usize> Code<1, O> for Read<Uneven, W> {
    type Sheet<S: Scalar> = Self;

    fn prepare<S: Scalar>() -> Self {
        static CURVE: LazyLock<Uneven> = LazyLock::new(Uneven::new);
        Self(&CURVE, PhantomData)
    }
}
