//! What a linkage has beside its outputs.

use super::QuantityInfo;
use crate::program::Closing;
use crate::syntax::tree::Distribution;
use crate::token::Span;

/// What a linkage has beside its outputs.
#[derive(Clone, Debug)]
pub struct LinkageInfo {
    /// Range of each driver.
    pub ranges: Vec<RangeInfo>,
    /// The coordinates that the loops determine.
    pub dependents: Vec<DependentInfo>,
    /// The scalar equations of the loops.
    pub loops: Vec<LoopInfo>,
    /// Equations that are closed together, each after those it needs.
    pub groups: Vec<GroupInfo>,
    /// What influence coefficients are taken by.
    pub variables: Vec<VariableInfo>,
}

/// Where a driver moves, SI units.
#[derive(Clone, Debug)]
pub struct RangeInfo {
    /// Where a sweep begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Where the start values of the dependent coordinates are meant.
    pub start: f64,
    /// Period after which the linkage is where it was; infinite if there is none.
    pub period: f64,
    /// Permitted error of the position with its distribution; zero if none is stated.
    pub tolerance: (f64, Distribution),
}

/// A dependent coordinate.
#[derive(Clone, Debug)]
pub struct DependentInfo {
    /// Name and unit.
    pub quantity: QuantityInfo,
    /// Whether it is an angle, the same after a turn.
    pub is_angle: bool,
}

/// A scalar loop equation.
#[derive(Clone, Debug)]
pub struct LoopInfo {
    /// Name, `loop.x`.
    pub name: String,
    /// Unit of its sides.
    pub unit: String,
    /// SI value of one such unit.
    pub factor: f64,
    /// Where it stands in the file.
    pub span: Span,
}

/// Equations that are closed together.
#[derive(Clone, Debug)]
pub struct GroupInfo {
    /// How they are solved.
    pub kind: GroupKind,
    /// Indices of the scalar equations.
    pub equations: Vec<usize>,
    /// Indices of the dependent coordinates.
    pub unknowns: Vec<usize>,
}

/// What an influence coefficient is taken by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableInfo {
    /// The constant of this index.
    Constant(usize),
    /// The driver of this index.
    Driver(usize),
}

/// Points that are joined.
#[derive(Clone, Debug)]
pub struct LinkInfo {
    /// Indices of the points, in the order of the line.
    pub points: Vec<usize>,
    /// What it is.
    pub text: String,
}

/// How the unknowns of a group are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupKind {
    /// Equations that are linear in displacements.
    Linear,
    /// One equation `A cos φ + B sin φ = C`.
    Angle,
    /// One equation with the square of a displacement: a distance.
    Distance,
    /// Two links joined by a pivot, each turning.
    Rrr,
    /// A link that turns and a slide.
    Rrp,
    /// A slide that turns about a pivot.
    Rpr,
    /// Anything else.
    General,
}

impl<T: Copy> Closing<T> {
    /// What one position takes: the closed forms, and of a group that has none one iteration.
    pub fn of_position(&self, groups: &[GroupInfo]) -> Vec<T> {
        let mut wanted = Vec::new();
        for (form, group) in self.groups.iter().zip(groups) {
            match form {
                Some(form) => {
                    wanted.extend(form.values.iter().map(|value| value.1));
                    wanted.push(form.sine);
                }
                None => {
                    wanted.extend(group.equations.iter().map(|&index| self.residuals[index]));
                    let slopes = self.slopes.iter();
                    let own = slopes.filter(|slope| {
                        group.equations.contains(&slope.0) && group.unknowns.contains(&slope.1)
                    });
                    wanted.extend(own.map(|slope| slope.2));
                }
            }
        }
        wanted
    }
}

/// The closures of a motion that are not solved for: all positions are coordinates, which they hold.
#[derive(Clone, Debug)]
pub struct AugmentedInfo {
    /// The scalar equations.
    pub loops: Vec<LoopInfo>,
    /// How many of them are independent in general.
    pub rank: usize,
    /// How large the slopes of each are by the coordinates.
    pub sizes: Vec<f64>,
    /// The coordinates whose start values are kept; the closures determine the others.
    pub kept: Vec<usize>,
    /// Equations that follow from the others.
    pub redundant: Vec<usize>,
}
