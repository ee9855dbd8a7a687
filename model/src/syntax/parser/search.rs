//! What is found of a formula over a range: `integral(f, x, a .. b)`, `solve(x in a .. b, left = right)`.

use super::{Parser, Read};
use crate::syntax::tree::{BinaryOperator, Name, Term, TermKind};
use crate::syntax::words::SEARCHES;
use crate::token::Span;

impl Parser<'_> {
    /// Arguments between commas, or a formula, its variable and the range of that, up to the closing parenthesis.
    pub(super) fn call_arguments(&mut self, name: &Name) -> Read<TermKind> {
        let mut arguments = Vec::new();
        while !self.is_close(')') {
            let start = self.here();
            let argument = self.term()?;
            if self.is_operator("..") {
                self.at_range(name, start, &arguments)?;
                let to = Box::new(self.far_end()?);
                let span = arguments.last().map_or(start, |one: &Term| one.span);
                let variable = match arguments.pop().map(|one| one.kind) {
                    Some(TermKind::Name(text)) => Name { text, span },
                    _ => return self.wrong_at(span, "a range needs a variable", None),
                };
                let Some(body) = arguments.pop().map(Box::new) else {
                    return self.wrong_at(span, "a range needs a formula", None);
                };
                self.close(')')?;
                let from = Box::new(argument);
                return Ok(TermKind::Search { name: name.clone(), variable, from, to, body });
            }
            arguments.push(argument);
            if !self.take_operator(",") {
                break;
            }
        }
        self.close(')')?;
        Ok(TermKind::Call { name: name.clone(), arguments })
    }

    /// Whether a range stands where one may.
    fn at_range(&mut self, name: &Name, start: Span, before: &[Term]) -> Read<()> {
        let is_search = SEARCHES.contains(&name.text.as_str());
        let is_variable = matches!(before, [_, Term { kind: TermKind::Name(_), .. }]);
        if is_search && is_variable {
            return Ok(());
        }
        let name = if is_search { name.text.as_str() } else { "integral" };
        let message = "a range stands behind a formula and its variable";
        let hint = match name {
            "solve" => "write `solve(x in a .. b, left = right)`".into(),
            _ => format!("write `{name}(f, x, a .. b)`"),
        };
        self.wrong_at(start, message, Some(&hint))
    }

    /// `.. b`
    pub(super) fn far_end(&mut self) -> Read<Term> {
        self.operator("..")?;
        if self.is_operator("=") {
            return self.wrong("a range includes both its ends", Some("write `a .. b`"));
        }
        self.term()
    }

    /// `x in a .. b, left = right)`
    pub(super) fn equation_to_solve(&mut self, name: Name) -> Read<Term> {
        let start = name.span;
        let variable = self.name("a variable")?;
        self.advance();
        let (from, to) = self.range()?;
        self.operator(",")?;
        let left = self.term()?;
        if !self.take_operator("=") {
            return self.wrong(
                format!("found {}, expected `=`", self.found()),
                Some("write `solve(x in a .. b, left = right)`"),
            );
        }
        let right = self.term()?;
        let span = left.span.to(right.span);
        let difference = TermKind::Binary(BinaryOperator::Subtract, left.into(), right.into());
        let body = Box::new(Term { span, kind: difference });
        self.close(')')?;
        let (from, to) = (Box::new(from), Box::new(to));
        let kind = TermKind::Search { name, variable, from, to, body };
        Ok(Term { span: self.since(start), kind })
    }
}
