//! Four-bar: crank, rod and rocker in the plane. `l1 dir(β) + l2 dir(γ) = [a, 0] + l3 dir(θ)`.

use super::{Directions, Dyad, constants, directions, unasked};
use crate::closure::{Closure, Group, GroupKind, Linkage, Range, Variable};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::{Kind, List, Moment, Primitive, Quantity, Shape, Unit, by_hand};
use std::f64::consts::TAU;

/// Constants `l1, l2, l3, a`; unknowns `γ, θ`; outputs both.
#[derive(Clone)]
pub struct FourBar {
    pub values: [f64; 4],
    pub start: [f64; 2],
    pub range: Range,
}

impl FourBar {
    pub fn new(values: [f64; 4], start_at: f64, start: [f64; 2]) -> Self {
        Self { values, start, range: Range { from: 0.0, to: TAU, start: start_at, period: TAU } }
    }
}

impl Default for FourBar {
    fn default() -> Self {
        Self::new([0.025, 0.09, 0.06, 0.1], TAU / 4.0, [0.4, 1.8])
    }
}

pub struct Loops<S, const ITERATED: bool> {
    crank: S,
    frame: S,
    dyad: Dyad<S>,
}

impl<S: Scalar, const ITERATED: bool> Loops<S, ITERATED> {
    #[inline(always)]
    fn span(&self, instant: &[S; 2]) -> [S; 2] {
        [self.frame - self.crank * instant[0], -self.crank * instant[1]]
    }
}

/// What its outputs are influenced by.
const VARIABLES: [Variable; 4] =
    [Variable::Constant(0), Variable::Constant(1), Variable::Constant(2), Variable::Constant(3)];

/// A number of its way.
const fn measure(name: &'static str) -> Quantity {
    Quantity { name, summary: "", unit: "", factor: 1.0, dimension: Unit::NONE.dimension }
}

/// Its measures: the swing of the rocker with the length of the crank, the largest cosine of the angle between rod and rocker,
/// the mean position of the rocker, how far this swings while the crank is within 60° of the frame, and the largest cosine while
/// it swings further, and this cosine where the rocker last passes there.
const MEASURES: [Quantity; 6] = [
    measure("swing"),
    measure("largest"),
    measure("mean"),
    measure("within"),
    measure("beyond"),
    measure("there"),
];

/// What they are made of.
const PRIMITIVES: [Primitive; 7] = [
    Primitive::of(Kind::Peak, 0),
    Primitive::of(Kind::Lowest, 0),
    Primitive::of(Kind::Peak, 1),
    Primitive::of(Kind::Mean, 0),
    Primitive::of(Kind::Peak, 0).within(2),
    Primitive::of(Kind::Peak, 1).within(3),
    Primitive::of(Kind::Value(Moment::Passes { index: 3, last: true }), 1),
];

/// What it is made of, its loops closed in a way.
const fn shape(groups: List<Group>) -> Shape {
    let uses: List<List<usize>> = &[&[0, 1], &[2], &[3], &[4], &[5], &[6]];
    by_hand([4, 2], &[true, true], groups, &VARIABLES).measures(&MEASURES, uses, &PRIMITIVES, 4)
}

/// In closed form.
const SHAPE: Shape =
    shape(&[Group { kind: GroupKind::Rrr, unknowns: &[0, 1], equations: &[0, 1] }]);

/// By iteration.
const ITERATED: Shape =
    shape(&[Group { kind: GroupKind::General, unknowns: &[0, 1], equations: &[0, 1] }]);

impl Linkage for FourBar {
    type Closure<S: Scalar> = Loops<S, false>;
    constants!();
    fn prepare<S: Scalar>(&self, values: &[S]) -> Loops<S, false> {
        Loops { crank: values[0], frame: values[3], dyad: Dyad { l2: values[1], l3: values[2] } }
    }
    fn span(&self) -> Span {
        Span::Open
    }

    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }

    fn ranges(&self) -> Vec<Range> {
        vec![self.range]
    }
    fn start(&self) -> Vec<f64> {
        self.start.to_vec()
    }
}

