//! Heald linkage as printed, see the specification; its influence coefficients by the adjoint of the loops.

use crate::closure::{Closure, Group, GroupKind, Linkage, Range, Variable};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::{Shape, by_hand};
use crate::tolerance::made::small;
use std::f64::consts::TAU;

/// Constants `l4, l5, l6, l7, a, b, s`; unknowns `φ5, φ6, φ7`; output `φ7`.
#[derive(Clone)]
pub struct Heald {
    pub values: [f64; 7],
}

impl Default for Heald {
    fn default() -> Self {
        Self { values: [0.09, 0.23, 0.18, 0.12, 0.08, 0.105, 0.04] }
    }
}

pub struct Loops<S>([S; 7]);

/// What it is made of.
const SHAPE: Shape = by_hand(
    [7, 1],
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
    #[inline(always)]
    fn shape() -> &'static Shape {
        const { &SHAPE }
    }

    fn values(&self) -> Vec<f64> {
        self.values.to_vec()
    }
    fn with_values(values: &[f64]) -> Self {
        let mut linkage = Self::default();
        linkage.values.copy_from_slice(values);
        linkage
    }
    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }
    #[inline(always)]
    fn prepare<S: Scalar>(v: &[S]) -> Loops<S> {
        Loops([v[0], v[1], v[2], v[3], v[4], v[5], v[6]])
    }
    fn span(&self) -> Span {
        Span::Open
    }
    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }
    fn ranges(&self) -> Vec<Range> {
        vec![Range {
            from: 60f64.to_radians(),
            to: 120f64.to_radians(),
            start: 90f64.to_radians(),
            period: TAU,
        }]
    }
    fn start(&self) -> Vec<f64> {
        [10f64, 63.0, -70.0].map(f64::to_radians).to_vec()
    }
}

impl<S: Scalar> Loops<S> {
    #[inline(always)]
    fn rows(&self, instant: &[S; 2], z: &[S; 9]) -> [S; 3] {
        let [l4, l5, l6, l7, a, b, s] = self.0;
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        [
            l4 * instant[0] + l5 * c5 - l6 * c6 - l7 * c7 - b,
            l4 * instant[1] + l5 * s5 - l6 * s6 - l7 * s7 - a,
            l6 * c6 - s - l7 * c7,
        ]
    }
    #[inline(always)]
    fn matrix(&self, z: &[S; 9]) -> [S; 9] {
        let [_, l5, l6, l7, ..] = self.0;
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        [-l5 * s5, l6 * s6, l7 * s7, l5 * c5, -l6 * c6, -l7 * c7, S::ZERO, -l6 * s6, l7 * s7]
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
    #[inline(always)]
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
    #[inline(always)]
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
    #[inline(always)]
    fn outputs(&self, _: &[S; 2], z: &[S; 9], values: &mut [S]) {
        values[0] = z[2];
    }
    fn influence(&self, instant: &[S; 2], z: &[S; 9], values: &mut [S]) {
        let m = self.matrix(z);
        let mut transposed = [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
        let mut adjoint = [S::ZERO, S::ZERO, -S::ONE];
        small::solve(3, &mut transposed, &mut adjoint);
        let [_, _, _, c5, s5, c6, s6, c7, s7] = *z;
        let (l4, zero, one) = (self.0[0], S::ZERO, S::ONE);
        let columns = [
            [instant[0], instant[1], zero],
            [c5, s5, zero],
            [-c6, -s6, c6],
            [-c7, -s7, -c7],
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
