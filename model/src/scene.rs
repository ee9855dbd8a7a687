//! Specialises a file to a scene: which statements hold once effects and choices are decided.
//!
//! This comes before names and units are looked at, because a name may mean one thing with an effect and another
//! without it. What is absent from a scene is gone before anything is derived.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{
    Alternative, BinaryOperator, File, Name, Scene, Statement, StatementKind, Term, TermKind,
    UnaryOperator, is_unread,
};
use crate::token::Span;
use crate::unroll::{bounds, statement_with_index};

/// Most statements that the repetitions of a scene may come to.
const LIMIT: usize = 20_000;

/// A choice: name, explanation, documentation, alternatives.
type Choice<'a> = (&'a Name, Option<&'a str>, &'a [String], &'a [Alternative]);

/// What a block stands in: an effect, or an alternative of a choice.
#[derive(Clone, Debug)]
enum Around {
    Effect(String),
    Alternative(String, String),
}

/// The effects and choices of a file.
#[derive(Clone, Debug, Default)]
pub struct Survey<'a> {
    /// Effects in the order of the file.
    pub effects: Vec<(&'a Name, Option<&'a str>, &'a [String])>,
    /// Choices in the order of the file.
    pub choices: Vec<Choice<'a>>,
    /// Scenes in the order of the file, with their documentation.
    pub scenes: Vec<(&'a Scene, &'a [String])>,
    /// Parts, by name.
    parts: Vec<&'a str>,
    /// For each effect and choice what it stands in.
    around: BTreeMap<&'a str, Vec<Around>>,
    /// Declared names with their places: one that is missing in a scene is declared in a block that does not hold.
    pub hidden: BTreeMap<&'a str, Span>,
    /// Words of statements that could not be read.
    pub unread: Option<&'a BTreeSet<String>>,
}

impl<'a> Survey<'a> {
    /// Looks through a file, nested blocks included.
    pub fn of(file: &'a File, diagnostics: &mut Diagnostics) -> Self {
        let mut survey = Self { unread: Some(&file.unread), ..Self::default() };
        survey.visit(&file.statements, &mut Vec::new());
        survey.report_duplicates(diagnostics);
        file.statements.iter().for_each(|statement| report_misplaced(statement, true, diagnostics));
        survey
    }

