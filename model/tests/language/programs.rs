//! The operations that a file comes to.

use assur_model::program::{Function, OperationKind, Value};

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
