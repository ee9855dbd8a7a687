//! Positions of a linkage over a grid of its independent variables, one mode followed through all of it.

use super::assembly::{Assembly, Event};
use super::error::ClosureError;
use super::problem::{GroupKind, Linkage};
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

/// Positions in the order in which they were asked for: the last variable changes fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Positions {
    /// Numbers of independent variables, dependent coordinates and outputs.
    widths: (usize, usize, usize),
    independents: Vec<f64>,
    coordinates: Vec<f64>,
    outputs: Vec<f64>,
    sines: Vec<f64>,
    /// What happened on the way.
    pub events: Vec<Event>,
    /// Why the first position that could not be reached could not, if there is one. Of a single variable the positions
    /// end before it; in a grid of several, positions that were not reached are NaN.
    pub end: Option<ClosureError>,
    /// How many positions were not reached.
    pub missed: usize,
}

impl Positions {
    /// Number of positions.
    pub fn len(&self) -> usize {
        self.sines.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.sines.is_empty()
    }

    /// The independent variables at a position.
    pub fn independents(&self, index: usize) -> &[f64] {
        &self.independents[index * self.widths.0..][..self.widths.0]
    }

    /// The dependent coordinates at a position, angles continued over whole turns.
    pub fn coordinates(&self, index: usize) -> &[f64] {
        &self.coordinates[index * self.widths.1..][..self.widths.1]
    }

    /// The outputs at a position.
    pub fn outputs(&self, index: usize) -> &[f64] {
        &self.outputs[index * self.widths.2..][..self.widths.2]
    }

    /// Smallest modulus of the sines of transmission angles at a position.
    pub fn sine(&self, index: usize) -> f64 {
        self.sines[index]
    }

    /// Room for a number of positions, all NaN.
    fn new<L: Linkage>(count: usize) -> Self {
        let room = |width: usize| vec![f64::NAN; width * count];
        Self {
            widths: (L::INDEPENDENTS, L::DEPENDENTS, L::OUTPUTS),
            independents: room(L::INDEPENDENTS),
            coordinates: room(L::DEPENDENTS),
            outputs: room(L::OUTPUTS),
            sines: room(1),
            ..Self::default()
        }
    }

    /// Leaves only the first ones.
    fn truncate(&mut self, count: usize) {
        self.independents.truncate(count * self.widths.0);
        self.coordinates.truncate(count * self.widths.1);
        self.outputs.truncate(count * self.widths.2);
        self.sines.truncate(count);
    }
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
    check(axes, L::INDEPENDENTS)?;
    dispatch(Sweep {
        linkage,
        axes,
        at_dead_point,
    })
}

fn check(axes: &[Axis], expected: usize) -> Result<(), ClosureError> {
    let bad = |reason: String| Err(ClosureError::BadRange { reason });
    if axes.len() != expected {
        return bad(format!(
            "{} ranges are given for {expected} independent variables",
            axes.len()
        ));
    }
    match axes
        .iter()
        .find(|axis| !(axis.from.is_finite() && axis.to.is_finite() && axis.count > 0))
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

    /// Iterations are not inlined.
    const LARGE: bool = iterates(L::GROUPS);

    #[inline(always)]
    fn run<S: Scalar>(self) -> Self::Output {
        let mut assembly = Assembly::<L, S>::new(self.linkage);
        assembly.start()?;
        let count = self.axes.iter().map(|axis| axis.count).product();
        let mut positions = Positions::new::<L>(count);
        let through = self.at_dead_point == AtDeadPoint::Through && self.axes.len() == 1;
        let limits = assembly.limits();
        let short = self.axes.iter().zip(&limits).all(|(axis, limit)| {
            (axis.to - axis.from).abs() <= limit * (axis.count.max(2) - 1) as f64
        });
        let mut place = vec![S::ZERO; self.axes.len()];
        let mut outputs = vec![S::ZERO; L::OUTPUTS];
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
    let mut outputs = vec![S::ZERO; L::OUTPUTS];
    let mut place = vec![S::ZERO; L::INDEPENDENTS];
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
                record(assembly, &mut outputs, positions, row);
            }
            Err(error) => positions.end = Some(error),
        }
    }
    positions.events.extend(assembly.take_events());
}

impl Positions {
    /// Adds room for one position.
    fn extend(&mut self) {
        let (a, b, c) = self.widths;
        for (values, width) in [
            (&mut self.independents, a),
            (&mut self.coordinates, b),
            (&mut self.outputs, c),
        ] {
            values.resize(values.len() + width, f64::NAN);
        }
        self.sines.push(f64::NAN);
    }
}

/// Writes a position down.
#[inline(always)]
fn record<L: Linkage, S: Scalar>(
    assembly: &Assembly<L, S>,
    outputs: &mut [S],
    positions: &mut Positions,
    index: usize,
) {
    assembly.outputs(outputs);
    let (a, b, c) = positions.widths;
    copy(
        &mut positions.independents[index * a..][..a],
        assembly.independents(),
    );
    copy(
        &mut positions.coordinates[index * b..][..b],
        assembly.position().as_ref(),
    );
    copy(&mut positions.outputs[index * c..][..c], outputs);
    positions.sines[index] = assembly.weakest().1.abs();
}

#[inline(always)]
fn copy<S: Scalar>(to: &mut [f64], from: &[S]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = from.to_f64();
    }
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
        let turned = if above % 2 == 0 {
            digit
        } else {
            axis.count - 1 - digit
        };
        above = above * axis.count + digit;
        index = index * axis.count + turned;
        *value = S::from_f64(axis.at(turned));
    }
    index
}

/// Whether a group is iterated.
const fn iterates(groups: &[super::problem::Group]) -> bool {
    let mut index = 0;
    while index < groups.len() {
        if matches!(groups[index].kind, GroupKind::General) {
            return true;
        }
        index += 1;
    }
    false
}

impl<L: Linkage, S: Scalar> Assembly<L, S> {
    /// Moves a long way in several steps, so that nothing on it is missed.
    ///
    /// # Errors
    /// As [`Assembly::move_to`].
    #[inline(never)]
    pub fn travel(&mut self, target: &[S]) -> Result<(), ClosureError> {
        let from = self.place();
        let limits = self.limits();
        let parts = target.iter().zip(&from).zip(&limits);
        let count = parts
            .map(|((to, from), limit)| ((to.to_f64() - from).abs() / limit).ceil())
            .fold(1.0, f64::max);
        let mut place = target.to_vec();
        let mut number = 1.0;
        while number < count {
            for ((value, to), from) in place.iter_mut().zip(target).zip(&from) {
                *value = S::from_f64(from + (to.to_f64() - from) * (number / count));
            }
            self.move_to(&place)?;
            number += 1.0;
        }
        self.move_to(target)
    }

    /// The longest step of each independent variable: a part of its period, or of its range.
    fn limits(&self) -> Vec<f64> {
        let ranges = self.linkage.ranges();
        let limits = ranges.iter().map(|range| {
            let (period, range) = (
                range.period / PARTS.0,
                (range.to - range.from).abs() / PARTS.1,
            );
            match (period.is_finite(), range > 0.0) {
                (true, _) => period,
                (false, true) => range,
                (false, false) => f64::INFINITY,
            }
        });
        limits.collect()
    }
}
