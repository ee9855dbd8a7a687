//! The Taylor series of a motion, one order after the other.

use assur_model::program::{Form, Function, OperationKind as Kind, Relation, Value};
use assur_solvers::dense::BoundRows;
use assur_solvers::scalar::Scalar;
use assur_solvers::series::{self, MatrixRows, TERMS};

use super::memory::Kept;
use super::run::{one, two};
use super::systems::{factor_block, solve_block};
use crate::code::Slot;
use crate::code::series::{Act, Condition, First, Matrix, Next, Plan, Product, Steady, Term, Two};

/// Where prepared values stand.
type Prepared<'a, S> = (&'a Kept<S>, &'a dyn Fn(Value) -> Option<Slot>);
/// Something that remembers one quantity.
type OneMemory<S> = Box<dyn FnMut(usize, S) -> S>;
/// Something that remembers two.
type TwoMemory<S> = Box<dyn FnMut(usize, S, S) -> S>;
/// Something that remembers an angle.
type PairMemory<S> = Box<dyn FnMut(usize, S) -> (S, S)>;

/// What is known on the way.
struct Course<'a, S: Scalar> {
    plan: &'a Plan,
    prepared: Prepared<'a, S>,
    slots: Vec<S>,
    conditions: Vec<S::Mask>,
    one: Vec<OneMemory<S>>,
    two: Vec<TwoMemory<S>>,
    pairs: Vec<PairMemory<S>>,
    systems: Vec<(MatrixRows<S>, Option<Factors<S>>)>,
    sides: &'a [S],
    time: S,
    length: S,
    k: usize,
}

/// A matrix at the begin of a step, factored.
enum Factors<S> {
    Block(Form, Vec<S>),
    Bound(Box<BoundRows<S>>),
}

/// Writes the series of a state: see `Equations::series`.
pub fn run<S: Scalar>(
    plan: &Plan,
    prepared: Prepared<'_, S>,
    sides: &[S],
    (time, length): (S, S),
    rows: &mut [S],
) {
    let states = plan.results.len().max(1);
    let none = S::less(S::ZERO, S::ZERO);
    let mut course = Course {
        plan,
        prepared,
        slots: vec![S::ZERO; plan.slots],
        conditions: vec![none; plan.conditions],
        one: plan.one.iter().map(|function| of_one(*function)).collect(),
        two: plan.two.iter().map(|kind| of_two(*kind)).collect(),
        pairs: plan.pairs.iter().map(|is_even| of_angle(*is_even)).collect(),
        systems: plan.systems.iter().map(|rows| (MatrixRows::new(*rows), None)).collect(),
        sides,
        time,
        length,
        k: 0,
    };
    let count = rows.len() / states;
    for k in 0..count.saturating_sub(1).min(TERMS) {
        let (before, next) = rows.split_at_mut((k + 1) * states);
        course.k = k;
        course.order(&before[k * states..]);
        let step = length * series::inverse(k + 1);
        for (next, rate) in next.iter_mut().zip(&plan.results) {
            *next = step * course.term(*rate, &before[k * states..]);
        }
    }
}

