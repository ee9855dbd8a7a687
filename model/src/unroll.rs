//! Repetition: `for` blocks and `sum` are written out, and indexed names get their whole numbers.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::syntax::print;
use crate::syntax::tree::{
    BinaryOperator, Name, Statement, StatementKind, Target, Term, TermKind, UnaryOperator,
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
    let (first, last) = (
        whole_number(from, diagnostics)?,
        whole_number(to, diagnostics)?,
    );
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
    let again = |inner: &Term| Box::new(with_index(inner, index, value));
    let kind = match &term.kind {
        TermKind::Name(name) if name == index => TermKind::Number {
            value: value as f64,
            unit: None,
        },
        TermKind::Number { .. } | TermKind::Name(_) => term.kind.clone(),
        TermKind::Index { name, index: inner } => TermKind::Index {
            name: name.clone(),
            index: Box::new(index_with(inner, index, value)),
        },
        TermKind::Member { base, name } => TermKind::Member {
            base: again(base),
            name: name.clone(),
        },
        TermKind::Vector(items) => TermKind::Vector(
            items
                .iter()
                .map(|item| with_index(item, index, value))
                .collect(),
        ),
        TermKind::Unary(operator, inner) => TermKind::Unary(*operator, again(inner)),
        TermKind::Binary(operator, left, right) => {
            TermKind::Binary(*operator, again(left), again(right))
        }
        TermKind::Call { name, arguments } => TermKind::Call {
            name: name.clone(),
            arguments: arguments
                .iter()
                .map(|item| with_index(item, index, value))
                .collect(),
        },
        TermKind::If {
            condition,
            then,
            otherwise,
        } => TermKind::If {
            condition: again(condition),
            then: again(then),
            otherwise: again(otherwise),
        },
        TermKind::Bound {
            name,
            value: given,
            instead,
        } => TermKind::Bound {
            name: name.clone(),
            value: again(given),
            instead: again(instead),
        },
        // An inner repetition with the same index hides the outer one.
        TermKind::Sum {
            index: own,
            from,
            to,
            body,
        } => TermKind::Sum {
            index: own.clone(),
            from: again(from),
            to: again(to),
            body: if own.text == index {
                body.clone()
            } else {
                again(body)
            },
        },
    };
    Term {
        span: term.span,
        kind,
    }
}

/// An index with `index` replaced by a whole number: a number itself once nothing else is in it.
fn index_with(term: &Term, index: &str, value: i64) -> Term {
    let replaced = with_index(term, index, value);
    match fold(&replaced) {
        Some(number) => Term {
            span: term.span,
            kind: TermKind::Number {
                value: number as f64,
                unit: None,
            },
        },
        None => replaced,
    }
}

