//! Published facts of a linkage.

use super::Failed;
use crate::problem::Span;
use crate::registry::{At, Expectation, RunLinkage, Sample, SceneEntry, Subject};

/// Samples over a range when an extreme is sought.
const SAMPLES: usize = 400;
/// How often the neighbourhood of the largest is looked at more closely.
const ROUNDS: usize = 5;

/// The computed value of what a fact speaks of.
pub(super) fn value(
    scene: &SceneEntry,
    run: &dyn RunLinkage,
    fact: &Expectation,
) -> Result<f64, Failed> {
    match fact.at {
        At::Maximum => largest(run, fact, |value| value),
        At::Minimum => largest(run, fact, |value| -value).map(|value| -value),
        At::Amplitude => largest(run, fact, f64::abs),
        At::Position(positions) => {
            let mut place: Vec<f64> = run.ranges().iter().map(|range| range.start).collect();
            for (driver, position) in positions {
                *place.get_mut(*driver).ok_or_else(|| nowhere(fact))? = *position;
            }
            at(scene, run, fact, place)
        }
        At::Time(time) => {
            let place = run.drive(time).ok_or_else(|| nowhere(fact))?;
            at(scene, run, fact, place)
        }
        At::Driver(..) | At::Run => Err(nowhere(fact)),
    }
}

fn nowhere(fact: &Expectation) -> Failed {
    Failed(format!("the linkage has no place {:?}", fact.at))
}

fn failed(error: &dyn std::fmt::Display) -> Failed {
    Failed(format!("no position: {error}"))
}

/// The value at a place.
fn at(
    scene: &SceneEntry,
    run: &dyn RunLinkage,
    fact: &Expectation,
    place: Vec<f64>,
) -> Result<f64, Failed> {
    if let Subject::Influence(output, variable) = fact.subject {
        let all = run.influence(&place).map_err(|error| failed(&error))?;
        let count = all.len() / scene.outputs.len().max(1);
        let value = all.get(output * count + variable).copied();
        return value.ok_or_else(|| nowhere(fact));
    }
    along(run, fact, &[place])?
        .first()
        .copied()
        .ok_or_else(|| nowhere(fact))
}

/// The values at several places on one way.
fn along(
    run: &dyn RunLinkage,
    fact: &Expectation,
    places: &[Vec<f64>],
) -> Result<Vec<f64>, Failed> {
    let path = run.follow(places).map_err(|error| failed(&error))?;
    if let Some(error) = path.stopped {
        return Err(failed(&error));
    }
    let value = |sample: &Sample| match fact.subject {
        Subject::Output(index) => sample.outputs.get(index).copied(),
        Subject::State(index) => sample.dependents.get(index).copied(),
        Subject::Influence(..) | Subject::Measure(_) => None,
    };
    let values: Option<Vec<f64>> = path.samples.iter().map(value).collect();
    values.ok_or_else(|| nowhere(fact))
}

/// The largest of what is made of a value over the range of the first driver, or over the time of the task.
fn largest(
    run: &dyn RunLinkage,
    fact: &Expectation,
    size: impl Fn(f64) -> f64,
) -> Result<f64, Failed> {
    let (mut from, mut to) = match (run.span(), run.ranges().first()) {
        (Span::Open, Some(range)) => (range.from, range.to),
        (span, _) => span.limits(),
    };
    let place = |share: f64| {
        if let Some(place) = run.drive(share) {
            return place;
        }
        let mut place: Vec<f64> = run.ranges().iter().map(|range| range.start).collect();
        place[0] = share;
        place
    };
    let mut best = f64::NEG_INFINITY;
    for _ in 0..ROUNDS {
        let share = |index: usize| from + (to - from) * index as f64 / SAMPLES as f64;
        let shares: Vec<f64> = (0..=SAMPLES).map(share).collect();
        let places: Vec<Vec<f64>> = shares.iter().map(|share| place(*share)).collect();
        let values = along(run, fact, &places)?;
        let sizes = values.into_iter().map(&size).enumerate();
        let (index, value) = sizes.fold((0, f64::NEG_INFINITY), |best, one| match one.1 > best.1 {
            true => one,
            false => best,
        });
        best = best.max(value);
        // Between its neighbours the largest sample is beside one hill.
        (from, to) = (
            shares[index.saturating_sub(1)],
            shares[(index + 1).min(SAMPLES)],
        );
    }
    Ok(best)
}
