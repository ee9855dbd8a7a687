//! Published values beside the computed ones.

use super::Comparison;
use crate::show::number;
use crate::show::page::{Page, WIDTH};
use crate::show::text::{Align, Columns, wrap};

/// A row for each published value, with its remarks below.
pub fn section(page: &mut Page, published: &[Comparison]) {
    if published.is_empty() {
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
    for comparison in published {
        let error = comparison.error.max(1e-7 * comparison.computed.abs());
        let note = if comparison.fact.remark.is_empty() {
            String::new()
        } else {
            let known = remarks.iter().position(|remark| *remark == comparison.fact.remark);
            let number = known.unwrap_or_else(|| {
                remarks.push(comparison.fact.remark);
                remarks.len() - 1
            });
            format!("[{}]", number + 1)
        };
        table.row([
            comparison.name.clone(),
            comparison.place.clone(),
            number::declared(comparison.in_unit(comparison.fact.value)),
            number::with_error(comparison.in_unit(comparison.computed), comparison.in_unit(error)),
            comparison.unit.clone(),
            number::signed(comparison.in_unit(comparison.deviation()), 2),
            number::percent(comparison.relative()),
            format!("± {}", number::short(comparison.in_unit(comparison.fact.tolerance))),
            match comparison.within() {
                Some(true) => "within",
                Some(false) => "OUTSIDE",
                None => "-",
            }
            .to_owned(),
            note,
        ]);
    }
    page.table("Published values", &table);
    for (index, remark) in remarks.iter().enumerate() {
        for (line, part) in wrap(remark, WIDTH - 8).iter().enumerate() {
            let lead = if line == 0 { format!("[{}]", index + 1) } else { String::new() };
            let line = page.style.faint(&format!("  {lead:<5}{part}"));
            page.line(&line);
        }
    }
    if published.iter().any(|comparison| !comparison.comparable) {
        page.warn("(-) published for other values than those of this run: not comparable");
    }
    page.line("");
}
