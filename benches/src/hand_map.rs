//! The map of burnishing of [`crate::sheets`] by hand: roughness over the feed, temperature over the speed.
//!
//! All but feed `S` and speed `v` is constant, the integral at the cusp included. Both heats are proportional to `v`, and
//! `K1 = k/√v`; the rest is the solution of a system of two.

use assur::scalar::Scalar;
use assur_equations::burnishing::Map;

use crate::sheets::{Code, Sheet};

/// `∫exp(−3 s⁴) ds` over 0..1.
const MEAN: f64 = 0.685_265_858_667_065_6;

/// Numbers of the map that its points share, named as in `burnishing.eqn`.
pub struct Constants {
    /// What is left of the roughness without feed marks, and `1/(8 r)`.
    rest: f64,
    bend: f64,
    /// `K1*√v`, and the factors of the system.
    k: f64,
    k_f: f64,
    g: f64,
    root_beta: f64,
    t: [[f64; 2]; 2],
    /// Heats over the speed.
    q01: f64,
    q02: f64,
    /// `P_th*√v/q01`, and the integral at the cusp, `2∫exp(−3 s⁴) ds` over 0..1.
    scale: f64,
    cusp: f64,
}

impl Constants {
    fn new(m: &Map) -> Self {
        use std::f64::consts::PI;
        let h_u = (m.c * PI * m.s_T * m.P).sqrt() / (2.0 * m.E);
        let load = m.P * (1.0 + m.f * m.f).sqrt();
        let q = load / (m.c * PI * m.r * m.s_T);
        let area = PI * m.r * (q + 2.0 * h_u);
        let smoothed = m.R_p * (m.kappa * load / (m.H_mu * m.t_m * area)).sqrt();
        let l1 = m.phi1 * m.r;
        let l2 = 0.5 * l1;
        let beta: f64 = 0.5;
        let b = (l1 + l2) * ((m.R + m.r) / m.R).sqrt();
        let force = m.k_T * m.P - 0.25 * m.mu * b * l2 * m.s_v;
        let w = |a: f64| {
            let cubes = (a.powi(3) + b.powi(3) - (a * a + b * b).powf(1.5)) / 3.0;
            2.0 * (a * a * b * (b / a).asinh() + a * b * b * (a / b).asinh() + cubes)
        };
        let across = 0.5 * (w(l1 + l2) - w(l1) - w(l2));
        let spread = 2.0 * PI * m.lambda2 * b;
        Self {
            rest: m.R_zi + m.R_z0 - smoothed,
            bend: 1.0 / (8.0 * m.r),
            k: 4.0 * m.K_b * (m.omega1 * l1 / PI).sqrt() / (3.0 * m.lambda1),
            k_f: m.K_f,
            g: ((1.0 + beta).powf(1.5) - 1.0 - beta.powf(1.5)) / beta,
            root_beta: beta.sqrt(),
            t: [
                [w(l1) / (spread * l1), across / (spread * l1)],
                [across / (spread * l2), w(l2) / (spread * l2)],
            ],
            q01: force / (b * l1 * m.psi1),
            q02: 3.0 / (8.0 * PI) * m.mu * m.s_v / m.psi2,
            scale: m.K_b * l1 * (m.omega1 / (PI * l1)).sqrt() / m.lambda1,
            cusp: 2.0 * MEAN,
        }
    }
}

/// By the formulas as they stand, square root and `K1` taken once.
pub struct Stated;

/// The same map with its constants as numbers of a type.
pub struct StatedMap<S> {
    quarter_rest: S,
    quarter_bend: S,
    k: S,
    k_f: S,
    g: S,
    root_beta: S,
    t: [[S; 2]; 2],
    q01: S,
    q02: S,
    scale: S,
    cusp: S,
}

impl Code<2, 4> for Stated {
    type Sheet<S: Scalar> = StatedMap<S>;

