//! From values of a program to the instructions that compute them.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{
    Form, Function, Fused, Line, Operation, OperationKind as Kind, Program, Relation, Shape, Stage,
    Value,
};

use super::order::{self, Step};
use super::registers::Registers;
use super::scope::Storage;
use super::{
    Angle, Code, Factor, Finding, Instruction, Kept, Load, Lookup, Register, Scope, Slot, Solve,
    TooLarge,
};

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
    pub fn new(
        program: &Program,
        storage: &Storage,
        scope: Scope,
        wanted: &Wanted,
        prepared: &BTreeMap<Value, Slot>,
    ) -> Result<Self, TooLarge> {
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
        let mut builder = Builder {
            program,
            code: Self::default(),
            slots: BTreeMap::new(),
            zero: None,
            one: None,
            numbers: Registers::default(),
            conditions: Registers::default(),
            last: last_reads(program, &steps, begin, &all),
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
        builder.finish(wanted)
    }

    /// The function that the line of a search is.
    fn of_line(line: &Line) -> Result<Self, TooLarge> {
        let operation =
            |kind: &Kind| Operation { kind: kind.clone(), stage: Stage::Trial, name: None };
        let program = Program {
            operations: line.operations.iter().map(operation).collect(),
            ..Program::default()
        };
        let storage = Storage::of(&program, 0);
        let wanted = Wanted::of([line.result]);
        Self::new(&program, &storage, Scope::Line, &wanted, &BTreeMap::new())
    }
}

