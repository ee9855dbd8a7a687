//! What a function is given: which values are there already, and where those from outside stand.

use std::collections::BTreeMap;

use assur_model::program::{Input, OperationKind, Program, Shape, Stage, Staging, Value};

/// Where a function stands, and so what it is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// The values of the constants.
    Values,
    /// The values of the constants, and the time.
    Drive,
    /// The positions of the drivers, and how they move.
    Independents,
    /// The time, the state, the sides of surfaces, and what has been found of a run.
    Time,
    /// A row of an instant, the state, the sides of surfaces, and a column of changes.
    Evaluation,
    /// A row of an instant, the position of a linkage, and the assembly mode of a group.
    Position,
    /// What a search captures, and the place.
    Line,
}

/// A value that is there already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// It has been prepared.
    Prepared,
    /// It stands in the row of the instant.
    Row(usize),
}

/// What is kept of a program between its stages.
#[derive(Clone, Debug)]
pub struct Storage {
    /// The values that are prepared, and those of an instant.
    pub staging: Staging,
    /// Where each value of an instant begins in its row.
    pub row: BTreeMap<Value, usize>,
    /// Length of the row.
    pub length: usize,
    /// Number of drivers.
    pub drivers: usize,
}

impl Storage {
    /// Of a program with so many drivers.
    pub fn of(program: &Program, drivers: usize) -> Self {
        let staging = program.staging();
        let (mut row, mut length) = (BTreeMap::new(), 0);
        for value in &staging.timed {
            row.insert(*value, length);
            length += numbers(program, *value);
        }
        Self { staging, row, length, drivers }
    }

    /// Whether a value is there already.
    pub fn outside(&self, program: &Program, scope: Scope, value: Value) -> Option<Kept> {
        let is_given = matches!(program.kind(value), OperationKind::Number(_));
        match (scope, program.stage(value)) {
            _ if is_given => None,
            (Scope::Values | Scope::Drive | Scope::Line, _) => None,
            (_, Stage::Constant | Stage::Parameter) => Some(Kept::Prepared),
            (Scope::Evaluation | Scope::Position, Stage::Instant) => {
                self.row.get(&value).map(|at| Kept::Row(*at))
            }
            _ => None,
        }
    }

    /// The list in which an input is given, and its place there.
    pub fn input(&self, scope: Scope, input: Input) -> Option<(usize, usize)> {
        let place = match (scope, input) {
            (Scope::Values | Scope::Drive, Input::Parameter(index)) => (0, index as usize),
            (Scope::Drive, Input::Time) => (1, 0),
            (Scope::Independents, Input::Time) => (1, 2 * self.drivers),
            (_, Input::Driver(index)) => match index as usize {
                index if index < self.drivers => (0, index),
                index => (1, index - self.drivers),
            },
            (Scope::Time, Input::Time) => (0, 0),
            (_, Input::State(index)) => (1, index as usize),
            (_, Input::Side(index)) => (2, index as usize),
            (_, Input::Measured(index)) => (3, index as usize),
            (_, Input::Change(index)) => (3, index as usize),
            (_, Input::Position(index)) => (1, index as usize),
            (_, Input::Mode(_)) => (2, 0),
            (_, Input::Captured(index)) => (0, index as usize),
            (_, Input::Place) => (1, 0),
            (_, Input::Time | Input::Parameter(_)) => return None,
        };
        Some(place)
    }
}

/// How many numbers of a row a value takes.
pub fn numbers(program: &Program, value: Value) -> usize {
    match program.shape(value) {
        Shape::Vector(size) => size,
        Shape::Number | Shape::Mask | Shape::Factor(..) => 1,
    }
}
