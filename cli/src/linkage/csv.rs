//! A linkage as comma-separated values.

use assur::closure::{Group, Sample};

use super::case::Task;
use super::group;
use super::reach;
use super::report::Report;
use super::search::Extreme;
use crate::ask::values::TIME;
use crate::ask::variables::Variable;
use crate::show::csv::{cell, cells, line, title, titles};
use crate::show::unit;

/// The positions over the task, one a row; a scene without a task gives the places of `--at`. Columns: the time if it runs,
/// the drivers, every variable, the transmission angle of each group; empty cells where the linkage does not get.
pub fn render(report: &Report) -> String {
    let case = &report.case;
    let variables = case.variables.iter().map(|one| title(&one.name, &one.unit));
    let angles = transmitting(report).map(|(_, of_group)| {
        let loops = group::equations(case.moved.entry, of_group);
        title(&format!("transmission({loops})"), "deg")
    });
    let drivers = titles(&case.drivers);
    let mut text =
        line(time_title(report).into_iter().chain(drivers).chain(variables).chain(angles));
    for along in &report.lines {
        for (station, sample) in along.stations.iter().zip(&along.samples) {
            text += &row(report, time(report, station), &case.place(station), sample.as_ref());
        }
    }
    if report.lines.is_empty() {
        for one in &report.places {
            text += &row(report, None, &one.place.independents, Some(&one.sample));
        }
    }
    text
}

/// The heading of the time, where the drivers move in it.
fn time_title(report: &Report) -> Option<String> {
    let is_timed = matches!(report.case.moved.task, Task::Time(_));
    is_timed.then(|| title(TIME.name, TIME.unit))
}

/// The time of a station, where the drivers move in it.
fn time(report: &Report, station: &[f64]) -> Option<f64> {
    let is_timed = matches!(report.case.moved.task, Task::Time(_));
    station.first().copied().filter(|_| is_timed)
}

/// Extremes, strokes, limit positions and the reach of the drivers: one row for each number, with the name, the unit, what it
/// is, and where.
pub fn limits(report: &Report) -> String {
    let case = &report.case;
    let heading = ["name", "unit", "what", "value"].map(str::to_owned);
    let heading = heading.into_iter().chain(time_title(report)).chain(titles(&case.drivers));
    let mut text = line(heading);
    for (variable, limits) in case.variables.iter().zip(&report.limits) {
        if let Some((low, high)) = limits {
            text += &of_variable(report, variable, (low, high));
        }
    }
    for reach in &report.reach {
        let driver = &case.drivers[reach.driver];
        let Ok(found) = &reach.stretch else { continue };
        for (word, end) in [("from", &found.low), ("to", &found.high)] {
            let what = match (reach.turns, end.dead) {
                (true, _) => continue,
                (false, Some(_)) => format!("dead point {word}"),
                (false, None) => format!("reach {word}"),
            };
            let value = unit::stated(end.at, driver.factor);
            text += &limit(report, (driver.name, driver.unit), &what, value, None);
        }
    }
    text
}

/// All rows of a variable.
fn of_variable(report: &Report, variable: &Variable, (low, high): (&Extreme, &Extreme)) -> String {
    let case = &report.case;
    let row = |what: &str, value: f64, at: Option<&Extreme>| {
        let named = (variable.name.as_str(), variable.unit.as_str());
        limit(report, named, what, variable.in_unit(value), at)
    };
    let mut text = row("minimum", low.value, Some(low))
        + &row("maximum", high.value, Some(high))
        + &row("stroke", high.value - low.value, None);
    if let Some(stroke) = reach::stroke(case, report.strokes.as_ref(), variable) {
        for turn in reach::turns(case, stroke) {
            text += &row(turn.kind(), turn.place.value, Some(&turn.place));
        }
        for gap in reach::gaps(case, stroke) {
            text += &row(&format!("before {}", gap.kind()), gap.place.value, Some(&gap.place));
            text += &row(&format!("after {}", gap.kind()), gap.after, Some(&gap.place));
        }
    }
    text
}

/// A row of [`limits`].
fn limit(
    report: &Report,
    (name, unit): (&str, &str),
    what: &str,
    value: f64,
    at: Option<&Extreme>,
) -> String {
    let drivers = &report.case.drivers;
    let empty = || vec![String::new(); drivers.len() + time_title(report).iter().len()];
    let place = at.map_or_else(empty, |at| {
        let time = time(report, &at.station).map(cell).into_iter();
        time.chain(cells(drivers, &at.independents)).collect()
    });
    let start = [title(name, ""), unit.to_owned(), what.to_owned(), bounded(value)];
    line(start.into_iter().chain(place))
}

/// A number, `inf` or `-inf` beyond all bounds.
fn bounded(value: f64) -> String {
    match value.is_infinite() {
        true => value.to_string(),
        false => cell(value),
    }
}

fn row(report: &Report, time: Option<f64>, place: &[f64], sample: Option<&Sample>) -> String {
    let case = &report.case;
    let values = match sample {
        Some(sample) => case.values(sample),
        None => vec![f64::NAN; case.variables.len()],
    };
    let variables = case.variables.iter().zip(values);
    let variables = variables.map(|(variable, value)| cell(variable.in_unit(value)));
    let angles = transmitting(report).map(|(index, _)| match sample {
        Some(sample) => cell(group::transmission(sample.sines[index])),
        None => String::new(),
    });
    let drivers = cells(&case.drivers, place);
    line(time.into_iter().map(cell).chain(drivers).chain(variables).chain(angles))
}

/// The groups that have a transmission angle.
fn transmitting(report: &Report) -> impl Iterator<Item = (usize, &'static Group)> {
    let groups = report.case.moved.entry.groups.iter().enumerate();
    groups.filter(|(_, of_group)| group::transmits(of_group))
}
