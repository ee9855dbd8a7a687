//! That a function names no register that is not there.

use std::ops::Deref;

use super::{CannotRun, Code, Instruction as Do, Register};

/// A function all registers of which are there.
#[derive(Clone, Debug, Default)]
pub struct Checked(Code);

impl Deref for Checked {
    type Target = Code;

    #[inline(always)]
    fn deref(&self) -> &Code {
        &self.0
    }
}

impl Checked {
    /// Looks at all registers that a function names.
    pub(super) fn new(code: Code) -> Result<Self, CannotRun> {
        let number = |register: &Register| usize::from(*register) < code.registers;
        let condition = |register: &Register| usize::from(*register) < code.conditions;
        let all = |registers: &[Register]| registers.iter().all(number);
        let is_within = |instruction: &Do| match instruction {
            Do::Add(all) | Do::Subtract(all) | Do::Multiply(all) | Do::Divide(all) => {
                all.iter().all(number)
            }
            Do::MultiplyAdd(all) | Do::MultiplySubtract(all) | Do::SubtractProduct(all) => {
                all.iter().all(number)
            }
            Do::Negate(all) | Do::Root(all) | Do::Call(_, all) => all.iter().all(number),
            Do::CallTwo(_, all) => all.iter().all(number),
            Do::Less([d, a, b]) | Do::LessEqual([d, a, b]) | Do::Equal([d, a, b]) => {
                condition(d) && number(a) && number(b)
            }
            Do::And(all) | Do::Or(all) => all.iter().all(condition),
            Do::Not(all) => all.iter().all(condition),
            Do::Select([d, c, a, b]) => number(d) && condition(c) && number(a) && number(b),
            // What these name stands in the lists below.
            Do::Sines(..) | Do::Factor(_) | Do::Solve(_) | Do::Table(_) | Do::Search(_) => true,
        };
        let is_there = code.instructions.iter().all(is_within)
            && code
                .angles
                .iter()
                .all(|one| number(&one.angle) && one.sine.iter().chain(&one.cosine).all(number))
            && code.factors.iter().all(|one| one.entries.iter().all(|entry| number(&entry.2)))
            && code.solves.iter().all(|one| all(&one.right))
            && code.lookups.iter().all(|one| number(&one.at))
            && code.searches.iter().all(|one| number(&one.target) && all(&one.captured))
            && all(&code.results)
            && all(&code.again.numbers)
            && code.again.conditions.iter().all(condition);
        match is_there {
            true => Ok(Self(code)),
            false => Err(CannotRun::Missing),
        }
    }
}
