//! As many equations as unknowns, and which ones are too many or too few.

use super::{Equation, UnknownName};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::structure::{Incidence, Matching};
use crate::token::Span;

fn listed(names: impl Iterator<Item = String>) -> String {
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// What to do about an unbalanced system.
pub struct Hints {
    /// Too many equations.
    pub over: &'static str,
    /// Too few.
    pub under: &'static str,
}

/// Reports what is determined too often or not at all, and says whether nothing is.
pub fn report_imbalance(
    incidence: &Incidence,
    matching: &Matching,
    equations: &[Equation],
    unknowns: &[UnknownName],
    (scene, hints): (&str, &Hints),
    diagnostics: &mut Diagnostics,
) -> bool {
    let imbalance = matching.imbalance(incidence);
    let count = |number: usize, word: &str| {
        format!("{number} {word}{}", if number == 1 { "" } else { "s" })
    };
    if let Some((rows, columns)) = &imbalance.overdetermined {
        let named = listed(rows.iter().map(|row| equations[*row].name.clone()));
        let message = format!(
            "{} ({named}) would have to determine {}{}",
            count(rows.len(), "equation"),
            count(columns.len(), "unknown"),
            if columns.is_empty() {
                String::new()
            } else {
                format!(
                    " ({})",
                    listed(columns.iter().map(|column| unknowns[*column].name.clone()))
                )
            }
        );
        let last = rows.last().map_or(Span::default(), |row| equations[*row].span);
        let report = Diagnostic::error(last, format!("{scene} {message}"));
        diagnostics.push_once(message, report.hint(hints.over));
    }
    if let Some((columns, rows)) = &imbalance.underdetermined {
        let named = listed(columns.iter().map(|column| unknowns[*column].name.clone()));
        let message = if rows.is_empty() {
            format!("nothing determines {named}")
        } else {
            format!(
                "{} ({named}) have to be determined by {} ({})",
                count(columns.len(), "unknown"),
                count(rows.len(), "equation"),
                listed(rows.iter().map(|row| equations[*row].name.clone()))
            )
        };
        let place = columns.first().map_or(Span::default(), |column| unknowns[*column].span);
        diagnostics.push_once(
            message.clone(),
            Diagnostic::error(place, format!("{scene} {message}")).hint(hints.under),
        );
    }
    imbalance.overdetermined.is_none() && imbalance.underdetermined.is_none()
}
