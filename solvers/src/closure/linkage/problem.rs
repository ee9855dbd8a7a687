//! What the closure solvers ask of a linkage: the two traits that emitted code implements.
//!
//! A linkage is its loops: equations `F(z; x, p) = 0` in the dependent coordinates `z`, for positions `x` of the drivers
//! and dimensions `p`. The compiler has ordered them into groups, each
//! closed after those it needs: an Assur group of two links in closed form with an explicit assembly mode, anything
//! larger by iteration. All quantities are in SI units, angles in radians.

use crate::problem::{Refused, Span, Storage};
use crate::scalar::Scalar;
use crate::shape::Shape;

/// The loops of one linkage with its dimensions fixed. The methods neither allocate nor panic; what does not exist is
/// NaN.
pub trait Closure<S: Scalar>: Send + Sync + 'static {
    /// A position: the dependent coordinates `z` first, in their declared order, then whatever the model keeps beside
    /// them (sines and cosines of those that are angles). A coordinate of a group is valid once the group is closed.
    type Position: Storage<S>;
    /// A row of what depends on the independent variables alone.
    type Instant: Storage<S>;
    /// Room for the rows of the largest group: its number of equations.
    type Row: Storage<S>;
    /// Room for the square matrix of the largest group: the square of that number.
    type Matrix: Storage<S>;

    /// What the linkage is made of: a constant, so that what is compiled for these loops alone knows it.
    fn shape(&self) -> &'static Shape;

    /// A position with all entries zero.
    fn zeros(&self) -> Self::Position;

    /// Values that depend on the independent variables alone.
    fn instant(&self, independents: &[S]) -> Self::Instant;

    /// What depends on the drivers alone, with how they move, which outputs may need; without it they are NaN. Length:
    /// [`LinkageEntry::motion`](crate::shape::LinkageEntry::motion).
    #[inline(always)]
    fn moving(&self, independents: &[S], _motion: &[S]) -> Self::Instant {
        self.instant(independents)
    }

    /// Closes a group in closed form: writes its unknowns (angles within `±π`) and returns the sine of its transmission
    /// angle: the determinant of its Jacobian over the product of the lengths of its columns, with the sign of `mode`.
    /// Of angles that count from each other the columns are those of the directions of the links.
    /// Zero is a dead point; NaN says that the group does not assemble. Groups it depends on must be closed.
    ///
    /// For [`GroupKind::Linear`](crate::shape::GroupKind::Linear) `mode` is without effect, and the sine is that between the
    /// two directions (±1 for a single equation). A group of kind [`GroupKind::General`](crate::shape::GroupKind::General)
    /// gives NaN.
    fn close(
        &self,
        group: usize,
        instant: &Self::Instant,
        mode: S,
        position: &mut Self::Position,
    ) -> S;

    /// Closes all groups of a linkage of which none is iterated, with their modes, and writes the sine of each: the same
    /// values as from [`Closure::close`], group after group. Shape of both: the number of groups. Angles of which a position
    /// keeps cosine and sine ([`LinkageEntry::cosines`](crate::shape::LinkageEntry::cosines)) may be left out.
    #[inline(always)]
    fn close_all(
        &self,
        instant: &Self::Instant,
        modes: &[S],
        position: &mut Self::Position,
        sines: &mut [S],
        _angles: bool,
    ) {
        for (group, (mode, sine)) in modes.iter().zip(sines).enumerate() {
            *sine = self.close(group, instant, *mode, position);
        }
    }

    /// By how much a group in closed form assembles, in the unit of its equations (metres for loops of lengths):
    /// negative is the gap that is left, zero a dead point.
    fn margin(&self, group: usize, instant: &Self::Instant, position: &Self::Position) -> S;

    /// Completes a position of which the unknowns of a group (the first entries) have been set, and writes the
    /// residuals of its `n` equations and their Jacobian by its unknowns: `jacobian.as_ref()[i*n + j] = ∂F_i/∂z_j`, in the
    /// order of [`Group::equations`](crate::shape::Group::equations) and [`Group::unknowns`](crate::shape::Group::unknowns).
    /// For groups of every kind.
    fn trial(
        &self,
        group: usize,
        instant: &Self::Instant,
        position: &mut Self::Position,
        residual: &mut Self::Row,
        jacobian: &mut Self::Matrix,
    );

    /// Writes the residuals of all equations at a closed position; shape: the number of dependent coordinates.
    fn residual(&self, instant: &Self::Instant, position: &Self::Position, residual: &mut [S]);

    /// Writes the kinematic coefficients: `columns[k].as_ref()[i] = ∂z_i/∂x_k` for the drivers `k` and the dependent
    /// coordinates `i`, which are the first entries.
    fn coefficients(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        columns: &mut [Self::Position],
    );

    /// Writes the outputs, in their declared order.
    fn outputs(&self, instant: &Self::Instant, position: &Self::Position, values: &mut [S]);

    /// Writes the influence coefficients: `values[i*variables + j]` is the derivative of output `i` by variable `j`,
    /// with the loops closed.
    fn influence(&self, instant: &Self::Instant, position: &Self::Position, values: &mut [S]);

    /// Writes the second derivatives: for each output the lower triangle, row by row, `variables*(variables + 1)/2`
    /// values. A linkage that has none ([`LinkageEntry::second`](crate::shape::LinkageEntry::second)) writes nothing.
    fn second_influence(
        &self,
        instant: &Self::Instant,
        position: &Self::Position,
        values: &mut [S],
    );

    /// Writes the quantities that measures look at.
    fn measured(&self, _instant: &Self::Instant, _position: &Self::Position, _values: &mut [S]) {}

    /// Writes the measures, from what has been found of the positions.
    fn measures(&self, _found: &[S], _values: &mut [S]) {}

    /// Writes the points, x and y of each.
    fn points(&self, instant: &Self::Instant, position: &Self::Position, values: &mut [S]);
}