    fn prepare<S: Scalar>() -> StatedMap<S> {
        let all = std::hint::black_box(Constants::new(&Map::default()));
        let number = S::from_f64;
        StatedMap {
            quarter_rest: number(0.25 * all.rest),
            quarter_bend: number(0.25 * all.bend),
            k: number(all.k),
            k_f: number(all.k_f),
            g: number(all.g),
            root_beta: number(all.root_beta),
            t: all.t.map(|row| row.map(number)),
            q01: number(all.q01),
            q02: number(all.q02),
            scale: number(all.scale),
            cusp: number(all.cusp),
        }
    }
}

impl<S: Scalar> Sheet<S, 2, 4> for StatedMap<S> {
    #[inline(always)]
    fn row(&self, [feed, speed]: [S; 2]) -> [S; 4] {
        let [[t11, t12], [t21, t22]] = self.t;
        let over_root = S::ONE / speed.sqrt();
        let k1 = self.k * over_root;
        let (q01, q02) = (self.q01 * speed, self.q02 * speed);
        let kept = k1 * self.k_f;
        let h1 = kept * q01;
        let h2 = kept * self.g.mul_add(q01, self.root_beta * q02);
        let (m11, m21, m22) = (k1 + t11, k1.mul_add(self.g, t21), k1.mul_add(self.root_beta, t22));
        let determinant = m11.mul_add(m22, -(t12 * m21));
        let eta = h1.mul_add(m22, -(t12 * h2)) / (determinant * q01);
        let theta = self.scale * q01 * over_root * (self.cusp - (eta + eta));
        let roughness = (feed * feed).mul_add(self.quarter_bend, self.quarter_rest);
        checked(eta, [roughness, theta, feed * speed])
    }
}

/// Reduced on paper: the speed falls out of `q1/q01`, which is `(a + b √v)/(c + d √v + e v)`.
pub struct Reduced;

/// The reduced map.
pub struct ReducedMap<S> {
    quarter_rest: S,
    quarter_bend: S,
    above: [S; 2],
    below: [S; 3],
    /// Factors of `√v` and of `√v q1/q01` in `Θ`.
    cusp: S,
    scale: S,
}

impl Code<2, 4> for Reduced {
    type Sheet<S: Scalar> = ReducedMap<S>;

    fn prepare<S: Scalar>() -> ReducedMap<S> {
        let all = std::hint::black_box(Constants::new(&Map::default()));
        let [[t11, t12], [t21, t22]] = all.t;
        let (k, rb) = (all.k, all.root_beta);
        let scale = all.scale * all.q01;
        let h2 = all.g + rb * all.q02 / all.q01;
        let above = [k * rb, t22 - t12 * h2].map(|one| k * all.k_f * one);
        let below = [k * k * rb, k * t22 + t11 * k * rb - t12 * k * all.g, t11 * t22 - t12 * t21];
        ReducedMap {
            quarter_rest: S::from_f64(0.25 * all.rest),
            quarter_bend: S::from_f64(0.25 * all.bend),
            above: above.map(S::from_f64),
            below: below.map(S::from_f64),
            cusp: S::from_f64(scale * all.cusp),
            scale: S::from_f64(-2.0 * scale),
        }
    }
}

impl<S: Scalar> Sheet<S, 2, 4> for ReducedMap<S> {
    #[inline(always)]
    fn row(&self, [feed, speed]: [S; 2]) -> [S; 4] {
        let ([a, b], [c, d, e]) = (self.above, self.below);
        let root = speed.sqrt();
        let eta = root.mul_add(b, a) / root.mul_add(d, speed.mul_add(e, c));
        let theta = root * eta.mul_add(self.scale, self.cusp);
        let roughness = (feed * feed).mul_add(self.quarter_bend, self.quarter_rest);
        checked(eta, [roughness, theta, feed * speed])
    }
}

/// The outputs, which do not exist where the diamond takes more heat than the surface has, and how far that is away.
#[inline(always)]
fn checked<S: Scalar>(eta: S, [roughness, theta, rate]: [S; 3]) -> [S; 4] {
    let most = S::from_f64(MEAN);
    let exists = S::less(eta, most);
    let nothing = S::from_f64(f64::NAN);
    [
        S::select(exists, roughness, nothing),
        S::select(exists, theta, nothing),
        S::select(exists, rate, nothing),
        most - eta,
    ]
}
