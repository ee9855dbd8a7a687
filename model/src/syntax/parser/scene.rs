//! Scenes, outputs, published facts.

use super::cursor::within;
use super::{Parser, Read};
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{
    Among, Expect, ExpectAt, Name, Output, Scene, SceneItem, Selection, StatementKind, SweepRange,
    Target, Term, TermKind, Varied,
};

impl Parser<'_> {
    /// `elastic "text" = torsion + crank.exact { … }`
    pub(super) fn scene(&mut self) -> Read<StatementKind> {
        let name = self.name("the name of the scene")?;
        let text = self.text();
        let mut selection = Vec::new();
        if self.take_operator("=") {
            loop {
                selection.push(self.selection()?);
                if !self.take_operator("+") {
                    break;
                }
            }
        }
        let mut items = Vec::new();
        if !self.take_operator(";") {
            if !self.take_open('{') {
                return self.expected("`+`, `{` or `;`");
            }
            while !self.is_close('}') && !self.at_end() {
                let begin = self.cursor.at;
                match self.item() {
                    Ok(list) => items.extend(list),
                    Err(_) => self.skip_statement(begin),
                }
            }
            self.close('}')?;
        }
        Ok(StatementKind::Scene(Scene { name, text, selection, items }))
    }

    pub(super) fn selection(&mut self) -> Read<Selection> {
        let mut name = self.name("an effect or a choice")?;
        let mut alternative: Option<Name> = None;
        while self.take_operator(".") {
            // What stands before the last `.` names the choice, perhaps that of a part.
            if let Some(part) = &alternative {
                name = within(name, part);
            }
            alternative = Some(self.name("an alternative")?);
        }
        Ok(Selection { name, alternative })
    }

    pub(super) fn item(&mut self) -> Read<Vec<SceneItem>> {
        let _ = self.documentation();
        let keyword = self.name(
            "what the scene does: `periodic`, `run`, `rest`, `sweep`, `hold`, `preset`, `output`, `start`, `vary`, `solve`, `require`, `prefer` or `minimise`",
        )?;
        let items = match keyword.text.as_str() {
            "periodic" => {
                vec![SceneItem::Periodic { period: self.period()? }]
            }
            "run" => {
                if !self.is_any_word() {
                    return self.wrong(
                        format!("found {}, expected `time`", self.found()),
                        Some("write `run time 0 s .. 1 s;`"),
                    );
                }
                let variable = self.name("`time`")?;
                let (from, to) = self.range()?;
                vec![SceneItem::Run { variable, from, to }]
            }
            "rest" => vec![SceneItem::Rest { place: keyword.span }],
            "preset" => vec![SceneItem::Preset { name: self.name("the name of a preset")? }],
            "output" => self.commas(|parser| Ok(SceneItem::Output(parser.output()?)))?,
            "start" if self.is_any_word() && self.is_operator_ahead(1, ";") => {
                vec![SceneItem::StartIn { mode: self.name("a mode")? }]
            }
            "start" => {
                let values = self.commas(|parser| {
                    let target = parser.term()?;
                    parser.operator("=")?;
                    Ok((target, parser.term()?))
                })?;
                vec![SceneItem::Start { values }]
            }
            "sweep" => {
                let drivers = self.commas(Self::sweep_range)?;
                vec![SceneItem::Sweep { drivers }]
            }
            "vary" => {
                let constants = self.commas(Self::varied)?;
                vec![SceneItem::Vary { constants }]
            }
            "solve" => {
                if !self.take_word("for") {
                    return self.wrong(
                        format!("found {}, expected `for`", self.found()),
                        Some("write `solve for x, y: left = right;`"),
                    );
                }
                let constants = self.commas(Self::varied)?;
                self.operator(":")?;
                let left = self.term()?;
                self.operator("=")?;
                vec![SceneItem::Solve { constants, left, right: self.term()? }]
            }
            "require" => {
                vec![SceneItem::Require { condition: self.term()?, text: self.text() }]
            }
            "prefer" => {
                let condition = self.term()?;
                let weight = if self.take_word("weight") { Some(self.term()?) } else { None };
                vec![SceneItem::Prefer { condition, weight, text: self.text() }]
            }
            "minimise" => vec![SceneItem::Minimise { what: self.output()? }],
            "hold" => {
                let drivers = self.commas(|parser| parser.path("a driver"))?;
                vec![SceneItem::Hold { drivers }]
            }
            "measure" => {
                return self.wrong_at(
                    keyword.span,
                    "a measure stands outside the scenes",
                    Some("move it out of the braces: every scene that runs has it"),
                );
            }
            other => {
                let message = format!("`{other}` is nothing that a scene does");
                return self.wrong_at(keyword.span, message, Some("a scene has `periodic over …`, `run time a .. b`, `rest`, `sweep`, `hold`, `preset`, `output`, `start`, `vary`, `solve`, `require`, `prefer` or `minimise`"));
            }
        };
        self.operator(";")?;
        Ok(items)
    }

    /// `over 2*pi/n`, or nothing
    fn period(&mut self) -> Read<Option<Term>> {
        if self.take_word("over") {
            return Ok(Some(self.term()?));
        }
        if self.is_operator(";") {
            return Ok(None);
        }
        self.wrong(
            format!("found {}, expected `over`", self.found()),
            Some("write `periodic over 2*pi/n;`, or `periodic;` where nothing states the period but the motion"),
        )
    }

    /// `phi4` or `phi4 60 deg .. 120 deg`
    fn sweep_range(&mut self) -> Read<SweepRange> {
        let driver = self.path("a driver")?;
        let ends = self.is_operator(",") || self.is_operator(";");
        let range = if ends { None } else { Some(self.range()?) };
        Ok(SweepRange { driver, range })
    }

    /// `L1`, `theta[2]`, `L1 in 3 mm .. 20 mm` or `mode in {-1, 1}`
    fn varied(&mut self) -> Read<Varied> {
        let constant = self.declared("a dimension or parameter")?;
        let among = if !self.take_word("in") {
            Among::Permitted
        } else if self.take_open('{') {
            let values = self.commas(Self::term)?;
            self.close('}')?;
            Among::Values(values)
        } else {
            let (from, to) = self.range()?;
            Among::Range(from, to)
        };
        Ok(Varied { constant, among })
    }

    /// `x`, `F1 [kN]`, `F1 = … [kN]`, `dot(x) [mm/s]`
    pub(super) fn output(&mut self) -> Read<Output> {
        let start = self.here();
        self.in_output = true;
        let read = self.output_value();
        self.in_output = false;
        let (name, value) = read?;
        let unit = if self.is_open_ahead(0, '[') { Some(self.bracketed_unit()?) } else { None };
        if let (None, Some(TermKind::Number { .. })) = (&name, value.as_ref().map(|one| &one.kind))
        {
            return self.wrong_at(
                self.since(start),
                "a number is reported here",
                Some("a decimal number is written with a point, `0.5`; what is reported of a number has a name, `n = 5`"),
            );
        }
        Ok(Output { name, value, unit, span: self.since(start) })
    }

    /// `F_max = peak(F) [kN] "largest force"`
    pub(super) fn measure(&mut self) -> Read<StatementKind> {
        let what = self.output()?;
        if what.name.is_none() || what.value.is_none() {
            return self.wrong_at(
                what.span,
                "a measure has a name and a value",
                Some("write `measure F_max = peak(F);`"),
            );
        }
        let text = self.text();
        Ok(StatementKind::Measure { what, text })
    }

    fn output_value(&mut self) -> Read<(Option<Target>, Option<Term>)> {
        let term = self.term()?;
        let target = match &term.kind {
            TermKind::Name(text) => {
                Some(Target { name: Name { text: text.clone(), span: term.span }, index: None })
            }
            TermKind::Index { name, index } => {
                Some(Target { name: name.clone(), index: Some(index.clone()) })
            }
            _ => None,
        };
        if !self.take_operator("=") {
            return Ok(if target.is_some() { (target, None) } else { (None, Some(term)) });
        }
        match target {
            Some(target) if !target.name.text.contains('.') => {
                Ok((Some(target), Some(self.term()?)))
            }
            _ => self.wrong_at(term.span, "a name is expected before `=`", None),
        }
    }

    /// `"beat-up" at theta = 180 deg`
    pub(super) fn mark(&mut self) -> Read<StatementKind> {
        let Some(text) = self.text() else {
            return self
                .expected("the text of the mark, as in `mark \"beat-up\" at theta = 180 deg;`");
        };
        if !self.take_word("at") {
            return self.expected("`at`");
        }
        let variable = self.path("a driver or `time`")?;
        self.operator("=")?;
        Ok(StatementKind::Mark { text, variable, value: self.term()? })
    }

    /// `scene S preset P at theta = 110 deg: x = 1 mm +- 0.1 mm "remark"`
    pub(super) fn expect(&mut self) -> Read<Expect> {
        let mut expect_scene = None;
        let mut preset = None;
        while self.is_word("scene") || self.is_word("preset") {
            let is_scene = self.take_word("scene");
            if !is_scene {
                self.advance();
            }
            let name = self.name("a name")?;
            *(if is_scene { &mut expect_scene } else { &mut preset }) = Some(name);
        }
        if !self.take_word("at") {
            return self.wrong(
                format!("found {}, expected `at`", self.found()),
                Some("a fact holds somewhere: `expect at theta = 110 deg: x = 1 mm +- 0.1 mm;` or `expect at maximum: …`"),
            );
        }
        let at = self.expect_at()?;
        if !self.take_operator(":") {
            return self.wrong(
                format!("found {}, expected `:`", self.found()),
                Some("a colon stands between where and what: `expect at time = 1 s: x = …`"),
            );
        }
        let quantity = self.term()?;
        if !self.take_operator("=") {
            return self.wrong(
                format!("found {}, expected `=`", self.found()),
                Some("a fact has one `=`: `x = 1 mm +- 0.1 mm`"),
            );
        }
        let value = self.term()?;
        if !self.take_operator("+-") {
            let report = Diagnostic::error(
                self.here(),
                format!("found {}, expected `+-` and a tolerance", self.found()),
            )
            .hint("how exactly must the computed value agree with the published one?");
            self.diagnostics.push(report);
            return Err(super::Reported);
        }
        let tolerance = self.term()?;
        Ok(Expect {
            scene: expect_scene,
            preset,
            at,
            quantity,
            value,
            tolerance,
            remark: self.text(),
        })
    }

    /// Where a published fact holds: `theta = 110 deg, phi = 0`, or `maximum`.
    fn expect_at(&mut self) -> Read<ExpectAt> {
        let place = self.path("a driver, `time`, `maximum`, `minimum` or `amplitude`")?;
        if !self.take_operator("=") {
            return Ok(ExpectAt::Extreme(place));
        }
        let mut places = vec![(place, self.term()?)];
        while self.take_operator(",") {
            let place = self.path("a driver")?;
            self.operator("=")?;
            places.push((place, self.term()?));
        }
        Ok(ExpectAt::Value { places })
    }
}
