//! Values as a user types them, `300rpm`, `0.1 [kg m^2]`, and in the unit in which they are printed.

pub use assur::registry::{si, stated};
use assur_model::unit;

use crate::ask::variables::Dimension;

/// A number with a unit.
pub struct Parsed {
    /// SI value.
    pub value: f64,
    /// Exponents of the base units.
    pub dimension: Dimension,
    /// Whether no unit is stated.
    pub bare: bool,
}

/// Reads a number with or without a unit.
///
/// # Errors
/// What cannot be read, and what to write instead.
pub fn parse(text: &str) -> Result<Parsed, String> {
    let value = unit::parse_value(text).map_err(|error| error.to_string())?;
    let dimension = value.unit.as_ref().map_or(unit::Dimension::NONE, |unit| unit.dimension);
    Ok(Parsed { value: value.si(), dimension: dimension.exponents(), bare: value.unit.is_none() })
}

/// The unit of one thing per another; nothing where both have the same.
pub fn ratio(one: &str, other: &str) -> String {
    match (one, other) {
        (one, other) if one == other => String::new(),
        (one, "") => one.to_owned(),
        ("", other) => format!("1/({other})"),
        (one, other) => format!("{one}/({other})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declared_values_are_stated_as_they_were_written() {
        for unit in ["mm", "deg", "rpm", "um", "kN", "mm^2", "km/h", "min", "[1/s]"] {
            let factor = parse(&format!("1 {unit}")).map_or(1.0, |one| one.value);
            for tenths in 1..4000 {
                let number = f64::from(tenths) / 10.0;
                let value = parse(&format!("{number} {unit}")).map_or(f64::NAN, |read| read.value);
                assert_eq!(stated(value, factor), number, "{unit}");
                assert_eq!(stated(-value, factor), -number, "{unit}");
            }
        }
    }
}
