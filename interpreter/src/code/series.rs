//! The Taylor series of some values as a list of what is done for each order.

use std::collections::{BTreeMap, BTreeSet};

use assur_model::program::{
    Form, Function, Input, OperationKind as Kind, Program, Series as Rules, Shape, Step, Value,
};

/// Something that is the same all along the step.
#[derive(Clone, Copy, Debug)]
pub enum Steady {
    /// A number of the program.
    Number(f64),
    /// A prepared value.
    Prepared(Value),
    /// What the first terms have decided, in this slot.
    Decided(usize),
}

/// A term that is read.
#[derive(Clone, Copy, Debug)]
pub enum Term {
    /// Of something steady: itself, then zero.
    Steady(Steady),
    /// In this slot.
    Slot(usize),
    /// Of a factor that is computed where it is read, one of [`Plan::late`].
    Late(usize),
}

/// A condition.
#[derive(Clone, Copy, Debug)]
pub enum Condition {
    /// A prepared one.
    Prepared(Value),
    /// One that the first terms have decided.
    Decided(usize),
}

/// A product.
#[derive(Clone, Copy, Debug)]
pub enum Product {
    /// Of two terms, remembered.
    Of(usize, Term, Term),
    /// Of something steady with a term.
    Scaled(Steady, Term),
}

/// How the next term of a value follows. Memories are numbered by their kind.
#[derive(Clone, Debug)]
pub enum Next {
    Time,
    State(usize),
    Add(Term, Term),
    Subtract(Term, Term),
    Negate(Term),
    Product(Product),
    ProductPlus(Product, Term),
    ProductMinus(Product, Term),
    MinusProduct(Product, Term),
    DivideSteady(Term, Steady),
    Quotient(usize, Term, Term),
    Select(Condition, Term, Term),
    Element(usize, usize),
    Abs(usize, Term),
    /// The larger or the smaller of two, as the first terms say.
    Extreme(usize, bool, Term, Term),
    One(usize, Term),
    Two(usize, Term, Term),
    PowerSteady(usize, Term, Steady),
    /// By logarithm, product and exponential.
    Power([usize; 3], Term, Term),
}

/// Something that is done for each order.
#[derive(Clone, Debug)]
pub enum Act {
    /// A side of a switching surface.
    Side(usize, usize),
    /// A number that the first terms decide.
    Decide(usize, Kind, Vec<First>),
    /// A condition that they decide.
    Condition(usize, Kind, Vec<First>),
    /// Sine and cosine of an angle.
    Pair { memory: usize, angle: Term, sine: Option<usize>, cosine: Option<usize> },
    /// A term.
    Term(usize, Next),
    /// The solution of a system: its matrix, or prepared factors, and the slots from one on.
    Solve { matrix: Matrix, right: Vec<Term>, target: usize },
}

/// The matrix of a system.
#[derive(Clone, Debug)]
pub enum Matrix {
    /// Prepared factors of so many rows.
    Prepared(Value, Form),
    /// Terms of its entries; those that are not stored are zero. Remembered.
    Terms { memory: usize, form: Form, entries: Vec<Term> },
}

/// What a decision reads.
#[derive(Clone, Copy, Debug)]
pub enum First {
    Steady(Steady),
    Slot(usize),
    Condition(Condition),
}

/// A memory of two quantities.
#[derive(Clone, Copy, Debug)]
pub enum Two {
    Product,
    Quotient,
    Power,
    Of(Function),
}

/// What is done for each order, and what remembers terms.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    pub acts: Vec<Act>,
    /// Factors that are computed where they are read.
    pub late: Vec<Next>,
    /// The terms of the wanted values.
    pub results: Vec<Term>,
    pub slots: usize,
    pub conditions: usize,
    /// Memories of one quantity.
    pub one: Vec<Function>,
    /// Memories of two.
    pub two: Vec<Two>,
    /// Memories of sine and cosine; of an angle that grows evenly.
    pub pairs: Vec<bool>,
    /// Memories of systems: their numbers of rows.
    pub systems: Vec<usize>,
}

