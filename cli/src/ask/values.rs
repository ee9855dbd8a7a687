//! Values with their units as options give them.

use assur::shape::Quantity;

use crate::ask::variables::Dimension;
use crate::error::Failure;
use crate::show::number;

/// Half a unit in the last of the ten digits that are printed of an angle: what its own rounding must stay below, in
/// radians.
pub const FINEST: f64 = 1e-10;

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
    let parts = text.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    parts.filter(|(name, value)| !name.is_empty() && !value.is_empty()).ok_or_else(|| {
        Failure::request(format!("{option} takes NAME=VALUE"))
            .place(format!("{option} {text}"))
            .remedy(format!("for example: {option} {example}"))
    })
}

/// Notes that a value is given, `what` at `place`.
///
/// # Errors
/// When it is given already.
pub fn once(given: &mut Vec<usize>, index: usize, what: &str, place: &str) -> Result<(), Failure> {
    if given.contains(&index) {
        return Err(Failure::request(format!("{what} is given twice"))
            .place(place)
            .remedy("leave one of them out"));
    }
    given.push(index);
    Ok(())
}

/// Reads a number with a unit as a value of a quantity, SI units. A pure number is accepted for a pure number, which an
/// angle is.
///
/// # Errors
/// What cannot be read, is not finite, or has another unit.
pub fn quantity(text: &str, quantity: &Quantity) -> Result<f64, Failure> {
    let remedy = remedy(quantity, text);
    let parsed = crate::show::unit::parse(text).map_err(|reason| {
        Failure::request(format!("`{text}` is not a value of `{}`", quantity.name))
            .reason(reason)
            .remedy(remedy.clone())
    })?;
    if !parsed.value.is_finite() {
        return Err(Failure::request(format!(
            "`{}` must be a finite number, not `{text}`",
            quantity.name
        ))
        .remedy(remedy.clone()));
    }
    let is_zero = parsed.bare && parsed.value == 0.0;
    if !is_zero && !same(parsed.dimension, quantity.dimension) {
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
            .remedy(remedy.clone()));
    }
    let rounding = rounding(parsed.value);
    if is_angle(quantity.unit) && rounding > FINEST {
        return Err(Failure::request(format!(
            "`{text}` is rounded to {} turns, more than the digits that are printed of an angle",
            number::error(rounding / std::f64::consts::TAU)
        ))
        .remedy("give the angle within a turn"));
    }
    Ok(parsed.value)
}

/// Whether a unit is one of angles.
fn is_angle(unit: &str) -> bool {
    matches!(unit, "deg" | "rad")
}

/// By how much a number may miss what was meant: half the distance to the next one.
pub fn rounding(value: f64) -> f64 {
    0.5 * (value.abs().next_up() - value.abs())
}

/// Reads a whole number of a range.
///
/// # Errors
/// When it is none, or out of the range.
pub fn whole<const LEAST: u64, const MOST: u64>(text: &str) -> Result<u64, Failure> {
    let number = text.trim().parse().ok();
    number.filter(|number| (LEAST..=MOST).contains(number)).ok_or_else(|| {
        Failure::request("this option takes a whole number")
            .remedy(format!("choose from {LEAST} to {MOST}"))
    })
}

/// How to write a value: the number that was typed with the unit of the quantity; where none was, what a number looks
/// like.
fn remedy(quantity: &Quantity, text: &str) -> String {
    match number(text) {
        Some(number) => format!("write it as {}", written(quantity, number)),
        None => format!(
            "write it as in {}; a number looks like 1.5, -20 or 2e-3",
            written(quantity, "1.5")
        ),
    }
}

/// A value of a quantity as an option takes it.
fn written(quantity: &Quantity, number: &str) -> String {
    let simple = quantity.unit.chars().all(char::is_alphabetic);
    if quantity.unit.is_empty() {
        format!("{}={number}", quantity.name)
    } else if simple {
        format!("{}={number}{}", quantity.name, quantity.unit)
    } else {
        format!("'{}={number} [{}]'", quantity.name, quantity.unit)
    }
}

/// The number that a text begins with, as it was typed; none where it is not finite, or where what follows is no unit
/// but more of a number, as in `1,5` or `2*355`.
fn number(text: &str) -> Option<&str> {
    let text = text.trim();
    let ends = (1..=text.len()).rev().filter(|end| text.is_char_boundary(*end));
    let end = ends.into_iter().find(|end| {
        let digits = text[..*end].ends_with(|last: char| last.is_ascii_digit() || last == '.');
        digits && text[..*end].parse::<f64>().is_ok_and(f64::is_finite)
    })?;
    let (number, rest) = text.split_at(end);
    let rest = rest.trim_start();
    let unit = |first: char| first.is_alphabetic() || matches!(first, '[' | '%' | '°');
    let based = number.ends_with('0') && rest.starts_with(['x', 'X']);
    let powerless = rest.starts_with(['e', 'E']) && !rest[1..].starts_with(char::is_alphabetic);
    let follows = rest.is_empty() || (rest.starts_with(unit) && !based && !powerless);
    follows.then_some(number)
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

    #[test]
    fn zero_needs_no_unit() {
        for zero in ["0", "-0", "0.0", "0e3", "0 s"] {
            assert_eq!(quantity(zero, &TIME), Ok(0.0), "{zero}");
        }
        for wrong in ["1", "1e-300", "0 kg"] {
            assert!(quantity(wrong, &TIME).is_err(), "{wrong}");
        }
    }

    #[track_caller]
    fn check_number(text: &str, expected: Option<&str>) {
        assert_eq!(number(text), expected, "{text}");
    }

    #[test]
    fn the_number_that_was_typed_is_repeated_whole() {
        for text in ["1e3", "1e300", "-2.5E-3", "+4", ".5", "7."] {
            check_number(text, Some(text));
            check_number(&format!("{text} kg"), Some(text));
            check_number(&format!("{text}[N m/rad]"), Some(text));
        }
        check_number("300rmp", Some("300"));
        check_number("20%", Some("20"));
    }

    #[test]
    fn what_is_more_than_a_number_is_not_cut_to_one() {
        for text in [
            "0x10", "1,5[s]", "2*355[s]", "1 000 s", "1_000", "1/2", "1e", "5e-", "1e999 s",
            "fast", "NaN", "inf s", "", "--3",
        ] {
            check_number(text, None);
        }
    }

    #[test]
    fn the_hint_keeps_the_value() {
        assert_eq!(remedy(&TIME, "1e3"), "write it as time=1e3s");
        assert_eq!(
            remedy(&TIME, "1,5s"),
            "write it as in time=1.5s; a number looks like 1.5, -20 or 2e-3"
        );
    }
}
