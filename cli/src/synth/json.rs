//! The answer as an object.

use std::path::Path;

use assur::study::Polish;
use assur::synthesis::End;
use serde::Serialize;

use super::Found;
use crate::show::json::{About, Amount, Number, number, path};
use crate::show::unit;

/// The answer of `assur synth` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Object {
    /// `assur-synth/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    varied: Vec<Varied>,
    /// The measure that is made small.
    minimised: &'static str,
    /// The condition that the last of those follow from while designs are sought, and how many these are.
    solved: Option<Solved>,
    /// The measures that must not be below zero, the most important first.
    kept: Vec<&'static str>,
    /// The measures that had better not be below zero.
    preferred: Vec<Preferred>,
    /// The best one first.
    designs: Vec<Design>,
    /// Designs that were judged.
    evaluations: u64,
    seed: u64,
    /// Whether nobody stopped it.
    whole: bool,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// What values follow from.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Solved {
    condition: &'static str,
    values: usize,
}

/// A value that is varied.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Varied {
    name: &'static str,
    unit: &'static str,
    from: f64,
    to: f64,
    /// The only values that it may have; none where it may have any.
    values: Vec<f64>,
}

/// A condition that had better be kept.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Preferred {
    name: &'static str,
    /// What is added to what is made small per unit of what is missed.
    weight: f64,
    /// Its unit.
    unit: String,
}

/// A design that was found.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Design {
    values: Vec<Amount>,
    /// Whether it keeps all conditions.
    keeps: bool,
    /// What is made small, with what is missed of preferences.
    worth: Number,
    /// What is made small where the dimensions err by their tolerances, to first order; null where nothing has any.
    made: Option<f64>,
    /// What is made small, then what is left of each condition, then of each preference.
    measures: Vec<Measure>,
    /// Why it has none; null where it has.
    reason: Option<String>,
    /// How it is put together otherwise than its start values mean; null where it is not.
    contradiction: Option<String>,
    /// The statement of an equation file that gives its values.
    preset: String,
    /// How it was polished, and what holds it; null where polishing made it no better.
    polish: Option<Polished>,
    /// Whether the search that found it had come to an end.
    gathered: bool,
    /// Designs that this search judged.
    evaluations: u64,
}

/// How a design was polished.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Polished {
    /// Whether no step promised to gain anything.
    settled: bool,
    looks: u64,
    /// Places of what is made small, and conditions of which nothing is left.
    held: Vec<Held>,
    /// The varied values that are at a bound.
    bounds: Vec<&'static str>,
    /// Directions that these leave free.
    free: usize,
    /// The least curvature in these, in the unit of what is made small, per range squared.
    least_curvature: Option<f64>,
    /// The largest slope that is left, in that unit per range.
    slope: Number,
}

/// What holds a design.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Held {
    name: &'static str,
    /// The place of the driver; null where it has no one place.
    at: Option<Amount>,
    /// Of what is made small its share; of a condition what would be gained per unit of it.
    multiplier: f64,
}

impl Polished {
    fn of(found: &Found, polish: &Polish) -> Self {
        let objective = found.synthesis.objective;
        let factor = found.measure(objective).factor;
        let held = polish.held.iter().map(|one| {
            let quantity = found.measure(one.measure);
            let per = if one.measure == objective { 1.0 } else { quantity.factor / factor };
            Held {
                name: quantity.name,
                at: found.way.zip(one.at).map(|(way, at)| Amount::of(way, at)),
                multiplier: one.multiplier * per,
            }
        });
        let bounds = polish.bounds.iter().filter_map(|(place, _)| found.varied().nth(*place));
        Self {
            settled: polish.end == End::Settled,
            looks: polish.looks,
            held: held.collect(),
            bounds: bounds.map(|quantity| quantity.name).collect(),
            free: polish.free,
            least_curvature: polish.curvature.map(|one| one / factor),
            slope: number(polish.slope / factor),
        }
    }
}

/// A measure of a design.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Measure {
    name: &'static str,
    unit: &'static str,
    value: Number,
    estimated_error: Number,
}

impl Object {
    /// The object.
    pub(super) fn of(found: &Found, figure: Option<&Path>) -> Self {
        let varied = found.varied().zip(found.synthesis.varied).map(|(quantity, one)| Varied {
            name: quantity.name,
            unit: quantity.unit,
            from: unit::stated(one.from, quantity.factor),
            to: unit::stated(one.to, quantity.factor),
            values: one.values.iter().map(|one| unit::stated(*one, quantity.factor)).collect(),
        });
        let preferred = found.synthesis.preferences.iter().map(|one| {
            let (weight, unit) = found.cost(*one);
            Preferred { name: found.measure(one.0).name, weight, unit }
        });
        let kept = found.synthesis.conditions.iter().map(|index| found.measure(*index).name);
        Self {
            format: "assur-synth/1",
            about: About::of(&found.constants),
            solved: found
                .synthesis
                .solved
                .map(|solved| Solved { condition: solved.text, values: solved.unknowns.len() }),
            varied: varied.collect(),
            minimised: found.measure(found.synthesis.objective).name,
            kept: kept.collect(),
            preferred: preferred.collect(),
            designs: (1..=found.designs.len()).map(|number| Design::of(found, number)).collect(),
            evaluations: found.evaluations,
            seed: found.seed,
            whole: found.is_whole,
            seconds: found.seconds,
            figure: path(figure),
        }
    }
}

impl Design {
    /// The design of a number, counted from one.
    fn of(found: &Found, place: usize) -> Self {
        let proposal = &found.designs[place - 1];
        let values = found.varied().zip(&proposal.candidate.design);
        let measures = found.measures().map(|(index, quantity)| {
            let (value, error) = proposal.measure(index);
            Measure {
                name: quantity.name,
                unit: quantity.unit,
                value: number(unit::stated(value, quantity.factor)),
                estimated_error: number(unit::stated(error, quantity.factor)),
            }
        });
        let measure = |index| proposal.measure(index).0;
        let worth = found.synthesis.worth(measure(found.synthesis.objective), measure);
        let factor = found.measure(found.synthesis.objective).factor;
        Self {
            values: values.map(|(quantity, value)| Amount::of(quantity, *value)).collect(),
            keeps: proposal.candidate.score.is_kept(),
            worth: number(unit::stated(worth, factor)),
            made: proposal.made.map(|made| unit::stated(made, factor)),
            measures: measures.collect(),
            reason: proposal.measures.as_ref().err().cloned(),
            contradiction: proposal.contradiction.clone(),
            preset: proposal.preset(found, place),
            polish: proposal.polish.as_ref().map(|polish| Polished::of(found, polish)),
            gathered: proposal.candidate.is_gathered,
            evaluations: proposal.candidate.evaluations,
        }
    }
}
