//! The top of a hill. The place of an extreme is known to half of its digits only from values of the quantity, which is flat
//! there; where the *slope* is zero is known to nearly all. The slope is that of a polynomial through values at Chebyshev's
//! points, which costs no digits as long as these are apart: the polynomial is that of as wide a stretch as it fits.
//! (L. N. Trefethen: *Approximation Theory and Approximation Practice*, 2013, chapters 3, 8 and 19.)

use std::f64::consts::FRAC_1_SQRT_2;

/// Which extreme is meant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sense {
    /// The largest value.
    Largest,
    /// The smallest value.
    Smallest,
}

impl Sense {
    /// Whether the first value is further out. No value is better than one that is not a number, so that it shows.
    pub fn better(self, a: f64, b: f64) -> bool {
        match self {
            _ if a.is_nan() => !b.is_nan(),
            Self::Largest => a > b,
            Self::Smallest => a < b,
        }
    }
}

/// The extreme of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top {
    /// The value.
    pub value: f64,
    /// Where.
    pub place: f64,
    /// How far the place may be wrong.
    pub blur: f64,
}

/// Degree of the polynomials.
const DEGREE: usize = 12;
/// Stretches that are tried, each narrower than the one before.
const ROUNDS: usize = 8;
/// Last coefficients of a polynomial that fits, over what it spans.
const FITS: f64 = 1e-4;
/// By how much the slope of a polynomial may be wrong, over what it may be wrong by itself.
const SLOPE: f64 = 2.0 * DEGREE as f64;
/// Roundings of a value.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
/// Golden sections that give all digits of a place.
const SECTIONS: usize = 80;
/// Halvings that close in on a zero of the slope.
const HALVINGS: usize = 60;

/// Parts at whose ends a quantity is looked at first.
const PARTS: usize = 32;

/// The largest value of a quantity between 0 and 1. Hills that do not show between neighbouring points of 33 are not seen.
pub fn highest(at: &mut dyn FnMut(f64) -> f64) -> Top {
    let place = |index: usize| index as f64 / PARTS as f64;
    let values: [f64; PARTS + 1] = std::array::from_fn(|index| at(place(index)));
    if let Some(index) = values.iter().position(|value| value.is_nan()) {
        return Top { value: f64::NAN, place: place(index), blur: 0.0 };
    }
    // Of a quantity that is the same everywhere one place is as good as any.
    let mut best = Top { value: values[0], place: 0.0, blur: 0.0 };
    for (index, here) in values.iter().enumerate() {
        let (before, after) = (index.saturating_sub(1), (index + 1).min(PARTS));
        let is_hill = values[before] <= *here && values[after] <= *here;
        let is_flat = values[before] == *here && values[after] == *here;
        if !is_hill || is_flat {
            continue;
        }
        let found = top(Sense::Largest, (place(before), place(after)), at);
        if found.value.is_nan() || found.value > best.value {
            best = found;
        }
    }
    best
}

/// The extreme of a quantity between two places.
pub fn top(sense: Sense, (mut from, mut to): (f64, f64), at: &mut dyn FnMut(f64) -> f64) -> Top {
    let mut found: Option<Top> = None;
    let mut best: Option<Top> = None;
    for _ in 0..ROUNDS {
        let stretch = Stretch::new((from, to), at);
        let place = stretch.furthest(sense);
        let reached = Top {
            value: stretch.values[place],
            place: stretch.at(node(place)),
            blur: stretch.half,
        };
        if best.is_none_or(|best| sense.better(reached.value, best.value)) {
            best = Some(reached);
        }
        if let Some((turn, blur)) = stretch.turns(place) {
            let turn = Top { value: at(turn), place: turn, blur };
            match found {
                // As narrow as this the values are no longer apart.
                Some(wider) if wider.blur <= blur => break,
                _ => found = Some(turn),
            }
            if stretch.is_exact() {
                break;
            }
        }
        // Two points on each side.
        let inner = |place: usize| stretch.at(node(place));
        let narrower = (inner((place + 2).min(DEGREE)), inner(place.saturating_sub(2)));
        if narrower == (from, to) || narrower.0 >= narrower.1 {
            break;
        }
        (from, to) = narrower;
    }
    match (found, best) {
        // By more than rounding the extreme is where the slope is zero, if it is.
        (Some(turn), Some(best)) if !by_more_than_rounding(sense, best.value, turn.value) => turn,
        (_, best) => corner(sense, (from, to), best, at),
    }
}

