//! Values as a user types them: `300rpm`, `0.1 [kg m^2]`.

use assur_model::unit;

use crate::variables::Dimension;

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
    let dimension = value
        .unit
        .as_ref()
        .map_or(unit::Dimension::NONE, |unit| unit.dimension);
    Ok(Parsed {
        value: value.si(),
        dimension: dimension.exponents(),
        bare: value.unit.is_none(),
    })
}
