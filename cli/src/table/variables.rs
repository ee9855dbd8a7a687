//! All variables at one place, and their extremes over the task.

use super::Page;
use crate::number;
use crate::report::{Report, Snapshot};
use crate::text::{Align, Columns};

/// Everything at one place.
pub fn snapshot(page: &mut Page, report: &Report, snapshot: &Snapshot, heading: &str) {
    let mut table = Columns::new([
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("± error", Align::Left),
        ("", Align::Left),
    ]);
    let rows = report
        .case
        .variables
        .iter()
        .zip(&snapshot.values)
        .zip(&snapshot.errors);
    for ((variable, value), error) in rows {
        table.row([
            variable.name.clone(),
            number::with_error(variable.in_unit(*value), variable.in_unit(*error)),
            variable.unit.clone(),
            number::error(variable.in_unit(*error)),
            variable.summary.clone(),
        ]);
    }
    page.section(heading, &table);
    page.line("");
}

/// Smallest and largest values over the task, and where they occur.
pub fn extremes(page: &mut Page, report: &Report) {
    let place = match report.case.scene.drivers.first() {
        Some(driver) if driver.unit.is_empty() => format!("at {}", driver.name),
        Some(driver) => format!("at {}, {}", driver.name, driver.unit),
        None => "at time, s".to_owned(),
    };
    let mut table = Columns::new([
        ("", Align::Left),
        ("smallest", Align::Point),
        (&place, Align::Point),
        ("largest", Align::Point),
        (&place, Align::Point),
        ("unit", Align::Left),
    ]);
    let time = |time: f64| {
        let position = report.case.drivers(time).first().copied();
        let shown = match (position, report.case.scene.drivers.first()) {
            (Some(position), Some(driver)) => position / driver.factor,
            _ => time,
        };
        number::short(number::significant(shown, 5).parse().unwrap_or(shown))
    };
    for ((variable, extreme), error) in report
        .case
        .variables
        .iter()
        .zip(&report.extremes)
        .zip(&report.errors)
    {
        let show = |value: f64| {
            number::with_error(
                variable.in_unit(value),
                variable.in_unit(error.max(1e-8 * extreme.amplitude())),
            )
        };
        table.row([
            variable.name.clone(),
            show(extreme.minimum.1),
            time(extreme.minimum.0),
            show(extreme.maximum.1),
            time(extreme.maximum.0),
            variable.unit.clone(),
        ]);
    }
    let over = if report.is_cycle() {
        format!("Over the {}", report.case.turn().one())
    } else {
        "Over the run".to_owned()
    };
    page.section(&over, &table);
    page.line("");
}