fn by_more_than_rounding(sense: Sense, a: f64, b: f64) -> bool {
    sense.better(a, b) && (a - b).abs() > ROUNDINGS * a.abs().max(b.abs())
}

/// Cosines of multiples of a twelfth of π, up to a quarter turn.
const COSINES: [f64; 7] = [
    1.0,
    0.965_925_826_289_068_3,
    0.866_025_403_784_438_6,
    FRAC_1_SQRT_2,
    0.5,
    0.258_819_045_102_520_74,
    0.0,
];

/// The cosine of so many twelfths of π.
fn cosine(twelfths: usize) -> f64 {
    match twelfths % 24 {
        part @ 0..=6 => COSINES[part],
        part @ 7..=12 => -COSINES[12 - part],
        part @ 13..=18 => -COSINES[part - 12],
        part => COSINES[24 - part],
    }
}

/// Place of a point, from 1 down to −1.
fn node(place: usize) -> f64 {
    cosine(place)
}

/// A stretch with the quantity at Chebyshev's points, last one first.
struct Stretch {
    middle: f64,
    half: f64,
    values: [f64; DEGREE + 1],
    /// Of the polynomial through them.
    coefficients: [f64; DEGREE + 1],
}

impl Stretch {
    fn new((from, to): (f64, f64), at: &mut dyn FnMut(f64) -> f64) -> Self {
        let (middle, half) = (from + (to - from) / 2.0, (to - from) / 2.0);
        let time = |place: usize| match place {
            0 => to,
            DEGREE => from,
            _ => middle + half * node(place),
        };
        let values = std::array::from_fn(|place| at(time(place)));
        Self { middle, half, values, coefficients: coefficients(&values) }
    }

    fn at(&self, place: f64) -> f64 {
        self.middle + self.half * place
    }

    /// The point that is furthest out.
    fn furthest(&self, sense: Sense) -> usize {
        let further =
            |best: usize, place: usize| match sense.better(self.values[place], self.values[best]) {
                true => place,
                false => best,
            };
        (1..=DEGREE).fold(0, further)
    }

    /// By how much the polynomial may be wrong: its last coefficients, and rounding.
    fn deviation(&self) -> f64 {
        let [.., a, b] = self.coefficients;
        a.abs().max(b.abs()).max(self.rounding())
    }

    fn rounding(&self) -> f64 {
        let size = self.values.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
        ROUNDINGS * size
    }

    /// Whether a narrower stretch would tell no more.
    fn is_exact(&self) -> bool {
        self.deviation() <= self.rounding()
    }

    /// Where the slope is zero beside a point, and how far that may be wrong. None where it is not, or where the
    /// polynomial does not fit.
    fn turns(&self, place: usize) -> Option<(f64, f64)> {
        let span: f64 = self.coefficients[1..].iter().map(|one| one.abs()).sum();
        if place == 0 || place == DEGREE || self.deviation() > FITS * span || span.is_nan() {
            return None;
        }
        let slope = derivative(&self.coefficients);
        let (mut low, mut high) = (node(place + 1), node(place - 1));
        let begin = sum(&slope, low);
        if begin * sum(&slope, high) > 0.0 {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = low + (high - low) / 2.0;
            match sum(&slope, middle) * begin > 0.0 {
                true => low = middle,
                false => high = middle,
            }
        }
        // As far as the slope cannot be told from zero.
        let noise = SLOPE * self.deviation();
        let mut part = noise / sum(&derivative(&slope), low).abs();
        let is_flat =
            |part: f64| [low - part, low + part].map(|place| sum(&slope, place).abs() <= noise);
        while part < 1.0 && is_flat(part).contains(&true) {
            part *= 2.0;
        }
        let turn = self.at(low);
        let blur = self.half * part.min(1.0) + f64::EPSILON * turn.abs();
        part.is_finite().then_some((turn, blur))
    }
}

