//! The answer of `assur study --format json`: one object.
//!
//! | field | contents |
//! |---|---|
//! | `format` | `"assur-study/1"` |
//! | `mechanism`, `scene`, `parameters`, `settings` | as of `assur run` |
//! | `over` | of a grid: each `name`, `unit`, `values`; the first changes fastest in the lists below |
//! | `samples`, `seed`, `tolerances` | of values made at random: their number, which ones, each `name`, `unit`, `tolerance`, `distribution`; null otherwise |
//! | `measures` | each `name`, `unit`, `values` (one a run, null where it has none); of values made at random besides `mean` (`value`, `low`, `high`), `deviation`, `least`, `greatest`, `quantiles` (`share`, `value`) |
//! | `failures` | runs that did not come out: each `run`, `reason` |
//! | `seconds`, `figure` | time that it took; path of the figure, or null |

use std::path::Path;

use assur::shape::Quantity;
use serde_json::{Value, json};

use super::answer::Answer;
use super::question::{Question, Way};
use crate::json::{mechanism, parameters, scene, settings};
use crate::unit;

/// The object, with its last line ended.
pub fn render(question: &Question, answer: &Answer, figure: Option<&Path>) -> String {
    let (over, samples, seed, tolerances) = way(question);
    let failures = answer.outcomes.iter().enumerate();
    let failures = failures.filter_map(|(run, one)| {
        let reason = one.as_ref().err()?;
        Some(json!({ "run": run, "reason": reason }))
    });
    let object = json!({
        "format": "assur-study/1",
        "mechanism": mechanism(question.mechanism),
        "scene": scene(&question.constants),
        "parameters": parameters(&question.constants),
        "settings": settings(&question.settings, question.scene),
        "over": over,
        "samples": samples,
        "seed": seed,
        "tolerances": tolerances,
        "measures": (0..question.measures.len()).map(|index| measure(question, answer, index)).collect::<Value>(),
        "failures": failures.collect::<Value>(),
        "seconds": answer.seconds,
        "figure": figure.map(|path| path.display().to_string()),
    });
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

fn way(question: &Question) -> (Value, Value, Value, Value) {
    let quantity = |index: usize| -> &Quantity { &question.scene.constants[index].quantity };
    match &question.way {
        Way::Grid(ranges) => {
            let ranges = ranges.iter().map(|range| {
                let quantity = quantity(range.constant);
                let values = range.values.iter().map(|value| unit::stated(*value, quantity.factor));
                json!({ "name": quantity.name, "unit": quantity.unit, "values": values.collect::<Vec<f64>>() })
            });
            (ranges.collect(), Value::Null, Value::Null, Value::Null)
        }
        Way::Random(constants, samples, seed) => {
            let made = constants.iter().filter(|one| one.tolerance > 0.0);
            let made = made.map(|one| {
                json!({
                    "name": one.quantity.name,
                    "unit": one.quantity.unit,
                    "tolerance": unit::stated(one.tolerance, one.quantity.factor),
                    "distribution": format!("{:?}", one.distribution).to_lowercase(),
                })
            });
            (Value::Null, json!(samples), json!(seed), made.collect())
        }
    }
}

fn measure(question: &Question, answer: &Answer, place: usize) -> Value {
    let index = question.measures[place];
    let quantity = &question.scene.measures[index];
    let of = |value: f64| json!(unit::stated(value, quantity.factor));
    let runs = 0..question.count();
    let mut object = json!({
        "name": quantity.name,
        "unit": quantity.unit,
        "values": runs.map(|run| of(answer.value(run, index))).collect::<Value>(),
    });
    if let Some(Some(spread)) = answer.spreads.get(place) {
        let quantiles = spread.quantiles.iter();
        let quantiles =
            quantiles.map(|(share, value)| json!({ "share": share, "value": of(*value) }));
        object["mean"] = json!({
            "value": of(spread.mean.value),
            "low": of(spread.mean.low),
            "high": of(spread.mean.high),
        });
        object["deviation"] = of(spread.deviation);
        object["least"] = of(spread.least);
        object["greatest"] = of(spread.greatest);
        object["quantiles"] = quantiles.collect();
    }
    object
}
