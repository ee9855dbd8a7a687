//! The six-bar of [`crate::linkage`] by hand: both dyads in closed form, and the influence coefficients of its output.
//!
//! Links `1..3` with the frame make the four-bar O1-A-B-O2; the dyad C-D-O3 hangs on its coupler. With `e(a)` the unit
//! vector of an angle and `e⊥` that vector turned by a right angle, the loops are
//!
//! ```text
//! F = L1 e(φ) + L2 e(θ) − L4 e(η) − L3 e(ρ) = 0
//! G = L1 e(φ) + X_C e(θ) + Y_C e⊥(θ) + L6 e(σ) − O3 − L7 e(Ψ) = 0
//! ```
//!
//! The inner product with `e(σ)` rids `G` of σ, and that with `e(ρ)` rids `F` of ρ. So for any dimension `x`, with the
//! partial derivatives at fixed angles on the right,
//!
//! ```text
//! ∂Ψ/∂x = w·∂G/∂x + v·∂F/∂x,    w = e(σ) / (L7 sin(σ − Ψ)),    v = −(w·∂G/∂θ) e(ρ) / (L2 sin(ρ − θ))
//! ```

use assur::scalar::Scalar;

/// Dimensions: `L1, L2, L3, L4, eta, X_C, Y_C, L6, L7, X_3, Y_3, phi0`.
pub const DIMENSIONS: usize = 12;

/// Where the functions come from that a position needs.
pub trait Functions<S> {
    /// Sine and cosine.
    fn sin_cos(angle: S) -> (S, S);
    /// Angles of the points `(x, y)`.
    fn angles(y: [S; 4], x: [S; 4]) -> [S; 4];
}

/// Those of Assur.
pub struct Assur;

impl<S: Scalar> Functions<S> for Assur {
    #[inline(always)]
    fn sin_cos(angle: S) -> (S, S) {
        angle.sin_cos()
    }
    #[inline(always)]
    fn angles(y: [S; 4], x: [S; 4]) -> [S; 4] {
        S::atan2_all(y, x)
    }
}

/// Those of the standard library.
pub struct Std;

impl Functions<f64> for Std {
    #[inline(always)]
    fn sin_cos(angle: f64) -> (f64, f64) {
        f64::sin_cos(angle)
    }
    #[inline(always)]
    fn angles(y: [f64; 4], x: [f64; 4]) -> [f64; 4] {
        [0, 1, 2, 3].map(|k| y[k].atan2(x[k]))
    }
}

/// Two links `a`, `b` between joints that are `V` apart: `a e(first) − b e(second) = V`.
#[derive(Clone, Copy)]
struct Dyad<S> {
    far: S,
    near: S,
    difference: S,
    mode: S,
    inverse: [S; 2],
}

impl<S: Scalar> Dyad<S> {
    #[inline(always)]
    fn new(a: S, b: S, mode: f64) -> Self {
        let (sum, difference) = (a + b, a - b);
        Self {
            far: sum * sum,
            near: difference * difference,
            difference: sum * difference,
            mode: S::from_f64(mode),
            inverse: [S::ONE / a, S::ONE / b],
        }
    }

    /// The unit vectors of both links.
    #[inline(always)]
    fn close(&self, [x, y]: [S; 2]) -> [[S; 2]; 2] {
        let square = x.mul_add(x, y * y);
        let area = (self.far - square) * (square - self.near);
        let scale = S::from_f64(0.5) / square;
        let across = self.mode * area.sqrt() * scale;
        let along = (square + self.difference) * scale;
        let a = [along.mul_add(x, -(across * y)), along.mul_add(y, across * x)];
        let [over_a, over_b] = self.inverse;
        [[a[0] * over_a, a[1] * over_a], [(a[0] - x) * over_b, (a[1] - y) * over_b]]
    }
}

/// The six-bar, what depends on its dimensions alone computed.
pub struct SixBar<S> {
    crank: S,
    coupler: S,
    base: S,
    rocker: S,
    point: [S; 2],
    phase: S,
    pivots: [[S; 2]; 2],
    frame: [S; 2],
    first: Dyad<S>,
    second: Dyad<S>,
}

