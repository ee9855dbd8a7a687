//! Heald linkage: three coupled equations, see the specification.
//!
//! ```text
//! l4 dir(φ4) + l5 dir(φ5) = l6 dir(φ6) + κ l7 dir(φ7) + [b, a]
//! l6 cos φ6 = s + l7 cos φ7
//! ```

use super::constants;
use crate::closure::{Closure, Group, GroupKind, Linkage, Range, Variable};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::{Shape, by_hand};
use crate::tolerance::made::small;
use std::f64::consts::TAU;

/// Constants `l4, l5, l6, l7, a, b, s, κ`; unknowns `φ5, φ6, φ7`; output `φ7`.
#[derive(Clone)]
pub struct Heald {
    pub values: [f64; 8],
    pub start: [f64; 3],
}

impl Heald {
    pub fn new(kappa: f64, degrees: [f64; 3]) -> Self {
        Self {
            values: [0.09, 0.23, 0.18, 0.12, 0.08, 0.105, 0.04, kappa],
            start: degrees.map(f64::to_radians),
        }
    }
    /// As printed.
    pub fn printed() -> Self {
        Self::new(1.0, [10.0, 63.0, -70.0])
    }
    /// With a straight guide.
    pub fn guided() -> Self {
        Self::new(-1.0, [51.0, 41.0, -36.0])
    }
}

impl Default for Heald {
    fn default() -> Self {
        Self::printed()
    }
}

pub struct Loops<S>([S; 8]);

/// What it is made of.
const SHAPE: Shape = by_hand(
    [8, 1],
    &[true; 3],
    &[Group { kind: GroupKind::General, unknowns: &[0, 1, 2], equations: &[0, 1, 2] }],
    &[
        Variable::Constant(0),
        Variable::Constant(1),
        Variable::Constant(2),
        Variable::Constant(3),
        Variable::Constant(4),
        Variable::Constant(5),
        Variable::Constant(6),
        Variable::Driver(0),
    ],
);

impl Linkage for Heald {
    type Closure<S: Scalar> = Loops<S>;
    constants!();
    fn prepare<S: Scalar>(&self, v: &[S]) -> Loops<S> {
        Loops(std::array::from_fn(|k| v[k]))
    }
    fn span(&self) -> Span {
        Span::Open
    }

    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }

    fn ranges(&self) -> Vec<Range> {
        let degrees = |value: f64| value.to_radians();
        vec![Range { from: degrees(60.0), to: degrees(120.0), start: degrees(90.0), period: TAU }]
    }
    fn start(&self) -> Vec<f64> {
        self.start.to_vec()
    }
}

impl<S: Scalar> Loops<S> {
    fn rows(&self, instant: &[S; 2], z: &[S; 9]) -> [S; 3] {
        let [l4, l5, l6, l7, a, b, s, kappa] = self.0;
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        [
            l4 * instant[0] + l5 * c5 - l6 * c6 - kappa * l7 * c7 - b,
            l4 * instant[1] + l5 * s5 - l6 * s6 - kappa * l7 * s7 - a,
            l6 * c6 - s - l7 * c7,
        ]
    }
    fn matrix(&self, z: &[S; 9]) -> [S; 9] {
        let [_, l5, l6, l7, _, _, _, kappa] = self.0;
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        let zero = S::ZERO;
        [
            -l5 * s5,
            l6 * s6,
            kappa * l7 * s7,
            l5 * c5,
            -l6 * c6,
            -kappa * l7 * c7,
            zero,
            -l6 * s6,
            l7 * s7,
        ]
    }
}

impl<S: Scalar> Closure<S> for Loops<S> {
    type Position = [S; 9];
    type Instant = [S; 2];
    type Row = [S; 3];
    type Matrix = [S; 9];
    #[inline(always)]
    fn shape(&self) -> &'static Shape {
        const { &SHAPE }
    }

    #[inline(always)]
    fn zeros(&self) -> [S; 9] {
        [S::ZERO; 9]
    }
    fn instant(&self, independents: &[S]) -> [S; 2] {
        let (sine, cosine) = independents[0].sin_cos();
        [cosine, sine]
    }
    fn close(&self, _: usize, _: &[S; 2], _: S, _: &mut [S; 9]) -> S {
        S::from_f64(f64::NAN)
    }
    fn margin(&self, _: usize, _: &[S; 2], _: &[S; 9]) -> S {
        S::from_f64(f64::NAN)
    }
    fn trial(
        &self,
        _: usize,
        instant: &[S; 2],
        z: &mut [S; 9],
        residual: &mut [S; 3],
        jacobian: &mut [S; 9],
    ) {
        let (sines, cosines) = S::sin_cos_all([z[0], z[1], z[2]]);
        for k in 0..3 {
            (z[3 + 2 * k], z[4 + 2 * k]) = (cosines[k], sines[k]);
        }
        *residual = self.rows(instant, z);
        *jacobian = self.matrix(z);
    }
    fn residual(&self, instant: &[S; 2], z: &[S; 9], residual: &mut [S]) {
        residual.copy_from_slice(&self.rows(instant, z));
    }
    fn coefficients(&self, instant: &[S; 2], z: &[S; 9], columns: &mut [[S; 9]]) {
        let mut right = [self.0[0] * instant[1], -self.0[0] * instant[0], S::ZERO];
        small::solve(3, &mut self.matrix(z), &mut right);
        columns[0][..3].copy_from_slice(&right);
    }
    fn outputs(&self, _: &[S; 2], z: &[S; 9], values: &mut [S]) {
        values[0] = z[2];
    }
    /// By the adjoint of the loops.
    fn influence(&self, instant: &[S; 2], z: &[S; 9], values: &mut [S]) {
        let m = self.matrix(z);
        let mut transposed = [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
        let mut adjoint = [S::ZERO, S::ZERO, -S::ONE];
        small::solve(3, &mut transposed, &mut adjoint);
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        let (l4, kappa, zero, one) = (self.0[0], self.0[7], S::ZERO, S::ONE);
        let columns = [
            [instant[0], instant[1], zero],
            [c5, s5, zero],
            [-c6, -s6, c6],
            [-kappa * c7, -kappa * s7, -c7],
            [zero, -one, zero],
            [-one, zero, zero],
            [zero, zero, -one],
            [-l4 * instant[1], l4 * instant[0], zero],
        ];
        for (value, column) in values.iter_mut().zip(columns) {
            let [x, y, g] = adjoint;
            *value = x * column[0] + y * column[1] + g * column[2];
        }
    }
    fn second_influence(&self, _: &[S; 2], _: &[S; 9], _: &mut [S]) {}
    fn points(&self, _: &[S; 2], _: &[S; 9], _: &mut [S]) {}
}
