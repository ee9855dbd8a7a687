//! What one effect, choice or preset changes: scenes that differ by it alone, side by side.

use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry};

use crate::ask::variables::Variable;
use crate::motion::case::Case;
use crate::show::number;
use crate::show::style::Style;
use crate::show::text::{Align, Columns};
use assur::answer::Motion;

/// Instants of a cycle at which scenes are compared.
const INSTANTS: usize = 720;
/// A change below this share of the amplitude is rounding and tolerance.
pub const NOISE: f64 = 1e-8;

/// A scene over its task, sampled.
pub struct Cycle<'a> {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Its variables.
    pub variables: &'a [Variable],
    /// What is done, so far as samples of two scenes can be compared where it is the same.
    pub task: String,
    /// The variables at each sample, SI units.
    pub samples: Vec<Vec<f64>>,
}

impl<'a> Cycle<'a> {
    /// Samples a motion; nothing where the scene has no task.
    pub fn of(case: &'a Case, motion: &Motion) -> Option<Self> {
        let (from, to) = case.moved.task.limits();
        let time = |index| from + (to - from) * index as f64 / INSTANTS as f64;
        (case.moved.task != Span::Open).then(|| Self {
            scene: case.scene,
            variables: &case.variables,
            task: format!("{:?}", case.moved.task),
            samples: (0..=INSTANTS).map(|index| case.sample(motion, time(index))).collect(),
        })
    }

    fn column(&self, name: &str) -> Option<impl Iterator<Item = f64>> {
        let mut variables = self.variables.iter();
        let index = variables.position(|variable| variable.name == name)?;
        Some(self.samples.iter().map(move |row| row[index]))
    }

    /// Largest difference of a variable, and the larger of its amplitudes.
    pub fn change(&self, other: &Self, name: &str) -> Option<(f64, f64)> {
        let pairs = self.column(name)?.zip(other.column(name)?);
        let largest = pairs.fold((0.0, 0.0), |(change, amplitude): (f64, f64), (a, b)| {
            (change.max((a - b).abs()), amplitude.max(a.abs()).max(b.abs()))
        });
        Some(largest)
    }
}

/// Two scenes, and what alone distinguishes them.
struct Step<'a> {
    /// The effect, `torsion`, or the choice, `crank`.
    feature: &'static str,
    /// The pair in words, `rigid →` and `torsion`.
    words: [String; 2],
    before: &'a Cycle<'a>,
    after: &'a Cycle<'a>,
}

/// For each effect, choice and preset that two scenes differ by alone, a table of what it changes.
pub fn render(mechanism: &Mechanism, cycles: &[&Cycle<'_>], style: Style) -> String {
    let steps = steps(cycles);
    let effects = mechanism.effects.iter().map(|effect| (effect.name, "effect", effect.summary));
    let choices = mechanism.choices.iter().map(|choice| (choice.name, "choice", choice.summary));
    let features = effects.chain(choices).chain([("", "preset", "")]);
    let mut text = String::new();
    for (name, kind, summary) in features {
        let of_feature = steps.iter().filter(|step| step.feature == name);
        let of_feature: Vec<_> = of_feature.collect();
        if of_feature.is_empty() {
            continue;
        }
        let mut heading =
            format!("What the {kind} {name}").trim_end().to_owned() + " changes at most";
        if let Some(line) = summary.lines().next() {
            heading += &format!(": {line}");
        }
        text += &format!("\n{}\n", style.heading(&heading));
        text += &table(&of_feature).render(style);
    }
    if steps.is_empty() {
        text += "\n  no two scenes with the same task differ by a single effect or choice\n";
    } else {
        let note =
            "  percent of the amplitude over the cycle, the larger of both scenes; - is no change";
        text += &format!("{}\n", style.faint(note));
    }
    text
}

fn table(steps: &[&Step<'_>]) -> Columns {
    let pairs = steps.iter().flat_map(|step| {
        [(step.words[0].as_str(), Align::Point), (step.words[1].as_str(), Align::Right)]
    });
    let ends = [("", Align::Left), ("unit", Align::Left)];
    let mut table =
        Columns::new(ends[..1].iter().copied().chain(pairs).chain(ends[1..].iter().copied()));
    let Some(first) = steps.first() else {
        return table;
    };
    let outputs = first.after.scene.outputs;
    for variable in first.after.variables {
        if !outputs.iter().any(|output| output.name == variable.name) {
            continue;
        }
        let mut row = vec![variable.name.clone()];
        for step in steps {
            row.extend(match step.before.change(step.after, &variable.name) {
                None => [String::new(), String::new()],
                Some((change, amplitude)) if change <= NOISE * amplitude => {
                    ["-".to_owned(), String::new()]
                }
                Some((change, amplitude)) => [
                    number::significant(variable.in_unit(change), 3),
                    format!("{} %", number::significant(100.0 * change / amplitude, 2)),
                ],
            });
        }
        row.push(variable.unit.clone());
        table.row(row);
    }
    table
}

fn steps<'a>(cycles: &[&'a Cycle<'a>]) -> Vec<Step<'a>> {
    let mut steps = Vec::new();
    for (index, first) in cycles.iter().enumerate() {
        for second in &cycles[index + 1..] {
            if first.task != second.task {
                continue;
            }
            let Some((feature, swap)) = difference(first.scene, second.scene) else {
                continue;
            };
            let (before, after) = if swap { (*second, *first) } else { (*first, *second) };
            steps.push(Step {
                feature,
                words: [format!("{} →", before.scene.name), after.scene.name.to_owned()],
                before,
                after,
            });
        }
    }
    steps
}

/// The effect or choice by which alone two scenes differ, an empty name for a preset, and whether the second scene is
/// the one to begin with: the one without the effect. A choice that only one of them makes belongs to an effect.
fn difference(a: &SceneEntry, b: &SceneEntry) -> Option<(&'static str, bool)> {
    let lost = a.effects.iter().filter(|name| !b.effects.contains(name));
    let won = b.effects.iter().filter(|name| !a.effects.contains(name));
    let chosen = a.choices.iter().filter(|(name, made)| {
        let mut others = b.choices.iter();
        others.any(|(other, differently)| name == other && made != differently)
    });
    let mut all = lost
        .map(|name| (*name, true))
        .chain(won.map(|name| (*name, false)))
        .chain(chosen.map(|(name, _)| (*name, false)))
        .chain((a.preset != b.preset).then_some(("", false)));
    let only = all.next()?;
    all.next().is_none().then_some(only)
}
