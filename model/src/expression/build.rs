//! Builds expressions in normal form.

use std::sync::Arc;

use assur_functions::Spline;

use super::function::{Function, Relation};
use super::graph::{Expression, Graph, Node, Real, Symbol};
use super::hash::{Map, Set};
use super::{laws, stable};

/// Sums and products with more operands are not opened into others.
const LONG: usize = 16;

/// What has been built before, so that it need not be normalised again.
#[derive(Debug, Default)]
pub struct Made {
    one: Option<Expression>,
    /// Terms without their number.
    rests: Map<Expression, Expression>,
    multiples: Map<(Real, Expression), Expression>,
    sums: Map<Box<[Expression]>, Expression>,
    products: Map<Box<[Expression]>, Expression>,
    /// Terms among which nothing cancels.
    pub(super) settled: Set<Box<[Expression]>>,
}

/// Adds what belongs to the same expression, in the order in which it stands, and sorts by expressions.
pub fn collect_like(list: &mut Vec<(Expression, f64)>) {
    list.sort_by_key(|one| one.0);
    list.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 += next.1;
        }
        same
    });
}

impl Graph {
    /// A number.
    pub fn number(&mut self, value: f64) -> Expression {
        self.intern(Node::Number(Real::new(value)))
    }

    /// 0
    pub fn zero(&mut self) -> Expression {
        self.number(0.0)
    }

    /// 1
    pub fn one(&mut self) -> Expression {
        if let Some(known) = self.made.one {
            return known;
        }
        let one = self.number(1.0);
        self.made.one = Some(one);
        one
    }

    /// Something given.
    pub fn symbol(&mut self, symbol: Symbol) -> Expression {
        self.intern(Node::Symbol(symbol))
    }

    /// Splits a term into its number and the rest: `-2*x` is −2 and `x`.
    pub fn split_coefficient(&mut self, term: Expression) -> (f64, Expression) {
        let Node::Product(factors) = self.node(term) else {
            return (1.0, term);
        };
        let Some(number) = self.as_number(factors[0]) else {
            return (1.0, term);
        };
        if let Some(rest) = self.made.rests.get(&term) {
            return (number, *rest);
        }
        let rest = factors[1..].to_vec();
        let rest = self.bare_product(rest);
        self.made.rests.insert(term, rest);
        (number, rest)
    }

    /// A product of factors that are in normal form and contain no number.
    fn bare_product(&mut self, factors: Vec<Expression>) -> Expression {
        match factors.as_slice() {
            [] => self.one(),
            [one] => *one,
            _ => self.intern(Node::Product(factors.into())),
        }
    }

    /// `coefficient * term`
    pub fn scale(&mut self, coefficient: f64, term: Expression) -> Expression {
        let key = (Real::new(coefficient), term);
        if let Some(known) = self.made.multiples.get(&key) {
            return *known;
        }
        let number = self.number(coefficient);
        let multiple = self.mul(number, term);
        self.made.multiples.insert(key, multiple);
        multiple
    }

    /// A sum; sums among the terms stay as they are.
    pub fn sum(&mut self, terms: &[Expression]) -> Expression {
        self.budget().spend(1);
        if let Some(known) = self.made.sums.get(terms) {
            return *known;
        }
        let sum = self.new_sum(terms);
        self.made.sums.insert(terms.into(), sum);
        sum
    }

    fn new_sum(&mut self, terms: &[Expression]) -> Expression {
        let mut constant = 0.0;
        let mut like: Vec<(Expression, f64)> = Vec::with_capacity(terms.len());
        for term in terms {
            match self.as_number(*term) {
                Some(value) => constant += value,
                None => {
                    let (coefficient, rest) = self.split_coefficient(*term);
                    like.push((rest, coefficient));
                }
            }
        }
        collect_like(&mut like);
        like.retain(|(_, coefficient)| *coefficient != 0.0);
        laws::pythagoras(self, &mut like, &mut constant);
        let mut list: Vec<Expression> =
            like.into_iter().map(|(rest, coefficient)| self.scale(coefficient, rest)).collect();
        if constant != 0.0 || list.is_empty() {
            list.push(self.number(constant));
        }
        list.sort_unstable();
        match list.as_slice() {
            [one] => *one,
            _ => self.intern(Node::Sum(list.into())),
        }
    }

