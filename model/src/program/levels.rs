//! In which order operations are best done: the sines and cosines that can be taken together are, those of one angle as
//! a pair.

use std::collections::{BTreeMap, BTreeSet};

use super::{Function, OperationKind, Program, Value};

/// The order in which operations are done: all that can be done before any sine, then the sines that can be taken
/// then, all at once, and so on. Each entry is one batch of sines and the operations before it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Operations before the batch.
    pub before: Vec<Value>,
    /// Sines and cosines of the batch.
    pub batch: Vec<Value>,
}

/// Sine and cosine of one angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The angle.
    pub angle: Value,
    /// Its sine, if that is read.
    pub sine: Option<Value>,
    /// Its cosine, if that is read.
    pub cosine: Option<Value>,
}

impl Program {
    /// Whether an operation is a sine or cosine, and of what.
    pub fn angle(&self, value: Value) -> Option<Value> {
        match self.kind(value) {
            OperationKind::Call(Function::Sin | Function::Cos, arguments) => {
                arguments.first().copied()
            }
            _ => None,
        }
    }

    /// Sorts operations into levels.
    pub fn levels(&self, needed: &BTreeSet<Value>) -> Vec<Level> {
        let mut level: BTreeMap<Value, usize> = BTreeMap::new();
        let mut levels: Vec<Level> = Vec::new();
        for value in needed {
            let read = self.kind(*value).operands();
            let own =
                read.iter().filter_map(|operand| level.get(operand)).copied().max().unwrap_or(0);
            while levels.len() <= own {
                levels.push(Level::default());
            }
            if self.angle(*value).is_some() {
                levels[own].batch.push(*value);
                level.insert(*value, own + 1);
            } else {
                levels[own].before.push(*value);
                level.insert(*value, own);
            }
        }
        levels
    }

    /// Sorts the sines and cosines of a batch by their angles.
    pub fn pairs(&self, batch: &[Value]) -> Vec<Pair> {
        let mut pairs: Vec<Pair> = Vec::new();
        for value in batch {
            let Some(angle) = self.angle(*value) else {
                continue;
            };
            let index = pairs.iter().position(|pair| pair.angle == angle).unwrap_or_else(|| {
                pairs.push(Pair { angle, sine: None, cosine: None });
                pairs.len() - 1
            });
            match self.kind(*value) {
                OperationKind::Call(Function::Sin, _) => pairs[index].sine = Some(*value),
                _ => pairs[index].cosine = Some(*value),
            }
        }
        pairs
    }
}
