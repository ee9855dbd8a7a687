//! The answer of `assur tolerance --format json`: one object.
//!
//! | field | contents |
//! |---|---|
//! | `format` | `"assur-tolerance/1"` |
//! | `mechanism`, `scene` | their names |
//! | `output` | `name`, whether it was `named` (else it is the last one of the scene), `others`, `unit` of its `value`, `error_unit` of all errors |
//! | `place` | the drivers, each `name`, `unit`, `value` |
//! | `contributions` | each `name`, `play`, `unit`, `half_width`, `distribution`, `influence` (error unit per unit), `worst`, `deviation`, `share`, `variance_share` |
//! | `bands` | `worst`, `deviation`; `second` (whether it can be `trusted`: near a dead point it cannot) and `monte_carlo` where asked for |
//! | `range` | `worst`, where (`at`), and the `ranking` of the sources |
//! | `allocation` | `band`, `tolerances`, `cost`, `price`, `greatest`, `active`; or null |
//! | `notes` | what the numbers do not say, each in words: a tolerance that leads out of the range of its dimension, a linkage put together far from its start values |
//! | `changed` | the values that were given with --set, in words |
//! | `status` | `"complete"`; `"conditional"` when linkages made at random do not assemble, so that `monte_carlo` speaks of the others alone; `"empty"` when none does |

use std::path::Path;

use assur::tolerance::{Allocation, Corners, Difference, Estimate, MonteCarlo, Status};
use serde_json::{Value, json};

use super::answer::{Answer, Second, Unit, label};
use super::question::Question;
use super::table::distribution;
use crate::unit;

/// The object, with its last line ended.
pub fn render(question: &Question, answer: &Answer, figure: Option<&Path>) -> String {
    let page = Page { question, answer, unit: Unit::of(question) };
    let object = json!({
        "format": "assur-tolerance/1",
        "mechanism": question.mechanism.name,
        "scene": question.scene.name,
        "output": {
            "name": question.output().name,
            "named": question.is_named,
            "others": question.other_outputs(),
            "unit": question.output().unit,
            "value": unit::stated(answer.linear.value, question.output().factor),
            "error_unit": page.unit.name,
        },
        "place": page.place(&answer.place),
        "contributions": page.contributions(),
        "bands": {
            "worst": page.error(answer.linear.worst),
            "deviation": page.error(answer.linear.deviation),
            "second": answer.second.as_ref().map(|one| page.second(one)),
            "monte_carlo": answer.made.as_ref().map(|one| page.made(one)),
        },
        "range": page.range(),
        "allocation": answer.allocation.as_ref().map(|one| page.allocation(one)),
        "changed": question.changed,
        "notes": question.notes,
        "status": page.status(),
        "seconds": answer.seconds,
        "figure": figure.map(|path| path.display().to_string()),
    });
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

struct Page<'a> {
    question: &'a Question,
    answer: &'a Answer,
    unit: Unit,
}

