//! A program on numbers: what the emitted Rust computes, without compiling it.

use std::collections::HashMap;

use assur_functions::table::ORDERS;

use super::{Form, Input, Line, OperationKind, Program, Value};
use crate::expression::solve;

/// Values of all operations at one instant and state.
#[derive(Clone, Debug)]
pub struct Values {
    numbers: Vec<f64>,
}

/// Where a linkage is evaluated.
#[derive(Clone, Copy, Debug, Default)]
pub struct Configuration<'a> {
    /// Positions of the drivers, and their speeds and accelerations where these are given.
    pub drivers: &'a [f64],
    /// Dependent coordinates, then cosines and sines of those that are angles.
    pub position: &'a [f64],
    /// Assembly modes of the groups.
    pub modes: &'a [f64],
}

impl Values {
    /// The value of an operation; conditions are 1 or 0.
    pub fn get(&self, value: Value) -> f64 {
        self.numbers[value.0 as usize]
    }

    /// The values of several.
    pub fn all(&self, values: &[Value]) -> Vec<f64> {
        values.iter().map(|value| self.get(*value)).collect()
    }
}

impl Program {
    /// Evaluates all operations. Shapes: `parameters`, `states`; inputs that are missing are NaN.
    pub fn evaluate(&self, parameters: &[f64], time: f64, state: &[f64]) -> Values {
        self.evaluate_all(parameters, time, state, &Configuration::default())
    }

    /// Evaluates all operations of a linkage at a place.
    pub fn evaluate_linkage(
        &self,
        parameters: &[f64],
        time: f64,
        linkage: &Configuration<'_>,
    ) -> Values {
        self.evaluate_all(parameters, time, &[], linkage)
    }

    fn evaluate_all(
        &self,
        parameters: &[f64],
        time: f64,
        state: &[f64],
        linkage: &Configuration<'_>,
    ) -> Values {
        let given =
            |list: &[f64], index: u32| list.get(index as usize).copied().unwrap_or(f64::NAN);
        let input = |input: Input| match input {
            Input::Parameter(index) => given(parameters, index),
            Input::State(index) => given(state, index),
            Input::Time => time,
            Input::Driver(index) => given(linkage.drivers, index),
            Input::Position(index) => given(linkage.position, index),
            Input::Mode(index) => given(linkage.modes, index),
            Input::Side(_) => 0.0,
            Input::Measured(_) | Input::Change(_) | Input::Captured(_) | Input::Place => f64::NAN,
        };
        let kinds = self.operations.iter().map(|operation| &operation.kind);
        Values { numbers: run(kinds, &input) }
    }
}

impl Line {
    /// What it gives at a place, for the values that it captures.
    fn evaluate(&self, captured: &[f64], place: f64) -> f64 {
        let input = |input: Input| match input {
            Input::Captured(index) => captured[index as usize],
            Input::Place => place,
            _ => f64::NAN,
        };
        run(self.operations.iter(), &input)[self.result.0 as usize]
    }
}

/// The values of operations, one after the other.
fn run<'a>(
    kinds: impl Iterator<Item = &'a OperationKind>,
    input: &dyn Fn(Input) -> f64,
) -> Vec<f64> {
    let mut numbers: Vec<f64> = Vec::new();
    let mut solutions: HashMap<u32, Vec<f64>> = HashMap::new();
    let mut factored: HashMap<u32, (Form, Vec<f64>)> = HashMap::new();
    for (index, kind) in kinds.enumerate() {
        let at = |value: &Value| numbers[value.0 as usize];
        let all = |list: &[Value]| list.iter().map(at).collect::<Vec<f64>>();
        let truth = |held: bool| if held { 1.0 } else { 0.0 };
        let number = match kind {
            OperationKind::Number(number) => *number,
            OperationKind::Input(one) => input(*one),
            OperationKind::Add(a, b) => at(a) + at(b),
            OperationKind::Subtract(a, b) => at(a) - at(b),
            OperationKind::Multiply(a, b) => at(a) * at(b),
            OperationKind::Divide(a, b) => at(a) / at(b),
            OperationKind::Negate(a) => -at(a),
            OperationKind::MultiplyAdd(a, b, c) => at(a) * at(b) + at(c),
            OperationKind::MultiplySubtract(a, b, c) => at(a) * at(b) - at(c),
            OperationKind::NegateMultiplyAdd(a, b, c) => at(c) - at(a) * at(b),
            OperationKind::Call(function, list) => function.apply(&all(list)),
            OperationKind::Compare(relation, a, b) => truth(relation.holds(at(a), at(b))),
            OperationKind::And(a, b) => truth(at(a) != 0.0 && at(b) != 0.0),
            OperationKind::Or(a, b) => truth(at(a) != 0.0 || at(b) != 0.0),
            OperationKind::Not(a) => truth(at(a) == 0.0),
            OperationKind::Select { condition, then, otherwise } => {
                if at(condition) != 0.0 {
                    at(then)
                } else {
                    at(otherwise)
                }
            }
            OperationKind::Factor { form, entries, .. } => {
                factored.insert(index as u32, (*form, all(entries)));
                f64::NAN
            }
            OperationKind::Solve { factor, right } => {
                if let Some((form, entries)) = factored.get(&factor.0) {
                    solutions.insert(index as u32, solve(*form, entries, &all(right)));
                }
                f64::NAN
            }
            OperationKind::Element { solution, index } => solutions
                .get(&solution.0)
                .and_then(|list| list.get(*index as usize))
                .copied()
                .unwrap_or(f64::NAN),
            OperationKind::Table { spline, at: place } => {
                let (table, place) = (spline.table(), at(place));
                let values = (0..ORDERS).map(|order| table.value(place, order as u32));
                solutions.insert(index as u32, values.collect());
                f64::NAN
            }
            OperationKind::Search { search, captured, lines, .. } => {
                let captured = all(captured);
                search.find(&|line, place| lines[line].evaluate(&captured, place))
            }
        };
        numbers.push(number);
    }
    numbers
}