impl<S: Scalar> Course<'_, S> {
    fn order(&mut self, state: &[S]) {
        let plan = self.plan;
        for act in &plan.acts {
            match act {
                Act::Side(slot, index) => {
                    self.slots[*slot] = self.sides.get(*index).copied().unwrap_or(S::ZERO);
                }
                Act::Decide(slot, kind, read) if self.k == 0 => {
                    self.slots[*slot] = self.number(kind, read);
                }
                Act::Condition(at, kind, read) if self.k == 0 => {
                    self.conditions[*at] = self.mask(kind, read);
                }
                Act::Decide(..) | Act::Condition(..) => {}
                Act::Pair { memory, angle, sine, cosine } => {
                    let angle = self.term(*angle, state);
                    let found = self.pairs[*memory](self.k, angle);
                    sine.iter().for_each(|slot| self.slots[*slot] = found.0);
                    cosine.iter().for_each(|slot| self.slots[*slot] = found.1);
                }
                Act::Term(slot, next) => self.slots[*slot] = self.next(next, state),
                Act::Solve { matrix, right, target } => {
                    let mut x: Vec<S> = right.iter().map(|one| self.term(*one, state)).collect();
                    self.solve(matrix, &mut x, state);
                    self.slots[*target..][..x.len()].copy_from_slice(&x);
                }
            }
        }
    }

    fn steady(&self, steady: Steady) -> S {
        match steady {
            Steady::Number(number) => S::from_f64(number),
            Steady::Decided(slot) => self.slots[slot],
            Steady::Prepared(value) => {
                let slot = (self.prepared.1)(value);
                let number = slot.and_then(|slot| self.prepared.0.number(slot));
                number.unwrap_or(S::from_f64(f64::NAN))
            }
        }
    }

    fn term(&mut self, term: Term, state: &[S]) -> S {
        match term {
            Term::Steady(Steady::Number(0.0)) => S::ZERO,
            Term::Steady(Steady::Number(1.0)) => series::one(self.k),
            Term::Steady(steady) => series::one::<S>(self.k) * self.steady(steady),
            Term::Slot(slot) => self.slots[slot],
            Term::Late(late) => self.next(&self.plan.late[late], state),
        }
    }

    fn holds(&self, condition: Condition) -> S::Mask {
        match condition {
            Condition::Decided(at) => self.conditions[at],
            Condition::Prepared(value) => {
                let slot = (self.prepared.1)(value);
                let mask = slot.and_then(|slot| self.prepared.0.condition(slot));
                mask.unwrap_or(S::less(S::ZERO, S::ZERO))
            }
        }
    }

    fn first(&self, first: First) -> S {
        match first {
            First::Steady(steady) => self.steady(steady),
            First::Slot(slot) => self.slots[slot],
            First::Condition(_) => S::ZERO,
        }
    }

    fn first_mask(&self, first: First) -> S::Mask {
        match first {
            First::Condition(condition) => self.holds(condition),
            _ => S::less(S::ZERO, S::ZERO),
        }
    }

    /// What the first terms say a number is.
    fn number(&self, kind: &Kind, read: &[First]) -> S {
        let at = |index: usize| self.first(read[index]);
        match kind {
            Kind::Number(number) => S::from_f64(*number),
            Kind::Add(..) => at(0) + at(1),
            Kind::Subtract(..) => at(0) - at(1),
            Kind::Multiply(..) => at(0) * at(1),
            Kind::Divide(..) => at(0) / at(1),
            Kind::Negate(_) => -at(0),
            Kind::MultiplyAdd(..) => S::mul_add(at(0), at(1), at(2)),
            Kind::MultiplySubtract(..) => S::mul_add(at(0), at(1), -at(2)),
            Kind::NegateMultiplyAdd(..) => S::mul_add(-at(0), at(1), at(2)),
            Kind::Call(function, list) if list.len() == 2 => two(*function, at(0), at(1)),
            Kind::Call(function, _) => one(*function, at(0)),
            Kind::Select { .. } => S::select(self.first_mask(read[0]), at(1), at(2)),
            _ => S::from_f64(f64::NAN),
        }
    }

    fn mask(&self, kind: &Kind, read: &[First]) -> S::Mask {
        let (at, holds) =
            (|index: usize| self.first(read[index]), |index: usize| self.first_mask(read[index]));
        match kind {
            Kind::Compare(Relation::Less, ..) => S::less(at(0), at(1)),
            Kind::Compare(Relation::LessEqual, ..) => S::less_equal(at(0), at(1)),
            Kind::Compare(Relation::Equal, ..) => S::equal(at(0), at(1)),
            Kind::And(..) => S::and(holds(0), holds(1)),
            Kind::Or(..) => S::or(holds(0), holds(1)),
            _ => S::not(holds(0)),
        }
    }

    fn product(&mut self, product: &Product, state: &[S]) -> S {
        match *product {
            Product::Of(memory, a, b) => {
                let (a, b) = (self.term(a, state), self.term(b, state));
                self.two[memory](self.k, a, b)
            }
            Product::Scaled(factor, term) => {
                let factor = self.steady(factor);
                match term {
                    Term::Late(_) if factor.to_f64() == 0.0 => factor * S::ZERO,
                    _ => factor * self.term(term, state),
                }
            }
        }
    }

    fn next(&mut self, next: &Next, state: &[S]) -> S {
        match next {
            Next::Time => series::time(self.k, self.time, self.length),
            Next::State(index) => state[*index],
            Next::Add(a, b) => self.term(*a, state) + self.term(*b, state),
            Next::Subtract(a, b) => self.term(*a, state) - self.term(*b, state),
            Next::Negate(a) => -self.term(*a, state),
            Next::Product(product) => self.product(product, state),
            Next::ProductPlus(product, c) => self.product(product, state) + self.term(*c, state),
            Next::ProductMinus(product, c) => self.product(product, state) - self.term(*c, state),
            Next::MinusProduct(product, c) => {
                let product = self.product(product, state);
                self.term(*c, state) - product
            }
            Next::DivideSteady(a, below) => self.term(*a, state) / self.steady(*below),
            Next::Quotient(memory, a, b) | Next::Two(memory, a, b) => {
                let (a, b) = (self.term(*a, state), self.term(*b, state));
                self.two[*memory](self.k, a, b)
            }
            Next::Select(condition, then, otherwise) => {
                let (then, otherwise) = (self.term(*then, state), self.term(*otherwise, state));
                S::select(self.holds(*condition), then, otherwise)
            }
            Next::Element(begin, index) => self.slots[begin + index],
            Next::Abs(kept, a) => {
                let a = self.term(*a, state);
                if self.k == 0 {
                    self.conditions[*kept] = S::less(a, S::ZERO);
                }
                S::select(self.conditions[*kept], -a, a)
            }
            Next::Extreme(kept, is_max, a, b) => {
                let (a, b) = (self.term(*a, state), self.term(*b, state));
                if self.k == 0 {
                    self.conditions[*kept] =
                        if *is_max { S::less_equal(b, a) } else { S::less_equal(a, b) };
                }
                S::select(self.conditions[*kept], a, b)
            }
            Next::One(memory, a) => {
                let a = self.term(*a, state);
                self.one[*memory](self.k, a)
            }
            Next::PowerSteady(memory, base, exponent) => {
                let (base, exponent) = (self.term(*base, state), self.steady(*exponent));
                self.two[*memory](self.k, base, exponent)
            }
            Next::Power([logarithm, product, power], base, exponent) => {
                let (base, exponent) = (self.term(*base, state), self.term(*exponent, state));
                let logarithm = self.one[*logarithm](self.k, base);
                let exponent = self.two[*product](self.k, exponent, logarithm);
                self.one[*power](self.k, exponent)
            }
        }
    }

    fn solve(&mut self, matrix: &Matrix, x: &mut [S], state: &[S]) {
        match matrix {
            Matrix::Prepared(value, form) => {
                if let Some(slot) = (self.prepared.1)(*value) {
                    self.prepared.0.solve(slot, *form, x);
                }
            }
            Matrix::Terms { memory, form, entries } => {
                let entries: Vec<S> = entries.iter().map(|one| self.term(*one, state)).collect();
                let k = self.k;
                let (terms, factors) = &mut self.systems[*memory];
                let factors = factors.get_or_insert_with(|| Factors::new(*form, &entries, x.len()));
                terms.next(k, &entries, x, |x| factors.solve(x));
            }
        }
    }
}

