//! From values of a program to the instructions that compute them.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{Fused, Line, OperationKind as Kind, Program, Value};

use super::order::{self, Step};
use super::registers::Registers;
use super::scope::Storage;
use super::{Angle, CannotRun, Checked, Code, Instruction, Register, Scope, Slot};

/// The list of the caller's in which columns are.
pub const COLUMN: usize = 3;

/// What a function gives.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// The results, in their order.
    pub results: Vec<Value>,
    /// Values that are read often though they are no results; each is counted as if it were read once more.
    pub named: Vec<Value>,
    /// Results that are asked for again for each column of changes.
    pub columns: Vec<Value>,
    /// Whether values of any shape are kept, each where it stands, instead of numbers.
    pub keeps: bool,
}

impl Wanted {
    /// Some results.
    pub fn of(results: impl IntoIterator<Item = Value>) -> Self {
        Self { results: results.into_iter().collect(), ..Self::default() }
    }
}

impl Code {
    /// The function of a program that computes some values. `prepared` says where those stand that are prepared.
    pub fn build(
        program: &Program,
        storage: &Storage,
        scope: Scope,
        wanted: &Wanted,
        prepared: &BTreeMap<Value, Slot>,
    ) -> Result<Checked, CannotRun> {
        let outside = |value: Value| storage.outside(program, scope, value);
        let all: Vec<Value> = wanted.results.iter().chain(&wanted.columns).copied().collect();
        let roots: Vec<Value> = wanted.results.iter().chain(&wanted.named).copied().collect();
        let needed = program.needed(&all, &|value| outside(value).is_some());
        // What changes with a column is done behind all that does not.
        let changing = match wanted.columns.is_empty() {
            true => BTreeSet::new(),
            false => program.changing(&needed),
        };
        let once: BTreeSet<Value> = needed.difference(&changing).copied().collect();
        let mut steps = order::steps(program, &once, &roots);
        let begin = steps.len();
        steps.extend(order::steps(program, &changing, &wanted.columns));
        let (last, again) = last_reads(program, &steps, begin, &all);
        let mut builder = Builder {
            program,
            code: Self::default(),
            slots: BTreeMap::new(),
            zero: 0,
            one: 0,
            numbers: Registers::default(),
            conditions: Registers::default(),
            last,
            fixed: BTreeSet::new(),
        };
        builder.fix(&needed, &all, &outside, prepared)?;
        builder.load(&needed, &all, (storage, scope))?;
        for (place, step) in steps.iter().enumerate() {
            if place == begin {
                builder.code.once = builder.code.instructions.len();
            }
            builder.step(place, step)?;
        }
        if begin == steps.len() {
            builder.code.once = builder.code.instructions.len();
        }
        builder.again(&again)?;
        Checked::new(builder.finish(wanted)?)
    }

    /// The function that the line of a search is.
    pub(super) fn of_line(line: &Line) -> Result<Checked, CannotRun> {
        let program = line.program();
        let storage = Storage::of(&program, 0);
        let wanted = Wanted::of([line.result]);
        Self::build(&program, &storage, Scope::Line, &wanted, &BTreeMap::new())
    }
}

/// The last step that reads each value; none of those that are results, or that columns read again and again. And these.
fn last_reads(
    program: &Program,
    steps: &[Step],
    begin: usize,
    results: &[Value],
) -> (BTreeMap<Value, usize>, BTreeSet<Value>) {
    let (mut last, mut again) = (BTreeMap::new(), BTreeSet::new());
    let mut written = BTreeMap::new();
    for (place, step) in steps.iter().enumerate() {
        for value in step.reads(program) {
            let is_again = place >= begin && written.get(&value).is_none_or(|own| *own < begin);
            last.insert(value, if is_again { usize::MAX } else { place });
            again.extend(is_again.then_some(value));
        }
        match step {
            Step::Operation(value) | Step::Fused(value, _) => {
                written.insert(*value, place);
            }
            Step::Sines(pairs) => written.extend(
                pairs
                    .iter()
                    .flat_map(|pair| [pair.sine, pair.cosine])
                    .flatten()
                    .map(|one| (one, place)),
            ),
        }
    }
    last.extend(results.iter().map(|value| (*value, usize::MAX)));
    (last, again)
}

/// A register, or the place of something that an instruction names.
pub(super) fn index(at: usize) -> Result<u16, CannotRun> {
    u16::try_from(at).map_err(|_| CannotRun::TooLarge)
}