    fn visit(&mut self, statements: &'a [Statement], around: &mut Vec<Around>) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Effect { name, text, body, otherwise } => {
                    self.effects.push((name, text.as_deref(), &statement.documentation));
                    self.around.insert(&name.text, around.clone());
                    around.push(Around::Effect(name.text.clone()));
                    self.visit(body, around);
                    around.pop();
                    self.visit(otherwise, around);
                }
                StatementKind::Choice { name, text, alternatives } => {
                    self.choices.push((
                        name,
                        text.as_deref(),
                        &statement.documentation,
                        alternatives,
                    ));
                    self.around.insert(&name.text, around.clone());
                    for alternative in alternatives {
                        around.push(Around::Alternative(
                            name.text.clone(),
                            alternative.name.text.clone(),
                        ));
                        self.visit(&alternative.body, around);
                        around.pop();
                    }
                }
                StatementKind::If { then, otherwise, .. } => {
                    self.visit(then, around);
                    self.visit(otherwise, around);
                }
                StatementKind::For { body, .. } | StatementKind::Mode { body, .. } => {
                    self.visit(body, around);
                }
                StatementKind::Scene(scene) => self.scenes.push((scene, &statement.documentation)),
                StatementKind::Part { name, .. } => self.parts.push(&name.text),
                kind => {
                    self.hidden.extend(
                        kind.declared().map(|target| (target.name.text.as_str(), target.name.span)),
                    );
                }
            }
        }
    }

    /// Names of its effects and choices, in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &'a str> + use<'a, '_> {
        let effects = self.effects.iter().map(|effect| effect.0.text.as_str());
        effects.chain(self.choices.iter().map(|choice| choice.0.text.as_str()))
    }

    /// Names of the effects and choices that one stands in.
    pub fn around(&self, name: &str) -> impl Iterator<Item = &str> {
        let around = self.around.get(name).into_iter().flatten();
        around.map(|around| match around {
            Around::Effect(effect) => effect.as_str(),
            Around::Alternative(choice, _) => choice.as_str(),
        })
    }

    /// Alternatives of a choice; none of what is no choice.
    pub fn alternatives(&self, name: &str) -> impl Iterator<Item = &'a str> + use<'a> {
        let choice = self.choices.iter().find(|choice| choice.0.text == name);
        let all = choice.map_or(&[][..], |choice| choice.3);
        all.iter().map(|alternative| alternative.name.text.as_str())
    }

    /// Whether a name that is missing may have been declared by a statement that could not be read.
    pub fn is_unread(&self, name: &str) -> bool {
        self.unread.is_some_and(|words| is_unread(words, name))
    }

    /// Whether any statement could not be read.
    pub fn is_incomplete(&self) -> bool {
        self.unread.is_some_and(|words| !words.is_empty())
    }

    /// Whether a condition speaks of something that could not be read.
    pub fn speaks_of_unread(&self, condition: &Term) -> bool {
        match &condition.kind {
            TermKind::Name(name) => self.is_unread(name),
            TermKind::Member { base: inner, .. } | TermKind::Unary(_, inner) => {
                self.speaks_of_unread(inner)
            }
            TermKind::Binary(_, left, right) => {
                self.speaks_of_unread(left) || self.speaks_of_unread(right)
            }
            _ => false,
        }
    }

    /// Why a condition on effects and choices cannot be decided, where it speaks of one that the file does not have.
    pub fn explain(&self, condition: &Term) -> Option<Diagnostic> {
        let choices = || self.choices.iter().map(|choice| choice.0.text.as_str());
        match &condition.kind {
            TermKind::Unary(UnaryOperator::Not, inner) => self.explain(inner),
            TermKind::Binary(BinaryOperator::And | BinaryOperator::Or, left, right) => {
                self.explain(left).or_else(|| self.explain(right))
            }
            TermKind::Name(name) if self.effects.iter().all(|effect| effect.0.text != *name) => {
                if let Some(choice) = self.choices.iter().find(|choice| choice.0.text == *name) {
                    return Some(no_alternative_said(condition.span, choice));
                }
                let near = nearest(name, self.effects.iter().map(|effect| effect.0.text.as_str()))?;
                let report =
                    Diagnostic::error(condition.span, format!("there is no effect `{name}`"));
                Some(report.hint(format!("did you mean `{near}`?")))
            }
            TermKind::Member { base, name } => {
                let TermKind::Name(wanted) = &base.kind else {
                    return None;
                };
                match self.choices.iter().find(|choice| choice.0.text == *wanted) {
                    Some(choice) if choice.3.iter().any(|one| one.name.text == name.text) => None,
                    Some(choice) => Some(no_alternative(name, choice)),
                    None => {
                        let report =
                            Diagnostic::error(base.span, format!("there is no choice `{wanted}`"));
                        let known = choices().chain(self.parts.iter().copied());
                        Some(match nearest(wanted, known) {
                            _ if matches!(name.text.as_str(), "dot" | "ddot" | "diff") => {
                                report.hint("a time derivative is `dot(x)`, a second one `ddot(x)`")
                            }
                            _ if name.text.chars().count() == 1 => {
                                report.hint("the components of a vector are `.x`, `.y` and `.z`")
                            }
                            Some(near) => report.hint(format!("did you mean `{near}`?")),
                            None => report.hint(
                                "`choice.alternative` asks which alternative of a choice holds",
                            ),
                        })
                    }
                }
            }
            _ => None,
        }
    }

    fn report_duplicates(&self, diagnostics: &mut Diagnostics) {
        let selectable = self
            .effects
            .iter()
            .map(|effect| effect.0)
            .chain(self.choices.iter().map(|choice| choice.0));
        report_twice(selectable, "effect or choice", diagnostics);
        report_twice(self.scenes.iter().map(|(scene, _)| &scene.name), "scene", diagnostics);
        for (_, _, _, alternatives) in &self.choices {
            report_twice(
                alternatives.iter().map(|alternative| &alternative.name),
                "alternative",
                diagnostics,
            );
        }
    }
}

