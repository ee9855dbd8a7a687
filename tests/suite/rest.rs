//! Positions of rest, and vibrations about them.

use assur::answer::{Error, Question, Status};
use assur::prelude::*;
use assur::rest::{Rest, RestError};

/// A four-bar that hangs, with a coupler that has mass.
mod hanging {
    assur::mechanism! {
        Hanging from "made up";
        parameter a = 50 mm, b = 150 mm, c = 120 mm, d = 160 mm, m = 0.5 kg, g = 9.81 [m/s^2], J = 1e-3 [kg*m^2];
        coordinate phi: deg = -60 deg;
        dependent psi ~ 10 deg, chi ~ 70 deg;
        closure pin: a*dir(phi) + b*dir(psi) = [d, 0] + c*dir(chi);
        let v = dot(a*dir(phi) + b/2*dir(psi));
        kinetic J*dot(phi)^2/2 + J*dot(chi)^2/2 + m*inner(v, v)/2;
        potential m*g*(a*sin(phi) + b/2*sin(psi));
        effect loss { dissipation 1e-3 [N*m*s]*dot(phi)^2/2; }
        output pin = reaction(pin) [N], weight = m*g [N];
        measure f = frequency(1) [Hz], D = damping(1), angle = value(phi, end) [deg];
        scene still { rest; }
        scene damped = loss { rest; }
        scene swings { run time 0 s .. 4 s; }
        // By mpmath with 30 digits: the minimum of the potential, its curvature and the reduced mass.
        expect scene still at rest: phi = -104.114705125358 deg +- 1e-11 deg;
        expect scene still at rest: f = 1.771005515441544 Hz +- 1e-12 Hz;
    }
}

/// A mass between springs, with what goes wrong.
mod block {
    assur::mechanism! {
        Block from "made up";
        parameter m = 2 kg, k = 200 [N/m], k_2 = 800 [N/m] in 0 [N/m] .. 1e6 [N/m], F = 30 N in -1 kN .. 1 kN, mu = 10 N, d = 0 [N*s/m] in -100 [N*s/m] .. 100 [N*s/m];
        coordinate x: mm = 20 mm;
        kinetic m*dot(x)^2/2;
        dissipation d*dot(x)^2/2;
        effect spring { potential k*x^2/2; }
        effect weight { force F on x; }
        /// Dry friction.
        effect friction { force -mu*sign(dot(x)) on x; }
        /// Stiffer on one side.
        effect rubber { force -(if x > 0 m { k_2 } else { k })*x on x; }
        /// A stop that it meets on the way.
        effect stop { mode free { when hit: x - 0.1 m rises -> held { set dot(x) = 0; } } mode held { hold x; } }
        scene hangs = spring + weight { rest; }
        scene sticks = spring + friction { rest; }
        scene kinked = rubber { rest; }
        scene falls = weight { rest; }
        scene wheel { rest; }
        scene stopped = spring + weight + stop { rest; start free; }
        measure f = frequency(1) [Hz];
    }
}

/// Its force exists on one side only; what it crosses on the way ends its mode; or a drive shakes it.
mod root {
    assur::mechanism! {
        Root from "made up";
        parameter m = 1 kg, w = 3 [1/s];
        coordinate x: m = 9 m, y: m = 0 m;
        kinetic m*(dot(x)^2 + dot(y)^2)/2;
        potential 2 [N/m]*y^2;
        force 1 N - 1 [N]*sqrt(x/(1 m)) on x;
        effect gate { mode far { when x - 4 m crosses -> near; } mode near { } }
        effect shaken { force 1 N*sin(w*time) on y; }
        scene still { rest; }
        scene through = gate { rest; start far; }
        scene shakes = shaken { run time 0 s .. 1 s; }
    }
}

/// A pendulum in Cartesian coordinates: reduced, and held by its closure.
mod cartesian {
    assur::mechanism! {
        Cartesian from "made up";
        parameter L = 0.7 m, m = 2 kg, g = 9.81 [m/s^2], d = 0.6 [N*s/m];
        coordinate x: m = 0.3 m;
        dependent y ~ -0.6 m;
        closure rod: x^2 + y^2 = L^2;
        kinetic m*(dot(x)^2 + dot(y)^2)/2;
        potential m*g*y;
        dissipation d*(dot(x)^2 + dot(y)^2)/2;
        output y;
        scene hangs { rest; }
    }
}

/// An arm that stands on its head, or hangs.
mod arm {
    assur::mechanism! {
        Arm from "made up";
        parameter l = 1 m, g = 9.81 [m/s^2], d = 0.5 [1/s];
        coordinate phi: deg = 70 deg, y: m = 0 m;
        motion ddot(phi) = -g/l*cos(phi) - d*dot(phi);
        motion ddot(y) = -4 [1/s^2]*y;
        scene still { rest; }
        scene up { rest; start phi = 80 deg; }
        scene down { rest; start phi = -70 deg; }
    }
}

