//! Six-bar: a four-bar and a dyad between a point of its coupler and the frame.

use super::{Dyad, constants, directions, unasked};
use crate::closure::{Closure, Group, GroupKind, Linkage, Range, Variable};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::{LinkageEntry, Shape, by_hand};
use std::f64::consts::TAU;

/// Constants `l1, l2, l3, a`, the coupler point `cx, cy`, `l5, l6`, its pivot `ox, oy`.
#[derive(Clone)]
pub struct SixBar {
    pub values: [f64; 10],
    pub start: [f64; 4],
}

impl Default for SixBar {
    fn default() -> Self {
        Self {
            values: [0.025, 0.09, 0.06, 0.1, 0.05, 0.03, 0.08, 0.07, 0.12, 0.09],
            start: [0.37, 1.84, f64::NAN, f64::NAN],
        }
    }
}

#[derive(Clone, Copy)]
pub struct Loops<S> {
    pub crank: S,
    pub frame: S,
    pub first: Dyad<S>,
    pub point: [S; 2],
    pub second: Dyad<S>,
    pub pivot: [S; 2],
}

impl<S: Scalar> Loops<S> {
    #[inline(always)]
    fn span(&self, group: usize, instant: &[S; 2], z: &[S; 12]) -> [S; 2] {
        let crank = [self.crank * instant[0], self.crank * instant[1]];
        if group == 0 {
            return [self.frame - crank[0], -crank[1]];
        }
        let (c, s, [x, y]) = (z[4], z[5], self.point);
        [self.pivot[0] - crank[0] - (c * x - s * y), self.pivot[1] - crank[1] - (s * x + c * y)]
    }
    fn dyad(&self, group: usize) -> Dyad<S> {
        if group == 0 { self.first } else { self.second }
    }
}

/// What it is made of; cosines and sines stand behind the angles.
const SHAPE: Shape = {
    let shape = by_hand(
        [10, 4],
        &[true; 4],
        &[
            Group { kind: GroupKind::Rrr, unknowns: &[0, 1], equations: &[0, 1] },
            Group { kind: GroupKind::Rrr, unknowns: &[2, 3], equations: &[2, 3] },
        ],
        &VARIABLES,
    );
    let cosines = &[Some(4), Some(6), Some(8), Some(10)];
    shape.linkage(LinkageEntry { cosines, ..*shape.loops() })
};

/// What its outputs are influenced by.
const VARIABLES: [Variable; 10] = {
    let mut all = [Variable::Constant(0); 10];
    let mut index = 1;
    while index < all.len() {
        all[index] = Variable::Constant(index);
        index += 1;
    }
    all
};

impl Linkage for SixBar {
    type Closure<S: Scalar> = Loops<S>;
    constants!();
    fn prepare<S: Scalar>(&self, v: &[S]) -> Loops<S> {
        Loops {
            crank: v[0],
            frame: v[3],
            first: Dyad { l2: v[1], l3: v[2] },
            point: [v[4], v[5]],
            second: Dyad { l2: v[6], l3: v[7] },
            pivot: [v[8], v[9]],
        }
    }
    fn span(&self) -> Span {
        Span::Open
    }

    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }

    fn ranges(&self) -> Vec<Range> {
        vec![Range { from: 0.0, to: TAU, start: TAU / 4.0, period: TAU }]
    }
    fn start(&self) -> Vec<f64> {
        self.start.to_vec()
    }
}

impl<S: Scalar> Closure<S> for Loops<S> {
    type Position = [S; 12];
    type Instant = [S; 2];
    type Row = [S; 2];
    type Matrix = [S; 4];
    #[inline(always)]
    fn shape(&self) -> &'static Shape {
        const { &SHAPE }
    }
    unasked!(S);

    #[inline(always)]
    fn zeros(&self) -> [S; 12] {
        [S::ZERO; 12]
    }
    #[inline(always)]
    fn instant(&self, independents: &[S]) -> [S; 2] {
        let (sine, cosine) = independents[0].sin_cos();
        [cosine, sine]
    }
    #[inline(always)]
    fn close(&self, group: usize, instant: &[S; 2], mode: S, z: &mut [S; 12]) -> S {
        let span = self.span(group, instant, z);
        match group {
            0 => {
                let (sine, [ca, sa, cb, sb]) = self.first.close(span, mode);
                [z[0], z[1]] = S::atan2_all([sa, sb], [ca, cb]);
                (z[4], z[5], z[6], z[7]) = (ca, sa, cb, sb);
                sine
            }
            _ => {
                let (sine, [ca, sa, cb, sb]) = self.second.close(span, mode);
                [z[2], z[3]] = S::atan2_all([sa, sb], [ca, cb]);
                (z[8], z[9], z[10], z[11]) = (ca, sa, cb, sb);
                sine
            }
        }
    }
    #[inline(always)]
    fn close_all(
        &self,
        instant: &[S; 2],
        modes: &[S],
        z: &mut [S; 12],
        sines: &mut [S],
        angles: bool,
    ) {
        for (group, dyad) in [self.first, self.second].into_iter().enumerate() {
            let (sine, all) = dyad.close(self.span(group, instant, z), modes[group]);
            sines[group] = sine;
            [z[4 + 4 * group], z[5 + 4 * group], z[6 + 4 * group], z[7 + 4 * group]] = all;
        }
        if angles {
            [z[0], z[1], z[2], z[3]] =
                S::atan2_all([z[5], z[7], z[9], z[11]], [z[4], z[6], z[8], z[10]]);
        }
    }
    fn margin(&self, group: usize, instant: &[S; 2], z: &[S; 12]) -> S {
        self.dyad(group).margin(self.span(group, instant, z))
    }
    fn trial(
        &self,
        group: usize,
        instant: &[S; 2],
        z: &mut [S; 12],
        residual: &mut [S; 2],
        jacobian: &mut [S; 4],
    ) {
        let all = directions(z[2 * group], z[2 * group + 1]);
        z[4 + 4 * group..8 + 4 * group].copy_from_slice(&all);
        (*residual, *jacobian) = self.dyad(group).trial(all, self.span(group, instant, z));
    }
    fn residual(&self, instant: &[S; 2], z: &[S; 12], residual: &mut [S]) {
        for group in 0..2 {
            let all = std::array::from_fn(|k| z[4 + 4 * group + k]);
            let (rows, _) = self.dyad(group).trial(all, self.span(group, instant, z));
            residual[2 * group..2 * group + 2].copy_from_slice(&rows);
        }
    }
    fn coefficients(&self, instant: &[S; 2], z: &[S; 12], columns: &mut [[S; 12]]) {
        let crank = [-self.crank * instant[1], self.crank * instant[0]];
        let first = self.first.rates([z[4], z[5], z[6], z[7]], [-crank[0], -crank[1]]);
        let [x, y] = [
            z[4] * self.point[0] - z[5] * self.point[1],
            z[5] * self.point[0] + z[4] * self.point[1],
        ];
        let rate = [-crank[0] + y * first[0], -crank[1] - x * first[0]];
        let second = self.second.rates([z[8], z[9], z[10], z[11]], rate);
        columns[0][..4].copy_from_slice(&[first[0], first[1], second[0], second[1]]);
    }
    fn outputs(&self, _: &[S; 2], z: &[S; 12], values: &mut [S]) {
        values.copy_from_slice(&z[..4]);
    }
}
