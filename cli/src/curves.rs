//! The variables over a task: samples, extremes, and how accurate they are.

use assur::problem::Span;
use assur::registry::Settings;

use crate::case::Case;
use crate::error::Failure;
use crate::measures::Measured;
use crate::motion::Motion;
use crate::settings::RTOL;

/// Fewest samples over a task; 720 gives every half degree of a revolution.
const SAMPLES: usize = 720;
/// Most samples over a task.
const MOST_SAMPLES: usize = 40_000;

/// Samples of all variables over the task.
#[derive(Clone, Debug, Default)]
pub struct Curves {
    /// The times.
    pub times: Vec<f64>,
    /// Positions of the drivers at each time.
    pub drivers: Vec<Vec<f64>>,
    /// Values of the variables at each time.
    pub values: Vec<Vec<f64>>,
}

/// Smallest and largest value of a variable, each with its time.
#[derive(Clone, Copy, Debug)]
pub struct Extreme {
    /// Time and value of the smallest.
    pub minimum: (f64, f64),
    /// Time and value of the largest.
    pub maximum: (f64, f64),
}

impl Extreme {
    /// The largest absolute value.
    pub fn amplitude(&self) -> f64 {
        self.minimum.1.abs().max(self.maximum.1.abs())
    }
}

/// Samples the task evenly, more finely where the solution took many steps.
pub fn sample(case: &Case, motion: &Motion) -> Curves {
    let (from, to) = case.task.limits();
    if case.task == Span::Open {
        return Curves::default();
    }
    let count = (motion.effort().steps * 4)
        .clamp(SAMPLES, MOST_SAMPLES)
        .next_multiple_of(SAMPLES);
    let mut times: Vec<f64> = (0..=count)
        .map(|index| from + (to - from) * index as f64 / count as f64)
        .collect();
    // Right before and after each event, so that a jump is one.
    let events = motion.events().iter().map(|event| event.time);
    times.extend(events.flat_map(|time| [time.next_down(), time]));
    times.sort_by(f64::total_cmp);
    times.dedup();
    Curves {
        drivers: times.iter().map(|time| case.drivers(*time)).collect(),
        values: times
            .iter()
            .map(|time| case.sample(motion, *time))
            .collect(),
        times,
    }
}

/// How accurate a solution is.
pub struct Estimate {
    /// Global error of each variable.
    pub errors: Vec<f64>,
    /// Error of each variable at the beginning of the task: of a run, whose start is given, rounding alone.
    pub start: Vec<f64>,
    /// Global error of each measure; NaN where one of the two solutions does not have it.
    pub measures: Vec<f64>,
    /// Error of the time after which the motion repeats, where that is a result.
    pub period: f64,
    /// How many times the work of the printed solution ten times more accuracy takes.
    pub tenfold: Option<f64>,
}

/// The global error of each variable and measure by solving again with another tolerance, and the work of ten times more accuracy.
///
/// The error is proportional to the tolerance, so a solution with a tenth of it differs from the printed one by nine
/// tenths of the printed one's error. Where double precision leaves no room for a tenth, ten times the tolerance gives
/// an upper bound instead. Rounding is added as a floor.
///
/// # Errors
/// When solving with the other tolerance does not succeed.
pub fn estimate(
    case: &Case,
    motion: &Motion,
    curves: &Curves,
    measures: &[Measured],
) -> Result<Estimate, Failure> {
    let rtol = motion.settings.rtol;
    let finer = rtol / 10.0 >= RTOL.0;
    let (other, share) = if finer {
        (rtol / 10.0, 10.0 / 9.0)
    } else {
        (rtol * 10.0, 1.0)
    };
    let check = case.solve(Settings {
        rtol: other,
        ..motion.settings
    })?;
    let differ = |time: f64, values: &[f64]| -> Vec<f64> {
        let pairs = values.iter().zip(case.sample(&check, time));
        let one = |(a, b): (&f64, f64)| ((a - b).abs() * share).max(4.0 * f64::EPSILON * a.abs());
        pairs.map(one).collect()
    };
    let mut errors = vec![0.0; case.variables.len()];
    // Every third sample is enough for a largest value.
    for (time, values) in curves.times.iter().zip(&curves.values).step_by(3) {
        // Between the times at which the two solutions have an event they differ by a jump.
        if motion.passed(*time) != check.passed(*time) {
            continue;
        }
        for (error, here) in errors.iter_mut().zip(differ(*time, values)) {
            *error = f64::max(*error, here);
        }
    }
    let start = match (case.task, curves.times.first(), curves.values.first()) {
        (Span::Run(..), Some(time), Some(values)) => differ(*time, values),
        _ => errors.clone(),
    };
    let work = motion.effort().evaluations;
    let tenfold = (finer && work > 0).then(|| check.effort().evaluations as f64 / work as f64);
    let others = check.measures(case);
    let measures = measures.iter().zip(others);
    let measures = measures.map(|(printed, other)| match (printed.value, other.value) {
        (Ok(a), Ok(b)) => ((a - b).abs() * share).max(4.0 * f64::EPSILON * a.abs()),
        _ => f64::NAN,
    });
    let lengths = motion.length().zip(check.length());
    let period = lengths.map_or(0.0, |(a, b)| (a - b).abs() * share);
    Ok(Estimate {
        measures: measures.collect(),
        period,
        errors,
        start,
        tenfold,
    })
}

/// Smallest and largest value of each variable, refined between the samples.
pub fn extremes(case: &Case, motion: &Motion, curves: &Curves) -> Vec<Extreme> {
    let best = |column: usize, sign: f64| {
        let value = |time: f64| {
            sign * case
                .sample(motion, time)
                .get(column)
                .copied()
                .unwrap_or(f64::NAN)
        };
        let samples = curves.values.iter().map(|row| sign * row[column]);
        let top = samples
            .enumerate()
            .filter(|(_, value)| value.is_finite())
            .max_by(|(_, a), (_, b)| a.total_cmp(b));
        let Some((index, sampled)) = top else {
            return (f64::NAN, f64::NAN);
        };
        let last = curves.times.len() - 1;
        let (time, refined) = climb(
            value,
            curves.times[index.saturating_sub(1)],
            curves.times[(index + 1).min(last)],
        );
        // At the border of the task the sample itself is the extreme.
        if refined > sampled {
            (time, sign * refined)
        } else {
            (curves.times[index], sign * sampled)
        }
    };
    (0..case.variables.len())
        .map(|column| Extreme {
            minimum: best(column, -1.0),
            maximum: best(column, 1.0),
        })
        .collect()
}

/// The largest value between two times, by golden section.
fn climb(value: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
    let (mut at_a, mut at_b) = (value(a), value(b));
    for _ in 0..36 {
        if at_a > at_b {
            (to, b, at_b) = (b, a, at_a);
            a = to - GOLDEN * (to - from);
            at_a = value(a);
        } else {
            (from, a, at_a) = (a, b, at_b);
            b = from + GOLDEN * (to - from);
            at_b = value(b);
        }
    }
    if at_a > at_b { (a, at_a) } else { (b, at_b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_of_a_parabola_is_found() {
        let (time, value) = climb(|time| 2.0 - (time - 0.3).powi(2), 0.0, 1.0);
        assert!((time - 0.3).abs() < 1e-7 && (value - 2.0).abs() < 1e-14);
    }
}
