//! Which kind of quantity a variable is, told by its dimension and unit.

use crate::ask::variables::{Dimension, Variable};

/// A kind of quantity: what may share a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Length and its derivatives, by their order.
    Translation(u8),
    /// Angle and its derivatives, by their order.
    Rotation(u8),
    /// Force.
    Force,
    /// Torque.
    Torque,
    /// Energy.
    Energy,
    /// Power.
    Power,
    /// Anything else, told apart by its dimension.
    Other(Dimension),
}

impl Kind {
    /// The kind of a variable.
    pub fn of(variable: &Variable) -> Self {
        let exponents: [f64; 7] =
            variable.dimension.map(|(up, down)| f64::from(up) / f64::from(down.max(1)));
        // A derivative by an angle has the dimension of what it is taken of.
        if variable.unit.ends_with("/rad") {
            return Self::Other(variable.dimension);
        }
        if exponents[3..].iter().any(|exponent| *exponent != 0.0) {
            return Self::Other(variable.dimension);
        }
        let angular = ["rad", "deg", "rpm"].iter().any(|unit| variable.unit.starts_with(unit));
        match exponents[..3] {
            [1.0, 0.0, 0.0] => Self::Translation(0),
            [1.0, 0.0, -1.0] => Self::Translation(1),
            [1.0, 0.0, -2.0] => Self::Translation(2),
            [0.0, 0.0, 0.0] if angular => Self::Rotation(0),
            [0.0, 0.0, -1.0] => Self::Rotation(1),
            [0.0, 0.0, -2.0] => Self::Rotation(2),
            [1.0, 1.0, -2.0] => Self::Force,
            [2.0, 1.0, -2.0] if variable.unit.ends_with('J') => Self::Energy,
            [2.0, 1.0, -2.0] => Self::Torque,
            [2.0, 1.0, -3.0] => Self::Power,
            _ => Self::Other(variable.dimension),
        }
    }

    /// Heading of a panel.
    pub fn title(self) -> &'static str {
        match self {
            Self::Translation(0) => "Displacement",
            Self::Translation(1) => "Velocity",
            Self::Translation(_) => "Acceleration",
            Self::Rotation(0) => "Angle",
            Self::Rotation(1) => "Angular velocity",
            Self::Rotation(_) => "Angular acceleration",
            Self::Force => "Force",
            Self::Torque => "Torque",
            Self::Energy => "Energy",
            Self::Power => "Power",
            Self::Other(_) => "",
        }
    }

    /// The column that it belongs to, if to one, and its place among the panels.
    pub fn rank(self) -> (Option<usize>, u8) {
        match self {
            Self::Translation(order) => (Some(0), order),
            Self::Force => (Some(0), 3),
            Self::Rotation(order) => (Some(1), order),
            Self::Torque => (Some(1), 3),
            Self::Energy => (None, 4),
            Self::Power => (None, 5),
            Self::Other(_) => (None, 6),
        }
    }

    /// Curves of one family have colours of their own: a coordinate keeps its colour in its derivatives.
    pub fn family(self) -> Self {
        match self {
            Self::Translation(_) => Self::Translation(0),
            Self::Rotation(_) => Self::Rotation(0),
            other => other,
        }
    }

    /// Whether it is a position, a displacement or an angle.
    pub fn is_position(self) -> bool {
        matches!(self, Self::Translation(0) | Self::Rotation(0))
    }
}
