//! Statements and blocks.

use std::collections::BTreeSet;

use super::{Parser, Read, slip};
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{Alternative, EnergyKind, File, Statement, StatementKind, Target, Term};
use crate::token::Span;

/// Words that begin a statement.
pub(super) const KEYWORDS: &[&str] = &[
    "dimension",
    "parameter",
    "preset",
    "let",
    "driver",
    "dependent",
    "closure",
    "coordinate",
    "state",
    "motion",
    "kinetic",
    "potential",
    "dissipation",
    "force",
    "require",
    "effect",
    "choice",
    "if",
    "for",
    "scene",
    "output",
    "measure",
    "point",
    "link",
    "part",
    "mark",
    "expect",
    "mode",
    "hold",
    "when",
];

/// A member of a list, with the documentation that stands before it in the list.
struct Member {
    documentation: Vec<String>,
    kind: StatementKind,
}

impl Member {
    fn alone(kind: StatementKind) -> Self {
        Self { documentation: Vec::new(), kind }
    }
}

/// Gives members what stands before their statement: to each, or to the first one where others have documentation of
/// their own.
fn document(members: &mut [Member], documentation: Vec<String>) {
    let mut all = members.iter();
    if all.all(|member| member.documentation.is_empty()) {
        for member in members {
            member.documentation.clone_from(&documentation);
        }
    } else if let Some(first) = members.first_mut() {
        first.documentation.splice(..0, documentation);
    }
}

