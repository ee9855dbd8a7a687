//! The positions of a linkage as comma-separated values: one heading with names and units, one row a position, no
//! comments. Columns: the time if it runs, the drivers, every variable, the transmission angle of each group; empty cells
//! where the linkage does not get. With `--rows limits` its limits instead, one number a row.

use assur::registry::Sample;

use super::case::Task;
use super::group;
use super::reach;
use super::report::Report;
use super::search::Extreme;
use crate::csv::{cell, title};
use crate::unit;
use crate::values::TIME;

/// The whole table; a scene without a task gives the places of `--at`.
pub fn render(report: &Report) -> String {
    let case = &report.case;
    let timed = matches!(case.task, Task::Time(_));
    let mut heading = Vec::new();
    if timed {
        heading.push(title(TIME.name, TIME.unit));
    }
    heading.extend(case.drivers.iter().map(|driver| title(driver.name, driver.unit)));
    heading.extend(case.variables.iter().map(|one| title(&one.name, &one.unit)));
    for (_, of_group) in transmitting(report) {
        let name = format!("transmission({})", group::equations(case.entry, of_group));
        heading.push(title(&name, "deg"));
    }
    let mut text = heading.join(",") + "\n";
    for line in &report.lines {
        for (station, sample) in line.stations.iter().zip(&line.samples) {
            let time = timed.then(|| station.first().copied()).flatten();
            text += &row(report, time, &case.place(station), sample.as_ref());
        }
    }
    if report.lines.is_empty() {
        for one in &report.places {
            text += &row(report, None, &one.place.independents, Some(&one.sample));
        }
    }
    text
}

/// Extremes, strokes, limit positions and the reach of the drivers: one row for each number.
pub fn limits(report: &Report) -> String {
    let case = &report.case;
    let timed = matches!(case.task, Task::Time(_));
    let drivers = case.drivers.iter();
    let time = timed.then(|| title(TIME.name, TIME.unit));
    let heading = ["name", "unit", "what", "value"].map(str::to_owned);
    let heading: Vec<_> = heading
        .into_iter()
        .chain(time)
        .chain(drivers.map(|driver| title(driver.name, driver.unit)))
        .collect();
    let mut text = heading.join(",") + "\n";
    let empty = || vec![String::new(); case.drivers.len() + usize::from(timed)];
    let at = |extreme: &Extreme| {
        let time = timed.then(|| extreme.station.first().copied()).flatten();
        let time = time.into_iter().map(cell);
        let drivers = case.drivers.iter().zip(&extreme.independents);
        time.chain(drivers.map(|(driver, position)| cell(unit::stated(*position, driver.factor))))
            .collect()
    };
    let mut row = |(name, unit): (&str, &str), what: &str, value: f64, at: Vec<String>| {
        let start = [title(name, ""), unit.to_owned(), what.to_owned(), bounded(value)];
        text += &(start.into_iter().chain(at).collect::<Vec<_>>().join(",") + "\n");
    };
    for (variable, limits) in case.variables.iter().zip(&report.limits) {
        let Some((low, high)) = limits else { continue };
        let named = (variable.name.as_str(), variable.unit.as_str());
        row(named, "minimum", variable.in_unit(low.value), at(low));
        row(named, "maximum", variable.in_unit(high.value), at(high));
        let stroke = variable.in_unit(high.value - low.value);
        row(named, "stroke", stroke, empty());
        let Some(stroke) = reach::stroke(case, report.strokes.as_ref(), variable) else {
            continue;
        };
        for turn in reach::turns(case, stroke) {
            let value = variable.in_unit(turn.place.value);
            row(named, turn.kind(), value, at(&turn.place));
        }
        for gap in reach::gaps(case, stroke) {
            let [before, after] = [gap.place.value, gap.after].map(|one| variable.in_unit(one));
            row(named, &format!("before {}", gap.kind()), before, at(&gap.place));
            row(named, &format!("after {}", gap.kind()), after, at(&gap.place));
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
            row((driver.name, driver.unit), &what, value, empty());
        }
    }
    text
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
    let mut cells: Vec<_> = time.into_iter().map(cell).collect();
    let drivers = case.drivers.iter().zip(place);
    cells.extend(drivers.map(|(driver, position)| cell(unit::stated(*position, driver.factor))));
    let values = match sample {
        Some(sample) => case.values(sample),
        None => vec![f64::NAN; case.variables.len()],
    };
    let variables = case.variables.iter().zip(values);
    cells.extend(variables.map(|(variable, value)| cell(variable.in_unit(value))));
    let angles = transmitting(report).map(|(index, _)| match sample {
        Some(sample) => cell(group::transmission(sample.sines[index])),
        None => String::new(),
    });
    cells.extend(angles);
    cells.join(",") + "\n"
}

/// The groups that have a transmission angle.
fn transmitting(report: &Report) -> impl Iterator<Item = (usize, &'static assur::closure::Group)> {
    let groups = report.case.entry.groups.iter().enumerate();
    groups.filter(|(_, of_group)| group::transmits(of_group))
}
