//! The choice between explicit and stiff.

use super::problems::VAN_DER_POL;
use super::{Hand, Implicit, march, tolerances};
use crate::settings::Method;

const OSCILLATOR: Hand<2> =
    Hand::new(|_, [place, speed]| [speed, -place], |_, _| [[0.0, 1.0], [-1.0, 0.0]]);

#[test]
fn an_oscillator_stays_explicit() {
    for rtol in [1e-2, 1e-4, 1e-7, 1e-10, 1e-13] {
        let options = tolerances(rtol, rtol);
        let motion =
            march(&OSCILLATOR, Implicit::Automatic, (0.0, 300.0), [1.0, 0.0], &options).unwrap();
        assert!(motion.switches.is_empty(), "{rtol:e} {:?}", motion.switches);
        // Its steps look like those beside a stiff part. Trials cost little, and become rare.
        let took = motion.statistics;
        let permitted = 45 + took.steps / 8;
        assert!(took.stiff_steps <= permitted, "{rtol:e} {took:?}");
    }
}

#[test]
fn van_der_pol_becomes_stiff_at_once() {
    let options = tolerances(1e-6, 1e-6);
    let motion =
        march(&VAN_DER_POL, Implicit::Automatic, (0.0, 2.0), [2.0, 0.0], &options).unwrap();
    let took = motion.statistics;
    println!("{took:?} {:?}", motion.switches);
    assert!(motion.switches[0].to == Method::Radau && motion.switches[0].time < 1e-3);
    assert!(took.stiff_steps * 2 > took.steps, "{took:?}");
    assert!(took.evaluations < 20_000, "{took:?}");
}

/// Stiff up to `t = 1`, a plain oscillator after it.
const SOFTENING: Hand<2> = Hand::new(
    |time, [follower, other]| {
        let stiff = 5e5 * (1.0 - (20.0 * (time - 1.0)).tanh());
        let rate = other - stiff * (follower - (10.0 * time).cos());
        [rate, -100.0 * follower]
    },
    |time, _| {
        let stiff = 5e5 * (1.0 - (20.0 * (time - 1.0)).tanh());
        [[-stiff, 1.0], [-100.0, 0.0]]
    },
);

#[test]
fn where_stiffness_ends_the_explicit_method_returns() {
    let options = tolerances(1e-8, 1e-8);
    let march = |method| march(&SOFTENING, method, (0.0, 20.0), [1.0, 0.0], &options).unwrap();
    let (motion, reference) = (march(Implicit::Automatic), march(Implicit::Rosenbrock));
    println!("{:?} {:?}", motion.statistics, motion.switches);
    println!("{:?}", reference.statistics);
    println!("{:?}", march(Implicit::Radau).statistics);
    let kinds: Vec<Method> = motion.switches.iter().map(|switch| switch.to).collect();
    assert_eq!(kinds, [Method::Radau, Method::Dop853]);
    assert!(motion.switches[1].time > 1.0 && motion.switches[1].time < 4.0);
    assert!(motion.statistics.evaluations < reference.statistics.evaluations);
    for (a, b) in motion.end().iter().zip(reference.end()) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
}

/// A fast oscillation that is hardly damped and of which nothing is left: stability holds back the explicit method on
/// the imaginary axis too.
const RINGING: Hand<3> = Hand::new(
    |_, [slow, place, speed]| {
        let force = -1e8 * (place - slow) - 200.0 * speed;
        [-slow, speed, force]
    },
    |_, _| [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1e8, -1e8, -200.0]],
);

#[test]
fn a_fast_oscillation_that_has_died_is_stiffness() {
    let options = tolerances(1e-6, 1e-6);
    let motion =
        march(&RINGING, Implicit::Automatic, (0.0, 10.0), [1.0, 1.0, -1.0], &options).unwrap();
    println!("{:?} {:?}", motion.statistics, motion.switches);
    assert!((motion.end()[1] / (-10.0_f64).exp() - 1.0).abs() < 1e-2);
    assert!(motion.statistics.evaluations < 20_000);
    assert!(motion.switches.first().is_some_and(|switch| switch.to == Method::Radau));
}
