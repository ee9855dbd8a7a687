//! The Taylor series of values in time: the same operations as for the values themselves, term by term.
//!
//! What holds all along the step is told from what has terms of its own, and for each operation that has it is said which
//! recurrence gives the next one. Whoever runs the program, printed or interpreted, does the steps in their order, once
//! for each order.

use std::collections::{BTreeMap, BTreeSet};

use super::{Function, Input, OperationKind as Kind, Pair, Program, Relation, Stage, Value};

/// Most operations of a series: rustc is slow on longer scopes.
const LONGEST: usize = 600;

/// Highest degree of what cannot vanish so that a series of few terms does not tell.
const HIGHEST: usize = 4;

/// How the terms of some values follow from each other.
#[derive(Clone, Debug)]
pub struct Series<'a> {
    program: &'a Program,
    /// The values that have terms, or are decided by the first ones.
    needed: BTreeSet<Value>,
    /// Values that the first terms decide.
    decided: BTreeSet<Value>,
}

/// What is done for one order of the series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A value that the first terms decide, and that is the same all along the step.
    Decided(Value),
    /// Sine and cosine of an angle; the recurrence for one that grows evenly with the time is shorter.
    Pair(Pair, bool),
    /// The next term of an operation.
    Term(Value),
    /// Of a factor that a single product with something steady reads: it may be left out where that is zero.
    Factor(Value),
}

impl Program {
    /// The series of some values; none where an operation has no series, or where there are too many.
    pub fn series(&self, wanted: &[Value]) -> Option<Series<'_>> {
        let needed = self.needed(wanted, &|value| self.stage(value) <= Stage::Parameter);
        let mut series = Series { program: self, needed, decided: BTreeSet::new() };
        for value in &series.needed {
            if series.is_decided(*value) {
                series.decided.insert(*value);
            }
        }
        let is_short = series.operations() <= LONGEST;
        let has_terms = series.needed.iter().all(|value| series.has_terms(*value));
        (is_short && has_terms).then_some(series)
    }
}

