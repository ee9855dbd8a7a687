//! A motion as comma-separated values.

use super::events;
use super::report::Report;
use crate::ask::values::TIME;
use crate::show::csv::{cell, cells, line, quoted, title, titles};
use crate::show::unit;

/// The curves over the task, one row a sample; a scene without a task gives the places of `--at`. Samples are even in time,
/// and there are those of short steps of the solution and of all extremes. Columns: the time, the mode if there are modes,
/// the drivers, then every variable. An event has two rows, right before and after it.
pub fn render(report: &Report) -> String {
    let case = &report.case;
    let has_modes = case.scene.modes.iter().any(|mode| !mode.name.is_empty());
    let mode = |time: f64| has_modes.then(|| case.mode(report.motion.place(time).0).to_owned());
    let row = |time: f64, drivers: &[f64], values: &[f64]| {
        let values = values.iter().zip(&case.variables);
        let values = values.map(|(value, variable)| cell(variable.in_unit(*value)));
        let start = [cell(time)].into_iter().chain(mode(time));
        line(start.chain(cells(&case.drivers, drivers)).chain(values))
    };
    let variables = case.variables.iter().map(|one| title(&one.name, &one.unit));
    let start = [title(TIME.name, TIME.unit)].into_iter();
    let start = start.chain(has_modes.then(|| "mode".to_owned()));
    let mut text = line(start.chain(titles(&case.drivers)).chain(variables));
    let curves = &report.curves;
    let samples = curves.times.iter().zip(&curves.drivers).zip(&curves.values);
    text.extend(samples.map(|((time, drivers), values)| row(*time, drivers, values)));
    if curves.times.is_empty() {
        let rest = report.motion.rest().map(|_| &report.start);
        let places = rest.into_iter().chain(&report.places);
        text.extend(places.map(|place| row(place.time, &place.drivers, &place.values)));
    }
    text
}

/// The events in their order: time, statement, names of the modes before and after it, each state before and after it,
/// and what is left of the guard, in a unit of its own.
pub fn events(report: &Report) -> String {
    let states = report.case.scene.states;
    let heading = [title(TIME.name, TIME.unit), "event".into(), "from".into(), "to".into()];
    let both = states.iter().flat_map(|state| {
        ["before", "after"].map(|when| title(&format!("{} {when}", state.name), state.unit))
    });
    let guard = ["guard", "guard unit"].map(str::to_owned);
    let mut text = line(heading.into_iter().chain(both).chain(guard));
    for (event, entry, _) in events::happened(report) {
        let modes = [event.from, event.to].map(|mode| quoted(report.case.mode(mode)));
        let start = [cell(event.time), quoted(entry.text)].into_iter().chain(modes);
        let before = cells(states, &event.before);
        let both = before.zip(cells(states, &event.after)).flat_map(|(a, b)| [a, b]);
        let guard = [cell(unit::stated(event.guard, entry.factor)), quoted(entry.unit)];
        text += &line(start.chain(both).chain(guard));
    }
    text
}
