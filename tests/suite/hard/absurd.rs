//! Values that no machine has.

use crate::solved::{accepts, bind, values};
use crate::stability::{Row, told};
use assur::registry::{Bind, SceneEntry};
use assur::shape::Constant;
use assur_equations::REGISTRY;

/// Every constant of every scene.
fn each(mut check: impl FnMut(&SceneEntry, &Constant)) {
    for scene in REGISTRY.iter().flat_map(|mechanism| mechanism.scenes) {
        scene.constants.iter().for_each(|constant| check(scene, constant));
    }
}

/// The refusal of a value names the constant and what is wrong with it.
#[track_caller]
fn check_refused(scene: &SceneEntry, constant: &Constant, value: f64) {
    let name = constant.quantity.name;
    match accepts(scene, &[(name, value)]) {
        Ok(()) => panic!("{}: {name} = {value} is accepted", scene.name),
        Err(refused) => {
            let text = refused.to_string();
            assert!(text.contains(name), "{}: {name} = {value}: {text}", scene.name);
            assert!(!refused.reason.is_empty());
        }
    }
}

#[test]
fn values_that_are_not_finite_are_refused_by_name() {
    each(|scene, constant| {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            check_refused(scene, constant, value);
        }
    });
}

#[test]
fn values_outside_their_range_are_refused_by_name() {
    let mut refused = 0;
    each(|scene, constant| {
        let (low, high) = constant.range;
        for value in [0.0, -constant.default, -1e300, 1e300] {
            if !(low..=high).contains(&value) {
                check_refused(scene, constant, value);
                refused += 1;
            }
        }
    });
    assert!(refused > 100, "{refused}");
    told(&Row {
        case: "Absurd parameters",
        tried: "each constant of each scene as 0, negative, 1e300 and -1e300 where its range forbids it, and as no number",
        naive: "numbers that are none, or wrong ones, at some later time".to_owned(),
        ours: format!("{refused} values refused by name and reason, and all that are not finite"),
        cost: "one comparison for each value".to_owned(),
    });
}

#[test]
fn sizes_and_masses_are_above_zero() {
    each(|scene, constant| {
        let name = constant.quantity.name;
        // An offset may have any sign.
        let is_size = constant.is_dimension && constant.range.0 >= 0.0;
        if is_size || matches!(name, "m1" | "m2" | "m3" | "m4" | "J2" | "c" | "n") {
            check_refused(scene, constant, 0.0);
            check_refused(scene, constant, -constant.default);
        }
    });
}

/// What is accepted can be evaluated, and has as many rates and outputs as it says.
#[test]
fn values_at_the_edge_of_their_range_do_no_harm() {
    each(|scene, constant| {
        let (low, high) = constant.range;
        for value in [low, high, 0.0, -constant.default, -1e300, 1e300] {
            let changes = [(constant.quantity.name, value)];
            if let (Bind::Linkage(_), Ok(())) = (scene.bind, accepts(scene, &changes)) {
                put_together(scene, &changes);
            }
            let Ok(run) = bind(scene, &changes) else {
                continue;
            };
            let state = vec![1e-3; scene.states.len()];
            assert_eq!(run.rates(0.1, &state).len(), scene.states.len());
            assert_eq!(run.outputs(0.1, &state).len(), scene.outputs.len());
        }
    });
}

/// A linkage of absurd dimensions is put together, or says why not.
fn put_together(scene: &SceneEntry, changes: &[(&str, f64)]) {
    let run = scene.bind.linkage(&values(scene, changes)).unwrap();
    let place: Vec<f64> = run.ranges().iter().map(|range| range.to).collect();
    match run.follow(&[place]) {
        Ok(path) => {
            // An output may be infinite, as a radius of curvature is on a straight line; a position may not.
            let reached = path.samples.iter().flat_map(|sample| &sample.dependents);
            assert!(reached.into_iter().all(|value| value.is_finite()));
            assert!(path.stopped.is_some() || path.samples.len() == 1);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
