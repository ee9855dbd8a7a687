//! How far each driver goes in the assembly mode of the start values, and the limit positions of the outputs.
//!
//! Both are found to the last digits: an end is a dead point, a limit position a zero of the rate of an output.

use std::f64::consts::TAU;

use assur::closure::{Extreme as Limit, Range, Stretch, Stroke};
use assur::problem::Span;

use super::case::{Case, Task};
use super::search::Extreme;
use super::wording::{Names, Told, tell};
use crate::variables::{Origin, Variable};

/// A driver that does not turn is followed so many widths of its range beyond its ends.
const BEYOND: f64 = 10.0;
/// At so many times it is looked whether a driver moves back.
const LOOKS: usize = 360;

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

/// A driver that moves alone, and never back.
#[derive(Clone, Copy)]
pub struct Single {
    /// Its index.
    pub driver: usize,
    /// Where it begins.
    from: f64,
    /// Where it ends.
    to: f64,
}

impl Single {
    /// The only driver that is swept, or that moves in time.
    pub fn of(case: &Case) -> Option<Self> {
        match &case.task {
            Task::Sweep(drivers) if drivers.len() == 1 => {
                let driver = *drivers.first()?;
                let Range { from, to, .. } = case.ranges[driver];
                Some(Self { driver, from, to })
            }
            Task::Time(span) if case.drivers.len() == 1 => {
                let (first, last) = span.limits();
                let time = |part: usize| first + (last - first) * part as f64 / LOOKS as f64;
                let position = |part| case.place(&[time(part)]).first().copied();
                let positions = (0..=LOOKS).map(position).collect::<Option<Vec<_>>>()?;
                let (from, to) = (*positions.first()?, *positions.last()?);
                let advances = |pair: &[f64]| (pair[1] - pair[0]) * (to - from) > 0.0;
                let is_single = positions.windows(2).all(advances);
                is_single.then_some(Self {
                    driver: 0,
                    from,
                    to,
                })
            }
            _ => None,
        }
    }

    fn width(self) -> f64 {
        (self.to - self.from).abs()
    }

    /// An extreme as one of the task.
    fn place(self, case: &Case, found: Limit) -> Extreme {
        let at = settled(found.at, self.width());
        let mut independents = case.standing();
        independents[self.driver] = at;
        let station = match &case.task {
            Task::Time(span) => {
                let (from, to) = span.limits();
                let position = |time: f64| case.place(&[time])[self.driver];
                let time = Span::Run(from, to).time_of(position, at);
                time.unwrap_or(f64::NAN)
            }
            _ => at,
        };
        Extreme {
            station: vec![station],
            independents,
            value: found.value,
        }
    }
}

/// The strokes of the outputs over a driver that moves alone; none otherwise. Outputs that depend on how it moves have
/// none.
pub fn strokes(case: &Case) -> Option<Vec<Stroke>> {
    let Single { driver, from, to } = Single::of(case)?;
    let bounds = (from.min(to), from.max(to));
    case.run().strokes(driver, bounds).ok()
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
pub fn extremes(case: &Case, stroke: &Stroke) -> Option<(Extreme, Extreme)> {
    let single = Single::of(case)?;
    let [least, greatest] = [stroke.least, stroke.greatest].map(|one| single.place(case, one));
    Some((least, greatest))
}

/// Beside the stroke, and beside the range of the driver, this part of them is rounding.
const NOISE: f64 = 1e-12;

/// The limit positions inside the range of the driver that moves alone, in the order of its positions.
pub fn turns(case: &Case, stroke: &Stroke) -> Vec<Turn> {
    let Some(single) = Single::of(case) else {
        return Vec::new();
    };
    let turn = |(one, is_largest): (&Limit, bool)| {
        let value = settled(one.value, stroke.length());
        let place = single.place(case, Limit { value, ..*one });
        Turn { place, is_largest }
    };
    stroke
        .limits
        .iter()
        .zip(are_largest(stroke))
        .map(turn)
        .collect()
}

/// Which limit positions are largest among their neighbours: largest and smallest ones take turns.
fn are_largest(stroke: &Stroke) -> Vec<bool> {
    let limits = &stroke.limits;
    let is_largest = |(index, one): (usize, &Limit)| {
        let neighbour = index.checked_sub(1).unwrap_or(index + 1);
        match limits.get(neighbour) {
            Some(other) => one.value > other.value,
            None => one.value == stroke.greatest.value,
        }
    };
    limits.iter().enumerate().map(is_largest).collect()
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
        assert_eq!(are_largest(&stroke), expected);
    }

    #[test]
    fn limit_positions_take_turns() {
        let all = [found(1.0, 2.0), found(2.0, -1.0), found(3.0, 0.5)];
        check(all.to_vec(), &[true, false, true]);
        check(all[1..2].to_vec(), &[false]);
    }
}
