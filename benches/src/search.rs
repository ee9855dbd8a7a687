//! The search for a dwell six-bar: designs judged by the whole way, against 72 positions by hand.
//!
//! All search alike, by the same differential evolution; how much a design takes differs, and what is seen of it: the loop by hand
//! looks at 72 positions, Assur finds what is furthest out between them and whether the linkage gets there.

use std::ops::ControlFlow;
use std::time::Instant;

use assur::answer::Settings;
use assur::registry::{Bind, Mechanism, SceneEntry};
use assur::study::Design;
use assur::synthesis::{Effort, Judge, search};
use assur_equations::REGISTRY as SHIPPED;
use assur_model::asked::Asked;

use crate::hand_search::{PLACES, Search};
use crate::table::{Table, at_least, number, ratio, verdict};

assur::equations! { "../../examples/synthesis/dwell_six_bar.eqn" }

/// Designs of one search.
const DESIGNS: u64 = 100_000;
/// Measurements of the quick ones, of which the shortest counts.
const REPEATS: usize = 5;
/// Largest ratio to the loop by hand, and least of one thread to two.
const GOALS: (f64, f64) = (1.15, 1.9);

/// Scene `best` of a mechanism.
fn scene(mechanism: &'static Mechanism) -> &'static SceneEntry {
    mechanism.scenes.iter().find(|scene| scene.name == "best").expect("it has one")
}

fn values(scene: &SceneEntry) -> Vec<f64> {
    scene.constants.iter().map(|constant| constant.default).collect()
}

/// What the lift rocker has to swing by at each place, cosine and sine.
fn wanted() -> [[f64; 2]; PLACES] {
    let mechanism = SHIPPED.iter().find(|one| one.name == "feed_inverse").expect("it is there");
    let scene = &mechanism.scenes[0];
    let mut values = values(scene);
    let rise =
        scene.constants.iter().position(|one| one.quantity.name == "p_pl").expect("it has one");
    values[rise] = 0.2e-3;
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

/// Seconds of a search, and what it comes to.
fn searched(judge: &dyn Judge, evaluations: u64, threads: usize) -> (f64, f64) {
    let effort = Effort { evaluations, threads, ..Effort::default() };
    let clock = Instant::now();
    let found =
        search(judge, &effort, None, &mut |_| ControlFlow::Continue(())).expect("it is well posed");
    (clock.elapsed().as_secs_f64(), found.score.value)
}

/// Microseconds for each design, and what the search comes to.
fn each(judge: &dyn Judge, evaluations: u64, threads: usize, repeats: usize) -> (f64, f64) {
    let times = (0..repeats).map(|_| searched(judge, evaluations, threads));
    let (seconds, value) =
        times.fold((f64::INFINITY, f64::NAN), |best, one| (best.0.min(one.0), one.1));
    (1e6 * seconds / evaluations as f64, value)
}

/// Prints the comparison.
pub fn report() {
    let emitted = &REGISTRY[0];
    let again = assur_interpreter::again(emitted, Asked::Some(&["best"])).expect("tokens");
    let read: &'static Mechanism = Box::leak(Box::new(again.expect("a file without errors")));
    let of = |mechanism: &'static Mechanism| {
        let scene = scene(mechanism);
        let mut values = values(scene);
        let rise = scene.constants.iter().position(|one| one.quantity.name == "wanted.p_pl");
        if let Some(rise) = rise {
            values[rise] = 0.2e-3;
        }
        Design::of(scene, &values, &Settings::default()).expect("it seeks")
    };
    let (compiled, interpreted) = (of(emitted), of(read));
    let hand = Search { sought: compiled.sought().to_vec(), wanted: wanted() };
    let mut table = Table::new(
        "Search for a dwell six-bar, 100 000 designs",
        &["what", "1 thread, us a design", "to by hand", "2 threads", "1 to 2", "deviation, deg"],
    );
    let reference = each(&hand, DESIGNS, 1, REPEATS);
    let judges: [(&str, &dyn Judge); 3] =
        [("by hand, 72 positions", &hand), ("compiled", &compiled), ("interpreted", &interpreted)];
    for (name, judge) in judges {
        let repeats = if name.starts_with("by") { REPEATS } else { 1 };
        let (one, value) = each(judge, DESIGNS, 1, repeats);
        let (two, _) = each(judge, DESIGNS, 2, repeats);
        table.row([
            name.to_owned(),
            number(Some(one)),
            ratio(Some(one), Some(reference.0)),
            number(Some(two)),
            ratio(Some(one), Some(two)),
            number(Some(value.to_degrees())),
        ]);
        if name == "compiled" {
            verdict("a design, compiled", Some(one), Some(reference.0), GOALS.0);
            at_least("two threads, compiled", Some(one), Some(two), GOALS.1);
        }
    }
    table.print();
}