fn report_twice<'a>(
    names: impl Iterator<Item = &'a Name>,
    what: &str,
    diagnostics: &mut Diagnostics,
) {
    let mut first = BTreeMap::new();
    for name in names {
        if let Some(earlier) = first.insert(&name.text, name.span) {
            diagnostics.push(
                Diagnostic::error(
                    name.span,
                    format!("there is already an {what} `{}`", name.text)
                        .replace("an scene", "a scene"),
                )
                .related(earlier, "the first one")
                .hint("give one of them another name"),
            );
        }
    }
}

fn no_alternative(wanted: &Name, choice: &Choice<'_>) -> Diagnostic {
    let known: Vec<_> = choice.3.iter().map(|one| one.name.text.as_str()).collect();
    let message = format!("the choice `{}` has no alternative `{}`", choice.0.text, wanted.text);
    Diagnostic::error(wanted.span, message)
        .related(choice.0.span, "the choice")
        .hint(format!("it has {}", known.join(", ")))
}

fn no_alternative_said(span: Span, choice: &Choice<'_>) -> Diagnostic {
    let name = &choice.0.text;
    let example = choice.3.first().map_or("…", |one| one.name.text.as_str());
    Diagnostic::error(span, format!("`{name}` is a choice: say which alternative holds"))
        .related(choice.0.span, "the choice")
        .hint(format!("for example `{name}.{example}`"))
}

/// Scenes, presets and published facts belong to the whole file: inside a block they would be overlooked.
fn report_misplaced(statement: &Statement, outside: bool, diagnostics: &mut Diagnostics) {
    let what = match &statement.kind {
        StatementKind::Scene(_) => "a scene",
        StatementKind::Preset { .. } => "a preset",
        StatementKind::Expect(_) => "a published fact",
        StatementKind::Effect { body, otherwise, .. }
        | StatementKind::If { then: body, otherwise, .. } => {
            return body
                .iter()
                .chain(otherwise)
                .for_each(|one| report_misplaced(one, false, diagnostics));
        }
        StatementKind::Choice { alternatives, .. } => {
            let bodies = alternatives.iter().flat_map(|alternative| &alternative.body);
            return bodies.for_each(|one| report_misplaced(one, false, diagnostics));
        }
        StatementKind::For { body, .. } | StatementKind::Mode { body, .. } => {
            return body.iter().for_each(|one| report_misplaced(one, false, diagnostics));
        }
        _ => return,
    };
    if !outside {
        let report =
            Diagnostic::error(statement.span, format!("{what} stands outside every block"));
        diagnostics.push(report.hint("move it out of the braces"));
    }
}

/// What is switched on.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Selected {
    /// Effects that are present.
    pub effects: BTreeSet<String>,
    /// The alternative of each choice.
    pub choices: BTreeMap<String, String>,
}

