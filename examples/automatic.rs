//! What does the automatic choice of the method cost? Every scene of the mechanisms that come with Assur that moves, at tolerances
//! from 1e-4 to 1e-12: the time of `auto` over that of the fastest method at the same tolerance, of those that keep it or err no
//! more than `auto` does. How far an answer is off is its largest difference from a reference at the limit of double precision,
//! over the size of each state.
//!
//!     cargo run --release --example automatic            all of them, in four minutes
//!     cargo run --release --example automatic batten     one mechanism

use assur::prelude::*;
use assur::registry::SceneEntry;
use assur::shape::Subject;
use assur::study::cost::{Look, Trial, cost};
use std::sync::Arc;

const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// Seconds for the times of a scene.
const SECONDS: f64 = 3.0;
/// Scenes with more loops are left out: the reference of forty windows in a row takes minutes.
const LOOPS: usize = 30;
/// Cases that are listed.
const LISTED: usize = 20;
/// The goal of each, and of the median.
const GOALS: [f64; 2] = [1.3, 1.1];

/// A scene at a tolerance.
struct Case {
    name: String,
    rtol: f64,
    /// Time of the automatic choice over that of the best.
    ratio: f64,
    /// The best.
    best: Settings,
    /// Times of both, in seconds.
    times: [f64; 2],
}

fn main() {
    let only = std::env::args().nth(1);
    let mut all: Vec<Case> = Vec::new();
    for mechanism in assur_equations::REGISTRY {
        if only.as_ref().is_some_and(|name| name != mechanism.name) {
            continue;
        }
        let is_short =
            |scene: &SceneEntry| scene.reduced.is_none_or(|one| one.loops.len() <= LOOPS);
        for scene in
            mechanism.scenes.iter().filter(|scene| scene.linkage.is_none() && is_short(scene))
        {
            let name = format!("{} {}", mechanism.name, scene.name);
            match of_scene(&name, scene) {
                Ok(found) => all.extend(found),
                Err(reason) => eprintln!("{name}: {reason}"),
            }
        }
    }
    all.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
    println!("{:>6}  {:>8}  {:>8}  {:>6}  best", "ratio", "auto, us", "best, us", "rtol");
    for case in all.iter().take(LISTED) {
        let [auto, best] = case.times.map(|time| 1e6 * time);
        println!(
            "{:6.2}  {auto:8.0}  {best:8.0}  {:6.0e}  {}, {}",
            case.ratio, case.rtol, case.best, case.name
        );
    }
    if let Some(median) = all.get(all.len() / 2) {
        let within = all.iter().filter(|case| case.ratio <= GOALS[0]).count();
        println!(
            "\n{} cases: median {:.3} (goal {}), {:.1} % within {}",
            all.len(),
            median.ratio,
            GOALS[1],
            100.0 * within as f64 / all.len() as f64,
            GOALS[0]
        );
    }
}

/// A scene at all tolerances; none where it has no motion.
fn of_scene(name: &str, scene: &SceneEntry) -> Result<Vec<Case>, String> {
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let model = scene.bind.motion(&values).map_err(|refused| refused.to_string())?;
    let model: Arc<dyn Model> = model.into();
    let settings =
        Method::ALL.map(|method| TOLERANCES.map(|rtol| Settings::new(method).rtol(rtol)));
    let subjects: Vec<Subject> = (0..scene.states.len()).map(Subject::State).collect();
    if subjects.is_empty() {
        return Err("it has no states".to_owned());
    }
    let look = Look { settings: settings.as_flattened(), subjects: &subjects, seconds: SECONDS };
    let found = cost(&model, &look, &|| true)?;
    let sizes = &found.sizes.0;
    let relative = |errors: &[f64]| {
        let parts = errors.iter().zip(sizes).filter(|(_, size)| **size > 0.0);
        parts.map(|(error, size)| error / size).fold(0.0, f64::max)
    };
    // Time and error of what is solved.
    let done = |trial: &Trial| {
        let work = trial.outcome.as_ref().ok()?;
        Some((work.times.quartiles.0, relative(&work.errors)))
    };
    let case = |auto: &Trial| {
        let (time, error) = done(auto)?;
        let rtol = auto.settings.rtol;
        let beside = found.trials.iter().filter(|one| one.settings.rtol == rtol);
        let solved = beside.filter_map(|one| Some((one, done(one)?)));
        let equal = solved.filter(|(_, (_, own))| *own <= error.max(rtol));
        let (best, (shortest, _)) = equal.min_by(|(_, (a, _)), (_, (b, _))| a.total_cmp(b))?;
        Some(Case {
            name: name.to_owned(),
            rtol,
            ratio: time / shortest,
            best: best.settings.clone(),
            times: [time, shortest],
        })
    };
    let automatic = found.trials.iter().filter(|trial| trial.settings.method == Method::Auto);
    Ok(automatic.filter_map(case).collect())
}
