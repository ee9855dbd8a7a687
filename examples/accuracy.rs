//! Can an estimated error be trusted? Every scene of the mechanisms that come with Assur that moves, at tolerances from 1e-4 to
//! 1e-12: what is told of each state, output and measure, over what it really errs by, which is its difference from a reference
//! at the limit of double precision. Quantities whose reference is not known ten times better than that do not count.
//!
//!     cargo run --release --example accuracy            all of them
//!     cargo run --release --example accuracy batten     one mechanism

use assur::answer::{Estimate, Question};
use assur::prelude::*;
use assur::problem::Span;
use assur::registry::SceneEntry;
use assur::shape::Subject;
use assur::study::cost::references;
use std::sync::Arc;
use std::time::Instant;

const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// Samples of a task.
const SAMPLES: usize = 360;
/// Seconds after which a scene is given up.
const PATIENCE: f64 = 120.0;
/// Worst cases that are listed, at either end.
const LISTED: usize = 20;

/// A quantity at a tolerance: what is told over what is true, and which it is.
type Ratio = (f64, String);

fn main() {
    let only = std::env::args().nth(1);
    let mut all: Vec<Ratio> = Vec::new();
    for mechanism in assur_equations::REGISTRY {
        if only.as_ref().is_some_and(|name| name != mechanism.name) {
            continue;
        }
        let before = all.len();
        let mut scenes = 0;
        for scene in mechanism.scenes.iter().filter(|scene| scene.linkage.is_none()) {
            match of_scene(mechanism.name, scene) {
                Ok(found) => {
                    scenes += usize::from(!found.is_empty());
                    all.extend(found);
                }
                Err(reason) => println!("  {} {}: {reason}", mechanism.name, scene.name),
            }
        }
        if scenes > 0 {
            println!("{}: {} numbers of {scenes} scenes", mechanism.name, all.len() - before);
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    report(&all);
}

/// The distribution, and the worst cases.
fn report(all: &[Ratio]) {
    let Some(last) = all.len().checked_sub(1) else { return };
    println!("\n  share of all   told over true");
    for share in [0.0, 0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0] {
        let at = (last as f64 * share).round() as usize;
        println!("  {:>10} %   {:>14.3}", 100.0 * share, all[at].0);
    }
    let count = |range: std::ops::RangeInclusive<f64>| {
        all.iter().filter(|one| range.contains(&one.0)).count()
    };
    println!(
        "\n{} of {} within a factor of 5, {} below a tenth",
        count(0.2..=5.0),
        all.len(),
        count(0.0..=0.1)
    );
    println!("\nToo small:");
    all.iter().take(LISTED).for_each(|one| println!("  {:>9.3}  {}", one.0, one.1));
    println!("Too large:");
    all.iter().rev().take(LISTED).for_each(|one| println!("  {:>9.3}  {}", one.0, one.1));
}

/// All numbers of a scene; none where it has no motion.
fn of_scene(mechanism: &str, scene: &SceneEntry) -> Result<Vec<Ratio>, String> {
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let model = scene.bind.motion(&values).map_err(|refused| refused.to_string())?;
    let model: Arc<dyn Model> = model.into();
    let moves = matches!(model.span(), Span::Periodic(_) | Span::Autonomous | Span::Run(..));
    if scene.states.is_empty() || !moves {
        return Ok(Vec::new());
    }
    let clock = Instant::now();
    let (first, second) = &references(&model)?;
    let states = (0..scene.states.len()).map(Subject::State);
    let subjects: Vec<Subject> =
        states.chain((0..scene.outputs.len()).map(Subject::Output)).collect();
    let names = scene.states.iter().chain(scene.outputs).chain(scene.measures);
    let names: Vec<&str> = names.map(|one| one.name).collect();
    let (from, to) = first.task().limits();
    let times: Vec<f64> =
        (0..=SAMPLES).map(|at| from + (to - from) * at as f64 / SAMPLES as f64).collect();
    let errors = |estimate: &Estimate, motion: &Motion| {
        let moving = estimate.largest(motion, &subjects, &times);
        [moving, estimate.measures(&motion.measures())].concat()
    };
    let against = Estimate::against(first);
    let doubt = errors(&against, second);
    let mut found = Vec::new();
    for rtol in TOLERANCES {
        if clock.elapsed().as_secs_f64() > PATIENCE {
            return Err(format!("given up after {PATIENCE} s"));
        }
        // What does not come out at a loose tolerance is an error that is told.
        let settings = Settings::new(Method::Dop853).rtol(rtol);
        let Ok(motion) = Question::of(model.clone()).solve(&settings) else { continue };
        let Ok(estimate) = motion.estimate() else { continue };
        if !motion.is_like(first) {
            println!("  {mechanism} {} takes another course at rtol {rtol:e}", scene.name);
            continue;
        }
        let (told, real) = (errors(&estimate, &motion), errors(&against, &motion));
        for (place, name) in names.iter().enumerate() {
            let (told, real) = (told[place], real[place]);
            if real > 10.0 * doubt[place] && told.is_finite() {
                let scene = scene.name;
                let words = format!(
                    "{mechanism} {scene} {name}, rtol {rtol:e}: told {told:.2e}, true {real:.2e}"
                );
                found.push((told / real, words));
            }
        }
    }
    Ok(found)
}
