//! A study as an object.

use std::path::Path;

use assur::shape::{Constant, Quantity};
use assur::study::Spread;
use serde::Serialize;

use super::answer::Answer;
use super::question::{Plan, Question};
use crate::show::json::{self, About, Number, Settings, number};
use crate::show::unit;

/// The answer of `assur study` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Study {
    /// `assur-study/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    settings: Settings,
    /// Of a grid: the first changes fastest in the lists of `measures`.
    over: Option<Vec<Over>>,
    /// Number of runs with values made at random.
    samples: Option<usize>,
    /// Which values were made at random.
    seed: Option<u64>,
    /// Of values made at random.
    tolerances: Option<Vec<Tolerance>>,
    measures: Vec<Measure>,
    /// Runs that did not come out.
    failures: Vec<Missing>,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// A value that is gone through.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Over {
    name: &'static str,
    unit: &'static str,
    values: Vec<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Tolerance {
    name: &'static str,
    unit: &'static str,
    tolerance: f64,
    distribution: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Measure {
    name: &'static str,
    unit: &'static str,
    /// One a run, null where it has none.
    values: Vec<Number>,
    #[serde(flatten)]
    together: Option<Together>,
}

/// What values made at random say together.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Together {
    mean: Mean,
    deviation: Number,
    least: Number,
    greatest: Number,
    quantiles: Vec<Quantile>,
}

/// The mean, and between what it lies with a confidence of 95 %.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Mean {
    value: Number,
    low: Number,
    high: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Quantile {
    share: f64,
    value: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Missing {
    run: usize,
    reason: String,
}

impl Study {
    /// The object.
    pub fn of(question: &Question, answer: &Answer, figure: Option<&Path>) -> Self {
        let failures = answer.outcomes.iter().enumerate();
        let failures = failures.filter_map(|(run, one)| {
            let reason = one.as_ref().err()?.clone();
            Some(Missing { run, reason })
        });
        let (over, random) = match &question.way {
            Plan::Grid(ranges) => (Some(ranges), None),
            Plan::Random(constants, samples, seed) => (None, Some((constants, *samples, *seed))),
        };
        let measures = 0..question.measures.len();
        Self {
            format: "assur-study/1",
            about: About::of(&question.constants),
            settings: Settings::of(&question.settings, question.scene),
            over: over.map(|ranges| {
                let of = |constant: usize| &question.scene.constants[constant].quantity;
                ranges.iter().map(|range| Over::of(of(range.constant), &range.values)).collect()
            }),
            samples: random.map(|(_, samples, _)| samples),
            seed: random.map(|(.., seed)| seed),
            tolerances: random.map(|(constants, ..)| Tolerance::all(constants)),
            measures: measures.map(|place| Measure::of(question, answer, place)).collect(),
            failures: failures.collect(),
            seconds: answer.seconds,
            figure: json::path(figure),
        }
    }
}

impl Over {
    fn of(quantity: &Quantity, values: &[f64]) -> Self {
        let values = values.iter().map(|value| unit::stated(*value, quantity.factor));
        Self { name: quantity.name, unit: quantity.unit, values: values.collect() }
    }
}

impl Tolerance {
    fn all(constants: &[Constant]) -> Vec<Self> {
        let made = constants.iter().filter(|one| one.tolerance > 0.0);
        let made = made.map(|one| Self {
            name: one.quantity.name,
            unit: one.quantity.unit,
            tolerance: unit::stated(one.tolerance, one.quantity.factor),
            distribution: one.distribution.name(),
        });
        made.collect()
    }
}

impl Measure {
    fn of(question: &Question, answer: &Answer, place: usize) -> Self {
        let index = question.measures[place];
        let quantity = &question.scene.measures[index];
        let of = |value: f64| number(unit::stated(value, quantity.factor));
        let runs = 0..question.count();
        let together = |spread: &Spread| {
            let mean = &spread.mean;
            let quantiles = spread.quantiles.iter();
            let quantiles =
                quantiles.map(|(share, value)| Quantile { share: *share, value: of(*value) });
            Together {
                mean: Mean { value: of(mean.value), low: of(mean.low), high: of(mean.high) },
                deviation: of(spread.deviation),
                least: of(spread.least),
                greatest: of(spread.greatest),
                quantiles: quantiles.collect(),
            }
        };
        Self {
            name: quantity.name,
            unit: quantity.unit,
            values: runs.map(|run| of(answer.value(run, index))).collect(),
            together: answer.spreads.get(place).and_then(Option::as_ref).map(together),
        }
    }
}
