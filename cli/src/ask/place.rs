//! What stands behind `--at`.

use assur::problem::Span;
use assur::shape::Quantity;

use super::case::{Case, amount, amount_of};
use super::lookup::suggestion;
use super::values::{self, TIME, split};
use crate::error::Failure;
use crate::show::number;

/// Places that are named, before it is known whether the scene gets there.
#[derive(Clone, Debug, Default)]
pub struct Place {
    /// The option as it was given.
    pub option: String,
    /// What it names: a driver by its index, or the time; each with its value in SI units.
    pub positions: Vec<(Option<usize>, f64)>,
}

impl Place {
    /// Reads an `--at`: positions of drivers, or a time where the scene moves in time.
    ///
    /// # Errors
    /// An unknown name, a wrong unit, a name that is given twice.
    pub fn read<M>(case: &Case<M>, text: &str, is_timed: bool) -> Result<Self, Failure> {
        let mut place = Self { option: format!("--at {text}"), positions: Vec::new() };
        for part in text.split(',') {
            let position = position(case, part, is_timed);
            let (name, index, value) =
                position.map_err(|failure| failure.place(place.option.as_str()))?;
            if place.positions.iter().any(|(known, _)| *known == index) {
                return Err(Failure::request(format!("`{name}` is given twice"))
                    .place(place.option)
                    .remedy("leave one of them out, or repeat --at for another position"));
            }
            place.positions.push((index, value));
        }
        Ok(place)
    }

    /// The time that is asked for, however many periods it lies behind the first one; none where a driver is named.
    pub fn time(&self) -> Option<f64> {
        match self.positions[..] {
            [(None, time)] => Some(time),
            _ => None,
        }
    }

    /// The time of the place and the place in words, where all drivers move in time. `time_of` is when a driver first has a
    /// position, or the lowest and the highest position that it has.
    ///
    /// # Errors
    /// When the task does not get there, or more than one thing is named.
    pub fn in_time<M>(
        &self,
        case: &Case<M>,
        span: Span,
        time_of: impl Fn(usize, f64) -> Result<f64, (f64, f64)>,
    ) -> Result<(f64, String), Failure> {
        let found = match self.positions[..] {
            [(None, time)] => reduced(span, time).map(|at| (at, amount_of(&TIME, time))),
            [(Some(index), position)] => {
                let label = case.driver_at(index, position);
                let driver = &case.drivers[index];
                let unreached = |(low, high)| {
                    Failure::request(format!("the task does not reach {label}")).remedy(format!(
                        "it moves from {} to {}",
                        amount(driver, low),
                        amount(driver, high)
                    ))
                };
                let time = time_of(index, position).map_err(unreached);
                time.map(|time| (time, label.clone()))
            }
            _ => Err(Failure::request("the drivers of this scene move in time, all together")
                .remedy("name one of them, or the time")),
        };
        found.map_err(|failure| failure.place(self.option.as_str()))
    }
}

/// A part of an `--at`: its name, the driver unless it is the time, and the value.
fn position<'a, M>(
    case: &Case<M>,
    text: &'a str,
    is_timed: bool,
) -> Result<(&'a str, Option<usize>, f64), Failure> {
    let (name, value) = split(text, "--at", &example(&case.drivers, is_timed))?;
    let index = case.drivers.iter().position(|driver| driver.name == name);
    if index.is_none() && !(is_timed && name == TIME.name) {
        return Err(unknown(case, name, is_timed));
    }
    let quantity = index.map_or(&TIME, |index| &case.drivers[index]);
    Ok((name, index, values::quantity(value, quantity)?))
}

fn example(drivers: &[Quantity], is_timed: bool) -> String {
    let positions = drivers.iter().map(|driver| match driver.unit {
        "deg" | "rad" if is_timed => format!("{}=110deg", driver.name),
        "deg" | "rad" => format!("{}=90deg", driver.name),
        unit => format!("{}=1{unit}", driver.name),
    });
    match positions.take(if is_timed { 1 } else { usize::MAX }).collect::<Vec<_>>() {
        list if list.is_empty() => "time=0.1s".to_owned(),
        list => list.join(","),
    }
}

fn unknown<M>(case: &Case<M>, name: &str, is_timed: bool) -> Failure {
    let time = is_timed.then_some(TIME.name);
    let names: Vec<_> = case.drivers.iter().map(|driver| driver.name).chain(time).collect();
    let known = case.scene.constants.iter().any(|one| one.quantity.name == name);
    let remedy = match known {
        true => format!("`{name}` is set with --set {name}=…"),
        false => suggestion(name, &names),
    };
    let what = if is_timed { "the driver or the time" } else { "positions of drivers" };
    Failure::request(format!("--at takes {what}, not `{name}`"))
        .remedy(format!("{remedy}\nfor example: --at {}", example(&case.drivers, is_timed)))
}

/// A time within the task.
fn reduced(span: Span, time: f64) -> Result<f64, Failure> {
    if let Span::Periodic(period) = span {
        let share = values::rounding(time) / period;
        if share > values::FINEST {
            return Err(Failure::request(format!(
                "time = {time:?} s is rounded to {} periods, more than the digits that are printed",
                number::error(share)
            ))
            .remedy("give a time within the first periods"));
        }
    }
    span.reduce(time).ok_or_else(|| {
        let (from, to) = span.limits();
        Failure::request(format!("the task does not reach time = {time} s"))
            .remedy(format!("it lasts from {from} s to {to} s"))
    })
}
