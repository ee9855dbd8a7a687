//! The second phase: which coordinates the loops determine, and in which order they are closed.

use std::rc::Rc;

use super::{Here, begin};
use crate::checked::EquationInfo;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Budget, Graph};
use crate::linkage::{self, Linkage, Loops};
use crate::lower::Lowering;
use crate::resolve::Names;
use crate::syntax::tree::{Statement, StatementKind};

/// Makes dependent coordinates of those that the closures determine, where there are more closures than coordinates that
/// are declared so.
pub fn bind(here: Here<'_>, names: &mut Names, budget: Rc<Budget>, diagnostics: &mut Diagnostics) {
    let statements = &here.phase().statements;
    let closes = |one: &Statement| matches!(one.kind, StatementKind::Closure { .. });
    if names.coordinates.is_empty() || !statements.iter().any(closes) {
        return;
    }
    // What is wrong in what is read here is said when it is read for good.
    let mut unsaid = Diagnostics::default();
    let (survey, selected) = (here.task.survey, here.task.selected);
    let low = &mut Lowering::new(names, survey, selected, &mut unsaid, budget);
    let declared = super::declare::quantities(here, low);
    let loops = Loops::read(statements, low);
    if low.diagnostics.has_errors() {
        return;
    }
    let (places, starts) = begin::places(here, &declared, low);
    let at = |symbol| match places.of(symbol) {
        value if value.is_finite() => value,
        _ => Graph::somewhere(symbol, 1),
    };
    let (bound, wrong) = linkage::bound(&loops, &at, low);
    let left = names.coordinates.len() - bound.len();
    if left == 0 && names.drivers.is_empty() && wrong.is_none() {
        let place = names.coordinates[0].name.span;
        let message = "no coordinate is left that can move: the closures determine all of them";
        diagnostics.push_once(
            "nothing moves".into(),
            Diagnostic::error(place, message)
                .hint("take a closure away, or prescribe a motion with `driver`"),
        );
    }
    diagnostics.extend(wrong);
    for (index, is_rate, term) in starts {
        let what = &mut names.coordinates[index].what;
        let place = if is_rate { &mut what.start_rate } else { &mut what.start };
        if bound.contains(&index) {
            *place = Some(term);
        }
    }
    names.bind(&bound);
}

/// Reads the loops, which give their texts, and orders them unless there is a mistake.
pub fn close(
    here: Here<'_>,
    low: &mut Lowering<'_>,
    is_complete: impl Fn(&Lowering<'_>) -> bool,
) -> (Vec<EquationInfo>, Option<Linkage>) {
    let loops = Loops::read(&here.phase().statements, low);
    let texts = loops.texts.clone();
    let linkage = match is_complete(low) {
        true => Linkage::of(loops, low.names, &here.place(), low),
        false => None,
    };
    low.loops_are_wrong = linkage.is_none();
    linkage::follow(low);
    (texts, linkage)
}
