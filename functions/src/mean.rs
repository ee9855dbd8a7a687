//! The mean of a function over a range: what an integral is, divided by its length.
//!
//! The function is given by its distance from either end, as a share of the range, so that whatever becomes infinite at an end
//! is computed without loss beside it. Most ranges need one Gauss–Kronrod rule with 21 points, or one for each half. Where these
//! do not agree the distance `t` from the end becomes `s⁴/2`, `0 <= s <= 1`: what grows like a power of `t`, or like its
//! logarithm, then is (nearly) smooth. The part with the largest error is halved until the errors are rounding, or no
//! halving helps. (R. Piessens et al.: *QUADPACK*, 1983, from which the estimate of the error is.)

/// Points of the rule.
pub const POINTS: usize = 21;
/// Distance of its points from the nearer end, the middle last; the weights of Kronrod's rule, and those of Gauss' rule at every
/// second point. All over a range of length 1.
const RULE: [(f64, f64, f64); 11] = [
    (0.002_171_418_487_095_959_5, 0.005_847_319_433_685_937, 0.0),
    (0.013_046_735_741_414_14, 0.016_279_081_153_982_362, 0.033_335_672_154_344_07),
    (0.034_921_254_322_145_885, 0.027_377_948_287_175_997, 0.0),
    (0.067_468_316_655_507_75, 0.037_519_837_405_459_98, 0.074_725_674_575_290_3),
    (0.109_591_136_706_791_55, 0.046_562_727_291_848_8, 0.0),
    (0.160_295_215_850_487_8, 0.054_693_579_401_148_82, 0.109_543_181_257_991_02),
    (0.218_621_432_665_697_67, 0.061_745_988_131_032_93, 0.0),
    (0.283_302_302_935_376_4, 0.067_354_608_655_736_67, 0.134_633_359_654_998_17),
    (0.352_803_568_649_269_9, 0.071_387_969_288_530_04, 0.0),
    (0.425_562_830_509_184_4, 0.073_869_552_450_669_24, 0.147_762_112_357_376_44),
    (0.5, 0.074_722_777_001_458_45, 0.0),
];
/// Parts into which a range is divided at most.
const MOST: usize = 256;
/// Errors that are rounding, over the mean of the absolute value.
const ROUNDING: f64 = 1e-14;
/// The least error of a part, over the same.
const FLOOR: f64 = 4.0 * f64::EPSILON;
/// With a larger error than this, over the same, a mean is told to be rough.
const ROUGH: f64 = 1e-10;
/// With a larger error than this, over the same, there is no mean: the function grows too fast, or swings without end.
const LARGEST: f64 = 1e-6;
/// Halvings that bring nothing before that is taken for rounding, and what is left of an error then.
const VAIN: (usize, f64) = (12, 0.9);

/// A part of the range.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    /// From which end the distance is counted; none for the whole range.
    end: Option<End>,
    /// Whether it is a half of the range as it is.
    is_plain: bool,
    /// Otherwise between which fourth roots of twice the distance it lies.
    roots: (f64, f64),
}

/// An end of the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// Where it begins.
    Near,
    /// Where it ends.
    Far,
}

impl Part {
    /// A point of the rule: from which end it is counted, and how far from it the point is, as a share of the range.
    #[inline(always)]
    pub fn point(&self, index: usize) -> (End, f64) {
        let (distance, is_far) = match index < POINTS / 2 {
            true => (RULE[index].0, false),
            false => (RULE[POINTS - 1 - index].0, index > POINTS / 2),
        };
        match self.end {
            None if is_far => (End::Far, distance),
            None => (End::Near, distance),
            Some(end) if self.is_plain => {
                (end, 0.5 * if is_far { 1.0 - distance } else { distance })
            }
            Some(end) => {
                let (from, to) = self.roots;
                let root = match is_far {
                    true => to - (to - from) * distance,
                    false => from + (to - from) * distance,
                };
                (end, 0.5 * (root * root) * (root * root))
            }
        }
    }

    /// What a value at a point counts beside its weight: the length of the part, and the slope of the distance.
    fn measure(&self, index: usize) -> f64 {
        let (from, to) = self.roots;
        match self.end {
            None => 1.0,
            Some(_) if self.is_plain => 0.5,
            Some(_) => {
                let x = RULE[index.min(POINTS - 1 - index)].0;
                let x = if index > POINTS / 2 { 1.0 - x } else { x };
                let root = from + (to - from) * x;
                2.0 * root * root * root * (to - from)
            }
        }
    }

    fn halves(&self) -> [Self; 2] {
        let Some(end) = self.end else {
            let plain = |end| Self { end: Some(end), is_plain: true, roots: (0.0, 1.0) };
            return [End::Near, End::Far].map(plain);
        };
        let (from, to) = self.roots;
        let middle = 0.5 * (from + to);
        let half = |roots| Self { end: Some(end), is_plain: false, roots };
        [(from, middle), (middle, to)].map(half)
    }
}

