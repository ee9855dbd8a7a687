//! What follows from a condition follows as in the interpreter.

use std::ops::ControlFlow;

use assur::prelude::*;
use assur::study::{Design, seek};
use assur::synthesis::Effort;

assur::mechanism! {
    /// The straight line that is nearest to a curve, by squares.
    Line from "closed form";
    parameter a = 0 in -5 .. 5, b = 0 in -5 .. 5, k = 0.5 in 0 .. 1;
    driver x in 0 .. 1;
    output y = a + b*x;
    scene best {
        sweep x;
        vary k;
        solve for a, b: a + b*x = exp(x);
        minimise rms(a + b*x - exp(x)) + (k - 0.25)^2;
    }
}

/// `a = 4e - 10`, `b = 18 - 6e`, to what 72 places leave of an integral.
#[test]
fn a_line_follows_from_a_curve() {
    let scene = &MECHANISM.scenes[0];
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let design = Design::of(scene, &values, &Settings::default()).expect("it seeks");
    assert_eq!(design.synthesis().chosen(), 1);
    let effort = Effort { evaluations: 400, ..Effort::default() };
    let mut stand = assur::study::Stand::default();
    let mut go = |stand: &assur::study::Stand| match stand.over {
        0 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let found = seek(&design, &effort, 1, &mut stand, &mut go).expect("it makes sense");
    let [k, a, b] = found[0].design[..] else { panic!("{found:?}") };
    let e = std::f64::consts::E;
    assert!((k - 0.25).abs() < 1e-3, "{found:?}");
    assert!(
        (a - (4.0 * e - 10.0)).abs() < 1e-4 && (b - (18.0 - 6.0 * e)).abs() < 1e-4,
        "{found:?}"
    );
}
