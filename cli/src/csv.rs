//! The curves over the task as comma-separated values (RFC 4180): one heading with names and units, one row a sample,
//! no comments. Samples are even in time, and there are those of short steps of the solution and of all extremes. Columns: the time, the mode if there are modes, the drivers, then every variable; numbers with all the
//! digits of a double. An event has two rows, right before and after it. With `--rows events` the events instead, one a
//! row.

use crate::events;
use crate::report::Report;
use crate::unit;
use crate::values::TIME;

/// The whole table; a scene without a task gives the places of `--at`.
pub fn render(report: &Report) -> String {
    let scene = report.case.scene;
    let variables = &report.case.variables;
    let mut heading = vec![title(TIME.name, TIME.unit)];
    let has_modes = scene.modes.iter().any(|mode| !mode.name.is_empty());
    if has_modes {
        heading.push("mode".to_owned());
    }
    heading.extend(scene.drivers.iter().map(|driver| title(driver.name, driver.unit)));
    heading.extend(variables.iter().map(|variable| title(&variable.name, &variable.unit)));
    let mut text = heading.join(",") + "\n";
    let curves = &report.curves;
    let row = |time: f64, drivers: &[f64], values: &[f64]| {
        let mut cells = vec![cell(time)];
        if has_modes {
            let (mode, _) = report.motion.place(time);
            cells.push(report.case.mode(mode).to_owned());
        }
        cells.extend(
            drivers
                .iter()
                .zip(scene.drivers)
                .map(|(value, driver)| cell(unit::stated(*value, driver.factor))),
        );
        cells.extend(
            values.iter().zip(variables).map(|(value, variable)| cell(variable.in_unit(*value))),
        );
        cells.join(",") + "\n"
    };
    for (index, time) in curves.times.iter().enumerate() {
        text += &row(*time, &curves.drivers[index], &curves.values[index]);
    }
    if curves.times.is_empty() {
        for place in &report.places {
            text += &row(place.time, &place.drivers, &place.values);
        }
    }
    text
}

/// The events in their order: time, statement, names of the modes before and after it, each state before and after it,
/// and what is left of the guard, in a unit of its own.
pub fn events(report: &Report) -> String {
    let states = report.case.scene.states;
    let mut heading: Vec<_> = ["event", "from", "to"].map(str::to_owned).into();
    heading.insert(0, title(TIME.name, TIME.unit));
    for state in states {
        let when = |when: &str| title(&format!("{} {when}", state.name), state.unit);
        heading.extend([when("before"), when("after")]);
    }
    heading.extend(["guard", "guard unit"].map(str::to_owned));
    let mut text = heading.join(",") + "\n";
    for (event, entry, _) in events::happened(report) {
        let (from, to) = (report.case.mode(event.from), report.case.mode(event.to));
        let mut cells = vec![cell(event.time), quoted(entry.text), quoted(from), quoted(to)];
        let values = event.before.iter().zip(&event.after).zip(states);
        cells.extend(values.flat_map(|((before, after), state)| {
            [cell(unit::stated(*before, state.factor)), cell(unit::stated(*after, state.factor))]
        }));
        cells.extend([cell(unit::stated(event.guard, entry.factor)), quoted(entry.unit)]);
        text += &(cells.join(",") + "\n");
    }
    text
}

/// A name with its unit, as a heading.
pub fn title(name: &str, unit: &str) -> String {
    let title = if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
    quoted(&title)
}

/// A text as a cell.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// A number; an empty cell where there is none.
pub fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_with_commas_are_quoted() {
        assert_eq!(title("inner(u, v)", "m"), "\"inner(u, v) [m]\"");
        assert_eq!(title("x3", ""), "x3");
        assert_eq!(quoted("say \"a\"\nb"), "\"say \"\"a\"\"\nb\"");
    }

    #[test]
    fn missing_numbers_are_empty() {
        assert_eq!(cell(f64::NAN), "");
        assert_eq!(cell(0.1), "0.1");
    }
}
