//! Where everything about a linkage is to be printed.

use super::case::{Case, Task};
use crate::ask::case::{amount, amount_of};
use crate::ask::place;
use crate::error::Failure;

/// A place that the linkage is to go to.
#[derive(Clone, Debug)]
pub struct Place {
    /// The option as it was given.
    pub option: String,
    /// The place in words, `phi4 = 90 deg`.
    pub label: String,
    /// The time, where the drivers move in time.
    pub time: Option<f64>,
    /// The independent variables.
    pub independents: Vec<f64>,
    /// Drivers that stand outside of their declared ranges, in words.
    pub outside: Vec<String>,
}

/// Reads an `--at`: positions of drivers or a time, those that are not named standing where they start.
///
/// # Errors
/// An unknown name, a wrong unit, a time or a position that the task does not reach.
pub fn read(case: &Case, text: &str) -> Result<Place, Failure> {
    let is_timed = matches!(case.moved.task, Task::Time(_));
    resolved(case, place::Place::read(case, text, is_timed)?)
}

/// Where the drivers start, or where they are when the task begins if they move in time.
///
/// # Errors
/// When a driver has no start position.
pub fn start(case: &Case) -> Result<Place, Failure> {
    let positions = match &case.moved.task {
        Task::Time(span) => vec![(None, span.limits().0)],
        _ => Vec::new(),
    };
    resolved(case, place::Place { option: String::new(), positions })
}

fn resolved(case: &Case, asked: place::Place) -> Result<Place, Failure> {
    if let Task::Time(span) = case.moved.task {
        let (time, label) =
            asked.in_time(case, span, |driver, position| case.time_of(driver, position))?;
        let independents = case.place(&[time]);
        let outside = Vec::new();
        return Ok(Place { option: asked.option, label, time: Some(time), independents, outside });
    }
    let named = asked.positions.iter().filter_map(|(index, value)| Some(((*index)?, *value)));
    let independents = case.standing_but(named.clone());
    if let Some(index) = independents.iter().position(|position| !position.is_finite()) {
        let name = case.drivers[index].name;
        return Err(Failure::request(format!("`{name}` has no start position"))
            .place(asked.option)
            .remedy(format!("give its position as well: --at …,{name}=…")));
    }
    let outside = named.filter_map(|(index, position)| outside(case, index, position)).collect();
    let label = case.label(&independents);
    Ok(Place { option: asked.option, label, time: None, independents, outside })
}

/// That a driver stands outside of its declared range, in words.
fn outside(case: &Case, index: usize, position: f64) -> Option<String> {
    let (range, driver) = (&case.moved.ranges[index], &case.drivers[index]);
    let (low, high) = (range.from.min(range.to), range.from.max(range.to));
    // Rounding of the unit does not put a position outside.
    let slack = 1e-12 * (high - low);
    let inside = !(position < low - slack || position > high + slack);
    (!inside && low < high).then(|| {
        format!(
            "{} is outside of its declared range, {} to {}",
            amount_of(driver, position),
            amount(driver, range.from),
            amount(driver, range.to)
        )
    })
}
