//! The answer of `assur run --format json`: one object.
//!
//! | field | contents |
//! |---|---|
//! | `format` | `"assur-run/1"`; a field that changes its meaning changes the number |
//! | `mechanism` | `name`, `title`, `source` |
//! | `scene` | `name`, `effects`, `choices` (name: alternative), `preset` (null for the declared values) |
//! | `parameters` | each `name`, `kind` (`dimension` or `parameter`), `unit`, `value`, `default`, `changed` |
//! | `task` | `kind` (`periodic`, `run` or `open`), `from`, `to`, `unit`, `periods` (after how many it repeats), `period` (`value`, `estimated_error`; null unless it is a result: nothing drives the motion) |
//! | `settings` | `method`, `rtol` |
//! | `status` | `"complete"`; `"not unique"` when free motions repeat after the same period and nothing drives them, so that any amount could be added (`conclusions` says it); `"inaccurate"` when the `largest_estimated_error` is more than a hundredth of its amplitude, as where errors grow without bound, and the exit code is 1; or `"incomplete"` when a value of `results`, `at` or `measures` below is null because it is not a finite number or a measure is missing |
//! | `results` | each `name`, `unit`, `value` and `estimated_error` at the beginning of the task, and `minimum` and `maximum` over it, each with `value`, `time`, `estimated_error` and `estimated_error_of_time`: the first time at which it is reached, and within how much later the value comes so near again that it cannot be told from it |
//! | `at` | for each `--at`: `place` in words, `time`, `mode` (null where there are none), `drivers` (`name`, `unit`, `value`), `results` as above without the extremes |
//! | `modes` | of a motion with modes or events: each `name` (empty where there are events and no modes), `summary` |
//! | `first_mode` | name of the mode at the beginning of the task, null where there are none |
//! | `events` | what happened, in order: each `time`, `estimated_error` of it (null where other tolerances lead to other events), `from` and `to` (names of modes), `event` (the statement), `line` of the equation file, `guard` (its `value` there, `unit`), `before` and `after` (the state, each `name`, `unit`, `value`) |
//! | `measures` | numbers of the whole task, each `name`, `unit`, `value` and `estimated_error`, or a `value` of null and why it is `missing` |
//! | `published` | each `name`, `unit`, `place`, `published`, `tolerance`, `computed`, `estimated_error`, `deviation`, `relative_deviation`, `within` (null when published for other values), `remark`, `line` of the equation file |
//! | `multipliers` | over all `periods` of the task: each `re`, `im`, `modulus`, `angle`, `angle_unit`, `estimated_error` (of `re` and `im` together), `meaning`; none unless the task is periodic |
//! | `conclusions` | what the multipliers say, a sentence each |
//! | `statistics` | `steps`, `rejected`, `evaluations`, `jacobians`, `stiff_steps` (by a stiff method), `rounded_steps` (whose error is that of rounding, above the tolerance), `switches` (of `auto`, each `time`, `to`), `condition` (number of the steady state), `residual` (after a period, over the scales), `seconds`, `seconds_with_error_estimate`, `largest_estimated_error` (`name`, `relative_to_amplitude`), `work_for_ten_times_more_accuracy`, `error_estimate_cut_off` (whether ten times more accuracy took too long to be tried) |
//! | `figure` | path of the figure, or null |
//!
//! Values stand in the unit beside them, times in seconds. A run that does not come out prints no object: the message
//! goes to standard error, and the exit code is 1 or 2.

use std::path::Path;

use assur::problem::Span;
use assur::registry::{Mechanism, SceneEntry, Settings};
use assur::shape::Quantity;
use serde_json::{Value, json};

use crate::constants::Constants;
use crate::events;
use crate::measures;
use crate::published::Comparison;
use crate::report::{Report, Snapshot};
use crate::settings::given_atol;
use crate::unit;
use assur::answer::End;

/// Name and version of the format.
pub const FORMAT: &str = "assur-run/1";

