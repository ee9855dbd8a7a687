//! A revolution whose modes are kept, against the same closed form without a look at them.

use super::linkages::SixBar;
use crate::closure::{Assembly, AtDeadPoint, Axis, Closure, Linkage, sweep};
use crate::dispatch::{Task, dispatch};
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// A revolution as one would write it by hand: the same closed form, modes fixed, nothing looked at.
struct ByHand;

impl Task for ByHand {
    type Output = f64;
    #[inline(always)]
    fn run<S: Scalar>(self) -> f64 {
        let values = SixBar::default().values().into_iter();
        let loops =
            Linkage::prepare::<S>(&SixBar::default(), &values.map(S::from_f64).collect::<Vec<S>>());
        let modes = [-1.0, 1.0].map(S::from_f64);
        let mut sum = S::ZERO;
        let mut z = loops.zeros();
        for k in 0..360 {
            let at = S::from_f64(TAU * k as f64 / 360.0);
            let instant = loops.instant(&[at]);
            loops.close_all(&instant, &modes, &mut z, &mut [S::ZERO; 2], true);
            sum = sum + (z[0] + z[1] + z[2] + z[3]);
        }
        sum.to_f64()
    }
}

/// A revolution whose modes are kept.
struct Kept;

impl Task for Kept {
    type Output = f64;
    #[inline(always)]
    fn run<S: Scalar>(self) -> f64 {
        let mut assembly = Assembly::<SixBar, S>::new(&SixBar::default());
        assembly.start().expect("the linkage assembles");
        let mut sum = S::ZERO;
        for k in 0..360 {
            let at = S::from_f64(TAU * k as f64 / 360.0);
            assembly.move_to(&[at]).expect("the crank turns");
            let z = assembly.position();
            sum = sum + (z[0] + z[1] + z[2] + z[3]);
        }
        sum.to_f64()
    }
}

#[test]
fn sweeps_over_a_revolution() {
    let axis = Axis { from: 0.0, to: TAU, count: 361 };
    let positions = sweep(&SixBar::default(), &[axis], AtDeadPoint::Stop).expect("it assembles");
    assert_eq!(positions.len(), 361);
    assert!(positions.end.is_none() && positions.events.is_empty());
    for j in 0..4 {
        let (first, last) = (positions.coordinates(0)[j], positions.coordinates(360)[j]);
        assert!((first - last).abs() < 1e-12);
    }
    assert!((dispatch(ByHand) - dispatch(Kept)).abs() < 1e-9);
}
