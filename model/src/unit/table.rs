//! Units as data.

use super::dimension::Dimension;
use super::factor::Factor;

/// A unit with a name of its own.
pub struct Named {
    /// Symbol.
    pub symbol: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// Its size in SI units.
    pub factor: Factor,
    /// Whether it takes prefixes.
    pub prefixed: bool,
}

/// Prefixes and their factors.
pub const PREFIXES: &[(&str, Factor)] = &[
    ("p", Factor::ratio(1, 1_000_000_000_000)),
    ("n", Factor::ratio(1, 1_000_000_000)),
    ("u", Factor::ratio(1, 1_000_000)),
    ("µ", Factor::ratio(1, 1_000_000)),
    ("m", Factor::ratio(1, 1000)),
    ("c", Factor::ratio(1, 100)),
    ("d", Factor::ratio(1, 10)),
    ("h", Factor::ratio(100, 1)),
    ("k", Factor::ratio(1000, 1)),
    ("M", Factor::ratio(1_000_000, 1)),
    ("G", Factor::ratio(1_000_000_000, 1)),
    ("T", Factor::ratio(1_000_000_000_000, 1)),
];

const fn si(symbol: &'static str, exponents: [i8; 7]) -> Named {
    Named { symbol, dimension: Dimension::whole(exponents), factor: Factor::ONE, prefixed: true }
}

const fn other(
    symbol: &'static str,
    exponents: [i8; 7],
    numerator: u64,
    denominator: u64,
) -> Named {
    let factor = Factor::ratio(numerator, denominator);
    Named { symbol, dimension: Dimension::whole(exponents), factor, prefixed: false }
}

const fn angle(symbol: &'static str, per_second: i8, numerator: u64, denominator: u64) -> Named {
    let factor = Factor::ratio_pi(numerator, denominator);
    Named {
        symbol,
        dimension: Dimension::whole([0, 0, -per_second, 0, 0, 0, 0]),
        factor,
        prefixed: false,
    }
}

/// All units. A whole name goes before a prefix with a shorter one (`min` is no milli-inch, `cd` no centi-day).
///
/// The inch is `inch`, because `in` begins a range. There is no litre `l`: it is too good a name for a length.
#[rustfmt::skip]
pub const UNITS: &[Named] = &[
    //            m  kg   s   A   K mol cd
    si("m",     [ 1,  0,  0,  0,  0,  0,  0]),
    Named { factor: Factor::ratio(1, 1000), ..si("g", [0, 1, 0, 0, 0, 0, 0]) },
    si("s",     [ 0,  0,  1,  0,  0,  0,  0]),
    si("A",     [ 0,  0,  0,  1,  0,  0,  0]),
    si("K",     [ 0,  0,  0,  0,  1,  0,  0]),
    si("mol",   [ 0,  0,  0,  0,  0,  1,  0]),
    si("cd",    [ 0,  0,  0,  0,  0,  0,  1]),
    si("rad",   [ 0,  0,  0,  0,  0,  0,  0]),
    si("Hz",    [ 0,  0, -1,  0,  0,  0,  0]),
    si("N",     [ 1,  1, -2,  0,  0,  0,  0]),
    si("Pa",    [-1,  1, -2,  0,  0,  0,  0]),
    si("J",     [ 2,  1, -2,  0,  0,  0,  0]),
    si("W",     [ 2,  1, -3,  0,  0,  0,  0]),
    si("V",     [ 2,  1, -3, -1,  0,  0,  0]),
    si("C",     [ 0,  0,  1,  1,  0,  0,  0]),
    si("F",     [-2, -1,  4,  2,  0,  0,  0]),
    si("H",     [ 2,  1, -2, -2,  0,  0,  0]),
    si("ohm",   [ 2,  1, -3, -2,  0,  0,  0]),
    si("T",     [ 0,  1, -2, -1,  0,  0,  0]),
    si("Wb",    [ 2,  1, -2, -1,  0,  0,  0]),
    other("min",  [ 0, 0,  1, 0, 0, 0, 0], 60, 1),
    other("h",    [ 0, 0,  1, 0, 0, 0, 0], 3600, 1),
    other("day",  [ 0, 0,  1, 0, 0, 0, 0], 86_400, 1),
    other("t",    [ 0, 1,  0, 0, 0, 0, 0], 1000, 1),
    other("bar",  [-1, 1, -2, 0, 0, 0, 0], 100_000, 1),
    other("kgf",  [ 1, 1, -2, 0, 0, 0, 0], 980_665, 100_000),
    other("gf",   [ 1, 1, -2, 0, 0, 0, 0], 980_665, 100_000_000),
    other("tex",  [-1, 1,  0, 0, 0, 0, 0], 1, 1_000_000),
    other("inch", [ 1, 0,  0, 0, 0, 0, 0], 254, 10_000),
    other("ft",   [ 1, 0,  0, 0, 0, 0, 0], 3048, 10_000),
    other("lb",   [ 0, 1,  0, 0, 0, 0, 0], 45_359_237, 100_000_000),
    other("lbf",  [ 1, 1, -2, 0, 0, 0, 0], 44_482_216_152_605, 10_000_000_000_000),
    angle("deg",  0, 1, 180),
    angle("arcmin", 0, 1, 10_800),
    angle("arcsec", 0, 1, 648_000),
    angle("rev",  0, 2, 1),
    angle("rpm",  1, 1, 30),
];

/// Units in which computed quantities are printed when the file says nothing, most natural first.
pub const NATURAL: &[&str] = &[
    "m", "m^2", "m^3", "kg", "s", "1/s", "1/s^2", "1/s^3", "m/s", "m/s^2", "m/s^3", "N", "N m",
    "N/m", "N s/m", "N m s", "m/N", "1/(N m)", "kg m^2", "kg m", "W", "N/s", "N m/s^2", "Pa",
    "Pa s", "1/m", "1/m^2", "kg/m", "kg/m^3", "A", "V", "ohm", "K", "C", "H", "F",
];

/// A unit by its symbol, with its prefix if it has one.
pub fn find(symbol: &str) -> Option<(Dimension, Factor)> {
    let named = |symbol: &str| UNITS.iter().find(|unit| unit.symbol == symbol);
    if let Some(unit) = named(symbol) {
        return Some((unit.dimension, unit.factor));
    }
    PREFIXES.iter().find_map(|(prefix, factor)| {
        let unit = named(symbol.strip_prefix(prefix)?).filter(|unit| unit.prefixed)?;
        Some((unit.dimension, unit.factor.times(*factor)))
    })
}
