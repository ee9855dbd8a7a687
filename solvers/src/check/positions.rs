//! Published facts of a linkage.

use super::Failed;
use crate::registry::{At, Expectation, RunLinkage, SceneEntry, Subject};

/// The computed value of what a fact speaks of.
pub(super) fn value(
    scene: &SceneEntry,
    run: &dyn RunLinkage,
    fact: &Expectation,
) -> Result<f64, Failed> {
    let nowhere = || Failed(format!("the linkage has no place {:?}", fact.at));
    let place = match fact.at {
        At::Position(positions) => {
            let mut place: Vec<f64> = run.ranges().iter().map(|range| range.start).collect();
            for (driver, position) in positions {
                *place.get_mut(*driver).ok_or_else(nowhere)? = *position;
            }
            place
        }
        At::Time(time) => run.drive(time).ok_or_else(nowhere)?,
        _ => return Err(nowhere()),
    };
    let failed = |error: &dyn std::fmt::Display| Failed(format!("no position: {error}"));
    match fact.subject {
        Subject::Influence(output, variable) => {
            let all = run.influence(&place).map_err(|error| failed(&error))?;
            let count = all.len() / scene.outputs.len().max(1);
            all.get(output * count + variable)
                .copied()
                .ok_or_else(nowhere)
        }
        subject => {
            let path = run.follow(&[place]).map_err(|error| failed(&error))?;
            let Some(sample) = path.samples.first() else {
                let why = path
                    .stopped
                    .map_or_else(String::new, |error| error.to_string());
                return Err(failed(&why));
            };
            let found = match subject {
                Subject::Output(index) => sample.outputs.get(index),
                Subject::State(index) | Subject::Influence(index, _) => {
                    sample.dependents.get(index)
                }
            };
            found.copied().ok_or_else(nowhere)
        }
    }
}
