//! Conditions, and branches that hang on them.

use super::{Lowering, Typed};
use crate::diagnostic::Diagnostic;
use crate::homogeneity::{agree, disagreement};
use crate::program::Relation;
use crate::syntax::tree::{BinaryOperator, Term};
use crate::token::Span;

impl Lowering<'_> {
    pub(super) fn logic(
        &mut self,
        operator: BinaryOperator,
        a: Typed,
        a_span: Span,
        b: Typed,
        b_span: Span,
    ) -> Typed {
        let and = operator == BinaryOperator::And;
        match (a, b) {
            (Typed::Decided(x), Typed::Decided(y)) => {
                Typed::Decided(if and { x && y } else { x || y })
            }
            (Typed::Decided(x), other @ Typed::Condition(_))
            | (other @ Typed::Condition(_), Typed::Decided(x)) => {
                if x == and {
                    other
                } else {
                    Typed::Decided(x)
                }
            }
            (Typed::Condition(x), Typed::Condition(y)) => {
                Typed::Condition(if and { self.graph.and(x, y) } else { self.graph.or(x, y) })
            }
            (a, b) => {
                let word = if and { "&&" } else { "||" };
                let message = format!(
                    "`{word}` joins conditions, and these are {} and {}",
                    a.describe(),
                    b.describe()
                );
                self.error(Diagnostic::error(a_span.to(b_span), message))
            }
        }
    }

    pub(super) fn compare(
        &mut self,
        operator: BinaryOperator,
        left: (Span, Typed),
        right: (Span, Typed),
    ) -> Typed {
        let (Some((x, p)), Some((y, q))) = (left.1.as_number(), right.1.as_number()) else {
            let message = format!("this compares {} and {}", left.1.describe(), right.1.describe());
            return self.error(Diagnostic::error(left.0.to(right.0), message));
        };
        if agree(p, q).is_none() {
            return self.error(disagreement("this compares", (left.0, p), (right.0, q)));
        }
        let value = match operator {
            BinaryOperator::Less => self.graph.compare(Relation::Less, x, y),
            BinaryOperator::LessEqual => self.graph.compare(Relation::LessEqual, x, y),
            BinaryOperator::Greater => self.graph.compare(Relation::Less, y, x),
            BinaryOperator::GreaterEqual => self.graph.compare(Relation::LessEqual, y, x),
            BinaryOperator::Equal => self.graph.compare(Relation::Equal, x, y),
            _ => {
                let equal = self.graph.compare(Relation::Equal, x, y);
                self.graph.not(equal)
            }
        };
        Typed::Condition(value)
    }

    pub(super) fn branch(&mut self, condition: &Term, then: &Term, otherwise: &Term) -> Typed {
        let condition = match self.term(condition) {
            Typed::Decided(held) => return self.term(if held { then } else { otherwise }),
            Typed::Condition(value) => value,
            Typed::Wrong => return Typed::Wrong,
            other => {
                let message = format!("`if` needs a condition, and this is {}", other.describe());
                return self.error(
                    Diagnostic::error(condition.span, message)
                        .hint("compare two quantities, as in `a < b`"),
                );
            }
        };
        match (self.term(then), self.term(otherwise)) {
            (Typed::Wrong, _) | (_, Typed::Wrong) => Typed::Wrong,
            (Typed::Quantity(x), Typed::Quantity(y)) if x.is_like(&y) => {
                let Some(kind) = agree(x.kind, y.kind) else {
                    let (left, right) = ((then.span, x.kind), (otherwise.span, y.kind));
                    return self.error(disagreement("the two branches give", left, right));
                };
                let select = |x, y| self.graph.select(condition, x, y);
                x.with(&y, kind, select).into()
            }
            (a, b) => {
                let message =
                    format!("the two branches give {} and {}", a.describe(), b.describe());
                self.error(Diagnostic::error(then.span.to(otherwise.span), message))
            }
        }
    }
}
