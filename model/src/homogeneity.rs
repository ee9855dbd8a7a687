//! Every equation balances in its units: the rules by which kinds of quantities combine.

use crate::diagnostic::Diagnostic;
use crate::token::Span;
use crate::unit::{Dimension, Unit};

/// Kind of a quantity. A literal zero fits everywhere, so its kind is open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Zero, of any kind.
    Any,
    /// A quantity with this dimension.
    Of(Dimension),
}

impl Kind {
    /// A pure number.
    pub const NUMBER: Kind = Kind::Of(Dimension::NONE);

    /// The dimension, that of a pure number where it is open.
    pub fn dimension(self) -> Dimension {
        match self {
            Kind::Any => Dimension::NONE,
            Kind::Of(dimension) => dimension,
        }
    }
}

/// Kinds of quantities that have a name of their own: unit and name.
const NAMED: &[(&str, &str)] = &[
    ("m", "a length"),
    ("m^2", "an area"),
    ("kg", "a mass"),
    ("s", "a time"),
    ("1/s", "a rate or angular velocity"),
    ("1/s^2", "an angular acceleration"),
    ("m/s", "a velocity"),
    ("m/s^2", "an acceleration"),
    ("N", "a force"),
    ("N m", "a torque or energy"),
    ("N/m", "a stiffness"),
    ("N s/m", "a damping coefficient"),
    ("N m s", "a rotary damping coefficient"),
    ("m/N", "a flexibility"),
    ("kg m^2", "a moment of inertia"),
    ("W", "a power"),
    ("Pa", "a stress or pressure"),
];

/// A kind of quantity in words: `a length (m)`, `a pure number`.
pub fn describe(dimension: Dimension) -> String {
    if dimension == Dimension::NONE {
        return "a pure number".into();
    }
    let known = NAMED.iter().find(|(unit, _)| {
        crate::unit::parse_unit_text(unit).is_ok_and(|unit| unit.dimension == dimension)
    });
    let symbol = Unit::for_dimension(&dimension).symbol;
    match known {
        Some((_, name)) => format!("{name} ({symbol})"),
        None => format!("a quantity in {symbol}"),
    }
}

/// Says that something is of one kind and what it is given of another one.
pub fn unlike(what: &str, expected: Kind, found: Kind) -> String {
    let [expected, found] = [expected, found].map(|kind| describe(kind.dimension()));
    format!("{what} is {expected}, and this is {found}")
}

/// The kind of a sum, a comparison or an equation, whose two sides must agree.
pub fn agree(left: Kind, right: Kind) -> Option<Kind> {
    match (left, right) {
        (Kind::Any, other) | (other, Kind::Any) => Some(other),
        (Kind::Of(a), Kind::Of(b)) => (a == b).then_some(left),
    }
}

/// Reports two sides that do not agree.
pub fn disagreement(
    what: &str,
    (left_span, left): (Span, Kind),
    (right_span, right): (Span, Kind),
) -> Diagnostic {
    let (a, b) = (left.dimension(), right.dimension());
    let message = format!("{what} {} and {}", describe(a), describe(b));
    let report = Diagnostic::error(left_span.to(right_span), message);
    let quotient = a.div(&b);
    let hint = match quotient {
        _ if a == Dimension::NONE || b == Dimension::NONE => {
            "a bare number has no unit: give it one, as in `75 mm` or `0.1 [kg m^2]`".to_string()
        }
        Some(quotient) => {
            format!("the sides differ by a factor in {}", Unit::for_dimension(&quotient).symbol)
        }
        None => "look for a missing factor".to_string(),
    };
    report.hint(hint)
}

/// What to do about a value that is not of the kind of what it is given to.
pub fn fitting_value(kind: Kind, target: &str) -> String {
    let unit = Unit::for_dimension(&kind.dimension()).symbol;
    match unit.as_str() {
        "" => format!("give `{target}` a pure number"),
        unit => format!("give `{target}` a value in {unit}"),
    }
}

/// The kind of a product.
pub fn times(left: Kind, right: Kind) -> Option<Kind> {
    match (left, right) {
        (Kind::Any, _) | (_, Kind::Any) => Some(Kind::Any),
        (Kind::Of(a), Kind::Of(b)) => a.mul(&b).map(Kind::Of),
    }
}

/// The kind of a quotient.
pub fn over(left: Kind, right: Kind) -> Option<Kind> {
    match (left, right) {
        (Kind::Any, _) => Some(Kind::Any),
        (Kind::Of(a), Kind::Any) => Some(Kind::Of(a)),
        (Kind::Of(a), Kind::Of(b)) => a.div(&b).map(Kind::Of),
    }
}

/// The kind of a power with a fixed exponent.
pub fn power(base: Kind, exponent: f64) -> Option<Kind> {
    match base {
        Kind::Any => Some(Kind::Any),
        Kind::Of(dimension) if dimension == Dimension::NONE => Some(base),
        Kind::Of(dimension) => {
            let denominator = (1..=12).find(|d| (exponent * f64::from(*d)).fract() == 0.0)?;
            let numerator = exponent * f64::from(denominator);
            if numerator.abs() > 60.0 {
                return None;
            }
            dimension.pow(numerator as i8, denominator as i8).map(Kind::Of)
        }
    }
}
