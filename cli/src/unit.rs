//! TEMPORARY until `assur_model::unit` exists.
use crate::variables::Dimension;
/// A number with a unit.
pub struct Parsed {
    /// SI value.
    pub value: f64,
    /// Dimension.
    pub dimension: Dimension,
    /// No unit stated.
    pub bare: bool,
}
pub fn parse(text: &str) -> Result<Parsed, String> {
    let cut = (1..=text.len()).rev().filter(|i| text.is_char_boundary(*i)).find(|i| text[..*i].trim().parse::<f64>().is_ok()).ok_or("it does not begin with a number")?;
    let value: f64 = text[..cut].trim().parse().map_err(|_| "no number")?;
    let unit = text[cut..].trim();
    let pi = std::f64::consts::PI;
    let (f, d): (f64, [i8; 3]) = match unit {
        "" | "rad" => (1.0, [0, 0, 0]),
        "deg" => (pi / 180.0, [0, 0, 0]),
        "rpm" => (pi / 30.0, [0, 0, -1]),
        "s" => (1.0, [0, 0, 1]),
        "ms" => (1e-3, [0, 0, 1]),
        "m" => (1.0, [1, 0, 0]),
        "mm" => (1e-3, [1, 0, 0]),
        "kg" => (1.0, [0, 1, 0]),
        "[N m/rad]" => (1.0, [2, 1, -2]),
        _ => return Err(format!("`{unit}` is not a unit")),
    };
    let mut dimension = [(0, 1); 7];
    for (slot, e) in dimension.iter_mut().zip(d) {
        slot.0 = e;
    }
    Ok(Parsed { value: value * f, dimension, bare: unit.is_empty() })
}