/// Where a driver moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Where it begins, and where a sweep does.
    pub from: f64,
    /// Where a sweep ends; `from` for an independent variable that stands still.
    pub to: f64,
    /// The value for which the start values of the dependent coordinates are meant.
    pub start: f64,
    /// The period after which the linkage is where it was, 2π for a turning crank; infinite if there is none.
    pub period: f64,
}

/// A linkage with its dimensions: the type that a user fills in and hands to a solver.
pub trait Linkage: Clone + Send + Sync + 'static {
    /// The loops, prepared for a scalar type.
    type Closure<S: Scalar>: Closure<S>;

    /// What the linkage is made of.
    fn shape(&self) -> &'static Shape;

    /// All constants, SI units, in their order.
    fn values(&self) -> Vec<f64>;

    /// The linkage with other constants.
    fn with_values(&self, values: &[f64]) -> Self;

    /// Computes what depends on the constants alone, from constants of any scalar type.
    fn prepare<S: Scalar>(&self, values: &[S]) -> Self::Closure<S>;

    /// The same for other constants, in the place of what has been prepared.
    #[inline(always)]
    fn renew<S: Scalar>(&self, closure: &mut Self::Closure<S>, values: &[S]) {
        *closure = self.prepare(values);
    }

    /// Whether linkages made at random are closed several side by side. Compiled for a linkage that takes as long as all else
    /// that is; emitted ones are where they state a tolerance, in builds without `debug_assertions`. A `bool`, since of a
    /// `match` on a constant of an enum rustc compiles every arm.
    const PACKED: bool = true;

    /// Whether it is sought: linkages of its kind are then looked at side by side. The others spare what that takes to compile.
    const IS_SOUGHT: bool = true;

    /// Whether it searches, or solves loops that contradict each other, and so goes separate ways for different numbers: side by
    /// side it would end otherwise than alone.
    fn is_apart(&self) -> bool {
        false
    }

    /// Checks the conditions that the mechanism puts on its values.
    ///
    /// # Errors
    /// The first condition that does not hold, with the values concerned.
    fn check(&self) -> Result<(), Refused>;

    /// The task of the scene: a time, or [`Span::Open`] where drivers are swept.
    fn span(&self) -> Span;

    /// The independent variables at a time, and behind them how the drivers move; none where they do not move in time.
    fn drive(&self, time: f64) -> Option<Vec<f64>>;

    /// The range of each driver; NaN where none is stated.
    fn ranges(&self) -> Vec<Range>;

    /// Rough values of the dependent coordinates at the start, which pick the assembly mode; NaN where none is stated.
    fn start(&self) -> Vec<f64>;
}
