//! The emitted code against the evaluator of the language: both run the same program, one as compiled Rust. On numbers
//! that take their functions from the standard library, as the evaluator does, they agree to the last bits.
#![allow(missing_docs, reason = "what is tested is the emitted code")]

#[path = "evaluator/functions.rs"]
mod functions;
#[path = "evaluator/standard.rs"]
mod standard;

use assur::problem::{Equations, Events, Phase, Reports, Scene, Span};
use assur::registry::Mechanism;
use assur::shape::Shape;
use assur_model::checked::SceneModel;
use assur_model::flatten::Wanted;
use assur_model::lexer;
use assur_model::program::{Program, Value, Values};
use standard::Standard;

/// Largest difference as a share of the value: two units in the last place.
const DIFFERENCE: f64 = 4.5e-16;
/// Sets of values, times and states that each scene is tried with.
const TRIALS: usize = 20;

/// The scene as the compiler has it.
fn compiled(mechanism: &Mechanism, name: &str) -> SceneModel {
    let tokens = |text: &str| lexer::lex_file(text).expect("the file can be read").tokens;
    let mut part = |wanted: &Wanted| {
        let mut parts = mechanism.parts.iter();
        let found = parts.find(|(path, _)| *path == wanted.path);
        Ok(tokens(found.expect("the part is carried along").1))
    };
    let model = assur_model::compile_with(&tokens(mechanism.text), &mut part).model;
    let scenes = model.expect("the file has no mistake").scenes;
    let found = scenes.into_iter().find(|scene| scene.name == name);
    found.expect("the file has the scene")
}

/// Numbers between -1 and 1, the same in every run.
struct Scatter(u64);

impl Scatter {
    fn next(&mut self) -> f64 {
        let odd = 6_364_136_223_846_793_005;
        self.0 = self.0.wrapping_mul(odd).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

#[track_caller]
fn check(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let is_same = found == expected || found.is_nan() && expected.is_nan();
        assert!(
            is_same || (found - expected).abs() <= DIFFERENCE * expected.abs(),
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
        let scene = from_values(&values);
        let state: Vec<f64> =
            scene.shape().scales.iter().map(|scale| scale * scatter.next()).collect();
        compare_at(model, &scene, &values, time, &state);
    }
}

/// Compares all modes at a time and state, and what depends on no mode.
fn compare_at<C: Scene>(model: &SceneModel, scene: &C, values: &[f64], time: f64, state: &[f64]) {
    let programs: Vec<&Program> = match model.modes.as_slice() {
        [] => vec![&model.program],
        modes => modes.iter().map(|mode| &mode.program).collect(),
    };
    let here: Vec<Standard> = state.iter().map(|value| Standard(*value)).collect();
    let equations = scene.prepare::<Standard>();
    for (mode, program) in programs.into_iter().enumerate() {
        let place = Place {
            mode,
            time: Standard(time),
            state: &here,
            expected: program.evaluate(values, time, state),
            program,
        };
        place.compare(scene.shape(), &equations);
        if let Some(events) = C::events(&equations) {
            place.compare_events(scene.shape(), events);
        }
    }
    let results = &model.program.results;
    let expected = model.program.evaluate(values, time, state);
    let mut drivers = vec![Standard(f64::NAN); scene.shape().drivers.len()];
    equations.drivers(Standard(time), &mut drivers);
    check(&numbers(&drivers), &expected.all(&results.drivers), "driver");
    check(&scene.start(), &expected.all(&results.start), "start");
    let span = match scene.span() {
        Span::Periodic(period) => vec![period],
        Span::Run(from, to) => vec![from, to],
        Span::Open | Span::Rest | Span::Autonomous => Vec::new(),
    };
    check(&span, &expected.all(&results.span), "time of the task");
}

/// A mode at a time and state, evaluated.
struct Place<'a> {
    mode: usize,
    time: Standard,
    state: &'a [Standard],
    program: &'a Program,
    expected: Values,
}

impl Place<'_> {
    /// Compares rates, Jacobian and outputs.
    fn compare<E: Equations<Standard> + Reports<Standard>>(&self, shape: &Shape, equations: &E) {
        let (results, phase) = (&self.program.results, Phase::of(self.mode));
        let mut instant = vec![Standard(0.0); equations.instant()];
        equations.instants(phase, &[self.time], &mut instant);
        let mut rates = self.state.to_vec();
        equations.rates(phase, &instant, self.state, &mut rates);
        check(&numbers(&rates), &self.expected.all(&results.derivative), "rate");

        let states = self.state.len();
        let mut slopes = vec![Standard(0.0); states * states];
        equations.jacobian(phase, &instant, self.state, &mut slopes);
        let mut jacobian = vec![0.0; states * states];
        for (row, column, value) in &results.jacobian {
            jacobian[*column as usize * states + *row as usize] = self.expected.get(*value);
        }
        check(&numbers(&slopes), &jacobian, "slope");

        let mut outputs = vec![Standard(f64::NAN); shape.outputs.len()];
        equations.outputs(phase, self.time, self.state, &mut outputs);
        check(&numbers(&outputs), &self.expected.all(&results.outputs), "output");
    }

    /// Compares guards, conditions and jumps.
    fn compare_events(&self, shape: &Shape, events: &dyn Events<Standard>) {
        let (phase, all) = (Phase::of(self.mode), &self.program.results.events);
        let entry = &shape.modes[self.mode];
        let nothing = vec![Standard(f64::NAN); entry.written()];
        let (mut values, mut rates) = (nothing.clone(), nothing);
        events.guards(phase, self.time, self.state, &mut values, &mut rates);
        let expected: Vec<Value> = all.iter().map(|event| event.guard).collect();
        check(&numbers(&values), &self.expected.all(&expected), "guard");
        let expected: Vec<Value> = all.iter().map(|event| event.rate).collect();
        check(&numbers(&rates), &self.expected.all(&expected), "rate of a guard");
        for (event, statement) in all.iter().enumerate() {
            if let Some(condition) = statement.condition {
                let permits = events.permits(phase, event, self.time, self.state);
                assert_eq!(permits, self.expected.get(condition) != 0.0, "condition");
            }
            if !statement.after.is_empty() {
                let mut after = self.state.to_vec();
                events.jump(phase, event, self.time, self.state, &mut after);
                check(&numbers(&after), &self.expected.all(&statement.after), "state after");
            }
        }
    }
}

/// A test for each scene of a module.
macro_rules! scenes {
    ($module:ident: $($name:ident $kind:ident),*) => {$(
        #[test]
        fn $name() {
            let model = super::compiled(&assur_equations::$module::MECHANISM, stringify!($name));
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

mod table_drive {
    scenes! {
        table_drive: table_1 Table1, balance Balance, full Full, constant Constant, kloss Kloss, transient Transient,
        switched Switched, loose Loose, loose_switched LooseSwitched
    }
}

mod presser_foot {
    scenes! {
        presser_foot: elliptic Elliptic, straight Straight, progressive Progressive, five_harmonics FiveHarmonics,
        machine Machine, machine_harmonics MachineHarmonics, hunt_crossley HuntCrossley, recovering Recovering
    }
}

mod needle_impact {
    scenes! {
        needle_impact: selected Selected, selected_full SelectedFull, rubbing Rubbing, made Made, unselected Unselected,
        unselected_free UnselectedFree, caught_up CaughtUp
    }
}
