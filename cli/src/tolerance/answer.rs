//! The numbers of the answer, SI units.

use std::time::Instant;

use assur::tolerance::{
    self, Allocation, AllocationError, Differences, Extremes, Linear, Moments, MonteCarlo, Rank,
    Study, ToleranceError,
};

use assur::shape::Quantity;

use super::arguments::Kind;
use super::question::{Label, Question};
use crate::error::Failure;
use crate::plot::{Band, Chart, name};
use crate::show::number;
use crate::show::progress::Progress;

/// Linkages over which the orders are compared.
const COMPARED: u64 = 10_000;

/// All that was found.
pub struct Answer {
    /// To first order, over the range.
    pub range: Vec<Linear>,
    /// To first order over the range of the first driver alone, where the range is a grid.
    pub along: Option<Vec<Linear>>,
    /// The sources by what they contribute over the range.
    pub ranking: Vec<Rank>,
    /// The place that is looked at more closely: positions of the drivers.
    pub place: Vec<f64>,
    /// To first order there.
    pub linear: Linear,
    /// To second order there.
    pub second: Option<Second>,
    /// Made at random there.
    pub made: Option<MonteCarlo>,
    /// Tolerances of least cost.
    pub allocation: Option<Allocation>,
    /// Seconds that all of it took.
    pub seconds: f64,
}

/// To second order.
pub struct Second {
    /// Mean, standard deviation, skewness.
    pub moments: Moments,
    /// All extremes; none where there are too many sources.
    pub extremes: Option<Extremes>,
    /// What the orders miss.
    pub differences: Differences,
}

/// Share of the error above which what an order misses is pointed out.
pub const MISSED: f64 = 0.05;

impl Second {
    /// Whether mean, standard deviation and worst case of the second order can be trusted: it misses little of linkages
    /// made at random and of the extremes, and all of them assemble. Near a dead point it cannot.
    pub fn is_trusted(&self) -> bool {
        let differences = &self.differences;
        let follows = differences.quadratic.rms <= MISSED * differences.errors.rms;
        let reaches = self.extremes.is_none_or(|all| {
            let (form, exact) = (all.quadratic.worst(), all.exact.worst());
            all.exact.failed == 0 && (form - exact).abs() <= MISSED * exact
        });
        differences.failed == 0 && follows && reaches
    }
}

/// Finds everything.
///
/// # Errors
/// Where the linkage does not get to a place, or a band cannot be kept.
pub fn find(question: &Question) -> Result<Answer, Failure> {
    let clock = Instant::now();
    let said = |error| said(question, error);
    let study = &question.study;
    let linear = |study: &Study| {
        let influences = question.case.run().influences(study)?;
        tolerance::linear(&influences, &study.sources)
    };
    let range = linear(study).map_err(said)?;
    let along = question
        .along
        .as_ref()
        .map(|places| linear(&Study { places: places.clone(), ..study.clone() }));
    let along = along.transpose().map_err(said)?;
    let worst = tolerance::worst_place(&range);
    let place = question.at.clone().unwrap_or_else(|| study.places[worst].clone());
    let there = Study { places: vec![place.clone()], ..study.clone() };
    let at_place = linear(&there).map_err(said)?.swap_remove(0);
    if !(at_place.worst.is_finite() && (at_place.deviation * at_place.deviation).is_finite()) {
        return Err(Failure::request(
            "the tolerances are too large to compute with: the sum of their squares is not finite",
        )
        .remedy("choose a smaller --scale, or smaller tolerances with --tolerance"));
    }
    let second = match question.kind.wants(Kind::Second) {
        true => Some(second(question, &there).map_err(said)?),
        false => None,
    };
    let made = match question.kind.wants(Kind::MonteCarlo) {
        true => Some(made(question, &there).map_err(said)?),
        false => None,
    };
    Ok(Answer {
        ranking: tolerance::ranking(&range),
        range,
        along,
        place,
        linear: at_place,
        second,
        made,
        allocation: allocation(question)?,
        seconds: clock.elapsed().as_secs_f64(),
    })
}

