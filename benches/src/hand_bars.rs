//! A slider-crank and a four-bar by hand, reduced to the angle of the crank: `M q'' = Q - M'/2 q'²` with the kinematic
//! coefficients of first and second order. On fused numbers.

use assur::dispatch::{Task, dispatch};
use assur::scalar::Scalar;

use crate::hand_freedom::{Run, follow};
use crate::hand_squeezer::{Moving, across, dyad, point, turning};

/// Lengths of the slider-crank; inertias of crank and rod, mass of the piston, torque.
const CRANK: f64 = 0.04;
const ROD: f64 = 0.14;
const INERTIA: [f64; 2] = [2e-3, 1e-3];
const PISTON: f64 = 0.5;
const TORQUE: f64 = 0.5;

/// Acceleration of the crank of a slider-crank.
#[inline(always)]
fn slider<S: Scalar>(angle: S, speed: S) -> S {
    let number = S::from_f64;
    let ([sine], [cosine]) = S::sin_cos_all([angle]);
    let ratio = number(-CRANK / ROD);
    let lean = ratio * sine;
    let upright = S::sqrt(Scalar::mul_add(-lean, lean, S::ONE));
    // ψ' cos ψ = ratio cos θ, ψ'' cos ψ = ψ'² sin ψ - ratio sin θ
    let inverse = S::ONE / upright;
    let turn = ratio * cosine * inverse;
    let bend = Scalar::mul_add(turn * turn, lean, -(ratio * sine)) * inverse;
    let (r, l) = (number(CRANK), number(ROD));
    let x = -(r * sine) - l * lean * turn;
    let xx = -(r * cosine) - l * Scalar::mul_add(upright * turn, turn, lean * bend);
    let (rod, piston) = (number(INERTIA[1]), number(PISTON));
    let m = number(INERTIA[0]) + Scalar::mul_add(rod * turn, turn, piston * x * x);
    let g = Scalar::mul_add(rod * turn, bend, piston * x * xx);
    (number(TORQUE) - g * (speed * speed)) / m
}

/// Masses of the four-bar: crank about its pivot; coupler with its centre of mass in the middle; rocker about its pivot.
const BARS: [f64; 4] = [0.05, 0.15, 0.12, 0.16];
const COUPLER: (f64, f64) = (0.8, 2.5e-3);
const TURNS: [f64; 2] = [4e-4, 3e-3];
const WEIGHT: f64 = 9.81;

/// Acceleration of the crank of a four-bar under gravity.
#[inline(always)]
fn four_bar<S: Scalar>(angle: S, speed: S) -> S {
    let number = S::from_f64;
    let ([sine], [cosine]) = S::sin_cos_all([angle]);
    let a = [number(BARS[0]) * cosine, number(BARS[0]) * sine];
    let (da, dda) = (across(a), [-a[0], -a[1]]);
    // P - A = b u - c w
    let over = Moving([number(BARS[3]) - a[0], -a[1]], [-da[0], -da[1]], [-dda[0], -dda[1]]);
    let both = dyad(BARS[1], BARS[2], 1.0, &over);
    let [coupler, rocker] = both.turns;
    let half = number(0.5);
    let u = [half * both.first[0], half * both.first[1]];
    let beside = across(u);
    let d = [da[0] + coupler.0 * beside[0], da[1] + coupler.0 * beside[1]];
    let square = coupler.0 * coupler.0;
    let dd = [
        dda[0] + coupler.1 * beside[0] - square * u[0],
        dda[1] + coupler.1 * beside[1] - square * u[1],
    ];
    let (mut m, mut g) = (number(TURNS[0]), S::ZERO);
    point((&mut m, &mut g), COUPLER.0, d, dd);
    turning((&mut m, &mut g), COUPLER.1, coupler);
    turning((&mut m, &mut g), TURNS[1], rocker);
    let force = number(-COUPLER.0 * WEIGHT) * d[1];
    (force - g * (speed * speed)) / m
}

/// Which of them.
#[derive(Clone, Copy, PartialEq)]
pub enum Bars {
    Slider,
    FourBar,
}

/// Integrates one of them by DOP853.
#[inline(never)]
pub fn run(which: Bars, start: [f64; 2], end: f64, tolerances: (f64, f64)) -> Run {
    match which {
        Bars::Slider => dispatch(Turn::<true> { start, end, tolerances }),
        Bars::FourBar => dispatch(Turn::<false> { start, end, tolerances }),
    }
}

struct Turn<const SLIDER: bool> {
    start: [f64; 2],
    end: f64,
    tolerances: (f64, f64),
}

impl<const SLIDER: bool> Task for Turn<SLIDER> {
    type Output = Run;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Run {
        follow(
            #[inline(always)]
            |angle: S, speed: S| match SLIDER {
                true => slider(angle, speed),
                false => four_bar(angle, speed),
            },
            self.start,
            (self.end, 1e-3),
            self.tolerances,
        )
    }
}
