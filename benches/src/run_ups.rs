//! A thousand run-ups of the table drive with different parameters, on one thread and on two.
//!
//! Runs know nothing of each other, so two cores should be nearly twice as fast as one. How far this machine lets two
//! threads be that is measured beside, by a hand-written loop without heap. On a machine with other work to do neither
//! gets both cores for long. The processor time tells then: two threads that take as much of it together as one takes
//! alone do not get in each other's way, and would be twice as fast on two cores that have nothing else to do.

use std::hint::black_box;
use std::time::Instant;

use assur::answer::{Method, Settings};
use assur::hybrid::{self, Motion};
use assur::problem::Scene;
use assur::registry::SceneEntry;
use assur::study::{self, Outcome};
use assur_equations::table_drive::{MECHANISM, Table1};

use crate::count::{Case, measure};
use crate::foot::{PERIOD, START};
use crate::hand_foot::Foot;
use crate::hand_run_up::{self, Drive, RunUp};
use crate::hand_walk;
use crate::table::{Table, at_least, number, power, ratio};

/// Runs, `COLUMNS` inertias of the table by as many stiffnesses as it takes.
const RUNS: usize = 1000;
const COLUMNS: usize = 40;
const ROUNDS: usize = 9;
/// End of a run-up, in seconds.
const END: f64 = 0.1;
/// Least speed of two threads in that of one.
const GOAL: f64 = 1.9;
const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-9);

fn scene() -> &'static SceneEntry {
    let mut scenes = MECHANISM.scenes.iter();
    let found = scenes.find(|scene| scene.name == "table_1");
    found.expect("the table drive has the scene")
}

/// The values of a run: inertia of the table from half its value to twice it, stiffness likewise.
fn values(scene: &SceneEntry, run: usize) -> Vec<f64> {
    let part =
        |index: usize, count: usize| 2f64.powf(2.0 * index as f64 / (count - 1) as f64 - 1.0);
    let constants = scene.constants.iter();
    let value = constants.map(|one| match one.quantity.name {
        "J2" => one.default * part(run % COLUMNS, COLUMNS),
        "c" => one.default * part(run / COLUMNS, RUNS / COLUMNS),
        _ => one.default,
    });
    value.collect()
}

/// All run-ups.
fn run_ups(threads: usize) -> Vec<Outcome> {
    let scene = scene();
    let values = |run| values(scene, run);
    study::runs(&scene.bind, RUNS, &values, &SETTINGS, threads, &|_| ())
}

/// As many turns of the hand-written presser foot, spread in the same way.
fn turns(threads: usize) -> Vec<f64> {
    let one = |_| {
        let foot = black_box(Foot::default());
        hand_walk::run::<true, false>(&foot, START, 6.0 * PERIOD, SETTINGS.rtol).state[0]
    };
    study::each(RUNS, threads, &|_| (), &one)
}

/// One run-up by the solvers, the motion kept.
fn by_assur(rtol: f64) -> Motion {
    let settings = Settings { rtol, ..SETTINGS };
    let scene = Table1::default();
    hybrid::march(&scene, (0.0, END), &scene.start(), &settings).expect("the drive runs up")
}

/// The same by hand.
fn by_hand(rtol: f64) -> RunUp {
    hand_run_up::run(&Drive::default(), END, rtol)
}

/// What is measured of a single run-up.
pub fn cases() -> Vec<Case<'static>> {
    let hand = Case::new("hand", 1, || {
        black_box(by_hand(black_box(SETTINGS.rtol)));
    });
    let assur = Case::new("assur", 1, || {
        black_box(by_assur(black_box(SETTINGS.rtol)));
    });
    vec![hand, assur]
}

/// The table of a single run-up.
fn one_run_up() {
    let measures = measure("run-ups", &mut cases(), 300);
    let reference = by_hand(1e-14).end;
    let error = |end: &[f64]| (end[0] - reference[0]).abs();
    let (hand, assur) = (by_hand(SETTINGS.rtol), by_assur(SETTINGS.rtol));
    let evaluations = [hand.evaluations, assur.statistics.evaluations];
    let errors = [error(&hand.end), error(&assur.end)];
    let columns =
        ["code", "evaluations", "error, rad", "instructions", "ratio", "time, us", "ratio"];
    let mut table = Table::new("A run-up with its event, DOP853, rtol 1e-9", &columns);
    for (k, name) in ["hand, motion kept", "Assur, emitted, motion kept"].iter().enumerate() {
        let one = &measures[k];
        table.row([
            name.to_string(),
            evaluations[k].to_string(),
            power(errors[k]),
            number(one.instructions),
            ratio(one.instructions, measures[0].instructions),
            number(one.microseconds()),
            ratio(one.microseconds(), measures[0].microseconds()),
        ]);
    }
    table.print();
    let (events, twists) = apart(1e-14);
    println!("At rtol 1e-14 the events differ by {events:.1e} s, the twists by {twists:.1e} rad.");
}

