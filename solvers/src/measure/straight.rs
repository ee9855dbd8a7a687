//! How far a curve is from the best straight line.
//!
//! Of the lines `y = a + b x` that is sought from which the curve deviates least at most. For points the deviation is half the
//! height of their convex hull along `y`, least over slopes that are those of edges of the hull: it is convex in `b`, with
//! kinks there alone. Between the points the curve may deviate more: where it does so most is found, taken up as points, and
//! all is done anew until it does not (E. W. Cheney, *Introduction to Approximation Theory*, 1966, chapter 1, section 8).

use assur_functions::{Sense, top};

use super::grid::{Grid, Sampler};

/// How often points are taken up at most.
const ROUNDS: usize = 30;
/// What the curve deviates more than its points by rounding, over its size.
const ROUNDING: f64 = 1e-14;

/// A point of the curve: its piece, its time, `x` and `y`.
#[derive(Clone, Copy, Debug)]
struct Point {
    piece: usize,
    time: f64,
    x: f64,
    y: f64,
}

/// The points of a curve that have been seen so far, in stretches.
#[derive(Clone, Debug, Default)]
pub(super) struct Straight {
    stretches: Vec<Vec<Point>>,
}

impl Straight {
    /// Looks at a part of a step: at `y`, and `x`.
    pub(super) fn look(
        &mut self,
        (y, x): (usize, usize),
        (from, to): (f64, f64),
        grid: &Grid<'_>,
        sampler: &mut Sampler<'_>,
    ) {
        let piece = grid.number;
        let mut at = |time: f64| {
            let values = sampler.at(grid.piece, time);
            Point { piece, time, x: values[x], y: values[y] }
        };
        let goes_on = self.stretches.last().and_then(|last| last.last());
        if !goes_on.is_some_and(|last| (last.piece, last.time) == (piece, from)) {
            self.stretches.push(vec![at(from)]);
        }
        let times = grid.times.into_iter().filter(|time| *time > from && *time < to);
        let points: Vec<Point> = times.chain([to]).map(&mut at).collect();
        if let Some(last) = self.stretches.last_mut() {
            last.extend(points);
        }
    }

    /// The deviation, once all of the run has been looked at; none of nothing.
    pub(super) fn finish(self, (y, x): (usize, usize), sampler: &mut Sampler<'_>) -> Option<f64> {
        let seen: Vec<Point> = self.stretches.iter().flatten().copied().collect();
        if seen.iter().any(|point| !(point.x.is_finite() && point.y.is_finite())) {
            return Some(f64::NAN);
        }
        let size = seen.iter().fold(0.0, |size: f64, point| size.max(point.y.abs()));
        let mut points: Vec<(f64, f64)> = seen.iter().map(|point| (point.x, point.y)).collect();
        let (mut slope, mut deviation) = best(&mut points)?;
        for _ in 0..ROUNDS {
            // The points say too little, the curve itself as much as there is.
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            let mut reached = |off: f64| (low, high) = (low.min(off), high.max(off));
            let off = |point: &Point| point.y - slope * point.x;
            for stretch in &self.stretches {
                stretch.iter().for_each(|point| reached(off(point)));
                for three in stretch.windows(3) {
                    let [before, here, after] = [&three[0], &three[1], &three[2]].map(off);
                    let sense = match () {
                        () if here >= before && here >= after => Sense::Largest,
                        () if here <= before && here <= after => Sense::Smallest,
                        () => continue,
                    };
                    let piece = &sampler.motion.pieces[three[0].piece];
                    let times = (three[0].time, three[2].time);
                    let mut at = |time: f64| {
                        let values = sampler.at(piece, time);
                        values[y] - slope * values[x]
                    };
                    let top = top(sense, times, &mut at);
                    reached(top.value);
                    let values = sampler.at(piece, top.place);
                    points.push((values[x], values[y]));
                }
            }
            if (high - low) / 2.0 - deviation <= ROUNDING * size {
                break;
            }
            (slope, deviation) = best(&mut points)?;
        }
        Some(deviation)
    }
}

/// The slope of the best line, and the largest deviation from it. Of the points those are kept that lie on their hull.
fn best(points: &mut Vec<(f64, f64)>) -> Option<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    points.dedup();
    let upper = hull(points, 1.0);
    let lower = hull(points, -1.0);
    let edges = upper.windows(2).chain(lower.windows(2));
    let slopes = edges.map(|ends| (ends[1].1 - ends[0].1) / (ends[1].0 - ends[0].0));
    let height = |slope: f64| {
        let off = |list: &[(f64, f64)], sign: f64| {
            let offs = list.iter().map(|point| sign * (point.1 - slope * point.0));
            offs.fold(f64::NEG_INFINITY, f64::max)
        };
        (off(&upper, 1.0) + off(&lower, -1.0)) / 2.0
    };
    // A curve at one place along the line deviates by half of its height, whatever the slope.
    let slopes = slopes.filter(|slope| slope.is_finite()).chain([0.0]);
    let heights = slopes.map(|slope| (slope, height(slope)));
    let best = heights.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let mut kept = [upper, lower].concat();
    std::mem::swap(points, &mut kept);
    (!points.is_empty()).then_some(best)
}

/// The upper hull of points in the order of their abscissas, with the sign -1 the lower one.
fn hull(points: &[(f64, f64)], sign: f64) -> Vec<(f64, f64)> {
    let mut hull: Vec<(f64, f64)> = Vec::new();
    for &point in points {
        while let [.., before, last] = hull[..] {
            let turn = (last.0 - before.0) * (point.1 - before.1)
                - (last.1 - before.1) * (point.0 - before.0);
            if sign * turn < 0.0 {
                break;
            }
            hull.pop();
        }
        hull.push(point);
    }
    hull
}
