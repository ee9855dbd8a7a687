//! Events that are never carried out.

use super::phases::{Phase, Phases};
use crate::checked::EventInfo;
use crate::diagnostic::Diagnostic;
use crate::expression::Expression;
use crate::lower::Lowering;
use crate::program::Event;
use crate::syntax::tree::{Direction, StatementKind, When};
use crate::token::Span;

/// Whether the condition of an event is one between numbers that does not hold. One that depends on effects is not
/// meant: it may hold in another scene.
pub fn never_holds(event: &When, condition: Option<Expression>, low: &mut Lowering<'_>) -> bool {
    let (Some(term), Some(condition)) = (&event.condition, condition) else {
        return false;
    };
    if !term.is_made_of_numbers() || low.graph.as_decided(condition) != Some(false) {
        return false;
    }
    let message = "this never holds, so the event is never carried out";
    low.diagnostics.push(
        Diagnostic::warning(term.span, message)
            .hint("compare quantities that move, or take the event away"),
    );
    true
}

/// Reports, and marks, events that always come behind another one that leads to a mode without them.
pub fn report(
    low: &mut Lowering<'_>,
    phases: &Phases,
    here: usize,
    events: &mut [(Event<Expression>, EventInfo)],
) {
    for later in 1..events.len() {
        let (before, rest) = events.split_at_mut(later);
        let (event, info) = &mut rest[0];
        let first = before.iter().find(|(first, other)| {
            let leaves = other.target != here && !has(&phases.all[other.target], info.span);
            leaves && !other.is_idle && precedes((first, other), (event, info))
        });
        let Some((_, first)) = first else {
            continue;
        };
        info.is_idle = true;
        let message = format!(
            "this event is never carried out: at the same instant another one leads to the mode `{}` first",
            phases.all[first.target].name
        );
        low.diagnostics.push(
            Diagnostic::warning(info.span, message)
                .related(first.span, "this one comes first")
                .hint("give the first one a condition, `when … if …`, or take one of them away"),
        );
    }
}

/// Whether one event happens wherever another one does.
fn precedes(
    (first, info): (&Event<Expression>, &EventInfo),
    (later, other): (&Event<Expression>, &EventInfo),
) -> bool {
    let passes = info.direction == Direction::Crosses || info.direction == other.direction;
    let holds = first.condition.is_none_or(|one| later.condition == Some(one));
    first.guard == later.guard && passes && holds
}

/// Whether an event is one of a mode.
fn has(phase: &Phase, event: Span) -> bool {
    let mut all = phase.statements.iter();
    all.any(|one| matches!(one.kind, StatementKind::When(_)) && one.span == event)
}
