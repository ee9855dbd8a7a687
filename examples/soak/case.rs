//! A scene with values, a method and a tolerance made at random.

use std::sync::Arc;

use assur::answer::{Method, Settings};
use assur::model::Model;
use assur::problem::Span;
use assur::registry::{Bind, SceneEntry};
use assur::shape::Constant;
use assur::tolerance::Random;

/// Numbers that a case may take from its sequence.
const DRAWS: u64 = 1 << 12;
/// Times within the task at which everything is compared.
const TIMES: usize = 3;
/// Relative tolerance of the reference.
const REFERENCE: &str = "1e-12";
/// Methods, each with one of another family that gives its reference.
const METHODS: [(Method, Method); 6] = [
    (Method::Dop853, Method::Radau),
    (Method::Tsit5, Method::Dop853),
    (Method::Taylor, Method::Dop853),
    (Method::Radau, Method::Dop853),
    (Method::Rosenbrock, Method::Dop853),
    (Method::Auto, Method::Dop853),
];

/// Which of the two runs of a case.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    Tried,
    Reference,
}

/// A run that the command is asked for.
#[derive(Clone)]
pub struct Case {
    pub number: u64,
    pub mechanism: &'static str,
    pub scene: &'static SceneEntry,
    changes: Vec<Change>,
    /// Words of `--at`.
    times: Vec<String>,
    method: usize,
    rtol: String,
}

/// A value that is not the declared one, in the unit of its declaration.
#[derive(Clone, Copy)]
struct Change {
    constant: usize,
    value: f64,
}

impl Case {
    /// The case of a number; values that the mechanism refuses are drawn again.
    pub fn make(seed: u64, number: u64, only: Option<&str>) -> Self {
        let mut random = Random::new(seed, number.wrapping_mul(DRAWS));
        let scenes: Vec<_> = assur_equations::REGISTRY
            .iter()
            .filter(|mechanism| only.is_none_or(|name| name == mechanism.name))
            .flat_map(|mechanism| mechanism.scenes.iter().map(|scene| (mechanism.name, scene)))
            .filter(|(_, scene)| matches!(scene.bind, Bind::Motion(_)) && !scene.states.is_empty())
            .collect();
        assert!(!scenes.is_empty(), "no motion is chosen by --only");
        let (mechanism, scene) = scenes[pick(&mut random, scenes.len())];
        let (changes, span) = changes(scene, &mut random);
        let (from, to) = span.limits();
        let time = |random: &mut Random| from + (to - from) * random.uniform();
        let times = match span {
            Span::Open | Span::Rest => Vec::new(),
            _ => (0..TIMES).map(|_| format!("time={:e}[s]", time(&mut random))).collect(),
        };
        Self {
            number,
            mechanism,
            scene,
            changes,
            times,
            method: pick(&mut random, METHODS.len()),
            rtol: format!("{:.1e}", 10.0_f64.powf(-4.0 - 6.0 * random.uniform())),
        }
    }

    /// Arguments of the command, but for the format.
    pub fn arguments(&self, precision: Precision) -> Vec<String> {
        let (method, rtol) = self.settled(precision);
        let mut words: Vec<String> =
            ["run", self.mechanism, "--scene", self.scene.name].map(str::to_owned).into();
        words.extend(["--method".to_owned(), method.name().to_owned()]);
        words.extend(["--rtol".to_owned(), rtol.to_owned()]);
        let changes = self.changes.iter();
        words.extend(changes.flat_map(|change| ["--set".to_owned(), change.word(self.scene)]));
        words.extend(self.times.iter().flat_map(|time| ["--at".to_owned(), time.clone()]));
        words
    }

    fn settled(&self, precision: Precision) -> (Method, &str) {
        let (tried, other) = METHODS[self.method];
        match precision {
            Precision::Tried => (tried, self.rtol.as_str()),
            Precision::Reference => (other, REFERENCE),
        }
    }

    /// Method and tolerance.
    pub fn settings(&self, precision: Precision) -> Option<Settings> {
        let (method, rtol) = self.settled(precision);
        Some(Settings::new(method).rtol(rtol.parse().ok()?))
    }

    /// The scene with its values, if the mechanism accepts them.
    pub fn model(&self) -> Option<Arc<dyn Model>> {
        let mut values: Vec<f64> = nominal(self.scene);
        for change in &self.changes {
            values[change.constant] =
                change.value * self.scene.constants[change.constant].quantity.factor;
        }
        Some(Arc::from(self.scene.bind.motion(&values).ok()?))
    }

    /// The command line of one of the runs.
    pub fn line(&self, precision: Precision) -> String {
        let words = self.arguments(precision);
        let quoted = words.iter().map(|word| match word.contains(['[', ' ', '(']) {
            true => format!("'{word}'"),
            false => word.clone(),
        });
        format!("assur {}", quoted.collect::<Vec<_>>().join(" "))
    }

    /// Cases that are simpler by one thing each: a value is the declared one, or has two digits; a time is not asked for.
    pub fn simpler(&self) -> impl Iterator<Item = Self> {
        let without = (0..self.changes.len()).map(|index| {
            let mut simpler = self.clone();
            simpler.changes.remove(index);
            simpler
        });
        let times = (0..self.times.len()).map(|index| {
            let mut simpler = self.clone();
            simpler.times.remove(index);
            simpler
        });
        let rounded = self.changes.iter().enumerate().filter_map(|(index, change)| {
            let value: f64 = format!("{:.1e}", change.value).parse().ok()?;
            (value != change.value).then(|| {
                let mut simpler = self.clone();
                simpler.changes[index].value = value;
                simpler
            })
        });
        without.chain(times).chain(rounded)
    }
}

impl Change {
    /// As a word of `--set`.
    fn word(&self, scene: &SceneEntry) -> String {
        let quantity = scene.constants[self.constant].quantity;
        let unit = match quantity.unit {
            "" => String::new(),
            unit => format!("[{unit}]"),
        };
        format!("{}={:e}{unit}", quantity.name, self.value)
    }
}

fn pick(random: &mut Random, count: usize) -> usize {
    ((random.uniform() * count as f64) as usize).min(count - 1)
}

fn nominal(scene: &SceneEntry) -> Vec<f64> {
    scene.constants.iter().map(|constant| constant.default).collect()
}

/// Values that the mechanism accepts, and the task with them.
fn changes(scene: &SceneEntry, random: &mut Random) -> (Vec<Change>, Span) {
    let nominal = nominal(scene);
    for _ in 0..40 {
        let mut values = nominal.clone();
        let mut changes = Vec::new();
        for (index, (constant, value)) in scene.constants.iter().zip(&mut values).enumerate() {
            // Half of the values change, so that cases are told apart by few of them.
            if random.uniform() < 0.5 {
                continue;
            }
            *value = changed(constant, random);
            changes.push(Change { constant: index, value: *value / constant.quantity.factor });
        }
        if let Ok(run) = scene.bind.motion(&values) {
            return (changes, run.span());
        }
    }
    let span = scene.bind.motion(&nominal).map_or(Span::Open, |run| run.span());
    (Vec::new(), span)
}

/// A value within some thirty percent of the declared one, rarely far from it, within its range.
fn changed(constant: &Constant, random: &mut Random) -> f64 {
    let spread: f64 = if random.uniform() < 0.1 { 2.0 } else { 0.3 };
    let size = spread * (2.0 * random.uniform() - 1.0);
    (constant.default * size.exp()).clamp(constant.range.0, constant.range.1)
}
