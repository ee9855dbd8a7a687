//! All solutions of one group that is iterated: branch and bound with Krawczyk's test.
//!
//! The unknowns range over a box, angles over a turn and displacements within a bound. A box in which an equation cannot
//! vanish is dropped; one in which Krawczyk's operator maps a slightly larger box into itself holds exactly one solution
//! there; any other is cut in two (R. E. Moore, R. B. Kearfott, M. J. Cloud: *Introduction to Interval Analysis*, 2009,
//! chapter 8). The groups before it are taken as closed exactly.

use crate::closure::linkage::loops::{Square, Trials};
use crate::dense::Lu;
use crate::scalar::Interval;
use crate::shape::LinkageEntry;
use std::f64::consts::PI;

/// Width at which a box that could not be decided is given up, in radians or parts of the bound.
const SMALLEST: f64 = 1e-7;
/// How far angles reach beyond half a turn, so that a solution there is not on the edge of a box.
const OVERLAP: f64 = 1.234e-3;
/// Where a box is cut: not in its middle, where solutions like to be.
const CUT: f64 = 0.4873;
/// Part of its width by which a box grows before it is tested.
const GROWTH: f64 = 0.1;
/// A box is cut at once unless the test makes it smaller than this part.
const SHRUNK: f64 = 0.7;

/// What a search has found.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    /// Solutions, each certainly there and certainly alone.
    pub solutions: Vec<Vec<f64>>,
    /// Boxes that could not be decided.
    pub undecided: Vec<Vec<f64>>,
    /// Boxes that were looked at.
    pub boxes: usize,
}

/// The equations of one group over boxes of its unknowns.
pub(super) struct Branches<'a> {
    loops: &'a dyn Trials<Interval>,
    entry: &'static LinkageEntry,
    instant: Vec<Interval>,
    group: usize,
    position: Vec<Interval>,
    square: Square<Interval>,
}

/// What the test of a box says.
enum Verdict {
    /// No solution.
    Empty,
    /// One solution, about here.
    One(Vec<f64>),
    /// All solutions are in this part of it.
    Perhaps(Vec<Interval>),
}

impl<'a> Branches<'a> {
    /// The equations of a group, the groups before it closed in a position.
    pub fn new(
        loops: &'a dyn Trials<Interval>,
        group: usize,
        independents: &[f64],
        closed: &[f64],
    ) -> Self {
        let points = |list: &[f64]| list.iter().map(|x| Interval::point(*x)).collect();
        let places: Vec<Interval> = points(independents);
        Self {
            entry: loops.shape().loops(),
            instant: loops.instant_row(&places, &[]),
            group,
            position: points(closed),
            square: Square::of(loops.shape()),
            loops,
        }
    }

    /// Finds all solutions, displacements up to a bound, in at most a number of boxes.
    pub fn search(&mut self, bound: f64, most: usize) -> Found {
        let unknowns = self.entry.groups[self.group].unknowns;
        let angles = self.entry.angles;
        let units: Vec<f64> =
            unknowns.iter().map(|&j| if angles[j] { 1.0 } else { bound }).collect();
        let reach = |&j: &usize| if angles[j] { PI + OVERLAP } else { bound };
        let whole = unknowns.iter().map(reach).map(|reach| Interval::new(-reach, reach));
        let mut open: Vec<Vec<Interval>> = vec![whole.collect()];
        let mut found = Found::default();
        while let Some(region) = open.pop() {
            found.boxes += 1;
            match self.test(&region) {
                Verdict::Empty => {}
                Verdict::One(solution) => found.solutions.push(solution),
                Verdict::Perhaps(part) => {
                    let widest = widest(&part, &units);
                    let width = part[widest].width() / units[widest];
                    if width < SMALLEST || found.boxes >= most {
                        found.undecided.push(part.iter().map(|side| side.middle()).collect());
                    } else if width < SHRUNK * self::width(&region, &units) {
                        open.push(part);
                    } else {
                        open.extend(cut(&part, widest));
                    }
                }
            }
        }
        found
    }