/// Three masses in a row, with any springs.
mod row {
    assur::mechanism! {
        Row from "made up";
        parameter m_1 = 1 kg, m_2 = 1 kg, m_3 = 1 kg, k_1 = 1 [N/m], k_2 = 1 [N/m], k_3 = 1 [N/m], F = 1 N;
        coordinate x_1: m = 0 m, x_2: m = 0 m, x_3: m = 0 m;
        kinetic (m_1*dot(x_1)^2 + m_2*dot(x_2)^2 + m_3*dot(x_3)^2)/2;
        potential (k_1*x_1^2 + k_2*(x_2 - x_1)^2 + k_3*(x_3 - x_2)^2)/2;
        force F on x_3;
        scene still { rest; }
    }
}

fn resting(scene: &impl Solve) -> Rest {
    let motion = scene.run().expect("it rests");
    motion.rest().expect("a position of rest").clone()
}

fn why(scene: &impl Solve) -> RestError {
    match scene.run() {
        Err(Error::NotAtRest(error)) => error,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_frequency_is_that_of_a_small_swing() {
    let scene = hanging::Still::default();
    let rest = resting(&scene);
    let frequency = rest.vibrations[0].frequency();
    let mut start = rest.state.clone();
    start[0] += 1e-4;
    let swing = Question::of(std::sync::Arc::new(Bound::new(&scene))).from(start).until(4.0);
    let swing = swing.solve(&Settings::new(Method::Dop853).rtol(1e-12)).expect("it swings");
    // After whole periods it is where it began, and its speed changes its sign.
    let speed = |time: f64| swing.at(time).state[1];
    let (mut from, mut to) = (6.75 / frequency, 7.25 / frequency);
    for _ in 0..60 {
        let middle = 0.5 * (from + to);
        if speed(middle) > 0.0 { from = middle } else { to = middle }
    }
    let found = 7.0 / from;
    assert!((found / frequency - 1.0).abs() < 1e-8, "{found} {frequency}");
    assert_eq!(scene.run().expect("it rests").status(), Status::Complete);
}

#[test]
fn measures_of_a_rest_and_of_a_run_keep_apart() {
    let still = hanging::Damped::default().run().expect("it rests");
    let damping = still.measure("D").expect("a vibration");
    assert!(damping > 1e-3 && damping < 0.1, "{damping}");
    assert!((still.measure("angle").expect("an end").to_degrees() + 104.1147).abs() < 1e-3);
    assert!(still.estimated_error("pin.x").expect("an output") < 1e-12);
    let names: Vec<_> = hanging::Swings::default()
        .ask()
        .model()
        .shape()
        .measures
        .iter()
        .map(|one| one.name)
        .collect();
    assert_eq!(names, ["angle"]);
}

#[test]
fn what_goes_wrong_is_told() {
    let hangs = resting(&block::Hangs::default());
    assert!((hangs.state[0] - 0.15).abs() < 1e-16, "{hangs:?}");
    assert!((hangs.vibrations[0].angular - 10.0).abs() < 1e-13);
    let sticks = why(&block::Sticks::default());
    assert!(matches!(sticks, RestError::Sticks { .. }), "{sticks}");
    assert!(sticks.to_string().contains("rests all over a stretch"), "{sticks}");
    let kinked = resting(&block::Kinked::default());
    assert!(kinked.kink.is_some() && kinked.state[0].abs() < 1e-15, "{kinked:?}");
    let angular = kinked.vibrations[0].angular;
    assert!([10.0_f64, 20.0].iter().any(|side| (angular - side).abs() < 1e-13), "{kinked:?}");
    let falls = why(&block::Falls::default());
    assert!(matches!(falls, RestError::Unbalanced { name: "dot(x)", rate: 15.0 }), "{falls}");
    let stopped = why(&block::Stopped::default());
    assert!(matches!(stopped, RestError::Beyond { next: "held", is_lost: false, .. }), "{stopped}");
    let wheel = block::Wheel::default().run().expect("it rests where it is");
    assert_eq!(wheel.status(), Status::Indifferent { directions: 1 });
    assert_eq!(wheel.at(0.0).state, [0.02, 0.0]);
}

#[test]
fn where_the_equations_end_a_step_is_shortened() {
    // A whole step of Newton's method leads from 9 m to -3 m, where there is no root.
    let rest = resting(&root::Still::default());
    assert!((rest.state[0] - 1.0).abs() < 1e-14 && rest.errors[0] < 1e-12, "{rest:?}");
    assert!(rest.iterations > 3 && rest.evaluations.0 > rest.iterations, "{rest:?}");
    let through = why(&root::Through::default());
    assert!(matches!(through, RestError::Beyond { next: "near", .. }), "{through}");
    let error = root::Shakes::default().ask().resting().run().expect_err("it never rests");
    assert!(matches!(error, Error::NotAtRest(RestError::Driven { name: "dot(y)", .. })), "{error}");
}

#[test]
fn what_closures_hold_rests_where_the_reduced_one_does() {
    let scene = cartesian::Hangs::default();
    let held = scene.unreduced().expect("either coordinate may come to a dead point");
    for rest in [resting(&scene), resting(&held)] {
        let [one] = &rest.vibrations[..] else { panic!("{rest:?}") };
        let decay = 0.6 / (2.0 * 2.0);
        let angular = (9.81 / 0.7 - decay * decay).sqrt();
        assert!((one.rate + decay).abs() < 1e-12, "{one:?}");
        assert!((one.angular - angular).abs() < 1e-12, "{one:?}");
        assert!(rest.state[0].abs() < 1e-14, "{rest:?}");
    }
    let motion = held.run().expect("it rests");
    assert!((motion.value("y", 0.0).expect("a coordinate") + 0.7).abs() < 1e-14);
}

/// Five hinges of which one follows from the others: the rest that its specification derives, and half a small swing about it.
#[test]
fn a_spatial_loop_rests_and_vibrates() {
    let question = assur_equations::bricard::Fall::default().ask().resting();
    let motion = question.run().expect("it rests");
    for (name, expected) in [("P[3].x", 0.0), ("P[3].y", -0.75_f64.sqrt()), ("P[3].z", -0.5)] {
        let found = motion.value(name, 0.0).expect("it is reported");
        assert!((found - expected).abs() < 1e-12, "{name}: {found}");
    }
    let rest = motion.rest().expect("a position of rest");
    let [one] = &rest.vibrations[..] else { panic!("{rest:?}") };
    let n = motion.shape().coordinates;
    let mut start = rest.state.clone();
    for index in 0..n {
        start[n + index] = 1e-4 * one.shape[index].0;
    }
    let half = 0.5 / one.frequency();
    let fine = Settings::new(Method::Dop853).rtol(1e-12);
    let fall = assur_equations::bricard::Fall::default();
    let swing = fall.from(start).until(1.1 * half).solve(&fine).expect("it swings");
    let aside = |time: f64| swing.at(time).state[0] - rest.state[0];
    let (mut from, mut to) = (0.9 * half, 1.1 * half);
    for _ in 0..50 {
        let middle = 0.5 * (from + to);
        if aside(middle) * aside(0.9 * half) > 0.0 { from = middle } else { to = middle }
    }
    assert!((from / half - 1.0).abs() < 1e-5, "{from} {half}");
}

#[test]
fn a_rest_that_is_none_for_long_is_told() {
    let down = resting(&arm::Down::default());
    assert!((down.state[0].to_degrees() + 90.0).abs() < 1e-12);
    let slow = &down.vibrations[0];
    assert!((slow.angular - 2.0).abs() < 1e-14 && !slow.dies_out() && !slow.grows(), "{slow:?}");
    let fast = &down.vibrations[1];
    assert!((fast.rate + 0.25).abs() < 1e-13 && fast.dies_out());
    assert!((fast.angular - (9.81_f64 - 0.0625).sqrt()).abs() < 1e-13);
    let up = arm::Up::default().run().expect("it rests");
    let rate = -0.25 + (0.0625_f64 + 9.81).sqrt();
    assert!(
        matches!(up.status(), Status::Falls { rate: found } if (found - rate).abs() < 1e-12),
        "{:?}",
        up.status()
    );
    let far = resting(&arm::Still::default());
    assert!((far.state[0].to_degrees() - 90.0).abs() < 1e-10, "{far:?}");
}

#[test]
fn random_rows_vibrate_as_their_masses_and_springs_say() {
    let mut seed = 11_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        10f64.powf(4.0 * ((seed >> 11) as f64 / (1_u64 << 53) as f64) - 2.0)
    };
    for _ in 0..100 {
        let [m_1, m_2, m_3, k_1, k_2, k_3, f] = std::array::from_fn(|_| random());
        let scene = row::Still { m_1, m_2, m_3, k_1, k_2, k_3, F: f };
        let rest = resting(&scene);
        let expected = [f / k_1, f / k_1 + f / k_2, f / k_1 + f / k_2 + f / k_3];
        for ((found, expected), error) in rest.state.iter().zip(expected).zip(&rest.errors) {
            assert!((found - expected).abs() <= *error, "{found} {expected} {error:e}");
        }
        // Symmetric: M^(-1/2) K M^(-1/2).
        let k = nalgebra::Matrix3::new(
            k_1 + k_2,
            -k_2,
            0.0, //
            -k_2,
            k_2 + k_3,
            -k_3, //
            0.0,
            -k_3,
            k_3,
        );
        let roots = nalgebra::Vector3::new(m_1, m_2, m_3).map(|mass| 1.0 / mass.sqrt());
        let scaled =
            nalgebra::Matrix3::from_fn(|row, column| k[(row, column)] * roots[row] * roots[column]);
        let mut squares: Vec<f64> = scaled.symmetric_eigenvalues().iter().copied().collect();
        squares.sort_by(f64::total_cmp);
        let largest = squares[2];
        for (one, square) in rest.vibrations.iter().zip(squares) {
            let off = (one.angular - square.sqrt()).abs();
            // The symmetric way knows a square to rounding of the largest one.
            let rounding = 4.0 * f64::EPSILON * largest / square.sqrt();
            assert!(off <= one.error + rounding, "{off:e} {one:?}");
        }
    }
}
