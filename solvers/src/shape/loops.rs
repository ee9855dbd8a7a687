//! The loops of a linkage.

#[cfg(test)]
use super::{Constant, Shape, Unit};
use super::{Distribution, List, Quantity, Text};

/// The loops of a scene as data.
#[derive(Clone, Copy, Debug)]
pub struct LinkageEntry {
    /// The coordinates that the loops determine.
    pub dependents: List<Quantity>,
    /// The scalar loop equations.
    pub loops: List<Loop>,
    /// Which dependent coordinates are angles, the same after a turn.
    pub angles: List<bool>,
    /// Where a position keeps the cosine of each, the sine behind it, if it does; none for those that are not listed.
    pub cosines: List<Option<usize>>,
    /// Equations that are closed together, each group after those it needs.
    pub groups: List<Group>,
    /// What influence coefficients are taken by.
    pub variables: List<Variable>,
    /// Length of what says how the drivers move: their speeds, their accelerations, the time; 0 where they are swept.
    pub motion: usize,
    /// Whether there are second derivatives.
    pub second: bool,
    /// Permitted error of each driver, SI units (zero if none is stated), with its distribution.
    pub tolerances: List<(f64, Distribution)>,
}

impl LinkageEntry {
    /// Nothing that closes.
    pub const NONE: Self = Self {
        dependents: &[],
        loops: &[],
        angles: &[],
        cosines: &[],
        groups: &[],
        variables: &[],
        motion: 0,
        second: false,
        tolerances: &[],
    };

    /// Whether a group is iterated.
    #[inline]
    pub fn is_iterated(&self) -> bool {
        let mut groups = self.groups.iter();
        groups.any(|group| group.kind == GroupKind::General)
    }

    /// Number of equations of the largest group.
    #[inline]
    pub fn largest(&self) -> usize {
        let sizes = self.groups.iter().map(|group| group.unknowns.len());
        sizes.max().unwrap_or(0)
    }
}

/// The closures of a motion that are not solved for: all positions are coordinates, which they hold.
#[derive(Clone, Copy, Debug)]
pub struct Augmented {
    /// Number of coordinates.
    pub coordinates: usize,
    /// The scalar closures.
    pub loops: List<Loop>,
    /// How many of them are independent in general.
    pub rank: usize,
    /// How large the slopes of each are by the coordinates.
    pub sizes: List<f64>,
    /// The coordinates whose start values are kept; the closures determine the others.
    pub kept: List<usize>,
    /// Closures that follow from the others.
    pub redundant: List<usize>,
}

/// How the unknowns of a group are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupKind {
    /// Equations that are linear in displacements: one solution. Two of them are a PRP or RPP dyad.
    Linear,
    /// One equation `A cos φ + B sin φ = C`: two solutions.
    Angle,
    /// One equation with the square of a displacement, `a s² + 2 b s + c = 0`, as of a distance: two solutions.
    Distance,
    /// Two links joined by a pivot, each turning: two circles meet.
    Rrr,
    /// A link that turns and a slide: a circle meets a line.
    Rrp,
    /// A slide that turns about a pivot, its displacement and its angle unknown.
    Rpr,
    /// None of these: iteration.
    General,
}

impl GroupKind {
    /// Whether the group has two assembly modes in closed form.
    pub fn has_modes(self) -> bool {
        !matches!(self, GroupKind::Linear | GroupKind::General)
    }
}

/// Loop equations that are closed together.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// How they are solved.
    pub kind: GroupKind,
    /// Indices of the dependent coordinates that they determine.
    pub unknowns: &'static [usize],
    /// Indices of the scalar equations.
    pub equations: &'static [usize],
}

/// What an influence coefficient is taken by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The constant of this index.
    Constant(usize),
    /// The position of the driver of this index.
    Driver(usize),
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
        Self { name, unit, factor, line }
    }
}

impl Link {
    /// A line through some points.
    #[doc(hidden)]
    pub const fn new(points: List<usize>, text: Text) -> Self {
        Self { points, text }
    }
}

/// The shape of a linkage that a test writes by hand, of one driver: how many constants and outputs it has, which dependent
/// coordinates are angles, its groups, and what influence coefficients are taken by.
#[cfg(test)]
pub(crate) const fn by_hand(
    [constants, outputs]: [usize; 2],
    angles: List<bool>,
    groups: List<Group>,
    variables: List<Variable>,
) -> Shape {
    const QUANTITIES: List<Quantity> = &[Quantity::new("", "", Unit::NONE); 4];
    let dependents = QUANTITIES.split_at(angles.len()).0;
    const CONSTANTS: List<Constant> = &[Constant::parameter(QUANTITIES[0], 0.0, 1.0); 10];
    Shape::named("")
        .constants(CONSTANTS.split_at(constants).0)
        .drivers(QUANTITIES.split_at(1).0)
        .outputs(QUANTITIES.split_at(outputs).0)
        .linkage(LinkageEntry { dependents, angles, groups, variables, ..LinkageEntry::NONE })
}
