//! The positions of a linkage as comma-separated values: one heading with names and units, one row a position, no
//! comments. Columns: the time if it runs, the drivers, every variable, the transmission angle of each group; empty cells
//! where the linkage does not get.

use assur::registry::Sample;

use super::case::Task;
use super::group;
use super::report::Report;
use crate::csv::{cell, title};
use crate::values::TIME;

/// The whole table; a scene without a task gives the places of `--at`.
pub fn render(report: &Report) -> String {
    let case = &report.case;
    let timed = matches!(case.task, Task::Time(_));
    let mut heading = Vec::new();
    if timed {
        heading.push(title(TIME.name, TIME.unit));
    }
    heading.extend(
        case.drivers
            .iter()
            .map(|driver| title(driver.name, driver.unit)),
    );
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

fn row(report: &Report, time: Option<f64>, place: &[f64], sample: Option<&Sample>) -> String {
    let case = &report.case;
    let mut cells: Vec<_> = time.into_iter().map(cell).collect();
    let drivers = case.drivers.iter().zip(place);
    cells.extend(drivers.map(|(driver, position)| cell(position / driver.factor)));
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
