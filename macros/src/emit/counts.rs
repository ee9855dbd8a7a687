//! How many operations each emitted function does.

use std::collections::BTreeSet;

use assur_model::program::{Stage, Value};

use super::layout::Layout;
use super::schedule;

/// Operations of one call of each emitted function.
pub struct Counts {
    /// Once per parameter set.
    pub prepare: usize,
    /// Once per instant.
    pub instant: usize,
    /// Per evaluation of the derivative; of a linkage per position, a group without closed form being iterated once.
    pub derivative: usize,
    /// Per evaluation of the Jacobian; of a linkage of the influence coefficients.
    pub jacobian: usize,
    /// Per evaluation of all outputs.
    pub outputs: usize,
}

impl Counts {
    /// All of them.
    pub fn all(&self) -> [usize; 5] {
        [self.prepare, self.instant, self.derivative, self.jacobian, self.outputs]
    }
}

/// Counts the operations of a scene.
pub fn of(layout: &Layout<'_>) -> Counts {
    let program = layout.program();
    let results = &program.results;
    let count = |wanted: &[Value], from: Stage| {
        let given = |value: Value| {
            program.operations[value.0 as usize].stage < from
                && !schedule::is_number(program, value)
        };
        schedule::count(program, &schedule::needed(program, wanted, &given))
    };
    let list = |values: &BTreeSet<Value>| values.iter().copied().collect::<Vec<Value>>();
    let (evaluated, slopes): (Vec<Value>, Vec<Value>) = match &layout.scene.linkage {
        Some(linkage) => {
            let closing = &results.closing;
            (closing.of_position(&linkage.groups), closing.influence.clone())
        }
        None => {
            let slopes = results.jacobian.iter().map(|entry| entry.2);
            (results.derivative.clone(), slopes.collect())
        }
    };
    let there = |value: Value| {
        let stage = program.operations[value.0 as usize].stage;
        (stage < Stage::Instant && !schedule::is_number(program, value))
            || layout.timed.contains(&value)
    };
    let slope_count = schedule::count(program, &schedule::needed(program, &slopes, &there));
    Counts {
        prepare: count(&list(&layout.prepared), Stage::Constant),
        instant: count(&list(&layout.timed), Stage::Instant),
        derivative: count(&evaluated, Stage::State),
        jacobian: slope_count,
        outputs: count(&results.outputs, Stage::Instant),
    }
}
