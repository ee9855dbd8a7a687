//! Gives every name of a scene its meaning.

use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{
    Constant, Dependent, Driver, Name, Output, Statement, StatementKind, Target, Term, TermKind,
    UnitTerm, Unknown,
};
use crate::syntax::words::{FUNCTIONS, MEASURING, QUANTITIES};
use crate::token::Span;
use crate::unroll::target_name;

/// A declared name.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Where it is declared.
    pub span: Span,
    /// What it is.
    pub role: Role,
}

/// What a name is.
#[derive(Clone, Debug)]
pub enum Role {
    /// A dimension or parameter, by index.
    Constant(u32),
    /// A driver, by index.
    Driver(u32),
    /// A dependent coordinate, by index.
    Dependent(u32),
    /// A coordinate, by index.
    Coordinate(u32),
    /// A first-order state, by index.
    State(u32),
    /// An abbreviation.
    Let(Term),
    /// An abbreviation with arguments.
    Function(Vec<Name>, Term),
    /// A number of a whole run.
    Measure(Term),
    /// A part, by what it is.
    Part(String),
}

/// A declaration with its full name, the index included, and its documentation.
#[derive(Clone, Debug)]
pub struct Declared<T> {
    /// Name.
    pub name: Name,
    /// Documentation.
    pub summary: String,
    /// The declaration.
    pub what: T,
}

/// The names of a scene.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// By name.
    pub table: BTreeMap<String, Entry>,
    /// Dimensions and parameters.
    pub constants: Vec<Declared<Constant>>,
    /// Drivers.
    pub drivers: Vec<Declared<Driver>>,
    /// Dependent coordinates.
    pub dependents: Vec<Declared<Dependent>>,
    /// Points with their positions, also abbreviations.
    pub points: Vec<Declared<Term>>,
    /// Coordinates.
    pub coordinates: Vec<Declared<Unknown>>,
    /// First-order states.
    pub states: Vec<Declared<Unknown>>,
    /// The coordinates among the dependent ones, by their place there: declared as such and determined by closures.
    pub bound: BTreeMap<usize, Unknown>,
    /// Coordinates that only another mode has, with the name of that mode.
    pub absent: BTreeMap<String, String>,
    /// Reported quantities that stand outside a scene block, with their full name where they have one.
    pub outputs: Vec<Declared<Output>>,
    /// Numbers of a whole run.
    pub measures: Vec<Declared<Output>>,
}

impl Names {
    /// Declares everything that a scene's statements declare.
    pub fn of(statements: &[Statement], diagnostics: &mut Diagnostics) -> Self {
        let mut names = Self::default();
        for statement in statements {
            names.declare(statement, diagnostics);
        }
        names
    }

    /// Makes dependent coordinates of those with these indices: closures determine them.
    pub fn bind(&mut self, indices: &[usize]) {
        let all = std::mem::take(&mut self.coordinates);
        for (index, declared) in all.into_iter().enumerate() {
            let role = if indices.contains(&index) {
                let place = self.dependents.len();
                let Unknown { target, unit, start, .. } = declared.what.clone();
                self.bound.insert(place, declared.what.clone());
                self.dependents.push(Declared {
                    name: declared.name.clone(),
                    summary: declared.summary,
                    what: Dependent { target, unit, start },
                });
                Role::Dependent(place as u32)
            } else {
                self.coordinates.push(declared.clone());
                Role::Coordinate(self.coordinates.len() as u32 - 1)
            };
            if let Some(entry) = self.table.get_mut(&declared.name.text) {
                entry.role = role;
            }
        }
    }

