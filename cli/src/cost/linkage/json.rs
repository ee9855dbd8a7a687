//! The answer as an object.

use std::path::Path;

use assur::study::cost::{MadeTrial, Way};
use serde::Serialize;

use super::{Cost, Errs, name};
use crate::show::json::{self, About, Number, number as finite};

/// The answer as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LinkageCost"))]
pub struct Object {
    /// `assur-cost-linkage/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    /// Seconds of a position, whatever the accuracy.
    position: Number,
    outputs: Vec<Output>,
    /// How an output errs by the tolerances; null where nothing has one.
    spread: Option<Spread>,
    /// Whether nobody stopped it.
    whole: bool,
    /// What was asked for with `--for`.
    wanted: Option<String>,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// An output.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Output {
    name: &'static str,
    unit: &'static str,
    /// How far it may be off as values are rounded, at most over the range.
    rounding: Number,
}

/// How an output errs where it errs most.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Spread {
    output: &'static str,
    unit: &'static str,
    /// Positions of the drivers, SI units.
    at: Vec<f64>,
    /// Greatest error, to first order.
    worst: Number,
    /// Of the reference.
    mean: Number,
    standard_deviation: Number,
    /// The reference, and by how much it is not known.
    reference: &'static str,
    doubt: Number,
    ways: Vec<One>,
    /// Rounds of times.
    rounds: usize,
    /// The cheapest way to what was asked for, by its place; null where nothing reaches it or nothing was asked for.
    cheapest: Option<usize>,
}

/// A way to find it.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Way"))]
struct One {
    way: &'static str,
    /// Linkages made at random; null where none are made.
    linkages: Option<u64>,
    /// The median, in seconds.
    seconds: Number,
    quartiles: [Number; 2],
    mean: Number,
    standard_deviation: Number,
    /// The larger one of the errors of both.
    error: Number,
    /// Whether it is better than all that is cheaper.
    front: bool,
}

impl Object {
    /// An answer.
    pub fn of(cost: &Cost, figure: Option<&Path>) -> Self {
        let outputs = cost.case.scene.outputs.iter().zip(&cost.roundings);
        let outputs = outputs.map(|(output, rounding)| Output {
            name: output.name,
            unit: output.unit,
            rounding: finite(rounding.error / output.factor),
        });
        Self {
            format: "assur-cost-linkage/1",
            about: About::of(&cost.case.constants),
            position: finite(cost.position),
            outputs: outputs.collect(),
            spread: cost.errs.as_ref().map(|errs| Spread::of(cost, errs)),
            whole: cost.is_whole,
            wanted: cost.wanted.as_ref().map(|wanted| wanted.text.clone()),
            seconds: cost.seconds,
            figure: json::path(figure),
        }
    }
}

impl Spread {
    fn of(cost: &Cost, errs: &Errs) -> Self {
        let stated = |value: f64| finite(value / errs.output.factor);
        let cheapest = cost.wanted.as_ref().and_then(|wanted| errs.cheapest(wanted, 1.0));
        let is_same = |one: &MadeTrial| cheapest.is_some_and(|cheapest| cheapest.way == one.way);
        let front = errs.front();
        let ways = errs.made.trials.iter().enumerate();
        let (way, reference) = errs.made.reference;
        Self {
            output: errs.output.name,
            unit: errs.output.unit,
            at: errs.place.clone(),
            worst: stated(errs.linear.worst),
            mean: stated(reference.mean),
            standard_deviation: stated(reference.deviation),
            reference: name(way),
            doubt: stated(errs.made.doubt),
            ways: ways
                .map(|(index, one)| One {
                    way: name(one.way),
                    linkages: match one.way {
                        Way::Made(linkages) => Some(linkages),
                        _ => None,
                    },
                    seconds: finite(one.times.median),
                    quartiles: [finite(one.times.quartiles.0), finite(one.times.quartiles.1)],
                    mean: stated(one.found.mean),
                    standard_deviation: stated(one.found.deviation),
                    error: stated(errs.error(one)),
                    front: front.contains(&index),
                })
                .collect(),
            rounds: errs.made.rounds,
            cheapest: errs.made.trials.iter().position(is_same),
        }
    }
}
