//! Typed values: an expression, or several, with the kind of quantity that it is.

use crate::expression::Expression;
use crate::homogeneity::describe;
use crate::unit::Dimension;

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

/// What a term means.
#[derive(Clone, Debug)]
pub enum Typed {
    /// A number with its kind.
    Scalar {
        /// Its value in SI units.
        value: Expression,
        /// Its kind.
        kind: Kind,
        /// Whether it is certainly the time derivative of something that depends on positions and time alone.
        rate: bool,
    },
    /// Two or three numbers of one kind.
    Vector {
        /// Components.
        values: Vec<Expression>,
        /// Their kind.
        kind: Kind,
        /// As for a scalar, for all components.
        rate: bool,
    },
    /// The rotation matrix of `rot(a)`, `rotx(a)` and so on, row by row.
    Matrix(Vec<Vec<Expression>>),
    /// A condition.
    Condition(Expression),
    /// A condition on effects and choices, decided by the compiler.
    Decided(bool),
    /// Nothing, after an error that has been reported: whatever touches it says no more.
    Wrong,
}

/// What two equal meanings have in common: variant and rate, kind, values.
pub(super) type Key = (u8, Option<[(i8, i8); 7]>, Vec<Expression>);

impl Typed {
    /// The same for equal meanings, and for no others. A value alone would not do: `2` and `2 m` have the same one.
    pub(super) fn key(&self) -> Key {
        let dimension = |kind: &Kind| match kind {
            Kind::Any => None,
            Kind::Of(dimension) => Some(dimension.exponents()),
        };
        match self {
            Typed::Scalar { value, kind, rate } => (u8::from(*rate), dimension(kind), vec![*value]),
            Typed::Vector { values, kind, rate } => {
                (2 + u8::from(*rate), dimension(kind), values.clone())
            }
            Typed::Matrix(rows) => (4, None, rows.concat()),
            Typed::Condition(value) => (5, None, vec![*value]),
            Typed::Decided(held) => (6 + u8::from(*held), None, Vec::new()),
            Typed::Wrong => (8, None, Vec::new()),
        }
    }

    /// The value of a number, the components of a vector.
    pub(super) fn values(&self) -> &[Expression] {
        match self {
            Typed::Scalar { value, .. } => std::slice::from_ref(value),
            Typed::Vector { values, .. } => values,
            _ => &[],
        }
    }

    /// A number that is no rate.
    pub fn scalar(value: Expression, kind: Kind) -> Self {
        Typed::Scalar {
            value,
            kind,
            rate: false,
        }
    }

    /// A pure number.
    pub fn number(value: Expression) -> Self {
        Self::scalar(value, Kind::NUMBER)
    }

    /// What it is, for messages.
    pub fn describe(&self) -> String {
        match self {
            Typed::Scalar {
                kind: Kind::Any, ..
            } => "zero".into(),
            Typed::Scalar {
                kind: Kind::Of(dimension),
                ..
            } => describe(*dimension),
            Typed::Vector { values, kind, .. } => {
                format!(
                    "a vector of {} components ({})",
                    values.len(),
                    describe(kind.dimension())
                )
            }
            Typed::Matrix(rows) => format!("a rotation in {} dimensions", rows.len()),
            Typed::Condition(_) | Typed::Decided(_) => "a condition".into(),
            Typed::Wrong => "a mistake".into(),
        }
    }
}
