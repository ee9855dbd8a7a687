//! Searches as operations: the bodies become lines of their own, which capture what does not change from trial to trial.

use super::emit::{Emitter, Key};
use super::{Input, Line, Operation, OperationKind, Stage, Value};
use crate::expression::{Expression, Map, Node, Symbol};

/// The line of a search that is written, or what stands around it.
#[derive(Default)]
pub(super) struct Frame {
    operations: Vec<Operation>,
    known: Map<Key, Value>,
    depths: Vec<u32>,
    done: Map<Expression, Value>,
    /// The level of the search whose line is written, if one is, and what its lines capture of the frame around.
    search: Option<(u32, Vec<Value>)>,
}

impl Emitter<'_> {
    pub(super) fn search(&mut self, node: Expression) -> Value {
        let Node::Search(search, level, bodies) = self.graph.node(node).clone() else {
            return self.number(f64::NAN);
        };
        let text = self.graph.switch_of(node).map_or(String::new(), |words| words.to_string());
        let mut captured = Vec::new();
        let mut lines = Vec::new();
        for body in bodies.iter().copied().take(search.bodies()) {
            let body = self.graph.with_steady_parts(body, level);
            self.frames.push(Frame { search: Some((level, captured)), ..Frame::default() });
            self.swap_frame();
            let result = self.value(body);
            self.swap_frame();
            let frame = self.frames.pop().unwrap_or_default();
            captured = frame.search.map(|one| one.1).unwrap_or_default();
            lines.push(needed(frame.operations.into_iter().map(|one| one.kind).collect(), result));
        }
        self.combine(OperationKind::Search { search, text, captured, lines })
    }

    /// Whether an expression is steady in the line that is written, and so captured. What is captured is a number: of
    /// conditions and systems of equations what they are made of is.
    pub(super) fn is_captured(&self, expression: Expression) -> bool {
        let is_number = !matches!(
            self.graph.node(expression),
            Node::Compare(..)
                | Node::And(..)
                | Node::Or(..)
                | Node::Not(..)
                | Node::Factor(..)
                | Node::Solve(..)
        );
        self.level.as_ref().is_some_and(|(level, _)| {
            let is_own = |symbol: Symbol| symbol == Symbol::Bound(*level);
            is_number
                && self.graph.as_number(expression).is_none()
                && !self.graph.depends_on(expression, is_own)
        })
    }

    /// The value of an expression of the frame around.
    pub(super) fn capture(&mut self, expression: Expression) -> Value {
        self.swap_frame();
        let inner = self.frames.pop();
        let value = self.value(expression);
        self.frames.extend(inner);
        self.swap_frame();
        let Some((_, captured)) = &mut self.level else {
            return value;
        };
        let index = captured.iter().position(|one| *one == value).unwrap_or_else(|| {
            captured.push(value);
            captured.len() - 1
        });
        self.push(OperationKind::Input(Input::Captured(index as u32)), Stage::Instant)
    }

    /// Exchanges what is written with the frame on top.
    fn swap_frame(&mut self) {
        use std::mem::swap;
        let Some(frame) = self.frames.last_mut() else {
            return;
        };
        swap(&mut self.operations, &mut frame.operations);
        swap(&mut self.known, &mut frame.known);
        swap(&mut self.depths, &mut frame.depths);
        swap(&mut self.done, &mut frame.done);
        swap(&mut self.level, &mut frame.search);
    }
}

/// A line with no more operations than its result needs.
fn needed(operations: Vec<OperationKind>, result: Value) -> Line {
    let mut is_needed = vec![false; operations.len()];
    is_needed[result.0 as usize] = true;
    for index in (0..operations.len()).rev() {
        if is_needed[index] {
            let operands = operations[index].operands();
            operands.iter().for_each(|one| is_needed[one.0 as usize] = true);
        }
    }
    let mut places = vec![Value::default(); operations.len()];
    let mut kept: Vec<OperationKind> = Vec::new();
    for (index, mut kind) in operations.into_iter().enumerate() {
        if is_needed[index] {
            kind.replace(&|one| places[one.0 as usize]);
            places[index] = Value(kept.len() as u32);
            kept.push(kind);
        }
    }
    Line { operations: kept, result: places[result.0 as usize] }
}
