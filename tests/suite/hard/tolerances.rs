//! Absolute tolerances of the states: a state that is far smaller than its scale decides about the others.

use assur::answer::{Method, Settings};
use assur::ode;
use assur::problem::Scene;

mod kinetics {
    assur::mechanism! {
        /// Three reactions of very different speeds.
        Robertson from "Hairer, Wanner: Solving ordinary differential equations II, (IV.10.2)";
        parameter T = 1 s;
        state y1: 1 = 1, y2: 1 = 0, y3: 1 = 0;
        motion T*dot(y1) = -0.04*y1 + 1e4*y2*y3;
        motion T*dot(y2) = 0.04*y1 - 1e4*y2*y3 - 3e7*y2^2;
        motion T*dot(y3) = 3e7*y2^2;
        output y1, y2, y3;
        scene long "until nearly all has reacted" { run time 0 s .. 1e11 s; }
    }
}

/// The relative error of what is left of the first substance at the end.
fn error(settings: &Settings) -> f64 {
    let scene = kinetics::Long::default();
    let motion = ode::march(&scene, (0.0, 1e11), &scene.start(), settings).unwrap();
    (motion.at(1e11)[0] / 2.083_340_149_701_255e-8 - 1.0).abs()
}

#[test]
fn states_far_below_their_scale_have_tolerances_of_their_own() {
    for (method, usual, given) in
        [(Method::Rosenbrock, 1.1e-5, 3.8e-9), (Method::Radau, 8.5e-9, 3.6e-12)]
    {
        let settings = Settings::new(method).rtol(1e-8);
        let fine = Settings { atol: vec![Some(1e-18); 3], ..settings.clone() };
        let errors = [settings, fine].map(|settings| error(&settings));
        let shares = [errors[0] / usual, errors[1] / given];
        assert!(shares.iter().all(|share| (0.3..3.0).contains(share)), "{method:?}: {errors:?}");
    }
}

#[test]
fn absolute_tolerances_follow_the_relative_one() {
    let settings =
        Settings { atol: vec![None, Some(1e-12)], ..Settings::new(Method::Radau).rtol(1e-8) };
    let finer = settings.at(1e-9);
    assert_eq!(finer.rtol, 1e-9);
    let atol = finer.atol[1].unwrap();
    assert!((atol / 1e-13 - 1.0).abs() < 1e-12, "{atol:e}");
    assert_eq!(finer.atol[0], None);
}

#[test]
fn a_run_of_more_steps_than_permitted_ends_with_an_error() {
    let settings = Settings { max_steps: Some(20), ..Settings::new(Method::Radau).rtol(1e-8) };
    let scene = kinetics::Long::default();
    let end = ode::march(&scene, (0.0, 1e11), &scene.start(), &settings);
    assert!(matches!(end, Err(ode::OdeError::TooManySteps { .. })), "{end:?}");
}
