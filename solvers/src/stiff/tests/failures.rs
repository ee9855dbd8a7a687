//! What is reported where there is no solution.

use super::{Hand, Implicit, STIFF, march, tolerances};
use crate::ode::OdeError;

const BLOW_UP: Hand<1> = Hand::new(|_, [y]| [y * y], |_, [y]| [[2.0 * y]]);

#[test]
fn a_blow_up_is_reported_where_it_happens() {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        match march(&BLOW_UP, method, (0.0, 2.0), [1.0], &tolerances(1e-8, 1e-8)) {
            Err(OdeError::StepTooSmall { time, component: 0, .. }) => {
                assert!((time - 1.0).abs() < 1e-5, "{method:?} {time}")
            }
            other => panic!("{method:?} {other:?}"),
        }
    }
}

const ROOT: Hand<2> = Hand::new(
    |_, [y, _]| [-1.0, (0.5 + y).sqrt()],
    |_, [y, _]| [[0.0, 0.0], [0.5 / (0.5 + y).sqrt(), 0.0]],
);

#[test]
fn a_rate_that_does_not_exist_is_reported() {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        let options = tolerances(1e-8, 1e-8);
        match march(&ROOT, method, (0.0, 2.0), [0.0, 0.0], &options) {
            Err(OdeError::NotFinite { time, component: 1 }) => {
                assert!((time - 0.5).abs() < 1e-5, "{method:?} {time}");
            }
            other => panic!("{method:?} {other:?}"),
        }
        assert_eq!(
            march(&ROOT, method, (0.0, 2.0), [-1.0, 0.0], &options),
            Err(OdeError::NotFinite { time: 0.0, component: 1 })
        );
    }
}

#[test]
fn a_derivative_that_does_not_exist_is_reported() {
    let options = tolerances(1e-8, 1e-8);
    for method in STIFF {
        let error = march(&ROOT, method, (0.0, 2.0), [-0.5, 0.0], &options).unwrap_err();
        assert_eq!(error, OdeError::NotDifferentiable { time: 0.0, component: 1, by: 0 });
        assert!(error.to_string().contains("an explicit method does not"));
    }
}

/// A stiff part whose derivative does not exist where the motion is, and a rate that does.
const KINK: Hand<2> =
    Hand::new(|time, [y, _]| [-1e3 * (y - time.cos()), 1.0], |_, _| [[-1e3, f64::NAN], [0.0, 0.0]]);

#[test]
fn without_a_jacobian_the_choice_is_the_explicit_method() {
    let options = tolerances(1e-6, 1e-6);
    let motion = march(&KINK, Implicit::Automatic, (0.0, 3.0), [1.0, 0.0], &options).unwrap();
    assert!((motion.end()[0] - 3.0_f64.cos()).abs() < 1e-3);
    assert_eq!(motion.statistics.stiff_steps, 0);
}

/// Free motion under a force: the Jacobian has no inverse, and steps need none.
const FREE: Hand<2> =
    Hand::new(|time, [_, speed]| [speed, 6.0 * time], |_, _| [[0.0, 1.0], [0.0, 0.0]]);

#[test]
fn a_singular_jacobian_does_no_harm() {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        let motion = march(&FREE, method, (0.0, 3.0), [0.0, 0.0], &tolerances(1e-9, 1e-9)).unwrap();
        assert!((motion.end()[0] - 27.0).abs() < 1e-7, "{method:?} {motion:?}");
        let still = motion.at(0.0);
        assert_eq!(still, [0.0, 0.0]);
    }
}

#[test]
fn options_that_make_no_sense_are_refused() {
    for method in STIFF.into_iter().chain([Implicit::Automatic]) {
        let name = |times, start: f64, rtol| match march(
            &FREE,
            method,
            times,
            [start, 0.0],
            &tolerances(rtol, 1e-9),
        ) {
            Err(OdeError::BadOption { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(name((0.0, f64::NAN), 0.0, 1e-9), "times");
        assert_eq!(name((0.0, 1.0), f64::INFINITY, 1e-9), "start");
        assert_eq!(name((0.0, 1.0), 0.0, 0.0), "rtol");
        let options = crate::ode::Options { max_steps: 3, ..tolerances(1e-12, 1e-12) };
        let few = march(&FREE, method, (0.0, 1e3), [1.0, 1.0], &options);
        assert!(matches!(few, Err(OdeError::TooManySteps { steps: 3, .. })), "{few:?}");
        let few = crate::ode::Options { max_steps: 30, ..tolerances(1e-6, 1e-6) };
        let start = [2.0, 0.0];
        let ended = march(&super::problems::VAN_DER_POL, method, (0.0, 2.0), start, &few);
        assert!(matches!(ended, Err(OdeError::TooManySteps { steps: 30, .. })), "{ended:?}");
        let none = march(&FREE, method, (1.0, 1.0), [1.0, 1.0], &tolerances(1e-9, 1e-9));
        assert_eq!(none.unwrap().end(), [1.0, 1.0]);
    }
}

/// Two wheels on a soft shaft that have turned far: the twist is a difference of large angles.
const WHEELS: Hand<4> = Hand::new(
    |_, y| {
        let torque = 200.0 * (y[0] - y[1]) + 0.2 * (y[2] - y[3]);
        let load = 2.0 * (y[3] / 400.0);
        [y[2], y[3], (2.0 - torque) / 2e-5, (torque - load) / 5e-2]
    },
    |_, _| {
        let (light, heavy) = (1.0 / 2e-5, 1.0 / 5e-2);
        [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [-200.0 * light, 200.0 * light, -0.2 * light, 0.2 * light],
            [200.0 * heavy, -200.0 * heavy, 0.2 * heavy, -0.2 * heavy - 0.005 * heavy],
        ]
    },
);

#[test]
fn where_the_state_has_no_room_for_the_tolerance_rounding_is_said_to_limit() {
    check_rounding(Implicit::Radau);
    check_rounding(Implicit::Rosenbrock);
}

fn check_rounding(method: Implicit) {
    let start = [2.5e5 + 0.01, 2.5e5, 300.0, 300.0];
    let run = |rtol: f64| {
        let options = tolerances(rtol, 1e-3 * rtol);
        let motion = march(&WHEELS, method, (0.0, 100.0), start, &options);
        motion.expect("it gets to the end")
    };
    let (fine, coarse) = (run(1e-12), run(1e-8));
    assert_eq!(coarse.statistics.rounded_steps, 0);
    assert!(fine.statistics.rounded_steps > 0);
    assert!(fine.statistics.steps < 20_000, "{:?}", fine.statistics);
    // The speeds end where the torque of the motor is that of the load.
    for motion in [&fine, &coarse] {
        assert!((motion.end()[2] / 400.0 - 1.0).abs() < 1e-4, "{:?}", motion.end());
    }
    assert!((fine.end()[2] - coarse.end()[2]).abs() < 1e-5);
}
