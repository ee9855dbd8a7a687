//! Motions against closed forms, and what happens where there is none.

use super::super::Explicit::{Dop853, Tsit5};
use super::super::{Explicit, OdeError, Options};
use super::{end, march, tolerance};
use crate::settings::Settings;
use std::f64::consts::TAU;

/// A free oscillator of frequency 1.
fn oscillator(_time: f64, [place, speed]: [f64; 2]) -> [f64; 2] {
    [speed, -place]
}

/// Relative change of the energy over 1000 periods.
fn energy_drift(method: Explicit, rtol: f64) -> f64 {
    let [position, speed] =
        end(method, oscillator, (0.0, 1000.0 * TAU), [1.0, 0.0], &tolerance(rtol));
    (position * position + speed * speed - 1.0).abs()
}

#[test]
fn an_oscillator_keeps_its_energy() {
    let (tsit5, dop853) = (energy_drift(Tsit5, 1e-9), energy_drift(Dop853, 1e-12));
    assert!(tsit5 < 1e-5, "{tsit5:e}");
    assert!(dop853 < 1e-9, "{dop853:e}");
}

#[test]
fn a_motion_can_be_followed_backwards() {
    fn check(method: Explicit) {
        let there = march(method, oscillator, (1.0, 9.0), [0.3, -0.2], &tolerance(1e-11)).unwrap();
        let last = [there.end()[0], there.end()[1]];
        let back = march(method, oscillator, (9.0, 1.0), last, &tolerance(1e-11)).unwrap();
        assert_eq!(*back.times().last().unwrap(), 1.0);
        assert!((back.end()[0] - 0.3).abs() < 1e-9 && (back.end()[1] + 0.2).abs() < 1e-9);
        for time in [1.0, 2.345, 5.0, 8.999, 9.0] {
            let (first, second) = (there.at(time), back.at(time));
            assert!((first[0] - second[0]).abs() < 1e-8, "{time} {first:?} {second:?}");
        }
    }
    check(Tsit5);
    check(Dop853);
}

#[test]
fn the_continuous_solution_is_as_accurate_as_the_steps() {
    fn check(method: Explicit, limit: f64) {
        let motion = march(method, oscillator, (0.0, 20.0), [0.0, 1.0], &tolerance(1e-10)).unwrap();
        for number in 0..=1000 {
            let time = 0.02 * f64::from(number);
            let (state, rate) = (motion.at(time), motion.derivative_at(time));
            assert!((state[0] - time.sin()).abs() < limit, "{time} {:e}", state[0] - time.sin());
            assert!(
                (rate[0] - time.cos()).abs() < 100.0 * limit,
                "{time} {:e}",
                rate[0] - time.cos()
            );
        }
        assert_eq!(motion.at(-1.0), motion.at(0.0));
        assert_eq!(motion.at(0.0), [0.0, 1.0]);
        assert!((motion.at(21.0)[0] - motion.end()[0]).abs() < 1e-14);
    }
    check(Tsit5, 1e-7);
    check(Dop853, 1e-8);
}

#[test]
fn smaller_tolerances_give_smaller_errors() {
    let error = |rtol: f64| {
        let motion = march(Dop853, oscillator, (0.0, 20.0), [0.0, 1.0], &tolerance(rtol)).unwrap();
        assert!(motion.statistics.estimated_error > 0.0);
        assert!(motion.statistics.smallest_step <= motion.statistics.largest_step);
        (motion.end()[0] - 20.0_f64.sin()).abs()
    };
    assert!(error(1e-6) > 10.0 * error(1e-9));
    assert!(error(1e-13) < 1e-11);
}

#[test]
fn a_blow_up_is_reported_where_it_happens() {
    fn blow_up(_time: f64, [y]: [f64; 1]) -> [f64; 1] {
        [y * y]
    }
    fn check(method: Explicit) {
        match march(method, blow_up, (0.0, 2.0), [1.0], &tolerance(1e-10)) {
            Err(OdeError::StepTooSmall { time, component: 0, .. }) => {
                assert!((time - 1.0).abs() < 1e-6, "{time}")
            }
            other => panic!("{other:?}"),
        }
    }
    check(Tsit5);
    check(Dop853);
}