/// A function on the way.
pub(super) struct Builder<'a> {
    pub program: &'a Program,
    pub code: Code,
    pub slots: BTreeMap<Value, Slot>,
    pub zero: Register,
    pub one: Register,
    pub numbers: Registers,
    pub conditions: Registers,
    last: BTreeMap<Value, usize>,
    /// Values whose registers are never given back.
    pub fixed: BTreeSet<Value>,
}

impl Builder<'_> {
    /// The register of a number, or of a condition.
    pub(super) fn at(&self, value: Value) -> Result<Register, CannotRun> {
        let slot = self.slots.get(&value).ok_or(CannotRun::Missing)?;
        let (Slot::Number(at) | Slot::Condition(at) | Slot::Bound(at)) = *slot;
        index(at)
    }

    /// Gives the registers back that nothing reads behind a step.
    pub(super) fn release(&mut self, place: usize, values: &[Value]) {
        for value in BTreeSet::from_iter(values) {
            if self.last.get(value) != Some(&place) || self.fixed.contains(value) {
                continue;
            }
            match (self.slots.get(value), self.program.kind(*value)) {
                (
                    _,
                    Kind::Element { .. }
                    | Kind::Factor { .. }
                    | Kind::Solve { .. }
                    | Kind::Table { .. },
                ) => {}
                (Some(Slot::Number(at)), _) => self.numbers.release(*at),
                (Some(Slot::Condition(at)), _) => self.conditions.release(*at),
                _ => {}
            }
        }
    }

    /// The register for the number that a step gives.
    pub(super) fn target(&mut self, value: Value) -> Result<Register, CannotRun> {
        let at = self.numbers.one()?;
        self.slots.insert(value, Slot::Number(at));
        index(at)
    }

    fn step(&mut self, place: usize, step: &Step) -> Result<(), CannotRun> {
        let read = step.reads(self.program);
        match step {
            Step::Fused(value, fused) => {
                let (Fused::Add(a, b, c) | Fused::Subtract(a, b, c) | Fused::SubtractFrom(a, b, c)) =
                    *fused;
                let (a, b, c) = (self.at(a)?, self.at(b)?, self.at(c)?);
                self.release(place, &read);
                let all = [self.target(*value)?, a, b, c];
                self.code.instructions.push(match fused {
                    Fused::Add(..) => Instruction::MultiplyAdd(all),
                    Fused::Subtract(..) => Instruction::MultiplySubtract(all),
                    Fused::SubtractFrom(..) => Instruction::SubtractProduct(all),
                });
            }
            Step::Sines(pairs) => {
                let begin = self.code.angles.len();
                for pair in pairs {
                    let angle = self.at(pair.angle)?;
                    let sine = pair.sine.map(|one| self.target(one)).transpose()?;
                    let cosine = pair.cosine.map(|one| self.target(one)).transpose()?;
                    self.code.angles.push(Angle { angle, sine, cosine });
                }
                self.release(place, &read);
                let batch = Instruction::Sines(index(begin)?, index(pairs.len())?);
                self.code.instructions.push(batch);
            }
            Step::Operation(value) => self.operation(place, *value, &read)?,
        }
        Ok(())
    }

    /// Keeps where those values stand that columns read again and again.
    fn again(&mut self, values: &BTreeSet<Value>) -> Result<(), CannotRun> {
        for value in values {
            match self.slots.get(value) {
                Some(Slot::Number(at)) => {
                    for register in *at..at + self.length(*value) {
                        self.code.again.numbers.push(index(register)?);
                    }
                }
                Some(Slot::Condition(at)) => self.code.again.conditions.push(index(*at)?),
                _ => {}
            }
        }
        Ok(())
    }

    /// The registers of the results.
    fn finish(mut self, wanted: &Wanted) -> Result<Code, CannotRun> {
        let all = wanted.results.iter().chain(&wanted.columns).enumerate();
        for (place, value) in all {
            if place == wanted.results.len() {
                self.code.first = self.code.results.len();
            }
            let slot = self.slots.get(value).copied().ok_or(CannotRun::Missing)?;
            if wanted.keeps {
                self.code.kept.insert(*value, slot);
                continue;
            }
            match slot {
                Slot::Number(at) => {
                    let length = super::scope::numbers(self.program, *value);
                    self.code.results.extend((at..at + length).map(|one| one as Register));
                }
                Slot::Condition(at) => {
                    let target = index(self.numbers.one()?)?;
                    let select = Instruction::Select([target, index(at)?, self.one, self.zero]);
                    self.code.instructions.push(select);
                    self.code.results.push(target);
                }
                Slot::Bound(_) => {}
            }
        }
        if wanted.columns.is_empty() {
            self.code.first = self.code.results.len();
        }
        self.code.registers = self.numbers.count;
        self.code.conditions = self.conditions.count;
        Ok(self.code)
    }
}
