//! Names in full: what a name means in its file becomes what it is called in the whole.

use std::collections::BTreeSet;

use crate::lower::COMPONENTS;
use crate::resolve::{FUNCTIONS, QUANTITIES};
use crate::syntax::tree::{
    ExpectAt, Name, SceneItem, Statement, StatementKind, Target, Term, TermKind, Tolerance,
};

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

    /// A statement without the statements in its blocks.
    pub fn statement(&mut self, kind: &mut StatementKind) {
        match kind {
            StatementKind::Constant(constant) => {
                self.target(&mut constant.target);
                self.some(&mut constant.value);
                self.limits(&mut constant.tolerance, &mut constant.range);
            }
            StatementKind::Preset { values, .. } => {
                for (target, value) in values {
                    self.target(target);
                    self.term(value);
                }
            }
            StatementKind::Let {
                target,
                arguments,
                value,
            } => {
                self.target(target);
                let before = self.locals.len();
                let arguments = arguments.iter().flatten();
                self.locals.extend(arguments.map(|one| one.text.clone()));
                self.term(value);
                self.locals.truncate(before);
            }
            StatementKind::Driver(driver) => {
                self.target(&mut driver.target);
                self.some(&mut driver.motion);
                self.some(&mut driver.start);
                self.limits(&mut driver.tolerance, &mut driver.range);
            }
            StatementKind::Dependent(dependent) => {
                self.target(&mut dependent.target);
                self.some(&mut dependent.start);
            }
            StatementKind::Closure { label, left, right }
            | StatementKind::Motion { label, left, right } => {
                label.iter_mut().for_each(|label| self.target(label));
                self.term(left);
                self.term(right);
            }
            StatementKind::Point { target, value } => {
                self.target(target);
                self.term(value);
            }
            StatementKind::Link { points, .. } => points.iter_mut().for_each(|one| self.term(one)),
            StatementKind::Part { name, bindings, .. } => {
                self.declared(name);
                for binding in bindings {
                    self.some(&mut binding.value);
                    self.some(&mut binding.start);
                    self.limits(&mut binding.tolerance, &mut binding.range);
                }
            }
            StatementKind::Coordinate(unknown) | StatementKind::State(unknown) => {
                self.target(&mut unknown.target);
                self.some(&mut unknown.start);
                self.some(&mut unknown.start_rate);
            }
            StatementKind::Energy { value, .. } => self.term(value),
            StatementKind::Force { value, on } => {
                self.term(value);
                self.term(on);
            }
            StatementKind::Require { condition, .. } | StatementKind::If { condition, .. } => {
                self.term(condition);
            }
            StatementKind::Effect { name, .. }
            | StatementKind::Choice { name, .. }
            | StatementKind::Mode { name, .. } => self.declared(name),
            StatementKind::Hold { target } => self.term(target),
            StatementKind::When(event) => {
                event.label.iter_mut().for_each(|label| self.target(label));
                self.term(&mut event.guard);
                self.some(&mut event.condition);
                event.target.iter_mut().for_each(|one| self.declared(one));
                for (target, value) in &mut event.resets {
                    self.term(target);
                    self.term(value);
                }
            }
            StatementKind::For { from, to, .. } => {
                self.term(from);
                self.term(to);
            }
            StatementKind::Scene(scene) => {
                for selection in &mut scene.selection {
                    self.selection(&mut selection.name, &mut selection.alternative);
                }
                scene.items.iter_mut().for_each(|item| self.item(item));
            }
            StatementKind::Output(output) | StatementKind::Measure { what: output, .. } => {
                output.name.iter_mut().for_each(|one| self.target(one));
                self.some(&mut output.value);
            }
            StatementKind::Mark { value, .. } => self.term(value),
            StatementKind::Expect(expect) => {
                if let ExpectAt::Value { places } = &mut expect.at {
                    places.iter_mut().for_each(|(_, value)| self.term(value));
                }
                self.term(&mut expect.quantity);
                self.term(&mut expect.value);
                self.term(&mut expect.tolerance);
            }
        }
    }

    fn item(&mut self, item: &mut SceneItem) {
        match item {
            SceneItem::Periodic { period } => {
                period.iter_mut().for_each(|period| self.term(period))
            }
            SceneItem::Run { from, to, .. } => {
                self.term(from);
                self.term(to);
            }
            SceneItem::Sweep { drivers } => {
                for (low, high) in drivers.iter_mut().filter_map(|one| one.range.as_mut()) {
                    self.term(low);
                    self.term(high);
                }
            }
            SceneItem::Preset { .. } => {}
            SceneItem::StartIn { mode } => self.declared(mode),
            SceneItem::Output(output) => self.some(&mut output.value),
            SceneItem::Start { values } => {
                for (target, value) in values {
                    self.term(target);
                    self.term(value);
                }
            }
        }
    }

    /// `feed.torsion` is an effect of a part, `feed.crank.exact` an alternative of its choice.
    fn selection(&self, name: &mut Name, alternative: &mut Option<Name>) {
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

    fn is_of_part(&self, name: &str) -> bool {
        let first = name.split('.').next().unwrap_or(name);
        self.parts.contains(first)
    }

    fn some(&mut self, term: &mut Option<Term>) {
        term.iter_mut().for_each(|term| self.term(term));
    }

    fn limits(&mut self, tolerance: &mut Option<Tolerance>, range: &mut Option<(Term, Term)>) {
        let half_width = tolerance.iter_mut().map(|one| &mut one.half_width);
        half_width.for_each(|term| self.term(term));
        if let Some((low, high)) = range {
            self.term(low);
            self.term(high);
        }
    }

    fn target(&mut self, target: &mut Target) {
        self.declared(&mut target.name);
        target.index.iter_mut().for_each(|index| self.term(index));
    }

    fn declared(&self, name: &mut Name) {
        name.text.insert_str(0, self.prefix);
    }

    /// A name that is used. One that the file does not declare gets the prefix as well, so that it is missing rather
    /// than found in the file around.
    fn used(&self, name: &mut String) {
        let of_language = [QUANTITIES, FUNCTIONS]
            .iter()
            .any(|list| list.contains(&name.as_str()));
        if !of_language && !self.locals.contains(name) {
            name.insert_str(0, self.prefix);
        }
    }

    fn term(&mut self, term: &mut Term) {
        match &mut term.kind {
            TermKind::Number { .. } | TermKind::Bound { .. } => {}
            TermKind::Name(name) => self.used(name),
            TermKind::Index { name, index } => {
                self.used(&mut name.text);
                self.term(index);
            }
            TermKind::Member { base, name } => match dotted(base) {
                Some(path) if self.is_of_part(&path) => {
                    let path = format!("{}{path}", self.prefix);
                    let is_component =
                        self.quantities.contains(&path) && COMPONENTS.contains(&name.text.as_str());
                    if is_component || self.choices.contains(&path) {
                        base.kind = TermKind::Name(path);
                    } else {
                        term.kind = TermKind::Name(format!("{path}.{}", name.text));
                    }
                }
                _ => self.term(base),
            },
            TermKind::Vector(items) => items.iter_mut().for_each(|one| self.term(one)),
            TermKind::Unary(_, inner) => self.term(inner),
            TermKind::Binary(_, left, right) => {
                self.term(left);
                self.term(right);
            }
            TermKind::Call { name, arguments } => {
                self.used(&mut name.text);
                arguments.iter_mut().for_each(|one| self.term(one));
            }
            TermKind::If {
                condition,
                then,
                otherwise,
            } => {
                self.term(condition);
                self.term(then);
                self.term(otherwise);
            }
            TermKind::Sum {
                index,
                from,
                to,
                body,
            } => {
                self.term(from);
                self.term(to);
                self.locals.push(index.text.clone());
                self.term(body);
                self.locals.pop();
            }
        }
    }
}

/// `feed.lift`, as one text.
fn dotted(term: &Term) -> Option<String> {
    match &term.kind {
        TermKind::Name(name) => Some(name.clone()),
        TermKind::Member { base, name } => Some(format!("{}.{}", dotted(base)?, name.text)),
        _ => None,
    }
}
