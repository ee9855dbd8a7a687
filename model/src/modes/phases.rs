//! Which statements hold in each mode of a scene.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{Name, Scene, SceneItem, Statement, StatementKind};
use crate::token::Span;
use crate::unroll::target_name;

/// A mode with the statements that hold in it.
#[derive(Clone, Debug, Default)]
pub struct Phase {
    /// Its name; empty for a scene that has no modes.
    pub name: String,
    /// What it is.
    pub summary: String,
    /// Where it is declared.
    pub span: Span,
    /// The statements that hold: first those that hold in all modes.
    pub statements: Vec<Statement>,
    /// How many of them hold in all modes; none in a scene that has no modes.
    pub common: usize,
    /// Coordinates that only another mode has, with the name of that mode.
    pub absent: BTreeMap<String, String>,
}

/// The modes of a scene.
#[derive(Clone, Debug, Default)]
pub struct Phases {
    /// The modes, in the order of the file.
    pub all: Vec<Phase>,
    /// The one in which the motion begins.
    pub first: usize,
}

/// What the file says of one mode, in one place or several.
struct Stated<'a> {
    name: &'a Name,
    summary: String,
    body: Vec<&'a Statement>,
}

impl Phases {
    /// Sorts the statements of a scene by modes. A mode that is stated in several places, with an effect perhaps, has
    /// what is said in all of them.
    pub fn of(
        statements: Vec<Statement>,
        scene: Option<&Scene>,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let stated = stated(&statements, diagnostics);
        let first = first(&stated, scene, diagnostics);
        if stated.is_empty() {
            let only = Phase { statements, ..Phase::default() };
            return Self { all: vec![only], first };
        }
        let is_mode = |one: &&Statement| matches!(one.kind, StatementKind::Mode { .. });
        let mut common: Vec<Statement> =
            statements.iter().filter(|one| !is_mode(one)).cloned().collect();
        // Declarations of all modes stand before the rest, so that every mode counts them alike.
        let mut owners: BTreeMap<String, &str> = BTreeMap::new();
        for mode in &stated {
            for statement in mode.body.iter().filter(|one| is_declaration(one)) {
                common.push((*statement).clone());
                let unknown = match &statement.kind {
                    StatementKind::Coordinate(unknown) | StatementKind::State(unknown) => unknown,
                    _ => continue,
                };
                if let Some(name) = target_name(&unknown.target, diagnostics) {
                    owners.insert(name.text, &mode.name.text);
                }
            }
        }
        let phase = |mode: &Stated<'_>| {
            let own = mode.body.iter().filter(|one| !is_declaration(one));
            let foreign = owners.iter().filter(|(_, owner)| **owner != mode.name.text);
            Phase {
                name: mode.name.text.clone(),
                summary: mode.summary.clone(),
                span: mode.name.span,
                common: common.len(),
                statements: common.iter().chain(own.copied()).cloned().collect(),
                absent: foreign.map(|(name, owner)| (name.clone(), owner.to_string())).collect(),
            }
        };
        Self { all: stated.iter().map(phase).collect(), first }
    }

    /// Whether there are modes, or events.
    pub fn is_hybrid(&self) -> bool {
        let eventful = |one: &Statement| {
            matches!(one.kind, StatementKind::When(_) | StatementKind::Hold { .. })
        };
        let mut all = self.all.iter();
        all.any(|phase| !phase.name.is_empty() || phase.statements.iter().any(eventful))
    }

    /// The names of events, each once.
    pub fn event_names(&self) -> Vec<String> {
        let statements = self.all.iter().flat_map(|phase| &phase.statements);
        let labels = statements.filter_map(|one| match &one.kind {
            StatementKind::When(event) => event.label.as_ref(),
            _ => None,
        });
        // A wrong index is reported where the event is read.
        let name = |label| target_name(label, &mut Diagnostics::default());
        let names: BTreeSet<String> = labels.filter_map(name).map(|name| name.text).collect();
        names.into_iter().collect()
    }

    /// The mode of a name.
    pub fn find(&self, name: &Name, diagnostics: &mut Diagnostics) -> Option<usize> {
        let found = self.all.iter().position(|phase| phase.name == name.text);
        if found.is_none() {
            let known: Vec<&str> = self.all.iter().map(|phase| phase.name.as_str()).collect();
            diagnostics.push(no_mode(name, &known));
        }
        found
    }
}

