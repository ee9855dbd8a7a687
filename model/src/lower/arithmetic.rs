//! Operators: sums, products, powers.

use super::{Kind, Lowering, Quantity, Typed};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, describe, disagreement, over, power, times};
use crate::syntax::tree::{BinaryOperator, Term, UnaryOperator};
use crate::token::Span;

impl Lowering<'_> {
    pub(super) fn unary(&mut self, operator: UnaryOperator, inner: &Term) -> Typed {
        match (operator, self.term(inner)) {
            (_, Typed::Wrong) => Typed::Wrong,
            (UnaryOperator::Negate, typed) => self.negate(typed, inner.span),
            (UnaryOperator::Not, Typed::Decided(held)) => Typed::Decided(!held),
            (UnaryOperator::Not, Typed::Condition(value)) => {
                Typed::Condition(self.graph.not(value))
            }
            (UnaryOperator::Not, other) => self.error(Diagnostic::error(
                inner.span,
                format!("`!` needs a condition, and this is {}", other.describe()),
            )),
        }
    }

    pub(super) fn negate(&mut self, typed: Typed, span: Span) -> Typed {
        match typed {
            Typed::Quantity(one) => {
                let negated = one.map(one.kind, |value| self.graph.neg(value));
                negated.rated(one.rate)
            }
            Typed::Wrong => Typed::Wrong,
            other => self.error(Diagnostic::error(
                span,
                format!("`-` needs a quantity, and this is {}", other.describe()),
            )),
        }
    }

    pub(super) fn binary(&mut self, operator: BinaryOperator, left: &Term, right: &Term) -> Typed {
        if operator == BinaryOperator::Multiply
            && (self.hides_product(left) || self.hides_product(right))
        {
            return Typed::Wrong;
        }
        if operator == BinaryOperator::Divide && self.is_ambiguous(left, right) {
            return Typed::Wrong;
        }
        let (a, b) = (self.term(left), self.term(right));
        if matches!(a, Typed::Wrong) || matches!(b, Typed::Wrong) {
            return Typed::Wrong;
        }
        match operator {
            BinaryOperator::Add => self.add(a, left.span, b, right.span),
            BinaryOperator::Subtract => {
                let negated = self.negate(b, right.span);
                self.add(a, left.span, negated, right.span)
            }
            BinaryOperator::Multiply => self.multiply(a, left.span, b, right.span),
            BinaryOperator::Divide => self.divide(a, left.span, b, right.span),
            BinaryOperator::Power => self.raise(a, left.span, b, right.span),
            BinaryOperator::And | BinaryOperator::Or => {
                self.logic(operator, a, left.span, b, right.span)
            }
            _ => self.compare(operator, (left.span, a), (right.span, b)),
        }
    }

    /// Whether a value depends on dimensions and parameters alone.
    pub(super) fn is_fixed(&self, value: Expression) -> bool {
        !self.graph.depends_on(value, |symbol| !matches!(symbol, Symbol::Parameter(_)))
    }

    fn is_rate(&self, value: Expression, rate: bool) -> bool {
        rate || self.is_fixed(value)
    }

    pub(super) fn add(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        match (a, b) {
            (Typed::Wrong, _) | (_, Typed::Wrong) => Typed::Wrong,
            (Typed::Quantity(x), Typed::Quantity(y)) if x.is_like(&y) => {
                let Some(kind) = agree(x.kind, y.kind) else {
                    let (left, right) = ((a_span, x.kind), (b_span, y.kind));
                    return self.error(disagreement("this adds or subtracts", left, right));
                };
                let rate = match (x.as_number(), y.as_number()) {
                    (Some((p, _)), Some((q, _))) => {
                        (x.rate || y.rate) && self.is_rate(p, x.rate) && self.is_rate(q, y.rate)
                    }
                    _ => x.rate && y.rate,
                };
                let sum = x.with(&y, kind, |x, y| self.graph.add(x, y));
                sum.rated(rate)
            }
            // Zero is also the zero vector.
            (Typed::Quantity(zero), Typed::Quantity(vector))
            | (Typed::Quantity(vector), Typed::Quantity(zero))
                if vector.is_vector() && !zero.is_vector() && zero.kind == Kind::Any =>
            {
                vector.into()
            }
            (a, b) => {
                let (a, b) = (a.describe(), b.describe());
                let message = format!("this adds or subtracts {a} and {b}");
                self.error(Diagnostic::error(a_span.to(b_span), message))
            }
        }
    }

    pub(super) fn multiply(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        let span = a_span.to(b_span);
        match (a, b) {
            (Typed::Quantity(x), Typed::Quantity(y)) if !(x.is_vector() && y.is_vector()) => {
                self.scaled(x, y, span)
            }
            (Typed::Matrix(rows), Typed::Quantity(vector))
                if rows.len() == vector.values().len() =>
            {
                let inner = |row: &Vec<_>| self.inner_sum(row, vector.values());
                let values: Vec<_> = rows.iter().map(inner).collect();
                Quantity::of(&values, vector.kind).into()
            }
            (Typed::Matrix(left), Typed::Matrix(right)) if left.len() == right.len() => {
                let columns: Vec<Vec<_>> = (0..right.len())
                    .map(|column| right.iter().map(|row| row[column]).collect())
                    .collect();
                let mut row = |row: &Vec<_>| {
                    let columns = columns.iter();
                    columns.map(|column| self.inner_sum(row, column)).collect()
                };
                Typed::Matrix(left.iter().map(&mut row).collect())
            }
            (a, b) => {
                let message = format!("`*` cannot multiply {} by {}", a.describe(), b.describe());
                self.error(
                    Diagnostic::error(span, message)
                        .hint("`inner(u, v)` and `cross(u, v)` multiply vectors"),
                )
            }
        }
    }

    /// The product of two numbers, or of a number and a vector in either order.
    fn scaled(&mut self, x: Quantity, y: Quantity, span: Span) -> Typed {
        let Some(kind) = times(x.kind, y.kind) else {
            return self.absurd_unit(span);
        };
        let (factor, other) = if x.is_vector() { (y, x) } else { (x, y) };
        let value = factor.values()[0];
        // Beside a vector the rate of the number counts for nothing.
        let rate = (other.rate && self.is_fixed(value))
            || (!other.is_vector() && factor.rate && self.is_fixed(other.values()[0]));
        let product = other.map(kind, |one| self.graph.mul(value, one));
        product.rated(rate)
    }

    pub(super) fn inner_sum(&mut self, left: &[Expression], right: &[Expression]) -> Expression {
        let products: Vec<_> =
            left.iter().zip(right).map(|(x, y)| self.graph.mul(*x, *y)).collect();
        self.graph.sum(&products)
    }

    fn divide(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        let Some((divisor, q)) = b.as_number() else {
            let message = format!("`/` cannot divide by {}", b.describe());
            return self.error(Diagnostic::error(b_span, message));
        };
        if self.graph.as_number(divisor) == Some(0.0) {
            return self.error(Diagnostic::error(b_span, "this divides by zero"));
        }
        let Typed::Quantity(dividend) = a else {
            let message = format!("`/` cannot divide {}", a.describe());
            return self.error(Diagnostic::error(a_span, message));
        };
        let Some(kind) = over(dividend.kind, q) else {
            return self.absurd_unit(a_span.to(b_span));
        };
        let rate = dividend.rate && self.is_fixed(divisor);
        let quotient = dividend.map(kind, |value| self.graph.div(value, divisor));
        quotient.rated(rate)
    }

    fn raise(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        let (Some((base, p)), Some((exponent, q))) = (a.as_number(), b.as_number()) else {
            let message = format!("`^` cannot raise {} to {}", a.describe(), b.describe());
            return self.error(
                Diagnostic::error(a_span.to(b_span), message)
                    .hint("the square of a vector is `inner(v, v)`"),
            );
        };
        if agree(q, Kind::NUMBER).is_none() {
            let message =
                format!("an exponent has to be a pure number, and this is {}", b.describe());
            return self.error(Diagnostic::error(b_span, message));
        }
        let kind = match self.graph.as_number(exponent) {
            Some(number) => power(p, number),
            None if agree(p, Kind::NUMBER).is_some() => Some(Kind::NUMBER),
            None => None,
        };
        let Some(kind) = kind else {
            let message = format!(
                "{} can be raised only to a fixed power with a simple fraction",
                describe(p.dimension())
            );
            return self.error(
                Diagnostic::error(a_span.to(b_span), message)
                    .hint("divide its unit out first, as in `(S/(1 mm))^0.88`"),
            );
        };
        Typed::scalar(self.graph.pow(base, exponent), kind)
    }

    fn absurd_unit(&mut self, span: Span) -> Typed {
        self.error(Diagnostic::error(
            span,
            "the unit of this has exponents that are too large to be meant",
        ))
    }
}