/// By how much the instants of the event differ, and the twists on the way.
fn apart(rtol: f64) -> (f64, f64) {
    let (hand, assur) = (by_hand(rtol), by_assur(rtol));
    assert_eq!((hand.events.len(), assur.events.len()), (1, 1));
    let twists = (0..1000).map(|k| {
        let time = (f64::from(k) + 0.5) / 1000.0 * END;
        let ((moves, one), (mode, other)) = (hand.at(time), assur.at(time));
        assert_eq!(moves, mode % 2 == 1, "{time}");
        (one[0] - other[0]).abs()
    });
    let events = (hand.events[0] - assur.events[0].time).abs();
    (events, twists.fold(0.0, f64::max))
}

/// Measures and prints.
pub fn report() {
    one_run_up();
    let first = run_ups(1);
    let failed = first.iter().filter(|one| one.is_err()).count();
    assert_eq!(failed, 0, "some run-ups do not come out");
    assert!(first == run_ups(2), "threads change the answer");
    type Code = (&'static str, fn(usize));
    let codes: [Code; 2] = [
        ("run-ups of the table drive", |threads| {
            black_box(run_ups(threads));
        }),
        ("hand-written loop, six turns of the foot each", |threads| {
            black_box(turns(threads));
        }),
    ];
    let mut best = [[f64::INFINITY; 2]; 2];
    let mut spent = [[0.0; 2]; 2];
    for _ in 0..ROUNDS {
        for ((best, spent), (_, code)) in best.iter_mut().zip(&mut spent).zip(&codes) {
            for threads in [1, 2] {
                let (clock, ticks) = (Instant::now(), processor_time());
                code(threads);
                let wall = 1e3 * clock.elapsed().as_secs_f64();
                best[threads - 1] = wall.min(best[threads - 1]);
                spent[threads - 1] += processor_time() - ticks;
            }
        }
    }
    let columns =
        ["a thousand", "1 thread, ms", "2 threads, ms", "times as fast", "by processor time"];
    let mut table = Table::new("A thousand run-ups with different parameters", &columns);
    for (((name, _), [one, two]), [alone, together]) in codes.iter().zip(best).zip(spent) {
        table.row([
            name.to_string(),
            number(Some(one)),
            number(Some(two)),
            format!("{:.2}", one / two),
            format!("{:.2}", 2.0 * alone / together),
        ]);
    }
    table.print();
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    println!("Load of the machine: {}", load.trim());
    let ([[one, two], _], [[alone, together], _]) = (best, spent);
    at_least("speed of two threads in that of one", Some(one), Some(two), GOAL);
    let what = "the same by processor time";
    at_least(what, Some(2.0 * alone), Some(together), GOAL);
}

/// What this program and its threads have taken of the processor, in ticks of the system; not a number elsewhere than on
/// Linux.
fn processor_time() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name of the program, in brackets, may hold anything.
    let fields = text.rsplit(") ").next().unwrap_or_default();
    let number = |index: usize| -> Option<f64> {
        fields.split(' ').nth(index).and_then(|one| one.parse().ok())
    };
    match (number(11), number(12)) {
        (Some(user), Some(system)) => user + system,
        _ => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_run_up_by_hand_is_that_of_the_solvers() {
        let (events, twists) = apart(1e-13);
        assert!(events < 1e-18 && twists < 1e-14, "{events} {twists}");
    }

    #[test]
    fn the_parameters_differ_from_run_to_run() {
        let scene = scene();
        let all: Vec<Vec<f64>> = (0..RUNS).map(|run| values(scene, run)).collect();
        for (run, one) in all.iter().enumerate() {
            assert!(!all[..run].contains(one));
        }
        assert!(run_ups(0).iter().all(Result::is_ok));
    }
}
