//! What is found of a formula over a range: values and derivatives against closed forms, and what is said of mistakes.

use std::f64::consts::{E, PI};

use assur_model::program::OperationKind;

use super::{check, first_scene};

/// The last output of a formula sheet at `p = 0.7`, `q = 2 m`.
#[track_caller]
fn value(output: &str) -> f64 {
    let text = format!(
        "Sheet; parameter p = 0.7, q = 2 m, w = 3; let f(a) = integral(a*y^2, y, 0 .. 1); output p, q, z = f(1); output y = {output}; scene s {{ sweep w 1 .. 4; }}"
    );
    let scene = first_scene(&text);
    let parameters: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let places = assur_model::program::Configuration { drivers: &[3.0], ..Default::default() };
    let values = scene.program.evaluate_linkage(&parameters, 0.0, &places);
    values.get(*scene.program.results.outputs.last().unwrap())
}

#[track_caller]
fn is(output: &str, expected: f64) {
    near(output, expected, 4e-15);
}

#[track_caller]
fn near(output: &str, expected: f64, rtol: f64) {
    let found = value(output);
    let error = (found - expected).abs();
    assert!(error <= rtol * (1.0 + expected.abs()), "{output}: {found}, not {expected}: {error:e}");
}

#[test]
fn integrals_have_their_values() {
    is("integral(exp(x), x, 0 .. 1)", E - 1.0);
    is("integral(x^2, x, p .. 2)", (8.0 - 0.343) / 3.0);
    is("integral(x, x, 0 m .. q)/(1 [m^2])", 2.0);
    is("integral(q, x, 1 .. 3)/(1 m)", 4.0);
    is("f(p)", 0.7 / 3.0);
    is("integral(integral(x*y, y, 0 .. x), x, 0 .. 2)", 2.0);
    is("integral(f(t)*t, t, 0 .. 1)", 1.0 / 9.0);
    is("integral(w*x, x, 0 .. w)", 13.5);
    // Conditions that the variable does not change.
    is("integral(if w < 5 { x } else { 2*x }, x, 0 .. 1)", 0.5);
    is("integral(if w < 5 && !(w < 2) { x } else { 2*x }, x, 0 .. 1)", 0.5);
    is("integral(if w < 2 || x < w/6 { x } else { 2*x }, x, 0 .. 1)", 0.125 + 0.75);
    is("sum(k in 1..3, integral(x^k, x, 0 .. 1))", 0.5 + 1.0 / 3.0 + 0.25);
}

/// What is infinite at an end is known to rounding, whichever end that is, and wherever it lies.
#[test]
fn integrals_may_be_singular_at_their_ends() {
    near("integral(1/sqrt(x), x, 0 .. p)", 2.0 * 0.7f64.sqrt(), 1e-14);
    near("integral(1/sqrt(p - x), x, 0 .. p)", 2.0 * 0.7f64.sqrt(), 1e-14);
    near("integral(1/sqrt(p - x), x, 0 .. min(p, 1))", 2.0 * 0.7f64.sqrt(), 1e-14);
    near("integral(1/sqrt((x - p)*(w - x)), x, p .. w)", PI, 1e-13);
    near("integral(ln(x), x, 0 .. 1)", -1.0, 1e-14);
}

#[test]
fn limits_may_coincide_and_be_exchanged() {
    is("integral(exp(x), x, p .. p)", 0.0);
    is("integral(exp(x), x, 1 .. 0)", 1.0 - E);
    is("diff(integral(exp(x), x, 0.7 .. p), p)", 0.7f64.exp());
}

#[test]
fn integrands_may_jump() {
    near("integral(if x < p { 1 } else { 3 }, x, 0 .. 1)", 0.7 + 0.9, 1e-13);
    near("integral(abs(x - p), x, 0 .. 1)", 0.29, 1e-14);
}

/// Leibniz' rule: limits, integrand and both.
#[test]
fn integrals_are_differentiated() {
    is("diff(integral(x^2, x, 0 .. p), p)", 0.49);
    is("diff(integral(x^2, x, p .. 1), p)", -0.49);
    is("diff(integral(exp(x), x, p .. p^2), p)", 1.4 * 0.49f64.exp() - 0.7f64.exp());
    is("diff(diff(integral(exp(x), x, 0 .. p^2), p), p)", (2.0 + 4.0 * 0.49) * 0.49f64.exp());
    is("diff(integral(ln(x), x, 0 .. p), p)", 0.7f64.ln());
    is("diff(integral(1/x, x, p .. p), p)", 0.0);
    is("diff(integral(sin(p*x), x, 0 .. 1), p)", 0.7f64.sin() / 0.7 + (0.7f64.cos() - 1.0) / 0.49);
    is("diff(integral(p*x, x, 0 .. p), p)", 1.5 * 0.49);
    // The naive rule is infinite at the limit and cannot be integrated inside.
    near("diff(integral(1/sqrt(p - x), x, 0 .. p), p)", 1.0 / 0.7f64.sqrt(), 1e-13);
    near("diff(integral(exp(x)/sqrt(p - x), x, 0 .. min(p, 1)), p)", 3.919578758642508, 1e-14);
    is(
        "diff(integral(integral(p*y, y, 0 .. x), x, 0 .. p), p)",
        0.7f64.powi(3) / 6.0 + 0.7f64.powi(3) / 2.0,
    );
}

