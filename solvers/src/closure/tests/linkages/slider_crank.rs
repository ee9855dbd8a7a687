//! Slider-crank: `l1 dir(β) + l2 dir(φ) = [s, e]`.

use super::{constants, unasked};
use crate::closure::{Closure, Group, GroupKind, Linkage, Range};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::{Shape, by_hand};
use std::f64::consts::TAU;

/// Constants `l1, l2, e`; unknowns `φ, s`.
#[derive(Clone)]
pub struct SliderCrank {
    pub values: [f64; 3],
    pub start: [f64; 2],
}

impl Default for SliderCrank {
    fn default() -> Self {
        Self { values: [0.075, 0.271, 0.0], start: [0.0, 0.3] }
    }
}

pub struct Loops<S>([S; 3]);

/// What it is made of.
const SHAPE: Shape = by_hand(
    [3, 1],
    &[true, false],
    &[Group { kind: GroupKind::Rrp, unknowns: &[0, 1], equations: &[0, 1] }],
    &[],
);

impl Linkage for SliderCrank {
    type Closure<S: Scalar> = Loops<S>;
    constants!();
    fn prepare<S: Scalar>(&self, v: &[S]) -> Loops<S> {
        Loops([v[0], v[1], v[2]])
    }
    fn span(&self) -> Span {
        Span::Open
    }

    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }

    fn ranges(&self) -> Vec<Range> {
        vec![Range { from: 0.0, to: TAU, start: 0.5, period: TAU }]
    }
    fn start(&self) -> Vec<f64> {
        self.start.to_vec()
    }
}

impl<S: Scalar> Closure<S> for Loops<S> {
    /// `φ, s, cos φ, sin φ`
    type Position = [S; 4];
    type Instant = [S; 2];
    type Row = [S; 2];
    type Matrix = [S; 4];
    #[inline(always)]
    fn shape(&self) -> &'static Shape {
        const { &SHAPE }
    }
    unasked!(S);

    #[inline(always)]
    fn zeros(&self) -> [S; 4] {
        [S::ZERO; 4]
    }
    fn instant(&self, independents: &[S]) -> [S; 2] {
        let (sine, cosine) = independents[0].sin_cos();
        [cosine, sine]
    }
    fn close(&self, _: usize, instant: &[S; 2], mode: S, z: &mut [S; 4]) -> S {
        let [l1, l2, e] = self.0;
        // The Jacobian is [-l2 sin φ, -1; l2 cos φ, 0], so that the sine is cos φ.
        let height = e - l1 * instant[1];
        let width = mode * ((l2 - height) * (l2 + height)).sqrt();
        let (cosine, sine) = (width / l2, height / l2);
        *z = [S::atan2(height, width), l1 * instant[0] + width, cosine, sine];
        cosine
    }
    fn margin(&self, _: usize, instant: &[S; 2], _: &[S; 4]) -> S {
        let [l1, l2, e] = self.0;
        l2 - (e - l1 * instant[1]).abs()
    }
    fn trial(
        &self,
        _: usize,
        instant: &[S; 2],
        z: &mut [S; 4],
        residual: &mut [S; 2],
        jacobian: &mut [S; 4],
    ) {
        let [l1, l2, e] = self.0;
        let (sine, cosine) = z[0].sin_cos();
        (z[2], z[3]) = (cosine, sine);
        *residual = [l1 * instant[0] + l2 * cosine - z[1], l1 * instant[1] + l2 * sine - e];
        *jacobian = [-l2 * sine, -S::ONE, l2 * cosine, S::ZERO];
    }
    fn residual(&self, instant: &[S; 2], z: &[S; 4], residual: &mut [S]) {
        let [l1, l2, e] = self.0;
        residual[0] = l1 * instant[0] + l2 * z[2] - z[1];
        residual[1] = l1 * instant[1] + l2 * z[3] - e;
    }
    fn coefficients(&self, instant: &[S; 2], z: &[S; 4], columns: &mut [[S; 4]]) {
        let [l1, l2, _] = self.0;
        let turn = -l1 * instant[0] / (l2 * z[2]);
        columns[0][0] = turn;
        columns[0][1] = -l1 * instant[1] - l2 * z[3] * turn;
    }
    fn outputs(&self, _: &[S; 2], z: &[S; 4], values: &mut [S]) {
        values[0] = z[1];
    }
}
