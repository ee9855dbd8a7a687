//! The way that a quantity covers, forth and back.

use assur_functions::{Sense, top};

use super::grid::{Grid, Sampler};

/// The way between two times of a step: where a point is further out than its neighbours, the turn beside it is found.
pub(super) fn travel(
    index: usize,
    (from, to): (f64, f64),
    grid: &Grid<'_>,
    sampler: &mut Sampler<'_>,
) -> f64 {
    let column = grid.column(index);
    let mut points = vec![(from, sampler.at(grid.piece, from)[index])];
    let inner = grid.times.into_iter().zip(column);
    points.extend(inner.filter(|(time, _)| *time > from && *time < to));
    points.push((to, sampler.at(grid.piece, to)[index]));
    let mut way = 0.0;
    let mut reached = points[0].1;
    for place in 1..points.len() {
        let here = points[place].1;
        let before = points[place - 1].1;
        let turn = points.get(place + 1).and_then(|after| {
            let sense = match () {
                () if here > before && here >= after.1 => Sense::Largest,
                () if here < before && here <= after.1 => Sense::Smallest,
                () => return None,
            };
            let times = (points[place - 1].0, after.0);
            Some(top(sense, times, &mut |time| sampler.at(grid.piece, time)[index]).value)
        });
        let next = turn.unwrap_or(here);
        way += (next - reached).abs();
        reached = next;
    }
    way
}
