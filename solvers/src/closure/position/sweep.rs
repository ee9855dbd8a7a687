//! Positions of a linkage over a grid of its independent variables, one mode followed through all of it.

use super::assembly::Assembly;
use super::guide::Guide;
use super::positions::{Positions, record};
use crate::closure::error::ClosureError;
use crate::closure::linkage::problem::Linkage;
use crate::dispatch::{Task, dispatch};
use crate::scalar::Scalar;

/// Parts of a period that are gone without a look in between, and of a range.
const PARTS: (f64, f64) = (24.0, 16.0);

/// Equally spaced values of one independent variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The first value.
    pub from: f64,
    /// The last value.
    pub to: f64,
    /// Number of values.
    pub count: usize,
}

impl Axis {
    /// The value of an index.
    pub fn at(&self, index: usize) -> f64 {
        if index + 1 == self.count && index > 0 {
            return self.to;
        }
        self.from + (self.to - self.from) * (index as f64 / (self.count.max(2) - 1) as f64)
    }
}

/// What to do where a mode ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AtDeadPoint {
    /// End there and tell where it is.
    #[default]
    Stop,
    /// Go back on the other mode, as the curve of positions does. Of a grid of several variables, stop.
    Through,
}

/// Moves a linkage from its start over a grid: one [`Axis`] for each independent variable.
///
/// # Errors
/// [`ClosureError`] if the linkage does not assemble at its start, or the grid makes no sense. That a position cannot be
/// reached is told in [`Positions::end`].
pub fn sweep<L: Linkage>(
    linkage: &L,
    axes: &[Axis],
    at_dead_point: AtDeadPoint,
) -> Result<Positions, ClosureError> {
    check(axes, Linkage::shape(linkage).drivers.len())?;
    dispatch(Sweep { linkage, axes, at_dead_point })
}

fn check(axes: &[Axis], expected: usize) -> Result<(), ClosureError> {
    let bad = |reason: String| Err(ClosureError::BadRange { reason });
    if axes.len() != expected {
        return bad(format!(
            "{} ranges are given for {expected} independent variables",
            axes.len()
        ));
    }
    match axes.iter().find(|axis| !(axis.from.is_finite() && axis.to.is_finite() && axis.count > 0))
    {
        Some(axis) => bad(format!(
            "a range from {} to {} in {} positions: expected finite ends and at least one position",
            axis.from, axis.to, axis.count
        )),
        None => Ok(()),
    }
}

/// A sweep to be done on some scalar type.
struct Sweep<'a, L> {
    linkage: &'a L,
    axes: &'a [Axis],
    at_dead_point: AtDeadPoint,
}

impl<L: Linkage> Task for Sweep<'_, L> {
    type Output = Result<Positions, ClosureError>;

    #[inline(always)]
    fn run<S: Scalar>(self) -> Self::Output {
        let mut assembly = Assembly::<L, S>::new(self.linkage);
        assembly.start()?;
        let count = self.axes.iter().map(|axis| axis.count).product();
        let shape = Linkage::shape(self.linkage);
        let mut positions = Positions::new(shape, count);
        let through = self.at_dead_point == AtDeadPoint::Through && self.axes.len() == 1;
        let limits = assembly.guide().limits();
        let short = self.axes.iter().zip(&limits).all(|(axis, limit)| {
            (axis.to - axis.from).abs() <= limit * (axis.count.max(2) - 1) as f64
        });
        let mut place = vec![S::ZERO; self.axes.len()];
        let mut outputs = vec![S::ZERO; shape.outputs.len()];
        for number in 0..count {
            let index = locate(self.axes, number, &mut place);
            let outcome = if short && number > 0 {
                assembly.move_to(&place)
            } else {
                assembly.travel(&place)
            };
            if let Err(error) = outcome {
                positions.missed += 1;
                positions.end.get_or_insert(error);
                if self.axes.len() > 1 {
                    continue;
                }
                positions.missed = count - number;
                positions.truncate(number);
                break;
            }
            record(&assembly, &mut outputs, &mut positions, index);
        }
        positions.events = assembly.take_events();
        if through && positions.end.is_some() {
            go_back(&mut assembly, &mut positions);
        }
        Ok(positions)
    }
}

/// Passes through the dead point that has ended a sweep, and goes back over the positions as far as the other mode goes.
#[cold]
#[inline(never)]
fn go_back<L: Linkage, S: Scalar>(assembly: &mut Assembly<L, S>, positions: &mut Positions) {
    let Some(ClosureError::DeadPoint { wanted, .. }) = &positions.end else {
        return;
    };
    let outcome = assembly.pass_dead_point(wanted);
    let mut outputs = vec![S::ZERO; assembly.guide().loops.shape().outputs.len()];
    let mut place = assembly.independents().to_vec();
    let count = positions.len();
    positions.end = outcome.err();
    for index in (0..count).rev() {
        if positions.end.is_some() {
            break;
        }
        for (value, kept) in place.iter_mut().zip(positions.independents(index)) {
            *value = S::from_f64(*kept);
        }
        match assembly.travel(&place) {
            Ok(()) => {
                let row = positions.len();
                positions.extend();
                S::outline(
                    #[inline(always)]
                    || record(assembly, &mut outputs, positions, row),
                );
            }
            Err(error) => positions.end = Some(error),
        }
    }
    positions.events.extend(assembly.take_events());
}

/// The place that is visited after a number of others, each next to the one before, and its index in the order of the
/// grid.
#[inline(always)]
fn locate<S: Scalar>(axes: &[Axis], number: usize, place: &mut [S]) -> usize {
    let mut stride: usize = axes.iter().map(|axis| axis.count).product();
    let (mut index, mut above, mut rest) = (0, 0, number);
    for (axis, value) in axes.iter().zip(place) {
        stride /= axis.count;
        let digit = rest / stride;
        rest %= stride;
        let turned = if above % 2 == 0 { digit } else { axis.count - 1 - digit };
        above = above * axis.count + digit;
        index = index * axis.count + turned;
        *value = S::from_f64(axis.at(turned));
    }
    index
}

impl<S: Scalar> Guide<'_, S> {
    /// In how many parts a long way is gone, so that nothing on it is missed; none where there is nothing to close.
    pub(super) fn parts(&self, target: &[S]) -> f64 {
        if self.entry.groups.is_empty() {
            return 0.0;
        }
        let (from, limits) = (self.place(), self.limits());
        let parts = target.iter().zip(&from).zip(&limits);
        parts
            .map(|((to, from), limit)| ((to.to_f64() - from).abs() / limit).ceil())
            .fold(1.0, f64::max)
    }

    /// The longest step of each independent variable: a part of its period, or of its range.
    pub(super) fn limits(&self) -> Vec<f64> {
        let ranges = self.linkage.ranges();
        let limits = ranges.iter().map(|range| {
            let (period, range) = (range.period / PARTS.0, (range.to - range.from).abs() / PARTS.1);
            match (period.is_finite(), range > 0.0) {
                (true, _) => period,
                (false, true) => range,
                (false, false) => f64::INFINITY,
            }
        });
        limits.collect()
    }
}
