//! Change points: where closures that hold the coordinates depend on each other for an instant, as where all links of a
//! parallelogram lie flat. The motion might go on in several ways there, and goes on by its momentum.

use super::motion::Motion;
use crate::problem::Phase;
use nalgebra::DMatrix;

/// Below this the part of a closure that the others do not say is none, over the largest. A motion misses the point by its
/// errors.
const NOTHING: f64 = 1e-5;
/// Only what falls below this is looked at closely.
const NEAR: f64 = 0.5;
/// Parts of a step at whose ends it is looked at.
const PARTS: usize = 4;
/// A time is found when it is known to this, over the time at which the step ends.
const FOUND: f64 = 1e-12;
/// Chords lead to nothing if they meet below this share of the least value known.
const SHARE: f64 = 0.25;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The times at which a motion passes a change point; none where its closures are solved for.
pub(super) fn times(motion: &Motion) -> Vec<f64> {
    let model = motion.model();
    if (0..model.shape().modes.len().max(1)).all(|mode| model.shape().held_in(mode).is_none()) {
        return Vec::new();
    }
    let steps = motion.steps();
    let parts = steps.windows(2).flat_map(|step| {
        let part = (step[1] - step[0]) / PARTS as f64;
        (0..PARTS).map(move |index| step[0] + index as f64 * part)
    });
    let times: Vec<f64> = parts.chain(steps.last().copied()).collect();
    let sizes: Vec<f64> = times.iter().map(|time| independent(motion, *time)).collect();
    let mut found: Vec<f64> = Vec::new();
    for (index, own) in sizes.iter().enumerate() {
        let before = index.checked_sub(1).map_or(f64::INFINITY, |index| sizes[index]);
        let after = sizes.get(index + 1).copied().unwrap_or(f64::INFINITY);
        if *own >= NEAR || *own > before || *own > after {
            continue;
        }
        let ends = (times[index.saturating_sub(1)], times[(index + 1).min(times.len() - 1)]);
        let Some(time) = vanishes(|time| independent(motion, time), ends, (before, after)) else {
            continue;
        };
        if found.last().is_none_or(|last| (time - last).abs() > 1e-9 * time.abs()) {
            found.push(time);
        }
    }
    found
}

/// How much of the closures at a time is independent: the smallest part of one that the others do not say, over the largest.
fn independent(motion: &Motion, time: f64) -> f64 {
    let (mode, state) = motion.place(time);
    let model = motion.model();
    let Some(held) = model.shape().held_in(mode) else {
        return f64::INFINITY;
    };
    let (n, m) = (held.coordinates, held.loops.len());
    let mut values = vec![0.0; m * (2 + n)];
    model.reports().closures(Phase::of(mode), time, &state, &mut values);
    let entry = |row: usize, column: usize| values[2 * m + column * n + row] / held.sizes[column];
    let parts = DMatrix::from_fn(n, m, entry).col_piv_qr();
    let sizes = parts.unpack_r().diagonal().abs();
    sizes[held.rank.clamp(1, sizes.len()) - 1] / sizes[0].max(f64::MIN_POSITIVE)
}

/// Where a function that is given at two times falls to nothing between them. It is found by golden sections, and given up as
/// soon as the chords beside each part, which lead to nothing where it vanishes, lie well above.
fn vanishes(
    function: impl Fn(f64) -> f64,
    (mut from, mut to): (f64, f64),
    (mut at_from, mut at_to): (f64, f64),
) -> Option<f64> {
    let inner = |from: f64, to: f64| (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
    let (mut a, mut b) = inner(from, to);
    let (mut at_a, mut at_b) = (function(a), function(b));
    let narrow = FOUND * to.abs().max(from.abs());
    while at_a.min(at_b) > NOTHING || to - from > narrow {
        let chord = |(x, at_x): (f64, f64), (y, at_y): (f64, f64)| (at_y - at_x) / (y - x);
        let (left, middle, right) = (
            chord((from, at_from), (a, at_a)),
            chord((a, at_a), (b, at_b)),
            chord((b, at_b), (to, at_to)),
        );
        let meet = (at_b - at_a + left * a - right * b) / (left - right);
        let between = at_a + left * (meet - a);
        let before = at_a - middle * (a - from);
        let after = at_b + middle * (to - b);
        let least = between.min(before).min(after);
        if least > NOTHING.max(SHARE * at_a.min(at_b)) || !(from < a && a < b && b < to) {
            return None;
        }
        if at_a < at_b {
            (to, at_to, b, at_b) = (b, at_b, a, at_a);
            a = inner(from, to).0;
            at_a = function(a);
        } else {
            (from, at_from, a, at_a) = (a, at_a, b, at_b);
            b = inner(from, to).1;
            at_b = function(b);
        }
    }
    Some(if at_a < at_b { a } else { b })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a function is found to vanish, and how often it is looked at.
    fn look(f: fn(f64) -> f64, (from, to): (f64, f64)) -> (Option<f64>, usize) {
        let count = std::cell::Cell::new(0);
        let counted = |x: f64| {
            count.set(count.get() + 1);
            f(x)
        };
        (vanishes(counted, (from, to), (f(from), f(to))), count.get())
    }

    #[test]
    fn what_falls_to_nothing_is_found_wherever_it_lies() {
        for place in 1..100 {
            let from = 1.0 - f64::from(place) / 100.0;
            let (found, _) = look(|x| (x - 1.0).abs(), (from, from + 1.0));
            assert!(found.is_some_and(|at| (at - 1.0).abs() < 1e-5), "{place}: {found:?}");
            let (found, _) = look(|x| (x - 1.0).sin().abs() * (1.0 + 0.3 * x), (from, from + 1.0));
            assert!(found.is_some_and(|at| (at - 1.0).abs() < 1e-5), "{place}: {found:?}");
        }
    }

    #[test]
    fn a_motion_may_begin_at_a_change_point() {
        let (found, count) = look(|x| x, (0.0, 0.1));
        assert!(found.is_some_and(|at| at < 1e-12) && count < 80, "{found:?} after {count}");
    }

    #[test]
    fn what_does_not_is_given_up_soon() {
        for f in [
            |x: f64| 0.1 + (x - 1.0).powi(2),
            |x: f64| 1e-3 + (x - 1.0).powi(2),
            |x: f64| (x - 1.0).hypot(1e-2),
        ] {
            let (found, count) = look(f, (0.4, 1.3));
            assert!(found.is_none() && count < 40, "{found:?} after {count}");
        }
    }
}
