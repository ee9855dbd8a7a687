//! Angles that are likely meant otherwise: `sin(90)`, and `sin(50 Hz*time)` without its factor of 2π.

use std::collections::BTreeSet;

use super::Lowering;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::resolve::Role;
use crate::syntax::print;
use crate::syntax::tree::{BinaryOperator, Term, TermKind};

impl Lowering<'_> {
    /// Warns of an angle, which a term came to, that is no angle in radians by the look of it.
    pub(super) fn check_angle(&mut self, term: &Term, value: Expression) {
        let turn = 2.0 * std::f64::consts::PI;
        let is_bare = term.is_made_of_numbers()
            && !mentions(term, &|part| has_unit(part) || is_name(part, "pi"));
        let number = self.graph.as_number(value).filter(|_| is_bare);
        if let Some(number) = number.filter(|number| number.abs() > turn) {
            let text = print::term(term);
            let message = format!("`{text}` are radians here, {:.1} turns", number / turn);
            let hint = match term.kind {
                TermKind::Number { .. } => {
                    format!("write `{text} deg` if degrees are meant, else `{text} rad`")
                }
                _ => "write the unit: `90 deg`, `1.5 rad`".to_string(),
            };
            self.diagnostics.push(Diagnostic::warning(term.span, message).hint(hint));
        }
        let mut seen = std::mem::take(&mut self.angles);
        let product = self.hertz(term, &mut seen);
        if product.is_none() {
            self.angles = seen;
        }
        if let Some(product) = product {
            let text = print::term(&product);
            let message = format!(
                "`{text}` counts periods, and an angle is taken of it here as if it were radians"
            );
            self.diagnostics
                .push(Diagnostic::warning(product.span, message).hint(format!(
                    "write `2*pi*{text}`, or state the frequency in rpm or [rev/s]"
                )));
        }
    }

    /// A product of a frequency in hertz and a time in an angle or in what its names stand for, without `pi` beside it.
    fn hertz(&self, term: &Term, seen: &mut BTreeSet<String>) -> Option<Term> {
        match &term.kind {
            TermKind::Unary(_, inner) => self.hertz(inner, seen),
            TermKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, left, right) => {
                self.hertz(left, seen).or_else(|| self.hertz(right, seen))
            }
            TermKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
                let mut factors = Vec::new();
                let mut divisors = Vec::new();
                split(term, &mut factors, &mut divisors);
                let all = || factors.iter().chain(&divisors);
                let turns = |part: &Term| is_name(part, "pi") || is_angle(part);
                if all().any(|factor| mentions(factor, &turns)) {
                    return None;
                }
                let timed =
                    factors.iter().any(|factor| mentions(factor, &|part| is_name(part, "time")));
                match timed && factors.iter().any(|factor| self.is_hertz(factor)) {
                    true => Some(term.clone()),
                    false => factors.iter().find_map(|factor| self.hertz(factor, seen)),
                }
            }
            TermKind::Name(name) if seen.insert(name.clone()) => {
                self.graph.budget().spend(1);
                let meaning = match &self.names.table.get(name)?.role {
                    Role::Let(value) => value,
                    Role::Driver(index) => {
                        self.names.drivers[*index as usize].what.motion.as_ref()?
                    }
                    _ => return None,
                };
                self.hertz(meaning, seen)
            }
            _ => None,
        }
    }

    /// Whether a term is a number, or a constant, that is stated in hertz.
    fn is_hertz(&self, term: &Term) -> bool {
        match &term.kind {
            TermKind::Number { unit: Some(unit), .. } => {
                matches!(unit.factors.as_slice(), [(name, (1, 1))] if name.text.ends_with("Hz"))
            }
            TermKind::Name(name) => match self.names.table.get(name).map(|entry| &entry.role) {
                Some(Role::Constant(index)) => {
                    let unit = self.unit_of(Symbol::Parameter(*index));
                    unit.is_some_and(|unit| unit.symbol.ends_with("Hz"))
                }
                _ => false,
            },
            _ => false,
        }
    }
}

/// Whether a part of a term is what is looked for.
fn mentions(term: &Term, wanted: &dyn Fn(&Term) -> bool) -> bool {
    wanted(term) || term.parts().into_iter().any(|part| mentions(part, wanted))
}

fn is_name(term: &Term, name: &str) -> bool {
    matches!(&term.kind, TermKind::Name(own) if own == name)
}

fn has_unit(term: &Term) -> bool {
    matches!(term.kind, TermKind::Number { unit: Some(_), .. })
}

/// Whether a term is a number with the unit of an angle in it, which is converted.
fn is_angle(term: &Term) -> bool {
    let TermKind::Number { unit: Some(unit), .. } = &term.kind else {
        return false;
    };
    let mut names = unit.factors.iter().map(|(name, _)| name.text.as_str());
    names.any(|name| ["rad", "deg", "rev", "rpm"].contains(&name))
}

/// The factors of a product, and what it is divided by.
fn split<'a>(term: &'a Term, factors: &mut Vec<&'a Term>, divisors: &mut Vec<&'a Term>) {
    match &term.kind {
        TermKind::Binary(BinaryOperator::Multiply, left, right) => {
            split(left, factors, divisors);
            split(right, factors, divisors);
        }
        TermKind::Binary(BinaryOperator::Divide, left, right) => {
            split(left, factors, divisors);
            divisors.push(right);
        }
        _ => factors.push(term),
    }
}
