//! The operations that lead to some values, in the order in which they are done.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Fused, OperationKind, Pair, Program, Value};

/// Something that is done.
#[derive(Clone, Debug)]
pub enum Step {
    /// An operation.
    Operation(Value),
    /// A sum with a product that is rounded together with it.
    Fused(Value, Fused),
    /// Sines and cosines.
    Sines(Vec<Pair>),
}

impl Step {
    /// The values that it reads.
    pub fn reads(&self, program: &Program) -> Vec<Value> {
        match self {
            Self::Operation(value) => program.kind(*value).operands(),
            Self::Fused(_, fused) => {
                let (Fused::Add(a, b, c) | Fused::Subtract(a, b, c) | Fused::SubtractFrom(a, b, c)) =
                    *fused;
                vec![a, b, c]
            }
            Self::Sines(pairs) => pairs.iter().map(|pair| pair.angle).collect(),
        }
    }
}

/// The steps to some values, from those that are there already.
pub fn steps(program: &Program, needed: &BTreeSet<Value>, wanted: &[Value]) -> Vec<Step> {
    let written = program.written(needed, wanted);
    let mut fused = BTreeMap::new();
    let mut within = BTreeSet::new();
    for value in needed {
        if let Some(one) = program.fused(*value, &written) {
            let (Fused::Add(.., c) | Fused::Subtract(.., c) | Fused::SubtractFrom(.., c)) = one;
            let operands = program.kind(*value).operands();
            within.extend(operands.into_iter().filter(|operand| *operand != c));
            fused.insert(*value, one);
        }
    }
    let mut steps = Vec::new();
    for level in program.levels(needed) {
        let own = level.before.into_iter().filter(|value| !within.contains(value));
        let is_done = |value: &Value| {
            let kind = program.kind(*value);
            !matches!(kind, OperationKind::Number(_) | OperationKind::Input(_))
        };
        steps.extend(own.filter(is_done).map(|value| match fused.get(&value) {
            Some(fused) => Step::Fused(value, *fused),
            None => Step::Operation(value),
        }));
        let pairs = program.pairs(&level.batch);
        if !pairs.is_empty() {
            steps.push(Step::Sines(pairs));
        }
    }
    steps
}
