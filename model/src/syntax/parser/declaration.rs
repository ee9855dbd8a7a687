//! Declarations: constants, abbreviations, drivers, coordinates, states.

use super::{Parser, Read};
use crate::syntax::tree::{
    Binding, Constant, Dependent, Distribution, Driver, Name, StatementKind, Target, Term,
    TermKind, Tolerance, Unknown,
};

impl Parser<'_> {
    /// A name that is declared, inside a repetition perhaps with an index.
    pub(super) fn target(&mut self) -> Read<Target> {
        let name = self.name("a name")?;
        self.with_index(name)
    }

    /// A name that is declared here or in a part, perhaps with an index.
    pub(super) fn declared(&mut self, what: &str) -> Read<Target> {
        let name = self.path(what)?;
        self.with_index(name)
    }

    fn with_index(&mut self, name: Name) -> Read<Target> {
        let index = if self.is_open_ahead(0, '[') { Some(Box::new(self.index()?)) } else { None };
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
        let value = if self.take_operator("=") { Some(self.term()?) } else { None };
        let (tolerance, range) = self.limits()?;
        Ok(StatementKind::Constant(Constant { is_dimension, target, value, tolerance, range }))
    }

    /// `+- 0.05 mm uniform` and `in a .. b`, in any order.
    #[expect(clippy::type_complexity, reason = "two optional parts, named where they are used")]
    fn limits(&mut self) -> Read<(Option<Tolerance>, Option<(Term, Term)>)> {
        let (mut tolerance, mut range) = (None, None);
        loop {
            if tolerance.is_none() && self.take_operator("+-") {
                let half_width = self.term()?;
                let distribution = match () {
                    () if self.take_word("uniform") => Distribution::Uniform,
                    () if self.take_word("truncated") => Distribution::Truncated,
                    () if self.take_word("lognormal") => Distribution::Lognormal,
                    () => {
                        let _ = self.take_word("normal");
                        Distribution::Normal
                    }
                };
                tolerance = Some(Tolerance { half_width, distribution });
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
        Ok(StatementKind::Let { target, arguments, value })
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

    /// `theta = n*time in 0 .. 2*pi`, `phi ~ 90 deg in 60 deg .. 120 deg +- 0.1 deg`
    pub(super) fn driver(&mut self) -> Read<StatementKind> {
        let target = self.target()?;
        let (motion, start) = self.value_and_start()?;
        let (tolerance, range) = self.limits()?;
        Ok(StatementKind::Driver(Driver { target, motion, start, range, tolerance }))
    }

    /// `= n*time` and `~ 90 deg`, either or both in this order.
    fn value_and_start(&mut self) -> Read<(Option<Term>, Option<Term>)> {
        let value = self.after("=")?;
        Ok((value, self.after("~")?))
    }

    /// The term after an operator, if that is there.
    fn after(&mut self, operator: &str) -> Read<Option<Term>> {
        if self.take_operator(operator) {
            return Ok(Some(self.term()?));
        }
        Ok(None)
    }

    /// `phi7 ~ -70 deg`, `s: m ~ 0.1 m`
    pub(super) fn dependent(&mut self) -> Read<StatementKind> {
        let target = self.target()?;
        let unit = if self.take_operator(":") { Some(self.declared_unit()?) } else { None };
        if self.is_operator("=") {
            let hint = format!(
                "`~` gives roughly the value where the drivers start: `dependent {} ~ …;`",
                target.name.text
            );
            return self
                .wrong("a dependent coordinate is not set: closures determine it", Some(&hint));
        }
        let start = self.after("~")?;
        Ok(StatementKind::Dependent(Dependent { target, unit, start }))
    }

    /// `E = l4*dir(phi4)`
    pub(super) fn point(&mut self) -> Read<StatementKind> {
        let target = self.target()?;
        self.operator("=")?;
        let value = self.term()?;
        Ok(StatementKind::Point { target, value })
    }

    /// `D - E - F "rod"`
    pub(super) fn link(&mut self) -> Read<StatementKind> {
        let begin = self.here();
        if self.text().is_some() {
            return self.wrong_at(
                begin,
                "a link begins with a point",
                Some("its text stands behind the points: `link A - B \"rod\";`"),
            );
        }
        let mut points = vec![self.place()?];
        while self.take_operator("-") {
            points.push(self.place()?);
        }
        if points.len() < 2 {
            return self.wrong_at(
                self.since(begin),
                "a link joins at least two points",
                Some("write `link A - B;`"),
            );
        }
        let text = self.text();
        Ok(StatementKind::Link { points, text })
    }

    /// The name of a point: `A`, `A[2]`, `feed.A`.
    fn place(&mut self) -> Read<Term> {
        let begin = self.here();
        let Target { name, index } = self.declared("a point")?;
        let kind = match index {
            Some(index) => TermKind::Index { name, index },
            None => TermKind::Name(name.text),
        };
        Ok(Term { span: self.since(begin), kind })
    }

    /// `feed: SewingFeed from "sewing_feed.eqn" { phi = theta; e_v = 6 mm; }`
    pub(super) fn part(&mut self) -> Read<StatementKind> {
        let name = self.name("the name of the part")?;
        self.operator(":")?;
        let mechanism = self.name("the mechanism that the part is")?;
        let file = if self.take_word("from") {
            let place = self.here();
            match self.text() {
                Some(text) => Some(Name { text, span: place }),
                None => return self.expected("the name of a file in quotation marks"),
            }
        } else {
            None
        };
        let mut bindings = Vec::new();
        if !self.take_operator(";") {
            self.open('{')?;
            while !self.is_close('}') {
                let _ = self.documentation();
                bindings.push(self.binding()?);
            }
            self.close('}')?;
        }
        Ok(StatementKind::Part { name, mechanism, file, bindings })
    }

    /// `e_v = 6 mm +- 0.1 mm;`, `beta ~ 180 deg;`
    fn binding(&mut self) -> Read<Binding> {
        let target = self.declared("a quantity of the part")?;
        let (value, start) = self.value_and_start()?;
        let (tolerance, range) = self.limits()?;
        self.operator(";")?;
        Ok(Binding { target, value, start, tolerance, range })
    }

    /// `phi: rad = 0, rate = 1 [rad/s]`
    pub(super) fn unknown(&mut self, has_rate: bool) -> Read<Unknown> {
        let target = self.target()?;
        if !self.take_operator(":") {
            let name = &target.name.text;
            let hint = match name.as_str() {
                "dot" | "speed" | "velocity" => {
                    "the start value of the rate is called `rate`: `x: m = 0, rate = 2 [m/s]`"
                        .into()
                }
                _ => format!("each has a unit of its own: write `{name}: m`"),
            };
            return self
                .wrong(format!("found {}, expected `:` and a unit", self.found()), Some(&hint));
        }
        let unit = self.declared_unit()?;
        let start = if self.take_operator("=") { Some(self.term()?) } else { None };
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
        Ok(Unknown { target, unit: Some(unit), start, start_rate })
    }
}