    /// The terms of an expression where it stands in a sum: those of a sum that has no name of its own.
    fn open_terms(&mut self, term: Expression) -> Vec<Expression> {
        let (coefficient, rest) = self.split_coefficient(term);
        match self.node(rest) {
            Node::Sum(terms)
                if coefficient.abs() == 1.0
                    && terms.len() < LONG
                    && self.name_of(rest).is_none() =>
            {
                let terms = terms.to_vec();
                terms.into_iter().map(|one| self.scale(coefficient, one)).collect()
            }
            _ => vec![term],
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: Expression, b: Expression) -> Expression {
        let mut terms = self.open_terms(a);
        terms.extend(self.open_terms(b));
        self.sum(&terms)
    }

    /// `a - b`
    pub fn sub(&mut self, a: Expression, b: Expression) -> Expression {
        let negated = self.neg(b);
        self.add(a, negated)
    }

    /// `-a`
    pub fn neg(&mut self, a: Expression) -> Expression {
        self.scale(-1.0, a)
    }

    /// `a * b`
    pub fn mul(&mut self, a: Expression, b: Expression) -> Expression {
        self.product(&[a, b])
    }

    /// A product; products among the factors are opened.
    pub fn product(&mut self, factors: &[Expression]) -> Expression {
        self.budget().spend(1);
        if let Some(known) = self.made.products.get(factors) {
            return *known;
        }
        let product = self.new_product(factors);
        self.made.products.insert(factors.into(), product);
        product
    }

    fn new_product(&mut self, factors: &[Expression]) -> Expression {
        let mut coefficient = 1.0;
        let mut powers = Vec::with_capacity(2 * factors.len());
        for factor in factors {
            self.gather(*factor, &mut coefficient, &mut powers);
        }
        if coefficient == 0.0 {
            return self.zero();
        }
        collect_like(&mut powers);
        // Room for the number in front.
        let mut list = Vec::with_capacity(powers.len() + 1);
        for (base, exponent) in powers {
            let power = self.powi_or(base, exponent);
            match self.node(power) {
                Node::Number(value) => coefficient *= value.get(),
                // A power of two roots, say, that has become a product.
                Node::Product(inner) => list.extend(inner.iter().copied()),
                _ => list.push(power),
            }
        }
        list.sort_unstable();
        if coefficient != 1.0 {
            if list.is_empty() {
                return self.number(coefficient);
            }
            list.insert(0, self.number(coefficient));
        }
        self.bare_product(list)
    }

    /// Takes a factor apart into its number and exponents by base; a power with a computed exponent is its own base.
    fn gather(&self, factor: Expression, number: &mut f64, powers: &mut Vec<(Expression, f64)>) {
        match self.node(factor) {
            Node::Number(value) => *number *= value.get(),
            Node::Product(inner) if inner.len() <= LONG => {
                inner.iter().for_each(|one| self.gather(*one, number, powers));
            }
            Node::Power(base, exponent) => match self.as_number(*exponent) {
                Some(exponent) => powers.push((*base, exponent)),
                None => powers.push((factor, 1.0)),
            },
            _ => powers.push((factor, 1.0)),
        }
    }

    /// `a / b`
    pub fn div(&mut self, a: Expression, b: Expression) -> Expression {
        // A quotient of numbers is rounded once.
        if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(b)) {
            return self.number(x / y);
        }
        let inverse = self.powi(b, -1);
        self.mul(a, inverse)
    }

    /// A whole power.
    pub fn powi(&mut self, base: Expression, exponent: i32) -> Expression {
        self.powi_or(base, f64::from(exponent))
    }

    fn powi_or(&mut self, base: Expression, exponent: f64) -> Expression {
        if exponent == 1.0 {
            self.one();
            return base;
        }
        let exponent = self.number(exponent);
        self.pow(base, exponent)
    }

    /// `√a`
    pub fn sqrt(&mut self, a: Expression) -> Expression {
        self.powi_or(a, 0.5)
    }

    /// A power.
    pub fn pow(&mut self, base: Expression, exponent: Expression) -> Expression {
        let Some(number) = self.as_number(exponent) else {
            return self.intern(Node::Power(base, exponent));
        };
        let whole = number.fract() == 0.0;
        match self.node(base).clone() {
            _ if number == 0.0 => return self.one(),
            _ if number == 1.0 => return base,
            Node::Number(value) => {
                let power = if whole && number.abs() < 64.0 {
                    value.get().powi(number as i32)
                } else {
                    value.get().powf(number)
                };
                if power.is_finite() {
                    return self.number(power);
                }
            }
            Node::Power(inner, outer) => match self.as_number(outer) {
                Some(outer) if whole => return self.powi_or(inner, outer * number),
                Some(outer) if outer == 2.0 && number == 0.5 => {
                    return self.call(Function::Abs, &[inner]);
                }
                _ => {}
            },
            Node::Product(factors) if whole => {
                let powers: Vec<_> =
                    factors.iter().map(|factor| self.powi_or(*factor, number)).collect();
                return self.product(&powers);
            }
            _ => {}
        }
        self.intern(Node::Power(base, exponent))
    }

