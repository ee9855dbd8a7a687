//! Why a value is no number: the first operation that has none although its operands do.

use super::{Function, OperationKind, Program, Value, Values};

/// An operation without a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Undefined {
    /// It with the values of its operands, `acos(1.25)`.
    pub operation: String,
    /// The nearest quantity that needs it, by its name in the file.
    pub quantity: Option<String>,
}

impl Program {
    /// What a value that is not a number lacks; none where something from outside is missing, or was looked for in vain.
    pub fn undefined(&self, values: &Values, mut value: Value) -> Option<Undefined> {
        let mut quantity = None;
        loop {
            let operation = &self.operations[value.0 as usize];
            if !values.get(value).is_nan() {
                return None;
            }
            quantity = operation.name.clone().or(quantity);
            let next = match &operation.kind {
                // Of a branch the side that holds.
                OperationKind::Select { condition, then, otherwise } => {
                    Some(if values.get(*condition) != 0.0 { *then } else { *otherwise })
                }
                // Outside of a table, or a system without a solution.
                OperationKind::Element { .. } => return None,
                kind => kind.operands().into_iter().find(|one| values.get(*one).is_nan()),
            };
            match next {
                Some(next) => value = next,
                None => {
                    let operation = written(&operation.kind, values)?;
                    return Some(Undefined { operation, quantity });
                }
            }
        }
    }
}

/// An operation with the values of its operands.
fn written(kind: &OperationKind, values: &Values) -> Option<String> {
    let at = |value: &Value| format!("{:.6}", values.get(*value)).parse::<f64>().ok();
    let near = |value: &Value| at(value).map(|number| number.to_string());
    match kind {
        OperationKind::Call(Function::Power, list) => {
            Some(format!("({})^{}", near(&list[0])?, near(&list[1])?))
        }
        OperationKind::Call(function, list) => {
            let list = list.iter().map(near).collect::<Option<Vec<_>>>()?;
            Some(format!("{}({})", format!("{function:?}").to_lowercase(), list.join(", ")))
        }
        OperationKind::Divide(a, b) => Some(format!("{}/{}", near(a)?, near(b)?)),
        _ => None,
    }
}