impl Plan {
    /// The series of some values; none where there is none.
    pub fn new(program: &Program, wanted: &[Value]) -> Option<Self> {
        let rules = program.series(wanted)?;
        let mut writer = Writer {
            program,
            rules: &rules,
            plan: Self::default(),
            slots: BTreeMap::new(),
            conditions: BTreeMap::new(),
            late: BTreeMap::new(),
            solved: BTreeSet::new(),
        };
        for step in rules.steps(wanted) {
            writer.step(step)?;
        }
        writer.plan.results = wanted.iter().map(|value| writer.term(*value)).collect();
        Some(writer.plan)
    }
}

struct Writer<'a> {
    program: &'a Program,
    rules: &'a Rules<'a>,
    plan: Plan,
    slots: BTreeMap<Value, usize>,
    conditions: BTreeMap<Value, usize>,
    late: BTreeMap<Value, usize>,
    solved: BTreeSet<Value>,
}

impl Writer<'_> {
    fn slot(&mut self, value: Value, count: usize) -> usize {
        let slot = self.plan.slots;
        self.plan.slots += count;
        self.slots.insert(value, slot);
        slot
    }

    fn steady(&self, value: Value) -> Steady {
        match (self.program.kind(value), self.slots.get(&value)) {
            (Kind::Number(number), _) => Steady::Number(*number),
            (_, Some(slot)) => Steady::Decided(*slot),
            _ => Steady::Prepared(value),
        }
    }

    fn condition(&self, value: Value) -> Condition {
        match self.conditions.get(&value) {
            Some(own) => Condition::Decided(*own),
            None => Condition::Prepared(value),
        }
    }

    fn term(&self, value: Value) -> Term {
        if matches!(self.program.kind(value), Kind::Number(_)) || self.rules.is_steady(value) {
            return Term::Steady(self.steady(value));
        }
        match (self.late.get(&value), self.slots.get(&value)) {
            (Some(late), _) => Term::Late(*late),
            (_, Some(slot)) => Term::Slot(*slot),
            _ => Term::Steady(self.steady(value)),
        }
    }

    fn first(&self, value: Value) -> First {
        let is_condition = self.program.shape(value) == Shape::Mask;
        match (is_condition, self.rules.is_constant(value), self.slots.get(&value)) {
            (true, ..) => First::Condition(self.condition(value)),
            (_, false, Some(slot)) => First::Slot(*slot),
            _ => First::Steady(self.steady(value)),
        }
    }

    fn step(&mut self, step: Step) -> Option<()> {
        match step {
            Step::Decided(value) => self.decided(value)?,
            Step::Pair(pair, is_even) => {
                let angle = self.term(pair.angle);
                let sine = pair.sine.map(|value| self.slot(value, 1));
                let cosine = pair.cosine.map(|value| self.slot(value, 1));
                let memory = self.plan.pairs.len();
                self.plan.pairs.push(is_even);
                self.plan.acts.push(Act::Pair { memory, angle, sine, cosine });
            }
            Step::Term(value) => match self.program.kind(value) {
                Kind::Solve { factor, right } => self.solve(value, *factor, right)?,
                _ => {
                    let next = self.next(value)?;
                    let slot = self.slot(value, 1);
                    self.plan.acts.push(Act::Term(slot, next));
                }
            },
            Step::Factor(value) => {
                let next = self.next(value)?;
                self.late.insert(value, self.plan.late.len());
                self.plan.late.push(next);
            }
        }
        Some(())
    }

    fn decided(&mut self, value: Value) -> Option<()> {
        let kind = self.program.kind(value);
        if let Kind::Input(Input::Side(index)) = kind {
            let slot = self.slot(value, 1);
            self.plan.acts.push(Act::Side(slot, *index as usize));
            return Some(());
        }
        if matches!(kind, Kind::Search { .. } | Kind::Table { .. }) {
            return None;
        }
        let read = kind.operands().into_iter().map(|operand| self.first(operand)).collect();
        if self.program.shape(value) == Shape::Mask {
            self.conditions.insert(value, self.plan.conditions);
            self.plan.acts.push(Act::Condition(self.plan.conditions, kind.clone(), read));
            self.plan.conditions += 1;
        } else {
            let slot = self.slot(value, 1);
            self.plan.acts.push(Act::Decide(slot, kind.clone(), read));
        }
        Some(())
    }

    fn two(&mut self, kind: Two) -> usize {
        self.plan.two.push(kind);
        self.plan.two.len() - 1
    }

    fn product(&mut self, a: Value, b: Value) -> Product {
        match self.rules.scaled(a, b) {
            Some((factor, value)) => Product::Scaled(self.steady(factor), self.term(value)),
            None => {
                let (first, second) = (self.term(a), self.term(b));
                Product::Of(self.two(Two::Product), first, second)
            }
        }
    }

    fn kept(&mut self) -> usize {
        self.plan.conditions += 1;
        self.plan.conditions - 1
    }

    fn next(&mut self, value: Value) -> Option<Next> {
        let kind = self.program.kind(value);
        Some(match kind {
            Kind::Input(Input::Time) => Next::Time,
            Kind::Input(Input::State(index)) => Next::State(*index as usize),
            Kind::Add(a, b) => Next::Add(self.term(*a), self.term(*b)),
            Kind::Subtract(a, b) => Next::Subtract(self.term(*a), self.term(*b)),
            Kind::Negate(a) => Next::Negate(self.term(*a)),
            Kind::Multiply(a, b) => Next::Product(self.product(*a, *b)),
            Kind::MultiplyAdd(a, b, c) => Next::ProductPlus(self.product(*a, *b), self.term(*c)),
            Kind::MultiplySubtract(a, b, c) => {
                Next::ProductMinus(self.product(*a, *b), self.term(*c))
            }
            Kind::NegateMultiplyAdd(a, b, c) => {
                Next::MinusProduct(self.product(*a, *b), self.term(*c))
            }
            Kind::Divide(a, b) if self.rules.is_steady(*b) => {
                Next::DivideSteady(self.term(*a), self.steady(*b))
            }
            Kind::Divide(a, b) => {
                let (a, b) = (self.term(*a), self.term(*b));
                Next::Quotient(self.two(Two::Quotient), a, b)
            }
            Kind::Select { condition, then, otherwise } => {
                let condition = self.condition(*condition);
                Next::Select(condition, self.term(*then), self.term(*otherwise))
            }
            Kind::Element { solution, index } if self.solved.contains(solution) => {
                Next::Element(self.slots[solution], *index as usize)
            }
            Kind::Call(function, list) => self.call(*function, list)?,
            _ => return None,
        })
    }

    fn call(&mut self, function: Function, read: &[Value]) -> Option<Next> {
        let terms: Vec<Term> = read.iter().map(|value| self.term(*value)).collect();
        Some(match (function, terms.as_slice()) {
            (Function::Abs, [a]) => Next::Abs(self.kept(), *a),
            (Function::Max | Function::Min, [a, b]) => {
                Next::Extreme(self.kept(), function == Function::Max, *a, *b)
            }
            (Function::Power, [base, _]) if self.rules.is_steady(read[1]) => {
                let exponent = self.steady(read[1]);
                Next::PowerSteady(self.two(Two::Power), *base, exponent)
            }
            (Function::Power, [base, exponent]) => {
                self.plan.one.extend([Function::Ln, Function::Exp]);
                let logarithm = self.plan.one.len() - 2;
                let memories = [logarithm, self.two(Two::Product), logarithm + 1];
                Next::Power(memories, *base, *exponent)
            }
            (Function::Sin | Function::Cos | Function::Sign | Function::Floor, _) => return None,
            (Function::Atan2 | Function::Hypot, [a, b]) => {
                Next::Two(self.two(Two::Of(function)), *a, *b)
            }
            (_, [a]) => {
                self.plan.one.push(function);
                Next::One(self.plan.one.len() - 1, *a)
            }
            _ => return None,
        })
    }

    fn solve(&mut self, value: Value, factor: Value, right: &[Value]) -> Option<()> {
        let right: Vec<Term> = right.iter().map(|value| self.term(*value)).collect();
        let Shape::Factor(form, rows) = self.program.shape(factor) else { return None };
        let matrix = match self.program.kind(factor) {
            Kind::Factor { entries, .. } if !self.rules.is_constant(factor) => {
                let places = (0..rows).flat_map(|i| (0..rows).map(move |j| (i, j)));
                let entries = places.map(|(i, j)| self.term(entries[form.place(rows, i, j)]));
                let (entries, memory) = (entries.collect(), self.plan.systems.len());
                self.plan.systems.push(rows);
                Matrix::Terms { memory, form, entries }
            }
            _ => Matrix::Prepared(factor, form),
        };
        let target = self.slot(value, rows);
        self.solved.insert(value);
        self.plan.acts.push(Act::Solve { matrix, right, target });
        Some(())
    }
}
