//! Motions that repeat by themselves, against known periods.

use super::{Cycle, CycleError, clock_of};
use crate::model::hand::Hand;
use crate::settings::{Method, Settings};

/// `x'' - (gain - saturation x²) x' + x = force t` in state `x` and `x'`.
#[derive(Clone, Copy)]
struct Oscillator {
    gain: f64,
    saturation: f64,
    force: f64,
    start: f64,
}

const VAN_DER_POL: Oscillator = Oscillator { gain: 1.0, saturation: 1.0, force: 0.0, start: 0.5 };

fn found(oscillator: &Oscillator, method: Method, rtol: f64) -> Result<Cycle, CycleError> {
    let Oscillator { gain, saturation, force, start } = *oscillator;
    let rates = |time, [x, v]: [f64; 2]| [v, (gain - saturation * x * x) * v - x + force * time];
    let rows = |_, [x, v]: [f64; 2]| {
        let by_x = -1.0 - 2.0 * saturation * x * v;
        [[0.0, 1.0], [by_x, gain - saturation * x * x]]
    };
    let model = Hand::new(rates, rows).starting([start, 0.0]);
    clock_of(&model, (0, &[start, 0.0]), &Settings::new(method).rtol(rtol))
}

/// Checks the period of van der Pol's oscillator with a gain.
#[track_caller]
fn check_period(gain: f64, method: Method, rtol: f64, expected: f64) {
    let scene = Oscillator { gain, saturation: gain, ..VAN_DER_POL };
    let cycle = found(&scene, method, rtol).expect("it repeats");
    let off = cycle.period() / expected - 1.0;
    assert!(off.abs() < 1e2 * rtol, "{method:?} {}: {off:e}", cycle.period());
    assert!(cycle.is_stable() && cycle.multipliers.len() == 1);
    // It begins where `x` is largest.
    let start = cycle.start();
    assert!(start[0] > 2.0 && start[0] < 2.03, "{start:?}");
    assert!(start[1].abs() < 1e3 * rtol, "{start:?}");
}

#[test]
fn van_der_pols_oscillator_has_its_period() {
    // Of the known expansions in powers of the gain and of its inverse, computed with many digits elsewhere.
    for method in [Method::Dop853, Method::Tsit5, Method::Auto, Method::Rosenbrock] {
        check_period(1.0, method, 1e-8, 6.663_286_859_323_13);
    }
    check_period(1.0, Method::Radau, 1e-7, 6.663_286_859_323_13);
    check_period(1.0, Method::Dop853, 1e-12, 6.663_286_859_323_13);
    check_period(10.0, Method::Dop853, 1e-10, 19.078_369_566_939_01);
}

#[test]
fn a_weak_clock_settles_slowly_and_is_found() {
    let scene = Oscillator { gain: 1e-4, saturation: 1e-4, ..VAN_DER_POL };
    let cycle = found(&scene, Method::Dop853, 1e-10).expect("it repeats");
    // T = 2π (1 + ε²/16 - …)
    let expected = std::f64::consts::TAU * (1.0 + 1e-8 / 16.0);
    assert!((cycle.period() / expected - 1.0).abs() < 1e-9);
    assert!((cycle.multipliers[0].modulus() - (-1e-4 * expected).exp()).abs() < 1e-7);
    assert!((cycle.start()[0] - 2.0).abs() < 1e-6, "{:?}", cycle.start());
}

#[test]
fn what_comes_to_rest_or_is_driven_says_so() {
    let damped = Oscillator { gain: -0.1, saturation: 0.0, ..VAN_DER_POL };
    let failure = found(&damped, Method::Dop853, 1e-9).expect_err("it comes to rest");
    assert!(matches!(failure, CycleError::Rest { .. }), "{failure}");
    let still = Oscillator { start: 0.0, ..VAN_DER_POL };
    let failure = found(&still, Method::Dop853, 1e-9).expect_err("it rests");
    assert_eq!(failure, CycleError::Rest { time: 0.0 });
    let driven = Oscillator { force: 0.1, ..VAN_DER_POL };
    let failure = found(&driven, Method::Dop853, 1e-9).expect_err("it is driven");
    assert_eq!(failure, CycleError::Driven { component: 1 });
}