#[test]
fn a_rate_that_does_not_exist_is_reported() {
    fn root(_time: f64, [y, _]: [f64; 2]) -> [f64; 2] {
        [-1.0, (0.5 + y).sqrt()]
    }
    fn check(method: Explicit) {
        match march(method, root, (0.0, 2.0), [0.0, 0.0], &tolerance(1e-8)) {
            Err(OdeError::NotFinite { time, component: 1 }) => {
                assert!((time - 0.5).abs() < 1e-6, "{time}")
            }
            other => panic!("{other:?}"),
        }
        let at_once = march(method, root, (0.0, 2.0), [-1.0, 0.0], &tolerance(1e-8));
        assert_eq!(at_once, Err(OdeError::NotFinite { time: 0.0, component: 1 }));
        let fixed = Options { fixed_step: Some(0.1), ..Options::default() };
        let message = march(method, root, (0.0, 2.0), [0.0, 0.0], &fixed).unwrap_err().to_string();
        assert!(message.contains("state 1 is not a finite number"), "{message}");
    }
    check(Tsit5);
    check(Dop853);
}

#[test]
fn options_that_make_no_sense_are_refused() {
    let name = |times: (f64, f64), start: f64, options: &Options| match march(
        Tsit5,
        oscillator,
        times,
        [start, 0.0],
        options,
    ) {
        Err(OdeError::BadOption { name, .. }) => name,
        other => panic!("{other:?}"),
    };
    assert_eq!(name((0.0, 1.0), 1.0, &tolerance(1e-15)), "rtol");
    assert_eq!(name((0.0, 1.0), 1.0, &tolerance(f64::NAN)), "rtol");
    assert_eq!(name((0.0, 1.0), 1.0, &Options::scaled(1e-6, &[1.0])), "atol");
    assert_eq!(name((0.0, 1.0), 1.0, &Options::scaled(1e-6, &[1.0, -1.0])), "atol");
    let three = Settings { atol: vec![None, None, Some(1e-9)], ..Settings::default() };
    let options = Options::of(&three, &[1.0, 1.0]);
    assert_eq!(name((0.0, 1.0), 1.0, &options), "atol");
    assert_eq!(name((0.0, f64::INFINITY), 1.0, &tolerance(1e-6)), "times");
    assert_eq!(name((0.0, 1.0), f64::NAN, &tolerance(1e-6)), "start");
    let zero = Options { max_step: Some(0.0), ..tolerance(1e-6) };
    assert_eq!(name((0.0, 1.0), 1.0, &zero), "max_step");
}

#[test]
fn limits_are_kept() {
    let few = Options { max_steps: 5, ..tolerance(1e-10) };
    let ended = march(Tsit5, oscillator, (0.0, 100.0), [1.0, 0.0], &few);
    assert!(matches!(ended, Err(OdeError::TooManySteps { steps: 5, .. })));
    let short = Options { max_step: Some(0.01), first_step: Some(1.0), ..tolerance(1e-3) };
    let motion = march(Dop853, oscillator, (0.0, 1.0), [1.0, 0.0], &short).unwrap();
    assert!(motion.statistics.largest_step <= 0.0101 + 1e-15);
    let still = march(Dop853, oscillator, (3.0, 3.0), [1.0, 0.5], &tolerance(1e-8)).unwrap();
    assert_eq!((still.at(3.0), still.at(4.0)), (vec![1.0, 0.5], vec![1.0, 0.5]));
    assert_eq!(still.derivative_at(3.0), [0.0, 0.0]);
}

#[test]
fn a_motion_whose_steps_stability_holds_ends_and_says_so() {
    // y follows cos t and knows a decay of 1e6/s: over 1000 s that is 2e8 steps.
    fn decay(time: f64, [y]: [f64; 1]) -> [f64; 1] {
        [-1e6 * (y - time.cos())]
    }
    fn check(method: Explicit, rtol: f64) {
        let options = Options { rtol, ..Options::default() };
        match march(method, decay, (0.0, 1000.0), [1.0], &options) {
            Err(OdeError::Stiff { time, step, rate, steps }) => {
                assert!(time < 2.0, "{time}");
                assert!(step > 1e-7 && step < 1e-5, "{step:e}");
                assert!(rate > 5e5 && rate < 2e6, "{rate:e}");
                assert!((steps / (1e3 / step) - 1.0).abs() < 0.01, "{steps:e}");
            }
            other => panic!("{rtol:e}: {:?}", other.map(|_| ())),
        }
    }
    for rtol in [1e-4, 1e-10] {
        check(Dop853, rtol);
        check(Tsit5, rtol);
    }
}
