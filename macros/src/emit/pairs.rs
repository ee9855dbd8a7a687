//! Sines and cosines, which are taken together when they are of one angle.

use assur_model::program::{Function, OperationKind, Value};

use super::layout::Layout;

/// Sine and cosine of one angle.
pub struct Pair {
    /// The angle.
    pub angle: Value,
    /// Its sine, if that is read.
    pub sine: Option<Value>,
    /// Its cosine, if that is read.
    pub cosine: Option<Value>,
}

/// Sorts the sines and cosines of a batch by their angles.
pub fn pairs(layout: &Layout<'_>, batch: &[Value]) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = Vec::new();
    for value in batch {
        let OperationKind::Call(function, arguments) =
            &layout.program().operations[value.0 as usize].kind
        else {
            continue;
        };
        let Some(angle) = arguments.first().copied() else {
            continue;
        };
        let index = pairs.iter().position(|pair| pair.angle == angle).unwrap_or_else(|| {
            pairs.push(Pair { angle, sine: None, cosine: None });
            pairs.len() - 1
        });
        match function {
            Function::Sin => pairs[index].sine = Some(*value),
            _ => pairs[index].cosine = Some(*value),
        }
    }
    pairs
}
