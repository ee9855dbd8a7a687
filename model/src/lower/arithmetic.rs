//! Operators: sums, products, powers.

use super::{Kind, Lowering, Typed};
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
            Typed::Scalar { value, kind, rate } => Typed::Scalar {
                value: self.graph.neg(value),
                kind,
                rate,
            },
            Typed::Vector { values, kind, rate } => Typed::Vector {
                values: values.iter().map(|value| self.graph.neg(*value)).collect(),
                kind,
                rate,
            },
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
        !self
            .graph
            .depends_on(value, |symbol| !matches!(symbol, Symbol::Parameter(_)))
    }

    fn is_rate(&self, value: Expression, rate: bool) -> bool {
        rate || self.is_fixed(value)
    }

    pub(super) fn add(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        match (a, b) {
            (Typed::Wrong, _) | (_, Typed::Wrong) => Typed::Wrong,
            (
                Typed::Scalar {
                    value: x,
                    kind: p,
                    rate: r,
                },
                Typed::Scalar {
                    value: y,
                    kind: q,
                    rate: s,
                },
            ) => {
                let Some(kind) = agree(p, q) else {
                    return self.error(disagreement(
                        "this adds or subtracts",
                        (a_span, p),
                        (b_span, q),
                    ));
                };
                let rate = (r || s) && self.is_rate(x, r) && self.is_rate(y, s);
                Typed::Scalar {
                    value: self.graph.add(x, y),
                    kind,
                    rate,
                }
            }
            (
                Typed::Vector {
                    values: x,
                    kind: p,
                    rate: r,
                },
                Typed::Vector {
                    values: y,
                    kind: q,
                    rate: s,
                },
            ) if x.len() == y.len() => {
                let Some(kind) = agree(p, q) else {
                    return self.error(disagreement(
                        "this adds or subtracts",
                        (a_span, p),
                        (b_span, q),
                    ));
                };
                let values = x
                    .iter()
                    .zip(&y)
                    .map(|(x, y)| self.graph.add(*x, *y))
                    .collect();
                Typed::Vector {
                    values,
                    kind,
                    rate: r && s,
                }
            }
            // Zero is also the zero vector.
            (
                Typed::Scalar {
                    kind: Kind::Any, ..
                },
                vector @ Typed::Vector { .. },
            )
            | (
                vector @ Typed::Vector { .. },
                Typed::Scalar {
                    kind: Kind::Any, ..
                },
            ) => vector,
            (a, b) => {
                let message = format!(
                    "this adds or subtracts {} and {}",
                    a.describe(),
                    b.describe()
                );
                self.error(Diagnostic::error(a_span.to(b_span), message))
            }
        }
    }

    pub(super) fn multiply(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        match (a, b) {
            (
                Typed::Scalar {
                    value: x,
                    kind: p,
                    rate: r,
                },
                Typed::Scalar {
                    value: y,
                    kind: q,
                    rate: s,
                },
            ) => {
                let Some(kind) = times(p, q) else {
                    return self.absurd_unit(a_span.to(b_span));
                };
                let rate = (r && self.is_fixed(y)) || (s && self.is_fixed(x));
                Typed::Scalar {
                    value: self.graph.mul(x, y),
                    kind,
                    rate,
                }
            }
            (
                Typed::Scalar {
                    value: x, kind: p, ..
                },
                Typed::Vector {
                    values,
                    kind: q,
                    rate,
                },
            )
            | (
                Typed::Vector {
                    values,
                    kind: q,
                    rate,
                },
                Typed::Scalar {
                    value: x, kind: p, ..
                },
            ) => {
                let Some(kind) = times(p, q) else {
                    return self.absurd_unit(a_span.to(b_span));
                };
                let rate = rate && self.is_fixed(x);
                let values = values
                    .iter()
                    .map(|value| self.graph.mul(x, *value))
                    .collect();
                Typed::Vector { values, kind, rate }
            }
            (Typed::Matrix(rows), Typed::Vector { values, kind, .. })
                if rows.len() == values.len() =>
            {
                let values = rows
                    .iter()
                    .map(|row| self.inner_sum(row, &values))
                    .collect();
                Typed::Vector {
                    values,
                    kind,
                    rate: false,
                }
            }
            (Typed::Matrix(left), Typed::Matrix(right)) if left.len() == right.len() => {
                let columns: Vec<Vec<_>> = (0..right.len())
                    .map(|column| right.iter().map(|row| row[column]).collect())
                    .collect();
                let rows = left
                    .iter()
                    .map(|row| {
                        columns
                            .iter()
                            .map(|column| self.inner_sum(row, column))
                            .collect()
                    })
                    .collect();
                Typed::Matrix(rows)
            }
            (a, b) => {
                let message = format!("`*` cannot multiply {} by {}", a.describe(), b.describe());
                self.error(
                    Diagnostic::error(a_span.to(b_span), message)
                        .hint("`inner(u, v)` and `cross(u, v)` multiply vectors"),
                )
            }
        }
    }

    pub(super) fn inner_sum(&mut self, left: &[Expression], right: &[Expression]) -> Expression {
        let products: Vec<_> = left
            .iter()
            .zip(right)
            .map(|(x, y)| self.graph.mul(*x, *y))
            .collect();
        self.graph.sum(&products)
    }

    fn divide(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        let Typed::Scalar {
            value: divisor,
            kind: q,
            ..
        } = b
        else {
            return self.error(Diagnostic::error(
                b_span,
                format!("`/` cannot divide by {}", b.describe()),
            ));
        };
        if self.graph.as_number(divisor) == Some(0.0) {
            return self.error(Diagnostic::error(b_span, "this divides by zero"));
        }
        match a {
            Typed::Scalar {
                value,
                kind: p,
                rate,
            } => {
                let Some(kind) = over(p, q) else {
                    return self.absurd_unit(a_span.to(b_span));
                };
                let rate = rate && self.is_fixed(divisor);
                Typed::Scalar {
                    value: self.graph.div(value, divisor),
                    kind,
                    rate,
                }
            }
            Typed::Vector {
                values,
                kind: p,
                rate,
            } => {
                let Some(kind) = over(p, q) else {
                    return self.absurd_unit(a_span.to(b_span));
                };
                let rate = rate && self.is_fixed(divisor);
                Typed::Vector {
                    values: values
                        .iter()
                        .map(|value| self.graph.div(*value, divisor))
                        .collect(),
                    kind,
                    rate,
                }
            }
            other => self.error(Diagnostic::error(
                a_span,
                format!("`/` cannot divide {}", other.describe()),
            )),
        }
    }

    fn raise(&mut self, a: Typed, a_span: Span, b: Typed, b_span: Span) -> Typed {
        let (
            Typed::Scalar {
                value: base,
                kind: p,
                ..
            },
            Typed::Scalar {
                value: exponent,
                kind: q,
                ..
            },
        ) = (&a, &b)
        else {
            let message = format!("`^` cannot raise {} to {}", a.describe(), b.describe());
            return self.error(
                Diagnostic::error(a_span.to(b_span), message)
                    .hint("the square of a vector is `inner(v, v)`"),
            );
        };
        let (base, p, exponent, q) = (*base, *p, *exponent, *q);
        if agree(q, Kind::NUMBER).is_none() {
            let message = format!(
                "an exponent has to be a pure number, and this is {}",
                b.describe()
            );
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