impl<S: Scalar, const ITERATED: bool> Closure<S> for Loops<S, ITERATED> {
    type Position = [S; 6];
    type Instant = [S; 2];
    type Row = [S; 2];
    type Matrix = [S; 4];
    #[inline(always)]
    fn shape(&self) -> &'static Shape {
        match ITERATED {
            true => const { &self::ITERATED },
            false => const { &SHAPE },
        }
    }
    unasked!(S);

    #[inline(always)]
    fn zeros(&self) -> [S; 6] {
        [S::ZERO; 6]
    }
    #[inline(always)]
    fn instant(&self, independents: &[S]) -> [S; 2] {
        let (sine, cosine) = independents[0].sin_cos();
        [cosine, sine]
    }
    #[inline(always)]
    fn close(&self, _: usize, instant: &[S; 2], mode: S, position: &mut [S; 6]) -> S {
        let (sine, [ca, sa, cb, sb]) = self.dyad.close(self.span(instant), mode);
        *position = [S::atan2(sa, ca), S::atan2(sb, cb), ca, sa, cb, sb];
        sine
    }
    fn margin(&self, _: usize, instant: &[S; 2], _: &[S; 6]) -> S {
        self.dyad.margin(self.span(instant))
    }
    fn trial(
        &self,
        _: usize,
        instant: &[S; 2],
        z: &mut [S; 6],
        residual: &mut [S; 2],
        jacobian: &mut [S; 4],
    ) {
        let all: Directions<S> = directions(z[0], z[1]);
        z[2..].copy_from_slice(&all);
        (*residual, *jacobian) = self.dyad.trial(all, self.span(instant));
    }
    fn residual(&self, instant: &[S; 2], z: &[S; 6], residual: &mut [S]) {
        let all = [z[2], z[3], z[4], z[5]];
        residual.copy_from_slice(&self.dyad.trial(all, self.span(instant)).0);
    }
    fn coefficients(&self, instant: &[S; 2], z: &[S; 6], columns: &mut [[S; 6]]) {
        let rate = [self.crank * instant[1], -self.crank * instant[0]];
        columns[0][..2].copy_from_slice(&self.dyad.rates([z[2], z[3], z[4], z[5]], rate));
    }
    fn outputs(&self, _: &[S; 2], z: &[S; 6], values: &mut [S]) {
        values.copy_from_slice(&z[..2]);
    }
    fn measured(&self, instant: &[S; 2], z: &[S; 6], values: &mut [S]) {
        let within = instant[0] - S::from_f64(0.5);
        let beyond = z[1] - S::from_f64(2.0);
        values.copy_from_slice(&[z[1], z[2].mul_add(z[4], z[3] * z[5]), within, beyond]);
    }
    fn measures(&self, found: &[S], values: &mut [S]) {
        values.copy_from_slice(&[
            found[0] - found[1] + self.crank,
            found[2],
            found[3],
            found[4],
            found[5],
            found[6],
        ]);
    }
}

/// The same, closed by iteration.
#[derive(Clone, Default)]
pub struct Iterated(pub FourBar);

impl Linkage for Iterated {
    type Closure<S: Scalar> = Loops<S, true>;
    fn shape(&self) -> &'static Shape {
        const { &ITERATED }
    }
    fn values(&self) -> Vec<f64> {
        self.0.values()
    }
    fn with_values(&self, values: &[f64]) -> Self {
        Self(self.0.with_values(values))
    }
    fn prepare<S: Scalar>(&self, values: &[S]) -> Loops<S, true> {
        let Loops { crank, frame, dyad } = self.0.prepare(values);
        Loops { crank, frame, dyad }
    }
    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }
    fn span(&self) -> Span {
        Span::Open
    }

    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }

    fn ranges(&self) -> Vec<Range> {
        self.0.ranges()
    }
    fn start(&self) -> Vec<f64> {
        self.0.start.to_vec()
    }
}
