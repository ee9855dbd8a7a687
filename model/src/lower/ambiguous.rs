//! Names that may be those of units or of quantities.

use super::Lowering;
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{Term, TermKind};
use crate::unit::is_unit;

/// The number and its unit with which a term ends, if the unit is one name without brackets.
fn last_unit(term: &Term) -> Option<(f64, &str)> {
    let inner = match &term.kind {
        TermKind::Number { value, unit: Some(unit) } => {
            let bare = unit.span.first == unit.span.last && unit.span.last == term.span.last;
            return if bare {
                unit.factors.first().map(|(name, _)| (*value, name.text.as_str()))
            } else {
                None
            };
        }
        TermKind::Unary(_, inner) | TermKind::Binary(_, _, inner) => inner,
        _ => return None,
    };
    // Parentheses around the whole end it elsewhere.
    if inner.span.last == term.span.last { last_unit(inner) } else { None }
}

impl Lowering<'_> {
    /// Reports `5 N/m`, where `m` may be the quantity or the metre.
    pub(super) fn is_ambiguous(&mut self, left: &Term, right: &Term) -> bool {
        let (Some((number, unit)), TermKind::Name(name)) = (last_unit(left), &right.kind) else {
            return false;
        };
        let in_parentheses = right.span.first != right.span.last;
        // In the file of a part the quantity is written without the name of the part.
        let full = name;
        let name = full.rsplit('.').next().unwrap_or(full);
        if in_parentheses || !is_unit(name) {
            return false;
        }
        let compound = format!("{number} [{unit}/{name}]");
        let declared = self.names.table.get(full).map(|entry| entry.span);
        let local = self.locals.last().is_some_and(|scope| scope.contains_key(name));
        let place = left.span.to(right.span);
        if declared.is_none() && !local {
            let message = format!("there is no quantity `{name}` here by which to divide");
            self.error(
                Diagnostic::error(right.span, message)
                    .hint(format!("write `{compound}` for the unit {unit}/{name}")),
            );
            return true;
        }
        let report = Diagnostic::error(place, format!("`{name}` is a quantity of the file here, and a unit as well")).hint(
            format!("write `{compound}` for the unit {unit}/{name}, or `({number} {unit})/{name}` to divide by the quantity `{name}`"),
        );
        self.error(match declared {
            Some(span) => report.related(span, "the quantity"),
            None => report,
        });
        true
    }

    /// Reports `2m` in a product, where `m` is a quantity and may be meant.
    pub(super) fn hides_product(&mut self, number: &Term) -> bool {
        let TermKind::Number { value, unit: Some(unit) } = &number.kind else {
            return false;
        };
        let [(name, (1, 1))] = unit.factors.as_slice() else {
            return false;
        };
        let Some(declared) = self.names.table.get(&name.text) else {
            return false;
        };
        // What is no unit is told as such.
        if unit.span != number.span || !is_unit(&name.text) {
            return false;
        }
        let name = &name.text;
        let message = format!("`{name}` is a quantity of the file here, and a unit as well");
        let report =
            Diagnostic::error(number.span, message).related(declared.span, "the quantity").hint(
                format!("write `{value} {name}` for the unit, or `{value}*{name}` for the product"),
            );
        self.error(report);
        true
    }
}
