//! Repetition: `for` blocks and `sum` are written out, and indexed names get their whole numbers.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::syntax::print;
use crate::syntax::tree::{
    BinaryOperator, Name, Statement, StatementKind, Target, Term, TermKind, UnaryOperator, Visitor,
};

/// Most statements or terms that one repetition may write out.
const LIMIT: i64 = 10_000;

/// The whole number that an index or a bound is.
pub fn whole_number(term: &Term, diagnostics: &mut Diagnostics) -> Option<i64> {
    let value = fold(term);
    if value.is_none() {
        diagnostics.push(
            Diagnostic::error(
                term.span,
                "an index or a bound of a repetition has to be a whole number",
            )
            .hint("it may be made of whole numbers, the index of a `for` or `sum`, and `+ - *`"),
        );
    }
    value
}

fn fold(term: &Term) -> Option<i64> {
    match &term.kind {
        TermKind::Number { value, unit: None } if value.fract() == 0.0 && value.abs() < 1e9 => {
            Some(*value as i64)
        }
        TermKind::Unary(UnaryOperator::Negate, inner) => fold(inner)?.checked_neg(),
        TermKind::Binary(operator, left, right) => {
            let (left, right) = (fold(left)?, fold(right)?);
            match operator {
                BinaryOperator::Add => left.checked_add(right),
                BinaryOperator::Subtract => left.checked_sub(right),
                BinaryOperator::Multiply => left.checked_mul(right),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The bounds of a repetition, checked.
pub fn bounds(from: &Term, to: &Term, diagnostics: &mut Diagnostics) -> Option<(i64, i64)> {
    let (first, last) = (whole_number(from, diagnostics)?, whole_number(to, diagnostics)?);
    let count = last.saturating_sub(first).saturating_add(1);
    if count > LIMIT {
        let message =
            format!("the repetition runs over {count} values; at most {LIMIT} are written out");
        diagnostics.push(Diagnostic::error(from.span.to(to.span), message));
        return None;
    }
    Some((first, last))
}

/// A term with `index` replaced by a whole number.
pub fn with_index(term: &Term, index: &str, value: i64) -> Term {
    let mut copy = term.clone();
    Numbering { index, value }.term(&mut copy);
    copy
}

/// A statement with `index` replaced by a whole number.
pub fn statement_with_index(statement: &Statement, index: &str, value: i64) -> Statement {
    let mut copy = statement.clone();
    Numbering { index, value }.statement(&mut copy);
    copy
}

/// Puts a whole number in the place of an index.
struct Numbering<'a> {
    index: &'a str,
    value: i64,
}

impl Numbering<'_> {
    fn statement(&mut self, statement: &mut Statement) {
        statement.kind.visit(self);
        // An inner repetition with the same index hides the outer one.
        if matches!(&statement.kind, StatementKind::For { index, .. } if index.text == self.index) {
            return;
        }
        for body in statement.kind.blocks_mut() {
            body.iter_mut().for_each(|inner| self.statement(inner));
        }
    }

    /// An index of a name is a number itself once nothing else is in it.
    fn inner_index(&mut self, term: &mut Term) {
        self.term(term);
        if let Some(number) = fold(term) {
            term.kind = number_kind(number);
        }
    }
}

impl Visitor for Numbering<'_> {
    fn term(&mut self, term: &mut Term) {
        match &mut term.kind {
            TermKind::Name(name) if name == self.index => term.kind = number_kind(self.value),
            TermKind::Index { index, .. } => self.inner_index(index),
            TermKind::Sum { index, from, to, .. }
            | TermKind::Search { variable: index, from, to, .. }
                if index.text == self.index =>
            {
                self.term(from);
                self.term(to);
            }
            _ => term.parts_mut().into_iter().for_each(|part| self.term(part)),
        }
    }

    fn target(&mut self, target: &mut Target) {
        let index = target.index.iter_mut();
        index.for_each(|index| self.inner_index(index));
    }

    fn body(&mut self, arguments: &[Name], body: &mut Term) {
        if arguments.iter().all(|argument| argument.text != self.index) {
            self.term(body);
        }
    }
}

fn number_kind(number: i64) -> TermKind {
    TermKind::Number { value: number as f64, unit: None }
}

/// The name of a target: `x`, or `x[3]`.
pub fn target_name(target: &Target, diagnostics: &mut Diagnostics) -> Option<Name> {
    match &target.index {
        None => Some(target.name.clone()),
        Some(index) => {
            let number = whole_number(index, diagnostics)?;
            Some(Name { text: format!("{}[{number}]", target.name.text), span: target.name.span })
        }
    }
}

/// The name of an equation; what it says, if it has none.
pub fn equation_name(
    label: &Option<Target>,
    (left, right): (&Term, &Term),
    diagnostics: &mut Diagnostics,
) -> String {
    let label = label.as_ref();
    let named = label.and_then(|label| target_name(label, diagnostics));
    named
        .map_or_else(|| format!("{} = {}", print::term(left), print::term(right)), |name| name.text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::Span;

    fn term(kind: TermKind) -> Term {
        Term { span: Span::default(), kind }
    }

    fn number(value: f64) -> Term {
        term(TermKind::Number { value, unit: None })
    }

    /// `2*k + 1`
    fn twice_k_plus_one() -> Term {
        let k = term(TermKind::Name("k".into()));
        let twice = TermKind::Binary(BinaryOperator::Multiply, Box::new(number(2.0)), Box::new(k));
        term(TermKind::Binary(BinaryOperator::Add, Box::new(term(twice)), Box::new(number(1.0))))
    }

    #[test]
    fn an_index_is_computed_after_replacement() {
        let mut diagnostics = Diagnostics::default();
        let replaced = with_index(&twice_k_plus_one(), "k", 4);
        assert_eq!(whole_number(&replaced, &mut diagnostics), Some(9));
        assert!(!diagnostics.has_errors());
    }

    #[test]
    fn an_index_that_is_no_whole_number_is_an_error() {
        for bad in [twice_k_plus_one(), number(0.5), number(f64::NAN), number(1e300)] {
            let mut diagnostics = Diagnostics::default();
            assert_eq!(whole_number(&bad, &mut diagnostics), None);
            assert!(diagnostics.has_errors());
        }
    }

    #[test]
    fn a_repetition_is_bounded() {
        let mut diagnostics = Diagnostics::default();
        assert_eq!(bounds(&number(1.0), &number(1e6), &mut diagnostics), None);
        let messages = diagnostics.into_sorted();
        assert!(messages[0].message.contains("1000000 values"), "{messages:?}");
    }
}
