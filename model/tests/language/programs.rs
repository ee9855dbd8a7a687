//! The operations that a file comes to.

use std::collections::BTreeSet;

use assur_model::program::{Function, OperationKind, Program, Stage, Step, Value};

use super::first_scene;

/// A sum waits for its slowest term alone: that is added last.
#[test]
fn what_takes_longest_is_added_last() {
    let text = "Sample; parameter a = 1 [1/s], b = 2 [1/s], c = 3 [1/s]; state x: 1 = 0, y: 1 = 0; \
                motion one: dot(x) = c + a*sin(y) - b*x; motion other: dot(y) = b*x; output x; \
                scene go { run time 0 s .. 1 s; }";
    let scene = first_scene(text);
    let program = &scene.program;
    let kind = |value: Value| &program.operations[value.0 as usize].kind;
    let OperationKind::MultiplyAdd(first, second, _) = kind(program.results.derivative[0]) else {
        panic!("{:?}", kind(program.results.derivative[0]));
    };
    let is_sine = |value: &Value| matches!(kind(*value), OperationKind::Call(Function::Sin, _));
    assert!(is_sine(first) || is_sine(second));
}

/// A mass that is pushed in the time, at a rate that is made of the constants, and turned by its own angle.
const PUSHED: &str = "Sample; parameter a = 1 [1/s], w = 2 [rad/s]; state x: rad = 0, y: 1 = 0; \
                      motion one: dot(x) = w*cos(x)*floor(y); \
                      motion other: dot(y) = a*sqrt(a/w*1 [rad])*(sin(w*time) + cos(w*time)) + a*sin(x); output x; \
                      scene go { run time 0 s .. 1 s; }";

fn is_call(program: &Program, value: Value, of: &[Function]) -> bool {
    matches!(program.kind(value), OperationKind::Call(function, _) if of.contains(function))
}

#[test]
fn what_is_of_an_earlier_stage_is_stored() {
    let program = first_scene(PUSHED).program;
    let staging = program.staging();
    let stages = |values: &BTreeSet<Value>| -> BTreeSet<Stage> {
        values.iter().map(|value| program.stage(*value)).collect()
    };
    assert_eq!(stages(&staging.prepared), BTreeSet::from([Stage::Parameter]));
    assert_eq!(stages(&staging.timed), BTreeSet::from([Stage::Instant]));
    assert!(!program.idle().always);
    // One sum of the sine and the cosine, and not these.
    assert_eq!(staging.timed.len(), 1);
}

#[test]
fn sines_of_one_angle_are_taken_together() {
    let program = first_scene(PUSHED).program;
    let needed = program.needed(&program.results.derivative, &|_| false);
    let levels = program.levels(&needed);
    let pairs: Vec<_> = levels.iter().flat_map(|level| program.pairs(&level.batch)).collect();
    assert_eq!(pairs.len(), 2, "{pairs:?}");
    for pair in pairs {
        for one in [pair.sine, pair.cosine] {
            assert_eq!(one.and_then(|one| program.angle(one)), Some(pair.angle));
        }
    }
}

/// An angle that grows evenly has a shorter recurrence, and what jumps is decided by the first terms.
#[test]
fn a_series_says_what_has_terms_and_what_is_decided() {
    let program = first_scene(PUSHED).program;
    let rates = &program.results.derivative;
    let series = program.series(rates).unwrap();
    let steps = series.steps(rates);
    let mut even: Vec<bool> = Vec::new();
    let mut decided = 0;
    for step in &steps {
        match step {
            Step::Pair(_, is_even) => even.push(*is_even),
            Step::Decided(value) => {
                assert!(series.is_steady(*value));
                decided += 1;
            }
            Step::Term(value) | Step::Factor(value) => {
                assert!(!series.is_steady(*value));
                assert!(!is_call(&program, *value, &[Function::Sin, Function::Cos]));
            }
        }
    }
    even.sort_unstable();
    // The floor, and what the constant makes of it.
    assert_eq!((even, decided), (vec![false, true], 2));
    assert!(series.operations() > steps.len());
}

/// Where the rates are sums and products of sines a step of the series need not be looked at in between.
#[test]
fn what_the_terms_of_a_series_may_not_tell_is_counted() {
    let unfelt = |rate: &str| {
        let text = format!(
            "Push from \"made up\";
            parameter k = 3;
            state x: 1 = 0.1, v: 1 = 1;
            let turn = 1[1/s]*time;
            motion one: dot(x) = v*cos(turn)*1[1/s];
            motion other: dot(v) = (k*x + {rate})*1[1/s];
            output x;
            scene go {{ run time 0 s .. 1 s; }}"
        );
        let program = first_scene(&text).program;
        let rates = &program.results.derivative;
        program.series(rates).unwrap().unfelt(rates)
    };
    for felt in [
        "sin(turn)",
        "-sign(v)",
        "abs(x)",
        "if v < 0 { -x } else { k*x }",
        "k*x*cos(2*turn)*v - x^3/k",
        "sin(x)*sin(v)*sin(turn)^2",
        "exp(k)*x",
    ] {
        assert_eq!(unfelt(felt), 0, "{felt}");
    }
    for hidden in ["tanh(x)", "1/(1 + x^2)", "sqrt(1 + x^2)", "sin(turn)^12", "exp(-x^2)"] {
        assert!(unfelt(hidden) > 0, "{hidden}");
    }
}
