//! Positions and influence coefficients against `tests/reference/linkages.json`, which another program in another
//! language has computed from meeting circles and differences at 60 digits.

use crate::solved::{entry, values};
use assur::closure::Variable;
use assur::registry::SceneEntry;
use serde_json::Value;

/// Largest deviation of a position, in degrees or mm.
const POSITION: f64 = 1e-11;
/// Largest deviation of a derivative, as a share of the largest by the same variable.
const DERIVATIVE: f64 = 1e-11;

fn cases() -> Vec<Value> {
    let text = include_str!("../../reference/linkages.json");
    serde_json::from_str(text).unwrap()
}

fn number(value: &Value) -> f64 {
    let text = value.as_str().map(str::to_owned);
    text.unwrap_or_else(|| value.to_string()).parse().unwrap()
}

/// SI value of a degree or a millimetre, whichever the quantity of this unit is given in.
fn factor(unit: &str) -> f64 {
    match unit {
        "deg" | "rad" | "" => std::f64::consts::PI / 180.0,
        _ => 1e-3,
    }
}

/// The positions of all drivers where the case has them, SI units.
fn place(scene: &SceneEntry, case: &Value, at: f64) -> Vec<f64> {
    let position = |driver: &assur::shape::Quantity| {
        let is_swept = case["driver"] == driver.name;
        let degrees = if is_swept { at } else { number(&case["still"][driver.name]) };
        degrees.to_radians()
    };
    scene.drivers.iter().map(position).collect()
}

/// The variables of a scene with their names and what they are given in.
fn variables(scene: &SceneEntry) -> Vec<(String, f64)> {
    let linkage = scene.linkage.unwrap();
    let name = |variable: &Variable| match *variable {
        Variable::Constant(index) => scene.constants[index].quantity,
        Variable::Driver(index) => scene.drivers[index],
    };
    let named = linkage.variables.iter().map(name);
    named.map(|one| (one.name.to_owned(), factor(one.unit))).collect()
}

#[test]
fn positions_are_those_of_another_program() {
    for case in cases() {
        let scene = entry(case["mechanism"].as_str().unwrap(), case["scene"].as_str().unwrap());
        let run = scene.bind.linkage(&values(scene, &[])).unwrap();
        let mut compared = 0;
        for expected in case["places"].as_array().unwrap() {
            let at = place(scene, &case, number(&expected["place"]));
            let path = run.follow(&[at]).unwrap();
            assert_eq!(path.stopped, None, "{}", scene.name);
            for (name, value) in expected["outputs"].as_object().unwrap() {
                let index = scene.outputs.iter().position(|one| one.name == name).unwrap();
                let found = path.samples[0].outputs[index] / factor(scene.outputs[index].unit);
                let off = (found - number(value)).abs();
                assert!(
                    off <= POSITION,
                    "{} {} {name}: off by {off:e}",
                    case["mechanism"],
                    expected["place"]
                );
                compared += 1;
            }
        }
        assert!(compared >= 8, "{compared}");
    }
}

#[test]
fn influence_coefficients_are_those_of_another_program() {
    for case in cases() {
        let scene = entry(case["mechanism"].as_str().unwrap(), case["scene"].as_str().unwrap());
        let run = scene.bind.linkage(&values(scene, &[])).unwrap();
        let variables = variables(scene);
        let mut compared = 0;
        for expected in case["places"].as_array().unwrap() {
            let at = place(scene, &case, number(&expected["place"]));
            let found = run.influence(&at).unwrap();
            for (column, (name, unit)) in variables.iter().enumerate() {
                let Some(expected) = expected["derivatives"][name].as_object() else {
                    continue;
                };
                let scale = expected.values().map(|one| number(one).abs()).fold(0.0, f64::max);
                for (output, value) in expected {
                    let row = scene.outputs.iter().position(|one| one.name == output).unwrap();
                    let own = found[row * variables.len() + column] * unit
                        / factor(scene.outputs[row].unit);
                    let off = (own - number(value)).abs();
                    assert!(
                        off <= DERIVATIVE * scale.max(1e-6),
                        "{} {output} by {name}: off by {off:e} of {scale:e}",
                        case["mechanism"]
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared >= 40, "{}: {compared}", scene.name);
    }
}
