//! What is kept of the samples at one place: sums of powers, extremes, and how many fell into each class.

use crate::scalar::{Pack, WIDTH};

/// Number of classes.
pub(super) const CLASSES: usize = 4096;

/// How many errors fell into each class.
pub(crate) type Counts = [u64; CLASSES];

/// 2⁵²: the last bits of a sum with it are those of a whole number.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// Least width of a class: it has a reciprocal.
const SMALLEST: f64 = 1e-300;

/// Joins the lanes of a pack, one after the other.
#[inline(always)]
fn fold<P: Pack>(pack: P, first: f64, join: impl Fn(f64, f64) -> f64) -> f64 {
    let mut lanes = [0.0; WIDTH];
    pack.store(&mut lanes);
    lanes[..P::WIDTH].iter().fold(first, |one, other| join(one, *other))
}

/// Sums over samples. They are added up in the order of the samples, so that they do not depend on who drew them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums {
    /// Samples that assemble.
    pub count: u64,
    /// Sums of the first four powers of their errors.
    pub powers: [f64; 4],
    /// Least and greatest error.
    pub extremes: (f64, f64),
}

impl Sums {
    pub const NONE: Self =
        Self { count: 0, powers: [0.0; 4], extremes: (f64::INFINITY, f64::NEG_INFINITY) };

    /// Adds errors, of which there are whole packs; one that is no number is none. Each lane is added up by itself.
    #[inline(always)]
    pub fn add_all<P: Pack>(&mut self, errors: &[f64]) {
        let (mut count, mut powers) = (P::ZERO, [P::ZERO; 4]);
        let (mut least, mut greatest) =
            (P::from_f64(f64::INFINITY), P::from_f64(f64::NEG_INFINITY));
        for errors in errors.chunks_exact(P::WIDTH) {
            let error = P::load(errors);
            let is = P::equal(error, error);
            count = count + P::select(is, P::ONE, P::ZERO);
            least = P::select(P::less(error, least), error, least);
            greatest = P::select(P::less(greatest, error), error, greatest);
            let error = P::select(is, error, P::ZERO);
            let square = error * error;
            powers = [
                powers[0] + error,
                powers[1] + square,
                square.mul_add(error, powers[2]),
                square.mul_add(square, powers[3]),
            ];
        }
        self.count += fold(count, 0.0, |sum, more| sum + more) as u64;
        for (sum, power) in self.powers.iter_mut().zip(powers) {
            *sum = fold(power, *sum, |sum, more| sum + more);
        }
        self.extremes.0 = fold(least, self.extremes.0, f64::min);
        self.extremes.1 = fold(greatest, self.extremes.1, f64::max);
    }

    pub fn join(&mut self, other: &Self) {
        self.count += other.count;
        for (sum, more) in self.powers.iter_mut().zip(other.powers) {
            *sum += more;
        }
        self.extremes.0 = self.extremes.0.min(other.extremes.0);
        self.extremes.1 = self.extremes.1.max(other.extremes.1);
    }

    /// Mean and second to fourth central moments; NaN without samples.
    pub fn moments(&self) -> [f64; 4] {
        let n = self.count as f64;
        let [mean, second, third, fourth] = self.powers.map(|sum| sum / n);
        let square = mean * mean;
        [
            mean,
            if second < square { 0.0 } else { second - square },
            third - 3.0 * mean * second + 2.0 * mean * square,
            fourth - 4.0 * mean * third + 6.0 * square * second - 3.0 * square * square,
        ]
    }
}

/// The bounds of the classes, all alike wide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Classes {
    low: f64,
    width: f64,
    /// Reciprocal of the width.
    scale: f64,
}

impl Classes {
    /// Classes around errors that have been seen, with room for as much again.
    pub fn around((low, high): (f64, f64)) -> Self {
        let room = 0.5 * (high - low);
        let width = (2.0 * (high - low) / CLASSES as f64).max(SMALLEST);
        let (low, width) = match low <= high && width.is_finite() {
            true => (low - room, width),
            false => (-1.0, 2.0 / CLASSES as f64),
        };
        Self { low, width, scale: 1.0 / width }
    }

