//! Parts: a mechanism inside another becomes statements of that other.
//!
//! Every name that the file of a part declares gets the name of the part before it, `e_v` of `feed` becomes `feed.e_v`,
//! and so does every name that is used there: a part sees nothing of the file around it but what is bound. Names of the
//! language stay. This comes before effects and scenes are looked at, so that those of a part belong to the whole.
//!
//! Of a part its scenes, presets, published facts and marks are left out, and what it reports is only named: the file
//! around has its own. Its conditions, points and links are kept.

mod binding;
mod files;
mod scope;
mod tables;

use std::collections::{BTreeMap, BTreeSet};

pub use files::{Loader, Wanted};

use crate::checked::PartFile;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::syntax::tree::{Binding, File, Name, Output, Statement, StatementKind};
use crate::token::Span;
use files::Files;
use scope::Scope;

/// Parts may stand in each other this deep.
const DEPTH: usize = 16;

/// Most statements that the parts of a file may come to.
const LIMIT: usize = 20_000;

/// The statements of a part, its names in full; none of a part that cannot be had.
type Inlined = Option<Vec<Statement>>;

/// Puts the statements of all parts in their places. Gives the files that were read.
pub fn flatten(
    file: &mut File,
    tokens: usize,
    loader: &mut Loader<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<PartFile> {
    let mut flattener = Flattener {
        files: Files::new(tokens, loader),
        diagnostics,
        unread: BTreeSet::new(),
        open: Vec::new(),
        place: None,
        count: 0,
    };
    file.statements = flattener.file(file, "");
    file.unread = flattener.unread;
    flattener.files.list
}

struct Flattener<'a, 'b> {
    files: Files<'a, 'b>,
    diagnostics: &'a mut Diagnostics,
    /// Words of statements that could not be read, and parts that could not be had.
    unread: BTreeSet<String>,
    /// Paths of the files around, the innermost last.
    open: Vec<String>,
    /// Where the main file names the part around.
    place: Option<Span>,
    /// Statements of parts so far.
    count: usize,
}

impl Flattener<'_, '_> {
    /// The statements of a file, with `prefix` before all its names.
    fn file(&mut self, file: &File, prefix: &str) -> Vec<Statement> {
        let words = file.unread.iter().map(|word| format!("{prefix}{word}"));
        self.unread.extend(words);
        let mut parts = BTreeMap::new();
        let mut scope = Scope::new(prefix);
        self.collect(&file.statements, prefix, false, &mut parts, &mut scope);
        self.place(&file.statements, &mut scope, &mut parts)
    }

    /// The parts of a file, by the places of their names.
    fn collect(
        &mut self,
        statements: &[Statement],
        prefix: &str,
        repeated: bool,
        parts: &mut BTreeMap<Span, Inlined>,
        scope: &mut Scope<'_>,
    ) {
        let mut here: BTreeMap<&str, Span> = BTreeMap::new();
        for statement in statements {
            let StatementKind::Part { name, mechanism, file, .. } = &statement.kind else {
                let repeated = repeated || matches!(statement.kind, StatementKind::For { .. });
                for body in statement.kind.blocks() {
                    self.collect(body, prefix, repeated, parts, scope);
                }
                continue;
            };
            let inlined = match here.insert(&name.text, name.span) {
                Some(earlier) => {
                    let message = format!("there is already a part `{prefix}{}`", name.text);
                    self.diagnostics.push(
                        Diagnostic::error(name.span, message)
                            .related(earlier, "the first one")
                            .hint("give one of them another name"),
                    );
                    None
                }
                None if repeated => {
                    let message =
                        "a part in a repetition is not available in this version of Assur";
                    self.diagnostics.push(
                        Diagnostic::error(name.span, message)
                            .hint("write a `part` statement for each"),
                    );
                    None
                }
                None => self.part(name, mechanism, file.as_ref(), prefix),
            };
            if inlined.is_none() {
                self.unread.insert(format!("{prefix}{}", name.text));
            }
            scope.add(name, inlined.as_deref().unwrap_or_default());
            parts.insert(name.span, inlined);
        }
    }

    /// The statements of a part, before anything is bound.
    fn part(
        &mut self,
        name: &Name,
        mechanism: &Name,
        file: Option<&Name>,
        prefix: &str,
    ) -> Inlined {
        let file = file.cloned().unwrap_or_else(|| Name {
            text: format!("{}.eqn", snake(&mechanism.text)),
            span: mechanism.span,
        });
        let around = self.place;
        let place = around.unwrap_or(name.span.to(file.span));
        let path = files::beside(self.open.last().map_or("", String::as_str), &file.text);
        if let Some(at) = self.open.iter().position(|one| *one == path) {
            let circle: Vec<_> = self.open[at..].iter().chain([&path]).cloned().collect();
            let message = format!("the parts stand in a circle: {}", circle.join(" -> "));
            self.diagnostics.push(
                Diagnostic::error(file.span, message)
                    .hint("a mechanism cannot be a part of itself"),
            );
            return None;
        }
        if self.open.len() >= DEPTH {
            let message = format!("parts stand in each other more than {DEPTH} deep");
            self.diagnostics.push(Diagnostic::error(file.span, message));
            return None;
        }
        let read = self.files.load(&path, place, file.span, self.diagnostics)?;
        if read.name.text != mechanism.text {
            let message = format!(
                "`{path}` holds the mechanism `{}`, not `{}`",
                read.name.text, mechanism.text
            );
            let hint = format!("write `part {}: {} from …`", name.text, read.name.text);
            self.diagnostics.push(
                Diagnostic::error(mechanism.span, message)
                    .related(read.name.span, "its name")
                    .hint(hint),
            );
        }
        self.count += 1 + read.statements.iter().map(Statement::count).sum::<usize>();
        if self.count > LIMIT {
            let message = format!("the parts up to here come to more than {LIMIT} statements");
            self.diagnostics.push_once("parts".into(), Diagnostic::error(place, message));
            return None;
        }
        self.open.push(path);
        self.place = Some(place);
        let statements = self.file(&read, &format!("{prefix}{}.", name.text));
        self.place = around;
        self.open.pop();
        Some(statements)
    }

    /// Statements with their names in full, parts replaced by what they hold.
    fn place(
        &mut self,
        statements: &[Statement],
        scope: &mut Scope<'_>,
        parts: &mut BTreeMap<Span, Inlined>,
    ) -> Vec<Statement> {
        let mut placed = Vec::new();
        for statement in statements {
            let mut statement = statement.clone();
            scope.measures = matches!(statement.kind, StatementKind::Measure { .. });
            if scope.is_part() && !is_kept(&mut statement.kind) {
                continue;
            }
            self.read_tables(&mut statement.kind);
            statement.kind.visit(scope);
            let locals = scope.enter(&statement.kind);
            for body in statement.kind.blocks_mut() {
                *body = self.place(body, scope, parts);
            }
            scope.leave(locals);
            if let StatementKind::Part { name, mechanism, bindings, .. } = &mut statement.kind {
                let Some(mut held) = parts.remove(&name.span).flatten() else {
                    continue;
                };
                let bindings = std::mem::take(bindings);
                self.bind(&name.text, &mechanism.text, bindings, &mut held);
                placed.extend(held);
            }
            placed.push(statement);
        }
        placed
    }

    fn bind(
        &mut self,
        part: &str,
        mechanism: &str,
        bindings: Vec<Binding>,
        held: &mut [Statement],
    ) {
        let mut bound: BTreeMap<String, Span> = BTreeMap::new();
        let whose = binding::Whose { part, mechanism, known: binding::known(part, held) };
        for binding in bindings {
            let name = format!("{part}.{}", binding.target.name.text);
            let span = binding.target.name.span;
            if let Some(earlier) = bound.insert(name.clone(), span) {
                let report = Diagnostic::error(span, format!("`{name}` is bound twice"));
                self.diagnostics.push(report.related(earlier, "the first time"));
                continue;
            }
            binding::apply(&binding, &name, &whose, held, &self.unread, self.diagnostics);
        }
    }
}

/// Whether a statement of a part belongs to the whole. What it reports or measures is named, for the whole to ask for it.
fn is_kept(kind: &mut StatementKind) -> bool {
    match kind {
        StatementKind::Scene(_)
        | StatementKind::Preset { .. }
        | StatementKind::Expect(_)
        | StatementKind::Mark { .. } => false,
        StatementKind::Output(Output { name: Some(target), value: Some(value), .. }) => {
            *kind = StatementKind::Let {
                target: target.clone(),
                arguments: None,
                value: value.clone(),
            };
            true
        }
        StatementKind::Output(_) => false,
        _ => true,
    }
}

/// `SewingFeed` as `sewing_feed`: how a file is called after its mechanism.
fn snake(name: &str) -> String {
    let mut text = String::new();
    let mut lower_before = false;
    for character in name.chars() {
        if character.is_uppercase() && lower_before {
            text.push('_');
        }
        lower_before = character.is_lowercase() || character.is_ascii_digit();
        text.extend(character.to_lowercase());
    }
    text
}
