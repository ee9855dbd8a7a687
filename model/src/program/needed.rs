//! What results rest on, and what kind of thing a value is.

use std::collections::BTreeSet;

use assur_functions::table::ORDERS;

use super::{Form, Input, OperationKind as Kind, Program, Stage, Value};

/// What kind of thing a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A scalar.
    Number,
    /// A condition.
    Mask,
    /// The factors of a matrix with this many rows.
    Factor(Form, usize),
    /// The solution of a system with this many rows.
    Vector(usize),
}

impl Program {
    /// What computes a value.
    pub fn kind(&self, value: Value) -> &Kind {
        &self.operations[value.0 as usize].kind
    }

    /// How often a value changes.
    pub fn stage(&self, value: Value) -> Stage {
        self.operations[value.0 as usize].stage
    }

    /// Whether it goes separate ways for different numbers: where it searches, or solves loops that contradict each other.
    pub fn is_apart(&self) -> bool {
        self.operations.iter().any(|one| {
            matches!(one.kind, Kind::Search { .. } | Kind::Factor { form: Form::Bound { .. }, .. })
        })
    }

    /// What kind of thing a value is.
    pub fn shape(&self, value: Value) -> Shape {
        match self.kind(value) {
            Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => Shape::Mask,
            Kind::Factor { form, size, .. } => Shape::Factor(*form, *size as usize),
            Kind::Solve { right, .. } => Shape::Vector(right.len()),
            Kind::Table { .. } => Shape::Vector(ORDERS),
            _ => Shape::Number,
        }
    }

    /// Whether a value is a number of the program, which is never stored.
    pub fn is_number(&self, value: Value) -> bool {
        matches!(self.kind(value), Kind::Number(_))
    }

    /// The values that some results rest on, as far as the values given from outside, in the order of the program.
    pub fn needed(&self, wanted: &[Value], outside: &dyn Fn(Value) -> bool) -> BTreeSet<Value> {
        let mut needed = BTreeSet::new();
        let mut open: Vec<Value> = wanted.to_vec();
        while let Some(value) = open.pop() {
            if !outside(value) && needed.insert(value) {
                open.extend(self.kind(value).operands());
            }
        }
        needed
    }

    /// The values that some are made of beside a column of changes, and that do not change with it; numbers left out.
    pub fn steady(&self, wanted: &[Value]) -> Vec<Value> {
        let changing = self.changing(&self.needed(wanted, &|_| false));
        let read = changing.iter().flat_map(|value| self.kind(*value).operands());
        let read = read.chain(wanted.iter().copied());
        let steady: BTreeSet<Value> = read.filter(|value| !changing.contains(value)).collect();
        steady.into_iter().filter(|value| !self.is_number(*value)).collect()
    }

    /// Those of some values that change with a column of changes.
    pub fn changing(&self, among: &BTreeSet<Value>) -> BTreeSet<Value> {
        let mut changing = BTreeSet::new();
        for value in among {
            let kind = self.kind(*value);
            let is_change = matches!(kind, Kind::Input(Input::Change(_)));
            if is_change || kind.operands().iter().any(|one| changing.contains(one)) {
                changing.insert(*value);
            }
        }
        changing
    }

    /// The values of earlier stages that results of a stage read directly, or are; numbers left out.
    pub fn frontier(&self, wanted: &[Value], stage: Stage) -> BTreeSet<Value> {
        let earlier = |value: Value| self.stage(value) < stage;
        let mut border: BTreeSet<Value> =
            wanted.iter().copied().filter(|value| earlier(*value)).collect();
        for value in self.needed(wanted, &earlier) {
            let read = self.kind(value).operands();
            border.extend(read.into_iter().filter(|value| earlier(*value)));
        }
        border.retain(|value| !self.is_number(*value));
        border
    }
}
