//! The answer as an object.

use std::path::Path;

use assur::answer::Settings;
use assur::study::cost::{Trial, Work};
use serde::Serialize;

use super::{Cost, Limited};
use crate::show::json::{self, About, Number, number as finite};
use crate::show::unit;

/// The answer as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Object {
    /// `assur-cost/1`.
    format: &'static str,
    #[serde(flatten)]
    about: About,
    /// What errors are differences from, and what says how well that is known.
    reference: String,
    second_reference: String,
    /// What is looked at.
    quantities: Vec<Quantity>,
    trials: Vec<One>,
    /// Rounds of times.
    rounds: usize,
    /// Whether nobody stopped it.
    whole: bool,
    /// What was asked for with `--for`.
    wanted: Option<String>,
    /// The cheapest way to it, by its place among the trials; null where nothing reaches it or nothing was asked for.
    cheapest: Option<usize>,
    /// The cheapest way to ten times more accuracy, by its place among the trials.
    cheapest_for_ten_times_more: Option<usize>,
    /// The most accurate way, where an accuracy was asked for.
    nearest: Option<Nearest>,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// The most accurate way.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Nearest {
    /// Its place among the trials.
    trial: Option<usize>,
    /// Its error over what is permitted.
    share: Number,
    /// What keeps it from more.
    limited_by: Limited,
}

/// A quantity.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Quantity {
    name: &'static str,
    unit: &'static str,
    /// The largest modulus over the task.
    size: Number,
    /// By how much the reference differs from the nearest solution by another method.
    doubt: Number,
    /// Its standard deviation by the tolerances of dimensions; null where nothing has one or no accuracy is asked for.
    spread: Number,
}

/// A way to solve the task.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct One {
    method: &'static str,
    rtol: f64,
    /// Why nothing comes of it; null where something does.
    reason: Option<String>,
    /// The median, in seconds.
    seconds: Number,
    quartiles: [Number; 2],
    steps: Option<usize>,
    evaluations: Option<usize>,
    /// The error of each quantity in its unit.
    errors: Vec<Number>,
    /// The largest error over the size of its quantity.
    largest: Number,
    /// Whether it is better than all that is cheaper.
    front: bool,
}

impl Object {
    /// An answer.
    pub fn of(cost: &Cost, figure: Option<&Path>) -> Self {
        let costs = &cost.costs;
        let front = costs.front(|work| cost.worst(work).0);
        let quantities = cost.shown.iter().map(|of| Quantity {
            name: of.quantity.name,
            unit: of.quantity.unit,
            size: finite(unit::stated(cost.size(of), of.quantity.factor)),
            doubt: finite(unit::stated(cost.doubt(of), of.quantity.factor)),
            spread: finite(unit::stated(cost.deviation(of), of.quantity.factor)),
        });
        let trials = costs.trials.iter().enumerate();
        let wanted = cost.wanted.as_ref();
        let place =
            |of: &Settings| costs.trials.iter().position(|trial: &Trial| trial.settings == *of);
        let cheapest = |part: f64| wanted.and_then(|wanted| place(&cost.cheapest(wanted, part)?.0));
        let nearest = wanted.and_then(|wanted| {
            let nearest = cost.nearest(wanted)?;
            Some(Nearest {
                trial: place(&nearest.0),
                share: finite(nearest.2),
                limited_by: cost.limited(wanted, &nearest),
            })
        });
        Self {
            format: "assur-cost/1",
            about: About::of(&cost.case.constants),
            reference: costs.reference.to_string(),
            second_reference: costs.second.to_string(),
            quantities: quantities.collect(),
            trials: trials.map(|(at, trial)| One::of(cost, trial, front.contains(&at))).collect(),
            rounds: costs.rounds,
            whole: cost.is_whole,
            wanted: cost.wanted.as_ref().map(|wanted| wanted.text.clone()),
            cheapest: cheapest(1.0),
            cheapest_for_ten_times_more: cheapest(0.1),
            nearest,
            seconds: cost.seconds,
            figure: json::path(figure),
        }
    }
}

impl One {
    fn of(cost: &Cost, trial: &Trial, front: bool) -> Self {
        let work = trial.outcome.as_ref().ok();
        let number = |of: fn(&Work) -> f64| work.and_then(|work| finite(of(work)));
        let errors = |work: &Work| {
            let errors = cost.shown.iter();
            let errors = errors.map(|of| unit::stated(cost.error(work, of), of.quantity.factor));
            errors.map(finite).collect()
        };
        Self {
            method: trial.settings.method.name(),
            rtol: trial.settings.rtol,
            reason: trial.outcome.as_ref().err().cloned(),
            seconds: number(|work| work.times.median),
            quartiles: [
                number(|work| work.times.quartiles.0),
                number(|work| work.times.quartiles.1),
            ],
            steps: work.map(|work| work.steps),
            evaluations: work.map(|work| work.evaluations),
            errors: work.map(errors).unwrap_or_default(),
            largest: work.and_then(|work| finite(cost.worst(work).0)),
            front,
        }
    }
}
