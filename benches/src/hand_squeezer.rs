//! Andrews' squeezing mechanism by hand, reduced to the angle of its crank: three loops of two links in closed form, their
//! first and second kinematic coefficients, the reduced inertia `M(q)` and `M'(q)/2`. On fused numbers.
//!
//! With `r' = dr/dq`: `M = Σ m r'² + I φ'²`, and `M q'' = Q - M'/2 q'²`.

use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;

use crate::hand_freedom::{Run, follow};

/// Start of the crank.
pub const START: [f64; 2] = [-0.0617138900142764, 0.0];

/// A vector with its first and second derivative by the angle of the crank.
#[derive(Clone, Copy)]
pub struct Moving<S>(pub [S; 2], pub [S; 2], pub [S; 2]);

/// An angle's first and second derivative.
#[derive(Clone, Copy)]
pub struct Turn<S>(pub S, pub S);

/// A quarter turn.
#[inline(always)]
pub fn across<S: Scalar>([x, y]: [S; 2]) -> [S; 2] {
    [-y, x]
}

#[inline(always)]
pub fn cross<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    Scalar::mul_add(a[0], b[1], -(a[1] * b[0]))
}

#[inline(always)]
pub fn inner<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    Scalar::mul_add(a[0], b[0], a[1] * b[1])
}

/// `a + k b`
#[inline(always)]
pub fn plus<S: Scalar>(a: [S; 2], k: S, b: [S; 2]) -> [S; 2] {
    [Scalar::mul_add(k, b[0], a[0]), Scalar::mul_add(k, b[1], a[1])]
}

/// Two links from a point to another: the vectors, and the turns of both.
pub struct Dyad<S> {
    pub first: [S; 2],
    pub second: [S; 2],
    pub turns: [Turn<S>; 2],
}

/// Closes two links of lengths `a` and `b` over a moving distance.
#[inline(always)]
pub fn dyad<S: Scalar>(a: f64, b: f64, sign: f64, over: &Moving<S>) -> Dyad<S> {
    let number = S::from_f64;
    let Moving(v, dv, ddv) = *over;
    let square = inner(v, v);
    let inverse = S::ONE / square;
    let outer = number((a + b) * (a + b)) - square;
    let inside = square - number((a - b) * (a - b));
    let height = S::sqrt(outer * inside) * number(0.5 * sign);
    let along = Scalar::mul_add(number(0.5 * (a * a - b * b)), inverse, number(0.5));
    let first = plus([along * v[0], along * v[1]], height * inverse, across(v));
    let second = [v[0] - first[0], v[1] - first[1]];
    // The determinant of the links turned by a quarter is that of the links.
    let determinant = S::ONE / cross(first, second);
    let (one, other) = (across(first), across(second));
    let solve =
        |right: [S; 2]| [cross(right, other) * determinant, cross(one, right) * determinant];
    let [p, q] = solve(dv);
    let [pp, qq] = solve(plus(plus(ddv, p * p, first), q * q, second));
    Dyad { first, second, turns: [Turn(p, pp), Turn(q, qq)] }
}

/// Adds the inertia of a moving point to `M` and `M'/2`.
#[inline(always)]
pub fn point<S: Scalar>((m, g): (&mut S, &mut S), mass: f64, d: [S; 2], dd: [S; 2]) {
    let mass = S::from_f64(mass);
    *m = Scalar::mul_add(mass, inner(d, d), *m);
    *g = Scalar::mul_add(mass, inner(d, dd), *g);
}

/// Adds that of a turning body.
#[inline(always)]
pub fn turning<S: Scalar>((m, g): (&mut S, &mut S), inertia: f64, Turn(d, dd): Turn<S>) {
    let inertia = S::from_f64(inertia);
    *m = Scalar::mul_add(inertia, d * d, *m);
    *g = Scalar::mul_add(inertia, d * dd, *g);
}

/// A point on two links: `first` whole and `part` of the second. Its first and second derivative.
#[inline(always)]
fn on<S: Scalar>(first: ([S; 2], Turn<S>), second: ([S; 2], Turn<S>), part: f64) -> [[S; 2]; 2] {
    let part = S::from_f64(part);
    let ((a, Turn(p, pp)), (b, Turn(q, qq))) = (first, second);
    let (along, beside) = (across(a), across(b));
    let d = plus([p * along[0], p * along[1]], part * q, beside);
    let bent = plus([pp * along[0], pp * along[1]], -(p * p), a);
    let dd = plus(plus(bent, part * qq, beside), -(part * (q * q)), b);
    [d, dd]
}

