//! Values as a user types them, `300rpm`, `0.1 [kg m^2]`, and in the unit in which they are printed.

use assur_model::unit;

use crate::ask::variables::Dimension;

/// Whole numbers below it are floating-point numbers.
const EXACT: f64 = 9_007_199_254_740_992.0;

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

/// A value in SI units as a number of units of this size: the shortest that means the same value, where there is one. So
/// a declared 10.4 mm is 10.4 again, and 30 deg are 30.
pub fn stated(value: f64, factor: f64) -> f64 {
    if factor == 1.0 {
        return value;
    }
    // A factor that is rounded itself, such as that of a degree, leaves a last place open.
    let (plain, slack) = match inverse(factor) {
        Some(parts) => (value * parts, 0.0),
        None => (value / factor, f64::EPSILON * value.abs()),
    };
    let short = format!("{plain:.14e}").parse().unwrap_or(plain);
    if (si(short, factor) - value).abs() <= slack { short } else { plain }
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

/// A number of units of this size in SI units, rounded once: as the language scales what a file declares.
pub fn si(number: f64, factor: f64) -> f64 {
    match inverse(factor) {
        Some(parts) => number / parts,
        None => number * factor,
    }
}

/// The whole number of parts of which such a unit is one: 1000 for a millimetre. A factor of a thousandth is not exact,
/// but its inverse is.
fn inverse(factor: f64) -> Option<f64> {
    let parts = (1.0 / factor).round();
    (parts > 1.0 && parts < EXACT && 1.0 / parts == factor).then_some(parts)
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

    #[test]
    fn what_is_stated_means_the_value() {
        for k in 1..1000 {
            let value = (f64::from(k) * 0.37).sin();
            for factor in [1e-3, 1e-6, std::f64::consts::PI / 180.0, 1e3, 1.0] {
                let again = si(stated(value, factor), factor);
                assert!((again - value).abs() <= 5e-16 * value.abs(), "{value} {factor}");
            }
        }
        assert!(stated(f64::NAN, 1e-3).is_nan());
        assert_eq!(stated(0.0, 1e-3), 0.0);
        assert_eq!(stated(f64::INFINITY, 1e-3), f64::INFINITY);
    }
}
