//! How far each driver goes in the assembly mode of the start values, and the limit positions of the outputs.
//!
//! Both are found to the last digits: an end is a dead point, a limit position a zero of the rate of an output.

use std::f64::consts::TAU;

use assur::closure::{Along, Break, Extreme as Place, Sample, Stretch, Stroke};

use super::case::{Case, Task};
use super::line::Line;
use super::search::{Extreme, largest, smallest};
use crate::ask::variables::Variable;
use crate::error::Told;
use assur::shape::Subject;

/// A driver that does not turn is followed so many widths of its range beyond its ends.
const BEYOND: f64 = 10.0;

/// How far a driver goes, the others standing where they start.
pub struct Reach {
    /// Index of the driver.
    pub driver: usize,
    /// Its ends; or why they are not known.
    pub stretch: Result<Stretch, Told>,
    /// Whether it turns all round.
    pub turns: bool,
}

/// A turning point of an output inside its range.
pub struct Turn {
    /// Where it is, and the output there.
    pub place: Extreme,
    /// Whether the output is larger there than beside it.
    pub is_highest: bool,
}

impl Turn {
    /// What it is in a word.
    pub fn kind(&self) -> &'static str {
        if self.is_highest { "highest" } else { "lowest" }
    }
}

/// A place where an output jumps, goes beyond all bounds, or has no value.
pub struct Gap {
    /// Where it is. The value is what the output tends to below.
    pub place: Extreme,
    /// What the output tends to above.
    pub after: f64,
}

impl Gap {
    /// What it is in a word.
    pub fn kind(&self) -> &'static str {
        let sides = [self.place.value, self.after];
        match (sides.iter().any(|side| side.is_infinite()), sides.iter().any(|side| side.is_nan()))
        {
            (true, _) => "pole",
            (false, true) => "end",
            (false, false) => "jump",
        }
    }
}

/// How far each driver goes that has a start position, and that turns or goes anywhere in this task.
pub fn of(case: &Case) -> Vec<Reach> {
    if case.standing().iter().any(|start| !start.is_finite()) || case.moved.task == Task::Open {
        return Vec::new();
    }
    let drivers = 0..case.drivers.len();
    drivers.filter_map(|driver| of_driver(case, driver)).collect()
}

fn of_driver(case: &Case, driver: usize) -> Option<Reach> {
    let range = &case.moved.ranges[driver];
    let is_angle = case.drivers[driver].unit == "deg";
    let (low, high) = (range.from.min(range.to), range.from.max(range.to));
    let bounds = match is_angle {
        false if low == high => return None,
        true => (range.start - TAU, range.start + TAU),
        false => {
            let beyond = BEYOND * (high - low);
            (low - beyond, high + beyond)
        }
    };
    let stretch = case.run().stretch(driver, bounds);
    let is_free =
        |found: &Stretch| is_angle && found.low.dead.is_none() && found.high.dead.is_none();
    Some(Reach {
        driver,
        turns: stretch.as_ref().is_ok_and(is_free),
        stretch: stretch.map_err(|error| case.tell(&error)),
    })
}

/// The strokes over a task with one axis, of the outputs and behind them of the dependent coordinates. None over a grid, and
/// where the linkage does not get through the task in time.
pub fn strokes(case: &Case) -> Option<Vec<Stroke>> {
    case.run().strokes(along(case)?).ok()
}

/// What moves the linkage through a task with one axis.
fn along(case: &Case) -> Option<Along> {
    match case.run().way()? {
        // Limits are those of the range, whichever way it is gone.
        Along::Driver(driver, (from, to)) => {
            Some(Along::Driver(driver, (from.min(to), from.max(to))))
        }
        way => Some(way),
    }
}

/// The stroke of a variable.
pub fn stroke<'a>(
    case: &Case,
    strokes: Option<&'a Vec<Stroke>>,
    variable: &Variable,
) -> Option<&'a Stroke> {
    let index = match variable.origin {
        Subject::Output(index) => index,
        Subject::State(index) => case.scene.outputs.len() + index,
        _ => return None,
    };
    let stroke = strokes?.get(index)?;
    (!stroke.length().is_nan()).then_some(stroke)
}

/// The smallest and the largest value of a variable over the task: exact where there is one axis, else the best of the
/// positions of the lines, refined.
pub fn extremes(
    case: &Case,
    lines: &[Line],
    strokes: Option<&Vec<Stroke>>,
    index: usize,
) -> Option<(Extreme, Extreme)> {
    if let Some(stroke) = stroke(case, strokes, &case.variables[index]) {
        return Some((place(case, stroke.least), place(case, stroke.greatest)));
    }
    let value = |sample: &Sample| case.values(sample)[index];
    Some((smallest(case, lines, value)?, largest(case, lines, value)?))
}

/// Where a sweep of a single driver ends at a dead point of a group, its sine zero.
pub fn dead_end(case: &Case, group: usize) -> Option<Extreme> {
    let Along::Driver(driver, bounds) = along(case)? else {
        return None;
    };
    let found = case.run().stretch(driver, bounds).ok()?;
    let end = [found.low, found.high].into_iter().find(|end| end.dead == Some(group))?;
    Some(place(case, Place { at: end.at, value: 0.0 }))
}

/// A place of a stroke as one of the task.
fn place(case: &Case, found: Place) -> Extreme {
    let width = case.axes().first().map_or(0.0, |axis| axis.to - axis.from);
    let station = vec![settled(found.at, width.abs())];
    let mut independents = case.place(&station);
    independents.truncate(case.drivers.len());
    Extreme { station, independents, value: found.value }
}

/// Beside the stroke, and beside the range of the driver, this part of them is rounding.
const NOISE: f64 = 1e-12;

/// The limit positions inside the task, in their order.
pub fn turns(case: &Case, stroke: &Stroke) -> Vec<Turn> {
    let length = Some(stroke.length()).filter(|length| length.is_finite());
    let turns = stroke.limits.iter().map(|limit| {
        let value = settled(limit.place.value, length.unwrap_or(0.0));
        Turn { place: place(case, Place { value, ..limit.place }), is_highest: limit.is_highest }
    });
    turns.collect()
}

/// Where an output jumps, goes beyond all bounds or has no value, in the order of the task.
pub fn gaps(case: &Case, stroke: &Stroke) -> Vec<Gap> {
    let length = Some(stroke.length()).filter(|length| length.is_finite());
    let value = |value: f64| settled(value, length.unwrap_or(0.0));
    let gap = |found: &Break| {
        let below = Place { at: found.at, value: value(found.before) };
        Gap { place: place(case, below), after: value(found.after) }
    };
    stroke.breaks.iter().map(gap).collect()
}

/// A value, zero if it is rounding beside a size.
pub fn settled(value: f64, size: f64) -> f64 {
    match value.abs() <= NOISE * size {
        true => 0.0,
        false => value,
    }
}