impl<S: Scalar> Factors<S> {
    fn new(form: Form, entries: &[S], n: usize) -> Self {
        let Form::Bound { unknowns, rank } = form else {
            let mut block = entries.to_vec();
            block.resize(n * (n + 2), S::ZERO);
            factor_block(form, &mut block);
            return Self::Block(form, block);
        };
        let unknowns = unknowns as usize;
        let mut bound = BoundRows::new(n, unknowns, rank as usize);
        bound.factor(|own| {
            for row in 0..n {
                let columns = unknowns.min(if row < unknowns { row + 1 } else { n });
                let entries = entries[row * n..][..columns].iter().enumerate();
                for (column, entry) in entries.filter(|one| one.1.to_f64() != 0.0) {
                    own.put(row, column, *entry);
                }
            }
        });
        Self::Bound(Box::new(bound))
    }

    fn solve(&self, x: &mut [S]) {
        let mut room = vec![S::ZERO; x.len()];
        match self {
            Self::Block(form, block) => solve_block(*form, block, x, &mut room),
            Self::Bound(bound) => bound.solve(x, &mut room),
        }
    }
}

fn of_angle<S: Scalar>(is_even: bool) -> PairMemory<S> {
    if is_even {
        let mut memory = series::Turn::default();
        return Box::new(move |k, angle| memory.next(k, angle));
    }
    let mut memory = series::Sine::default();
    Box::new(move |k, angle| memory.next(k, angle))
}

fn of_two<S: Scalar>(kind: Two) -> TwoMemory<S> {
    /// A memory as a function.
    macro_rules! memory {
        ($name:ident) => {{
            let mut memory = series::$name::default();
            Box::new(move |k, a, b| memory.next(k, a, b))
        }};
    }
    match kind {
        Two::Product => memory!(Product),
        Two::Quotient => memory!(Quotient),
        Two::Power => memory!(Power),
        Two::Of(Function::Atan2) => memory!(Atan2),
        Two::Of(_) => memory!(Hypot),
    }
}

fn of_one<S: Scalar>(function: Function) -> OneMemory<S> {
    /// Memories as functions.
    macro_rules! memories {
        ($($name:ident),*) => {
            match function {
                $(Function::$name => {
                    let mut memory = series::$name::default();
                    Box::new(move |k, a| memory.next(k, a))
                })*
                _ => Box::new(|_, _| S::from_f64(f64::NAN)),
            }
        };
    }
    memories!(
        Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Exp, Ln, Log10, Sqrt, Erf, NormalCdf, ExpM1, Ln1p
    )
}
