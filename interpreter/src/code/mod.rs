//! A function of a program as instructions on registers, the same for numbers of any kind.
//!
//! Registers hold numbers; what is true of them stands in a file of its own, and bound systems, which remember an order of
//! their rows, in a third. The first registers are the same at each call: numbers of the program and what has been prepared.
//! Behind them stand those that the caller gives, then whatever is computed, each in a register that nothing needs any more.

mod begin;
mod build;
mod checked;
mod operation;
mod order;
mod registers;
mod scope;
pub(crate) mod series;

use std::collections::BTreeMap;
use std::sync::Arc;

use assur_model::program::{Form, Function, Search, Spline, Value};

pub use build::{COLUMN, Wanted};
pub use checked::Checked;
pub use scope::{Kept, Scope, Storage};

/// A register of numbers, or of conditions.
pub type Register = u16;

/// One instruction. The first register is written, the others are read.
#[derive(Clone, Copy, Debug)]
pub enum Instruction {
    /// `a + b`
    Add([Register; 3]),
    /// `a - b`
    Subtract([Register; 3]),
    /// `a * b`
    Multiply([Register; 3]),
    /// `a / b`
    Divide([Register; 3]),
    /// `-a`
    Negate([Register; 2]),
    /// `a * b + c`
    MultiplyAdd([Register; 4]),
    /// `a * b - c`
    MultiplySubtract([Register; 4]),
    /// `c - a * b`
    SubtractProduct([Register; 4]),
    /// The square root of a number.
    Root([Register; 2]),
    /// A function of one number.
    Call(Function, [Register; 2]),
    /// A function of two numbers.
    CallTwo(Function, [Register; 3]),
    /// Sines and cosines of several angles: so many, from a place of [`Code::angles`] on.
    Sines(u16, u16),
    /// `a < b`, into a condition.
    Less([Register; 3]),
    /// `a <= b`
    LessEqual([Register; 3]),
    /// `a == b`
    Equal([Register; 3]),
    /// Both conditions.
    And([Register; 3]),
    /// Either condition.
    Or([Register; 3]),
    /// Not the condition.
    Not([Register; 2]),
    /// Where a condition, the second register, holds, the one number, else the other.
    Select([Register; 4]),
    /// One of [`Code::factors`].
    Factor(u16),
    /// One of [`Code::solves`].
    Solve(u16),
    /// One of [`Code::lookups`].
    Table(u16),
    /// One of [`Code::searches`].
    Search(u16),
}

/// Sine and cosine of an angle: where they go, if anywhere.
#[derive(Clone, Copy, Debug)]
pub struct Angle {
    /// The angle.
    pub angle: Register,
    /// Its sine.
    pub sine: Option<Register>,
    /// Its cosine.
    pub cosine: Option<Register>,
}

/// A matrix to be factored.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Its kind.
    pub form: Form,
    /// Its number of rows.
    pub rows: usize,
    /// Where its factors go: a block of registers, or one of the bound systems.
    pub target: usize,
    /// Its entries: row, column, register.
    pub entries: Vec<(u16, u16, Register)>,
}

/// A factored system to be solved.
#[derive(Clone, Debug)]
pub struct Solve {
    /// The kind of its matrix.
    pub form: Form,
    /// Where the factors are.
    pub factor: usize,
    /// The right-hand side.
    pub right: Vec<Register>,
    /// The block of registers for the solution; of a bound system, with as much room behind it.
    pub target: usize,
}

/// A sampled curve to be looked up.
#[derive(Clone, Debug)]
pub struct Lookup {
    /// The curve.
    pub spline: Arc<Spline>,
    /// The place.
    pub at: Register,
    /// The block of registers for value and derivatives.
    pub target: usize,
}

/// What is to be found of some functions.
#[derive(Clone, Debug)]
pub struct Finding {
    /// What is looked for.
    pub search: Search,
    /// It in the words of the file.
    pub text: String,
    /// What the functions are given beside the place.
    pub captured: Vec<Register>,
    /// The functions, of [`Code::lines`].
    pub lines: Vec<usize>,
    /// Where it goes.
    pub target: Register,
}

/// Numbers that a caller gives and that are copied into registers.
#[derive(Clone, Copy, Debug)]
pub struct Load {
    /// Which list of the caller's.
    pub list: usize,
    /// From where in it.
    pub from: usize,
    /// How many.
    pub count: usize,
    /// Into which registers.
    pub at: usize,
}

/// What of the prepared values goes into the first registers.
#[derive(Clone, Debug, Default)]
pub struct Fixed {
    /// Numbers of the program.
    pub numbers: Vec<(Register, f64)>,
    /// Prepared numbers: from where, how many, into which registers.
    pub kept: Vec<(usize, usize, usize)>,
    /// Prepared conditions.
    pub conditions: Vec<(usize, usize)>,
    /// Prepared bound systems.
    pub bounds: Vec<(usize, usize)>,
    /// How many registers of numbers these take.
    pub count: usize,
}

/// Registers that are read again and again.
#[derive(Clone, Debug, Default)]
pub struct Again {
    /// Of numbers.
    pub numbers: Vec<Register>,
    /// Of conditions.
    pub conditions: Vec<Register>,
}

/// A function of a program.
#[derive(Clone, Debug, Default)]
pub struct Code {
    /// What stands in the first registers.
    pub fixed: Fixed,
    /// What the caller gives.
    pub loads: Vec<Load>,
    /// The instructions.
    pub instructions: Vec<Instruction>,
    /// Of a function that is asked for several columns, how many of them are done once.
    pub once: usize,
    /// Angles whose sines and cosines are taken.
    pub angles: Vec<Angle>,
    /// Matrices that are factored.
    pub factors: Vec<Factor>,
    /// Systems that are solved.
    pub solves: Vec<Solve>,
    /// Curves that are looked up.
    pub lookups: Vec<Lookup>,
    /// What is searched for.
    pub searches: Vec<Finding>,
    /// Functions inside of searches; they are given what is captured, and the place.
    pub lines: Vec<Checked>,
    /// The registers of the results, one number after the other.
    pub results: Vec<Register>,
    /// How many of these are done once.
    pub first: usize,
    /// What is done once and read again for each column.
    pub again: Again,
    /// Where values of other shapes are kept, for those that prepare.
    pub kept: BTreeMap<Value, Slot>,
    /// Number of registers.
    pub registers: usize,
    /// Number of conditions.
    pub conditions: usize,
    /// Sizes of the bound systems: rows, unknowns, most independent closures.
    pub bounds: Vec<[usize; 3]>,
}

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// From this register of numbers on.
    Number(usize),
    /// In this condition.
    Condition(usize),
    /// In this bound system.
    Bound(usize),
}

/// Why a function cannot be run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CannotRun {
    /// It needs more numbers at a time than there are registers.
    TooLarge,
    /// It reads what nobody gives: a mistake of the compiler's.
    Missing,
}

impl std::fmt::Display for CannotRun {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::TooLarge => "a function of it needs more than 65535 numbers at a time",
            Self::Missing => {
                "a function of it reads what nobody gives, which is a mistake of Assur"
            }
        })
    }
}

impl std::error::Error for CannotRun {}
