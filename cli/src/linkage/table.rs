//! The answer of `assur run` about a linkage as tables to read.

use std::path::Path;

use assur::registry::Sample;

use super::case::{Task, amount};
use super::group;
use super::influence::unit_of;
use super::reach;
use super::report::{Report, Snapshot, task};
use super::search::Extreme;
use super::wording::dead_point;
use crate::number;
use crate::style::Style;
use crate::table::{Page, WIDTH, about, parameters, published};
use crate::text::{Align, Columns, wrap};
use crate::values::TIME;
use crate::variables::Variable;

/// Digits of the largest value of a column.
const DIGITS: i32 = 7;
/// Beside values of the same kind this part of them is rounding.
const NOISE: f64 = 1e-9;
/// Digits of what is known to the last.
const EXACT: usize = 10;
/// A transmission angle below which a linkage transmits forces badly.
const POOR: f64 = 30.0;

/// All tables, with the last line ended.
pub fn render(report: &Report, figure: Option<&Path>, style: Style) -> String {
    let mut page = Page::new(style);
    let title = format!(
        "{}, scene {}: {}",
        report.mechanism.title,
        report.case.scene.name,
        task(&report.case)
    );
    about(&mut page, &title, &report.case.constants);
    drivers(&mut page, report);
    parameters(&mut page, &report.case.constants);
    positions(&mut page, report);
    limits(&mut page, report);
    turns(&mut page, report);
    reach(&mut page, report);
    transmissions(&mut page, report);
    met(&mut page, report);
    for place in &report.places {
        snapshot(&mut page, report, place);
    }
    published::section(&mut page, &report.published);
    if let Some(path) = figure {
        page.line(&format!("Figure: {}", path.display()));
    }
    status(&mut page, report);
    page.text
}

fn drivers(page: &mut Page, report: &Report) {
    let case = &report.case;
    let mut table = Columns::new([
        ("", Align::Left),
        ("from", Align::Right),
        ("to", Align::Right),
        ("starts at", Align::Right),
        ("", Align::Left),
    ]);
    for (index, driver) in case.drivers.iter().enumerate() {
        let range = &case.ranges[index];
        let summary = driver.summary.lines().next().unwrap_or("").to_owned();
        let show = |value: f64| match value.is_finite() {
            true => amount(driver, value),
            false => String::new(),
        };
        let cells = match &case.task {
            Task::Time(span) => {
                let (from, to) = span.limits();
                let ends = [from, to].map(|time| show(case.place(&[time])[index]));
                [ends[0].clone(), ends[1].clone(), String::new()]
            }
            _ if range.from == range.to => ["".to_owned(), "stands".to_owned(), show(range.start)],
            _ => [range.from, range.to, range.start].map(show),
        };
        table.row(
            [driver.name.to_owned()]
                .into_iter()
                .chain(cells)
                .chain([summary]),
        );
    }
    page.section("Drivers", &table);
    page.line("");
}

/// The variables at round positions.
fn positions(page: &mut Page, report: &Report) {
    let case = &report.case;
    if report.rows.is_empty() {
        return;
    }
    let axes = case.axes();
    let timed = matches!(case.task, Task::Time(_));
    // Where time runs the drivers are of interest as well.
    let driven = if timed { &case.drivers[..] } else { &[] };
    let with_unit = |name: &str, unit: &str| match unit {
        "" => name.to_owned(),
        _ => format!("{name}, {unit}"),
    };
    let of_axes = axes
        .iter()
        .map(|axis| with_unit(axis.quantity.name, axis.quantity.unit));
    let of_drivers = driven
        .iter()
        .map(|driver| with_unit(driver.name, driver.unit));
    let of_variables = case
        .variables
        .iter()
        .map(|one| with_unit(&one.name, &one.unit));
    let headings: Vec<_> = of_axes.chain(of_drivers).chain(of_variables).collect();
    let mut table = Columns::new(
        headings
            .iter()
            .map(|heading| (heading.as_str(), Align::Point)),
    );
    let decimals = decimals(report);
    for (index, line) in report.rows.iter().enumerate() {
        if index > 0 && report.rows.len() > 1 {
            table.row([]);
        }
        for (station, sample) in line.stations.iter().zip(&line.samples) {
            let axes = axes.iter().zip(station);
            let mut row: Vec<_> = axes
                .map(|(axis, value)| number::short(value / axis.quantity.factor))
                .collect();
            let place = if timed {
                case.place(station)
            } else {
                Vec::new()
            };
            let driven = driven.iter().zip(&place);
            row.extend(driven.map(|(driver, position)| number::short(position / driver.factor)));
            row.extend(cells(report, sample.as_ref(), &decimals));
            table.row(row);
        }
    }
    page.section("Positions", &table);
    page.line("");
}

