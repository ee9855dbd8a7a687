//! Where a multiplier is nearest to what it meets, between three values.
//!
//! The square of the distance is smooth, and near a resonance a parabola, so the search is Brent's (Algorithms for
//! Minimization without Derivatives, 1973, chapter 5).

use super::track::{Section, matched};
use super::{Resonance, Spectrum};
use assur_solvers::periodic::Multiplier;

/// Most values that are tried.
const TRIES: usize = 80;
/// Part of the value to which the place is found at best.
const SMALLEST: f64 = 4.0 * f64::EPSILON;
/// Shorter part of the golden section.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// A value with the square of the distance there.
#[derive(Clone)]
struct Point {
    value: f64,
    square: f64,
    spectrum: Spectrum,
}

/// The place with the multipliers there.
pub(super) fn find(
    at: &(dyn Fn(f64) -> Result<Spectrum, String> + Sync),
    section: &Section<'_>,
) -> Option<(Resonance, Spectrum)> {
    let point = |mut spectrum: Spectrum| {
        let (order, _) = matched(&section.expected(spectrum.value), &spectrum)?;
        spectrum.multipliers = order.iter().map(|at| spectrum.multipliers[*at]).collect();
        let square = section.square(&spectrum);
        Some(Point { value: spectrum.value, square, spectrum })
    };
    let [before, here, after] = section.around.map(|one| Point {
        value: one.value,
        square: section.square(one),
        spectrum: one.clone(),
    });
    let curvature = curvature(&before, &here, &after);
    let (mut low, mut high) = if before.value < after.value {
        (before.value, after.value)
    } else {
        (after.value, before.value)
    };
    // The best three, the best first.
    let mut best = [here, before, after];
    best[1..].sort_by(|a, b| a.square.total_cmp(&b.square));
    let (mut step, mut last) = (high - low, high - low);
    let mut known = section.known(&best[0].spectrum, curvature);
    for _ in 0..TRIES {
        let (value, middle) = (best[0].value, 0.5 * (low + high));
        known = section.known(&best[0].spectrum, curvature);
        let smallest = known.max(SMALLEST * value.abs().max(low.abs()).max(high.abs()));
        if (value - middle).abs() <= 2.0 * smallest - 0.5 * (high - low) {
            break;
        }
        let parabola = vertex(&best).map(|vertex| vertex - value);
        let reach = 0.5 * last.abs();
        let is_useful = |by: &f64| {
            let tried = value + by;
            by.abs() < reach && tried > low && tried < high
        };
        last = step;
        step = match parabola.filter(is_useful) {
            Some(by) => by,
            None => {
                last = if value < middle { high - value } else { low - value };
                GOLDEN * last
            }
        };
        let by = if step.abs() >= smallest { step } else { smallest.copysign(step) };
        let tried = point(at(value + by).ok()?)?;
        let (a, b) = (&mut low, &mut high);
        if tried.square <= best[0].square {
            *(if by >= 0.0 { a } else { b }) = value;
            best.rotate_right(1);
            best[0] = tried;
        } else {
            *(if by < 0.0 { a } else { b }) = tried.value;
            if tried.square <= best[1].square {
                best.swap(1, 2);
                best[1] = tried;
            } else if tried.square <= best[2].square {
                best[2] = tried;
            }
        }
    }
    let [found, ..] = best;
    let resonance = Resonance {
        value: found.value,
        error: known.max(0.5 * (high - low)),
        meets: section.meets,
        distance: found.square.abs().sqrt(),
        multiplier: found.spectrum.multipliers[section.pair[0]],
        growth: found.spectrum.growth(),
    };
    Some((resonance, found.spectrum))
}

impl Section<'_> {
    /// The multipliers at a value between the three, by those at its neighbours.
    fn expected(&self, value: f64) -> Spectrum {
        let [before, here, after] = self.around;
        let beside =
            if (value - here.value) * (after.value - here.value) >= 0.0 { after } else { before };
        let part = (value - here.value) / (beside.value - here.value);
        let between = |a: f64, b: f64| a + part * (b - a);
        let pairs = here.multipliers.iter().zip(&beside.multipliers);
        let multipliers = pairs.map(|(a, b)| Multiplier {
            re: between(a.re, b.re),
            im: between(a.im, b.im),
            error: 0.0,
        });
        Spectrum { value, multipliers: multipliers.collect(), periods: here.periods }
    }

    /// How well the place is known, by the error of the multipliers and how fast they move.
    fn known(&self, of: &Spectrum, curvature: f64) -> f64 {
        let [one, other] = [self.pair[0], self.other[0]].map(|which| of.multipliers[which].error);
        f64::max(one, other) / curvature.max(f64::MIN_POSITIVE).sqrt()
    }
}

/// Half of the second derivative of the square of the distance: the square of the speed of what moves.
fn curvature(before: &Point, here: &Point, after: &Point) -> f64 {
    let slope = |a: &Point, b: &Point| (b.square - a.square) / (b.value - a.value);
    ((slope(here, after) - slope(before, here)) / (after.value - before.value)).abs()
}

/// The lowest point of the parabola through three points.
fn vertex(points: &[Point; 3]) -> Option<f64> {
    let [x, w, v] = points;
    let (a, b) =
        ((x.value - w.value) * (x.square - v.square), (x.value - v.value) * (x.square - w.square));
    let (p, q) = ((x.value - v.value) * b - (x.value - w.value) * a, 2.0 * (b - a));
    (q != 0.0).then(|| x.value - p / q).filter(|vertex| vertex.is_finite())
}
