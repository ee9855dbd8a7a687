//! Tolerances as an object.

use std::path::Path;

use assur::shape::Quantity;
use assur::tolerance::{self as found, Corners, Status as Assembled};
use serde::Serialize;

use super::answer::{Answer, Second, Unit, label};
use super::question::Question;
use crate::show::json::{self, Amount, Number, number};
use crate::show::unit;

/// The answer of `assur tolerance` as an object.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Tolerance {
    /// `assur-tolerance/1`.
    format: &'static str,
    /// Its name.
    mechanism: &'static str,
    /// Its name.
    scene: &'static str,
    output: Output,
    /// The drivers at the place that is looked at.
    place: Vec<Amount>,
    contributions: Vec<Contribution>,
    bands: Bands,
    range: Range,
    /// Tolerances of least cost, if they are asked for.
    allocation: Option<Allocation>,
    /// The values that were given with --set, in words.
    changed: String,
    /// The statements by which the scene differs from that of the file.
    changes: Vec<String>,
    /// What the numbers do not say: a tolerance that leads out of the range of its dimension, a linkage put together far from
    /// its start values.
    notes: Vec<String>,
    status: Status,
    seconds: f64,
    /// Path of the figure, if one was drawn.
    figure: Option<String>,
}

/// What errs.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Output {
    name: &'static str,
    /// Whether it was asked for; else it is the last one of the scene.
    named: bool,
    others: Vec<&'static str>,
    unit: &'static str,
    value: Number,
    /// Unit of all errors.
    error_unit: &'static str,
}

/// What a source contributes to the error.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Contribution {
    name: &'static str,
    /// Whether it errs by play.
    play: bool,
    unit: &'static str,
    half_width: Number,
    distribution: &'static str,
    /// Error unit per unit of the source.
    influence: Number,
    worst: Number,
    deviation: Number,
    share: Number,
    variance_share: Number,
}

/// How large the error is.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Bands {
    /// Sum of all largest errors.
    worst: Number,
    /// Standard deviation to first order.
    deviation: Number,
    second: Option<SecondOrder>,
    monte_carlo: Option<MonteCarlo>,
}

/// To second order.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct SecondOrder {
    mean: Number,
    deviation: Number,
    skewness: Number,
    /// Extremes by second derivatives; null where there are too many.
    extremes_quadratic: Option<Extremes>,
    /// Extremes with the loops closed again.
    extremes_closed: Option<Extremes>,
    missed_by_first_order: Difference,
    missed_by_second_order: Difference,
    /// Whether the second order describes these errors: near a dead point it does not.
    trusted: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Extremes {
    least: Number,
    greatest: Number,
    tried: usize,
    /// Those that do not assemble.
    failed: usize,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Difference {
    rms: Number,
    greatest: Number,
}

/// Linkages made at random.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct MonteCarlo {
    drawn: u64,
    assembled: u64,
    seed: u64,
    confidence: f64,
    /// Share of those that do not assemble.
    failures: Estimate,
    mean: Estimate,
    deviation: Estimate,
    skewness: Number,
    least: Number,
    greatest: Number,
    /// At most this share lies beyond the least and the greatest, each.
    share_beyond_each: Number,
    quantiles: Vec<Quantile>,
}

/// A value and its interval of confidence.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Estimate {
    value: Number,
    low: Number,
    high: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Quantile {
    level: f64,
    error: Estimate,
}

/// Over the range of the drivers.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Range {
    places: usize,
    worst: Number,
    /// Where the error is greatest.
    at: Vec<Amount>,
    /// The sources by what they contribute.
    ranking: Vec<Rank>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Rank {
    name: String,
    mean_share: Number,
    largest_share: Number,
    at: Vec<Amount>,
}