impl Series<'_> {
    /// How many operations it takes for each order.
    pub fn operations(&self) -> usize {
        self.needed.len()
    }

    /// How many operations each term takes, one at least, and how many sums over all terms so far.
    pub fn counts(&self) -> (usize, usize) {
        let values = || self.needed.iter().copied();
        let operations = values().map(|value| self.program.kind(value).weight());
        (operations.sum::<usize>().max(1), values().map(|value| self.sums(value)).sum())
    }

    /// How many values may change within a step and change back without that its terms tell: branches, what saturates or has
    /// poles beside the real axis, high powers. Other sums and products of sines and cosines have terms where they change. Sides of
    /// switching surfaces are held all along a step, and what says them otherwise does not count.
    pub fn unfelt(&self, wanted: &[Value]) -> usize {
        let mut degrees: BTreeMap<Value, usize> = BTreeMap::new();
        for value in &self.reached(wanted) {
            let degree =
                self.degree(*value, &|operand| degrees.get(&operand).copied().unwrap_or(0));
            degrees.insert(*value, degree);
        }
        degrees.values().filter(|degree| **degree > HIGHEST).count()
    }

    /// What some values are made of where the sides of switching surfaces are held.
    fn reached(&self, wanted: &[Value]) -> BTreeSet<Value> {
        let (mut reached, mut open) = (BTreeSet::new(), wanted.to_vec());
        while let Some(value) = open.pop() {
            if !self.needed.contains(&value) || !reached.insert(value) {
                continue;
            }
            match self.program.kind(value) {
                Kind::Select { condition, otherwise, .. } if self.asks_for_side(*condition) => {
                    open.push(*otherwise);
                }
                kind => open.extend(kind.operands()),
            }
        }
        reached
    }

    /// Whether a condition is that a side is left to the values.
    fn asks_for_side(&self, condition: Value) -> bool {
        let is_side =
            |value: &Value| matches!(self.program.kind(*value), Kind::Input(Input::Side(_)));
        matches!(self.program.kind(condition), Kind::Compare(Relation::Equal, a, b) if is_side(a) || is_side(b))
    }

    /// The degree of a value in time, states, sines and cosines; above the highest where it is no polynomial.
    fn degree(&self, value: Value, of: &dyn Fn(Value) -> usize) -> usize {
        let kind = self.program.kind(value);
        let largest = || kind.operands().into_iter().map(of).max().unwrap_or(0);
        let product = |a: &Value, b: &Value| (of(*a) + of(*b)).min(1 + HIGHEST);
        match kind {
            Kind::Input(Input::Time | Input::State(_)) => 1,
            Kind::Add(..) | Kind::Subtract(..) | Kind::Negate(_) => largest(),
            Kind::Multiply(a, b) => product(a, b),
            Kind::MultiplyAdd(a, b, c)
            | Kind::MultiplySubtract(a, b, c)
            | Kind::NegateMultiplyAdd(a, b, c) => product(a, b).max(of(*c)),
            Kind::Divide(a, below) if of(*below) == 0 => of(*a),
            Kind::Solve { factor, .. } if of(*factor) == 0 => largest(),
            Kind::Element { .. } => largest(),
            Kind::Select { condition, .. } if of(*condition) == 0 => largest(),
            Kind::Call(Function::Sin | Function::Cos, _) => largest(),
            _ if largest() == 0 => 0,
            _ => 1 + HIGHEST,
        }
    }

    /// How many sums over all terms so far a value takes.
    fn sums(&self, value: Value) -> usize {
        let kind = self.program.kind(value);
        if kind.operands().into_iter().all(|operand| self.is_steady(operand)) {
            return 0;
        }
        match kind {
            Kind::Multiply(a, b)
            | Kind::MultiplyAdd(a, b, _)
            | Kind::MultiplySubtract(a, b, _)
            | Kind::NegateMultiplyAdd(a, b, _) => usize::from(self.scaled(*a, *b).is_none()),
            Kind::Divide(_, below) => usize::from(!self.is_steady(*below)),
            Kind::Solve { factor, right } => match self.is_constant(*factor) {
                true => 0,
                false => right.len() * right.len(),
            },
            Kind::Call(function, operands) => match function {
                Function::Abs | Function::Min | Function::Max => 0,
                Function::Sign | Function::Floor => 0,
                // One for each of a pair.
                Function::Sin | Function::Cos => usize::from(!self.is_even(operands[0])),
                Function::Exp | Function::ExpM1 | Function::Sqrt => 1,
                Function::Power if self.is_steady(operands[1]) => 2,
                Function::Asin | Function::Acos | Function::Atan2 => 5,
                _ => 3,
            },
            _ => 0,
        }
    }

    /// What is done for each order. `wanted` are the values whose terms are read in the end.
    pub fn steps(&self, wanted: &[Value]) -> Vec<Step> {
        let mut steps = Vec::new();
        let mut paired: BTreeSet<Value> = BTreeSet::new();
        for value in self.needed.iter().copied() {
            if paired.contains(&value) || matches!(self.program.kind(value), Kind::Factor { .. }) {
                continue;
            }
            steps.push(if self.decided.contains(&value) {
                Step::Decided(value)
            } else if let Some(pair) = self.pair(value) {
                paired.extend(pair.sine.into_iter().chain(pair.cosine));
                Step::Pair(pair, self.is_even(pair.angle))
            } else if self.is_factor(value, wanted) {
                Step::Factor(value)
            } else {
                Step::Term(value)
            });
        }
        steps
    }

    /// Whether a value depends on nothing but the parameters.
    pub fn is_constant(&self, value: Value) -> bool {
        self.program.stage(value) <= Stage::Parameter
    }

    /// Whether a value is the same all along the step.
    pub fn is_steady(&self, value: Value) -> bool {
        self.is_constant(value) || self.decided.contains(&value)
    }

    /// The factors of a product, the steady one first; none where both have terms.
    pub fn scaled(&self, a: Value, b: Value) -> Option<(Value, Value)> {
        match (self.is_steady(a), self.is_steady(b)) {
            (true, _) => Some((a, b)),
            (_, true) => Some((b, a)),
            _ => None,
        }
    }

    /// Whether a value is decided by the first terms.
    fn is_decided(&self, value: Value) -> bool {
        let kind = self.program.kind(value);
        match kind {
            Kind::Input(Input::Side(_)) | Kind::Compare(..) => true,
            Kind::Call(Function::Sign | Function::Floor, _) => true,
            Kind::Number(_) | Kind::Input(_) => false,
            Kind::Factor { .. } | Kind::Solve { .. } | Kind::Element { .. } => false,
            _ => kind.operands().into_iter().all(|operand| self.is_steady(operand)),
        }
    }

    /// Whether there is a recurrence for the terms of a value, or it needs none.
    fn has_terms(&self, value: Value) -> bool {
        match self.program.kind(value) {
            Kind::Input(Input::Time | Input::State(_)) => true,
            Kind::Input(_)
            | Kind::And(..)
            | Kind::Or(..)
            | Kind::Not(_)
            | Kind::Search { .. }
            | Kind::Table { .. } => self.is_steady(value),
            _ => true,
        }
    }

    /// Sine and cosine of one angle, if a value is one of them.
    fn pair(&self, value: Value) -> Option<Pair> {
        let angle = self.program.angle(value)?;
        let of = |function: Function| {
            let kind = Kind::Call(function, vec![angle]);
            self.needed.iter().find(|one| *self.program.kind(**one) == kind).copied()
        };
        Some(Pair { angle, sine: of(Function::Sin), cosine: of(Function::Cos) })
    }

    /// Whether a value is read once, by a product with something steady, and worth leaving out where that is zero.
    fn is_factor(&self, value: Value, wanted: &[Value]) -> bool {
        let is_long = match self.program.kind(value) {
            Kind::Multiply(a, b) | Kind::MultiplyAdd(a, b, _) => {
                !self.is_steady(*a) && !self.is_steady(*b)
            }
            Kind::Divide(_, below) => !self.is_steady(*below),
            Kind::Call(..) => true,
            _ => false,
        };
        let reads = |reader: &Value| {
            let operands = self.program.kind(*reader).operands();
            operands.iter().filter(|operand| **operand == value).count()
        };
        let by_product = |reader: &Value| match self.program.kind(*reader) {
            Kind::Multiply(a, b)
            | Kind::MultiplyAdd(a, b, _)
            | Kind::MultiplySubtract(a, b, _)
            | Kind::NegateMultiplyAdd(a, b, _) => {
                *a == value && self.is_steady(*b) || *b == value && self.is_steady(*a)
            }
            _ => false,
        };
        is_long
            && !wanted.contains(&value)
            && self.needed.iter().map(reads).sum::<usize>() == 1
            && self.needed.iter().any(by_product)
    }

    /// Whether a value grows evenly with the time.
    fn is_even(&self, value: Value) -> bool {
        let constant = |value: &Value| self.is_steady(*value);
        let product = |a: &Value, b: &Value| {
            constant(a) && self.is_even(*b) || constant(b) && self.is_even(*a)
        };
        constant(&value)
            || match self.program.kind(value) {
                Kind::Input(Input::Time) => true,
                Kind::Add(a, b) | Kind::Subtract(a, b) => self.is_even(*a) && self.is_even(*b),
                Kind::Negate(a) => self.is_even(*a),
                Kind::Multiply(a, b) => product(a, b),
                Kind::Divide(a, b) => constant(b) && self.is_even(*a),
                Kind::MultiplyAdd(a, b, c)
                | Kind::MultiplySubtract(a, b, c)
                | Kind::NegateMultiplyAdd(a, b, c) => product(a, b) && self.is_even(*c),
                _ => false,
            }
    }
}
