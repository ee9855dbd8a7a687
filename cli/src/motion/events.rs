//! The modes of a motion and the events between them.

use assur::hybrid::Happened;
use assur::registry::SceneEntry;
use assur::shape::EventEntry;

use super::report::Report;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};
use crate::show::unit;

/// Most events that a table lists.
const MOST: usize = 40;

/// A stretch of the task in one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// The mode.
    pub mode: usize,
    /// Its name.
    pub name: &'static str,
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
}

/// The modes in their order; none where the scene has none.
pub fn bands(report: &Report) -> Vec<Band> {
    let case = &report.case;
    if case.scene.modes.iter().all(|mode| mode.name.is_empty()) {
        return Vec::new();
    }
    let (begin, end) = case.moved.task.limits();
    let (mut bands, mut from, mut mode) = (Vec::new(), begin, report.motion.first_mode());
    let events = report.motion.events().iter();
    let changes = events.filter(|event| event.to != event.from);
    for (time, next) in changes.map(|event| (event.time, event.to)).chain([(end, mode)]) {
        if time > from {
            bands.push(Band { mode, name: case.mode(mode), from, to: time });
        }
        (from, mode) = (time, next);
    }
    bands
}

/// Whether a scene states events; where a branch changes over is none.
pub fn are_stated(scene: &SceneEntry) -> bool {
    let mut events = scene.modes.iter().flat_map(|mode| mode.events);
    events.any(|entry| entry.surface.is_none())
}

/// What happened, in order, each with its statement and the error of its time.
pub fn happened(report: &Report) -> impl Iterator<Item = (&Happened, &'static EventEntry, f64)> {
    let modes = report.case.scene.modes;
    let events = report.motion.events().iter().zip(&report.events);
    events.filter_map(|(event, error)| {
        let entry = modes.get(event.from)?.events.get(event.event)?;
        entry.surface.is_none().then_some((event, entry, *error))
    })
}

/// Name of the mode in which the task begins; empty where there are no modes.
pub fn first_mode(report: &Report) -> &'static str {
    report.case.mode(report.motion.first_mode())
}

/// What happened, in order.
pub fn section(page: &mut Page, report: &Report) {
    if !are_stated(report.case.scene) {
        return;
    }
    let events: Vec<_> = happened(report).collect();
    let mut table = Columns::new([
        ("time, s", Align::Point),
        ("± error", Align::Left),
        ("mode", Align::Left),
        ("event", Align::Left),
        ("guard there", Align::Point),
        ("unit", Align::Left),
    ]);
    let first = first_mode(report);
    let (begin, _) = report.case.moved.task.limits();
    if !first.is_empty() {
        table.row([
            number::short(begin),
            String::new(),
            first.to_owned(),
            "start".to_owned(),
            String::new(),
            String::new(),
        ]);
    }
    let count = events.len();
    let left_out = count.saturating_sub(MOST);
    for (index, (event, entry, error)) in events.into_iter().enumerate() {
        if left_out > 0 && (MOST / 2..MOST / 2 + left_out).contains(&index) {
            continue;
        }
        table.row([
            number::with_error(event.time, error.max(1e-11 * event.time)),
            number::error(error),
            match event.to == event.from {
                true => String::new(),
                false => report.case.mode(event.to).to_owned(),
            },
            entry.text.to_owned(),
            number::error(unit::stated(event.guard, entry.factor)),
            entry.unit.to_owned(),
        ]);
    }
    let heading = match (count, left_out) {
        (0, _) => "Events: none".to_owned(),
        (count, 0) => format!("Events: {count}"),
        (count, left_out) => {
            format!(
                "Events: {count}, of which {left_out} in the middle are left out (--format json has all, and csv with --rows events)"
            )
        }
    };
    page.section(&heading, &table);
}
