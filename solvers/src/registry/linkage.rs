//! What a scene has and does that is a linkage.

use super::limits::RunLimits;
use super::path::{self, Path};
use super::tolerance::RunTolerance;
use crate::closure::{ClosureError, Linkage, Range};
use crate::problem::{Refused, Span};

/// A linkage whose dimensions are fixed, ready to be moved.
pub trait RunLinkage: RunLimits + RunTolerance + Send + Sync {
    /// The range of each driver.
    fn ranges(&self) -> Vec<Range>;
    /// The task, where the drivers move in time.
    fn span(&self) -> Span;
    /// Positions, speeds and accelerations of the drivers at a time, where they move in time.
    fn drive(&self, time: f64) -> Option<Vec<f64>>;
    /// Puts the linkage together where its start values are meant and moves it through the places, in their order.
    /// Each is the positions of the drivers, and behind them how these move where that is known ([`Self::drive`]).
    ///
    /// # Errors
    /// Why it cannot be put together. Where the way ends before the last place the path says so.
    fn follow(&self, places: &[Vec<f64>]) -> Result<Path, ClosureError>;
    /// Influence coefficients at a place: outputs by variables, row by row.
    ///
    /// # Errors
    /// Why the linkage does not get there.
    fn influence(&self, place: &[f64]) -> Result<Vec<f64>, ClosureError>;
    /// Nanoseconds of one move between neighbouring positions of the task, outputs included, measured over this many;
    /// not a number if it has no two positions that are reached.
    fn time_position(&self, moves: usize) -> f64;
}

/// Checks the values of a linkage and prepares it.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind_linkage<L: Linkage + 'static>(linkage: L) -> Result<Box<dyn RunLinkage>, Refused> {
    linkage.check()?;
    Ok(Box::new(Bound::<L, true> { linkage }))
}

/// The same of a linkage in which nothing has a tolerance or is a made dimension: what answers questions about tolerances is
/// not compiled for it.
///
/// # Errors
/// The first value or condition that the mechanism does not accept.
pub fn bind_exact<L: Linkage + 'static>(linkage: L) -> Result<Box<dyn RunLinkage>, Refused> {
    linkage.check()?;
    Ok(Box::new(Bound::<L, false> { linkage }))
}

/// A linkage with its values, and whether anything in it is made to a tolerance.
pub(super) struct Bound<L: Linkage, const MADE: bool> {
    pub(super) linkage: L,
}

impl<L: Linkage + 'static, const MADE: bool> RunLinkage for Bound<L, MADE>
where
    Self: RunTolerance,
{
    fn ranges(&self) -> Vec<Range> {
        self.linkage.ranges()
    }

    fn span(&self) -> Span {
        self.linkage.span()
    }

    fn drive(&self, time: f64) -> Option<Vec<f64>> {
        self.linkage.drive(time)
    }

    fn follow(&self, places: &[Vec<f64>]) -> Result<Path, ClosureError> {
        path::follow(&self.linkage, places)
    }

    fn influence(&self, place: &[f64]) -> Result<Vec<f64>, ClosureError> {
        path::influence(&self.linkage, place)
    }

    fn time_position(&self, moves: usize) -> f64 {
        path::time_position(&self.linkage, moves)
    }
}
