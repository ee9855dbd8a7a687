//! The emitted code against the evaluator of the language: both run the same program, one as compiled Rust. On numbers
//! that take their functions from the standard library, as the evaluator does, they agree to the last bits.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

#[path = "evaluator/functions.rs"]
mod functions;
#[path = "evaluator/standard.rs"]
mod standard;

use assur::problem::{Equations, Phase, Reports, Scene, Span};
use assur_model::checked::SceneModel;
use assur_model::lexer;
use standard::Standard;

/// Largest difference as a share of the value: two units in the last place.
const DIFFERENCE: f64 = 4.5e-16;
/// Sets of values, times and states that each scene is tried with.
const TRIALS: usize = 20;

/// The scene as the compiler has it.
fn compiled(text: &str, name: &str) -> SceneModel {
    let lexed = lexer::lex_file(text).expect("the file can be read");
    let model = assur_model::compile(&lexed.tokens).model;
    let scenes = model.expect("the file has no mistake").scenes;
    let found = scenes.into_iter().find(|scene| scene.name == name);
    found.expect("the file has the scene")
}

/// Numbers between -1 and 1, the same in every run.
struct Scatter(u64);

impl Scatter {
    fn next(&mut self) -> f64 {
        let odd = 6_364_136_223_846_793_005;
        self.0 = self
            .0
            .wrapping_mul(odd)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

#[track_caller]
fn check(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!(
            (found - expected).abs() <= DIFFERENCE * expected.abs(),
            "{what} {index}: emitted {found:e}, evaluated {expected:e}"
        );
    }
}

fn numbers(values: &[Standard]) -> Vec<f64> {
    values.iter().map(|value| value.0).collect()
}

/// Compares everything that both compute.
#[track_caller]
fn compare<C: Scene>(model: &SceneModel, from_values: impl Fn(&[f64]) -> C) {
    let mut scatter = Scatter(1);
    for _ in 0..TRIALS {
        let values: Vec<f64> = model
            .constants
            .iter()
            .map(|constant| constant.default * (1.0 + 0.05 * scatter.next()))
            .collect();
        let time = scatter.next();
        let state: Vec<f64> = C::shape()
            .scales
            .iter()
            .map(|scale| scale * scatter.next())
            .collect();
        compare_at(model, &from_values(&values), &values, time, &state);
    }
}

fn compare_at<C: Scene>(model: &SceneModel, scene: &C, values: &[f64], time: f64, state: &[f64]) {
    let results = &model.program.results;
    let expected = model.program.evaluate(values, time, state);
    let (equations, phase) = (scene.prepare::<Standard>(), Phase::of(0));
    let here: Vec<Standard> = state.iter().map(|value| Standard(*value)).collect();
    let mut instant = vec![Standard(0.0); equations.instant()];
    equations.instants(phase, &[Standard(time)], &mut instant);
    let mut rates = here.clone();
    equations.rates(phase, &instant, &here, &mut rates);
    check(&numbers(&rates), &expected.all(&results.derivative), "rate");

    let states = state.len();
    let mut slopes = vec![Standard(0.0); states * states];
    equations.jacobian(phase, &instant, &here, &mut slopes);
    let mut jacobian = vec![0.0; states * states];
    for (row, column, value) in &results.jacobian {
        jacobian[*column as usize * states + *row as usize] = expected.get(*value);
    }
    check(&numbers(&slopes), &jacobian, "slope");

    let mut outputs = vec![Standard(f64::NAN); C::shape().outputs.len()];
    equations.outputs(phase, Standard(time), &here, &mut outputs);
    check(
        &numbers(&outputs),
        &expected.all(&results.outputs),
        "output",
    );
    let mut drivers = vec![Standard(f64::NAN); C::shape().drivers.len()];
    equations.drivers(Standard(time), &mut drivers);
    check(
        &numbers(&drivers),
        &expected.all(&results.drivers),
        "driver",
    );
    check(&scene.start(), &expected.all(&results.start), "start");
    let span = match scene.span() {
        Span::Periodic(period) => vec![period],
        Span::Run(from, to) => vec![from, to],
        Span::Open | Span::Autonomous => Vec::new(),
    };
    check(&span, &expected.all(&results.span), "time of the task");
}

/// A test for each scene of a module.
macro_rules! scenes {
    ($module:ident: $($name:ident $kind:ident),*) => {$(
        #[test]
        fn $name() {
            let model = super::compiled(assur_equations::$module::TEXT, stringify!($name));
            super::compare(&model, |values| {
                let values = values.try_into().expect("as many values as constants");
                assur_equations::$module::$kind::from_values(values)
            });
        }
    )*};
}

mod batten {
    scenes! {
        batten: elastic Elastic, rigid Rigid, torsion Torsion, bending Bending, uncoupled Uncoupled,
        first_order FirstOrder, nonlinear Nonlinear, exact Exact, harmonic Harmonic, damped Damped, start Start
    }
}

mod batten_table {
    scenes! { batten_table: table Table, identity Identity }
}
