//! Where tolerances are looked at.

use assur::closure::{AnyLinkage, Range};
use assur::problem::Span;

/// Places over the range of the drivers, of several a grid of as many; or over the time of the task.
pub fn range(run: &dyn AnyLinkage, count: usize) -> Vec<Vec<f64>> {
    let share = |index: usize, count: usize| index as f64 / (count - 1) as f64;
    let (first, last) = match run.span() {
        Span::Open => (0.0, 0.0),
        span => span.limits(),
    };
    if run.drive(first).is_some() {
        let time = |index: usize| first + share(index, count) * (last - first);
        return (0..count).filter_map(|index| run.drive(time(index))).collect();
    }
    let ranges = run.ranges();
    let moving = ranges.iter().filter(|range| moves(range)).count().max(1);
    let each = (count as f64).powf(1.0 / moving as f64).round().max(2.0) as usize;
    let mut places = vec![Vec::new()];
    for range in &ranges {
        let along: Vec<f64> = match moves(range) {
            true => (0..each)
                .map(|index| range.from + share(index, each) * (range.to - range.from))
                .collect(),
            false => vec![range.start],
        };
        let longer = |place: Vec<f64>| {
            let extend = move |value: &f64| [place.as_slice(), &[*value]].concat();
            along.iter().map(extend).collect::<Vec<_>>()
        };
        places = places.into_iter().flat_map(longer).collect();
    }
    places
}

/// Whether a driver goes over its range.
fn moves(range: &Range) -> bool {
    range.from.is_finite() && range.to.is_finite() && range.from != range.to
}

/// Places over the range of the first driver that moves, the others standing where they start; none unless several move.
pub fn along(run: &dyn AnyLinkage, count: usize) -> Option<Vec<Vec<f64>>> {
    let ranges = run.ranges();
    if run.span() != Span::Open || ranges.iter().filter(|range| moves(range)).count() < 2 {
        return None;
    }
    let first = ranges.iter().position(moves)?;
    let start: Vec<f64> = ranges.iter().map(|range| range.start).collect();
    let place = |index: usize| {
        let mut place = start.clone();
        let range = &ranges[first];
        let share = index as f64 / (count - 1) as f64;
        place[first] = range.from + share * (range.to - range.from);
        place
    };
    Some((0..count).map(place).collect())
}