const A: [f64; 2] = [-0.06934, -0.00227];
const B: [f64; 2] = [-0.03635, 0.03273];
const C: [f64; 2] = [0.014, 0.072];

/// Acceleration of the crank.
#[inline(always)]
pub fn acceleration<S: Scalar>(angle: S, speed: S) -> S {
    let number = S::from_f64;
    let [(sine, cosine)] = {
        let ([s], [c]) = S::sin_cos_all([angle]);
        [(s, c)]
    };
    let rr = number(0.007);
    let f = [rr * cosine, rr * sine];
    let df = across(f);
    let ddf = [-f[0], -f[1]];
    // F - B = d u + ss w
    let over = Moving([f[0] - number(B[0]), f[1] - number(B[1])], df, ddf);
    let third = dyad(0.028, 0.035, 1.0, &over);
    let [rod, rocker] = third.turns;
    let e = [number(B[0]) + third.second[0], number(B[1]) + third.second[1]];
    let beside = across(third.second);
    let de = [rocker.0 * beside[0], rocker.0 * beside[1]];
    let dde =
        plus([rocker.1 * beside[0], rocker.1 * beside[1]], -(rocker.0 * rocker.0), third.second);
    let over = Moving([e[0] - number(A[0]), e[1] - number(A[1])], de, dde);
    let right = dyad(0.04, 0.02, 1.0, &over);
    let left = dyad(0.04, 0.02, -1.0, &over);

    let (mut m, mut g) = (number(0.04325 * 0.00092 * 0.00092 + 2.194e-6), S::ZERO);
    let both = (&mut m, &mut g);
    let (m, g) = both;
    // F - da u, where d u is the first link.
    let part = number(0.0115 / 0.028);
    let u = third.first;
    let beside = across(u);
    let d = plus(df, -(part * rod.0), beside);
    let dd = plus(plus(ddf, -(part * rod.1), beside), part * (rod.0 * rod.0), u);
    point((m, g), 0.00365, d, dd);
    turning((m, g), 4.410e-7, rod);
    turning((m, g), 0.02373 * (0.01874 * 0.01874 + 0.01043 * 0.01043) + 5.255e-6, rocker);
    let [d, dd] =
        on((right.first, right.turns[0]), (right.second, right.turns[1]), (0.02 - 0.01421) / 0.02);
    point((m, g), 0.00706, d, dd);
    turning((m, g), 5.667e-7, right.turns[1]);
    turning((m, g), 0.07050 * (0.02308 * 0.02308 + 0.00916 * 0.00916) + 1.169e-5, right.turns[0]);
    let [d, dd] =
        on((left.first, left.turns[0]), (left.second, left.turns[1]), (0.02 - 0.01421) / 0.02);
    point((m, g), 0.00706, d, dd);
    turning((m, g), 5.667e-7, left.turns[1]);
    turning((m, g), 0.05498 * (0.01228 * 0.01228 + 0.00449 * 0.00449) + 1.912e-5, left.turns[0]);

    let inverse = number(1.0 / 0.035);
    let w = [third.second[0] * inverse, third.second[1] * inverse];
    let x = across(w);
    let reach = plus([number(0.02) * x[0], number(0.02) * x[1]], number(0.018), w);
    let spring = [number(B[0] - C[0]) + reach[0], number(B[1] - C[1]) + reach[1]];
    let length = S::sqrt(inner(spring, spring));
    let pull = number(4530.0) * (length - number(0.07785)) / length;
    let force = pull * inner(spring, across(reach)) * rocker.0;
    (number(0.033) - force - *g * (speed * speed)) / *m
}

/// Integrates to `end` by DOP853; absolute tolerances `rtol·scale`.
#[inline(never)]
pub fn run(end: f64, rtol: f64, scale: f64) -> Run {
    dispatch(Squeeze { end, rtol, scale })
}

struct Squeeze {
    end: f64,
    rtol: f64,
    scale: f64,
}

impl Task for Squeeze {
    type Output = Run;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Run {
        let Self { end, rtol, scale } = self;
        follow(
            #[inline(always)]
            |angle, speed| acceleration::<S>(angle, speed),
            START,
            (end, 1e-4),
            (rtol, scale),
        )
    }
}
