//! What is reported where there is no solution.

use super::{Method, Problem, STIFF, tolerances};
use crate::ode::OdeError;

const BLOW_UP: Problem<1> = Problem {
    rate: |_, state, rate| rate[0] = state[0] * state[0],
    rows: |_, state| [[2.0 * state[0]]],
};

#[test]
fn a_blow_up_is_reported_where_it_happens() {
    for method in STIFF.into_iter().chain([Method::Automatic]) {
        match BLOW_UP.march(method, (0.0, 2.0), [1.0], &tolerances(1e-8, 1e-8)) {
            Err(OdeError::StepTooSmall {
                time, component: 0, ..
            }) => assert!((time - 1.0).abs() < 1e-5, "{method:?} {time}"),
            other => panic!("{method:?} {other:?}"),
        }
    }
}

const ROOT: Problem<2> = Problem {
    rate: |_, state, rate| (rate[0], rate[1]) = (-1.0, (0.5 + state[0]).sqrt()),
    rows: |_, state| [[0.0, 0.0], [0.5 / (0.5 + state[0]).sqrt(), 0.0]],
};

#[test]
fn a_rate_that_does_not_exist_is_reported() {
    for method in STIFF.into_iter().chain([Method::Automatic]) {
        let options = tolerances(1e-8, 1e-8);
        match ROOT.march(method, (0.0, 2.0), [0.0, 0.0], &options) {
            Err(OdeError::NotFinite { time, component: 1 }) => {
                assert!((time - 0.5).abs() < 1e-5, "{method:?} {time}");
            }
            other => panic!("{method:?} {other:?}"),
        }
        assert_eq!(
            ROOT.march(method, (0.0, 2.0), [-1.0, 0.0], &options),
            Err(OdeError::NotFinite {
                time: 0.0,
                component: 1
            })
        );
    }
}

#[test]
fn a_derivative_that_does_not_exist_is_reported() {
    let options = tolerances(1e-8, 1e-8);
    for method in STIFF {
        let error = ROOT
            .march(method, (0.0, 2.0), [-0.5, 0.0], &options)
            .unwrap_err();
        assert_eq!(
            error,
            OdeError::NotDifferentiable {
                time: 0.0,
                component: 1,
                by: 0
            }
        );
        assert!(error.to_string().contains("an explicit method does not"));
    }
}

/// A stiff part whose derivative does not exist where the motion is, and a rate that does.
const KINK: Problem<2> = Problem {
    rate: |time, state, rate| (rate[0], rate[1]) = (-1e3 * (state[0] - time.cos()), 1.0),
    rows: |_, _| [[-1e3, f64::NAN], [0.0, 0.0]],
};

#[test]
fn without_a_jacobian_the_choice_is_the_explicit_method() {
    let options = tolerances(1e-6, 1e-6);
    let motion = KINK
        .march(Method::Automatic, (0.0, 3.0), [1.0, 0.0], &options)
        .unwrap();
    assert!((motion.end()[0] - 3.0_f64.cos()).abs() < 1e-3);
    assert_eq!(motion.statistics.stiff_steps, 0);
}

/// Free motion under a force: the Jacobian has no inverse, and steps need none.
const FREE: Problem<2> = Problem {
    rate: |time, state, rate| (rate[0], rate[1]) = (state[1], 6.0 * time),
    rows: |_, _| [[0.0, 1.0], [0.0, 0.0]],
};

#[test]
fn a_singular_jacobian_does_no_harm() {
    for method in STIFF.into_iter().chain([Method::Automatic]) {
        let motion = FREE
            .march(method, (0.0, 3.0), [0.0, 0.0], &tolerances(1e-9, 1e-9))
            .unwrap();
        assert!(
            (motion.end()[0] - 27.0).abs() < 1e-7,
            "{method:?} {motion:?}"
        );
        let still = motion.at(0.0);
        assert_eq!(still, [0.0, 0.0]);
    }
}

#[test]
fn options_that_make_no_sense_are_refused() {
    for method in STIFF.into_iter().chain([Method::Automatic]) {
        let name = |times, start: f64, rtol| match FREE.march(
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
        let options = crate::ode::Options {
            max_steps: 3,
            ..tolerances(1e-12, 1e-12)
        };
        let few = FREE.march(method, (0.0, 1e3), [1.0, 1.0], &options);
        assert!(
            matches!(few, Err(OdeError::TooManySteps { steps: 3, .. })),
            "{few:?}"
        );
        let few = crate::ode::Options {
            max_steps: 30,
            ..tolerances(1e-6, 1e-6)
        };
        let start = [2.0, 0.0];
        let ended = super::problems::VAN_DER_POL.march(method, (0.0, 2.0), start, &few);
        assert!(
            matches!(ended, Err(OdeError::TooManySteps { steps: 30, .. })),
            "{ended:?}"
        );
        let none = FREE.march(method, (1.0, 1.0), [1.0, 1.0], &tolerances(1e-9, 1e-9));
        assert_eq!(none.unwrap().end(), [1.0, 1.0]);
    }
}

/// Two wheels on a soft shaft that have turned far: the twist is a difference of large angles.
const WHEELS: Problem<4> = Problem {
    rate: |_, y, rate| {
        let torque = 200.0 * (y[0] - y[1]) + 0.2 * (y[2] - y[3]);
        rate[0] = y[2];
        rate[1] = y[3];
        rate[2] = (2.0 - torque) / 2e-5;
        rate[3] = (torque - 2.0 * (y[3] / 400.0)) / 5e-2;
    },
    rows: |_, _| {
        let (light, heavy) = (1.0 / 2e-5, 1.0 / 5e-2);
        [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [-200.0 * light, 200.0 * light, -0.2 * light, 0.2 * light],
            [
                200.0 * heavy,
                -200.0 * heavy,
                0.2 * heavy,
                -0.2 * heavy - 0.005 * heavy,
            ],
        ]
    },
};

#[test]
fn where_the_state_has_no_room_for_the_tolerance_rounding_is_said_to_limit() {
    check_rounding(Method::Radau);
    check_rounding(Method::Rosenbrock);
}

fn check_rounding(method: Method) {
    let start = [2.5e5 + 0.01, 2.5e5, 300.0, 300.0];
    let run = |rtol: f64| {
        let options = tolerances(rtol, 1e-3 * rtol);
        let motion = WHEELS.march(method, (0.0, 100.0), start, &options);
        motion.expect("it gets to the end")
    };
    let (fine, coarse) = (run(1e-12), run(1e-8));
    assert_eq!(coarse.statistics.rounded_steps, 0);
    assert!(fine.statistics.rounded_steps > 0);
    assert!(fine.statistics.steps < 20_000, "{:?}", fine.statistics);
    // The speeds end where the torque of the motor is that of the load.
    for motion in [&fine, &coarse] {
        assert!(
            (motion.end()[2] / 400.0 - 1.0).abs() < 1e-4,
            "{:?}",
            motion.end()
        );
    }
    assert!((fine.end()[2] - coarse.end()[2]).abs() < 1e-5);
}