fn second(question: &Question, study: &Study) -> Result<Second, ToleranceError> {
    let form = question.case.run().quadratics(study)?.swap_remove(0);
    let extremes = match question.case.run().corners(study) {
        Ok(all) => Some(all[0]),
        Err(ToleranceError::TooManyCorners { .. }) => None,
        Err(error) => return Err(error),
    };
    let seed = question.sampling.seed;
    Ok(Second {
        moments: form.moments(&study.sources),
        extremes,
        differences: question.case.run().differences(study, COMPARED, seed)?[0],
    })
}

fn made(question: &Question, study: &Study) -> Result<MonteCarlo, ToleranceError> {
    let (made, _) = question.case.made_in_words();
    let what = format!("{}, {made} made at random", question.case.constants.mechanism.name);
    let bar = Progress::start(what, question.sampling.samples);
    let progress = |more| bar.advance_by(more);
    question.case.run().monte_carlo(study, &question.sampling, &progress)
}

fn allocation(question: &Question) -> Result<Option<Allocation>, Failure> {
    let Some(wanted) = &question.allocation else {
        return Ok(None);
    };
    let run = question.case.run();
    let found = run.allocate(&question.study, &wanted.candidates, wanted.rule, wanted.band);
    found.map(Some).map_err(|error| out_of_reach(question, error))
}

/// A failure of the solvers, with places and sources by their names.
fn said(question: &Question, error: ToleranceError) -> Failure {
    let source = |source: usize| question.labels.get(source).map_or("?", |one| one.quantity.name);
    match error {
        ToleranceError::BadSamples { samples, least, most } => {
            Failure::request(format!("{samples} linkages cannot be made"))
                .place(format!("--samples {samples}"))
                .remedy(format!("choose from {least} to {most}"))
        }
        ToleranceError::BadHalfWidth { source: index, half_width } => {
            Failure::request(format!("`{}` cannot err by {half_width}", source(index)))
        }
        ToleranceError::Closure(error) => {
            Failure::numerical("the linkage does not get to all places")
                .reason(question.case.tell(&error).reason)
                .remedy("look at another place with --at, or change the values with --set")
        }
        ToleranceError::NotFinite { at, .. } => Failure::numerical(format!(
            "at {} the output has no finite influence coefficients",
            place_text(question, &at)
        ))
        .reason("a dead point may be there"),
        other => Failure::request(other.to_string()),
    }
}

fn out_of_reach(question: &Question, error: AllocationError) -> Failure {
    let name = |candidate: usize| {
        let own = question.labels.iter().filter(|one| !one.is_play);
        own.map(|one| one.quantity.name).nth(candidate).unwrap_or("?")
    };
    let unit = Unit::of(question.output());
    match error {
        AllocationError::Tolerance(error) => said(question, error),
        AllocationError::OutOfReach {
            at,
            reached,
            band,
            candidate,
            share,
        } => Failure::numerical(format!(
            "no tolerances within their limits keep the band of {}",
            unit.text(band)
        ))
        .place(format!("at {}", place_text(question, &at)))
        .reason(format!(
            "with all of them at their lower limits the error is {}; {:.0} % of it comes from `{}`",
            unit.text(reached),
            100.0 * share,
            name(candidate)
        ))
        .remedy("lower that limit with --limit, or widen the band"),
        AllocationError::Unbounded { candidate } => Failure::request(format!(
            "`{}` has no influence on the output: nothing bounds its tolerance",
            name(candidate)
        ))
        .remedy(format!(
            "give it an upper limit, --limit {}=..1mm",
            name(candidate)
        )),
        AllocationError::BadLimits { candidate, .. } => {
            Failure::request(format!("the limits of `{}` leave nothing", name(candidate)))
                .place("--limit")
        }
        AllocationError::BadCost {
            candidate, factor, ..
        } => Failure::request(format!(
            "a weight of `{}` that gives a cost of {factor}/t cannot be",
            name(candidate)
        ))
        .place("--cost")
        .remedy("give a positive number"),
        AllocationError::BadBand { .. } => {
            Failure::request("the band must be positive").place("--allocate")
        }
        AllocationError::NotSolved {
            at,
            status,
            iterations,
        } => Failure::numerical("no tolerances of least cost are found")
            .place(format!("at {}, where the output errs most", place_text(question, &at)))
            .reason(format!(
                "the conic programme stops after {iterations} iterations: {status}; beside a dead point the influences \
                 are too far apart"
            ))
            .remedy(
                "let the drivers go less near to their dead points (their range in the equation file), or give upper \
                 limits with --limit",
            ),
        other => Failure::numerical(other.to_string()),
    }
}

