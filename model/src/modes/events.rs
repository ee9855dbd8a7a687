//! Where an event leads, and what it sets.

use super::guard;
use super::idle;
use super::phases::{Phase, Phases};
use crate::checked::EventInfo;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Symbol};
use crate::homogeneity::{agree, fitting_value, over, unlike};
use crate::lower::{Kind, Lowering, second};
use crate::program::{Event, Slopes};
use crate::resolve::{Names, Role};
use crate::syntax::print;
use crate::syntax::tree::{StatementKind, Term, TermKind, When};
use crate::token::Span;
use crate::unroll::target_name;

/// Reads the events of a mode.
pub fn read(
    low: &mut Lowering<'_>,
    names: &Names,
    phases: &Phases,
    here: usize,
) -> Vec<(Event<Expression>, EventInfo)> {
    let mut events = Vec::new();
    for statement in &phases.all[here].statements {
        if let StatementKind::When(event) = &statement.kind {
            let reader = Reader { names, phases, here, span: statement.span };
            low.begin(Some(statement.span));
            events.extend(reader.read(event, low));
        }
    }
    low.begin(None);
    // Of two that happen together the first in the file is first.
    events.sort_by_key(|(_, info)| info.span.first);
    idle::report(low, phases, here, &mut events);
    events
}

/// Reads one event.
struct Reader<'a> {
    names: &'a Names,
    phases: &'a Phases,
    here: usize,
    span: Span,
}

impl Reader<'_> {
    fn read(&self, event: &When, low: &mut Lowering<'_>) -> Option<(Event<Expression>, EventInfo)> {
        let (guard, kind) = low.scalar(&event.guard)?;
        let rate = guard::rate(low, guard, &event.guard, event.direction)?;
        let condition = match &event.condition {
            Some(condition) => Some(low.condition(condition)?),
            None => None,
        };
        let target = match &event.target {
            Some(name) => self.phases.find(name, low.diagnostics)?,
            None => self.here,
        };
        if target == self.here && event.resets.is_empty() {
            let report = Diagnostic::error(self.span, "this event changes nothing");
            low.diagnostics
                .push(report.hint("name the mode that follows, `-> mode`, or what it sets"));
            return None;
        }
        let after = self.after(event, target, low)?;
        let unit = low.natural_unit(&event.guard, kind);
        let label = event.label.as_ref();
        let label = label.and_then(|label| target_name(label, low.diagnostics));
        let info = EventInfo {
            label: label.map(|label| label.text),
            text: print::event(event),
            direction: event.direction,
            factor: unit.scale(),
            unit: unit.symbol,
            target,
            surface: None,
            span: self.span,
            is_idle: idle::never_holds(event, condition, low),
        };
        Some((Event { guard, rate, condition, after, slopes: Slopes::default() }, info))
    }

    /// The state after the event: what it sets, and what the mode that follows holds.
    fn after(
        &self,
        event: &When,
        target: usize,
        low: &mut Lowering<'_>,
    ) -> Option<Vec<Expression>> {
        let coordinates = self.names.coordinates.len();
        let mut after: Vec<Expression> = (0..coordinates as u32)
            .map(Symbol::Coordinate)
            .chain((0..coordinates as u32).map(Symbol::Speed))
            .chain((0..self.names.states.len() as u32).map(Symbol::State))
            .map(|symbol| low.graph.symbol(symbol))
            .collect();
        let set = self.set(event, &mut after, low)?;
        let next = &self.phases.all[target];
        for (index, name) in self.unknowns() {
            let speed = (index < coordinates).then_some(coordinates + index);
            let slot = if index < coordinates { index } else { index + coordinates };
            let slots = || [Some(slot), speed].into_iter().flatten();
            if let Some(owner) = next.absent.get(name) {
                if let Some(place) = slots().find_map(|slot| set[slot]) {
                    let message = format!(
                        "`{name}` belongs to the mode `{owner}`, and this event leads to `{}`",
                        next.name
                    );
                    low.diagnostics.push(
                        Diagnostic::error(place, message)
                            .related(self.names.table[name].span, "declared here")
                            .hint(format!("leave it out here: `{name}` is set by the events that lead to `{owner}`")),
                    );
                    return None;
                }
                slots().for_each(|slot| after[slot] = low.graph.zero());
            } else if self.phases.all[self.here].absent.contains_key(name) && set[slot].is_none() {
                let message =
                    format!("nothing says where `{name}` begins in the mode `{}`", next.name);
                low.diagnostics.push(
                    Diagnostic::error(self.span, message)
                        .hint(format!("set it: `{{ set {name} = …; }}`")),
                );
                return None;
            }
        }
        self.check_held(event, next, &set, &mut after, low)?;
        Some(after)
    }

    /// What an event sets, in its place among the states after it. Gives where each state is set.
    fn set(
        &self,
        event: &When,
        after: &mut [Expression],
        low: &mut Lowering<'_>,
    ) -> Option<Vec<Option<Span>>> {
        let mut set = vec![None; after.len()];
        for (term, value) in &event.resets {
            let (slot, kind) = self.slot(term, low)?;
            let (value, found) = low.scalar(value)?;
            if agree(found, kind).is_none() {
                let message = unlike(&format!("`{}`", print::term(term)), kind, found);
                let report = Diagnostic::error(term.span, message);
                low.diagnostics.push(report.hint(fitting_value(kind, &print::term(term))));
                return None;
            }
            if set[slot].replace(term.span).is_some() {
                let message = format!("`{}` is set twice", print::term(term));
                low.diagnostics.push(Diagnostic::error(term.span, message));
                return None;
            }
            after[slot] = value;
        }
        Some(set)
    }

    /// What the mode that follows holds stands still: a speed that it has before is set to zero in so many words.
    fn check_held(
        &self,
        event: &When,
        next: &Phase,
        set: &[Option<Span>],
        after: &mut [Expression],
        low: &mut Lowering<'_>,
    ) -> Option<()> {
        let coordinates = self.names.coordinates.len();
        let before = held(self.names, &self.phases.all[self.here]);
        for index in held(self.names, next) {
            if index >= coordinates || before.contains(&index) {
                continue;
            }
            let name = &self.names.coordinates[index].name.text;
            let slot = coordinates + index;
            let zero = low.graph.zero();
            if set[slot].is_none() || after[slot] != zero {
                let message = format!(
                    "the mode `{}` holds `{name}`, which moves before `{}`",
                    next.name,
                    print::event(event)
                );
                low.diagnostics.push(
                    Diagnostic::error(set[slot].unwrap_or(self.span), message)
                        .hint(format!("say that it stops: `{{ set dot({name}) = 0; }}`")),
                );
                return None;
            }
        }
        Some(())
    }

    /// Coordinates and states with their names; states are counted behind the coordinates.
    fn unknowns(&self) -> impl Iterator<Item = (usize, &str)> {
        let all = self.names.coordinates.iter().chain(&self.names.states);
        all.map(|one| one.name.text.as_str()).enumerate()
    }

    /// The component of the state that a term names, whether the mode here has it or not.
    fn slot(&self, term: &Term, low: &mut Lowering<'_>) -> Option<(usize, Kind)> {
        let coordinates = self.names.coordinates.len();
        let (name, speed) = match &term.kind {
            TermKind::Call { name, arguments } if name.text == "dot" => (arguments.first()?, true),
            _ => (term, false),
        };
        if is_missing(self.names, name) {
            // That there is no such name is all that can be said.
            low.term(name);
            return None;
        }
        let role = named(name).and_then(|name| Some(&self.names.table.get(&name)?.role));
        let found = match role {
            Some(Role::Coordinate(index)) => {
                let kind = low.kind_of(Symbol::Coordinate(*index));
                match speed {
                    true => over(kind, Kind::Of(second()))
                        .map(|kind| (coordinates + *index as usize, kind)),
                    false => Some((*index as usize, kind)),
                }
            }
            Some(Role::State(index)) if !speed => {
                Some((2 * coordinates + *index as usize, low.kind_of(Symbol::State(*index))))
            }
            _ => None,
        };
        if found.is_none() {
            let report =
                Diagnostic::error(term.span, "only a coordinate, its `dot`, or a state can be set");
            low.diagnostics.push(report.hint("the rest follows from them"));
        }
        found
    }
}