/// The object, with its last line ended.
pub fn render(report: &Report, figure: Option<&Path>) -> String {
    let object = object(report, figure);
    // A `Value` has only text keys and finite numbers, so printing it cannot fail.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

fn object(report: &Report, figure: Option<&Path>) -> Value {
    let results = results(report);
    let places: Vec<_> = report.places.iter().map(|place| snapshot(report, place)).collect();
    let published: Vec<_> = report.published.iter().map(compared).collect();
    let measures = measures::list(report);
    let complete = !lacks(&results) && !places.iter().any(lacks) && !lacks(&measures);
    json!({
        "format": FORMAT,
        "mechanism": mechanism(report.mechanism),
        "scene": scene(&report.case.constants),
        "parameters": parameters(&report.case.constants),
        "task": task(report),
        "settings": settings(&report.motion.settings, report.case.scene),
        "status": status(complete, report),
        "results": results,
        "at": places,
        "modes": events::modes(report),
        "first_mode": text(events::first_mode(report)),
        "events": events::list(report),
        "measures": measures,
        "published": published,
        "multipliers": multipliers(report),
        "conclusions": report.conclusions(),
        "statistics": statistics(report),
        "figure": figure.map(|path| path.display().to_string()),
    })
}

/// The mechanism.
pub fn mechanism(mechanism: &Mechanism) -> Value {
    json!({
        "name": mechanism.name,
        "title": mechanism.title,
        "source": mechanism.source,
    })
}

/// The scene with its preset.
pub fn scene(constants: &Constants) -> Value {
    let scene = constants.scene;
    let choices = scene.choices.iter();
    let choices = choices.map(|(name, made)| ((*name).to_owned(), json!(made)));
    json!({
        "name": scene.name,
        "effects": scene.effects,
        "choices": choices.collect::<serde_json::Map<_, _>>(),
        "preset": text(constants.preset),
    })
}

/// A text, null if it is empty.
pub fn text(text: &str) -> Value {
    if text.is_empty() { Value::Null } else { json!(text) }
}

/// Whether a value is missing in a list of results.
fn lacks(value: &Value) -> bool {
    let list = value.get("results").unwrap_or(value);
    list.as_array().is_some_and(|list| list.iter().any(|result| result["value"].is_null()))
}

/// How a motion was integrated.
pub fn settings(settings: &Settings, scene: &SceneEntry) -> Value {
    let atol = given_atol(settings, scene).into_iter();
    let atol =
        atol.map(|(name, unit, value)| json!({ "name": name, "unit": unit, "value": value }));
    json!({
        "method": settings.method.name(),
        "rtol": settings.rtol,
        "atol": atol.collect::<Value>(),
    })
}

/// The dimensions and parameters.
pub fn parameters(constants: &Constants) -> Value {
    let one = |index: usize| {
        let constant = &constants.scene.constants[index];
        let quantity = &constant.quantity;
        json!({
            "name": quantity.name,
            "kind": if constant.is_dimension { "dimension" } else { "parameter" },
            "unit": quantity.unit,
            "value": unit::stated(constants.values[index], quantity.factor),
            "default": unit::stated(constant.default, quantity.factor),
            "changed": constants.is_changed(index),
        })
    };
    (0..constants.values.len()).map(one).collect()
}

fn task(report: &Report) -> Value {
    let task = report.case.task;
    let (kind, (from, to)) = match task {
        Span::Periodic(_) => ("periodic", task.limits()),
        Span::Run(..) => ("run", task.limits()),
        // They last no time; the limits of such a span are those of a search.
        Span::Open | Span::Autonomous => ("open", (0.0, 0.0)),
    };
    let period = report.period();
    json!({
        "kind": kind,
        "from": from,
        "to": to,
        "unit": "s",
        "periods": report.case.repeats,
        "period": period.map(|(value, error)| json!({ "value": value, "estimated_error": error })),
    })
}

/// Every variable at the beginning of the task, with its extremes over the task.
fn results(report: &Report) -> Value {
    let mut list = readings(report, &report.start);
    let results = list.iter_mut().zip(&report.case.variables);
    for ((result, variable), extremes) in results.zip(&report.extremes) {
        let end = |end: End| {
            json!({
                "value": variable.in_unit(end.value),
                "estimated_error": variable.in_unit(end.error),
                "time": end.time,
                "estimated_error_of_time": end.reach,
            })
        };
        result["minimum"] = end(extremes.lowest);
        result["maximum"] = end(extremes.highest);
    }
    Value::Array(list)
}

fn readings(report: &Report, snapshot: &Snapshot) -> Vec<Value> {
    let variables = report.case.variables.iter().zip(&snapshot.values).zip(&snapshot.errors);
    variables
        .map(|((variable, value), error)| {
            json!({
                "name": variable.name,
                "unit": variable.unit,
                "value": variable.in_unit(*value),
                "estimated_error": variable.in_unit(*error),
            })
        })
        .collect()
}

fn snapshot(report: &Report, snapshot: &Snapshot) -> Value {
    let driver = |(quantity, value): (&Quantity, &f64)| json!({ "name": quantity.name, "unit": quantity.unit, "value": unit::stated(*value, quantity.factor) });
    json!({
        "place": snapshot.label,
        "time": snapshot.time,
        "mode": mode(report, snapshot.time),
        "drivers": report.case.scene.drivers.iter().zip(&snapshot.drivers).map(driver).collect::<Vec<_>>(),
        "results": readings(report, snapshot),
    })
}

/// Name of the mode at a time; null where there are no modes.
fn mode(report: &Report, time: f64) -> Value {
    let (mode, _) = report.motion.place(time);
    text(report.case.mode(mode))
}

/// A published value beside the computed one.
pub fn compared(comparison: &Comparison) -> Value {
    let fact = comparison.fact;
    json!({
        "name": comparison.name,
        "unit": comparison.unit,
        "place": comparison.place,
        "published": comparison.in_unit(fact.value),
        "tolerance": comparison.in_unit(fact.tolerance),
        "computed": comparison.in_unit(comparison.computed),
        "estimated_error": comparison.in_unit(comparison.error),
        "deviation": comparison.in_unit(comparison.deviation()),
        "relative_deviation": comparison.relative(),
        "within": comparison.within(),
        "remark": text(fact.remark),
        "line": fact.line,
    })
}

fn multipliers(report: &Report) -> Value {
    let mut list = Vec::new();
    for multiplier in &report.multipliers {
        for sign in if multiplier.pair { &[1.0, -1.0][..] } else { &[1.0][..] } {
            list.push(json!({
                "re": multiplier.re,
                "im": sign * multiplier.im,
                "modulus": multiplier.modulus(),
                "angle": sign * multiplier.angle(),
                "angle_unit": "deg",
                "estimated_error": multiplier.error,
                "meaning": multiplier.meaning(report.case.turn()),
            }));
        }
    }
    Value::Array(list)
}

fn status(complete: bool, report: &Report) -> &'static str {
    match (complete, report.free()) {
        (false, _) => "incomplete",
        (true, 1..) => "not unique",
        _ if report.is_inaccurate() => "inaccurate",
        _ => "complete",
    }
}

fn statistics(report: &Report) -> Value {
    let effort = report.motion.statistics();
    let worst = report.cost.worst.map(|(index, share)| {
        json!({ "name": report.case.variables[index].name, "relative_to_amplitude": share })
    });
    let switches: Vec<Value> = report
        .motion
        .switches()
        .into_iter()
        .map(|one| json!({ "time": one.time, "to": if one.stiff { "stiff" } else { "explicit" } }))
        .collect();
    json!({
        "steps": effort.steps,
        "rejected": effort.rejected,
        "evaluations": effort.evaluations,
        "jacobians": effort.jacobians,
        "stiff_steps": effort.stiff_steps,
        "rounded_steps": effort.rounded_steps,
        "switches": switches,
        "condition": report.motion.repeats().map(|repeats| repeats.condition),
        "residual": report.motion.repeats().map(|repeats| repeats.residual),
        "seconds": report.cost.solve,
        "seconds_with_error_estimate": report.cost.total,
        "largest_estimated_error": worst,
        "work_for_ten_times_more_accuracy": report.cost.tenfold,
        "error_estimate_cut_off": report.cost.is_cut_off,
    })
}