/// Positions of the drivers in words.
pub fn place_text(question: &Question, place: &[f64]) -> String {
    question.case.label(place)
}

/// The unit in which errors of the output are printed: thousandths of a radian for an angle.
#[derive(Clone, Copy)]
pub struct Unit {
    /// Its name.
    pub name: &'static str,
    /// Its value in SI units.
    pub factor: f64,
}

impl Unit {
    /// That of the output.
    pub fn of(output: &Quantity) -> Self {
        match output.unit {
            "deg" | "rad" => Self { name: "mrad", factor: 1e-3 },
            name => Self { name, factor: output.factor },
        }
    }

    /// The unit by another one, `mrad/mm`.
    pub fn per(self, other: &str) -> String {
        let wrapped = |unit: &str| match unit.contains(['/', ' ', '*']) {
            true => format!("({unit})"),
            false => unit.to_owned(),
        };
        match (self.name, other) {
            (own, "") => own.to_owned(),
            ("", other) => format!("1/{}", wrapped(other)),
            (own, other) => format!("{}/{}", wrapped(own), wrapped(other)),
        }
    }

    /// A value with the unit.
    pub fn text(self, value: f64) -> String {
        let number = number::significant(value / self.factor, 5);
        format!("{number} {}", self.name).trim_end().to_owned()
    }
}

impl Answer {
    /// What the figure shows.
    pub fn chart(&self, question: &Question) -> Chart {
        let unit = Unit::of(question.output());
        let driver = question.case.drivers.first();
        let along = self.along.as_ref().unwrap_or(&self.range);
        let places = question.along.as_ref().unwrap_or(&question.study.places);
        let abscissa = |place: &Vec<f64>| match driver {
            Some(driver) => place.first().copied().unwrap_or(f64::NAN) / driver.factor,
            None => f64::NAN,
        };
        let band = |rank: &Rank| Band {
            name: figure_label(question, rank.source),
            values: along
                .iter()
                .map(|one| one.contributions[rank.source].worst / unit.factor)
                .collect(),
        };
        let changed = match question.changed.as_str() {
            "" => String::new(),
            changed => format!("with {changed}"),
        };
        Chart {
            title: format!(
                "{}, scene {}: what contributes to the error of {}",
                question.case.constants.mechanism.title,
                question.case.scene.name,
                name::set(question.output().name).text
            ),
            note: changed,
            abscissa: match driver {
                Some(driver) => (name::set(driver.name).text, driver.unit.to_owned()),
                None => ("place".to_owned(), String::new()),
            },
            ordinate: unit.name.to_owned(),
            places: places.iter().map(abscissa).collect(),
            bands: self.ranking.iter().map(band).collect(),
            deviation: along.iter().map(|one| one.deviation / unit.factor).collect(),
        }
    }
}

/// What a source is called.
pub fn label(question: &Question, source: usize) -> String {
    let label = question.labels[source];
    with_play(label, label.quantity.name)
}

/// What a source is called in a figure.
fn figure_label(question: &Question, source: usize) -> String {
    let label = question.labels[source];
    with_play(label, &name::set(label.quantity.name).text)
}

fn with_play(label: Label, name: &str) -> String {
    match label.is_play {
        true => format!("{name} (play)"),
        false => name.to_owned(),
    }
}
