//! Limit positions and strokes of the outputs and of the dependent coordinates.
//!
//! A limit position is a zero of the rate, which the kinematic coefficients give: it is found to the last bits, where a
//! search for the greatest value would lose half of the digits. Where an output jumps or goes beyond all bounds it is
//! looked what it tends to on either side.

use super::breaks::{Break, unbounded};
use super::extremes::{self, Course, Extreme, Limit, Node};
use super::limits::{End, Stretch, stretch_of};
use super::track::{Along, Track};
use crate::closure::error::ClosureError;
use crate::closure::linkage::any::AnyLinkage;
use crate::closure::linkage::problem::Linkage;

/// Number of parts of a range in which limit positions are looked for.
const PARTS: usize = 360;
/// By this part of a stroke a sample lies clearly beyond it.
const CLEAR: f64 = 1e-9;
/// Distance from a dead point, in parts of the range, at which a linkage can stand.
const BESIDE: f64 = 1e-9;

/// Part of a range on either side of a change point in which what hangs on rates is not looked at.
const AROUND: f64 = 0.01;

/// The extremes of an output or a dependent coordinate over a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The smallest value, at a limit position or an end, or beside a jump; infinite at a pole.
    pub least: Extreme,
    /// The greatest value.
    pub greatest: Extreme,
    /// All limit positions inside, in order.
    pub limits: Vec<Limit>,
    /// Where it jumps, goes beyond all bounds or has no value, in order.
    pub breaks: Vec<Break>,
}

impl Stroke {
    /// The greatest value less the smallest.
    pub fn length(&self) -> f64 {
        self.greatest.value - self.least.value
    }
}

/// Finds the limit positions and the strokes over a task: of all outputs, and behind them of all dependent coordinates.
///
/// # Errors
/// As [`stretch`](fn@crate::closure::stretch); or, in time, why the linkage does not get through the task.
pub fn strokes<L: Linkage>(linkage: &L, along: Along) -> Result<Vec<Stroke>, ClosureError> {
    strokes_of(linkage, along)
}

/// [`strokes()`] of a linkage behind a pointer.
pub(crate) fn strokes_of(
    linkage: &dyn AnyLinkage,
    along: Along,
) -> Result<Vec<Stroke>, ClosureError> {
    let stretch = match along {
        Along::Driver(index, bounds) => Some(stretch_of(linkage, index, bounds)?),
        Along::Time(..) => None,
    };
    let mut track = Track::new(linkage, along)?;
    let looks =
        places(along, stretch.as_ref()).map(|at| track.look(at)).collect::<Result<Vec<_>, _>>()?;
    let (from, to) = along.bounds();
    let points = std::mem::take(&mut track.change_points);
    let met = points.iter().map(|at| track.look(*at));
    let met = met.collect::<Result<Vec<_>, _>>()?;
    let stroke = |channel: usize| {
        // What hangs on rates is zero over zero at a change point, and rounding about it.
        let is_lost = met.iter().any(|look| look.of(channel).value.is_nan());
        let near = |at: f64| points.iter().any(|point| (at - point).abs() < AROUND * (to - from));
        let seen = |sample: Node| match is_lost && near(sample.at) {
            true => sample.unknown(),
            false => sample,
        };
        let samples: Vec<_> = looks.iter().map(|look| seen(look.of(channel))).collect();
        let mut look = |at| Ok(seen(track.look(at)?.of(channel)));
        let mut course = extremes::follow(&samples, &mut look)?;
        course.breaks.retain(|one| {
            let ends_there = one.before.is_nan() || one.after.is_nan();
            let edge =
                points.iter().any(|point| (one.at - point).abs() < 1.01 * AROUND * (to - from));
            !(is_lost && ends_there && edge)
        });
        let ends = match &stretch {
            Some(found) => at_ends(found, channel, &mut course, look)?,
            None => samples.first().into_iter().chain(samples.last()).map(Node::place).collect(),
        };
        Ok(over(course, ends, &samples))
    };
    let shape = linkage.shape();
    let channels = shape.outputs.len() + shape.loops().dependents.len();
    (0..channels).map(stroke).collect()
}