/// Tolerances of least cost.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Allocation {
    band: Number,
    tolerances: Vec<HalfWidth>,
    cost: Number,
    /// What the cost falls by where the band widens, relative to the band.
    price: Number,
    greatest: Number,
    greatest_at: Vec<Amount>,
    /// Where the band binds.
    active: Vec<Active>,
    rounds: usize,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct HalfWidth {
    name: &'static str,
    unit: &'static str,
    half_width: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Active {
    at: Vec<Amount>,
    share: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum Status {
    Complete,
    /// Linkages made at random do not assemble: `monte_carlo` speaks of the others alone.
    Conditional,
    /// None of the linkages made at random assembles.
    Empty,
}

impl Tolerance {
    /// The object.
    pub fn of(question: &Question, answer: &Answer, figure: Option<&Path>) -> Self {
        Page { question, answer, unit: Unit::of(question.output()) }.whole(figure)
    }
}

struct Page<'a> {
    question: &'a Question,
    answer: &'a Answer,
    unit: Unit,
}

impl Page<'_> {
    fn whole(&self, figure: Option<&Path>) -> Tolerance {
        let (question, answer) = (self.question, self.answer);
        let output = question.output();
        Tolerance {
            format: "assur-tolerance/1",
            mechanism: question.case.constants.mechanism.name,
            scene: question.case.scene.name,
            output: Output {
                name: output.name,
                named: question.is_named,
                others: question.other_outputs(),
                unit: output.unit,
                value: number(unit::stated(answer.linear.value, output.factor)),
                error_unit: self.unit.name,
            },
            place: self.place(&answer.place),
            contributions: self.contributions(),
            bands: Bands {
                worst: self.error(answer.linear.worst),
                deviation: self.error(answer.linear.deviation),
                second: answer.second.as_ref().map(|one| self.second(one)),
                monte_carlo: answer.made.as_ref().map(|one| self.made(one)),
            },
            range: self.range(),
            allocation: answer.allocation.as_ref().map(|one| self.allocation(one)),
            changed: question.changed.clone(),
            changes: question.case.constants.changes.clone(),
            notes: question.notes.clone(),
            status: match answer.made.as_ref().map(|made| made.places[0].status) {
                None | Some(Assembled::Complete) => Status::Complete,
                Some(Assembled::Conditional) => Status::Conditional,
                Some(Assembled::Empty) => Status::Empty,
            },
            seconds: answer.seconds,
            figure: json::path(figure),
        }
    }

    fn error(&self, value: f64) -> Number {
        number(unit::stated(value, self.unit.factor))
    }

    fn estimate(&self, estimate: found::Estimate) -> Estimate {
        Estimate {
            value: self.error(estimate.value),
            low: self.error(estimate.low),
            high: self.error(estimate.high),
        }
    }

    fn place(&self, place: &[f64]) -> Vec<Amount> {
        Amount::all(&self.question.case.drivers, place)
    }

    fn contributions(&self) -> Vec<Contribution> {
        let question = self.question;
        let all = self.answer.linear.contributions.iter().enumerate();
        let one = all.map(|(index, one)| {
            let quantity = question.labels[index].quantity;
            let source = &question.study.sources[index];
            Contribution {
                name: quantity.name,
                play: question.labels[index].is_play,
                unit: quantity.unit,
                half_width: number(unit::stated(source.half_width, quantity.factor)),
                distribution: source.distribution.name(),
                influence: number(one.influence / self.unit.factor * quantity.factor),
                worst: self.error(one.worst),
                deviation: self.error(one.deviation),
                share: number(one.share),
                variance_share: number(one.variance_share),
            }
        });
        one.collect()
    }

    fn second(&self, second: &Second) -> SecondOrder {
        let corners = |corners: &Corners| Extremes {
            least: self.error(corners.least),
            greatest: self.error(corners.greatest),
            tried: corners.tried,
            failed: corners.failed,
        };
        let difference = |one: found::Difference| Difference {
            rms: self.error(one.rms),
            greatest: self.error(one.greatest),
        };
        SecondOrder {
            mean: self.error(second.moments.mean),
            deviation: self.error(second.moments.deviation),
            skewness: number(second.moments.skewness),
            extremes_quadratic: second.extremes.map(|one| corners(&one.quadratic)),
            extremes_closed: second.extremes.map(|one| corners(&one.exact)),
            missed_by_first_order: difference(second.differences.linear),
            missed_by_second_order: difference(second.differences.quadratic),
            trusted: second.is_trusted(),
        }
    }

    fn made(&self, made: &found::MonteCarlo) -> MonteCarlo {
        let (place, sampling) = (&made.places[0], &self.question.sampling);
        let quantiles = place.quantiles.iter();
        let quantiles =
            quantiles.map(|one| Quantile { level: one.level, error: self.estimate(one.estimate) });
        let failures = place.failures;
        MonteCarlo {
            drawn: place.drawn,
            assembled: place.assembled,
            seed: sampling.seed,
            confidence: sampling.confidence,
            failures: Estimate {
                value: number(failures.value),
                low: number(failures.low),
                high: number(failures.high),
            },
            mean: self.estimate(place.mean),
            deviation: self.estimate(place.deviation),
            skewness: number(place.skewness),
            least: self.error(place.least),
            greatest: self.error(place.greatest),
            share_beyond_each: number(place.beyond),
            quantiles: quantiles.collect(),
        }
    }

    fn range(&self) -> Range {
        let (question, answer) = (self.question, self.answer);
        let worst = found::worst_place(&answer.range);
        let ranking = answer.ranking.iter().map(|rank| Rank {
            name: label(question, rank.source),
            mean_share: number(rank.mean),
            largest_share: number(rank.largest),
            at: self.place(&question.study.places[rank.place]),
        });
        Range {
            places: answer.range.len(),
            worst: self.error(answer.range[worst].worst),
            at: self.place(&question.study.places[worst]),
            ranking: ranking.collect(),
        }
    }

    fn allocation(&self, chosen: &found::Allocation) -> Allocation {
        let own = self.question.labels.iter().filter(|one| !one.is_play);
        let half_width = |(quantity, value): (&'static Quantity, &f64)| HalfWidth {
            name: quantity.name,
            unit: quantity.unit,
            half_width: number(unit::stated(*value, quantity.factor)),
        };
        let tolerances = own.map(|label| label.quantity).zip(&chosen.tolerances);
        let active = chosen.active.iter();
        let active = active.map(|one| Active { at: self.place(&one.at), share: number(one.share) });
        let wanted = self.question.allocation.as_ref();
        Allocation {
            band: wanted.and_then(|wanted| self.error(wanted.band)),
            tolerances: tolerances.map(half_width).collect(),
            cost: number(chosen.cost),
            price: number(chosen.price),
            greatest: self.error(chosen.greatest),
            greatest_at: self.place(&chosen.greatest_at),
            active: active.collect(),
            rounds: chosen.rounds,
        }
    }
}