/// Coefficients of the sum of Chebyshev polynomials through values at Chebyshev's points.
fn coefficients(values: &[f64; DEGREE + 1]) -> [f64; DEGREE + 1] {
    let end = |index: usize| {
        if index == 0 || index == DEGREE { 0.5 } else { 1.0 }
    };
    std::array::from_fn(|order| {
        let terms = values
            .iter()
            .enumerate()
            .map(|(place, value)| end(place) * value * cosine(place * order));
        end(order) * terms.sum::<f64>() * 2.0 / DEGREE as f64
    })
}

/// The derivative of a sum of Chebyshev polynomials.
fn derivative(coefficients: &[f64; DEGREE + 1]) -> [f64; DEGREE + 1] {
    let mut slope = [0.0; DEGREE + 1];
    for order in (1..=DEGREE).rev() {
        let next = slope.get(order + 1).copied().unwrap_or(0.0);
        slope[order - 1] = next + 2.0 * order as f64 * coefficients[order];
    }
    slope[0] /= 2.0;
    slope
}

/// A sum of Chebyshev polynomials, by Clenshaw's rule.
fn sum(coefficients: &[f64; DEGREE + 1], place: f64) -> f64 {
    let (mut last, mut before) = (0.0, 0.0);
    for coefficient in coefficients[1..].iter().rev() {
        (last, before) = (coefficient + 2.0 * place * last - before, last);
    }
    coefficients[0] + place * last - before
}

/// The extreme by golden sections, where the quantity is not smooth: at a corner its place is known to all digits from the
/// values alone.
fn corner(
    sense: Sense,
    (mut from, mut to): (f64, f64),
    best: Option<Top>,
    at: &mut dyn FnMut(f64) -> f64,
) -> Top {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (to - golden * (to - from), from + golden * (to - from));
    let (mut below, mut above) = (at(low), at(high));
    // The width from which on values could not be told apart.
    let mut flat: Option<f64> = None;
    for _ in 0..SECTIONS {
        flat = match (below - above).abs() <= ROUNDINGS * below.abs().max(above.abs()) {
            true => flat.or(Some(to - from)),
            false => None,
        };
        if !(from < low && low < high && high < to) {
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
    let (place, value) = match sense.better(below, above) {
        true => (low, below),
        false => (high, above),
    };
    match best {
        Some(best) if sense.better(best.value, value) => best,
        _ => Top { value, place, blur: flat.unwrap_or(to - from) + f64::EPSILON * place.abs() },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_highest_of_several_hills_is_found() {
        let found = highest(&mut |x| (20.0 * x).sin() - x);
        let place = 0.05f64.acos() / 20.0;
        let error = (found.value - (20.0 * place).sin() + place).abs();
        assert!(error < 1e-15 && (found.place - place).abs() < 1e-13, "{found:?}");
    }

    #[test]
    fn the_highest_may_lie_at_an_end_at_a_corner_or_everywhere() {
        assert_eq!(highest(&mut |x| 2.0 * x).place, 1.0);
        assert_eq!(highest(&mut |x| -x).place, 0.0);
        let corner = highest(&mut |x| -(x - 0.123_456_789).abs());
        assert!((corner.place - 0.123_456_789).abs() < 1e-14, "{corner:?}");
        assert_eq!(highest(&mut |_| 3.0).value, 3.0);
        assert!(highest(&mut |x| (x - 0.5).sqrt()).value.is_nan());
    }
}
