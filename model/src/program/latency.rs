//! How long operations take, one after the other, after the state is known.

use super::{Function, OperationKind as Kind, Value};

/// A division or a square root, in additions.
const DIVISION: u32 = 4;
/// A function that is a series.
const SERIES: u32 = 12;

/// What is found of a function.
const SEARCH: u32 = 500;

/// When the result of an operation is there, in additions, as each of its operands is.
pub fn of(kind: &Kind, depth: impl Fn(Value) -> u32) -> u32 {
    let operands = kind.operands();
    let latest = operands.into_iter().map(&depth).max().unwrap_or(0);
    match kind {
        Kind::Number(_) | Kind::Input(_) => 0,
        Kind::MultiplyAdd(a, b, c)
        | Kind::MultiplySubtract(a, b, c)
        | Kind::NegateMultiplyAdd(a, b, c) => (depth(*a).max(depth(*b)) + 2).max(depth(*c) + 1),
        Kind::Divide(..) | Kind::Call(Function::Sqrt, _) => latest + DIVISION,
        Kind::Call(Function::Abs | Function::Sign | Function::Max | Function::Min, _) => latest + 1,
        Kind::Call(..) => latest + SERIES,
        Kind::Factor { size, .. } => latest + size * (DIVISION + 2),
        Kind::Solve { right, .. } => latest + right.len() as u32 * (DIVISION + 2),
        Kind::Element { .. } => latest,
        Kind::Search { .. } => latest + SEARCH,
        Kind::Table { .. } => latest + SERIES,
        Kind::Add(..)
        | Kind::Subtract(..)
        | Kind::Multiply(..)
        | Kind::Negate(_)
        | Kind::Compare(..)
        | Kind::And(..)
        | Kind::Or(..)
        | Kind::Not(_)
        | Kind::Select { .. } => latest + 1,
    }
}