/// Whether nothing has the name that a term is.
fn is_missing(names: &Names, term: &Term) -> bool {
    named(term).is_some_and(|name| !names.table.contains_key(&name))
}

/// A name, with its index perhaps.
fn named(term: &Term) -> Option<String> {
    match &term.kind {
        TermKind::Name(name) => Some(name.clone()),
        TermKind::Index { name, index } => {
            let TermKind::Number { value, .. } = index.kind else {
                return None;
            };
            Some(format!("{}[{value}]", name.text))
        }
        _ => None,
    }
}

/// The coordinates and states that a mode holds, states counted behind the coordinates.
fn held(names: &Names, phase: &Phase) -> Vec<usize> {
    let holds = holds(phase);
    holds.filter_map(|target| held_index(names, target)).collect()
}

/// The coordinates and states that stand still in a mode: it holds them, or does not have them.
pub fn still(names: &Names, phase: &Phase) -> Vec<usize> {
    let held = held(names, phase);
    let all = names.coordinates.iter().chain(&names.states).enumerate();
    let stands = |(index, name): (usize, &str)| {
        (held.contains(&index) || phase.absent.contains_key(name)).then_some(index)
    };
    all.filter_map(|(index, one)| stands((index, &one.name.text))).collect()
}

/// Reports what cannot be held.
pub fn check_holds(low: &mut Lowering<'_>, names: &Names, phase: &Phase) {
    for target in holds(phase) {
        if !is_missing(names, target) && held_index(names, target).is_none() {
            let report = Diagnostic::error(target.span, "only a coordinate or a state can be held");
            low.diagnostics.push(report.hint("write `hold x;`"));
        }
        low.aside(|low| low.term(target));
    }
}

fn holds(phase: &Phase) -> impl Iterator<Item = &Term> {
    let statements = phase.statements.iter();
    statements.filter_map(|statement| match &statement.kind {
        StatementKind::Hold { target } => Some(target),
        _ => None,
    })
}

fn held_index(names: &Names, target: &Term) -> Option<usize> {
    match names.table.get(&named(target)?)?.role {
        Role::Coordinate(index) => Some(index as usize),
        Role::State(index) => Some(names.coordinates.len() + index as usize),
        _ => None,
    }
}