/// What a rule says of a part.
#[derive(Clone, Copy, Debug, Default)]
struct Share {
    part: Part,
    value: f64,
    /// The mean of the absolute value.
    size: f64,
    error: f64,
}

impl Share {
    fn of(part: Part, values: &[f64; POINTS]) -> Self {
        let scaled: [f64; POINTS] =
            std::array::from_fn(|index| values[index] * part.measure(index));
        let rule = |index: usize| RULE[index.min(POINTS - 1 - index)];
        let sum = |term: &dyn Fn(usize) -> f64| (0..POINTS).map(term).sum::<f64>();
        let value = sum(&|index| rule(index).1 * scaled[index]);
        let coarse = sum(&|index| rule(index).2 * scaled[index]);
        let size = sum(&|index| rule(index).1 * scaled[index].abs());
        let spread = sum(&|index| rule(index).1 * (scaled[index] - value).abs());
        let apart = (value - coarse).abs();
        let error = match spread > 0.0 && apart > 0.0 {
            true => spread * (200.0 * apart / spread).powf(1.5).min(1.0),
            false => apart,
        };
        Self { part, value, size, error: error.max(FLOOR * size) }
    }
}

/// The mean of a function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean; NaN where there is none.
    pub value: f64,
    /// How wrong it may be.
    pub error: f64,
    /// The mean of the absolute values.
    pub size: f64,
    /// Why there is none, or why it is not known to rounding.
    pub fault: Option<MeanFault>,
}

/// Why a function has no mean, or none that is known to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeanFault {
    /// It is no finite number at a place, a share of the range.
    NotFinite(f64),
    /// Its mean does not get any more accurate: the function itself is known no better.
    Rough {
        /// The mean.
        mean: f64,
        /// How wrong that may be.
        error: f64,
    },
    /// Its mean does not settle: it grows too fast beside a place, or swings without end.
    Diverges {
        /// The place that is worst, a share of the range.
        at: f64,
        /// The mean so far.
        mean: f64,
        /// How wrong that may be.
        error: f64,
    },
}

/// The mean of a function, of which `fill` gives the values at the points of a part.
pub fn mean(fill: &mut dyn FnMut(&Part, &mut [f64; POINTS])) -> Mean {
    let mut values = [0.0; POINTS];
    let whole = Part::default();
    fill(&whole, &mut values);
    let first = Share::of(whole, &values);
    if first.value.is_finite() && first.error <= ROUNDING * first.size {
        return Mean { value: first.value, error: first.error, size: first.size, fault: None };
    }
    in_parts(fill, values)
}

/// By halving. Outlined: most ranges do not come here, and need no room for the parts.
#[inline(never)]
fn in_parts(fill: &mut dyn FnMut(&Part, &mut [f64; POINTS]), mut values: [f64; POINTS]) -> Mean {
    let mut shares = [Share::default(); MOST];
    let mut count = 0;
    let mut vain = 0;
    let (mut worst, mut last) = (0, Share::default());
    loop {
        let mut halves = [Share::default(); 2];
        for (share, part) in halves.iter_mut().zip(last.part.halves()) {
            fill(&part, &mut values);
            if let Some(index) = values.iter().position(|value| !value.is_finite()) {
                return none(MeanFault::NotFinite(place(part.point(index))));
            }
            *share = Share::of(part, &values);
        }
        let error = halves[0].error + halves[1].error;
        vain += usize::from(count > 0 && error > VAIN.1 * last.error);
        shares[worst] = halves[0];
        shares[count.max(1)] = halves[1];
        count = count.max(1) + 1;
        let all = &shares[..count];
        let sum = |of: fn(&Share) -> f64| all.iter().map(of).sum::<f64>();
        let (value, size, error) =
            (sum(|one| one.value), sum(|one| one.size), sum(|one| one.error));
        let is_settled = error <= ROUNDING * size;
        if is_settled || count == MOST || vain == VAIN.0 {
            let larger = |best: usize, next: usize| {
                if all[next].error > all[best].error { next } else { best }
            };
            let at = place(all[(0..count).fold(0, larger)].part.point(POINTS / 2));
            return match is_settled || error <= LARGEST * size {
                true => {
                    let is_rough = error > ROUGH * size;
                    let rough = MeanFault::Rough { mean: value, error };
                    Mean { value, error, size, fault: is_rough.then_some(rough) }
                }
                false => none(MeanFault::Diverges { at, mean: value, error }),
            };
        }
        worst = (0..count).fold(
            0,
            |best, next| {
                if all[next].error > all[best].error { next } else { best }
            },
        );
        last = shares[worst];
    }
}

fn none(fault: MeanFault) -> Mean {
    Mean { value: f64::NAN, error: f64::INFINITY, size: f64::NAN, fault: Some(fault) }
}

