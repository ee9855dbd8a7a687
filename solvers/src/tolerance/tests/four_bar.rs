//! A crank-rocker in closed form, whose statistics are checked against those of its solved equation.

use super::super::{Sampling, Source, Status, Study, monte_carlo};
use crate::closure::{Closure, Group, GroupKind, Linkage, Range, Variable};
use crate::problem::{Refused, Span};
use crate::scalar::Scalar;
use crate::shape::Distribution;
use crate::shape::{Shape, by_hand};
use std::f64::consts::TAU;

/// Two links that meet: `l2 dir(a) - l3 dir(b) = [d - l1 cos q, -l1 sin q]`; output `b`. Constants `l1, l2, l3, d`.
#[derive(Clone)]
struct FourBar([f64; 4]);

struct Loops<S>([S; 4]);

/// What it is made of.
const SHAPE: Shape = by_hand(
    [4, 1],
    &[true; 2],
    &[Group { kind: GroupKind::Rrr, unknowns: &[0, 1], equations: &[0, 1] }],
    &[Variable::Constant(0), Variable::Constant(1), Variable::Constant(2), Variable::Constant(3)],
);

impl Linkage for FourBar {
    type Closure<S: Scalar> = Loops<S>;
    #[inline(always)]
    fn shape() -> &'static Shape {
        const { &SHAPE }
    }

    fn values(&self) -> Vec<f64> {
        self.0.to_vec()
    }
    fn with_values(values: &[f64]) -> Self {
        Self(std::array::from_fn(|k| values[k]))
    }
    fn check(&self) -> Result<(), Refused> {
        Ok(())
    }
    fn prepare<S: Scalar>(v: &[S]) -> Loops<S> {
        Loops([v[0], v[1], v[2], v[3]])
    }
    fn span(&self) -> Span {
        Span::Open
    }
    fn drive(&self, _: f64) -> Option<Vec<f64>> {
        None
    }
    fn ranges(&self) -> Vec<Range> {
        vec![Range { from: 0.0, to: TAU, start: 1.0, period: TAU }]
    }
    fn start(&self) -> Vec<f64> {
        vec![0.5, 1.5]
    }
}

impl<S: Scalar> Loops<S> {
    fn gap(&self, instant: &[S; 2]) -> [S; 2] {
        let [l1, _, _, d] = self.0;
        [d - l1 * instant[0], -(l1 * instant[1])]
    }
}

impl<S: Scalar> Closure<S> for Loops<S> {
    type Position = [S; 2];
    type Instant = [S; 2];
    type Row = [S; 2];
    type Matrix = [S; 4];
    #[inline(always)]
    fn shape(&self) -> &'static Shape {
        const { &SHAPE }
    }

    fn zeros(&self) -> [S; 2] {
        [S::ZERO; 2]
    }
    fn instant(&self, independents: &[S]) -> [S; 2] {
        let (sine, cosine) = independents[0].sin_cos();
        [cosine, sine]
    }
    fn close(&self, _: usize, instant: &[S; 2], mode: S, z: &mut [S; 2]) -> S {
        let [_, l2, l3, _] = self.0;
        let [x, y] = self.gap(instant);
        let square = x * x + y * y;
        let half = S::from_f64(0.5);
        let cosine = half * (l2 * l2 + l3 * l3 - square) / (l2 * l3);
        let sine = mode * (S::ONE - cosine * cosine).sqrt();
        // The direction of the gap from the link l2.
        let along = l2 - l3 * cosine;
        z[0] = S::atan2(y, x) + S::atan2(l3 * sine, along);
        z[1] = z[0] + S::atan2(sine, cosine);
        sine
    }
    fn margin(&self, _: usize, instant: &[S; 2], _: &[S; 2]) -> S {
        let [_, l2, l3, _] = self.0;
        let [x, y] = self.gap(instant);
        l2 + l3 - x.hypot(y)
    }
    fn trial(
        &self,
        _: usize,
        instant: &[S; 2],
        z: &mut [S; 2],
        residual: &mut [S; 2],
        jacobian: &mut [S; 4],
    ) {
        let [_, l2, l3, _] = self.0;
        let [x, y] = self.gap(instant);
        let ([sa, sb], [ca, cb]) = S::sin_cos_all([z[0], z[1]]);
        *residual = [l2 * ca - l3 * cb - x, l2 * sa - l3 * sb - y];
        *jacobian = [-(l2 * sa), l3 * sb, l2 * ca, -(l3 * cb)];
    }
    fn residual(&self, instant: &[S; 2], z: &[S; 2], residual: &mut [S]) {
        let mut row = [S::ZERO; 2];
        self.trial(0, instant, &mut z.clone(), &mut row, &mut [S::ZERO; 4]);
        residual.copy_from_slice(&row);
    }
    fn coefficients(&self, _: &[S; 2], _: &[S; 2], _: &mut [[S; 2]]) {}
    fn outputs(&self, _: &[S; 2], z: &[S; 2], values: &mut [S]) {
        values[0] = z[1];
    }
    fn influence(&self, _: &[S; 2], _: &[S; 2], _: &mut [S]) {}
    fn second_influence(&self, _: &[S; 2], _: &[S; 2], _: &mut [S]) {}
    fn points(&self, _: &[S; 2], _: &[S; 2], _: &mut [S]) {}
}

/// The rocker has rod and rocker in line with the stretched crank: only a rod that is long enough reaches.
#[test]
fn the_share_that_does_not_meet_is_the_one_that_is_known() {
    // At q = 180 deg the gap is l1 + d = 0.125, which l2 + l3 passes by a tenth of the tolerance.
    let tolerance = 1e-4;
    let linkage = FourBar([0.025, 0.065 + 0.1 * tolerance, 0.06, 0.1]);
    let study = Study {
        output: 0,
        places: vec![vec![180f64.to_radians()]],
        sources: vec![Source {
            variable: 1,
            half_width: tolerance,
            distribution: Distribution::Uniform,
        }],
    };
    let sampling = Sampling { samples: 50_000, ..Sampling::default() };
    let found = monte_carlo(&linkage, &study, &sampling, &|_| ()).expect("it is at the brink");
    let place = &found.places[0];
    assert_eq!(place.status, Status::Conditional);
    assert_eq!(place.assembled, 50_000 - (place.failures.value * 5e4).round() as u64);
    assert!(place.failures.low < 0.45 && 0.45 < place.failures.high, "{place:?}");
}