fn no_mode(name: &Name, known: &[&str]) -> Diagnostic {
    let report = Diagnostic::error(name.span, format!("there is no mode `{}` here", name.text));
    let known: Vec<&str> = known.iter().copied().filter(|one| !one.is_empty()).collect();
    let otherwise = match known.is_empty() {
        true => format!("declare it with `mode {} {{ … }}`", name.text),
        false => format!("the scene has {}", known.join(", ")),
    };
    report.meant(nearest(&name.text, known.iter().copied()), otherwise)
}

fn stated<'a>(statements: &'a [Statement], diagnostics: &mut Diagnostics) -> Vec<Stated<'a>> {
    let mut all: Vec<Stated<'a>> = Vec::new();
    for statement in statements {
        let StatementKind::Mode { name, text, body } = &statement.kind else {
            continue;
        };
        for inner in body {
            report_misplaced(inner, diagnostics);
        }
        let documentation = statement.documentation.join("\n").trim().to_string();
        let summary = text.clone().unwrap_or(documentation);
        let earlier = all.iter_mut().find(|one| one.name.text == name.text);
        match earlier {
            Some(mode) => {
                mode.body.extend(body);
                if mode.summary.is_empty() {
                    mode.summary = summary;
                }
            }
            None => all.push(Stated { name, summary, body: body.iter().collect() }),
        }
    }
    all
}

/// The mode in which the motion begins: the first one unless the scene says otherwise.
fn first(stated: &[Stated<'_>], scene: Option<&Scene>, diagnostics: &mut Diagnostics) -> usize {
    let mut first = 0;
    let mut said: Option<&Name> = None;
    for item in scene.iter().flat_map(|scene| &scene.items) {
        let SceneItem::StartIn { mode } = item else {
            continue;
        };
        if let Some(earlier) = said.replace(mode) {
            let message = "the motion begins in one mode, and this is the second";
            diagnostics.push(
                Diagnostic::error(mode.span, message)
                    .related(earlier.span, "the first one")
                    .hint("take one of the two away"),
            );
        }
        let known: Vec<&str> = stated.iter().map(|one| one.name.text.as_str()).collect();
        match known.iter().position(|name| *name == mode.text) {
            Some(index) => first = index,
            None => diagnostics.push(no_mode(mode, &known)),
        }
    }
    first
}

fn is_declaration(statement: &Statement) -> bool {
    matches!(
        statement.kind,
        StatementKind::Constant(_)
            | StatementKind::Driver(_)
            | StatementKind::Coordinate(_)
            | StatementKind::State(_)
    )
}

/// What belongs to the whole scene, whatever its mode.
fn report_misplaced(statement: &Statement, diagnostics: &mut Diagnostics) {
    let what = match &statement.kind {
        StatementKind::Mode { .. } => "a mode",
        StatementKind::Output(_) => "an output",
        StatementKind::Measure { .. } => "a measure",
        StatementKind::Mark { .. } => "a mark",
        StatementKind::Part { .. } => "a part",
        StatementKind::Dependent(_) => "a dependent coordinate",
        StatementKind::Point { .. } | StatementKind::Link { .. } => "what is drawn",
        _ => return,
    };
    let report = Diagnostic::error(statement.span, format!("{what} stands outside every mode"));
    diagnostics.push(match statement.kind {
        StatementKind::Output(_) | StatementKind::Measure { .. } => {
            report.hint("report the name of an abbreviation that each mode defines in its own way")
        }
        _ => report.hint("move it out of the braces"),
    });
}
