//! Published facts of a linkage.

use super::Failed;
use crate::registry::SceneEntry;
use assur_solvers::closure::{Along, AnyLinkage, Sample, Stroke};
use assur_solvers::shape::{At, Expectation, Subject};

/// The computed value of what a fact speaks of.
pub(super) fn value(
    scene: &SceneEntry,
    run: &dyn AnyLinkage,
    fact: &Expectation,
) -> Result<f64, Failed> {
    match fact.at {
        At::Maximum => Ok(stroke(scene, run, fact)?.greatest.value),
        At::Minimum => Ok(stroke(scene, run, fact)?.least.value),
        At::Amplitude => {
            let found = stroke(scene, run, fact)?;
            Ok(found.least.value.abs().max(found.greatest.value.abs()))
        }
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
        At::Run => measured(run, fact),
        At::Driver(..) => Err(nowhere(fact)),
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
    run: &dyn AnyLinkage,
    fact: &Expectation,
    place: Vec<f64>,
) -> Result<f64, Failed> {
    if let Subject::Influence(output, variable) = fact.subject {
        let all = run.influence(&place).map_err(|error| failed(&error))?;
        let count = all.len() / scene.outputs.len().max(1);
        let value = all.get(output * count + variable).copied();
        return value.ok_or_else(|| nowhere(fact));
    }
    along(run, fact, &[place])?.first().copied().ok_or_else(|| nowhere(fact))
}

/// The values at several places on one way.
fn along(
    run: &dyn AnyLinkage,
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
        _ => None,
    };
    let values: Option<Vec<f64>> = path.samples.iter().map(value).collect();
    values.ok_or_else(|| nowhere(fact))
}

/// A measure of the whole way.
fn measured(run: &dyn AnyLinkage, fact: &Expectation) -> Result<f64, Failed> {
    let (Subject::Measure(index), Some(way)) = (fact.subject, run.way()) else {
        return Err(nowhere(fact));
    };
    let found = run.measures(way).map_err(|error| failed(&error))?;
    let value = found.get(index).and_then(|one| one.value.ok());
    value.ok_or_else(|| nowhere(fact))
}

/// The stroke of a value over the range of the driver that is swept, or over the time of the task.
fn stroke(scene: &SceneEntry, run: &dyn AnyLinkage, fact: &Expectation) -> Result<Stroke, Failed> {
    let task = match run.way().ok_or_else(|| nowhere(fact))? {
        Along::Driver(driver, (from, to)) => Along::Driver(driver, (from.min(to), from.max(to))),
        way => way,
    };
    let index = match fact.subject {
        Subject::Output(index) => index,
        Subject::State(index) => scene.outputs.len() + index,
        _ => return Err(nowhere(fact)),
    };
    let strokes = run.strokes(task).map_err(|error| failed(&error))?;
    strokes.into_iter().nth(index).ok_or_else(|| nowhere(fact))
}
