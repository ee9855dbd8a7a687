//! What stands behind the `--at` of a linkage.

use assur::problem::Span;

use super::case::{Case, Task, amount};
use crate::error::Failure;
use crate::lookup::suggestion;
use crate::values::{self, TIME, split};

/// Where everything is to be printed.
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
    let failed = |failure: Failure| failure.place(format!("--at {text}"));
    let positions = positions(case, text).map_err(failed)?;
    let place = match &case.task {
        Task::Time(span) => in_time(case, *span, &positions),
        _ => swept(case, &positions),
    };
    place.map(|place| Place { option: format!("--at {text}"), ..place }).map_err(failed)
}

/// Where the drivers start, or where they are when the task begins if they move in time.
///
/// # Errors
/// When a driver has no start position.
pub fn start(case: &Case) -> Result<Place, Failure> {
    match &case.task {
        Task::Time(span) => {
            let (first, _) = span.limits();
            in_time(case, *span, &[(None, first)])
        }
        _ => swept(case, &[]),
    }
}

/// Something that `--at` names, with its value in SI units; the time has no index.
type Position = (Option<usize>, f64);

fn positions(case: &Case, text: &str) -> Result<Vec<Position>, Failure> {
    let example = example(case);
    let mut list: Vec<Position> = Vec::new();
    for part in text.split(',') {
        let (name, value) = split(part, "--at", &example)?;
        let index = case.drivers.iter().position(|driver| driver.name == name);
        let is_time = name == TIME.name && matches!(case.task, Task::Time(_));
        if index.is_none() && !is_time {
            return Err(unknown(case, name, &example));
        }
        let quantity = index.map_or(&TIME, |index| &case.drivers[index]);
        if list.iter().any(|(known, _)| *known == index) {
            return Err(Failure::request(format!("`{name}` is given twice"))
                .remedy("leave one of them out, or repeat --at for another position"));
        }
        list.push((index, values::quantity(value, quantity)?));
    }
    Ok(list)
}

fn example(case: &Case) -> String {
    let positions = case.drivers.iter().map(|driver| match driver.unit {
        "deg" => format!("{}=90deg", driver.name),
        unit => format!("{}=1{unit}", driver.name),
    });
    match positions.collect::<Vec<_>>() {
        list if list.is_empty() => "time=0.1s".to_owned(),
        list => list.join(","),
    }
}

fn unknown(case: &Case, name: &str, example: &str) -> Failure {
    let mut names: Vec<_> = case.drivers.iter().map(|driver| driver.name).collect();
    if matches!(case.task, Task::Time(_)) {
        names.push(TIME.name);
    }
    let known = case.scene.constants.iter().any(|one| one.quantity.name == name);
    let remedy = match known {
        true => format!("`{name}` is set with --set {name}=…"),
        false => suggestion(name, &names),
    };
    Failure::request(format!("--at takes positions of drivers, not `{name}`"))
        .remedy(format!("{remedy}\nfor example: --at {example}"))
}

fn swept(case: &Case, positions: &[Position]) -> Result<Place, Failure> {
    let mut independents = case.standing();
    for (index, position) in positions {
        if let Some(index) = index {
            independents[*index] = *position;
        }
    }
    let unknown = independents.iter().position(|position| !position.is_finite());
    if let Some(index) = unknown {
        let name = case.drivers[index].name;
        return Err(Failure::request(format!("`{name}` has no start position"))
            .remedy(format!("give its position as well: --at …,{name}=…")));
    }
    let outside = positions.iter().filter_map(|(index, position)| {
        let index = (*index)?;
        let range = &case.ranges[index];
        let (low, high) = (range.from.min(range.to), range.from.max(range.to));
        // Rounding of the unit does not put a position outside.
        let slack = 1e-12 * (high - low);
        let inside = !(*position < low - slack || *position > high + slack);
        let driver = &case.drivers[index];
        (!inside && low < high).then(|| {
            format!(
                "{} = {} is outside of its declared range, {} to {}",
                driver.name,
                amount(driver, *position),
                amount(driver, range.from),
                amount(driver, range.to)
            )
        })
    });
    Ok(Place {
        option: String::new(),
        label: case.label(&independents),
        time: None,
        outside: outside.collect(),
        independents,
    })
}

fn in_time(case: &Case, span: Span, positions: &[Position]) -> Result<Place, Failure> {
    let [(index, value)] = positions else {
        return Err(Failure::request("the drivers of this scene move in time, all together")
            .remedy("name one of them, or the time"));
    };
    let time = match index {
        None => span.reduce(*value).ok_or_else(|| {
            let (from, to) = span.limits();
            Failure::request(format!("the task does not reach time = {value} s"))
                .remedy(format!("it lasts from {from} s to {to} s"))
        }),
        Some(index) => time_of(case, span, *index, *value).map_err(|(low, high)| {
            let driver = &case.drivers[*index];
            Failure::request(format!(
                "the task does not reach {} = {}",
                driver.name,
                amount(driver, *value)
            ))
            .remedy(format!(
                "it moves from {} to {}",
                amount(driver, low),
                amount(driver, high)
            ))
        }),
    }?;
    let independents = case.place(&[time]);
    let label = match index {
        None => format!("time = {}", amount(&TIME, *value)),
        Some(index) => {
            let driver = &case.drivers[*index];
            format!("{} = {}", driver.name, amount(driver, *value))
        }
    };
    Ok(Place { option: String::new(), label, time: Some(time), independents, outside: Vec::new() })
}

/// When a driver that moves in time first has a position.
///
/// # Errors
/// The lowest and the highest position that it has.
pub fn time_of(case: &Case, span: Span, driver: usize, position: f64) -> Result<f64, (f64, f64)> {
    let at = |time: f64| case.place(&[time]).get(driver).copied().unwrap_or(f64::NAN);
    span.time_of(at, position)
}
