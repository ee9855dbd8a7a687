//! Units: what they measure, exactly how large they are, and how they are written.

mod dimension;
mod factor;
mod table;
mod text;

pub use dimension::{BASES, Dimension};
pub use factor::Factor;
pub use text::{UnitError, Value, parse_unit_text, parse_value};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::nearest::nearest;
use crate::syntax::tree::{Name, UnitTerm};

/// A unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// How it is written, `N m/rad`; empty for a pure number.
    pub symbol: String,
    /// Its size in SI units.
    pub factor: Factor,
}

impl Unit {
    /// The unit of pure numbers.
    pub fn none() -> Self {
        Self { dimension: Dimension::NONE, symbol: String::new(), factor: Factor::ONE }
    }

    /// A value in SI units, given in this one.
    pub fn to_si(&self, value: f64) -> f64 {
        self.factor.to_si(value)
    }

    /// SI value of one such unit.
    pub fn scale(&self) -> f64 {
        self.factor.scale()
    }

    /// The SI unit that engineers use for a dimension: `N m` rather than `kg m^2/s^2`.
    pub fn for_dimension(dimension: &Dimension) -> Self {
        if *dimension == Dimension::NONE {
            return Self::none();
        }
        let natural = table::NATURAL.iter().filter_map(|symbol| parse_unit_text(symbol).ok());
        natural.into_iter().find(|unit| unit.dimension == *dimension).unwrap_or_else(|| {
            let factors = BASES.iter().map(|base| base.to_string()).zip(dimension.exponents());
            let symbol = symbol_of(factors.filter(|(_, exponent)| exponent.0 != 0));
            Self { dimension: *dimension, symbol, factor: Factor::ONE }
        })
    }
}

/// The unit that a written one is; reports a name that is no unit.
pub fn resolve(written: &UnitTerm, diagnostics: &mut Diagnostics) -> Option<Unit> {
    match read(&written.factors) {
        Ok(unit) => Some(unit),
        Err((name, reason)) => {
            let place = name.map_or(written.span, |name| name.span);
            let mut report = Diagnostic::error(place, reason);
            if let Some(hint) = name.and_then(|name| hint(&name.text)) {
                report = report.hint(hint);
            }
            diagnostics.push(report);
            None
        }
    }
}

/// A unit from its factors; else the name that is wrong and what is wrong.
fn read(factors: &[(Name, (i8, i8))]) -> Result<Unit, (Option<&Name>, String)> {
    let mut unit = Unit::none();
    for (name, (numerator, denominator)) in factors {
        let Some((dimension, factor)) = table::find(&name.text) else {
            return Err((Some(name), format!("`{}` is not a unit", name.text)));
        };
        let power =
            dimension.pow(*numerator, *denominator).and_then(|power| unit.dimension.mul(&power));
        unit.dimension =
            power.ok_or((None, "the exponents of this unit are too large".to_string()))?;
        unit.factor = unit.factor.times(factor.pow(*numerator, *denominator));
    }
    unit.symbol = symbol_of(factors.iter().map(|(name, exponent)| (name.text.clone(), *exponent)));
    Ok(unit)
}

/// Whether a name is the symbol of a unit, with its prefix if it has one.
pub fn is_unit(name: &str) -> bool {
    table::find(name).is_some()
}

fn hint(name: &str) -> Option<String> {
    let instead = match name {
        "in" | "inches" => "inch",
        "sec" | "second" | "seconds" => "s",
        "hr" | "hour" | "hours" => "h",
        "degree" | "degrees" => "deg",
        "minutes" | "minute" | "mins" => "min",
        "kilogram" | "kilograms" | "kilo" | "kilos" => "kg",
        "gram" | "grams" => "g",
        "meter" | "metre" | "meters" | "metres" => "m",
        "millimeter" | "millimetre" | "millimeters" | "millimetres" => "mm",
        "newton" | "newtons" | "Newton" => "N",
        "radian" | "radians" => "rad",
        "hertz" | "Hertz" | "hz" | "HZ" => "Hz",
        "watt" | "watts" | "Watt" => "W",
        "Sec" | "S" | "secs" => "s",
        "micron" | "microns" => "um",
        _ if factors_in(name).is_some() => {
            return factors_in(name).map(|factors| format!("write `[{factors}]`"));
        }
        _ => {
            let near = nearest(name, table::UNITS.iter().map(|unit| unit.symbol))?;
            return Some(format!("did you mean `{near}`?"));
        }
    };
    Some(format!("write `{instead}`"))
}

/// The factors of a unit that is written in one word: `N m` of `Nm`, `mm^2` of `mm2`.
fn factors_in(name: &str) -> Option<String> {
    let base = name.trim_end_matches(|last: char| last.is_ascii_digit());
    if base.len() < name.len() && is_unit(base) {
        return Some(format!("{base}^{}", &name[base.len()..]));
    }
    let mut cuts = name.char_indices().skip(1).map(|(cut, _)| name.split_at(cut));
    let found = cuts.find(|(first, second)| is_unit(first) && is_unit(second));
    found.map(|(first, second)| format!("{first} {second}"))
}

/// `kg m^2/s`, `1/(m^2 s^2)`, `m^(1/2)`.
fn symbol_of(factors: impl Iterator<Item = (String, (i8, i8))>) -> String {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for (name, (numerator, denominator)) in factors {
        let list = if numerator < 0 { &mut below } else { &mut above };
        list.push(match (numerator.unsigned_abs(), denominator) {
            (1, 1) => name,
            (power, 1) => format!("{name}^{power}"),
            (power, root) => format!("{name}^({power}/{root})"),
        });
    }
    let above =
        if above.is_empty() && !below.is_empty() { "1".to_string() } else { above.join(" ") };
    match below.as_slice() {
        [] => above,
        [one] => format!("{above}/{one}"),
        _ => format!("{above}/({})", below.join(" ")),
    }
}

#[cfg(test)]
mod tests;