/// Decimals of each variable: so many that the largest value has its digits; none where an exponent is needed. What is
/// rounding beside others of its kind has as many as they.
fn decimals(report: &Report) -> Vec<Option<usize>> {
    let most = |limits: &Option<(Extreme, Extreme)>| {
        let ends = limits
            .as_ref()
            .map(|(low, high)| low.value.abs().max(high.value.abs()));
        ends.unwrap_or(0.0)
    };
    let variables = &report.case.variables;
    let of = |(variable, limits): (&Variable, &Option<(Extreme, Extreme)>)| {
        let all = variables.iter().zip(&report.limits);
        let alike = all.filter(|(other, _)| other.dimension == variable.dimension);
        let floor = NOISE * alike.map(|(_, limits)| most(limits)).fold(0.0, f64::max);
        let size = match most(limits) {
            size if size < floor => floor / NOISE,
            size => size,
        };
        let exponent = number::exponent(variable.in_unit(size));
        let plain = size > 0.0 && (-4..7).contains(&exponent);
        plain.then(|| (DIGITS - 1 - exponent).max(0) as usize)
    };
    variables.iter().zip(&report.limits).map(of).collect()
}

fn cells(report: &Report, sample: Option<&Sample>, decimals: &[Option<usize>]) -> Vec<String> {
    let case = &report.case;
    let Some(sample) = sample else {
        return vec!["-".to_owned(); case.variables.len()];
    };
    let values = case.values(sample);
    let columns = case.variables.iter().zip(values).zip(decimals);
    columns
        .map(|((variable, value), decimals)| fixed(variable.in_unit(value), *decimals))
        .collect()
}

fn fixed(value: f64, decimals: Option<usize>) -> String {
    match decimals {
        _ if !value.is_finite() => "none".to_owned(),
        Some(decimals) => {
            let text = format!("{value:.decimals$}");
            let zero = text.chars().all(|one| matches!(one, '-' | '0' | '.'));
            if zero {
                text.trim_start_matches('-').to_owned()
            } else {
                text
            }
        }
        None => number::significant(value, DIGITS as usize),
    }
}

/// A place of the task, one text for each of its axes.
fn station(report: &Report, extreme: &Extreme) -> String {
    let axes = report.case.axes();
    let parts = axes.iter().zip(&extreme.station).map(|(axis, value)| {
        // An extreme is known to half of the digits only.
        number::short(number::rounded(value / axis.quantity.factor, 6))
    });
    let mut parts: Vec<_> = parts.collect();
    if let (Task::Time(_), Some(driver)) = (&report.case.task, report.case.drivers.first()) {
        let position = extreme.independents.first().copied().unwrap_or(f64::NAN);
        parts = vec![number::short(number::rounded(position / driver.factor, 6))];
    }
    parts.join(", ")
}

