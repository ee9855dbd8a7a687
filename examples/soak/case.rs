//! A scene with values, a method and a tolerance made at random.

use assur::problem::Span;
use assur::registry::{Bind, SceneEntry};
use assur::shape::Constant;
use assur::tolerance::Random;

/// Numbers that a case may take from its sequence.
const DRAWS: u64 = 1 << 12;
/// Times within the task at which everything is compared.
const TIMES: usize = 3;
/// Method and relative tolerance of the reference.
const REFERENCE: &str = "1e-12";
/// Methods, each with one of another family that gives its reference.
const METHODS: [(&str, &str); 6] = [
    ("dop853", "radau"),
    ("tsit5", "dop853"),
    ("taylor", "dop853"),
    ("radau", "dop853"),
    ("rosenbrock", "dop853"),
    ("auto", "dop853"),
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
    /// Words of `--set`.
    values: Vec<String>,
    /// Words of `--at`.
    times: Vec<String>,
    method: usize,
    rtol: String,
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
        let (values, span) = values(scene, &mut random);
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
            values,
            times,
            method: pick(&mut random, METHODS.len()),
            rtol: format!("{:.1e}", 10.0_f64.powf(-4.0 - 6.0 * random.uniform())),
        }
    }

    /// Arguments of the command, but for the format.
    pub fn arguments(&self, precision: Precision) -> Vec<String> {
        let (tried, other) = METHODS[self.method];
        let (method, rtol) = match precision {
            Precision::Tried => (tried, self.rtol.as_str()),
            Precision::Reference => (other, REFERENCE),
        };
        let mut words = vec!["run", self.mechanism, "--scene", self.scene.name];
        words.extend(["--method", method, "--rtol", rtol]);
        words.extend(self.values.iter().flat_map(|value| ["--set", value]));
        words.extend(self.times.iter().flat_map(|time| ["--at", time]));
        words.into_iter().map(str::to_owned).collect()
    }

    /// The command line of the run that is tried.
    pub fn line(&self, precision: Precision) -> String {
        let words = self.arguments(precision);
        let quoted = words.iter().map(|word| match word.contains(['[', ' ', '(']) {
            true => format!("'{word}'"),
            false => word.clone(),
        });
        format!("assur {}", quoted.collect::<Vec<_>>().join(" "))
    }
}

fn pick(random: &mut Random, count: usize) -> usize {
    ((random.uniform() * count as f64) as usize).min(count - 1)
}

/// Values that the mechanism accepts, as words of `--set`, and the task with them.
fn values(scene: &SceneEntry, random: &mut Random) -> (Vec<String>, Span) {
    let nominal: Vec<f64> = scene.constants.iter().map(|constant| constant.default).collect();
    for _ in 0..40 {
        let mut values = nominal.clone();
        let mut words = Vec::new();
        for (constant, value) in scene.constants.iter().zip(&mut values) {
            // Half of the values change, so that cases are told apart by few of them.
            if random.uniform() < 0.5 {
                continue;
            }
            *value = changed(constant, random);
            let quantity = constant.quantity;
            let unit = match quantity.unit {
                "" => String::new(),
                unit => format!("[{unit}]"),
            };
            words.push(format!("{}={:e}{unit}", quantity.name, *value / quantity.factor));
        }
        if let Ok(run) = scene.bind.motion(&values) {
            return (words, run.span());
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
