//! Specialises a file to a scene: which statements hold once effects and choices are decided.
//!
//! This comes before names and units are looked at, because a name may mean one thing with an effect and another
//! without it. What is absent from a scene is gone before anything is derived.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{
    Alternative, BinaryOperator, File, Name, Scene, Statement, StatementKind, Term, TermKind,
    UnaryOperator,
};
use crate::unroll::{bounds, statement_with_index};

/// Most statements that a scene may come to.
const LIMIT: usize = 20_000;

/// A choice: name, explanation, documentation, alternatives.
type Choice<'a> = (&'a Name, Option<&'a str>, &'a [String], &'a [Alternative]);

/// The effects and choices of a file.
#[derive(Clone, Debug, Default)]
pub struct Survey<'a> {
    /// Effects in the order of the file.
    pub effects: Vec<(&'a Name, Option<&'a str>, &'a [String])>,
    /// Choices in the order of the file.
    pub choices: Vec<Choice<'a>>,
    /// Scenes in the order of the file, with their documentation.
    pub scenes: Vec<(&'a Scene, &'a [String])>,
}

impl<'a> Survey<'a> {
    /// Looks through a file, nested blocks included.
    pub fn of(file: &'a File, diagnostics: &mut Diagnostics) -> Self {
        let mut survey = Self::default();
        survey.visit(&file.statements);
        survey.report_duplicates(diagnostics);
        survey
    }

    fn visit(&mut self, statements: &'a [Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Effect {
                    name,
                    text,
                    body,
                    otherwise,
                } => {
                    self.effects
                        .push((name, text.as_deref(), &statement.documentation));
                    self.visit(body);
                    self.visit(otherwise);
                }
                StatementKind::Choice {
                    name,
                    text,
                    alternatives,
                } => {
                    self.choices.push((
                        name,
                        text.as_deref(),
                        &statement.documentation,
                        alternatives,
                    ));
                    alternatives
                        .iter()
                        .for_each(|alternative| self.visit(&alternative.body));
                }
                StatementKind::If {
                    then, otherwise, ..
                } => {
                    self.visit(then);
                    self.visit(otherwise);
                }
                StatementKind::For { body, .. } => self.visit(body),
                StatementKind::Scene(scene) => self.scenes.push((scene, &statement.documentation)),
                _ => {}
            }
        }
    }

    fn report_duplicates(&self, diagnostics: &mut Diagnostics) {
        let selectable = self
            .effects
            .iter()
            .map(|effect| effect.0)
            .chain(self.choices.iter().map(|choice| choice.0));
        report_twice(selectable, "effect or choice", diagnostics);
        report_twice(
            self.scenes.iter().map(|(scene, _)| &scene.name),
            "scene",
            diagnostics,
        );
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

    /// What a scene selects; reports what the file does not have.
    pub fn by(scene: &Scene, survey: &Survey<'_>, diagnostics: &mut Diagnostics) -> Option<Self> {
        let mut selected = Self::defaults(survey);
        let mut good = true;
        for selection in &scene.selection {
            let name = &selection.name.text;
            let choice = survey.choices.iter().find(|choice| choice.0.text == *name);
            match (&selection.alternative, choice) {
                (Some(alternative), Some(choice)) => {
                    let names = || choice.3.iter().map(|one| one.name.text.as_str());
                    if names().any(|one| one == alternative.text) {
                        selected
                            .choices
                            .insert(name.clone(), alternative.text.clone());
                    } else {
                        good = false;
                        let message = format!(
                            "the choice `{name}` has no alternative `{}`",
                            alternative.text
                        );
                        let known: Vec<_> = names().collect();
                        diagnostics.push(
                            Diagnostic::error(alternative.span, message)
                                .related(choice.0.span, "the choice")
                                .hint(format!("it has {}", known.join(", "))),
                        );
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
                    let message = format!("`{name}` is a choice: say which alternative holds");
                    let example = choice.3.first().map_or("…", |one| one.name.text.as_str());
                    diagnostics.push(
                        Diagnostic::error(selection.name.span, message)
                            .related(choice.0.span, "the choice")
                            .hint(format!("for example `{name}.{example}`")),
                    );
                }
                (alternative, _) => {
                    good = false;
                    let what = if alternative.is_some() {
                        "choice"
                    } else {
                        "effect"
                    };
                    let known: Vec<&str> = match alternative {
                        Some(_) => survey
                            .choices
                            .iter()
                            .map(|choice| choice.0.text.as_str())
                            .collect(),
                        None => survey
                            .effects
                            .iter()
                            .map(|effect| effect.0.text.as_str())
                            .collect(),
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

    /// Decides a condition on effects and choices; `None` when it speaks of anything else.
    pub fn decide(&self, condition: &Term, survey: &Survey<'_>) -> Option<bool> {
        match &condition.kind {
            TermKind::Name(name) if survey.effects.iter().any(|effect| effect.0.text == *name) => {
                Some(self.effects.contains(name))
            }
            TermKind::Member { base, name } => match &base.kind {
                TermKind::Name(choice) => self
                    .choices
                    .get(choice)
                    .map(|alternative| *alternative == name.text),
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
    let mut flat = Vec::new();
    open(&file.statements, survey, selected, &mut flat, diagnostics);
    flat
}

fn open(
    statements: &[Statement],
    survey: &Survey<'_>,
    selected: &Selected,
    flat: &mut Vec<Statement>,
    diagnostics: &mut Diagnostics,
) {
    for statement in statements {
        if flat.len() > LIMIT {
            diagnostics.push(Diagnostic::error(
                statement.span,
                format!("the repetitions up to here come to more than {LIMIT} statements"),
            ));
            return;
        }
        match &statement.kind {
            StatementKind::Effect { name, body, otherwise, .. } => {
                let branch = if selected.effects.contains(&name.text) { body } else { otherwise };
                open(branch, survey, selected, flat, diagnostics);
            }
            StatementKind::Choice { name, alternatives, .. } => {
                let held = selected.choices.get(&name.text);
                if let Some(alternative) = alternatives.iter().find(|one| Some(&one.name.text) == held) {
                    open(&alternative.body, survey, selected, flat, diagnostics);
                }
            }
            StatementKind::If { condition, then, otherwise } => match selected.decide(condition, survey) {
                Some(held) => open(if held { then } else { otherwise }, survey, selected, flat, diagnostics),
                None => diagnostics.push(
                    Diagnostic::error(
                        condition.span,
                        "statements can depend on effects and choices only, and this condition speaks of something else",
                    )
                    .hint("to switch on a quantity write `if … { … } else { … }` inside an expression"),
                ),
            },
            StatementKind::For { index, from, to, body } => {
                if let Some((first, last)) = bounds(from, to, diagnostics) {
                    for value in first..=last {
                        let copies: Vec<_> =
                            body.iter().map(|one| statement_with_index(one, &index.text, value)).collect();
                        open(&copies, survey, selected, flat, diagnostics);
                        if flat.len() > LIMIT {
                            break;
                        }
                    }
                }
            }
            StatementKind::Scene(_) | StatementKind::Preset { .. } | StatementKind::Expect(_) => {}
            _ => flat.push(statement.clone()),
        }
    }
}