/// The name of a target: `x`, or `x[3]`.
pub fn target_name(target: &Target, diagnostics: &mut Diagnostics) -> Option<Name> {
    match &target.index {
        None => Some(target.name.clone()),
        Some(index) => {
            let number = whole_number(index, diagnostics)?;
            Some(Name {
                text: format!("{}[{number}]", target.name.text),
                span: target.name.span,
            })
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
    named.map_or_else(
        || format!("{} = {}", print::term(left), print::term(right)),
        |name| name.text,
    )
}

/// A statement with `index` replaced by a whole number.
pub fn statement_with_index(statement: &Statement, index: &str, value: i64) -> Statement {
    let term = |inner: &Term| with_index(inner, index, value);
    let target = |inner: &Target| Target {
        name: inner.name.clone(),
        index: inner
            .index
            .as_ref()
            .map(|number| Box::new(index_with(number, index, value))),
    };
    let list = |inner: &[Statement]| {
        inner
            .iter()
            .map(|one| statement_with_index(one, index, value))
            .collect()
    };
    let mut copy = statement.clone();
    match &mut copy.kind {
        StatementKind::Constant(constant) => {
            constant.target = target(&constant.target);
            constant.value = constant.value.as_ref().map(term);
            if let Some(tolerance) = &mut constant.tolerance {
                tolerance.half_width = term(&tolerance.half_width);
            }
            constant.range = constant
                .range
                .as_ref()
                .map(|(low, high)| (term(low), term(high)));
        }
        StatementKind::Let {
            target: name,
            arguments,
            value: body,
        } => {
            *name = target(name);
            // An argument of the same name hides the index.
            if !arguments
                .iter()
                .flatten()
                .any(|argument| argument.text == index)
            {
                *body = term(body);
            }
        }
        StatementKind::Driver(driver) => {
            driver.target = target(&driver.target);
            driver.motion = driver.motion.as_ref().map(term);
            driver.start = driver.start.as_ref().map(term);
            driver.range = driver
                .range
                .as_ref()
                .map(|(low, high)| (term(low), term(high)));
            if let Some(tolerance) = &mut driver.tolerance {
                tolerance.half_width = term(&tolerance.half_width);
            }
        }
        StatementKind::Dependent(dependent) => {
            dependent.target = target(&dependent.target);
            dependent.start = dependent.start.as_ref().map(term);
        }
        StatementKind::Point {
            target: name,
            value: position,
        } => {
            *name = target(name);
            *position = term(position);
        }
        StatementKind::Link { points, .. } => points.iter_mut().for_each(|one| *one = term(one)),
        StatementKind::Part { bindings, .. } => {
            for binding in bindings {
                binding.value = binding.value.as_ref().map(term);
                binding.start = binding.start.as_ref().map(term);
            }
        }
        StatementKind::Coordinate(unknown) | StatementKind::State(unknown) => {
            unknown.target = target(&unknown.target);
            unknown.start = unknown.start.as_ref().map(term);
            unknown.start_rate = unknown.start_rate.as_ref().map(term);
        }
        StatementKind::Closure { label, left, right }
        | StatementKind::Motion { label, left, right } => {
            *label = label.as_ref().map(target);
            (*left, *right) = (term(left), term(right));
        }
        StatementKind::Energy { value: energy, .. } => *energy = term(energy),
        StatementKind::Force { value: force, on } => (*force, *on) = (term(force), term(on)),
        StatementKind::Require { condition, .. } => *condition = term(condition),
        StatementKind::Mark { value: place, .. } => *place = term(place),
        StatementKind::Output(output) | StatementKind::Measure { what: output, .. } => {
            output.name = output.name.as_ref().map(target);
            output.value = output.value.as_ref().map(term);
        }
        StatementKind::If {
            condition,
            then,
            otherwise,
        } => {
            *condition = term(condition);
            (*then, *otherwise) = (list(then), list(otherwise));
        }
        StatementKind::For {
            index: own,
            from,
            to,
            body,
        } => {
            (*from, *to) = (term(from), term(to));
            if own.text != index {
                *body = list(body);
            }
        }
        StatementKind::Effect {
            body, otherwise, ..
        } => (*body, *otherwise) = (list(body), list(otherwise)),
        StatementKind::Choice { alternatives, .. } => {
            alternatives
                .iter_mut()
                .for_each(|alternative| alternative.body = list(&alternative.body));
        }
        StatementKind::Mode { body, .. } => *body = list(body),
        StatementKind::Hold { target } => *target = term(target),
        StatementKind::When(event) => {
            event.label = event.label.as_ref().map(target);
            event.guard = term(&event.guard);
            event.condition = event.condition.as_ref().map(term);
            for (target, value) in &mut event.resets {
                (*target, *value) = (term(target), term(value));
            }
        }
        StatementKind::Preset { .. } | StatementKind::Scene(_) | StatementKind::Expect(_) => {}
    }
    copy
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::Span;

    fn term(kind: TermKind) -> Term {
        Term {
            span: Span::default(),
            kind,
        }
    }

    fn number(value: f64) -> Term {
        term(TermKind::Number { value, unit: None })
    }

    /// `2*k + 1`
    fn twice_k_plus_one() -> Term {
        let k = term(TermKind::Name("k".into()));
        let twice = TermKind::Binary(BinaryOperator::Multiply, Box::new(number(2.0)), Box::new(k));
        term(TermKind::Binary(
            BinaryOperator::Add,
            Box::new(term(twice)),
            Box::new(number(1.0)),
        ))
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
        for bad in [
            twice_k_plus_one(),
            number(0.5),
            number(f64::NAN),
            number(1e300),
        ] {
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
        assert!(
            messages[0].message.contains("1000000 values"),
            "{messages:?}"
        );
    }
}