/// The last step that reads each value; none of those that are results, or that columns read again and again.
fn last_reads(
    program: &Program,
    steps: &[Step],
    begin: usize,
    results: &[Value],
) -> BTreeMap<Value, usize> {
    let mut last = BTreeMap::new();
    let mut written = BTreeMap::new();
    for (place, step) in steps.iter().enumerate() {
        for value in step.reads(program) {
            let is_again = place >= begin && written.get(&value).is_none_or(|own| *own < begin);
            last.insert(value, if is_again { usize::MAX } else { place });
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
    last
}

struct Builder<'a> {
    program: &'a Program,
    code: Code,
    slots: BTreeMap<Value, Slot>,
    zero: Option<Register>,
    one: Option<Register>,
    numbers: Registers,
    conditions: Registers,
    last: BTreeMap<Value, usize>,
    /// Values whose registers are never given back.
    fixed: BTreeSet<Value>,
}

impl Builder<'_> {
    /// Puts numbers and what is prepared into the first registers.
    fn fix(
        &mut self,
        needed: &BTreeSet<Value>,
        results: &[Value],
        outside: &dyn Fn(Value) -> Option<Kept>,
        prepared: &BTreeMap<Value, Slot>,
    ) -> Result<(), TooLarge> {
        let program = self.program;
        let read = needed.iter().flat_map(|value| program.kind(*value).operands());
        let all: BTreeSet<Value> =
            read.chain(needed.iter().copied()).chain(results.iter().copied()).collect();
        self.zero = Some(self.number(0.0)?);
        self.one = Some(self.number(1.0)?);
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
            let Some(from) = prepared.get(&value) else { continue };
            let slot = match *from {
                Slot::Number(from) => {
                    let length = self.length(value);
                    let at = self.numbers.block(length)?;
                    self.code.fixed.kept.push((from, length, at));
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
    fn number(&mut self, number: f64) -> Result<Register, TooLarge> {
        let mut known = self.code.fixed.numbers.iter();
        if let Some(known) = known.find(|one| one.1.to_bits() == number.to_bits()) {
            return Ok(known.0);
        }
        let register = self.numbers.block(1)? as Register;
        self.code.fixed.numbers.push((register, number));
        Ok(register)
    }

    /// Puts what the caller gives into the next registers.
    fn load(
        &mut self,
        needed: &BTreeSet<Value>,
        results: &[Value],
        (storage, scope): (&Storage, Scope),
    ) -> Result<(), TooLarge> {
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
                let end = at + super::scope::numbers(program, value);
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
                    let zero = self.zero.unwrap_or_default();
                    let less = [condition as Register, zero, register as Register];
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
    fn length(&self, value: Value) -> usize {
        match self.program.shape(value) {
            Shape::Number | Shape::Mask => 1,
            Shape::Vector(size) => size,
            Shape::Factor(_, rows) => rows * (rows + 2),
        }
    }

    /// Room for the bound system that a value is.
    fn bound(&mut self, value: Value) -> usize {
        if let Shape::Factor(Form::Bound { unknowns, rank }, rows) = self.program.shape(value) {
            self.code.bounds.push([rows, unknowns as usize, rank as usize]);
        }
        self.code.bounds.len() - 1
    }

    /// The register of a number, or of a condition.
    fn at(&self, value: Value) -> Register {
        match self.slots.get(&value) {
            Some(Slot::Number(at) | Slot::Condition(at) | Slot::Bound(at)) => *at as Register,
            None => 0,
        }
    }

    /// Gives the registers back that nothing reads behind a step.
    fn release(&mut self, place: usize, values: &[Value]) {
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
    fn target(&mut self, value: Value) -> Result<Register, TooLarge> {
        let at = self.numbers.one()?;
        self.slots.insert(value, Slot::Number(at));
        Ok(at as Register)
    }

    fn step(&mut self, place: usize, step: &Step) -> Result<(), TooLarge> {
        let read = step.reads(self.program);
        match step {
            Step::Fused(value, fused) => {
                let (Fused::Add(a, b, c) | Fused::Subtract(a, b, c) | Fused::SubtractFrom(a, b, c)) =
                    *fused;
                let [a, b, c] = [a, b, c].map(|one| self.at(one));
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
                    let angle = self.at(pair.angle);
                    let sine = pair.sine.map(|one| self.target(one)).transpose()?;
                    let cosine = pair.cosine.map(|one| self.target(one)).transpose()?;
                    self.code.angles.push(Angle { angle, sine, cosine });
                }
                self.release(place, &read);
                let count = pairs.len() as u16;
                self.code.instructions.push(Instruction::Sines(begin as u16, count));
            }
            Step::Operation(value) => self.operation(place, *value, &read)?,
        }
        Ok(())
    }

    fn operation(&mut self, place: usize, value: Value, read: &[Value]) -> Result<(), TooLarge> {
        use Instruction as Do;
        let kind = self.program.kind(value);
        let registers: Vec<Register> = read.iter().map(|one| self.at(*one)).collect();
        let with = |target: Register| [target, registers[0], registers[1]];
        let with_three = |target: Register| [target, registers[0], registers[1], registers[2]];
        let instruction = match kind {
            Kind::Number(_) | Kind::Input(_) => return Ok(()),
            Kind::Element { index, .. } => {
                let at = usize::from(registers[0]) + *index as usize;
                self.slots.insert(value, Slot::Number(at));
                return Ok(());
            }
            Kind::Factor { form, size, entries } => {
                self.factor(value, (*form, *size as usize), entries)?
            }
            Kind::Solve { factor, .. } => self.solve(value, *factor, registers)?,
            Kind::Table { spline, .. } => {
                let target = self.numbers.block(self.length(value))?;
                self.slots.insert(value, Slot::Number(target));
                self.code.lookups.push(Lookup { spline: spline.clone(), at: registers[0], target });
                Do::Table(self.code.lookups.len() as u16 - 1)
            }
            Kind::Search { search, text, lines, .. } => {
                let target = self.target(value)?;
                let begin = self.code.lines.len();
                for line in lines {
                    self.code.lines.push(Code::of_line(line)?);
                }
                let (lines, text) = ((begin..self.code.lines.len()).collect(), text.clone());
                let (search, captured) = (*search, registers);
                self.code.searches.push(Finding { search, text, captured, lines, target });
                Do::Search(self.code.searches.len() as u16 - 1)
            }
            Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => {
                self.release(place, read);
                let at = self.conditions.one()?;
                self.slots.insert(value, Slot::Condition(at));
                let target = at as Register;
                match kind {
                    Kind::Compare(Relation::Less, ..) => Do::Less(with(target)),
                    Kind::Compare(Relation::LessEqual, ..) => Do::LessEqual(with(target)),
                    Kind::Compare(Relation::Equal, ..) => Do::Equal(with(target)),
                    Kind::And(..) => Do::And(with(target)),
                    Kind::Or(..) => Do::Or(with(target)),
                    _ => Do::Not([target, registers[0]]),
                }
            }
            _ => {
                self.release(place, read);
                let target = self.target(value)?;
                match kind {
                    Kind::Add(..) => Do::Add(with(target)),
                    Kind::Subtract(..) => Do::Subtract(with(target)),
                    Kind::Multiply(..) => Do::Multiply(with(target)),
                    Kind::Divide(..) => Do::Divide(with(target)),
                    Kind::Negate(_) => Do::Negate([target, registers[0]]),
                    Kind::MultiplyAdd(..) => Do::MultiplyAdd(with_three(target)),
                    Kind::MultiplySubtract(..) => Do::MultiplySubtract(with_three(target)),
                    Kind::NegateMultiplyAdd(..) => Do::SubtractProduct(with_three(target)),
                    Kind::Call(Function::Sqrt, _) => Do::Root([target, registers[0]]),
                    Kind::Call(function, list) if list.len() == 2 => {
                        Do::CallTwo(*function, with(target))
                    }
                    Kind::Call(function, _) => Do::Call(*function, [target, registers[0]]),
                    _ => Do::Select(with_three(target)),
                }
            }
        };
        self.code.instructions.push(instruction);
        Ok(())
    }

    fn factor(
        &mut self,
        value: Value,
        (form, rows): (Form, usize),
        entries: &[Value],
    ) -> Result<Instruction, TooLarge> {
        let columns = |row: usize| if form == Form::General { rows } else { row + 1 };
        let places = (0..rows).flat_map(|row| (0..columns(row)).map(move |column| (row, column)));
        let mut all = Vec::new();
        for (row, column) in places {
            let entry = entries[form.place(rows, row, column)];
            // Most of a bound system is zero.
            let is_zero = matches!(self.program.kind(entry), Kind::Number(0.0));
            if !(is_zero && matches!(form, Form::Bound { .. })) {
                all.push((row as u16, column as u16, self.at(entry)));
            }
        }
        let target = match form {
            Form::Bound { .. } => {
                let at = self.bound(value);
                self.slots.insert(value, Slot::Bound(at));
                at
            }
            _ => {
                let at = self.numbers.block(self.length(value))?;
                self.slots.insert(value, Slot::Number(at));
                at
            }
        };
        self.code.factors.push(Factor { form, rows, target, entries: all });
        Ok(Instruction::Factor(self.code.factors.len() as u16 - 1))
    }

    fn solve(
        &mut self,
        value: Value,
        factor: Value,
        registers: Vec<Register>,
    ) -> Result<Instruction, TooLarge> {
        let Shape::Factor(form, rows) = self.program.shape(factor) else {
            return Ok(Instruction::Negate([0, 0]));
        };
        let target = self.numbers.block(2 * rows)?;
        self.slots.insert(value, Slot::Number(target));
        let (factor, right) = (usize::from(registers[0]), registers[1..].to_vec());
        self.code.solves.push(Solve { form, factor, right, target });
        Ok(Instruction::Solve(self.code.solves.len() as u16 - 1))
    }

    /// The registers of the results.
    fn finish(mut self, wanted: &Wanted) -> Result<Code, TooLarge> {
        let all = wanted.results.iter().chain(&wanted.columns).enumerate();
        for (index, value) in all {
            if index == wanted.results.len() {
                self.code.first = self.code.results.len();
            }
            let Some(slot) = self.slots.get(value).copied() else {
                // What is neither computed nor given has no value here.
                let register = self.number_behind()?;
                self.code.results.push(register);
                continue;
            };
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
                    let target = self.numbers.one()? as Register;
                    let (one, zero) = (self.one.unwrap_or_default(), self.zero.unwrap_or_default());
                    let select = Instruction::Select([target, at as Register, one, zero]);
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

    /// A register that holds no number.
    fn number_behind(&mut self) -> Result<Register, TooLarge> {
        let register = self.numbers.one()? as Register;
        let zero = self.zero.unwrap_or_default();
        self.code.instructions.push(Instruction::Divide([register, zero, zero]));
        Ok(register)
    }
}
