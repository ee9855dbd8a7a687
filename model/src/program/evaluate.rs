//! A program on numbers: what the emitted Rust computes, without compiling it.

use super::{Input, OperationKind, Program, Value};
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
        let mut numbers: Vec<f64> = Vec::with_capacity(self.operations.len());
        let mut solutions: std::collections::HashMap<u32, Vec<f64>> =
            std::collections::HashMap::new();
        for (index, operation) in self.operations.iter().enumerate() {
            let at = |value: &Value| numbers[value.0 as usize];
            let truth = |held: bool| if held { 1.0 } else { 0.0 };
            let number =
                match &operation.kind {
                    OperationKind::Number(number) => *number,
                    OperationKind::Input(Input::Parameter(index)) => given(parameters, *index),
                    OperationKind::Input(Input::State(index)) => given(state, *index),
                    OperationKind::Input(Input::Time) => time,
                    OperationKind::Input(Input::Driver(index)) => given(linkage.drivers, *index),
                    OperationKind::Input(Input::Position(index)) => given(linkage.position, *index),
                    OperationKind::Input(Input::Mode(index)) => given(linkage.modes, *index),
                    OperationKind::Input(Input::Side(_)) => 0.0,
                    OperationKind::Input(Input::Measured(_) | Input::Change(_)) => f64::NAN,
                    OperationKind::Add(a, b) => at(a) + at(b),
                    OperationKind::Subtract(a, b) => at(a) - at(b),
                    OperationKind::Multiply(a, b) => at(a) * at(b),
                    OperationKind::Divide(a, b) => at(a) / at(b),
                    OperationKind::Negate(a) => -at(a),
                    OperationKind::MultiplyAdd(a, b, c) => at(a) * at(b) + at(c),
                    OperationKind::MultiplySubtract(a, b, c) => at(a) * at(b) - at(c),
                    OperationKind::NegateMultiplyAdd(a, b, c) => at(c) - at(a) * at(b),
                    OperationKind::Call(function, list) => {
                        function.apply(&list.iter().map(at).collect::<Vec<_>>())
                    }
                    OperationKind::Compare(relation, a, b) => truth(relation.holds(at(a), at(b))),
                    OperationKind::And(a, b) => truth(at(a) != 0.0 && at(b) != 0.0),
                    OperationKind::Or(a, b) => truth(at(a) != 0.0 || at(b) != 0.0),
                    OperationKind::Not(a) => truth(at(a) == 0.0),
                    OperationKind::Select { condition, then, otherwise } => {
                        if at(condition) != 0.0 { at(then) } else { at(otherwise) }
                    }
                    OperationKind::Factor { .. } => f64::NAN,
                    OperationKind::Solve { factor, right } => {
                        if let OperationKind::Factor { form, entries, .. } =
                            &self.operations[factor.0 as usize].kind
                        {
                            let entries: Vec<f64> = entries.iter().map(at).collect();
                            let right: Vec<f64> = right.iter().map(at).collect();
                            solutions.insert(index as u32, solve(*form, &entries, &right));
                        }
                        f64::NAN
                    }
                    OperationKind::Element { solution, index } => solutions
                        .get(&solution.0)
                        .and_then(|list| list.get(*index as usize))
                        .copied()
                        .unwrap_or(f64::NAN),
                };
            numbers.push(number);
        }
        Values { numbers }
    }
}
