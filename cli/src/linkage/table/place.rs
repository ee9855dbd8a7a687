//! A linkage at a place that was asked for, with its influence coefficients.

use super::limits::rounding;
use crate::linkage::group;
use crate::linkage::influence::unit_of;
use crate::linkage::report::{Report, Snapshot};
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Everything at a place.
pub fn section(page: &mut Page, report: &Report, snapshot: &Snapshot) {
    let case = &report.case;
    let time = match snapshot.place.time {
        Some(time) if !snapshot.place.label.starts_with("time") => {
            format!(", time = {} s", number::short(time))
        }
        _ => String::new(),
    };
    let mut table = Columns::new([
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("± error", Align::Left),
        ("", Align::Left),
    ]);
    let values = case.values(&snapshot.sample);
    for ((variable, value), error) in case.variables.iter().zip(values).zip(&snapshot.errors) {
        let value = variable.in_unit(value);
        table.row([
            variable.name.clone(),
            number::with_error(value, 1e-9 * value.abs()),
            variable.unit.clone(),
            rounding(variable.in_unit(*error)),
            variable.summary.clone(),
        ]);
    }
    for (index, of_group) in case.moved.entry.groups.iter().enumerate() {
        if group::transmits(of_group) {
            let angle = group::transmission(snapshot.sample.sines[index]);
            table.row([
                "transmission".to_owned(),
                number::short(number::rounded(angle, 6)),
                "deg".to_owned(),
                String::new(),
                group::equations(case.moved.entry, of_group),
            ]);
        }
    }
    page.table(&format!("At {}{time}", snapshot.place.label), &table);
    for outside in &snapshot.place.outside {
        page.warn(outside);
    }
    page.line("");
    influence(page, report, snapshot);
}

/// What each driver and dimension does to the outputs.
fn influence(page: &mut Page, report: &Report, snapshot: &Snapshot) {
    let outputs =
        &report.case.variables[..report.case.scene.outputs.len().min(report.case.variables.len())];
    let counts = |value: &f64| value.is_finite() && *value != 0.0;
    let rows: Vec<_> =
        snapshot.influence.iter().filter(|row| row.values.iter().any(counts)).collect();
    if rows.is_empty() || outputs.is_empty() {
        return;
    }
    let columns =
        outputs.iter().flat_map(|output| [(output.name.as_str(), Align::Point), ("", Align::Left)]);
    let mut table = Columns::new([("by", Align::Left)].into_iter().chain(columns));
    for row in rows {
        let mut cells = vec![row.variable.name.to_owned()];
        for (output, value) in outputs.iter().zip(&row.values) {
            let (unit, factor) = unit_of(output, &row.variable);
            cells.push(number::significant(value / factor, 6));
            cells.push(unit);
        }
        table.row(cells);
    }
    let heading = format!("Influence coefficients at {}", snapshot.place.label);
    page.section(&heading, &table);
}