impl Page<'_> {
    fn error(&self, value: f64) -> Value {
        json!(unit::stated(value, self.unit.factor))
    }

    fn estimate(&self, estimate: Estimate) -> Value {
        json!({
            "value": self.error(estimate.value),
            "low": self.error(estimate.low),
            "high": self.error(estimate.high),
        })
    }

    fn place(&self, place: &[f64]) -> Value {
        let drivers = self.question.drivers.iter().zip(place);
        drivers
            .map(|(driver, value)| {
                json!({ "name": driver.name, "unit": driver.unit, "value": unit::stated(*value, driver.factor) })
            })
            .collect()
    }

    fn contributions(&self) -> Value {
        let question = self.question;
        let all = self.answer.linear.contributions.iter().enumerate();
        all.map(|(index, one)| {
            let quantity = question.labels[index].quantity;
            let source = &question.study.sources[index];
            json!({
                "name": quantity.name,
                "play": question.labels[index].is_play,
                "unit": quantity.unit,
                "half_width": unit::stated(source.half_width, quantity.factor),
                "distribution": distribution(source.distribution),
                "influence": one.influence / self.unit.factor * quantity.factor,
                "worst": self.error(one.worst),
                "deviation": self.error(one.deviation),
                "share": one.share,
                "variance_share": one.variance_share,
            })
        })
        .collect()
    }

    fn second(&self, second: &Second) -> Value {
        let corners = |corners: &Corners| {
            json!({
                "least": self.error(corners.least),
                "greatest": self.error(corners.greatest),
                "tried": corners.tried,
                "failed": corners.failed,
            })
        };
        let difference = |one: Difference| json!({ "rms": self.error(one.rms), "greatest": self.error(one.greatest) });
        json!({
            "mean": self.error(second.moments.mean),
            "deviation": self.error(second.moments.deviation),
            "skewness": second.moments.skewness,
            "extremes_quadratic": second.extremes.map(|one| corners(&one.quadratic)),
            "extremes_closed": second.extremes.map(|one| corners(&one.exact)),
            "missed_by_first_order": difference(second.differences.linear),
            "missed_by_second_order": difference(second.differences.quadratic),
            "trusted": second.is_trusted(),
        })
    }

    fn made(&self, made: &MonteCarlo) -> Value {
        let place = &made.places[0];
        let quantiles = place.quantiles.iter();
        let quantiles: Value = quantiles
            .map(|one| json!({ "level": one.level, "error": self.estimate(one.estimate) }))
            .collect();
        json!({
            "drawn": place.drawn,
            "assembled": place.assembled,
            "seed": self.question.sampling.seed,
            "confidence": self.question.sampling.confidence,
            "failures": { "value": place.failures.value, "low": place.failures.low, "high": place.failures.high },
            "mean": self.estimate(place.mean),
            "deviation": self.estimate(place.deviation),
            "skewness": place.skewness,
            "least": self.error(place.least),
            "greatest": self.error(place.greatest),
            "share_beyond_each": place.beyond,
            "quantiles": quantiles,
        })
    }

    fn status(&self) -> &'static str {
        match self.answer.made.as_ref().map(|made| made.places[0].status) {
            None | Some(Status::Complete) => "complete",
            Some(Status::Conditional) => "conditional",
            Some(Status::Empty) => "empty",
        }
    }

    fn range(&self) -> Value {
        let (question, answer) = (self.question, self.answer);
        let worst = assur::tolerance::worst_place(&answer.range);
        let ranking = answer.ranking.iter();
        let ranking: Value = ranking
            .map(|rank| {
                json!({
                    "name": label(question, rank.source),
                    "mean_share": rank.mean,
                    "largest_share": rank.largest,
                    "at": self.place(&question.study.places[rank.place]),
                })
            })
            .collect();
        json!({
            "places": answer.range.len(),
            "worst": self.error(answer.range[worst].worst),
            "at": self.place(&question.study.places[worst]),
            "ranking": ranking,
        })
    }

    fn allocation(&self, found: &Allocation) -> Value {
        let own = self.question.labels.iter().filter(|one| !one.is_play);
        let tolerances: Value = own
            .zip(&found.tolerances)
            .map(|(label, tolerance)| {
                let quantity = label.quantity;
                json!({
                    "name": quantity.name,
                    "unit": quantity.unit,
                    "half_width": unit::stated(*tolerance, quantity.factor),
                })
            })
            .collect();
        let active: Value = found
            .active
            .iter()
            .map(|one| json!({ "at": self.place(&one.at), "share": one.share }))
            .collect();
        json!({
            "band": self.question.allocation.as_ref().map(|one| self.error(one.band)),
            "tolerances": tolerances,
            "cost": found.cost,
            "price": found.price,
            "greatest": self.error(found.greatest),
            "greatest_at": self.place(&found.greatest_at),
            "active": active,
            "rounds": found.rounds,
        })
    }
}
