//! A sampled curve: `table(x; 0: 1, 1: 3; periodic)`, `table("spring.csv", x, force; smooth 2 N)`.

use super::{Parser, Read};
use crate::syntax::tree::{Name, Points, TableTerm, Term, TermKind};
use crate::token::Span;

/// How tables are written.
const FORMS: &str = "write `table(\"spring.csv\", x)` or `table(x; 0 mm: 0 N, 2 mm: 15 N)`";

impl Parser<'_> {
    /// What stands in the parentheses.
    pub(super) fn table(&mut self, start: Span) -> Read<Term> {
        let named = self.here();
        let (at, points) = match self.text() {
            Some(file) => self.sampled_in(Name { text: file, span: named })?,
            None => self.written_points()?,
        };
        let (mut is_periodic, mut error) = (false, None);
        if self.take_operator(";") {
            loop {
                if self.take_word("periodic") {
                    is_periodic = true;
                } else if self.take_word("smooth") {
                    error = Some(self.term()?);
                } else {
                    return self.wrong(
                        format!("found {}, expected `periodic` or `smooth`", self.found()),
                        Some("write `table(…; periodic)`, or `table(…; smooth 2 N)` with the standard error of the points"),
                    );
                }
                if !self.take_operator(",") {
                    break;
                }
            }
        }
        self.close(')')?;
        let kind = TermKind::Table(Box::new(TableTerm { at, points, is_periodic, error }));
        Ok(Term { span: self.since(start), kind })
    }

    /// `, x, column` behind the name of a file.
    fn sampled_in(&mut self, file: Name) -> Read<(Term, Points)> {
        if !self.take_operator(",") {
            return self.wrong(format!("found {}, expected `,`", self.found()), Some(FORMS));
        }
        let at = self.term()?;
        let mut column = None;
        if self.take_operator(",") {
            let span = self.here();
            column = Some(match self.text() {
                Some(text) => Name { text, span },
                None => self.name("the head of a column")?,
            });
        }
        Ok((at, Points::File { file, column, sheet: None }))
    }

    /// `x; 0: 1, 1: 3`
    fn written_points(&mut self) -> Read<(Term, Points)> {
        let at = self.term()?;
        if !self.take_operator(";") {
            return self.wrong(format!("found {}, expected `;`", self.found()), Some(FORMS));
        }
        let mut points = Vec::new();
        while !self.is_close(')') && !self.is_operator(";") {
            let x = self.term()?;
            if !self.take_operator(":") {
                let message = format!("found {}, expected `:`", self.found());
                return self.wrong(message, Some("a point is written `2 mm: 15 N`"));
            }
            points.push((x, self.term()?));
            if !self.take_operator(",") {
                break;
            }
        }
        Ok((at, Points::Written(points)))
    }
}