    /// Makes a constant of a driver that a scene holds, where it stands as it is declared.
    pub fn hold(&mut self, name: &Name, diagnostics: &mut Diagnostics) {
        let place = self.drivers.iter().position(|one| one.name.text == name.text);
        let Some(place) = place else {
            let all = self.drivers.iter().map(|one| one.name.text.as_str());
            let report =
                Diagnostic::error(name.span, format!("there is no driver `{}`", name.text));
            diagnostics.push(match nearest(&name.text, all) {
                Some(near) => report.hint(format!("did you mean `{near}`?")),
                None => report.hint("what is held is a driver; a parameter is a value anyway"),
            });
            return;
        };
        let Declared { name: own, summary, what } = self.drivers.remove(place);
        if what.start.is_none() {
            let report = Diagnostic::error(name.span, format!("`{}` stands nowhere", name.text));
            let report = report.related(own.span, "it is declared without a start value");
            diagnostics.push(report.hint("write where it starts, `driver phi ~ 0 deg;`"));
        }
        let Driver { target, start: value, tolerance, range, .. } = what;
        let what = Constant { is_dimension: false, target, value, tolerance, range };
        self.constants.push(Declared { name: own, summary, what });
        let roles = self.drivers.iter().enumerate();
        let roles = roles.map(|(index, one)| (&one.name.text, Role::Driver(index as u32)));
        let held = Role::Constant(self.constants.len() as u32 - 1);
        for (name, role) in roles.chain([(&name.text, held)]) {
            if let Some(entry) = self.table.get_mut(name) {
                entry.role = role;
            }
        }
    }

    /// Makes drivers of constants that a scene sweeps.
    pub fn drive(&mut self, swept: &[&str]) {
        let all = std::mem::take(&mut self.constants);
        for declared in all {
            let is_swept = swept.contains(&declared.name.text.as_str());
            let role = if is_swept {
                let Constant { target, value, tolerance, range, .. } = declared.what.clone();
                let what = Driver { target, motion: None, start: value, tolerance, range };
                let Declared { name, summary, .. } = declared.clone();
                self.drivers.push(Declared { name, summary, what });
                Role::Driver(self.drivers.len() as u32 - 1)
            } else {
                self.constants.push(declared.clone());
                Role::Constant(self.constants.len() as u32 - 1)
            };
            if let Some(entry) = self.table.get_mut(&declared.name.text) {
                entry.role = role;
            }
        }
    }

    /// Puts dependent coordinates and drivers together elsewhere than they declare, as a scene states.
    pub fn start(&mut self, target: &Term, value: &Term) {
        let TermKind::Name(name) = &target.kind else { return };
        let start = match self.table.get(name).map(|entry| &entry.role) {
            Some(Role::Dependent(index)) => &mut self.dependents[*index as usize].what.start,
            Some(Role::Driver(index)) => &mut self.drivers[*index as usize].what.start,
            _ => return,
        };
        // Its kind and its unit stay those of the declaration.
        *start = Some(match start.take() {
            Some(instead) => instead.replaced(name, value),
            None => value.clone(),
        });
    }

    /// Makes coordinates of all dependent ones, behind the others: closures hold them, and are not solved for them.
    pub fn release(&mut self) {
        for declared in std::mem::take(&mut self.dependents) {
            let Dependent { target, unit, start } = declared.what;
            if let Some(entry) = self.table.get_mut(&declared.name.text) {
                entry.role = Role::Coordinate(self.coordinates.len() as u32);
            }
            let what = Unknown { target, unit, start, start_rate: None };
            let Declared { name, summary, .. } = declared;
            self.coordinates.push(Declared { name, summary, what });
        }
    }

    fn declare(&mut self, statement: &Statement, diagnostics: &mut Diagnostics) {
        let summary = statement.documentation.join("\n").trim().to_string();
        match &statement.kind {
            StatementKind::Constant(what) => {
                let declared = (&what.target, summary, what);
                self.list(declared, Role::Constant, |all| &mut all.constants, diagnostics);
            }
            StatementKind::Driver(what) => {
                let declared = (&what.target, summary, what);
                self.list(declared, Role::Driver, |all| &mut all.drivers, diagnostics);
            }
            StatementKind::Dependent(what) => {
                let declared = (&what.target, summary, what);
                self.list(declared, Role::Dependent, |all| &mut all.dependents, diagnostics);
            }
            StatementKind::Coordinate(what) => {
                let declared = (&what.target, summary, what);
                self.list(declared, Role::Coordinate, |all| &mut all.coordinates, diagnostics);
            }
            StatementKind::State(what) => {
                let declared = (&what.target, summary, what);
                self.list(declared, Role::State, |all| &mut all.states, diagnostics);
            }
            StatementKind::Point { target, value } => {
                let role = |_| Role::Let(value.clone());
                self.list((target, summary, value), role, |all| &mut all.points, diagnostics);
            }
            StatementKind::Let { target, arguments, value } => {
                let role = match arguments {
                    None => Role::Let(value.clone()),
                    Some(arguments) => Role::Function(arguments.clone(), value.clone()),
                };
                if let Some(name) = target_name(target, diagnostics) {
                    self.insert(&name, role, diagnostics);
                }
            }
            StatementKind::Output(output) => self.declare_output(output, summary, diagnostics),
            StatementKind::Measure { what, text } => {
                self.declare_measure(what, text.as_ref().unwrap_or(&summary), diagnostics);
            }
            StatementKind::Part { name, mechanism, .. } => {
                self.insert(name, Role::Part(mechanism.text.clone()), diagnostics);
            }
            _ => {}
        }
    }

