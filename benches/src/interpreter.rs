//! Equation files run without being compiled, against the same compiled.

use std::hint::black_box;
use std::time::Instant;

use assur::answer::{Method, Question, Settings};
use assur::model::Model;
use assur::registry::{Bind, Mechanism};
use assur_equations::REGISTRY;
use assur_model::asked::Asked;

use crate::table::{Table, number, ratio, verdict};

/// Scenes that are compared.
const SCENES: [(&str, &str); 5] = [
    ("batten", "elastic"),
    ("batten", "exact"),
    ("presser_foot", "elliptic"),
    ("presser_foot", "machine"),
    ("table_drive", "table_1"),
];
/// Calls in one measurement.
const CALLS: usize = 20_000;
/// Measurements, of which the shortest counts.
const REPEATS: usize = 9;
/// Largest ratios to compiled code.
const GOALS: (f64, f64) = (3.0, 2.5);

/// The mechanism from its text, with one scene.
fn read(emitted: &Mechanism, scene: &str) -> &'static Mechanism {
    let again = assur_interpreter::again(emitted, Asked::Some(&[scene])).expect("tokens");
    Box::leak(Box::new(again.expect("a file without errors")))
}

/// A scene with its own values.
fn bound(mechanism: &Mechanism, scene: &str) -> Box<dyn Model> {
    let entry = mechanism.scenes.iter().find(|entry| entry.name == scene).expect("a scene");
    let values: Vec<f64> = entry.constants.iter().map(|constant| constant.default).collect();
    match entry.bind {
        Bind::Motion(bind) => bind(&values).expect("values that the file states"),
        Bind::Linkage(_) => panic!("{scene} is a linkage"),
    }
}

/// The shortest of several times, in seconds.
fn least(mut work: impl FnMut()) -> f64 {
    let times = (0..REPEATS).map(|_| {
        let clock = Instant::now();
        work();
        clock.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

/// Nanoseconds of an evaluation with its share of the instants of a step, as the steps of the explicit methods make them.
fn evaluation(model: &dyn Model) -> f64 {
    (0..REPEATS).map(|_| model.time_evaluation(CALLS)).fold(f64::INFINITY, f64::min)
}

/// Prints the table.
pub fn report() {
    let columns = [
        "scene",
        "read, ms",
        "evaluation, ns",
        "compiled, ns",
        "ratio",
        "run, us",
        "compiled, us",
        "ratio",
    ];
    let mut table = Table::new("Equation files without compiling", &columns);
    let mut judged = Vec::new();
    for (name, scene) in SCENES {
        let emitted = REGISTRY.iter().find(|one| one.name == name).expect("a mechanism");
        let reading = 1e3 * least(|| drop(black_box(bound(read(emitted, scene), scene))));
        let interpreted = read(emitted, scene);
        let [own, compiled] = [interpreted, emitted].map(|one| evaluation(&*bound(one, scene)));
        let [run, compiled_run] = [interpreted, emitted].map(|one| {
            let settings = Settings::new(Method::Dop853);
            1e6 * least(|| {
                let found = Question::of(bound(one, scene).into()).solve(&settings);
                black_box(found.is_ok());
            })
        });
        table.row([
            format!("{name} {scene}"),
            number(Some(reading)),
            number(Some(own)),
            number(Some(compiled)),
            ratio(Some(own), Some(compiled)),
            number(Some(run)),
            number(Some(compiled_run)),
            ratio(Some(run), Some(compiled_run)),
        ]);
        judged.push((format!("{name} {scene}"), [(own, compiled), (run, compiled_run)]));
    }
    table.print();
    for (scene, [evaluation, run]) in judged {
        verdict(&format!("{scene}, evaluation"), Some(evaluation.0), Some(evaluation.1), GOALS.0);
        verdict(&format!("{scene}, run"), Some(run.0), Some(run.1), GOALS.1);
    }
}
