//! Limits of a linkage: extremes, limit positions, how far the drivers go, transmission angles.

use super::{decimals, fixed};
use crate::ask::values::TIME;
use crate::linkage::case::Task;
use crate::linkage::group;
use crate::linkage::reach;
use crate::linkage::report::Report;
use crate::linkage::search::Extreme;
use crate::linkage::wording::dead_point;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Digits of what is known to the last.
const EXACT: usize = 10;
/// A transmission angle below which a linkage transmits forces badly.
const POOR: f64 = 30.0;

/// All of them.
pub fn sections(page: &mut Page, report: &Report) {
    limits(page, report);
    turns(page, report);
    // Without loops nothing ends a range but the range.
    if !report.case.is_sheet() {
        reach(page, report);
    }
    transmissions(page, report);
}

/// A place of the task, one text for each of its axes.
fn station(report: &Report, extreme: &Extreme) -> String {
    let axes = report.case.axes();
    let parts = axes.iter().zip(&extreme.station).map(|(axis, value)| {
        // An extreme is known to half of the digits only.
        number::short(number::rounded(value / axis.quantity.factor, 6))
    });
    let mut parts: Vec<_> = parts.collect();
    if let (Task::Time(_), Some(driver)) = (&report.case.moved.task, report.case.drivers.first()) {
        let position = extreme.independents.first().copied().unwrap_or(f64::NAN);
        parts = vec![number::short(number::rounded(position / driver.factor, 6))];
    }
    parts.join(", ")
}

/// What [`station`] gives, with units.
fn station_heading(report: &Report) -> String {
    let case = &report.case;
    let quantities: Vec<_> = match &case.moved.task {
        Task::Time(_) => vec![case.drivers.first().copied().unwrap_or(TIME)],
        _ => case.axes().iter().map(|axis| axis.quantity).collect(),
    };
    let unit = quantities.first().map_or("", |first| first.unit);
    let alike = quantities.iter().all(|one| one.unit == unit);
    let names = quantities.iter().map(|one| match alike {
        true => one.name.to_owned(),
        false => format!("{} [{}]", one.name, one.unit),
    });
    let names = names.collect::<Vec<_>>().join(", ");
    match alike && !unit.is_empty() {
        true => format!("at {names}, {unit}"),
        false => format!("at {names}"),
    }
}

fn limits(page: &mut Page, report: &Report) {
    let place = station_heading(report);
    let align = if report.case.axes().len() > 1 { Align::Left } else { Align::Point };
    let mut table = Columns::new([
        ("", Align::Left),
        ("smallest", Align::Point),
        (&place, align),
        ("largest", Align::Point),
        (&place, align),
        ("stroke", Align::Point),
        ("± error", Align::Left),
        ("unit", Align::Left),
        ("", Align::Left),
    ]);
    let decimals = decimals(report);
    let rows = report.case.variables.iter().zip(&report.limits).zip(decimals).zip(&report.errors);
    for (((variable, limits), decimals), errors) in rows {
        let Some((low, high)) = limits else { continue };
        let show = |value: f64| match value.is_infinite() {
            true => "unbounded".to_owned(),
            false => fixed(variable.in_unit(value), decimals),
        };
        table.row([
            variable.name.clone(),
            show(low.value),
            station(report, low),
            show(high.value),
            station(report, high),
            show(high.value - low.value),
            rounding(variable.in_unit(errors.0.max(errors.1))),
            variable.unit.clone(),
            variable.summary.clone(),
        ]);
    }
    if report.limits.iter().any(Option::is_some) {
        page.section("Limits", &table);
    }
}

/// How far a value may be off, or nothing where that is not known.
pub(super) fn rounding(error: f64) -> String {
    if error.is_finite() { number::error(error) } else { String::new() }
}