    /// A function.
    pub fn call(&mut self, function: Function, arguments: &[Expression]) -> Expression {
        let numbers: Option<Vec<f64>> = arguments.iter().map(|one| self.as_number(*one)).collect();
        if let Some(value) =
            numbers.map(|values| function.apply(&values)).filter(|value| value.is_finite())
        {
            return self.number(value);
        }
        if function == Function::Sqrt {
            return self.sqrt(arguments[0]);
        }
        if function == Function::Power {
            return self.pow(arguments[0], arguments[1]);
        }
        match laws::function(self, function, arguments)
            .or_else(|| stable::function(self, function, arguments))
        {
            Some(simpler) => simpler,
            None => self.intern(Node::Call(function, arguments.into())),
        }
    }

    /// A value that stays as it is in whatever contains it, but for its number.
    pub fn whole(&mut self, value: Expression) -> Expression {
        let (coefficient, rest) = self.split_coefficient(value);
        let whole = match self.node(rest) {
            Node::Sum(_) | Node::Product(_) | Node::Power(..) => self.intern(Node::Whole(rest)),
            _ => rest,
        };
        self.scale(coefficient, whole)
    }

    /// A derivative of a sampled curve at a place; there is none beyond the third.
    pub fn sampled(&mut self, spline: Arc<Spline>, order: u32, at: Expression) -> Expression {
        match self.as_number(at) {
            _ if order > 3 => self.zero(),
            Some(x) if spline.table().value(x, order).is_finite() => {
                let value = spline.table().value(x, order);
                self.number(value)
            }
            _ => self.intern(Node::Table(spline, order, at)),
        }
    }

    /// A condition; between numbers it becomes `0 < 1` or `1 < 0`.
    pub fn compare(&mut self, relation: Relation, a: Expression, b: Expression) -> Expression {
        if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(b)) {
            return self.decided(relation.holds(x, y));
        }
        if a == b {
            return self.decided(relation != Relation::Less);
        }
        self.intern(Node::Compare(relation, a, b))
    }

    /// A condition that always, or never, holds.
    fn decided(&mut self, held: bool) -> Expression {
        let (zero, one) = (self.zero(), self.one());
        let (a, b) = if held { (zero, one) } else { (one, zero) };
        self.intern(Node::Compare(Relation::Less, a, b))
    }

    /// Whether a condition always, or never, holds.
    pub fn as_decided(&self, condition: Expression) -> Option<bool> {
        match self.node(condition) {
            Node::Compare(Relation::Less, a, b) => Some(self.as_number(*a)? < self.as_number(*b)?),
            _ => None,
        }
    }

    /// Both conditions.
    pub fn and(&mut self, a: Expression, b: Expression) -> Expression {
        match (self.as_decided(a), self.as_decided(b)) {
            (Some(true), _) => b,
            (_, Some(true)) => a,
            (Some(false), _) | (_, Some(false)) => self.decided(false),
            _ => self.intern(Node::And(a.min(b), a.max(b))),
        }
    }

    /// Either condition.
    pub fn or(&mut self, a: Expression, b: Expression) -> Expression {
        match (self.as_decided(a), self.as_decided(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) | (_, Some(true)) => self.decided(true),
            _ => self.intern(Node::Or(a.min(b), a.max(b))),
        }
    }

    /// Not the condition.
    pub fn not(&mut self, a: Expression) -> Expression {
        match (self.as_decided(a), self.node(a)) {
            (Some(held), _) => self.decided(!held),
            (None, Node::Not(inner)) => *inner,
            _ => self.intern(Node::Not(a)),
        }
    }

    /// `then` where the condition holds, else `otherwise`.
    pub fn select(
        &mut self,
        condition: Expression,
        then: Expression,
        otherwise: Expression,
    ) -> Expression {
        match self.as_decided(condition) {
            Some(held) => {
                if held {
                    then
                } else {
                    otherwise
                }
            }
            None if then == otherwise => then,
            None => self.intern(Node::Select(condition, then, otherwise)),
        }
    }
}
