//! What stands in the registers of a function before its first instruction.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Form, OperationKind as Kind, Shape, Value};

use super::build::{Builder, index};
use super::scope::{self, Storage};
use super::{CannotRun, Instruction, Kept, Load, Register, Scope, Slot};

impl Builder<'_> {
    /// Puts numbers and what is prepared into the first registers.
    pub(super) fn fix(
        &mut self,
        needed: &BTreeSet<Value>,
        results: &[Value],
        outside: &dyn Fn(Value) -> Option<Kept>,
        prepared: &BTreeMap<Value, Slot>,
    ) -> Result<(), CannotRun> {
        let program = self.program;
        let read = needed.iter().flat_map(|value| program.kind(*value).operands());
        let all: BTreeSet<Value> =
            read.chain(needed.iter().copied()).chain(results.iter().copied()).collect();
        self.zero = self.number(0.0)?;
        self.one = self.number(1.0)?;
        for value in all.iter().copied() {
            if let Kind::Number(number) = program.kind(value) {
                let register = self.number(*number)?;
                self.slots.insert(value, Slot::Number(usize::from(register)));
                self.fixed.insert(value);
            }
        }
        for value in all {
            if outside(value) != Some(Kept::Prepared) {
                continue;
            }
            let from = prepared.get(&value).ok_or(CannotRun::Missing)?;
            let slot = match *from {
                Slot::Number(from) => {
                    let length = self.length(value);
                    let at = self.numbers.block(length)?;
                    // Blocks that stand side by side in both places are one.
                    match self.code.fixed.kept.last_mut() {
                        Some(last) if (last.0 + last.1, last.2 + last.1) == (from, at) => {
                            last.1 += length;
                        }
                        _ => self.code.fixed.kept.push((from, length, at)),
                    }
                    Slot::Number(at)
                }
                Slot::Condition(from) => {
                    let at = self.conditions.block(1)?;
                    self.code.fixed.conditions.push((from, at));
                    Slot::Condition(at)
                }
                Slot::Bound(from) => {
                    let at = self.bound(value);
                    self.code.fixed.bounds.push((from, at));
                    Slot::Bound(at)
                }
            };
            self.slots.insert(value, slot);
            self.fixed.insert(value);
        }
        self.code.fixed.count = self.numbers.count;
        Ok(())
    }

    /// The register of a number of the program.
    fn number(&mut self, number: f64) -> Result<Register, CannotRun> {
        let mut known = self.code.fixed.numbers.iter();
        if let Some(known) = known.find(|one| one.1.to_bits() == number.to_bits()) {
            return Ok(known.0);
        }
        let register = index(self.numbers.block(1)?)?;
        self.code.fixed.numbers.push((register, number));
        Ok(register)
    }

    /// Puts what the caller gives into the next registers.
    pub(super) fn load(
        &mut self,
        needed: &BTreeSet<Value>,
        results: &[Value],
        (storage, scope): (&Storage, Scope),
    ) -> Result<(), CannotRun> {
        let program = self.program;
        let read = needed.iter().flat_map(|value| program.kind(*value).operands());
        let all: BTreeSet<Value> =
            read.chain(needed.iter().copied()).chain(results.iter().copied()).collect();
        let mut given: BTreeMap<Value, (usize, usize)> = BTreeMap::new();
        let mut ends: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
        for value in all {
            let place = match (program.kind(value), storage.outside(program, scope, value)) {
                (_, Some(Kept::Row(at))) => Some((0, at)),
                (Kind::Input(input), None) => storage.input(scope, *input),
                _ => None,
            };
            if let Some((list, at)) = place {
                let end = at + scope::numbers(program, value);
                let known = ends.entry(list).or_insert((at, end));
                *known = (known.0.min(at), known.1.max(end));
                given.insert(value, (list, at));
            }
        }
        let mut begins = BTreeMap::new();
        for (list, (from, to)) in ends {
            let (count, at) = (to - from, self.numbers.block(to - from)?);
            self.code.loads.push(Load { list, from, count, at });
            begins.insert(list, (from, at));
        }
        for (value, (list, at)) in given {
            let (from, begin) = begins[&list];
            let register = begin + at - from;
            let slot = match program.shape(value) {
                Shape::Mask => {
                    let condition = self.conditions.block(1)?;
                    let less = [index(condition)?, self.zero, index(register)?];
                    self.code.instructions.push(Instruction::Less(less));
                    Slot::Condition(condition)
                }
                _ => Slot::Number(register),
            };
            self.slots.insert(value, slot);
            self.fixed.insert(value);
        }
        Ok(())
    }

    /// How many registers a value takes.
    pub(super) fn length(&self, value: Value) -> usize {
        match self.program.shape(value) {
            Shape::Number | Shape::Mask => 1,
            Shape::Vector(size) => size,
            Shape::Factor(_, rows) => rows * (rows + 2),
        }
    }

    /// Room for the bound system that a value is.
    pub(super) fn bound(&mut self, value: Value) -> usize {
        if let Shape::Factor(Form::Bound { unknowns, rank }, rows) = self.program.shape(value) {
            self.code.bounds.push([rows, unknowns as usize, rank as usize]);
        }
        self.code.bounds.len() - 1
    }
}
