//! How far each driver goes in the assembly mode of the start values, and the limit positions of the outputs.
//!
//! Both are found to the last digits: an end is a dead point, a limit position a zero of the rate of an output.

use std::f64::consts::TAU;

use assur::closure::{Extreme as Limit, Stretch, Stroke};

use super::case::{Case, Task};
use super::search::Extreme;
use super::wording::{Names, Told, tell};
use crate::variables::{Origin, Variable};

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
    /// Position of the driver.
    pub at: f64,
    /// The output there.
    pub value: f64,
    /// Whether the output is largest there among its neighbours.
    pub is_largest: bool,
}

/// How far each driver goes that has a start position.
pub fn of(case: &Case) -> Vec<Reach> {
    if case.standing().iter().any(|start| !start.is_finite()) || case.task == Task::Open {
        return Vec::new();
    }
    let drivers = 0..case.drivers.len();
    drivers.map(|driver| of_driver(case, driver)).collect()
}

fn of_driver(case: &Case, driver: usize) -> Reach {
    let range = &case.ranges[driver];
    let is_angle = case.drivers[driver].unit == "deg";
    let (low, high) = (range.from.min(range.to), range.from.max(range.to));
    let bounds = match is_angle {
        true => (range.start - TAU, range.start + TAU),
        false => {
            let beyond = BEYOND * (high - low);
            (low - beyond, high + beyond)
        }
    };
    let stretch = case.run().stretch(driver, bounds);
    let is_free =
        |found: &Stretch| is_angle && found.low.dead.is_none() && found.high.dead.is_none();
    Reach {
        driver,
        turns: stretch.as_ref().is_ok_and(is_free),
        stretch: stretch.map_err(|error| {
            let names = Names {
                entry: case.entry,
                drivers: &case.drivers,
            };
            tell(names, &error)
        }),
    }
}

/// The strokes of the outputs where a single driver is swept; none otherwise.
pub fn strokes(case: &Case) -> Option<Vec<Stroke>> {
    let range = &case.ranges[swept(case)?];
    let bounds = (range.from.min(range.to), range.from.max(range.to));
    case.run().strokes(swept(case)?, bounds).ok()
}

/// The driver that is swept, if it is one alone.
pub fn swept(case: &Case) -> Option<usize> {
    match &case.task {
        Task::Sweep(drivers) if drivers.len() == 1 => drivers.first().copied(),
        _ => None,
    }
}

/// The stroke of a variable, if it is an output whose stroke is known.
pub fn stroke<'a>(strokes: Option<&'a Vec<Stroke>>, variable: &Variable) -> Option<&'a Stroke> {
    let Origin::Output(index) = variable.origin else {
        return None;
    };
    let stroke = strokes?.get(index)?;
    (stroke.length() > 0.0).then_some(stroke)
}

/// The ends of a stroke as extremes of the task.
pub fn extremes(case: &Case, stroke: &Stroke) -> (Extreme, Extreme) {
    let width = width(case);
    let extreme = |found: Limit| {
        let at = settled(found.at, width);
        Extreme {
            station: vec![at],
            independents: case.place(&[at]),
            value: found.value,
        }
    };
    (extreme(stroke.least), extreme(stroke.greatest))
}

/// Beside the stroke, and beside the range of the driver, this part of them is rounding.
const NOISE: f64 = 1e-12;

/// The limit positions inside the range of the driver that is swept, in their order.
pub fn turns(case: &Case, stroke: &Stroke) -> Vec<Turn> {
    turns_within(stroke, width(case))
}

fn turns_within(stroke: &Stroke, width: f64) -> Vec<Turn> {
    let limits = &stroke.limits;
    let turn = |(index, one): (usize, &Limit)| {
        // Largest and smallest ones take turns.
        let neighbour = index.checked_sub(1).unwrap_or(index + 1);
        let is_largest = match limits.get(neighbour) {
            Some(other) => one.value > other.value,
            None => one.value == stroke.greatest.value,
        };
        Turn {
            at: settled(one.at, width),
            value: settled(one.value, stroke.length()),
            is_largest,
        }
    };
    limits.iter().enumerate().map(turn).collect()
}

/// How far the driver goes that is swept.
fn width(case: &Case) -> f64 {
    swept(case).map_or(0.0, |index| {
        (case.ranges[index].to - case.ranges[index].from).abs()
    })
}

/// A value, zero if it is rounding beside a size.
pub fn settled(value: f64, size: f64) -> f64 {
    match value.abs() <= NOISE * size {
        true => 0.0,
        false => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(at: f64, value: f64) -> Limit {
        Limit { at, value }
    }

    #[track_caller]
    fn check(limits: Vec<Limit>, expected: &[bool]) {
        let stroke = Stroke {
            least: found(2.0, -1.0),
            greatest: found(0.0, 3.0),
            limits,
        };
        let turns = turns_within(&stroke, 5.0);
        let largest: Vec<_> = turns.iter().map(|turn| turn.is_largest).collect();
        assert_eq!(largest, expected);
    }

    #[test]
    fn limit_positions_take_turns() {
        let all = [found(1.0, 2.0), found(2.0, -1.0), found(3.0, 0.5)];
        check(all.to_vec(), &[true, false, true]);
        check(all[1..2].to_vec(), &[false]);
    }
}