/// Where outputs turn round inside the task, and where they jump or go beyond all bounds.
fn turns(page: &mut Page, report: &Report) {
    let case = &report.case;
    let place = station_heading(report);
    let mut turns = Columns::new([
        ("", Align::Left),
        ("", Align::Left),
        ("value", Align::Point),
        ("± error", Align::Left),
        ("unit", Align::Left),
        (&place, Align::Point),
    ]);
    let mut gaps = Columns::new([
        ("", Align::Left),
        ("", Align::Left),
        ("before", Align::Point),
        ("after", Align::Point),
        ("unit", Align::Left),
        (&place, Align::Point),
    ]);
    let (mut turning, mut broken) = (false, false);
    for (index, variable) in case.variables.iter().enumerate() {
        let Some(stroke) = reach::stroke(case, report.strokes.as_ref(), variable) else {
            continue;
        };
        let is_output = index < case.scene.outputs.len();
        for turn in reach::turns(case, stroke).iter().filter(|_| is_output) {
            turning = true;
            turns.row([
                variable.name.clone(),
                turn.kind().to_owned(),
                number::significant(variable.in_unit(turn.place.value), EXACT),
                rounding(variable.in_unit(report.error(&turn.place, index))),
                variable.unit.clone(),
                exactly(report, &turn.place),
            ]);
        }
        for gap in reach::gaps(case, stroke) {
            broken = true;
            let side = |value: f64| match value {
                f64::INFINITY => "+infinity".to_owned(),
                f64::NEG_INFINITY => "-infinity".to_owned(),
                value => number::significant(variable.in_unit(value), EXACT),
            };
            gaps.row([
                variable.name.clone(),
                gap.kind().to_owned(),
                side(gap.place.value),
                side(gap.after),
                variable.unit.clone(),
                exactly(report, &gap.place),
            ]);
        }
    }
    if turning {
        page.section("Limit positions, where an output turns round", &turns);
    }
    if broken {
        page.section("Jumps, poles and ends of what has a value", &gaps);
    }
}

/// A place of a task with one axis, to the last digits: of the first driver.
fn exactly(report: &Report, extreme: &Extreme) -> String {
    let case = &report.case;
    let value = match (&case.moved.task, case.drivers.first()) {
        (Task::Time(_), Some(driver)) => {
            extreme.independents.first().map(|position| position / driver.factor)
        }
        _ => {
            let axes = case.axes();
            let axis = axes.first().zip(extreme.station.first());
            axis.map(|(axis, value)| value / axis.quantity.factor)
        }
    };
    number::significant(value.unwrap_or(f64::NAN), EXACT)
}

/// How far the drivers go.
fn reach(page: &mut Page, report: &Report) {
    let case = &report.case;
    if report.reach.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("", Align::Left),
        ("", Align::Left),
        ("", Align::Point),
        ("", Align::Left),
        ("", Align::Left),
    ]);
    for reach in &report.reach {
        let driver = &case.drivers[reach.driver];
        let name = driver.name.to_owned();
        let found = match &reach.stretch {
            Ok(_) if reach.turns => {
                table.row([name, "turns all round".to_owned()]);
                continue;
            }
            Ok(found) => found,
            Err(told) => {
                let words = format!("not known: {}", told.reason);
                table.row([name, String::new(), String::new(), String::new(), words]);
                continue;
            }
        };
        let ends = [(name, "from", &found.low), (String::new(), "to", &found.high)];
        for (name, word, end) in ends {
            table.row([
                name,
                word.to_owned(),
                number::significant(end.at / driver.factor, EXACT),
                driver.unit.to_owned(),
                match end.dead {
                    Some(group) => dead_point(case.moved.entry, group),
                    None => "and farther".to_owned(),
                },
            ]);
        }
    }
    let heading = match report.reach.len() {
        1 => "Reach of the driver in this assembly mode",
        _ => "Reach of each driver in this assembly mode, the others standing where they start",
    };
    page.section(heading, &table);
}

fn transmissions(page: &mut Page, report: &Report) {
    if report.transmissions.is_empty() {
        return;
    }
    let place = station_heading(report);
    let align = if report.case.axes().len() > 1 { Align::Left } else { Align::Point };
    let mut table = Columns::new([
        ("loops", Align::Left),
        ("for", Align::Left),
        ("solved as", Align::Left),
        ("smallest, deg", Align::Point),
        (&place, align),
        ("", Align::Left),
    ]);
    for (index, worst) in &report.transmissions {
        let of_group = &report.case.moved.entry.groups[*index];
        let angle = group::transmission(worst.value);
        let remark = match angle {
            angle if angle < 1e-3 => "in line: no force is transmitted",
            angle if angle < 10.0 => "near a dead point",
            angle if angle < POOR => "transmits forces badly",
            _ => "",
        };
        table.row([
            group::equations(report.case.moved.entry, of_group),
            group::unknowns(report.case.moved.entry, of_group),
            group::kind(of_group.kind).to_owned(),
            format!("{angle:.3}"),
            station(report, worst),
            remark.to_owned(),
        ]);
    }
    page.section("Transmission angle (90 deg is best, 0 a dead point)", &table);
}
