//! Extremes of a quantity.

use super::grid::{Grid, Sampler};

/// Sections that give half of the digits of a time, and all of them.
const HALF: usize = 44;
const ALL: usize = 80;

/// Which extreme is meant.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sense {
    Largest,
    Smallest,
}

impl Sense {
    /// Whether the first value is further out. No value is better than one that is not a number, so that it shows.
    pub(super) fn better(self, a: f64, b: f64) -> bool {
        match self {
            _ if a.is_nan() => !b.is_nan(),
            Self::Largest => a > b,
            Self::Smallest => a < b,
        }
    }
}

/// The extreme of a quantity in a part of a step, or what was the best before.
pub(super) fn of(
    index: usize,
    sense: Sense,
    (from, to): (f64, f64),
    best: Option<f64>,
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
) -> f64 {
    let ends = [from, to].map(|time| (time, sampler.at(grid.piece, time)[index]));
    let inner = grid.times.into_iter().zip(grid.column(index));
    let inner = inner.filter(|(time, _)| *time > from && *time < to);
    let mut points = vec![ends[0]];
    points.extend(inner);
    points.push(ends[1]);
    let further = |a: f64, b: f64| if sense.better(a, b) { a } else { b };
    let start = best.unwrap_or(ends[0].1);
    let mut found = points.iter().fold(start, |best, one| further(one.1, best));
    let last = points.len() - 1;
    for (place, here) in points.iter().enumerate() {
        // At an end of the step too: the next step does not see what lies beside it.
        let (before, after) = (points[place.saturating_sub(1)], points[last.min(place + 1)]);
        if sense.better(before.1, here.1) || sense.better(after.1, here.1) {
            continue;
        }
        // A parabola says how far out the extreme may lie; twice as far is looked for. Beside an end it takes two more
        // points to draw one.
        let near = match place == 0 || place == last {
            true => &points[place.saturating_sub(2)..=last.min(place + 2)],
            false => &points[place - 1..=place + 1],
        };
        let rise = near
            .iter()
            .fold(0.0_f64, |most, one| most.max((here.1 - one.1).abs()));
        let reach = match sense {
            Sense::Largest => here.1 + rise,
            Sense::Smallest => here.1 - rise,
        };
        if sense.better(reach, found) {
            let (_, value) = refine(index, sense, (before.0, after.0), grid, sampler);
            found = further(value, found);
        }
    }
    // An extreme beside an end has no point on its other side that would show it.
    let last = points.len() - 1;
    let beyond = |place: usize| points[place.min(last)];
    let sides = [
        [beyond(0), beyond(1), beyond(2)],
        [
            points[last],
            beyond(last - 1),
            beyond(last.saturating_sub(2)),
        ],
    ];
    for [end, next, third] in sides {
        let rise = (end.1 - next.1).abs().max((next.1 - third.1).abs());
        let reach = match sense {
            Sense::Largest => end.1 + rise,
            Sense::Smallest => end.1 - rise,
        };
        if sense.better(end.1, next.1)
            && sense.better(reach, found)
            && turns_beside(end, next, third)
        {
            let window = (end.0.min(next.0), end.0.max(next.0));
            let (_, value) = refine(index, sense, window, grid, sampler);
            found = further(value, found);
        }
    }
    found
}

/// Whether a parabola through three points, of which the first is further out than the second, turns between these two,
/// or so little before the first that the quantity itself may turn between them.
fn turns_beside(end: (f64, f64), next: (f64, f64), third: (f64, f64)) -> bool {
    if third.0 == next.0 {
        return true;
    }
    let chord = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1) / (b.0 - a.0);
    let bend = (chord(next, third) - chord(end, next)) / (third.0 - end.0);
    let slope = chord(end, next) - bend * (next.0 - end.0);
    let turn = -slope / (2.0 * bend * (next.0 - end.0));
    turn > -0.5 && turn < 1.0
}

/// The extreme between two times by golden sections, with its time. Where a quantity is flat near it, its value is right
/// to the last digits as soon as its time is to half of them; at a corner it takes all of them.
pub(super) fn refine(
    index: usize,
    sense: Sense,
    (mut from, mut to): (f64, f64),
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
) -> (f64, f64) {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut at = |time: f64| sampler.at(grid.piece, time)[index];
    let (mut low, mut high) = (to - golden * (to - from), from + golden * (to - from));
    let (mut below, mut above) = (at(low), at(high));
    // 0.618^44 = 6e-10: below the square root of the rounding of a number.
    for count in 0..ALL {
        let is_flat = (below - above).abs() <= 4.0 * f64::EPSILON * below.abs().max(above.abs());
        if count >= HALF && is_flat || !(from < low && low < high && high < to) {
            break;
        }
        if sense.better(below, above) {
            (to, high, above) = (high, low, below);
            low = to - golden * (to - from);
            below = at(low);
        } else {
            (from, low, below) = (low, high, above);
            high = from + golden * (to - from);
            above = at(high);
        }
    }
    match sense.better(below, above) {
        true => (low, below),
        false => (high, above),
    }
}
