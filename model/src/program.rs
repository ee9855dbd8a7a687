//! A program: the straight line of operations that a scene boils down to. It is the border between the language and
//! whoever runs it, the emitted Rust or the evaluator.

mod build;
mod closing;
mod collect;
mod count;
mod counts;
mod emit;
mod evaluate;
mod event;
mod latency;
mod levels;
mod needed;
mod order;
mod product;
mod resting;
mod results;
mod search;
mod sensitivity;
mod series;
mod share;
mod staging;
mod surfaces;
mod undefined;
mod written;

use std::sync::Arc;

pub use assur_functions::Spline;

pub use crate::expression::{Form, Function, Relation, Search};
pub use build::{Request, bind, build};
pub use closing::{ClosedForm, Closing};
pub use counts::Counts;
pub use evaluate::{Configuration, Values};
pub use event::{Event, Slopes};
pub use levels::{Level, Pair};
pub use needed::Shape;
pub use results::Results;
pub use series::{Series, Step};
pub use staging::{Idle, Staging};
pub use undefined::Undefined;
pub use written::Fused;

/// Index of an operation, and so of its value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub u32);

/// How often a value changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Never.
    Constant,
    /// Once per parameter set.
    Parameter,
    /// Once per instant.
    Instant,
    /// At every evaluation.
    State,
    /// At every trial of a search: only in the lines of one.
    Trial,
}

/// What is given from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// A dimension or parameter, by index.
    Parameter(u32),
    /// The time.
    Time,
    /// A component of the state vector.
    State(u32),
    /// A driver of a linkage: its position, behind all positions its speed, behind all speeds its acceleration.
    Driver(u32),
    /// An entry of a linkage's position.
    Position(u32),
    /// The assembly mode of a group, 1 or −1.
    Mode(u32),
    /// On which side of a switching surface the motion is, 1 or −1; 0 where its values say it.
    Side(u32),
    /// What has been found of a run for a measure.
    Measured(u32),
    /// A component of a column that the Jacobian is multiplied with.
    Change(u32),
    /// In the line of a search: a value that it captures.
    Captured(u32),
    /// In the line of a search: the place at which it is tried.
    Place,
}

/// One operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// What is computed.
    pub kind: OperationKind,
    /// How often.
    pub stage: Stage,
    /// Name in the file of the quantity that this is, if it is one.
    pub name: Option<String>,
}

/// What an operation computes.
#[derive(Clone, Debug, PartialEq)]
pub enum OperationKind {
    /// A number.
    Number(f64),
    /// A value from outside.
    Input(Input),
    /// `a + b`
    Add(Value, Value),
    /// `a - b`
    Subtract(Value, Value),
    /// `a * b`
    Multiply(Value, Value),
    /// `a / b`
    Divide(Value, Value),
    /// `-a`
    Negate(Value),
    /// `a * b + c`
    MultiplyAdd(Value, Value, Value),
    /// `a * b - c`
    MultiplySubtract(Value, Value, Value),
    /// `c - a * b`, written with its operands in the order a, b, c
    NegateMultiplyAdd(Value, Value, Value),
    /// A function of one or two values. Sine and cosine of one angle are two operations, which the printer pairs.
    Call(Function, Vec<Value>),
    /// A condition.
    Compare(Relation, Value, Value),
    /// Both conditions.
    And(Value, Value),
    /// Either condition.
    Or(Value, Value),
    /// Not the condition.
    Not(Value),
    /// `if condition { then } else { otherwise }`
    Select {
        /// The condition.
        condition: Value,
        /// Its value where it holds.
        then: Value,
        /// Its value where it does not.
        otherwise: Value,
    },
    /// The factors of a matrix.
    Factor {
        /// What kind of matrix it is.
        form: Form,
        /// Rows of the matrix.
        size: u32,
        /// The entries, as [`Form::place`] says.
        entries: Vec<Value>,
    },
    /// The solution of a factored system, a vector.
    Solve {
        /// The factors.
        factor: Value,
        /// The right-hand side.
        right: Vec<Value>,
    },
    /// One element of a solution, or one derivative of a sampled curve.
    Element {
        /// The solution, or the curve.
        solution: Value,
        /// Which element, from 0.
        index: u32,
    },
    /// What is found of functions of a place from 0 to 1.
    Search {
        /// What is looked for.
        search: Search,
        /// It in the words of the file; empty where it is derived.
        text: String,
        /// The values that the functions capture.
        captured: Vec<Value>,
        /// The functions.
        lines: Vec<Line>,
    },
    /// A sampled curve and its derivatives up to the third, a vector.
    Table {
        /// The curve.
        spline: Arc<Spline>,
        /// The place.
        at: Value,
    },
}

/// A function of a place and of values that it captures. Its operations speak of each other, not of those of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The operations.
    pub operations: Vec<OperationKind>,
    /// What it gives.
    pub result: Value,
}

/// The straight line of operations of one scene, sorted so that operands come first and stages rise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// The operations.
    pub operations: Vec<Operation>,
    /// What the functions of the program return.
    pub results: Results,
    /// Number of parameters.
    pub parameters: usize,
    /// Length of the state vector.
    pub states: usize,
    /// Whether the derivative is affine in the state.
    pub linear: bool,
    /// The guards of the switching surfaces as text; their events stand behind those of the file.
    pub surfaces: Vec<String>,
    /// Number of the kinks of guards.
    pub kinks: usize,
    /// Number of the angles that turn in guards, whose events are the last ones.
    pub turns: usize,
}

impl Line {
    /// The line as a program of its own.
    pub fn program(&self) -> Program {
        let operation = |kind: &OperationKind| Operation {
            kind: kind.clone(),
            stage: Stage::Trial,
            name: None,
        };
        let operations = self.operations.iter().map(operation).collect();
        Program { operations, ..Program::default() }
    }
}

impl Program {
    /// Gives the parameters other numbers, of so many.
    pub(crate) fn renumber_parameters(&mut self, count: usize, new: impl Fn(usize) -> usize) {
        self.parameters = count;
        for operation in &mut self.operations {
            if let OperationKind::Input(Input::Parameter(index)) = &mut operation.kind {
                *index = new(*index as usize) as u32;
            }
        }
    }
}
