//! What a part is given from outside: bindings take the place of what its file says.

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{
    Binding, Constant, Dependent, Driver, Statement, StatementKind, Target, Term, Unknown,
    is_unread,
};

/// Whose quantities are bound.
pub struct Whose<'a> {
    /// Full name of the part.
    pub part: &'a str,
    /// What it is.
    pub mechanism: &'a str,
    /// What can be bound, as its file calls it.
    pub known: Vec<String>,
}

/// Binds a quantity, wherever the statements of the part declare it.
pub fn apply(
    binding: &Binding,
    name: &str,
    whose: &Whose<'_>,
    held: &mut [Statement],
    unread: &BTreeSet<String>,
    diagnostics: &mut Diagnostics,
) {
    let span = binding.target.name.span;
    let own = binding.target.name.text.as_str();
    if says_nothing(binding) {
        let report = Diagnostic::error(span, format!("nothing is said of `{name}`"));
        diagnostics.push(report.hint(format!("give it a value: `{own} = …;`")));
        return;
    }
    let mut found = false;
    visit(held, &mut |statement| {
        let Some(target) = statement.kind.declared().filter(|one| one.name.text == name) else {
            return;
        };
        found = true;
        if target.index.is_some() || binding.target.index.is_some() {
            let message = "a quantity with an index cannot be bound in this version of Assur";
            let report = Diagnostic::error(span, message);
            diagnostics.push(report.related(target.name.span, "declared here"));
            return;
        }
        let place = target.name.span;
        if let Err((report, hint)) = bind(&mut statement.kind, binding, name, whose) {
            diagnostics.push(report.related(place, "declared here").hint(hint));
        }
    });
    if !found && !is_unread(unread, name) {
        diagnostics.push(unknown(own, binding, whose));
    }
}

fn says_nothing(binding: &Binding) -> bool {
    let values = binding.value.is_none() && binding.start.is_none();
    values && binding.tolerance.is_none() && binding.range.is_none()
}

/// A report and its hint.
type Refused = (Diagnostic, String);

/// Puts what is bound into the declaration.
fn bind(
    kind: &mut StatementKind,
    binding: &Binding,
    name: &str,
    whose: &Whose<'_>,
) -> Result<(), Refused> {
    let own = &binding.target.name.text;
    let at_start = |what: &str| match &binding.start {
        Some(start) => refused(
            start,
            format!("`{name}` is {what}, and `~` states where something starts"),
            format!("give it a value: `{own} = …;`"),
        ),
        None => Ok(()),
    };
    let no_value = |what: &str| match &binding.value {
        Some(value) => refused(
            value,
            format!("`{name}` cannot be given: {what}"),
            format!("say where it starts: `{own} ~ …;`"),
        ),
        None => Ok(()),
    };
    match kind {
        StatementKind::Constant(constant) => {
            at_start("a constant")?;
            if let Some(value) = &binding.value {
                let bound = given(name, value, constant.value.as_ref());
                if !value.is_made_of_numbers() {
                    no_limits(binding, name, "follows from other quantities")?;
                    *kind = abbreviation(&constant.target, bound);
                    return Ok(());
                }
                constant.value = Some(bound);
            }
            limit(constant, binding);
        }
        StatementKind::Driver(driver) => {
            let bounds = driver.range.iter().flat_map(|(low, high)| [low, high]);
            let instead = driver.start.iter().chain(bounds).chain(&driver.motion).next();
            if let Some(value) = &binding.value {
                at_start("driven from outside")?;
                no_limits(binding, name, "is driven from outside")?;
                *kind = abbreviation(&driver.target, given(name, value, instead));
                return Ok(());
            }
            if let Some(start) = &binding.start {
                driver.start = Some(given(name, start, instead));
            }
            driver.range = binding.range.clone().or(driver.range.take());
            driver.tolerance = binding.tolerance.clone().or(driver.tolerance.take());
        }
        StatementKind::Dependent(Dependent { start, .. }) => {
            no_value("closures determine it")?;
            no_limits(binding, name, "is found by closing the loops")?;
            if let Some(other) = &binding.start {
                *start = Some(given(name, other, start.as_ref()));
            }
        }
        StatementKind::Coordinate(Unknown { start, .. })
        | StatementKind::State(Unknown { start, .. }) => {
            no_value("the equations of motion determine it")?;
            no_limits(binding, name, "is found from the equations of motion")?;
            *start = binding.start.clone();
        }
        _ => {
            let message =
                format!("`{name}` follows from other quantities of `{}`", whose.mechanism);
            let report = Diagnostic::error(binding.target.name.span, message);
            let hint = "a part is given its drivers, dimensions, parameters and start values";
            return Err((report, hint.into()));
        }
    }
    Ok(())
}

fn refused(term: &Term, message: String, hint: String) -> Result<(), Refused> {
    Err((Diagnostic::error(term.span, message), hint))
}

/// A tolerance or a range belongs to a constant or to a driver that is free.
fn no_limits(binding: &Binding, name: &str, what: &str) -> Result<(), Refused> {
    let half_width = binding.tolerance.iter().map(|one| &one.half_width);
    let range = binding.range.iter().map(|(low, _)| low);
    match half_width.chain(range).next() {
        Some(term) => refused(
            term,
            format!("`{name}` {what}, so it has no tolerance and no range of its own"),
            "leave them out".into(),
        ),
        None => Ok(()),
    }
}

fn limit(constant: &mut Constant, binding: &Binding) {
    constant.tolerance = binding.tolerance.clone().or(constant.tolerance.take());
    constant.range = binding.range.clone().or(constant.range.take());
}

/// A value in the place of another one.
fn given(name: &str, value: &Term, instead: Option<&Term>) -> Term {
    match instead {
        Some(instead) => instead.clone().replaced(name, value),
        None => value.clone(),
    }
}

fn abbreviation(target: &Target, value: Term) -> StatementKind {
    StatementKind::Let { target: target.clone(), arguments: None, value }
}

/// What can be bound of a part, as its file calls it.
pub fn known(part: &str, held: &mut [Statement]) -> Vec<String> {
    let mut known: Vec<String> = Vec::new();
    let start = format!("{part}.");
    visit(held, &mut |statement| {
        if let StatementKind::Constant(Constant { target, .. })
        | StatementKind::Driver(Driver { target, .. })
        | StatementKind::Dependent(Dependent { target, .. })
        | StatementKind::Coordinate(Unknown { target, .. })
        | StatementKind::State(Unknown { target, .. }) = &statement.kind
        {
            let name = &target.name.text;
            let own = name.strip_prefix(&start).unwrap_or(name);
            if !known.iter().any(|one| one == own) {
                known.push(own.to_string());
            }
        }
    });
    known
}

fn unknown(own: &str, binding: &Binding, whose: &Whose<'_>) -> Diagnostic {
    let Whose { part, mechanism, known } = whose;
    let message = format!("the part `{part}` has no `{own}`");
    let report = Diagnostic::error(binding.target.name.span, message);
    let otherwise = match known.is_empty() {
        true => format!("nothing of `{mechanism}` can be bound"),
        false => format!("`{mechanism}` declares {}", known.join(", ")),
    };
    let near = nearest(own, known.iter().map(String::as_str));
    report.meant(near, otherwise)
}

/// Goes through statements and those in their blocks.
fn visit(statements: &mut [Statement], what: &mut dyn FnMut(&mut Statement)) {
    for statement in statements {
        what(statement);
        for body in statement.kind.blocks_mut() {
            visit(body, what);
        }
    }
}
