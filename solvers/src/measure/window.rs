//! Where a condition holds.

use assur_functions::{Sense, top};

use super::GRID;
use super::grid::{Grid, Sampler};

/// The parts of a step in which a quantity is positive; the whole step where there is none.
pub(super) fn windows(
    window: Option<usize>,
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
) -> Vec<(f64, f64)> {
    let Some(index) = window else {
        return vec![grid.ends()];
    };
    let values = grid.column(index);
    let mut points: Vec<(f64, f64)> = grid.times.into_iter().zip(values).collect();
    // A point that its neighbours surround may hide two passages: the extreme beside it shows them.
    for middle in 1..GRID {
        let (before, here, after) = (values[middle - 1], values[middle], values[middle + 1]);
        let holds = here > 0.0;
        if (before > 0.0) != holds || (after > 0.0) != holds {
            continue;
        }
        let sense = match holds {
            true => Sense::Smallest,
            false => Sense::Largest,
        };
        if sense.better(before, here) || sense.better(after, here) {
            continue;
        }
        // Beyond its points it moves by less than between them.
        if (here - before).abs().max((here - after).abs()) < here.abs() {
            continue;
        }
        let times = (grid.times[middle - 1], grid.times[middle + 1]);
        let top = top(sense, times, &mut |time| sampler.at(grid.piece, time)[index]);
        if (top.value > 0.0) != holds {
            points.push((top.place, top.value));
        }
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut parts = Vec::new();
    let mut since = (points[0].1 > 0.0).then_some(points[0].0);
    for pair in points.windows(2) {
        let (held, holds) = (pair[0].1 > 0.0, pair[1].1 > 0.0);
        if held == holds {
            continue;
        }
        let time = passage(index, (pair[0].0, pair[1].0), held, grid, sampler);
        match since.take() {
            Some(begin) => parts.push((begin, time)),
            None => since = Some(time),
        }
    }
    parts.extend(since.map(|begin| (begin, grid.ends().1)));
    parts.retain(|(from, to)| to > from);
    parts
}

/// Where a quantity passes zero between two times, to neighbouring numbers.
fn passage(
    index: usize,
    (mut from, mut to): (f64, f64),
    held: bool,
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
) -> f64 {
    loop {
        let middle = from + (to - from) / 2.0;
        if middle <= from || middle >= to {
            return to;
        }
        match (sampler.at(grid.piece, middle)[index] > 0.0) == held {
            true => from = middle,
            false => to = middle,
        }
    }
}
