//! What roundings do: every function of every scene, on doubles, beside the same on numbers of 71 digits. The page
//! `docs/roundings.md` is written by `ASSUR_BLESS=1 cargo test -p assur-equations --test interpreter roundings`.

mod loops;
mod motions;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use assur::registry::{Mechanism, SceneEntry};
use assur::scalar::Scalar;
use assur::study::each;
use assur_equations::REGISTRY;
use assur_model::asked::Asked;
use assur_model::checked::Compiled;
use assur_model::lexer;
use assur_model::texts::Texts;

use crate::octuple::Octuple;

/// Places at which each function is taken.
const PLACES: usize = 6;
/// Disturbances of a place.
const DISTURBED: usize = 4;
/// An error is that of the place where it is no larger than so many times what a unit in the last place of that does.
const OWN: f64 = 4.0;
/// What is that much smaller than its double is zero.
const ZERO: f64 = 1e-30;
/// So is what a unit in the last place of its place changes by so many of its own, in its fourth digit.
const ZERO_OF_PLACE: f64 = 1e12;
/// Errors inside of so many units are explained.
const LARGE: f64 = 100.0;
/// Why: mechanism and function, reason.
const REASONS: &str = "\
four_bar_row guard: each of 40 windows takes its angle from the one before, rounds it the same way, and all are near their dead points
four_bar_row rate: as its guards, near that place
table_drive output: acceleration of the motor as that of the table, held by 1e6 N m, and of the twist, in a mode that the scene does not come to
bricard slope: one of 25 entries of a product of five turns, a thousand times smaller than the others
bricard mass: as its slopes
engine guard: rate of sin((θ - π)/2) at the top dead centre, where the sine is -1 and its rate goes through zero
pumping_jack output: 3 mm above the lowest place of a stroke of 1.5 m, as the difference of two angles
elastic_crank slope: entries of 1e-2 beside others of 1e6 that the mass matrix brings in
presser_foot slope: 1 - tanh(v/v_0)^2 where the friction is saturated; the error is 1e-16 of what the slope is at rest
burnishing influence: the share of heat nearly does not depend on the force, which both zones feel; what is left of two quotients
burnishing second influence: both zones feel angle and radius alike, what is left of two profiles
gear_flank slope: what is left of two products of turned vectors that nearly stand on each other
gear_flank influence: by an offset that the flank hardly feels there: parts of turned vectors that annul each other but for 1e-7 of them
gear_flank second influence: as its influences
gear_flank coefficient: where the place of contact hardly moves, of two quotients of such parts
gear_flank output: 1 - U beside the place where U is 1, which is what this output is for
feed_rack influence: of what vanishes at the singular place that the scene looks for
cam second influence: second differences of splines, where the radius goes through infinity nearby
batten rate: sums of forces of rods and dampers near their balance, 30 times as far out as the motion goes
";

/// The error of a number.
struct Error {
    /// Units in the last place.
    units: f64,
    /// What a unit in the last place of states, time and parameters does to it.
    own: f64,
    /// Mechanism and function.
    of: (&'static str, &'static str),
    words: String,
}

