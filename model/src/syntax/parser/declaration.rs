//! Declarations: constants, abbreviations, drivers, coordinates, states.

use super::{Parser, Read};
use crate::syntax::tree::{
    Constant, Distribution, Name, StatementKind, Target, Term, Tolerance, Unknown,
};

impl Parser<'_> {
    /// A name that is declared, inside a repetition perhaps with an index.
    pub(super) fn target(&mut self) -> Read<Target> {
        let name = self.name("a name")?;
        let index = if self.is_open_ahead(0, '[') {
            Some(Box::new(self.index()?))
        } else {
            None
        };
        Ok(Target { name, index })
    }

    /// Several after commas become several statements.
    pub(super) fn commas<T>(&mut self, mut one: impl FnMut(&mut Self) -> Read<T>) -> Read<Vec<T>> {
        let mut list = vec![one(self)?];
        while self.take_operator(",") {
            list.push(one(self)?);
        }
        Ok(list)
    }

    /// `R = 75 mm +- 0.05 mm normal in 60 mm .. 90 mm`
    pub(super) fn constant(&mut self, is_dimension: bool) -> Read<StatementKind> {
        let target = self.target()?;
        let value = if self.take_operator("=") {
            Some(self.term()?)
        } else {
            None
        };
        let (tolerance, range) = self.limits()?;
        Ok(StatementKind::Constant(Constant {
            is_dimension,
            target,
            value,
            tolerance,
            range,
        }))
    }

    /// `+- 0.05 mm uniform` and `in a .. b`, in any order.
    #[expect(
        clippy::type_complexity,
        reason = "two optional parts, named where they are used"
    )]
    fn limits(&mut self) -> Read<(Option<Tolerance>, Option<(Term, Term)>)> {
        let (mut tolerance, mut range) = (None, None);
        loop {
            if tolerance.is_none() && self.take_operator("+-") {
                let half_width = self.term()?;
                let distribution = match () {
                    () if self.take_word("uniform") => Distribution::Uniform,
                    () if self.take_word("truncated") => Distribution::Truncated,
                    () => {
                        let _ = self.take_word("normal");
                        Distribution::Normal
                    }
                };
                tolerance = Some(Tolerance {
                    half_width,
                    distribution,
                });
            } else if range.is_none() && self.take_word("in") {
                range = Some(self.range()?);
            } else {
                return Ok((tolerance, range));
            }
        }
    }

    /// `x = …` or `f(a, b) = …`
    pub(super) fn abbreviation(&mut self) -> Read<StatementKind> {
        let target = self.target()?;
        let arguments = if target.index.is_none() && self.take_open('(') {
            Some(self.arguments()?)
        } else {
            None
        };
        self.operator("=")?;
        let value = self.term()?;
        Ok(StatementKind::Let {
            target,
            arguments,
            value,
        })
    }

    /// Names of arguments, each once.
    fn arguments(&mut self) -> Read<Vec<Name>> {
        let mut list: Vec<Name> = Vec::new();
        while !self.is_close(')') {
            let name = self.name("the name of an argument")?;
            if list.iter().any(|one| one.text == name.text) {
                return self.wrong_at(
                    name.span,
                    format!("two arguments are called `{}`", name.text),
                    None,
                );
            }
            list.push(name);
            if !self.take_operator(",") {
                break;
            }
        }
        self.close(')')?;
        if list.is_empty() {
            return self.wrong_at(
                self.before(),
                "a function needs an argument",
                Some("without one it is a value: leave `()` out"),
            );
        }
        Ok(list)
    }

    /// `theta = n*time in 0 .. 2*pi`
    pub(super) fn driver(&mut self) -> Read<StatementKind> {
        let target = self.target()?;
        let value = if self.take_operator("=") {
            Some(self.term()?)
        } else {
            None
        };
        let (tolerance, range) = self.limits()?;
        Ok(StatementKind::Driver {
            target,
            value,
            range,
            tolerance,
        })
    }

    /// `phi: rad = 0, rate = 1 [rad/s]`
    pub(super) fn unknown(&mut self, has_rate: bool) -> Read<Unknown> {
        let target = self.target()?;
        if !self.take_operator(":") {
            let hint = format!("write `{}: m`", target.name.text);
            return self.wrong(
                format!("found {}, expected `:` and a unit", self.found()),
                Some(&hint),
            );
        }
        let unit = self.declared_unit()?;
        let start = if self.take_operator("=") {
            Some(self.term()?)
        } else {
            None
        };
        let follows = has_rate
            && self.is_operator(",")
            && self.is_word_ahead(1, "rate")
            && self.is_operator_ahead(2, "=");
        let start_rate = if follows {
            self.cursor.at += 3;
            Some(self.term()?)
        } else {
            None
        };
        Ok(Unknown {
            target,
            unit,
            start,
            start_rate,
        })
    }
}
