//! Events.

use super::{Parser, Read};
use crate::syntax::tree::{Direction, StatementKind, Term, When};

impl Parser<'_> {
    /// `hit: x - l rises if dot(x) > 0 -> run { set dot(x) = 0; }`, and the `;` where no `}` ends it.
    pub(super) fn event(&mut self) -> Read<StatementKind> {
        let label = self.label()?;
        let guard = self.term()?;
        let direction = self.direction()?;
        let condition = match self.take_word("if") {
            true => Some(self.term()?),
            false => None,
        };
        let target = match self.take_operator("->") {
            true => Some(self.name("the mode that follows")?),
            false => None,
        };
        let mut resets = Vec::new();
        match self.take_open('{') {
            true => {
                while !self.is_close('}') && !self.at_end() {
                    resets.extend(self.resets()?);
                }
                self.close('}')?;
            }
            false if self.take_operator(";") => {}
            false => {
                return self.wrong(
                    format!("found {}, expected `->`, `{{` or `;`", self.found()),
                    Some("write `when x rises -> mode;` or `when x rises { set dot(x) = 0; }`"),
                );
            }
        }
        Ok(StatementKind::When(When { label, guard, direction, condition, target, resets }))
    }

    fn direction(&mut self) -> Read<Direction> {
        let known = [
            ("rises", Direction::Rises),
            ("falls", Direction::Falls),
            ("crosses", Direction::Crosses),
        ];
        let found = known.into_iter().find(|(word, _)| self.take_word(word));
        match found {
            Some((_, direction)) => Ok(direction),
            None => self.wrong(
                format!("found {}, expected `rises`, `falls` or `crosses`", self.found()),
                Some("an event is where a quantity passes zero: `when x - l rises -> …`"),
            ),
        }
    }

    /// `set dot(x) = 0, y = 1 m;`
    fn resets(&mut self) -> Read<Vec<(Term, Term)>> {
        if !self.take_word("set") {
            return self.wrong(
                format!("found {}, expected `set`", self.found()),
                Some("an event sets what jumps: `{ set dot(x) = 0; }`"),
            );
        }
        let resets = self.commas(|parser| {
            let target = parser.term()?;
            parser.operator("=")?;
            Ok((target, parser.term()?))
        })?;
        self.operator(";")?;
        Ok(resets)
    }
}
