//! The third phase: what the statements say, as expressions.

use super::Here;
use crate::checked::EquationInfo;
use crate::lower::Lowering;
use crate::resolve::Role;
use crate::statements::Parts;
use crate::syntax::tree::{StatementKind, Term, TermKind};
use crate::unroll::target_name;

/// Lowers abbreviations, and what the statements say of the motion.
pub fn parts(here: Here<'_>, texts: Vec<EquationInfo>, low: &mut Lowering<'_>) -> Parts {
    abbreviations(here, low);
    let mut parts = Parts { texts, ..Parts::default() };
    for statement in &here.phase().statements {
        low.begin(Some(statement.span));
        parts.read(statement, low);
    }
    low.begin(None);
    parts
}

/// Abbreviations in the order of the file, used or not, so that each mistake is found.
fn abbreviations(here: Here<'_>, low: &mut Lowering<'_>) {
    for statement in &here.phase().statements {
        let StatementKind::Let { target, arguments: None, .. } = &statement.kind else {
            continue;
        };
        let Some(name) = target_name(target, low.diagnostics) else {
            continue;
        };
        let entry = low.names.table.get(&name.text);
        if let Some(Role::Let(_)) = entry.map(|entry| &entry.role) {
            low.begin(Some(statement.span));
            let used = low.used.contains(&name.text);
            let term = Term { span: name.span, kind: TermKind::Name(name.text.clone()) };
            low.aside(|low| low.term(&term));
            if !used {
                low.used.remove(&name.text);
            }
        }
    }
}
