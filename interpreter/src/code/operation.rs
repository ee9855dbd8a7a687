//! Operations as instructions.

use assur_model::program::{Form, Function, OperationKind as Kind, Relation, Shape, Value};

use super::build::{Builder, index};
use super::{CannotRun, Code, Factor, Finding, Instruction, Lookup, Register, Slot, Solve};

impl Builder<'_> {
    /// Adds the instruction for an operation.
    pub(super) fn operation(
        &mut self,
        place: usize,
        value: Value,
        read: &[Value],
    ) -> Result<(), CannotRun> {
        use Instruction as Do;
        let kind = self.program.kind(value);
        let registers =
            read.iter().map(|one| self.at(*one)).collect::<Result<Vec<Register>, _>>()?;
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
                Do::Table(index(self.code.lookups.len() - 1)?)
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
                Do::Search(index(self.code.searches.len() - 1)?)
            }
            Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => {
                self.release(place, read);
                let at = self.conditions.one()?;
                self.slots.insert(value, Slot::Condition(at));
                let target = index(at)?;
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
    ) -> Result<Instruction, CannotRun> {
        let columns = |row: usize| if form == Form::General { rows } else { row + 1 };
        let places = (0..rows).flat_map(|row| (0..columns(row)).map(move |column| (row, column)));
        let mut all = Vec::new();
        for (row, column) in places {
            let entry = entries[form.place(rows, row, column)];
            // Most of a bound system is zero.
            let is_zero = matches!(self.program.kind(entry), Kind::Number(0.0));
            if !(is_zero && matches!(form, Form::Bound { .. })) {
                all.push((index(row)?, index(column)?, self.at(entry)?));
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
        Ok(Instruction::Factor(index(self.code.factors.len() - 1)?))
    }

    fn solve(
        &mut self,
        value: Value,
        factor: Value,
        registers: Vec<Register>,
    ) -> Result<Instruction, CannotRun> {
        let Shape::Factor(form, rows) = self.program.shape(factor) else {
            return Err(CannotRun::Missing);
        };
        let target = self.numbers.block(2 * rows)?;
        self.slots.insert(value, Slot::Number(target));
        let (factor, right) = (usize::from(registers[0]), registers[1..].to_vec());
        self.code.solves.push(Solve { form, factor, right, target });
        Ok(Instruction::Solve(index(self.code.solves.len() - 1)?))
    }
}