/// Equally spaced places over a task, as far as the linkage gets. Ends at dead points cannot be stood on; the rates of
/// outputs do not vanish beside them.
fn places(along: Along, stretch: Option<&Stretch>) -> impl Iterator<Item = f64> {
    let (low, high) = stretch.map_or(along.bounds(), |found| (found.low.at, found.high.at));
    let beside = |end: Option<&End>| match end.and_then(|end| end.dead) {
        Some(_) => BESIDE * (high - low),
        None => 0.0,
    };
    let first = low + beside(stretch.map(|found| &found.low));
    let last = high - beside(stretch.map(|found| &found.high));
    let between = move |k| first + (last - first) * k as f64 / PARTS as f64;
    (0..PARTS).map(between).chain([last])
}

/// The values at both ends. Towards a dead point an output may go beyond all bounds.
fn at_ends(
    stretch: &Stretch,
    channel: usize,
    course: &mut Course,
    mut look: impl FnMut(f64) -> Result<Node, ClosureError>,
) -> Result<Vec<Extreme>, ClosureError> {
    let width = stretch.high.at - stretch.low.at;
    let mut ends = Vec::new();
    for (end, inwards) in [(&stretch.low, width), (&stretch.high, -width)] {
        let (at, mut value) = (end.at, end.value(channel));
        if end.dead.is_some() {
            let mut values = [0.0; 3];
            for (value, part) in values.iter_mut().zip([1.0, 1e2, 1e4]) {
                *value = look(at + part * BESIDE * inwards)?.value;
            }
            if let Some(infinite) = unbounded(values) {
                value = infinite;
                let side = |is_here: bool| if is_here { infinite } else { f64::NAN };
                course.breaks.push(Break {
                    at,
                    before: side(inwards < 0.0),
                    after: side(inwards > 0.0),
                });
            }
        }
        ends.push(Extreme { at, value });
    }
    course.breaks.sort_by(|one, other| one.at.total_cmp(&other.at));
    Ok(ends)
}

/// The stroke over limit positions, breaks and ends, and over samples that lie clearly beyond them.
fn over(course: Course, ends: Vec<Extreme>, samples: &[Node]) -> Stroke {
    let Course { limits, breaks } = course;
    let beside = |one: &Break| [one.before, one.after].map(|value| Extreme { at: one.at, value });
    let known = limits.iter().map(|limit| limit.place);
    let known = known.chain(ends).chain(breaks.iter().flat_map(beside));
    let known: Vec<_> = known.filter(|one| !one.value.is_nan()).collect();
    let nowhere = Extreme { at: f64::NAN, value: f64::NAN };
    let mut least = known.first().copied().unwrap_or(nowhere);
    let mut greatest = least;
    let mut reach = |one: Extreme, clearance: f64| {
        if one.value < least.value - clearance {
            least = one;
        }
        if one.value > greatest.value + clearance {
            greatest = one;
        }
        greatest.value - least.value
    };
    let length = known.iter().fold(0.0, |_, one| reach(*one, 0.0));
    for &Node { at, value, .. } in samples {
        reach(Extreme { at, value }, CLEAR * length);
    }
    Stroke { least, greatest, limits, breaks }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_clearly_beyond_all_else_count() {
        let extreme = |at: f64, value: f64| Extreme { at, value };
        let sample = |at: f64, value: f64| Node { at, value, rate: 1.0 };
        let ends = vec![extreme(0.0, 1.0), extreme(4.0, 2.0)];
        let lowest = Limit { place: extreme(1.0, 0.5), is_highest: false };
        let course = Course { limits: vec![lowest], breaks: Vec::new() };
        let samples = [sample(1.1, 0.5 - 1e-12), sample(2.0, 90.0), sample(3.0, -80.0)];
        let stroke = over(course.clone(), ends.clone(), &samples[..1]);
        assert_eq!((stroke.least, stroke.greatest), (lowest.place, ends[1]));
        let stroke = over(course, ends, &samples);
        assert_eq!((stroke.least.at, stroke.greatest.at), (3.0, 2.0));
    }
}
