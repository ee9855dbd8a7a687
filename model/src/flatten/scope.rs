//! Names in full: what a name means in its file becomes what it is called in the whole.

use std::collections::BTreeSet;

use crate::syntax::tree::{
    Name, Selection, Statement, StatementKind, Target, Term, TermKind, Visitor,
};
use crate::syntax::words::{COMPONENTS, FUNCTIONS, MEASURING, MOMENTS, QUANTITIES};

/// The names of a file.
pub struct Scope<'a> {
    /// What stands before its names in the whole; empty for the main file.
    prefix: &'a str,
    /// Its parts.
    parts: BTreeSet<String>,
    /// The choices of its parts, in full.
    choices: BTreeSet<String>,
    /// The quantities of its parts, in full.
    quantities: BTreeSet<String>,
    /// Indices of repetitions and arguments of functions.
    locals: Vec<String>,
    /// Whether a measure is being named, which has words of its own.
    pub measures: bool,
}

impl<'a> Scope<'a> {
    /// A file without parts.
    pub fn new(prefix: &'a str) -> Self {
        Self {
            prefix,
            parts: BTreeSet::new(),
            choices: BTreeSet::new(),
            quantities: BTreeSet::new(),
            locals: Vec::new(),
            measures: false,
        }
    }

    /// Adds a part.
    pub fn add(&mut self, name: &Name, statements: &[Statement]) {
        self.parts.insert(name.text.clone());
        self.add_names(statements);
    }

    fn add_names(&mut self, statements: &[Statement]) {
        for statement in statements {
            if let StatementKind::Choice { name, .. } = &statement.kind {
                self.choices.insert(name.text.clone());
            }
            let quantity = statement.kind.declared().map(|one| one.name.text.clone());
            self.quantities.extend(quantity);
            for body in statement.kind.blocks() {
                self.add_names(body);
            }
        }
    }

    /// Whether the file is that of a part.
    pub fn is_part(&self) -> bool {
        !self.prefix.is_empty()
    }

    /// Knows the index of a repetition in its body. Gives what [`Self::leave`] needs.
    pub fn enter(&mut self, kind: &StatementKind) -> usize {
        let before = self.locals.len();
        if let StatementKind::For { index, .. } = kind {
            self.locals.push(index.text.clone());
        }
        before
    }

    /// Forgets what was known since.
    pub fn leave(&mut self, before: usize) {
        self.locals.truncate(before);
    }

    fn is_of_part(&self, name: &str) -> bool {
        let first = name.split('.').next().unwrap_or(name);
        self.parts.contains(first)
    }

    /// A name that is used. One that the file does not declare gets the prefix as well, so that it is missing rather
    /// than found in the file around.
    fn used(&self, name: &mut String) {
        let of_language = [QUANTITIES, FUNCTIONS].iter().any(|list| list.contains(&name.as_str()));
        if !of_language && !self.locals.contains(name) {
            name.insert_str(0, self.prefix);
        }
    }
}

impl Visitor for Scope<'_> {
    fn term(&mut self, term: &mut Term) {
        match &mut term.kind {
            // What is bound has been named where it stands.
            TermKind::Bound { .. } => return,
            TermKind::Name(name) if self.measures && name == "end" => {}
            TermKind::Name(name) => self.used(name),
            TermKind::Call { name, .. } if self.measures && is_of_measure(&name.text) => {}
            TermKind::Index { name, .. } | TermKind::Call { name, .. } => self.used(&mut name.text),
            TermKind::Member { base, name } => {
                if let Some(path) = dotted(base).filter(|path| self.is_of_part(path)) {
                    let path = format!("{}{path}", self.prefix);
                    let is_component =
                        self.quantities.contains(&path) && COMPONENTS.contains(&name.text.as_str());
                    if is_component || self.choices.contains(&path) {
                        base.kind = TermKind::Name(path);
                    } else {
                        term.kind = TermKind::Name(format!("{path}.{}", name.text));
                    }
                    return;
                }
            }
            TermKind::Sum { index, from, to, body }
            | TermKind::Search { variable: index, from, to, body, .. } => {
                self.term(from);
                self.term(to);
                self.locals.push(index.text.clone());
                self.term(body);
                self.locals.pop();
                return;
            }
            _ => {}
        }
        term.parts_mut().into_iter().for_each(|part| self.term(part));
    }

    fn target(&mut self, target: &mut Target) {
        self.name(&mut target.name);
        target.index.iter_mut().for_each(|index| self.term(index));
    }

    fn name(&mut self, name: &mut Name) {
        name.text.insert_str(0, self.prefix);
    }

    fn body(&mut self, arguments: &[Name], body: &mut Term) {
        let before = self.locals.len();
        self.locals.extend(arguments.iter().map(|one| one.text.clone()));
        self.term(body);
        self.locals.truncate(before);
    }

    /// `feed.torsion` is an effect of a part, `feed.crank.exact` an alternative of its choice.
    fn selection(&mut self, Selection { name, alternative }: &mut Selection) {
        if !self.is_of_part(&name.text) || self.choices.contains(&name.text) {
            return;
        }
        if let Some(last) = alternative.take() {
            *name = Name {
                text: format!("{}.{}", name.text, last.text),
                span: name.span.to(last.span),
            };
        }
    }
}

/// Whether a function is one that only measures know.
fn is_of_measure(name: &str) -> bool {
    [MEASURING, MOMENTS].iter().any(|list| list.contains(&name))
}

/// `feed.lift`, as one text.
fn dotted(term: &Term) -> Option<String> {
    match &term.kind {
        TermKind::Name(name) => Some(name.clone()),
        TermKind::Member { base, name } => Some(format!("{}.{}", dotted(base)?, name.text)),
        _ => None,
    }
}
