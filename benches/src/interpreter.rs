//! Equation files run without being compiled, against the same compiled.

use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;
use std::time::Instant;

use assur::answer::{Method, Question, Settings};
use assur::closure::{AnyLinkage, Variable};
use assur::model::Model;
use assur::registry::{Bind, Mechanism};
use assur::shape::Distribution;
use assur::tolerance::{Sampling, Source, Study};
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

/// Linkages that are compared: the scene, and the place of the driver in radians.
const LINKAGES: [(&str, &str, f64); 2] =
    [("heald_linkage", "printed", FRAC_PI_2), ("dwell_six_bar", "standard", 1.0)];
/// Linkages made at random in one measurement, and half of their tolerances, SI units.
const SAMPLES: (u64, f64) = (20_000, 2e-5);
/// Positions of a way in one measurement, a part of a radian from each other.
const POSITIONS: (usize, f64) = (3600, 1e-4);
/// Largest ratio of a sample to one of compiled code.
const SAMPLE: f64 = 1.0;

/// A linkage with its own values.
fn linkage(mechanism: &Mechanism, scene: &str) -> Box<dyn AnyLinkage> {
    let entry = mechanism.scenes.iter().find(|entry| entry.name == scene).expect("a scene");
    let values: Vec<f64> = entry.constants.iter().map(|constant| constant.default).collect();
    match entry.bind {
        Bind::Linkage(bind) => bind(&values).expect("values that the file states"),
        Bind::Motion(_) => panic!("{scene} is a motion"),
    }
}

/// Nanoseconds of a linkage made at random, on one thread.
fn sample(linkage: &dyn AnyLinkage, place: f64) -> f64 {
    let variables = linkage.shape().loops().variables.iter().enumerate();
    let made = variables.filter(|(_, one)| matches!(one, Variable::Constant(_)));
    let (samples, half_width) = SAMPLES;
    let distribution = Distribution::Uniform;
    let sources = made.map(|(variable, _)| Source { variable, half_width, distribution });
    let study = Study { output: 0, places: vec![vec![place]], sources: sources.collect() };
    let sampling = Sampling { samples, threads: 1, ..Sampling::default() };
    let seconds = least(|| {
        black_box(linkage.monte_carlo(&study, &sampling, &|_| ()).expect("it assembles"));
    });
    1e9 * seconds / samples as f64
}

/// Nanoseconds of a position of a way, with all that is told of it.
fn position(linkage: &dyn AnyLinkage, place: f64) -> f64 {
    let (count, step) = POSITIONS;
    let places: Vec<Vec<f64>> = (0..count).map(|k| vec![place + step * k as f64]).collect();
    let seconds = least(|| {
        black_box(linkage.follow(&places).expect("it moves there"));
    });
    1e9 * seconds / count as f64
}

/// Prints the table of linkages.
fn linkages() {
    let columns =
        ["scene", "sample, ns", "compiled, ns", "ratio", "position, ns", "compiled, ns", "ratio"];
    let mut table = Table::new("Linkages without compiling", &columns);
    let mut judged = Vec::new();
    for (name, scene, place) in LINKAGES {
        let emitted = REGISTRY.iter().find(|one| one.name == name).expect("a mechanism");
        let both = [read(emitted, scene), emitted].map(|one| linkage(one, scene));
        let [own, compiled] = both.each_ref().map(|one| Some(sample(&**one, place)));
        let [moved, compiled_moved] = both.each_ref().map(|one| Some(position(&**one, place)));
        table.row([
            format!("{name} {scene}"),
            number(own),
            number(compiled),
            ratio(own, compiled),
            number(moved),
            number(compiled_moved),
            ratio(moved, compiled_moved),
        ]);
        judged.push((name, own, compiled));
    }
    table.print();
    for (name, own, compiled) in judged {
        verdict(&format!("{name}, sample"), own, compiled, SAMPLE);
    }
}

/// Prints the tables.
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
    linkages();
}
