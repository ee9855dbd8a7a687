//! The loops of a linkage.

use super::{Distribution, List, Quantity, Text};
use crate::closure::{Group, Variable};

/// The loops of a scene as data.
#[derive(Clone, Copy, Debug)]
pub struct LinkageEntry {
    /// The coordinates that the loops determine.
    pub dependents: List<Quantity>,
    /// The scalar loop equations.
    pub loops: List<Loop>,
    /// Equations that are closed together, each group after those it needs.
    pub groups: List<Group>,
    /// What influence coefficients are taken by.
    pub variables: List<Variable>,
    /// Permitted error of each driver, SI units (zero if none is stated), with its distribution.
    pub tolerances: List<(f64, Distribution)>,
    /// Names of the points.
    pub points: List<Text>,
    /// Lines between them.
    pub links: List<Link>,
}

/// A scalar loop equation.
#[derive(Clone, Copy, Debug)]
pub struct Loop {
    /// Name, `loop.x`.
    pub name: Text,
    /// Unit of its sides.
    pub unit: Text,
    /// SI value of one such unit.
    pub factor: f64,
    /// Line in the equation file, from 1.
    pub line: u32,
}

/// Points that are joined.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Indices of the points, in the order of the line.
    pub points: List<usize>,
    /// What it is; may be empty.
    pub text: Text,
}

impl Loop {
    /// A loop equation of a line of the file.
    #[doc(hidden)]
    pub const fn new(line: u32, name: Text, unit: Text, factor: f64) -> Self {
        Self {
            name,
            unit,
            factor,
            line,
        }
    }
}

impl Link {
    /// A line through some points.
    #[doc(hidden)]
    pub const fn new(points: List<usize>, text: Text) -> Self {
        Self { points, text }
    }
}
