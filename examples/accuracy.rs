//! Can an estimated error be trusted? Every scene of the mechanisms that come with Assur that moves, at tolerances from 1e-4 to
//! 1e-12: what is told of each state, output and measure, over what it really errs by, which is its difference from a reference
//! at the limit of double precision. Quantities whose reference is not known ten times better than that do not count.
//!
//!     cargo run --release --example accuracy            all of them, as the page docs/accuracy.md
//!     cargo run --release --example accuracy batten     one mechanism

use assur::prelude::*;
use assur::registry::SceneEntry;
use assur::study::{Told, trust};
use std::time::Duration;

const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// Time after which no more is tried of a scene.
const PATIENCE: Duration = Duration::from_secs(120);
/// Worst cases that are listed, at either end.
const LISTED: usize = 12;
/// An estimate that is that many times too large or too small is as good as another,
const NEAR: f64 = 5.0;
/// and one that is that many times too small is wrong.
const WRONG: f64 = 10.0;

/// A number at a tolerance.
struct Number {
    /// What is told over what is true.
    ratio: f64,
    rtol: f64,
    /// Which it is, and what is told and true.
    words: String,
}

fn main() {
    let only = std::env::args().nth(1);
    let (mut all, mut missing): (Vec<Number>, Vec<String>) = (Vec::new(), Vec::new());
    let mut scenes = 0;
    for mechanism in assur_equations::REGISTRY {
        if only.as_ref().is_some_and(|name| name != mechanism.name) {
            continue;
        }
        for scene in mechanism.scenes.iter().filter(|scene| scene.linkage.is_none()) {
            eprintln!("{} {}", mechanism.name, scene.name);
            match of_scene(mechanism.name, scene, &mut missing) {
                Ok(found) => {
                    scenes += usize::from(!found.is_empty());
                    all.extend(found);
                }
                Err(reason) => missing.push(format!("{} {}: {reason}", mechanism.name, scene.name)),
            }
        }
    }
    all.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    if all.is_empty() {
        eprintln!("nothing that moves");
    } else {
        report(&all, scenes, &missing);
    }
}

/// The distribution, and the worst cases.
fn report(all: &[Number], scenes: usize, missing: &[String]) {
    println!("# Errors told and true\n");
    println!(
        "An answer of Assur tells by how much each of its numbers may err. Here that is compared with what it errs by: {} states,",
        all.len()
    );
    println!(
        "outputs and measures of {scenes} scenes at {} tolerances, against a reference at the limit of",
        TOLERANCES.len()
    );
    println!(
        "double precision. Made by\n\n```console\n$ cargo run --release --example accuracy > docs/accuracy.md\n```\n"
    );
    println!("What is told over what is true:\n");
    println!(
        "| rtol | numbers | least | 1 % below | 10 % below | median | 10 % above | largest | within {NEAR} | below 1/{WRONG} |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for rtol in TOLERANCES {
        let some: Vec<&Number> = all.iter().filter(|one| one.rtol == rtol).collect();
        row(&format!("{rtol:e}"), &some);
    }
    row("all", &all.iter().collect::<Vec<_>>());
    println!("\nToo small, the worst first:\n");
    all.iter().take(LISTED).for_each(|one| println!("* {:.3}: {}", one.ratio, one.words));
    println!("\nToo large, the worst first:\n");
    all.iter().rev().take(LISTED).for_each(|one| println!("* {:.0}: {}", one.ratio, one.words));
    println!("\nNot compared:\n");
    missing.iter().for_each(|one| println!("* {one}"));
}

/// A row of the distribution.
fn row(name: &str, some: &[&Number]) {
    let Some(last) = some.len().checked_sub(1) else { return };
    let at = |share: f64| some[(last as f64 * share).round() as usize].ratio;
    let share = |count: usize| 100.0 * count as f64 / some.len() as f64;
    let near = some.iter().filter(|one| (1.0 / NEAR..=NEAR).contains(&one.ratio)).count();
    let wrong = some.iter().filter(|one| one.ratio < 1.0 / WRONG).count();
    let shares = [0.0, 0.01, 0.1, 0.5, 0.9, 1.0].map(|share| format!("{:.2}", at(share)));
    let shares = shares.join(" | ");
    println!("| {name} | {} | {shares} | {:.1} % | {wrong} |", some.len(), share(near));
}

/// All numbers of a scene; none where it has no motion.
fn of_scene(
    mechanism: &str,
    scene: &SceneEntry,
    missing: &mut Vec<String>,
) -> Result<Vec<Number>, String> {
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let model = scene.bind.motion(&values).map_err(|refused| refused.to_string())?;
    let settings = TOLERANCES.map(|rtol| Settings::default().rtol(rtol));
    let found = trust(&model.into(), &settings, PATIENCE)?;
    missing.extend(found.missing.iter().map(|why| format!("{mechanism} {}: {why}", scene.name)));
    let names = scene.states.iter().chain(scene.outputs).chain(scene.measures);
    let names: Vec<&str> = names.map(|one| one.name).collect();
    let number = |one: &Told| Number {
        ratio: one.told / one.real,
        rtol: one.rtol,
        words: format!(
            "{mechanism} {} {}, rtol {:e}: told {:.1e}, true {:.1e}",
            scene.name, names[one.place], one.rtol, one.told, one.real
        ),
    };
    Ok(found.numbers.iter().map(number).collect())
}