/// Unit vectors, cosine first, of the crank and of the links θ, ρ, σ, Ψ.
#[derive(Clone, Copy)]
pub struct Pose<S> {
    crank: [S; 2],
    links: [[S; 2]; 4],
}

impl<S: Scalar> SixBar<S> {
    /// Prepares a six-bar; the modes are the signs of `sin(ρ − θ)` and `sin(Ψ − σ)`.
    #[inline(always)]
    pub fn new(dimensions: [S; DIMENSIONS], modes: [f64; 2]) -> Self {
        let [crank, l2, l3, l4, eta, x, y, l6, l7, x3, y3, phase] = dimensions;
        let (sine, cosine) = eta.sin_cos();
        Self {
            crank,
            coupler: l2,
            base: l4,
            rocker: l7,
            point: [x, y],
            phase,
            pivots: [[l4 * cosine, l4 * sine], [x3, y3]],
            frame: [cosine, sine],
            first: Dyad::new(l2, l3, modes[0]),
            second: Dyad::new(l6, l7, modes[1]),
        }
    }

    /// Closes both dyads at an angle of the shaft.
    #[inline(always)]
    pub fn pose<F: Functions<S>>(&self, phi: S) -> Pose<S> {
        let (sine, cosine) = F::sin_cos(phi + self.phase);
        self.closed([cosine, sine])
    }

    /// Closes both dyads, the crank along a unit vector.
    #[inline(always)]
    pub fn closed(&self, [cosine, sine]: [S; 2]) -> Pose<S> {
        let a = [self.crank * cosine, self.crank * sine];
        let [o2, o3] = self.pivots;
        let [theta, rho] = self.first.close([o2[0] - a[0], o2[1] - a[1]]);
        let arm = self.arm(theta);
        let c = [a[0] + arm[0], a[1] + arm[1]];
        let [sigma, psi] = self.second.close([o3[0] - c[0], o3[1] - c[1]]);
        Pose { crank: [cosine, sine], links: [theta, rho, sigma, psi] }
    }

    /// From A to C.
    #[inline(always)]
    fn arm(&self, [cosine, sine]: [S; 2]) -> [S; 2] {
        let [x, y] = self.point;
        [cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y)]
    }

    /// `∂Ψ/∂` each dimension, in their order, and behind them `∂Ψ/∂φ`.
    #[inline(always)]
    pub fn influence(&self, pose: &Pose<S>, values: &mut [S; DIMENSIONS + 1]) {
        let Pose { crank, links: [theta, rho, sigma, psi] } = *pose;
        let (l1, l2, l4, l7) = (self.crank, self.coupler, self.base, self.rocker);
        let k = S::ONE / (l7 * turned(sigma, psi));
        let w = [k * sigma[0], k * sigma[1]];
        let n = turned(w, self.arm(theta)) / (l2 * turned(rho, theta));
        let v = [-(n * rho[0]), -(n * rho[1])];
        let both = [w[0] + v[0], w[1] + v[1]];
        let turn = l1 * turned(both, crank);
        *values = [
            inner(both, crank),
            inner(v, theta),
            n,
            -inner(v, self.frame),
            -(l4 * turned(v, self.frame)),
            inner(w, theta),
            turned(w, theta),
            k,
            -inner(w, psi),
            -w[0],
            -w[1],
            turn,
            turn,
        ];
    }
}

/// The inner product of two vectors.
#[inline(always)]
pub fn inner<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0].mul_add(b[0], a[1] * b[1])
}

/// The inner product of `a` with `b` turned by a right angle.
#[inline(always)]
pub fn turned<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[1].mul_add(b[0], -(a[0] * b[1]))
}

impl<S: Scalar> Pose<S> {
    /// The unit vector of the output Ψ.
    #[inline(always)]
    pub fn output(&self) -> [S; 2] {
        self.links[3]
    }

    /// The angles θ, ρ, σ, Ψ.
    #[inline(always)]
    pub fn angles<F: Functions<S>>(&self) -> [S; 4] {
        let [[a, b], [c, d], [e, f], [g, h]] = self.links;
        F::angles([b, d, f, h], [a, c, e, g])
    }
}