impl Parser<'_> {
    /// Documentation, name, source, statements.
    pub(super) fn file(&mut self) -> Read<File> {
        let documentation = self.documentation();
        let begin = self.cursor.at;
        let name = self.name("the name of the mechanism")?;
        let mut file = File {
            documentation,
            name,
            source: None,
            statements: Vec::new(),
            unread: BTreeSet::new(),
        };
        if let Err(reported) = self.header(&mut file) {
            // Without its first `;` the rest would be read as something that it is not.
            if KEYWORDS.contains(&file.name.text.as_str()) {
                return Err(reported);
            }
            self.skip_statement(begin);
        }
        while !self.at_end() {
            self.statement(&mut file.statements);
            if self.is_close('}') {
                let _: Read<()> = self.wrong("this `}` closes nothing", Some("take it away"));
                self.advance();
            }
        }
        file.unread = std::mem::take(&mut self.unread);
        Ok(file)
    }

    fn header(&mut self, file: &mut File) -> Read<()> {
        if self.take_word("from") {
            match self.text() {
                Some(source) => file.source = Some(source),
                None => return self.expected("the source in quotation marks"),
            }
        }
        if self.take_operator(";") {
            return Ok(());
        }
        self.wrong(
            format!("found {}, expected `;` after the name of the mechanism", self.found()),
            Some("a file begins with `Name from \"source\";`"),
        )
    }

    /// `{ … }`, statements.
    fn block(&mut self) -> Read<Vec<Statement>> {
        self.open('{')?;
        let statements = self.deeper(|parser| {
            let mut statements = Vec::new();
            while !parser.is_close('}') && !parser.at_end() {
                parser.statement(&mut statements);
            }
            Ok(statements)
        })?;
        self.close('}')?;
        Ok(statements)
    }

    /// Reads one statement, which may stand for several; a wrong one is reported and skipped.
    fn statement(&mut self, list: &mut Vec<Statement>) {
        let documentation = self.documentation();
        if self.at_end() || self.is_close('}') {
            if !documentation.is_empty() {
                let span = self.before();
                self.diagnostics
                    .push(Diagnostic::warning(span, "this documentation belongs to nothing"));
            }
            return;
        }
        let start = self.here();
        let begin = self.cursor.at;
        match self.kinds() {
            Ok(mut members) => {
                let span = self.since(start);
                document(&mut members, documentation);
                let one = |member: Member| Statement {
                    documentation: member.documentation,
                    span,
                    kind: member.kind,
                };
                list.extend(members.into_iter().map(one));
            }
            Err(_) => self.skip_statement(begin),
        }
    }

    fn kinds(&mut self) -> Read<Vec<Member>> {
        let keyword = self.name("a statement")?;
        let start = keyword.span;
        let block = match keyword.text.as_str() {
            "preset" => Some(self.preset()?),
            "effect" => Some(self.effect()?),
            "choice" => Some(self.choice()?),
            "if" => Some(self.condition()?),
            "for" => Some(self.repetition()?),
            "scene" => Some(self.scene()?),
            "part" => Some(self.part()?),
            "mode" => Some(self.mode()?),
            "when" => Some(self.event()?),
            _ => None,
        };
        if let Some(kind) = block {
            return Ok(vec![Member::alone(kind)]);
        }
        let members = match keyword.text.as_str() {
            "dimension" => self.listed(|parser| parser.constant(true))?,
            "parameter" => self.listed(|parser| parser.constant(false))?,
            "let" => self.listed(Self::abbreviation)?,
            "driver" => self.listed(Self::driver)?,
            "dependent" => self.listed(Self::dependent)?,
            "closure" => vec![Member::alone(self.closure()?)],
            "point" => self.listed(Self::point)?,
            "link" => self.listed(Self::link)?,
            "coordinate" => {
                self.listed(|parser| Ok(StatementKind::Coordinate(parser.unknown(true)?)))?
            }
            "state" => self.listed(|parser| Ok(StatementKind::State(parser.unknown(false)?)))?,
            "motion" => vec![Member::alone(self.motion()?)],
            "kinetic" => vec![Member::alone(self.energy(EnergyKind::Kinetic)?)],
            "potential" => vec![Member::alone(self.energy(EnergyKind::Potential)?)],
            "dissipation" => vec![Member::alone(self.energy(EnergyKind::Dissipation)?)],
            "force" => self.listed(Self::force)?,
            "require" => vec![Member::alone(self.requirement()?)],
            "output" => self.listed(|parser| Ok(StatementKind::Output(parser.output()?)))?,
            "measure" => self.listed(Self::measure)?,
            "hold" => self.listed(|parser| Ok(StatementKind::Hold { target: parser.term()? }))?,
            "mark" => vec![Member::alone(self.mark()?)],
            "expect" => vec![Member::alone(StatementKind::Expect(self.expect()?))],
            other => return self.unknown_statement(other, start),
        };
        if !self.take_operator(";") {
            return self
                .wrong(format!("found {}, expected `;`", self.found()), self.missing_hint());
        }
        Ok(members)
    }

    /// Members of a list, each perhaps with documentation.
    fn listed(
        &mut self,
        mut one: impl FnMut(&mut Self) -> Read<StatementKind>,
    ) -> Read<Vec<Member>> {
        self.commas(|parser| {
            Ok(Member { documentation: parser.documentation(), kind: one(parser)? })
        })
    }

    /// What a reader may have meant where a statement should end.
    fn missing_hint(&self) -> Option<&'static str> {
        let operator = |text| self.is_operator(text);
        match () {
            () if self.slip().is_some() => self.slip(),
            () if self.is_any_word() || self.is_open_ahead(0, '(') => {
                Some("a product needs `*`, a statement ends with `;`")
            }
            () if operator("=") => {
                Some("an equation of motion begins with `motion`, an abbreviation with `let`")
            }
            () if self.is_close('}') || self.at_end() => Some("a statement ends with `;`"),
            () => None,
        }
    }

    fn unknown_statement<T>(&mut self, keyword: &str, start: Span) -> Read<T> {
        let hint = slip::statement(keyword, self.is_operator("=") || self.is_operator(":="));
        self.wrong_at(start, format!("`{keyword}` begins no statement"), Some(&hint))
    }

    fn motion(&mut self) -> Read<StatementKind> {
        let (label, left, right) = self.equation()?;
        Ok(StatementKind::Motion { label, left, right })
    }

    fn closure(&mut self) -> Read<StatementKind> {
        let (label, left, right) = self.equation()?;
        Ok(StatementKind::Closure { label, left, right })
    }

    /// `name: left = right`; the name may be missing.
    fn equation(&mut self) -> Read<(Option<Target>, Term, Term)> {
        let label = self.label()?;
        let left = self.term()?;
        if !self.take_operator("=") {
            return self.wrong(
                format!("found {}, expected `=`", self.found()),
                self.slip().or(Some("an equation has two sides and one `=`: `left = right`")),
            );
        }
        Ok((label, left, self.term()?))
    }

    /// `name:` or `name[k]:`, if one follows.
    pub(super) fn label(&mut self) -> Read<Option<Target>> {
        if !self.is_any_word() || !self.is_operator_ahead(1 + self.index_length(1), ":") {
            return Ok(None);
        }
        let target = self.target()?;
        self.operator(":")?;
        Ok(Some(target))
    }

    fn energy(&mut self, kind: EnergyKind) -> Read<StatementKind> {
        let named = usize::from(self.is_any_word());
        if self.is_operator_ahead(named, "=") && !self.is_operator_ahead(named, "==") {
            return self.wrong(
                format!("found {}, expected an energy", self.found()),
                Some("it has no name and no `=`: `kinetic m*dot(x)^2/2;`"),
            );
        }
        Ok(StatementKind::Energy { kind, value: self.term()? })
    }

    fn force(&mut self) -> Read<StatementKind> {
        let value = self.term()?;
        if !self.take_word("on") {
            return self.wrong(
                format!(
                    "found {}, expected `on` and the position on which the force works",
                    self.found()
                ),
                Some("write `force F on x;`"),
            );
        }
        Ok(StatementKind::Force { value, on: self.term()? })
    }

    fn requirement(&mut self) -> Read<StatementKind> {
        let condition = self.term()?;
        Ok(StatementKind::Require { condition, text: self.text() })
    }

    fn preset(&mut self) -> Read<StatementKind> {
        let name = self.name("the name of the preset")?;
        let text = self.text();
        self.open('{')?;
        let mut values = Vec::new();
        while !self.is_close('}') {
            let _ = self.documentation();
            let target = self.declared("a name")?;
            self.operator("=")?;
            values.push((target, self.term()?));
            self.operator(";")?;
        }
        self.close('}')?;
        Ok(StatementKind::Preset { name, text, values })
    }

    fn effect(&mut self) -> Read<StatementKind> {
        let name = self.name("the name of the effect")?;
        let text = self.text();
        let body = self.block()?;
        let otherwise = if self.take_word("else") { self.block()? } else { Vec::new() };
        Ok(StatementKind::Effect { name, text, body, otherwise })
    }

    fn mode(&mut self) -> Read<StatementKind> {
        Ok(StatementKind::Mode {
            name: self.name("the name of the mode")?,
            text: self.text(),
            body: self.block()?,
        })
    }

    fn choice(&mut self) -> Read<StatementKind> {
        let name = self.name("the name of the choice")?;
        let text = self.text();
        let place = self.here();
        self.open('{')?;
        let mut alternatives = Vec::new();
        while !self.is_close('}') && !self.at_end() {
            let documentation = self.documentation().join(" ");
            let name = self.name("the name of an alternative")?;
            let text = self.text().or((!documentation.is_empty()).then_some(documentation));
            alternatives.push(Alternative { name, text, body: self.alternative()? });
        }
        self.close('}')?;
        if alternatives.is_empty() {
            let report =
                Diagnostic::error(place, format!("the choice `{}` has no alternative", name.text));
            self.diagnostics.push(report);
        }
        Ok(StatementKind::Choice { name, text, alternatives })
    }

    fn alternative(&mut self) -> Read<Vec<Statement>> {
        if !self.is_open_ahead(0, '{') {
            return self.wrong(
                format!("found {}, expected `{{`", self.found()),
                Some("each alternative has a block: `choice rod { long { … } real { … } }`"),
            );
        }
        self.block()
    }

    fn condition(&mut self) -> Read<StatementKind> {
        let condition = self.term()?;
        let then = self.block()?;
        let otherwise = match () {
            () if !self.take_word("else") => Vec::new(),
            () if self.is_word("if") => {
                let start = self.here();
                self.advance();
                let kind = self.deeper(Self::condition)?;
                vec![Statement { documentation: Vec::new(), span: self.since(start), kind }]
            }
            () => self.block()?,
        };
        Ok(StatementKind::If { condition, then, otherwise })
    }

    fn repetition(&mut self) -> Read<StatementKind> {
        let index = self.name("an index")?;
        if !self.take_word("in") {
            return self.wrong(
                format!("found {}, expected `in`", self.found()),
                Some("write `for k in 1..5 { … }`"),
            );
        }
        let (from, to) = self.range()?;
        self.indices.push(index.text.clone());
        let body = self.block();
        self.indices.pop();
        Ok(StatementKind::For { index, from, to, body: body? })
    }
}
