//! The answer of `assur run` about a linkage as tables to read.

mod limits;
mod place;

use std::path::Path;

use assur::closure::Sample;

use super::case::Task;
use super::report::Report;
use super::search::Extreme;
use crate::ask::case::amount;
use crate::ask::variables::Variable;
use crate::published;
use crate::show::measures;
use crate::show::number;
use crate::show::page::{Page, WIDTH, first_line};
use crate::show::text::{Align, Columns, wrap};

/// Digits of the largest value of a column.
const DIGITS: i32 = 7;
/// Beside values of the same kind this part of them is rounding.
const NOISE: f64 = 1e-9;

/// All tables.
pub fn render(page: &mut Page, report: &Report, figure: Option<&Path>) {
    let constants = &report.case.constants;
    page.about(constants, &report.case.task_in_words());
    if let Some(note) = &report.note {
        page.warn(note);
        page.line("");
    }
    drivers(page, report);
    page.parameters(constants);
    positions(page, report);
    limits::sections(page, report);
    measures::section(page, report.case.scene, &report.measures);
    met(page, report);
    for place in &report.places {
        place::section(page, report, place);
    }
    published::section(page, &report.published);
    page.figure(figure);
    status(page, report);
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
        let range = &case.moved.ranges[index];
        let summary = first_line(driver.summary).to_owned();
        let show = |value: f64| match value.is_finite() {
            true => amount(driver, value),
            false => String::new(),
        };
        let cells = match &case.moved.task {
            Task::Time(span) => {
                let (from, to) = span.limits();
                let ends = [from, to].map(|time| show(case.place(&[time])[index]));
                [ends[0].clone(), ends[1].clone(), String::new()]
            }
            _ if range.from == range.to => ["".to_owned(), "stands".to_owned(), show(range.start)],
            _ => [range.from, range.to, range.start].map(show),
        };
        table.row([driver.name.to_owned()].into_iter().chain(cells).chain([summary]));
    }
    page.section(if case.is_sheet() { "Ranges" } else { "Drivers" }, &table);
}

/// The variables at round positions.
fn positions(page: &mut Page, report: &Report) {
    let case = &report.case;
    if report.rows.is_empty() {
        return;
    }
    let axes = case.axes();
    let timed = matches!(case.moved.task, Task::Time(_));
    // Where time runs the drivers are of interest as well.
    let driven = if timed { &case.drivers[..] } else { &[] };
    let with_unit = |name: &str, unit: &str| match unit {
        "" => name.to_owned(),
        _ => format!("{name}, {unit}"),
    };
    let of_axes = axes.iter().map(|axis| with_unit(axis.quantity.name, axis.quantity.unit));
    let of_drivers = driven.iter().map(|driver| with_unit(driver.name, driver.unit));
    let of_variables = case.variables.iter().map(|one| with_unit(&one.name, &one.unit));
    let headings: Vec<_> = of_axes.chain(of_drivers).chain(of_variables).collect();
    let mut table = Columns::new(headings.iter().map(|heading| (heading.as_str(), Align::Point)));
    let decimals = decimals(report);
    for (index, line) in report.rows.iter().enumerate() {
        if index > 0 && report.rows.len() > 1 {
            table.row([]);
        }
        for (station, sample) in line.stations.iter().zip(&line.samples) {
            let axes = axes.iter().zip(station);
            let mut row: Vec<_> =
                axes.map(|(axis, value)| number::short(value / axis.quantity.factor)).collect();
            let place = if timed { case.place(station) } else { Vec::new() };
            let driven = driven.iter().zip(&place);
            row.extend(driven.map(|(driver, position)| number::short(position / driver.factor)));
            row.extend(cells(report, sample.as_ref(), &decimals));
            table.row(row);
        }
    }
    page.section(if case.is_sheet() { "Values" } else { "Positions" }, &table);
}

/// Decimals of each variable: so many that the largest value has its digits; none where an exponent is needed. What is
/// rounding beside others of its kind has as many as they.
fn decimals(report: &Report) -> Vec<Option<usize>> {
    let most = |limits: &Option<(Extreme, Extreme)>| {
        let ends = limits.as_ref().map(|(low, high)| low.value.abs().max(high.value.abs()));
        ends.filter(|most| most.is_finite()).unwrap_or(0.0)
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
    columns.map(|((variable, value), decimals)| fixed(variable.in_unit(value), *decimals)).collect()
}

fn fixed(value: f64, decimals: Option<usize>) -> String {
    match decimals {
        _ if !value.is_finite() => "none".to_owned(),
        Some(decimals) => {
            let text = format!("{value:.decimals$}");
            let zero = text.chars().all(|one| matches!(one, '-' | '0' | '.'));
            if zero { text.trim_start_matches('-').to_owned() } else { text }
        }
        None => number::significant(value, DIGITS as usize),
    }
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
            let of = &report.case.moved.entry.loops[index];
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
    let (places, closed) = match report.case.is_sheet() {
        true => ("places", "evaluated"),
        false => ("positions", "closed"),
    };
    let share = match report.is_complete() {
        true if cost.positions == 0 => format!("Closed in {}", number::duration(cost.total)),
        true => {
            format!("Complete: {positions} {places} {closed} in {}", number::duration(cost.closing))
        }
        false => format!(
            "Incomplete: {positions} of {} {places} {closed} in {}",
            number::count(cost.positions),
            number::duration(cost.closing)
        ),
    };
    let known = match cost.doubt {
        0.0 => String::new(),
        doubt => format!("; integrals known to {} of what they sum up", number::error(doubt)),
    };
    page.line(&format!("{share}{left}{known}."));
}
