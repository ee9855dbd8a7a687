//! Published values beside the computed ones.

use super::{Page, WIDTH};
use crate::number;
use crate::report::Report;
use crate::text::{Align, Columns, wrap};

/// A row for each published value, with its remarks below.
pub fn section(page: &mut Page, report: &Report) {
    if report.published.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("", Align::Left),
        ("where", Align::Left),
        ("published", Align::Point),
        ("computed", Align::Point),
        ("unit", Align::Left),
        ("deviation", Align::Left),
        ("", Align::Right),
        ("band", Align::Left),
        ("", Align::Left),
        ("", Align::Left),
    ]);
    let mut remarks: Vec<&str> = Vec::new();
    for comparison in &report.published {
        let variable = &report.case.variables[comparison.variable];
        let error = report.errors[comparison.variable].max(1e-7 * comparison.computed.abs());
        let note = if comparison.fact.remark.is_empty() {
            String::new()
        } else {
            let known = remarks
                .iter()
                .position(|remark| *remark == comparison.fact.remark);
            let number = known.unwrap_or_else(|| {
                remarks.push(comparison.fact.remark);
                remarks.len() - 1
            });
            format!("[{}]", number + 1)
        };
        table.row([
            variable.name.clone(),
            comparison.place.clone(),
            number::declared(variable.in_unit(comparison.fact.value)),
            number::with_error(
                variable.in_unit(comparison.computed),
                variable.in_unit(error),
            ),
            variable.unit.clone(),
            number::signed(variable.in_unit(comparison.deviation()), 2),
            number::percent(comparison.relative()),
            format!(
                "± {}",
                number::short(variable.in_unit(comparison.fact.tolerance))
            ),
            match comparison.within() {
                Some(true) => "within",
                Some(false) => "OUTSIDE",
                None => "-",
            }
            .to_owned(),
            note,
        ]);
    }
    page.section("Published values", &table);
    for (index, remark) in remarks.iter().enumerate() {
        for (line, part) in wrap(remark, WIDTH - 8).iter().enumerate() {
            let lead = if line == 0 {
                format!("[{}]", index + 1)
            } else {
                String::new()
            };
            let line = page.style.faint(&format!("  {lead:<5}{part}"));
            page.line(&line);
        }
    }
    if report
        .published
        .iter()
        .any(|comparison| !comparison.comparable)
    {
        let line = page
            .style
            .warn("  (-) published for other values than those of this run: not comparable");
        page.line(&line);
    }
    page.line("");
}
