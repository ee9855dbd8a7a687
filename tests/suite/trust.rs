//! What is told of errors, beside what is true: all scenes that move, but for those with very many closures, at five tolerances.

use std::time::Duration;

use assur::prelude::*;
use assur::registry::SceneEntry;
use assur::study::{Told, each, trust};

const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
/// Scenes of which more closures are solved are left to the page `docs/accuracy.md`: their references take minutes.
const MOST: usize = 30;

#[test]
fn what_is_told_of_errors_is_true() {
    let scenes: Vec<(&str, &SceneEntry)> = assur_equations::REGISTRY
        .iter()
        .flat_map(|of| of.scenes.iter().map(|scene| (of.name, scene)))
        .filter(|(_, scene)| scene.linkage.is_none())
        .filter(|(_, scene)| scene.reduced.as_ref().is_none_or(|one| one.loops.len() <= MOST))
        .collect();
    let ratios = each(scenes.len(), 0, &|_| (), &|index| {
        let (of, scene) = scenes[index];
        let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
        let model = scene.bind.motion(&values).expect("values of the file");
        let settings = TOLERANCES.map(|rtol| Settings::default().rtol(rtol));
        let found = trust(&model.into(), &settings, Duration::MAX).unwrap_or_default();
        let words = |one: &Told| {
            let Told { rtol, place, told, real } = one;
            let words = format!("{of} {} {rtol:e} {place}: {told:e} {real:e}", scene.name);
            (one.told / one.real, words)
        };
        found.numbers.iter().map(words).collect::<Vec<_>>()
    });
    let ratios: Vec<(f64, String)> = ratios.into_iter().flatten().collect();
    let all = ratios.len();
    let near = ratios.iter().filter(|one| (0.2..=5.0).contains(&one.0)).count();
    let wrong: Vec<_> = ratios.iter().filter(|one| one.0 < 0.1).collect();
    assert!(all > 5000, "{all}");
    let far: Vec<_> = ratios.iter().filter(|one| !(0.2..=5.0).contains(&one.0)).collect();
    assert!(10 * near >= 9 * all, "{near} of {all}: {far:#?}");
    assert!(wrong.is_empty(), "{wrong:?}");
}