impl Selected {
    /// No effect, and the first alternative of each choice.
    pub fn defaults(survey: &Survey<'_>) -> Self {
        let first = |choice: &Choice<'_>| {
            choice
                .3
                .first()
                .map(|alternative| (choice.0.text.clone(), alternative.name.text.clone()))
        };
        Self {
            effects: BTreeSet::new(),
            choices: survey.choices.iter().filter_map(first).collect(),
        }
    }

    /// Switches on whatever an effect or choice stands in.
    pub fn surround(&mut self, name: &str, survey: &Survey<'_>) {
        for around in survey.around.get(name).into_iter().flatten() {
            match around {
                Around::Effect(effect) => {
                    self.effects.insert(effect.clone());
                }
                Around::Alternative(choice, alternative) => {
                    self.choices.insert(choice.clone(), alternative.clone());
                }
            }
        }
    }

    /// Whether all holds that an effect or choice stands in.
    pub fn holds_around(&self, name: &str, survey: &Survey<'_>) -> bool {
        survey.around.get(name).into_iter().flatten().all(|around| match around {
            Around::Effect(effect) => self.effects.contains(effect),
            Around::Alternative(choice, alternative) => {
                self.choices.get(choice) == Some(alternative)
            }
        })
    }

    /// The same with an effect.
    pub fn showing(&self, effect: &str) -> Self {
        let mut other = self.clone();
        other.effects.insert(effect.to_owned());
        other
    }

    /// The same with another alternative of a choice.
    pub fn choosing(&self, choice: &str, alternative: &str) -> Self {
        let mut other = self.clone();
        other.choices.insert(choice.to_owned(), alternative.to_owned());
        other
    }

    /// What a scene selects; reports what the file does not have.
    pub fn by(scene: &Scene, survey: &Survey<'_>, diagnostics: &mut Diagnostics) -> Option<Self> {
        let mut selected = Self::defaults(survey);
        let mut good = true;
        for selection in &scene.selection {
            let name = &selection.name.text;
            let choice = survey.choices.iter().find(|choice| choice.0.text == *name);
            match (&selection.alternative, choice) {
                (Some(alternative), Some(choice)) => {
                    if choice.3.iter().any(|one| one.name.text == alternative.text) {
                        selected.choices.insert(name.clone(), alternative.text.clone());
                    } else {
                        good = false;
                        diagnostics.push(no_alternative(alternative, choice));
                    }
                }
                (None, None) if survey.effects.iter().any(|effect| effect.0.text == *name) => {
                    if !selected.effects.insert(name.clone()) {
                        diagnostics.push(Diagnostic::warning(
                            selection.name.span,
                            format!("`{name}` is named twice"),
                        ));
                    }
                }
                (None, Some(choice)) => {
                    good = false;
                    diagnostics.push(no_alternative_said(selection.name.span, choice));
                }
                _ if survey.is_unread(name) => good = false,
                (alternative, _) => {
                    good = false;
                    let what = if alternative.is_some() { "choice" } else { "effect" };
                    let known: Vec<&str> = match alternative {
                        Some(_) => {
                            survey.choices.iter().map(|choice| choice.0.text.as_str()).collect()
                        }
                        None => {
                            survey.effects.iter().map(|effect| effect.0.text.as_str()).collect()
                        }
                    };
                    let mut report = Diagnostic::error(
                        selection.name.span,
                        format!(
                            "the scene `{}` selects an unknown {what} `{name}`",
                            scene.name.text
                        ),
                    );
                    if let Some(near) = nearest(name, known.iter().copied()) {
                        report = report.hint(format!("did you mean `{near}`?"));
                    } else if known.is_empty() {
                        report = report.hint(format!("the file declares no {what}"));
                    } else {
                        report = report.hint(format!("the file declares {}", known.join(", ")));
                    }
                    diagnostics.push(report);
                }
            }
        }
        good.then_some(selected)
    }

    /// What is switched on, for messages: "with `torsion` and `crank.exact`".
    pub fn describe(&self) -> String {
        let choices =
            self.choices.iter().map(|(choice, alternative)| format!("`{choice}.{alternative}`"));
        let all: Vec<String> =
            self.effects.iter().map(|effect| format!("`{effect}`")).chain(choices).collect();
        if all.is_empty() {
            "without effects".into()
        } else {
            format!("with {}", all.join(" and "))
        }
    }

    /// Decides a condition on effects and choices; `None` when it speaks of anything else.
    pub fn decide(&self, condition: &Term, survey: &Survey<'_>) -> Option<bool> {
        match &condition.kind {
            TermKind::Name(name) if survey.effects.iter().any(|effect| effect.0.text == *name) => {
                Some(self.effects.contains(name))
            }
            TermKind::Member { base, name } => match &base.kind {
                TermKind::Name(wanted) => {
                    let choice = survey.choices.iter().find(|choice| choice.0.text == *wanted)?;
                    choice.3.iter().find(|one| one.name.text == name.text)?;
                    self.choices.get(wanted).map(|alternative| *alternative == name.text)
                }
                _ => None,
            },
            TermKind::Unary(UnaryOperator::Not, inner) => {
                self.decide(inner, survey).map(|held| !held)
            }
            TermKind::Binary(BinaryOperator::And, left, right) => {
                Some(self.decide(left, survey)? & self.decide(right, survey)?)
            }
            TermKind::Binary(BinaryOperator::Or, left, right) => {
                Some(self.decide(left, survey)? | self.decide(right, survey)?)
            }
            _ => None,
        }
    }
}