/// The share of the range that lies before a point.
fn place((end, distance): (End, f64)) -> f64 {
    match end {
        End::Near => distance,
        End::Far => 1.0 - distance,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{E, PI};

    /// The integral of a function of the distances from both ends, and how often it is asked.
    fn integral(length: f64, f: &dyn Fn(f64, f64) -> f64) -> (Mean, usize) {
        let mut asked = 0;
        let found = mean(&mut |part, values| {
            for (index, value) in values.iter_mut().enumerate() {
                asked += 1;
                *value = length
                    * match part.point(index) {
                        (End::Near, t) => f(length * t, length - length * t),
                        (End::Far, t) => f(length - length * t, length * t),
                    };
            }
        });
        (found, asked)
    }

    #[track_caller]
    fn check(length: f64, f: &dyn Fn(f64, f64) -> f64, expected: f64, rtol: f64) -> usize {
        let (found, asked) = integral(length, f);
        let error = (found.value - expected).abs();
        assert!(error <= rtol * expected.abs(), "{found:?}, expected {expected}: {error:e}");
        assert!(error <= found.error + 4.0 * f64::EPSILON * expected.abs(), "{found:?}: {error:e}");
        asked
    }

    #[test]
    fn smooth_functions_take_one_rule() {
        assert_eq!(check(1.0, &|x, _| x.exp(), E - 1.0, 1e-15), 21);
        assert_eq!(check(2.0, &|x, _| x.powi(15), 2f64.powi(16) / 16.0, 1e-15), 21);
        assert_eq!(check(2.0, &|x, _| x.powi(24), 2f64.powi(25) / 25.0, 1e-14), 63);
        assert_eq!(check(PI, &|x, _| x.sin(), 2.0, 1e-15), 21);
    }

    #[test]
    fn what_is_infinite_at_an_end_is_known_to_rounding() {
        check(3.0, &|x, _| 1.0 / x.sqrt(), 2.0 * 3f64.sqrt(), 1e-14);
        check(3.0, &|_, y| 1.0 / y.sqrt(), 2.0 * 3f64.sqrt(), 1e-14);
        check(1.0, &|x, y| 1.0 / (x * y).sqrt(), PI, 1e-14);
        check(1.0, &|x, _| x.ln(), -1.0, 1e-13);
        check(1.0, &|x, _| x.powf(-0.75), 4.0, 1e-13);
        // The naive way loses half of the digits: the distance from the end is a difference of rounded numbers.
        let (naive, _) = integral(3.0, &|x, _| 1.0 / (3.0 - x).sqrt());
        let error = (naive.value - 2.0 * 3f64.sqrt()).abs();
        assert!(naive.value.is_nan() || error > 1e-10, "{naive:?}");
    }

    #[test]
    fn jumps_and_kinks_inside_are_closed_in_on() {
        check(1.0, &|x, _| if x < 0.3 { 1.0 } else { 5.0 }, 3.8, 1e-13);
        check(1.0, &|x, _| (x - 0.7).abs(), 0.29, 1e-14);
        check(
            1.0,
            &|x, _| (x - 0.7).abs().sqrt(),
            2.0 / 3.0 * (0.7f64.powf(1.5) + 0.3f64.powf(1.5)),
            1e-11,
        );
    }

    #[test]
    fn swift_oscillations_are_resolved() {
        check(1.0, &|x, _| (200.0 * x).sin(), (1.0 - 200f64.cos()) / 200.0, 1e-12);
        check(1.0, &|x, _| 1.0 / (1e-6 + (x - 0.5).powi(2)), 2e3 * 500f64.atan(), 1e-13);
    }

    #[test]
    fn what_diverges_is_said_to() {
        for f in [|x: f64, _: f64| 1.0 / x, |_: f64, y: f64| y.powf(-1.5)] {
            let (found, asked) = integral(1.0, &f);
            assert!(matches!(found.fault, Some(MeanFault::Diverges { .. })), "{found:?}");
            assert!(found.value.is_nan() && asked < 11_000, "{asked}");
        }
        let (found, _) = integral(1.0, &|x, _| (x - 0.5).sqrt());
        assert!(matches!(found.fault, Some(MeanFault::NotFinite(at)) if at < 0.5), "{found:?}");
    }

    #[test]
    fn noise_is_reported_as_an_error() {
        let noise =
            |x: f64| (x.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as f64 / 2f64.powi(24);
        let (found, asked) = integral(1.0, &|x, _| 1.0 + 1e-10 * noise(x));
        assert!((found.value - 1.0).abs() < 1e-10 && found.error < 1e-9, "{found:?}");
        let (rough, _) = integral(1.0, &|x, _| 1.0 + 1e-7 * noise(x));
        assert!(
            matches!(rough.fault, Some(MeanFault::Rough { error, .. }) if error < 1e-6),
            "{rough:?}"
        );
        assert!(asked < 2_000, "{asked}");
    }
}