/// What [`station`] gives, with units.
fn station_heading(report: &Report) -> String {
    let case = &report.case;
    let quantities: Vec<_> = match &case.task {
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
    let align = if report.case.axes().len() > 1 {
        Align::Left
    } else {
        Align::Point
    };
    let mut table = Columns::new([
        ("", Align::Left),
        ("smallest", Align::Point),
        (&place, align),
        ("largest", Align::Point),
        (&place, align),
        ("stroke", Align::Point),
        ("unit", Align::Left),
        ("", Align::Left),
    ]);
    let decimals = decimals(report);
    let rows = report
        .case
        .variables
        .iter()
        .zip(&report.limits)
        .zip(decimals);
    for ((variable, limits), decimals) in rows {
        let Some((low, high)) = limits else { continue };
        let show = |extreme: &Extreme| fixed(variable.in_unit(extreme.value), decimals);
        table.row([
            variable.name.clone(),
            show(low),
            station(report, low),
            show(high),
            station(report, high),
            fixed(variable.in_unit(high.value - low.value), decimals),
            variable.unit.clone(),
            variable.summary.clone(),
        ]);
    }
    if report.limits.iter().any(Option::is_some) {
        page.section("Limits", &table);
        page.line("");
    }
}

/// Where outputs turn round inside the range.
fn turns(page: &mut Page, report: &Report) {
    let case = &report.case;
    let Some(driver) = reach::swept(case).map(|index| &case.drivers[index]) else {
        return;
    };
    let place = format!("at {}, {}", driver.name, driver.unit);
    let mut table = Columns::new([
        ("", Align::Left),
        ("", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        (place.trim_end_matches(", "), Align::Point),
    ]);
    let mut count = 0;
    for variable in &case.variables {
        let stroke = reach::stroke(report.strokes.as_ref(), variable);
        let turns = stroke.map(|stroke| reach::turns(case, stroke));
        for turn in turns.unwrap_or_default() {
            let kind = if turn.is_largest { "highest" } else { "lowest" };
            table.row([
                variable.name.clone(),
                kind.to_owned(),
                number::significant(variable.in_unit(turn.value), EXACT),
                variable.unit.clone(),
                number::significant(turn.at / driver.factor, EXACT),
            ]);
            count += 1;
        }
    }
    if count > 0 {
        page.section("Limit positions, where an output turns round", &table);
        page.line("");
    }
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
        let ends = [
            (name, "from", &found.low),
            (String::new(), "to", &found.high),
        ];
        for (name, word, end) in ends {
            table.row([
                name,
                word.to_owned(),
                number::significant(end.at / driver.factor, EXACT),
                driver.unit.to_owned(),
                match end.dead {
                    Some(group) => dead_point(case.entry, group),
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
    page.line("");
}

fn transmissions(page: &mut Page, report: &Report) {
    if report.transmissions.is_empty() {
        return;
    }
    let place = station_heading(report);
    let align = if report.case.axes().len() > 1 {
        Align::Left
    } else {
        Align::Point
    };
    let mut table = Columns::new([
        ("loops", Align::Left),
        ("for", Align::Left),
        ("solved as", Align::Left),
        ("smallest, deg", Align::Point),
        (&place, align),
        ("", Align::Left),
    ]);
    for (index, worst) in &report.transmissions {
        let of_group = &report.case.entry.groups[*index];
        let angle = group::transmission(worst.value);
        let remark = match angle {
            angle if angle < 1e-3 => "in line: no force is transmitted",
            angle if angle < 10.0 => "near a dead point",
            angle if angle < POOR => "transmits forces badly",
            _ => "",
        };
        table.row([
            group::equations(report.case.entry, of_group),
            group::unknowns(report.case.entry, of_group),
            group::kind(of_group.kind).to_owned(),
            format!("{angle:.3}"),
            station(report, worst),
            remark.to_owned(),
        ]);
    }
    page.section(
        "Transmission angle (90 deg is best, 0 a dead point)",
        &table,
    );
    page.line("");
}

fn met(page: &mut Page, report: &Report) {
    if report.met.is_empty() {
        return;
    }
    let mut table = Columns::new([("", Align::Left); 2]);
    for (place, event) in &report.met {
        table.row([place.clone(), event.clone()]);
    }
    page.section("On the way", &table);
    page.line("");
}

fn snapshot(page: &mut Page, report: &Report, snapshot: &Snapshot) {
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
        ("", Align::Left),
    ]);
    for (variable, value) in case.variables.iter().zip(case.values(&snapshot.sample)) {
        let value = variable.in_unit(value);
        table.row([
            variable.name.clone(),
            number::with_error(value, 1e-9 * value.abs()),
            variable.unit.clone(),
            variable.summary.clone(),
        ]);
    }
    for (index, of_group) in case.entry.groups.iter().enumerate() {
        if group::transmits(of_group) {
            let angle = group::transmission(snapshot.sample.sines[index]);
            table.row([
                "transmission".to_owned(),
                number::short(number::rounded(angle, 6)),
                "deg".to_owned(),
                group::equations(case.entry, of_group),
            ]);
        }
    }
    page.section(&format!("At {}{time}", snapshot.place.label), &table);
    for outside in &snapshot.place.outside {
        let line = page.style.warn(&format!("  {outside}"));
        page.line(&line);
    }
    page.line("");
    influence(page, report, snapshot);
}

/// What each driver and dimension does to the outputs.
fn influence(page: &mut Page, report: &Report, snapshot: &Snapshot) {
    let outputs = &report.case.variables[..report
        .case
        .scene
        .outputs
        .len()
        .min(report.case.variables.len())];
    let counts = |value: &f64| value.is_finite() && *value != 0.0;
    let rows: Vec<_> = snapshot
        .influence
        .iter()
        .filter(|row| row.values.iter().any(counts))
        .collect();
    if rows.is_empty() || outputs.is_empty() {
        return;
    }
    let columns = outputs
        .iter()
        .flat_map(|output| [(output.name.as_str(), Align::Point), ("", Align::Left)]);
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
    page.line("");
}

/// Whether it got everywhere, and what it cost.
fn status(page: &mut Page, report: &Report) {
    let stops = report.stops.iter().map(|stop| stop.place.as_str());
    let stops: Vec<_> = stops.filter(|place| !place.is_empty()).collect();
    for line in wrap(&format!("Stops at {}.", stops.join("; at ")), WIDTH) {
        if !stops.is_empty() {
            let line = page.style.warn(&line);
            page.line(&line);
        }
    }
    let cost = &report.cost;
    let left = match cost.gap {
        Some((index, gap)) => {
            let of = &report.case.entry.loops[index];
            format!(
                "; largest gap left in a loop {} {} ({})",
                number::error(gap / of.factor),
                of.unit,
                of.name
            )
        }
        None => String::new(),
    };
    let positions = number::count(cost.reached);
    let share = match report.is_complete() {
        true if cost.positions == 0 => format!("Closed in {}", number::duration(cost.total)),
        true => format!(
            "Complete: {positions} positions closed in {}",
            number::duration(cost.closing)
        ),
        false => format!(
            "Incomplete: {positions} of {} positions closed in {}",
            number::count(cost.positions),
            number::duration(cost.closing)
        ),
    };
    page.line(&format!("{share}{left}."));
}