    /// Counts errors in their classes, of which there are whole packs; one that is no number in none.
    #[inline(always)]
    pub fn count<P: Pack>(&self, errors: &[f64], counts: &mut Counts) {
        let mut classes = [0.0; WIDTH];
        for errors in errors.chunks_exact(P::WIDTH) {
            self.class(P::load(errors)).store(&mut classes);
            for (error, class) in errors.iter().zip(classes) {
                if !error.is_nan() {
                    counts[(class + WHOLE).to_bits() as usize % CLASSES] += 1;
                }
            }
        }
    }

    /// The class of an error; the first and the last also take what lies beyond them.
    #[inline(always)]
    pub fn class<P: Pack>(&self, error: P) -> P {
        let last = P::from_f64((CLASSES - 1) as f64);
        let class = ((error - P::from_f64(self.low)) * P::from_f64(self.scale)).floor();
        let class = P::select(P::less(class, P::ZERO), P::ZERO, class);
        P::select(P::less(last, class), last, class)
    }

    /// The error below which a share of the samples lies, by straight lines within the classes; `up_to` counts the samples
    /// of each class and of those before.
    pub fn quantile(&self, up_to: &[u64], share: f64, (least, greatest): (f64, f64)) -> f64 {
        let all = up_to.last().copied().unwrap_or(0);
        let wanted = share.clamp(0.0, 1.0) * all as f64;
        let class = up_to.partition_point(|count| *count == 0 || (*count as f64) < wanted);
        let Some(&reached) = up_to.get(class) else { return f64::NAN };
        let below = class.checked_sub(1).map_or(0, |before| up_to[before]);
        let from = (self.low + class as f64 * self.width).max(least);
        let to = (self.low + (class + 1) as f64 * self.width).min(greatest);
        let from = if class == 0 { least } else { from };
        let to = if class + 1 == CLASSES { greatest } else { to };
        from + (to - from) * ((wanted - below as f64) / (reached - below) as f64)
    }
}

/// Adds to each count those before it.
pub(super) fn cumulate(counts: &mut [u64]) {
    let mut sum = 0;
    for count in counts {
        sum += *count;
        *count = sum;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_central() {
        let mut sums = Sums::NONE;
        let mut halves = [Sums::NONE; 2];
        sums.add_all::<f64>(&[1.0, 2.0, f64::NAN, 4.0, 9.0]);
        halves[0].add_all::<f64>(&[1.0, 2.0]);
        halves[1].add_all::<f64>(&[4.0, 9.0, f64::NAN]);
        let [mut first, second] = halves;
        first.join(&second);
        for sums in [sums, first] {
            assert_eq!(sums.moments(), [4.0, 9.5, 22.5, 180.5 + 0.0]);
            assert_eq!(sums.extremes, (1.0, 9.0));
        }
        assert!(Sums::NONE.moments()[0].is_nan());
    }

    #[test]
    fn quantiles_of_an_even_spread() {
        let classes = Classes::around((0.0, 1.0));
        let mut counts = [0; CLASSES];
        for k in 0..100_000 {
            counts[classes.class((f64::from(k) + 0.5) / 1e5) as usize] += 1;
        }
        cumulate(&mut counts);
        for share in [0.001, 0.1, 0.5, 0.9, 0.999] {
            let found = classes.quantile(&counts, share, (0.0, 1.0));
            assert!((found - share).abs() < 2e-5, "{share}: {found}");
        }
    }

    #[test]
    fn what_lies_beyond_the_classes_is_counted() {
        let classes = Classes::around((0.0, 1.0));
        assert_eq!(classes.class(-1e9), 0.0);
        assert_eq!(classes.class(1e9) as usize, CLASSES - 1);
        assert_eq!(Classes::around((0.5, 0.5)).class(0.5), 0.0);
        let empty = Classes::around((f64::INFINITY, f64::NEG_INFINITY));
        assert!(empty.class(0.0) > 0.0);
    }
}