    /// Declares what is counted among others of its sort.
    fn list<T: Clone>(
        &mut self,
        (target, summary, what): (&Target, String, &T),
        role: impl FnOnce(u32) -> Role,
        list: fn(&mut Self) -> &mut Vec<Declared<T>>,
        diagnostics: &mut Diagnostics,
    ) {
        let Some(name) = target_name(target, diagnostics) else {
            return;
        };
        let index = list(self).len() as u32;
        if self.insert(&name, role(index), diagnostics) {
            list(self).push(Declared { name, summary, what: what.clone() });
        }
    }

    /// An output with a value of its own also names that value.
    pub fn declare_output(
        &mut self,
        output: &Output,
        summary: String,
        diagnostics: &mut Diagnostics,
    ) {
        let name = match &output.name {
            Some(target) => match target_name(target, diagnostics) {
                Some(name) => name,
                None => return,
            },
            None => Name { text: String::new(), span: output.span },
        };
        if let (false, Some(value)) = (name.text.is_empty(), &output.value)
            && !self.insert(&name, Role::Let(value.clone()), diagnostics)
        {
            return;
        }
        self.outputs.push(Declared { name, summary, what: output.clone() });
    }

    /// Declares a number that a synthesis asks for under its own text, unless it has been asked for.
    pub fn seek(&mut self, name: Name, value: Term, text: Option<String>, unit: Option<UnitTerm>) {
        if self.table.contains_key(&name.text) {
            return;
        }
        let role = Role::Measure(value.clone());
        self.table.insert(name.text.clone(), Entry { span: name.span, role });
        let what = Output { name: None, value: Some(value), unit, span: name.span };
        self.measures.push(Declared { name, summary: text.unwrap_or_default(), what });
    }

    pub(crate) fn declare_measure(
        &mut self,
        what: &Output,
        summary: &str,
        diagnostics: &mut Diagnostics,
    ) {
        let (Some(target), Some(value)) = (&what.name, &what.value) else {
            return;
        };
        let Some(name) = target_name(target, diagnostics) else {
            return;
        };
        // That of a part is there for the whole to ask for.
        let is_own = !name.text.contains('.');
        if self.insert(&name, Role::Measure(value.clone()), diagnostics) && is_own {
            self.measures.push(Declared { name, summary: summary.to_string(), what: what.clone() });
        }
    }

    fn insert(&mut self, name: &Name, role: Role, diagnostics: &mut Diagnostics) -> bool {
        // In a part as well, the file of which means what it means by itself.
        let own = name.text.rsplit('.').next().unwrap_or_default();
        if FUNCTIONS.contains(&own) || QUANTITIES.contains(&own) {
            diagnostics.push(
                Diagnostic::error(name.span, format!("`{}` belongs to the language", name.text))
                    .hint("choose another name"),
            );
            return false;
        }
        if MEASURING.contains(&own) && matches!(role, Role::Measure(_)) {
            let message = format!("`{own}` is a function of measures, and its name is taken");
            diagnostics.push(
                Diagnostic::error(name.span, message)
                    .hint(format!("choose another name, such as `{own}_1`")),
            );
            return false;
        }
        if let Some(earlier) = self.table.get(&name.text) {
            // The same statement written out twice for different indices cannot meet itself here, so this is a real
            // second declaration.
            diagnostics.push(
                Diagnostic::error(name.span, format!("`{}` is declared twice", name.text))
                    .related(earlier.span, "the first declaration")
                    .hint("give one of them another name, or put them into different alternatives of a choice"),
            );
            return false;
        }
        self.table.insert(name.text.clone(), Entry { span: name.span, role });
        true
    }
}