    fn test(&mut self, region: &[Interval]) -> Verdict {
        let n = region.len();
        let (values, _) = self.look(region);
        if values.iter().any(|value| !value.contains(0.0) && !value.low.is_nan()) {
            return Verdict::Empty;
        }
        let grown: Vec<Interval> = region.iter().map(|side| grow(*side)).collect();
        let (_, slopes) = self.look(&grown);
        let middle: Vec<f64> = grown.iter().map(|side| side.middle()).collect();
        let points: Vec<Interval> = middle.iter().map(|value| Interval::point(*value)).collect();
        let (values, _) = self.look(&points);
        let Some(inverse) = inverse(slopes.iter().map(|slope| slope.middle()).collect(), n) else {
            return Verdict::Perhaps(region.to_vec());
        };
        let image = krawczyk(&inverse, &values, &slopes, &grown, &middle);
        if image.iter().any(|side| side.low.is_nan()) {
            return Verdict::Perhaps(region.to_vec());
        }
        let inside = image.iter().zip(&grown).all(|(a, b)| b.low < a.low && a.high < b.high);
        let meeting: Option<Vec<Interval>> =
            image.iter().zip(region).map(|(a, b)| a.meet(*b)).collect();
        match meeting {
            None => Verdict::Empty,
            Some(_) if inside => Verdict::One(image.iter().map(|side| side.middle()).collect()),
            Some(part) => Verdict::Perhaps(part),
        }
    }

    /// Values and derivatives of the equations over a box.
    fn look(&mut self, region: &[Interval]) -> (Vec<Interval>, Vec<Interval>) {
        let n = region.len();
        let unknowns = self.entry.groups[self.group].unknowns;
        for (side, &j) in region.iter().zip(unknowns) {
            self.position[j] = *side;
        }
        self.square.look(self.loops, self.group, &self.instant, &mut self.position);
        (self.square.residual[..n].to_vec(), self.square.jacobian[..n * n].to_vec())
    }
}

/// Krawczyk's operator: `m - Y F(m) + (1 - Y F'(X)) (X - m)`, with `Y` about the inverse of the derivatives.
fn krawczyk(
    inverse: &[f64],
    values: &[Interval],
    slopes: &[Interval],
    region: &[Interval],
    middle: &[f64],
) -> Vec<Interval> {
    let n = region.len();
    let times = |i: usize, column: &dyn Fn(usize) -> Interval| {
        (0..n).fold(Interval::point(0.0), |sum, k| {
            sum + Interval::point(inverse[i * n + k]) * column(k)
        })
    };
    let part = |i: usize| {
        let centre = Interval::point(middle[i]) - times(i, &|k| values[k]);
        (0..n).fold(centre, |sum, j| {
            let unit = Interval::point(if i == j { 1.0 } else { 0.0 });
            let rest = unit - times(i, &|k| slopes[k * n + j]);
            sum + rest * (region[j] - Interval::point(middle[j]))
        })
    };
    (0..n).map(part).collect()
}

/// The inverse of a matrix.
fn inverse(mut matrix: Vec<f64>, n: usize) -> Option<Vec<f64>> {
    let mut pivots = vec![0; n];
    Lu::factor(&mut matrix, n, &mut pivots).ok()?;
    let mut inverse = vec![0.0; n * n];
    for j in 0..n {
        let mut column = vec![0.0; n];
        column[j] = 1.0;
        Lu::substitute(&matrix, &pivots, &mut column);
        for (i, value) in column.into_iter().enumerate() {
            inverse[i * n + j] = value;
        }
    }
    inverse.iter().all(|value| value.is_finite()).then_some(inverse)
}

/// A somewhat larger side.
fn grow(side: Interval) -> Interval {
    let margin = GROWTH * side.width() + 1e-12 * side.magnitude() + f64::MIN_POSITIVE;
    Interval::new(side.low - margin, side.high + margin)
}

/// The widest side of a box.
fn widest(region: &[Interval], units: &[f64]) -> usize {
    let widths = region.iter().zip(units).map(|(side, unit)| side.width() / unit);
    let most =
        widths.enumerate().fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    most.0
}

/// Width of the widest side.
fn width(region: &[Interval], units: &[f64]) -> f64 {
    let widest = widest(region, units);
    region[widest].width() / units[widest]
}

/// Both parts of a box.
fn cut(region: &[Interval], side: usize) -> [Vec<Interval>; 2] {
    let Interval { low, high } = region[side];
    let at = low + CUT * (high - low);
    let (mut left, mut right) = (region.to_vec(), region.to_vec());
    left[side] = Interval::new(low, at);
    right[side] = Interval::new(at, high);
    [left, right]
}
