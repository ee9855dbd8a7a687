//! Which operations a function needs, in which order they are best done, and how many they are.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Form, Function, OperationKind, Program, Stage, Value};

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

/// What kind of thing a value is.
pub fn shape(program: &Program, value: Value) -> Shape {
    use OperationKind as Kind;
    match &program.operations[value.0 as usize].kind {
        Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => Shape::Mask,
        Kind::Factor { form, size, .. } => Shape::Factor(*form, *size as usize),
        Kind::Solve { right, .. } => Shape::Vector(right.len()),
        _ => Shape::Number,
    }
}

/// Whether a value is a number written out, which is never stored.
pub fn is_number(program: &Program, value: Value) -> bool {
    matches!(program.operations[value.0 as usize].kind, OperationKind::Number(_))
}

/// The values that some results rest on, as far as the values given from outside, in the order of the program.
pub fn needed(
    program: &Program,
    wanted: &[Value],
    outside: &dyn Fn(Value) -> bool,
) -> BTreeSet<Value> {
    let mut needed = BTreeSet::new();
    let mut open: Vec<Value> = wanted.to_vec();
    while let Some(value) = open.pop() {
        if !outside(value) && needed.insert(value) {
            open.extend(program.operations[value.0 as usize].kind.operands());
        }
    }
    needed
}

/// The values of earlier stages that results of a stage read directly, or are; numbers left out.
pub fn frontier(program: &Program, wanted: &[Value], stage: Stage) -> BTreeSet<Value> {
    let earlier = |value: Value| program.operations[value.0 as usize].stage < stage;
    let mut border: BTreeSet<Value> =
        wanted.iter().copied().filter(|value| earlier(*value)).collect();
    for value in needed(program, wanted, &earlier) {
        let read = program.operations[value.0 as usize].kind.operands();
        border.extend(read.into_iter().filter(|value| earlier(*value)));
    }
    border.retain(|value| !is_number(program, *value));
    border
}

/// Whether an operation is a sine or cosine, and of what.
pub fn angle(program: &Program, value: Value) -> Option<Value> {
    match &program.operations[value.0 as usize].kind {
        OperationKind::Call(Function::Sin | Function::Cos, arguments) => arguments.first().copied(),
        _ => None,
    }
}

/// The order in which operations are done: all that can be done before any sine, then the sines that can be taken
/// then, all at once, and so on. Each entry is one batch of sines and the operations before it.
pub struct Levels {
    /// Operations before the batch.
    pub before: Vec<Value>,
    /// Sines and cosines of the batch.
    pub batch: Vec<Value>,
}

/// Sorts operations into levels.
pub fn levels(program: &Program, needed: &BTreeSet<Value>) -> Vec<Levels> {
    let mut level: BTreeMap<Value, usize> = BTreeMap::new();
    let mut levels: Vec<Levels> = Vec::new();
    for value in needed {
        let read = program.operations[value.0 as usize].kind.operands();
        let own = read.iter().filter_map(|operand| level.get(operand)).copied().max().unwrap_or(0);
        while levels.len() <= own {
            levels.push(Levels { before: Vec::new(), batch: Vec::new() });
        }
        if angle(program, *value).is_some() {
            levels[own].batch.push(*value);
            level.insert(*value, own + 1);
        } else {
            levels[own].before.push(*value);
            level.insert(*value, own);
        }
    }
    levels
}

/// Arithmetic operations, functions and selections among some values.
pub fn count(program: &Program, values: &BTreeSet<Value>) -> usize {
    use OperationKind as Kind;
    let cost = |value: &Value| match &program.operations[value.0 as usize].kind {
        Kind::Number(_) | Kind::Input(_) | Kind::Element { .. } => 0,
        Kind::MultiplyAdd(..) | Kind::MultiplySubtract(..) | Kind::NegateMultiplyAdd(..) => 2,
        Kind::Factor { form, size, .. } => {
            let size = *size as usize;
            let symmetric = size * (size + 1) * (2 * size + 1) / 6;
            match form {
                Form::Symmetric => symmetric,
                Form::General => 2 * symmetric,
            }
        }
        Kind::Solve { right, .. } => 2 * right.len() * right.len(),
        _ => 1,
    };
    values.iter().map(cost).sum()
}