/// Functions with their values.
type Functions<S> = Vec<(&'static str, Vec<S>)>;

/// A number from 0 to 1, of two numbers.
fn share(a: usize, b: usize) -> f64 {
    ((a * 131 + b) as f64 * 0.618_033_988_749_9 + 0.3).fract()
}

/// The size of the last place of a number.
fn unit(value: f64) -> f64 {
    f64::from_bits(value.abs().to_bits() + 1) - value.abs()
}

/// A number a unit in its last place off, up or down by chance; in turn 0 the number.
fn disturbed(value: f64, turn: usize, index: usize) -> f64 {
    match turn {
        0 => value,
        _ => value + (2.0 * share(turn, index).round() - 1.0) * unit(value),
    }
}

/// The values of a scene, and the same a little off in each of them.
fn turns(entry: &SceneEntry) -> impl Iterator<Item = Vec<f64>> {
    (0..=DISTURBED).map(|turn| {
        let values = entry.constants.iter().enumerate();
        values.map(|(index, one)| disturbed(one.default, turn, 1000 + index)).collect()
    })
}

/// The errors of functions: on doubles, beside them without roundings, and without roundings a little off. Numbers are named by
/// their function and their place in it.
fn judged(
    (mechanism, scene): (&'static str, &str),
    named: &dyn Fn(&str, usize) -> String,
    found: Functions<f64>,
    exact: Vec<Functions<Octuple>>,
) -> Vec<Error> {
    let (right, others) = exact.split_first().expect("a turn");
    let mut errors = Vec::new();
    for (function, (what, values)) in found.into_iter().enumerate() {
        let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for (index, value) in values.into_iter().enumerate() {
            let right = right[function].1[index];
            let size = right.to_f64();
            if !size.is_normal() || !value.is_finite() || size.abs() < ZERO * value.abs() {
                continue;
            }
            let units = |other: Octuple| (other - right).to_f64().abs() / unit(size);
            let own = others.iter().map(|other| units(other[function].1[index]));
            let own = own.fold(0.0, f64::max);
            if own > ZERO_OF_PLACE {
                continue;
            }
            let units = units(Octuple::from_f64(value));
            let words = format!(
                "{mechanism} {scene}, {}: {value:.3e} of at most {largest:.0e}",
                named(what, index)
            );
            errors.push(Error { units, own, of: (mechanism, what), words });
        }
    }
    errors
}

/// The errors of all functions of a mechanism.
fn of_mechanism(of: &Mechanism) -> Vec<Error> {
    let lexed = lexer::lex_file(of.text).expect("tokens");
    let mut texts = Texts::default();
    let compiled = assur_model::compile_asked(&lexed.tokens, Asked::All, &mut |wanted| {
        let part = of.parts.iter().find(|(path, _)| *path == wanted.path);
        texts.lex(wanted, part.map_or("", |(_, text)| text).as_bytes())
    });
    let Compiled { model: Some(model), .. } = compiled else { panic!("{}", of.name) };
    let scenes = of.scenes.iter().zip(&model.scenes);
    let errors = scenes.flat_map(|(entry, scene)| match scene.linkage {
        Some(_) => loops::of_scene(of.name, entry, scene),
        None => motions::of_scene(of.name, entry, scene),
    });
    errors.collect()
}

/// A row of the table.
fn row(name: &str, mut errors: Vec<&Error>) -> String {
    errors.sort_by(|a, b| a.units.total_cmp(&b.units));
    let at = |share: f64| errors[((errors.len() - 1) as f64 * share).round() as usize].units;
    let inside = errors.iter().filter(|one| !is_own(one)).count();
    let [median, most, last] = [0.5, 0.9, 0.99].map(at);
    format!("| {name} | {} | {median:.2} | {most:.1} | {last:.1} | {inside} |", errors.len())
}

/// Whether an error is that of the place.
fn is_own(error: &Error) -> bool {
    error.units <= OWN * error.own.max(1.0)
}

const HEAD: &str = "# Roundings

Every function of every scene at random places, on doubles beside the same on numbers of 71 digits: of what moves rates, their
slopes, outputs, energies, masses, guards; of linkages what closes the groups, the slopes of their loops, kinematic
coefficients, outputs with their influence coefficients of first and second order, points. Errors in units in the last place;
*inside* counts those that are more than four units, and more than four times what a unit in the last place of states, time,
position and parameters does to the exact value: sums that cancel within a function. Most are influence coefficients of `gear_flank` and `burnishing`, which go
through many products and quotients whose parts annul each other. What is zero without roundings, or ill determined by its
place to the fourth digit, does not count. Made by

```console
$ ASSUR_BLESS=1 cargo test -p assur-equations --test interpreter roundings
```

| mechanism | numbers | median | 90 % below | 99 % below | inside |
|---|---:|---:|---:|---:|---:|
";

#[test]
fn functions_lose_no_digits() {
    let all = each(REGISTRY.len(), 0, &|_| (), &|index| of_mechanism(&REGISTRY[index]));
    let mut page = HEAD.to_owned();
    for (of, errors) in REGISTRY.iter().zip(&all) {
        if !errors.is_empty() {
            let _ = writeln!(page, "{}", row(of.name, errors.iter().collect()));
        }
    }
    let mut all: Vec<&Error> = all.iter().flatten().collect();
    let _ = writeln!(page, "{}\n", row("all", all.clone()));
    let _ = writeln!(page, "The largest inside of each function, above {LARGE} units:\n");
    all.sort_by(|a, b| b.units.total_cmp(&a.units));
    let (mut listed, mut unknown) = (Vec::<(&str, &str)>::new(), String::new());
    for one in all.iter().filter(|one| one.units > LARGE && !is_own(one)) {
        if listed.contains(&one.of) {
            continue;
        }
        listed.push(one.of);
        let head = format!("{} {}: ", one.of.0, one.of.1);
        let reason = REASONS.lines().find_map(|line| line.strip_prefix(&head));
        if reason.is_none() {
            let _ = writeln!(
                unknown,
                "{}: {:.0} units, {:.1} by the place",
                one.words, one.units, one.own
            );
        }
        let reason = reason.unwrap_or("?");
        let _ = writeln!(
            page,
            "* {}: {:.0} units, {:.1} by the place: {reason}",
            one.words, one.units, one.own
        );
    }
    assert!(unknown.is_empty(), "why?\n{unknown}");
    let median = all[all.len() / 2].units;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/roundings.md");
    match std::env::var_os("ASSUR_BLESS") {
        Some(_) => fs::write(path, page).expect("the page can be written"),
        None => assert!(path.exists(), "write docs/roundings.md"),
    }
    assert!(all.len() > 10_000, "{}", all.len());
    assert!(median <= 1.0, "{median}");
    let inside = all.iter().filter(|one| !is_own(one)).count();
    assert!(10 * inside < all.len(), "{inside} of {}", all.len());
}
