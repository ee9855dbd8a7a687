//! The variables over a task: samples, and extremes.

use assur::answer::{Motion, Samples};
use assur::measure::Extremes;
use assur::problem::Span;

use super::case::Case;

/// Fewest samples over a task; 720 gives every half degree of a revolution.
const SAMPLES: usize = 720;
/// Most samples over a task that are even in time, and most others.
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

impl Curves {
    /// The samples, to be compared with.
    pub fn samples(&self) -> Samples<'_> {
        Samples { times: &self.times, values: &self.values }
    }
}

/// Samples the task: evenly, more finely where the solution took many steps; at every step that is shorter than that; at
/// all extremes; and right before and after each event, so that a jump is one.
pub fn sample(case: &Case, motion: &Motion, extremes: &[Extremes]) -> Curves {
    let (from, to) = case.moved.task.limits();
    if matches!(case.moved.task, Span::Open | Span::Rest) {
        return Curves::default();
    }
    let count =
        (motion.statistics().steps * 4).clamp(SAMPLES, MOST_SAMPLES).next_multiple_of(SAMPLES);
    let mut times: Vec<f64> =
        (0..=count).map(|index| from + (to - from) * index as f64 / count as f64).collect();
    times.extend(short_steps(case, motion, (to - from) / count as f64));
    let ends = extremes.iter().flat_map(|one| [one.lowest, one.highest]);
    times.extend(ends.map(|extreme| extreme.time));
    let events = motion.events().iter().map(|event| event.time);
    times.extend(events.flat_map(|time| [time.next_down(), time]));
    times.retain(|time| (from..=to).contains(time));
    times.sort_by(f64::total_cmp);
    times.dedup();
    Curves {
        drivers: times.iter().map(|time| case.drivers_at(*time)).collect(),
        values: times.iter().map(|time| case.sample(motion, *time)).collect(),
        times,
    }
}

/// The ends of the steps that are shorter than a length. Of more than a figure can hold those between which every variable
/// is largest or smallest, so many steps at a time.
fn short_steps(case: &Case, motion: &Motion, length: f64) -> Vec<f64> {
    let steps = motion.steps();
    let short = steps.windows(2).filter(|step| step[1] - step[0] < length);
    let times: Vec<f64> = short.map(|step| step[1]).collect();
    if times.len() <= MOST_SAMPLES {
        return times;
    }
    let parts = MOST_SAMPLES / (2 * case.variables.len().max(1));
    let each = times.len().div_ceil(parts.max(1));
    times.chunks(each).flat_map(|times| furthest(case, motion, times)).collect()
}

/// Of some times those at which a variable is smallest or largest.
fn furthest(case: &Case, motion: &Motion, times: &[f64]) -> Vec<f64> {
    let mut ends: Vec<[(f64, f64); 2]> = Vec::new();
    for time in times {
        let values = case.sample(motion, *time);
        ends.resize(values.len(), [(f64::MAX, *time), (f64::MIN, *time)]);
        for ([low, high], value) in ends.iter_mut().zip(values) {
            if value < low.0 {
                *low = (value, *time);
            }
            if value > high.0 {
                *high = (value, *time);
            }
        }
    }
    ends.into_iter().flatten().map(|(_, time)| time).collect()
}
