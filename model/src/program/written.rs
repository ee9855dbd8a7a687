//! Which values are written where they are read, and so which products go into the sums that read them.

use std::collections::{BTreeMap, BTreeSet};

use super::{OperationKind as Kind, Program, Value};

/// Most operations in one expression.
const LONGEST: usize = 8;

/// A product that is rounded together with the sum that it goes into, where numbers are fused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fused {
    /// `a * b + c`
    Add(Value, Value, Value),
    /// `a * b - c`
    Subtract(Value, Value, Value),
    /// `c - a * b`, its operands in the order a, b, c
    SubtractFrom(Value, Value, Value),
}

impl Program {
    /// Of the values that some wanted ones need, those that are written where they are read: nameless, read once, and not
    /// long.
    pub fn written(&self, needed: &BTreeSet<Value>, wanted: &[Value]) -> BTreeSet<Value> {
        let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
        let inner = needed.iter().flat_map(|value| self.kind(*value).operands());
        for value in inner.chain(wanted.iter().copied()) {
            *uses.entry(value).or_insert(0) += 1;
        }
        let mut weights: BTreeMap<Value, usize> = BTreeMap::new();
        for value in needed {
            let (operation, kind) = (&self.operations[value.0 as usize], self.kind(*value));
            let is_given = matches!(kind, Kind::Number(_) | Kind::Input(_));
            let is_apart = matches!(kind, Kind::Factor { .. } | Kind::Solve { .. });
            if operation.name.is_some() || is_given || is_apart || self.angle(*value).is_some() {
                continue;
            }
            let operands = kind.operands();
            let weight = 1 + operands.iter().filter_map(|one| weights.get(one)).sum::<usize>();
            let is_short = uses.get(value).is_none_or(|uses| *uses <= 1) && weight <= LONGEST;
            if is_short || matches!(kind, Kind::Element { .. }) {
                weights.insert(*value, weight);
            }
        }
        weights.into_keys().collect()
    }

    /// The product that goes into a sum or difference, if one is written there: the second operand rather than the first.
    pub fn fused(&self, value: Value, written: &BTreeSet<Value>) -> Option<Fused> {
        let product = |value: &Value| match self.kind(*value) {
            Kind::Multiply(a, b) if written.contains(value) => Some((*a, *b)),
            _ => None,
        };
        match self.kind(value) {
            Kind::Add(first, second) => match (product(first), product(second)) {
                (_, Some((a, b))) => Some(Fused::Add(a, b, *first)),
                (Some((a, b)), None) => Some(Fused::Add(a, b, *second)),
                (None, None) => None,
            },
            Kind::Subtract(first, second) => match (product(first), product(second)) {
                (_, Some((a, b))) => Some(Fused::SubtractFrom(a, b, *first)),
                (Some((a, b)), None) => Some(Fused::Subtract(a, b, *second)),
                (None, None) => None,
            },
            _ => None,
        }
    }
}
