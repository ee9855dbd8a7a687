//! What roundings do: every function of every scene that moves, on doubles, beside the same on numbers of 71 digits. The page
//! `docs/roundings.md` is written by `ASSUR_BLESS=1 cargo test -p assur-equations --test interpreter roundings`.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use assur::problem::{Equations, Phase, Reports, Scene};
use assur::registry::Mechanism;
use assur::scalar::Scalar;
use assur::shape::Shape;
use assur::study::each;
use assur_equations::REGISTRY;
use assur_interpreter::scene::{Motion, Moving};
use assur_model::asked::Asked;
use assur_model::checked::Compiled;
use assur_model::lexer;
use assur_model::texts::Texts;

use crate::octuple::Octuple;

/// Places at which each function is taken.
const PLACES: usize = 6;
/// Scenes of more states take too long.
const MOST: usize = 30;
/// Disturbances of a place.
const DISTURBED: usize = 4;
/// An error is that of the place where it is no larger than so many times what a unit in the last place of that does.
const OWN: f64 = 4.0;
/// What is that much smaller than its double is zero.
const ZERO: f64 = 1e-30;
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

/// A place in a mode.
struct Here<'a, S> {
    shape: &'a Shape,
    mode: usize,
    time: S,
    state: Vec<S>,
}

impl<S: Scalar> Here<'_, S> {
    /// The functions of a scene with their values.
    fn functions(&self, scene: &Moving<false>) -> Vec<(&'static str, Vec<S>)> {
        let prepared = scene.prepare::<S>();
        let (shape, n, phase) = (self.shape, self.state.len(), Phase::of(self.mode));
        let (time, state) = (self.time, &self.state[..]);
        let zeros = |count| vec![S::ZERO; count];
        let mut row = zeros(prepared.instant());
        prepared.instants(phase, &[time], &mut row);
        let mut found = Vec::new();
        let mut take = |name, count, write: &dyn Fn(&mut [S])| {
            let mut values = zeros(count);
            write(&mut values);
            found.push((name, values));
        };
        take("rate", n, &|values| prepared.rates(phase, &row, state, values));
        take("slope", n * n, &|values| prepared.jacobian(phase, &row, state, values));
        take("output", shape.outputs.len(), &|values| prepared.outputs(phase, time, state, values));
        take("energy", 2, &|values| {
            if let Some(energy) = prepared.energy(phase, time, state) {
                (values[0], values[1]) = energy;
            }
        });
        let masses = shape.coordinates * shape.coordinates;
        take("mass", masses, &|values| {
            prepared.mass(phase, time, state, values);
        });
        if let Some(events) = Moving::<false>::events(&prepared) {
            let count = shape.modes[self.mode].written();
            take("guard", 2 * count, &|values| {
                let (values, rates) = values.split_at_mut(count);
                events.guards(phase, time, state, values, rates);
            });
        }
        found
    }
}

/// A number from 0 to 1, of two numbers.
fn share(a: usize, b: usize) -> f64 {
    ((a * 131 + b) as f64 * 0.618_033_988_749_9 + 0.3).fract()
}

/// The size of the last place of a number.
fn unit(value: f64) -> f64 {
    f64::from_bits(value.abs().to_bits() + 1) - value.abs()
}

/// A number a unit in its last place off, up or down by chance.
fn disturbed(value: f64, turn: usize, index: usize) -> f64 {
    value + (2.0 * share(turn, index).round() - 1.0) * unit(value)
}

