//! Values with their units as options give them, and what stands behind `--at`.

use assur::registry::{Quantity, SceneEntry};

use crate::error::Failure;
use crate::lookup::suggestion;
use crate::variables::Dimension;

/// Where everything is to be printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At a time, in seconds.
    Time(f64),
    /// Where the driver of this index stands so, SI units.
    Driver(usize, f64),
}

/// Reads an `--at`.
///
/// # Errors
/// An unknown name or a wrong unit.
pub fn place(scene: &'static SceneEntry, text: &str) -> Result<Place, Failure> {
    let example = scene
        .drivers
        .first()
        .map_or("time=0.1s".to_owned(), |driver| {
            format!("{}=110deg", driver.name)
        });
    let (name, value) = split(text, "--at", &example)?;
    let failed = |failure: Failure| failure.place(format!("--at {text}"));
    if name == "time" {
        return quantity(value, &TIME).map(Place::Time).map_err(failed);
    }
    if let Some(index) = scene.drivers.iter().position(|driver| driver.name == name) {
        return quantity(value, &scene.drivers[index])
            .map(|value| Place::Driver(index, value))
            .map_err(failed);
    }
    let mut names: Vec<_> = scene.drivers.iter().map(|driver| driver.name).collect();
    names.push("time");
    Err(
        Failure::request(format!("--at takes the driver or the time, not `{name}`"))
            .place(format!("--at {text}"))
            .remedy(format!(
                "{}\nfor example: --at {example}",
                suggestion(name, &names)
            )),
    )
}

/// The time as a quantity.
pub const TIME: Quantity = Quantity {
    name: "time",
    summary: "time",
    unit: "s",
    factor: 1.0,
    dimension: [(0, 1), (0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
};

/// The name and the value of `NAME=VALUE`.
///
/// # Errors
/// When one of them is missing.
pub fn split<'a>(
    text: &'a str,
    option: &str,
    example: &str,
) -> Result<(&'a str, &'a str), Failure> {
    let parts = text
        .split_once('=')
        .map(|(name, value)| (name.trim(), value.trim()));
    parts
        .filter(|(name, value)| !name.is_empty() && !value.is_empty())
        .ok_or_else(|| {
            Failure::request(format!("{option} takes NAME=VALUE"))
                .place(format!("{option} {text}"))
                .remedy(format!("for example: {option} {example}"))
        })
}

/// Reads a number with a unit as a value of a quantity, SI units. A pure number is accepted for a pure number, which an
/// angle is.
///
/// # Errors
/// What cannot be read, is not finite, or has another unit.
pub fn quantity(text: &str, quantity: &Quantity) -> Result<f64, Failure> {
    let example = example(quantity, text);
    let parsed = crate::unit::parse(text).map_err(|reason| {
        Failure::request(format!("`{text}` is not a value of `{}`", quantity.name))
            .reason(reason)
            .remedy(format!("write it as {example}"))
    })?;
    if !parsed.value.is_finite() {
        return Err(Failure::request(format!(
            "`{}` must be a finite number, not `{text}`",
            quantity.name
        ))
        .remedy(format!("write it as {example}")));
    }
    if !same(parsed.dimension, quantity.dimension) {
        let what = if parsed.bare {
            format!("`{}` needs a unit", quantity.name)
        } else {
            format!("`{text}` has the wrong unit for `{}`", quantity.name)
        };
        let expected = if quantity.unit.is_empty() {
            "a pure number".to_owned()
        } else {
            format!("a unit like {}", quantity.unit)
        };
        return Err(Failure::request(what)
            .reason(format!("expected {expected}"))
            .remedy(format!("write it as {example}")));
    }
    Ok(parsed.value)
}

/// How the value might have been meant: the number that was typed with the unit of the quantity.
fn example(quantity: &Quantity, text: &str) -> String {
    let typed: String = text
        .chars()
        .take_while(|one| one.is_ascii_digit() || matches!(one, '.' | '-'))
        .collect();
    let number = match typed.parse::<f64>() {
        Ok(_) => typed.as_str(),
        Err(_) => "1.5",
    };
    let simple = quantity.unit.chars().all(char::is_alphabetic);
    if quantity.unit.is_empty() {
        format!("{}={number}", quantity.name)
    } else if simple {
        format!("{}={number}{}", quantity.name, quantity.unit)
    } else {
        format!("'{}={number} [{}]'", quantity.name, quantity.unit)
    }
}

fn same(a: Dimension, b: Dimension) -> bool {
    a.iter()
        .zip(&b)
        .all(|(a, b)| i16::from(a.0) * i16::from(b.1) == i16::from(b.0) * i16::from(a.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_needs_a_unit_of_time() {
        assert_eq!(quantity("100 ms", &TIME), Ok(0.1));
        for wrong in ["3", "3 kg", "NaN s", "inf s", "s", "1e999 s"] {
            assert!(quantity(wrong, &TIME).is_err(), "{wrong}");
        }
    }
}
