//! What the values of a measure say together.

use assur_solvers::tolerance::{self, Estimate, normal_quantile};

/// The values of a measure in many runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Runs that have the measure.
    pub count: usize,
    /// Their mean, with its confidence interval.
    pub mean: Estimate,
    /// Their standard deviation.
    pub deviation: f64,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub greatest: f64,
    /// The values below which these shares lie.
    pub quantiles: Vec<(f64, f64)>,
}

/// Sums values up; none without any. The interval contains the mean with the probability `confidence`.
pub fn spread(values: &[f64], confidence: f64, levels: &[f64]) -> Option<Spread> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|one| one.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (least, greatest) = (*sorted.first()?, *sorted.last()?);
    let n = sorted.len() as f64;
    // From the middle of the range: a small spread around a large value loses no digits.
    let about = least + (greatest - least) / 2.0;
    let shift = sorted.iter().map(|one| one - about).sum::<f64>() / n;
    let squares = sorted.iter().map(|one| (one - about - shift).powi(2)).sum::<f64>();
    let deviation = match sorted.len() {
        1 => f64::NAN,
        _ => (squares / (n - 1.0)).sqrt(),
    };
    let mean = about + shift;
    let half = normal_quantile(0.5 + 0.5 * confidence) * deviation / n.sqrt();
    let quantile = |level: f64| {
        // Linear between the values (R. J. Hyndman, Y. Fan, The American Statistician 50, 1996, definition 7).
        let place = level.clamp(0.0, 1.0) * (n - 1.0);
        let low = place.floor() as usize;
        let high = (low + 1).min(sorted.len() - 1);
        sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
    };
    Some(Spread {
        count: sorted.len(),
        mean: Estimate { value: mean, low: mean - half, high: mean + half },
        deviation,
        least,
        greatest,
        quantiles: levels.iter().map(|level| (*level, quantile(*level))).collect(),
    })
}

/// The share of runs for which something holds, with its confidence interval.
pub fn share(count: usize, of: usize, confidence: f64) -> Estimate {
    let z = normal_quantile(0.5 + 0.5 * confidence);
    tolerance::share(count as u64, of as u64, z)
}
