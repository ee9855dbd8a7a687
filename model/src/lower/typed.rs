//! Typed values: an expression, or several, with the kind of quantity that it is.

use crate::expression::Expression;
use crate::homogeneity::{Kind, describe};

/// A number, or the two or three components of a vector, of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// The components; those that a number or a vector of two does not have repeat the first one.
    components: [Expression; 3],
    count: usize,
    /// Their kind.
    pub kind: Kind,
    /// Whether all are certainly time derivatives of something that depends on positions and time alone.
    pub rate: bool,
}

impl Quantity {
    /// A number, or a vector of two or three components, that is no rate.
    pub fn of(values: &[Expression], kind: Kind) -> Self {
        Self {
            components: [0, 1, 2].map(|index| *values.get(index).unwrap_or(&values[0])),
            count: values.len(),
            kind,
            rate: false,
        }
    }

    /// The value of a number, the components of a vector.
    pub fn values(&self) -> &[Expression] {
        &self.components[..self.count]
    }

    /// Whether it is a vector.
    pub fn is_vector(&self) -> bool {
        self.count > 1
    }

    /// Its value and kind, if it is a number.
    pub fn as_number(&self) -> Option<(Expression, Kind)> {
        (!self.is_vector()).then_some((self.components[0], self.kind))
    }

    /// Whether it has as many components as another one.
    pub fn is_like(&self, other: &Self) -> bool {
        self.count == other.count
    }

    /// Another value, of a kind, in the place of each; it is no rate.
    pub fn map(&self, kind: Kind, new: impl FnMut(Expression) -> Expression) -> Self {
        let values: Vec<_> = self.values().iter().copied().map(new).collect();
        Self::of(&values, kind)
    }

    /// The value, marked as a rate or as none.
    pub fn rated(self, rate: bool) -> Typed {
        Typed::Quantity(Self { rate, ..self })
    }

    /// What two with equally many components come to, component by component; it is no rate.
    pub fn with(
        &self,
        other: &Self,
        kind: Kind,
        mut new: impl FnMut(Expression, Expression) -> Expression,
    ) -> Self {
        let pairs = self.values().iter().zip(other.values());
        let values: Vec<_> = pairs.map(|(a, b)| new(*a, *b)).collect();
        Self::of(&values, kind)
    }
}

/// What a term means.
#[derive(Clone, Debug)]
pub enum Typed {
    /// A number or a vector.
    Quantity(Quantity),
    /// The rotation matrix of `rot(a)`, `rotx(a)` and so on, row by row.
    Matrix(Vec<Vec<Expression>>),
    /// A condition.
    Condition(Expression),
    /// A condition on effects and choices, decided by the compiler.
    Decided(bool),
    /// Nothing, after an error that has been reported: whatever touches it says no more.
    Wrong,
}

impl From<Quantity> for Typed {
    fn from(quantity: Quantity) -> Self {
        Typed::Quantity(quantity)
    }
}

/// What two equal meanings have in common: variant and rate, kind, values.
pub(super) type Key = (u8, Option<[(i8, i8); 7]>, Vec<Expression>);

impl Typed {
    /// A key that equal meanings share, and no others. A value alone would not do: `2` and `2 m` have the same one.
    pub(super) fn key(&self) -> Key {
        let dimension = |kind: &Kind| match kind {
            Kind::Any => None,
            Kind::Of(dimension) => Some(dimension.exponents()),
        };
        match self {
            Typed::Quantity(one) => {
                let variant = 2 * u8::from(one.is_vector()) + u8::from(one.rate);
                (variant, dimension(&one.kind), one.values().to_vec())
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
            Typed::Quantity(quantity) => quantity.values(),
            _ => &[],
        }
    }

    /// Its value and kind, if it is a number.
    pub fn as_number(&self) -> Option<(Expression, Kind)> {
        match self {
            Typed::Quantity(quantity) => quantity.as_number(),
            _ => None,
        }
    }

    /// A number that is no rate.
    pub fn scalar(value: Expression, kind: Kind) -> Self {
        Quantity::of(&[value], kind).into()
    }

    /// A pure number.
    pub fn number(value: Expression) -> Self {
        Self::scalar(value, Kind::NUMBER)
    }

    /// What it is, for messages.
    pub fn describe(&self) -> String {
        match self {
            Typed::Quantity(one) if one.is_vector() => {
                let (count, kind) = (one.count, describe(one.kind.dimension()));
                format!("a vector of {count} components ({kind})")
            }
            Typed::Quantity(one) => match one.kind {
                Kind::Any => "zero".into(),
                Kind::Of(dimension) => describe(dimension),
            },
            Typed::Matrix(rows) => format!("a rotation in {} dimensions", rows.len()),
            Typed::Condition(_) | Typed::Decided(_) => "a condition".into(),
            Typed::Wrong => "a mistake".into(),
        }
    }
}