/// The errors of all functions in a mode at a place. The first scene is the one that is meant, the others have parameters a little
/// off.
fn errors(
    (mechanism, scene): (&'static str, &str),
    scenes: &[Moving<false>],
    here: &Here<'_, f64>,
) -> Vec<Error> {
    let number = Octuple::from_f64;
    let off = |turn: usize, index: usize, value: f64| match turn {
        0 => number(value),
        _ => number(disturbed(value, turn, index)),
    };
    let mut exact = scenes.iter().enumerate().map(|(turn, scene)| {
        let state = here.state.iter().enumerate();
        let state = state.map(|(index, value)| off(turn, index, *value)).collect();
        let time = off(turn, 777, here.time);
        Here { shape: here.shape, mode: here.mode, time, state }.functions(scene)
    });
    let right = exact.next().expect("a scene");
    let others: Vec<_> = exact.collect();
    let mut found = Vec::new();
    for (function, (what, values)) in here.functions(&scenes[0]).into_iter().enumerate() {
        for (index, value) in values.into_iter().enumerate() {
            let right = right[function].1[index];
            let size = right.to_f64();
            if !size.is_normal() || !value.is_finite() || size.abs() < ZERO * value.abs() {
                continue;
            }
            let units = |other: Octuple| (other - right).to_f64().abs() / unit(size);
            let own = others.iter().map(|other| units(other[function].1[index]));
            let own = own.fold(0.0, f64::max);
            let units = units(number(value));
            let words =
                format!("{mechanism} {scene}, mode {}, {what} {index}: {value:.3e}", here.mode);
            found.push(Error { units, own, of: (mechanism, what), words });
        }
    }
    found
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
    let mut found = Vec::new();
    for (entry, scene) in of.scenes.iter().zip(&model.scenes) {
        if scene.linkage.is_some() || entry.states.is_empty() || entry.states.len() > MOST {
            continue;
        }
        let values: Vec<f64> = entry.constants.iter().map(|one| one.default).collect();
        let motion = Arc::new(Motion::new(scene, entry.shape, None));
        let scenes: Vec<_> = (0..=DISTURBED)
            .map(|turn| {
                let values = values.iter().enumerate().map(|(index, value)| match turn {
                    0 => *value,
                    _ => disturbed(*value, turn, 1000 + index),
                });
                Moving::<false>::new(&motion, &values.collect::<Vec<_>>())
            })
            .collect();
        let moving = &scenes[0];
        let (from, to) = moving.span().limits();
        for mode in 0..entry.modes.len().max(1) {
            for place in 0..PLACES {
                let near = |(index, (value, scale)): (usize, (f64, &f64))| {
                    let width = [1.0, 30.0][place % 2] * scale;
                    value + width * (2.0 * share(place, index) - 1.0)
                };
                let state = moving.start().into_iter().zip(entry.scales).enumerate().map(near);
                let time = from + (to - from) * share(place, 55);
                let here = Here { shape: entry.shape, mode, time, state: state.collect() };
                found.extend(errors((of.name, entry.name), &scenes, &here));
            }
        }
    }
    found
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

Every function of every scene that moves, rates, their slopes, outputs, energies, masses, guards, at random places, on doubles
beside the same on numbers of 71 digits. Errors in units in the last place; *inside* counts those that are more than four
units, and more than four times what a unit in the last place of states, time and parameters does to the exact value: sums
that cancel within a function. What is zero without roundings does not count. Made by

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
    let mut listed: Vec<(&str, &str)> = Vec::new();
    for one in all.iter().filter(|one| one.units > LARGE && !is_own(one)) {
        if listed.contains(&one.of) {
            continue;
        }
        listed.push(one.of);
        let head = format!("{} {}: ", one.of.0, one.of.1);
        let reason = REASONS.lines().find_map(|line| line.strip_prefix(&head));
        let reason = reason.unwrap_or_else(|| panic!("why {} units? {}", one.units, one.words));
        let _ = writeln!(
            page,
            "* {}: {:.0} units, {:.1} by the place: {reason}",
            one.words, one.units, one.own
        );
    }
    let median = all[all.len() / 2].units;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/roundings.md");
    match std::env::var_os("ASSUR_BLESS") {
        Some(_) => fs::write(path, page).expect("the page can be written"),
        None => assert!(path.exists(), "write docs/roundings.md"),
    }
    assert!(all.len() > 10_000, "{}", all.len());
    assert!(median <= 1.0, "{median}");
    let inside = all.iter().filter(|one| !is_own(one)).count();
    assert!(50 * inside < all.len(), "{inside} of {}", all.len());
}