/// The statements that hold in a scene: blocks opened, repetitions written out. Scenes, presets and published facts
/// are left out.
pub fn specialise(
    file: &File,
    survey: &Survey<'_>,
    selected: &Selected,
    diagnostics: &mut Diagnostics,
) -> Vec<Statement> {
    let mut opener = Opener { survey, selected, diagnostics, flat: Vec::new(), copies: 0 };
    opener.open(&file.statements);
    opener.flat
}

/// Opens blocks and writes repetitions out.
struct Opener<'a, 'b> {
    survey: &'a Survey<'b>,
    selected: &'a Selected,
    diagnostics: &'a mut Diagnostics,
    flat: Vec<Statement>,
    /// Statements that repetitions have written out.
    copies: usize,
}

impl Opener<'_, '_> {
    fn open(&mut self, statements: &[Statement]) {
        for statement in statements {
            if self.copies > LIMIT {
                return;
            }
            match &statement.kind {
                StatementKind::Effect { name, body, otherwise, .. } => {
                    self.open(if self.selected.effects.contains(&name.text) {
                        body
                    } else {
                        otherwise
                    });
                }
                StatementKind::Choice { name, alternatives, .. } => {
                    let held = self.selected.choices.get(&name.text);
                    if let Some(alternative) =
                        alternatives.iter().find(|one| Some(&one.name.text) == held)
                    {
                        self.open(&alternative.body);
                    }
                }
                StatementKind::If { condition, then, otherwise } => {
                    match self.selected.decide(condition, self.survey) {
                        Some(held) => self.open(if held { then } else { otherwise }),
                        None => self.undecided(condition),
                    }
                }
                StatementKind::For { index, from, to, body } => {
                    if let Some((first, last)) = bounds(from, to, self.diagnostics) {
                        self.repeat(statement.span, &index.text, first..=last, body);
                    }
                }
                StatementKind::Mode { name, text, body } => {
                    let outside = std::mem::take(&mut self.flat);
                    self.open(body);
                    let body = std::mem::replace(&mut self.flat, outside);
                    self.flat.push(Statement {
                        kind: StatementKind::Mode { name: name.clone(), text: text.clone(), body },
                        ..statement.clone()
                    });
                }
                StatementKind::Scene(_)
                | StatementKind::Preset { .. }
                | StatementKind::Expect(_) => {}
                _ => self.flat.push(statement.clone()),
            }
        }
    }

    fn repeat(
        &mut self,
        span: Span,
        index: &str,
        values: std::ops::RangeInclusive<i64>,
        body: &[Statement],
    ) {
        for value in values {
            self.copies += body.len().max(1);
            if self.copies > LIMIT {
                let message =
                    format!("the repetitions up to here come to more than {LIMIT} statements");
                self.diagnostics.push_once("repetitions".into(), Diagnostic::error(span, message));
                return;
            }
            let copies: Vec<_> =
                body.iter().map(|one| statement_with_index(one, index, value)).collect();
            self.open(&copies);
            if self.copies > LIMIT {
                return;
            }
        }
    }

    fn undecided(&mut self, condition: &Term) {
        if self.survey.speaks_of_unread(condition) {
            return;
        }
        self.diagnostics.push(self.survey.explain(condition).unwrap_or_else(|| {
            Diagnostic::error(
                condition.span,
                "statements can depend on effects and choices only, and this condition speaks of something else",
            )
            .hint("to switch on a quantity write `if … { … } else { … }` inside an expression")
        }));
    }
}
