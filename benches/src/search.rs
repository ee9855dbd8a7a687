//! The search for a dwell six-bar: designs judged by the whole way, against 72 positions by hand.
//!
//! All search alike, by the same differential evolution; how much a design takes differs, and what is seen of it: the loop by hand
//! looks at 72 positions, Assur finds what is furthest out between them and whether the linkage gets there.

use std::ops::ControlFlow;
use std::time::Instant;

use assur::answer::Settings;
use assur::registry::{Bind, Mechanism, SceneEntry};
use assur::study::{Design, Stand, seek};
use assur::synthesis::{Effort, Judge, search};
use assur_equations::REGISTRY as SHIPPED;
use assur_model::asked::Asked;

use crate::hand_search::{PLACES, Search};
use crate::table::{Table, at_least, number, ratio, verdict};

assur::equations! { "../../examples/synthesis/dwell_six_bar.eqn" }

/// Designs of one search.
const DESIGNS: u64 = 100_000;
/// Searches side by side.
const SEARCHES: u64 = 4;
/// Measurements, of which the shortest counts.
const REPEATS: usize = 3;
/// Largest ratio to the loop by hand, and least of one thread to two.
const GOALS: (f64, f64) = (1.15, 1.9);

/// The values of a scene, with the rise of the teeth that is sought for.
fn with_rise(scene: &SceneEntry, name: &str) -> Vec<f64> {
    let mut values: Vec<f64> = scene.constants.iter().map(|constant| constant.default).collect();
    let rise = scene.constants.iter().position(|one| one.quantity.name == name);
    values[rise.expect("it has one")] = 0.2e-3;
    values
}

/// What the lift rocker has to swing by at each place, cosine and sine.
fn wanted() -> [[f64; 2]; PLACES] {
    let mechanism = SHIPPED.iter().find(|one| one.name == "feed_inverse").expect("it is there");
    let scene = &mechanism.scenes[0];
    let values = with_rise(scene, "p_pl");
    let Bind::Linkage(bind) = scene.bind else { panic!("it is a linkage") };
    let linkage = bind(&values).expect("values that the file states");
    let place =
        |index: usize| vec![(360.0 * (index as f64 + 0.5) / PLACES as f64 - 180.0).to_radians()];
    // From the place where it starts, and back from there.
    let half = PLACES / 2;
    let ahead: Vec<_> = (half..PLACES).map(place).collect();
    let back: Vec<_> = (0..half).rev().map(place).collect();
    let psi = linkage.shape().outputs.iter().position(|one| one.name == "psi").expect("it has one");
    let mut all = [[0.0; 2]; PLACES];
    for (places, index) in [(ahead, half..PLACES), (back, 0..half)] {
        let path = linkage.follow(&places).expect("it is put together");
        assert!(path.stopped.is_none(), "{:?}", path.stopped);
        let mut samples: Vec<f64> = path.samples.iter().map(|sample| sample.outputs[psi]).collect();
        if index.start == 0 {
            samples.reverse();
        }
        for (all, psi) in all[index].iter_mut().zip(samples) {
            *all = [psi.cos(), psi.sin()];
        }
    }
    all
}

/// Microseconds for each design of a search, and what it comes to.
fn searched(judge: &dyn Judge) -> (f64, f64) {
    let effort = Effort { evaluations: DESIGNS, threads: 1, ..Effort::default() };
    let clock = Instant::now();
    let found = search(judge, &effort, None, &mut |_| ControlFlow::Continue(()));
    let found = found.expect("it is well posed");
    let each = clock.elapsed().as_secs_f64() / found.population.evaluations as f64;
    (1e6 * each, found.score.value.to_degrees())
}

/// The same of several searches side by side, on so many threads.
fn sought(design: &Design<'_>, threads: usize) -> (f64, f64) {
    let effort = Effort { evaluations: DESIGNS, threads, ..Effort::default() };
    let mut stand = Stand::default();
    let mut progress = |stand: &Stand| match stand.over < SEARCHES {
        true => ControlFlow::Continue(()),
        false => ControlFlow::Break(()),
    };
    let clock = Instant::now();
    let found = seek(design, &effort, SEARCHES, &mut stand, &mut progress);
    let found = found.expect("it is well posed");
    let each = clock.elapsed().as_secs_f64() / stand.judged as f64;
    (1e6 * each, found[0].score.value.to_degrees())
}

/// A pair of times of rounds, each the shortest.
fn shortest(mut one: impl FnMut() -> (f64, f64)) -> (f64, f64) {
    let all = (0..REPEATS).map(|_| one());
    all.fold((f64::INFINITY, f64::NAN), |best, one| (best.0.min(one.0), one.1))
}

/// Scene `best` of the file, with its rise.
fn design(mechanism: &'static Mechanism) -> Design<'static> {
    let scene = mechanism.scenes.iter().find(|scene| scene.name == "best").expect("it has one");
    let values = with_rise(scene, "wanted.p_pl");
    Design::of(scene, &values, &Settings::default()).expect("it seeks")
}

/// Microseconds for each design as it is compiled.
pub fn compiled() -> f64 {
    shortest(|| searched(&design(&REGISTRY[0]))).0
}

/// Prints the comparison.
pub fn report() {
    let again = assur_interpreter::again(&REGISTRY[0], Asked::Some(&["best"])).expect("tokens");
    let read: &'static Mechanism = Box::leak(Box::new(again.expect("a file without errors")));
    let (compiled, interpreted) = (design(&REGISTRY[0]), design(read));
    let hand = Search { sought: compiled.sought().to_vec(), wanted: wanted() };
    let columns = ["what", "time, us a design", "/ hand", "deviation, deg"];
    let mut table = Table::new("A search of 100 000 designs on one thread", &columns);
    let judges: [(&str, &dyn Judge); 3] =
        [("hand, 72 positions", &hand), ("compiled", &compiled), ("interpreted", &interpreted)];
    let found = judges.map(|(_, judge)| shortest(|| searched(judge)));
    for ((name, _), (time, value)) in judges.iter().zip(&found) {
        let over = ratio(Some(*time), Some(found[0].0));
        table.row([(*name).to_owned(), number(Some(*time)), over, number(Some(*value))]);
    }
    table.print();
    verdict("a design, compiled / hand", Some(found[1].0), Some(found[0].0), GOALS.0);

    let columns = ["what", "1 thread, us a design", "2 threads", "1 / 2"];
    let mut table = Table::new("Four searches of 25 000 designs", &columns);
    let mut of_compiled = (f64::NAN, f64::NAN);
    for (name, design) in [("compiled", &compiled), ("interpreted", &interpreted)] {
        let [one, two] = [1, 2].map(|threads| shortest(|| sought(design, threads)).0);
        table.row([
            name.to_owned(),
            number(Some(one)),
            number(Some(two)),
            ratio(Some(one), Some(two)),
        ]);
        if name == "compiled" {
            of_compiled = (one, two);
        }
    }
    table.print();
    at_least("searches, one thread / two", Some(of_compiled.0), Some(of_compiled.1), GOALS.1);
}
