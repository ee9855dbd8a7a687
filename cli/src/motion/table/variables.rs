//! All variables at one place, and their extremes over the task.

use crate::motion::report::{Report, Snapshot};
use crate::motion::rest;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};
use assur::answer::End;
use assur::shape::Quantity;

/// Everything at one place.
pub fn snapshot(page: &mut Page, report: &Report, snapshot: &Snapshot, heading: &str) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("± error", Align::Left),
        ("", Align::Left),
    ]);
    let rows = report.case.variables.iter().zip(&snapshot.values).zip(&snapshot.errors);
    let rests = report.motion.rest().is_some();
    let shown = rows
        .filter(|((variable, _), _)| !rests || rest::says(report.motion.shape(), variable.origin));
    for ((variable, value), error) in shown {
        table.row([
            variable.name.clone(),
            number::with_error(variable.in_unit(*value), variable.in_unit(*error)),
            variable.unit.clone(),
            number::error(variable.in_unit(*error)),
            variable.summary.clone(),
        ]);
    }
    page.section(heading, &table);
}

/// Smallest and largest values over the task, and where they occur.
pub fn extremes(page: &mut Page, report: &Report) {
    let place = match report.case.leading(0.0).0 {
        Quantity { name, unit: "", .. } => format!("at {name}"),
        Quantity { name, unit, .. } => format!("at {name}, {unit}"),
    };
    let mut table = Columns::new([
        ("", Align::Left),
        ("smallest", Align::Point),
        ("± error", Align::Left),
        (&place, Align::Point),
        ("largest", Align::Point),
        ("± error", Align::Left),
        (&place, Align::Point),
        ("unit", Align::Left),
    ]);
    let place = |time: f64| {
        let (leading, position) = report.case.leading(time);
        position / leading.factor
    };
    let variables = report.case.variables.iter();
    for (variable, extremes) in variables.zip(&report.extremes) {
        let value = |end: End| {
            let error = end.error.max(1e-9 * end.value.abs());
            number::with_error(variable.in_unit(end.value), variable.in_unit(error))
        };
        let error = |end: End| number::error(variable.in_unit(end.error));
        let place = |end: End| {
            let (here, there) = (place(end.time), place(end.time + end.blur));
            number::with_error(here, (there - here).abs().max(1e-8 * here.abs()))
        };
        table.row([
            variable.name.clone(),
            value(extremes.lowest),
            error(extremes.lowest),
            place(extremes.lowest),
            value(extremes.highest),
            error(extremes.highest),
            place(extremes.highest),
            variable.unit.clone(),
        ]);
    }
    let over = if report.is_cycle() {
        format!("Over the {}", report.case.turn().one())
    } else {
        "Over the run".to_owned()
    };
    page.section(&over, &table);
}