/// Where only the ends change nothing is left to be integrated.
#[test]
fn the_slope_by_an_end_is_the_formula_there() {
    let text = "Sheet; parameter p = 0.7; output y = diff(integral(exp(-x^2), x, 0 .. p), p); scene s { sweep p 0 .. 1; }";
    let operations = first_scene(text).program.operations;
    let is_search = |kind: &OperationKind| matches!(kind, OperationKind::Search { .. });
    let before = operations.iter().take_while(|one| !is_search(&one.kind)).count();
    assert_eq!(before, operations.len(), "{operations:?}");
}

#[test]
fn roots_have_their_values_and_derivatives() {
    is("solve(x in 0 .. 2, x^2 = p)", 0.7f64.sqrt());
    is("root(cos(x) - x, x, 0 .. 1)", 0.7390851332151607);
    is("solve(x in 0 m .. 5 m, x^2 = q*(2 m))/(1 m)", 2.0);
    is("diff(solve(x in 0 .. 2, x^2 = p), p)", 0.5 / 0.7f64.sqrt());
    is("diff(diff(solve(x in 0 .. 2, x^2 = p), p), p)", -0.25 * 0.7f64.powf(-1.5));
    is("diff(solve(x in 0 .. p + 1, integral(y, y, 0 .. x) = p), p)", 1.0 / 1.4f64.sqrt());
    assert!(value("solve(x in 2 .. 3, x^2 = p)").is_nan());
    assert!(value("solve(x in 0 .. 1, (x - p)^2 = 0)").is_nan());
}

#[test]
fn peaks_have_their_values_places_and_derivatives() {
    is("peak(x*(p - x), x, 0 .. 1)", 0.1225);
    near("peak_at(x*(p - x), x, 0 .. 1)", 0.35, 1e-13);
    is("lowest(x*(x - p), x, 0 .. 1)", -0.1225);
    near("lowest_at(x*(x - p), x, 0 .. 1)", 0.35, 1e-13);
    is("peak(x, x, 0 .. p)", 0.7);
    is("diff(peak(x*(p - x), x, 0 .. 1), p)", 0.35);
    near("diff(diff(peak(x*(p - x), x, 0 .. 1), p), p)", 0.5, 1e-12);
    near("diff(peak_at(x*(p - x), x, 0 .. 1), p)", 0.5, 1e-12);
    // At a kink the top stays.
    is("diff(peak_at(p*x - abs(x - 0.4), x, 0 .. 1), p)", 0.0);
    is("diff(diff(peak(p*x - 3*abs(x - 0.4), x, 0 .. 1), p), p)", 0.0);
    near("diff(peak(p*x - 3*abs(x - 0.4), x, 0 .. 1), p)", 0.4, 1e-7);
    is("diff(peak(x, x, 0 .. p), p)", 1.0);
    is("diff(peak_at(x, x, 0 .. p), p)", 1.0);
}

#[test]
fn mistakes_in_searches_are_explained() {
    let sheet = |output: &str| {
        format!(
            "Sheet; parameter p = 1, q = 2 m; output y = {output}; scene s {{ sweep p 0 .. 1; }}"
        )
    };
    for (output, expected) in [
        ("integral(x, x, 0 .. q + p)", &[("adds or subtracts a length", "q + p", "")]),
        ("integral(x, x, 0 .. p) + q", &[("adds or subtracts", "integral(x, x, 0 .. p) + q", "")]),
        ("integral(x, x, 1 m .. p)", &[("the ends of the range are", "1 m .. p", "")]),
        ("integral(x + q, x, 0 .. 1)", &[("adds or subtracts", "x + q", "")]),
        ("root(p, x, 0 .. 1)", &[("`x` does not occur", "p", "")]),
        ("solve(x in 0 .. 1, x = q)", &[("adds or subtracts", "x = q", "")]),
        ("integral(z, x, 0 .. 1)", &[("there is no `z`", "z", "")]),
        ("integral([x, x], x, 0 .. 1)", &[("a number is expected", "[x, x]", "")]),
        ("diff(integral(sign(x - p), x, 0 .. 1), p)", &[("jump", "sign(x - p)", "")]),
    ] {
        check(&sheet(output), &expected[..]);
    }
}

/// Where a condition on what is swept does not hold there are no values, and the margin says by how much.
#[test]
fn conditions_on_what_is_swept_take_the_values_away() {
    let text = "Sheet; parameter p = 1 in 0 .. 3, q = 2; require p < q \"too far\"; output y = p^2; scene s { sweep p; }";
    let scene = first_scene(text);
    assert_eq!(scene.outputs[1].name, "margin of p < q");
    assert_eq!(scene.outputs[1].summary, "too far");
    let at = |p: f64| {
        let places = assur_model::program::Configuration { drivers: &[p], ..Default::default() };
        let values = scene.program.evaluate_linkage(&[2.0], 0.0, &places);
        values.all(&scene.program.results.outputs)
    };
    assert_eq!(at(1.5), [2.25, 0.5]);
    let beyond = at(2.5);
    assert!(beyond[0].is_nan() && beyond[1] == -0.5, "{beyond:?}");
}
