//! The order of operations: operands first, stages rising, nothing that no result needs.

use std::collections::BTreeSet;

use super::{Operation, OperationKind, Program, Stage, Value};

impl OperationKind {
    /// The values that the operation reads.
    pub fn operands(&self) -> Vec<Value> {
        use OperationKind as Kind;
        match self {
            Kind::Number(_) | Kind::Input(_) => Vec::new(),
            Kind::Negate(a) | Kind::Not(a) | Kind::Table { at: a, .. } => vec![*a],
            Kind::Add(a, b) | Kind::Subtract(a, b) | Kind::Multiply(a, b) | Kind::Divide(a, b) => {
                vec![*a, *b]
            }
            Kind::Compare(_, a, b) | Kind::And(a, b) | Kind::Or(a, b) => vec![*a, *b],
            Kind::MultiplyAdd(a, b, c)
            | Kind::MultiplySubtract(a, b, c)
            | Kind::NegateMultiplyAdd(a, b, c) => {
                vec![*a, *b, *c]
            }
            Kind::Call(_, list) => list.clone(),
            Kind::Select { condition, then, otherwise } => vec![*condition, *then, *otherwise],
            Kind::Factor { entries, .. } => entries.clone(),
            Kind::Solve { factor, right } => {
                std::iter::once(*factor).chain(right.iter().copied()).collect()
            }
            Kind::Element { solution, .. } => vec![*solution],
            Kind::Search { captured, .. } => captured.clone(),
        }
    }

    /// Replaces each value that the operation reads.
    pub(super) fn replace(&mut self, new: &dyn Fn(Value) -> Value) {
        use OperationKind as Kind;
        let all = |list: &mut Vec<Value>| list.iter_mut().for_each(|one| *one = new(*one));
        match self {
            Kind::Number(_) | Kind::Input(_) => {}
            Kind::Negate(a) | Kind::Not(a) | Kind::Table { at: a, .. } => *a = new(*a),
            Kind::Add(a, b) | Kind::Subtract(a, b) | Kind::Multiply(a, b) | Kind::Divide(a, b) => {
                (*a, *b) = (new(*a), new(*b));
            }
            Kind::Compare(_, a, b) | Kind::And(a, b) | Kind::Or(a, b) => {
                (*a, *b) = (new(*a), new(*b))
            }
            Kind::MultiplyAdd(a, b, c)
            | Kind::MultiplySubtract(a, b, c)
            | Kind::NegateMultiplyAdd(a, b, c) => {
                (*a, *b, *c) = (new(*a), new(*b), new(*c));
            }
            Kind::Call(_, list) => all(list),
            Kind::Select { condition, then, otherwise } => {
                (*condition, *then, *otherwise) = (new(*condition), new(*then), new(*otherwise));
            }
            Kind::Factor { entries, .. } => all(entries),
            Kind::Solve { factor, right } => {
                *factor = new(*factor);
                all(right);
            }
            Kind::Element { solution, .. } => *solution = new(*solution),
            Kind::Search { captured, .. } => all(captured),
        }
    }
}

/// All values that some values are made of.
pub fn reach(program: &Program, results: &[Value]) -> BTreeSet<Value> {
    let mut seen = BTreeSet::new();
    let mut stack = results.to_vec();
    while let Some(value) = stack.pop() {
        if seen.insert(value) {
            stack.extend(program.operations[value.0 as usize].kind.operands());
        }
    }
    seen
}

/// Sorts the operations by stage, keeping their order otherwise, and leaves out what no result needs.
pub fn sort(program: &mut Program) {
    let needed = reach(program, &program.results.all());
    let mut kept: Vec<usize> = needed.iter().map(|value| value.0 as usize).collect();
    kept.sort_by_key(|index| (program.operations[*index].stage, *index));
    let mut place = vec![0_u32; program.operations.len()];
    for (new, old) in kept.iter().enumerate() {
        place[*old] = new as u32;
    }
    let new = |value: Value| Value(place[value.0 as usize]);
    let operations: Vec<Operation> = kept
        .iter()
        .map(|old| {
            let mut operation = program.operations[*old].clone();
            operation.kind.replace(&new);
            operation
        })
        .collect();
    program.operations = operations;
    program.results = program.results.map(new);
    debug_assert!(program.operations.is_sorted_by_key(|operation| -> Stage { operation.stage }));
}
