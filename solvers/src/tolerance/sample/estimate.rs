//! What samples say of the distribution that they come from, with confidence intervals.

use super::tally::{Classes, Sums};
use crate::tolerance::random::normal;

/// An estimate with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// An estimated quantile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantile {
    /// Share of the linkages with a lesser error.
    pub level: f64,
    /// The error. An end of the interval that the samples do not reach is that extreme of them.
    pub estimate: Estimate,
}

/// Whether the statistics speak of all linkages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// All samples assemble.
    Complete,
    /// Some do not: the statistics are those of the others, and of no production as a whole.
    Conditional,
    /// None does: there are no statistics.
    Empty,
}

/// The errors of the output at one place, from samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// The output without any error.
    pub value: f64,
    /// Samples that were drawn.
    pub drawn: u64,
    /// Those that assemble in the mode of the nominal linkage.
    pub assembled: u64,
    /// Whether that are all.
    pub status: Status,
    /// Share of linkages that do not assemble in this mode, or whose mode cannot be told.
    pub failures: Estimate,
    /// Mean error.
    pub mean: Estimate,
    /// Standard deviation.
    pub deviation: Estimate,
    /// Third central moment over the cube of the standard deviation.
    pub skewness: f64,
    /// Least error that was met.
    pub least: f64,
    /// Greatest error that was met.
    pub greatest: f64,
    /// No larger a share of the linkages has lesser errors than the least, nor greater ones than the greatest; each with
    /// the confidence of the intervals.
    pub beyond: f64,
    /// Quantiles, as they were asked for.
    pub quantiles: Vec<Quantile>,
}

/// Everything about the samples at one place.
pub(super) struct Counted<'a> {
    pub value: f64,
    pub drawn: u64,
    pub sums: &'a Sums,
    pub classes: &'a Classes,
    /// Samples of each class and of those before.
    pub up_to: &'a [u64],
}

impl Counted<'_> {
    /// What they say, with intervals of a confidence.
    pub fn judge(&self, confidence: f64, levels: &[f64]) -> Sampled {
        let z = normal::quantile(0.5 + 0.5 * confidence);
        let sums = self.sums;
        let n = sums.count as f64;
        let [mean, ..] = sums.moments();
        let (deviation, skewness) = self.spread(z);
        let interval = z * deviation.value / n.sqrt();
        let [least, greatest] = match sums.count {
            0 => [f64::NAN; 2],
            _ => [sums.extremes.0, sums.extremes.1],
        };
        Sampled {
            value: self.value,
            drawn: self.drawn,
            assembled: sums.count,
            status: match (sums.count, self.drawn - sums.count) {
                (0, _) => Status::Empty,
                (_, 0) => Status::Complete,
                _ => Status::Conditional,
            },
            failures: share(self.drawn - sums.count, self.drawn, z),
            mean: around(mean, interval),
            deviation,
            skewness,
            least,
            greatest,
            beyond: 1.0 - (1.0 - confidence).powf(1.0 / n),
            quantiles: levels.iter().map(|level| self.quantile(*level, z)).collect(),
        }
    }

    /// The standard deviation, whose own follows from the fourth moment, and the skewness.
    fn spread(&self, z: f64) -> (Estimate, f64) {
        let n = self.sums.count as f64;
        let [_, second, third, fourth] = self.sums.moments();
        let deviation = (second * n / (n - 1.0)).sqrt();
        let variance = (fourth - second * second).max(0.0) / n;
        let half = match deviation > 0.0 {
            true => z * variance.sqrt() / (2.0 * deviation),
            false => 0.0 * deviation,
        };
        let estimate = Estimate { low: (deviation - half).max(0.0), ..around(deviation, half) };
        (estimate, third / second.powf(1.5))
    }

    /// A quantile. The number of samples below it is binomial, which says between which of them it lies.
    fn quantile(&self, level: f64, z: f64) -> Quantile {
        let at = |share: f64| self.classes.quantile(self.up_to, share, self.sums.extremes);
        let half = z * (level * (1.0 - level) / self.sums.count as f64).sqrt();
        Quantile {
            level,
            estimate: Estimate { value: at(level), low: at(level - half), high: at(level + half) },
        }
    }
}

fn around(value: f64, half: f64) -> Estimate {
    Estimate { value, low: value - half, high: value + half }
}

/// A share with the interval of E. B. Wilson (Journal of the American Statistical Association 22, 1927), which holds
/// near 0 and 1 too.
pub fn share(count: u64, of: u64, z: f64) -> Estimate {
    let n = of as f64;
    let p = count as f64 / n;
    let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt() / (1.0 + z * z / n);
    Estimate {
        value: p,
        low: if count == 0 { 0.0 } else { middle - half },
        high: if count == of { 1.0 } else { middle + half },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_intervals_at_the_ends_too() {
        let none = share(0, 1000, 1.96);
        assert_eq!((none.value, none.low), (0.0, 0.0));
        assert!((none.high - 0.003_827).abs() < 1e-5);
        let half = share(500, 1000, 1.96);
        assert!((half.low - 0.469_07).abs() < 1e-4 && (half.high - 0.530_93).abs() < 1e-4);
        assert_eq!(share(7, 7, 1.96).high, 1.0);
    }

    #[test]
    fn nothing_has_no_statistics() {
        let counted = Counted {
            value: 1.0,
            drawn: 10,
            sums: &Sums::NONE,
            classes: &Classes::around((0.0, 1.0)),
            up_to: &[0; crate::tolerance::sample::tally::CLASSES],
        };
        let sampled = counted.judge(0.95, &[0.5]);
        assert_eq!(sampled.status, Status::Empty);
        assert_eq!(sampled.failures.value, 1.0);
        for value in [
            sampled.mean.value,
            sampled.deviation.value,
            sampled.least,
            sampled.quantiles[0].estimate.value,
        ] {
            assert!(value.is_nan());
        }
    }
}
