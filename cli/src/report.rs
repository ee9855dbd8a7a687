//! Everything that `assur run` has to say, as numbers in SI units; how it is printed is decided elsewhere.

use std::time::Instant;

use assur::registry::{Mechanism, Settings};

use crate::error::Failure;
use crate::motion::{Case, Motion, Task};
use crate::multipliers::{self, Multiplier};
use crate::number;
use crate::published::{self, Comparison};
use crate::values::{Place, RTOL};

/// Fewest samples over a task; 720 gives every half degree of a revolution.
const SAMPLES: usize = 720;
/// Most samples over a task.
const MOST_SAMPLES: usize = 40_000;

/// All results of a run.
pub struct Report {
    /// The mechanism.
    pub mechanism: &'static Mechanism,
    /// The scene with its values.
    pub case: Case,
    /// The motion.
    pub motion: Motion,
    /// The curves.
    pub curves: Curves,
    /// Estimated global error of each variable, the largest over the task.
    pub errors: Vec<f64>,
    /// Everything at the beginning of the task.
    pub start: Snapshot,
    /// Smallest and largest value of each variable over the task.
    pub extremes: Vec<Extreme>,
    /// Everything at the places that were asked for.
    pub places: Vec<Snapshot>,
    /// Published values beside the computed ones.
    pub published: Vec<Comparison>,
    /// Floquet multipliers of a steady state.
    pub multipliers: Vec<Multiplier>,
    /// What it cost.
    pub cost: Cost,
}

impl Report {
    /// Whether the task is a steady state that repeats.
    pub fn is_cycle(&self) -> bool {
        matches!(self.case.task, Task::Periodic(_))
    }
}

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

/// All variables at one instant.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The place in words, `theta = 110 deg`.
    pub label: String,
    /// The time within the task.
    pub time: f64,
    /// Positions of the drivers.
    pub drivers: Vec<f64>,
    /// Values of the variables.
    pub values: Vec<f64>,
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

/// Time and accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Seconds of the solution that is printed.
    pub solve: f64,
    /// Seconds of everything, the estimate of the error included.
    pub total: f64,
    /// The largest error relative to the amplitude of its variable, with the index of that variable.
    pub worst: Option<(usize, f64)>,
    /// How many times the work of the printed solution ten times more accuracy takes; unknown at the limit of double
    /// precision.
    pub tenfold: Option<f64>,
}

/// Runs a scene and collects what there is to say about it.
///
/// # Errors
/// When the solvers do not succeed or a place is not reached.
pub fn collect(
    mechanism: &'static Mechanism,
    case: Case,
    settings: Settings,
    places: &[Place],
) -> Result<Report, Failure> {
    let clock = Instant::now();
    let times: Vec<_> = places
        .iter()
        .map(|place| locate(&case, *place))
        .collect::<Result<_, _>>()?;
    let motion = case.solve(settings)?;
    let curves = sample(&case, &motion);
    let (errors, tenfold) = estimate(&case, &motion, &curves)?;
    let extremes = extremes(&case, &motion, &curves);
    let (from, _) = case.task.limits();
    let start = snapshot(&case, &motion, from, place_label(&case, from));
    let places = times
        .into_iter()
        .map(|(time, label)| snapshot(&case, &motion, time, label))
        .collect();
    let published = published::compare(mechanism, &case, &motion, &extremes)?;
    let multipliers = multipliers::read(&motion.multipliers());
    let worst = errors
        .iter()
        .zip(&extremes)
        .map(|(error, extreme)| error / extreme.amplitude())
        .enumerate()
        .filter(|(_, share)| share.is_finite())
        .max_by(|(_, a), (_, b)| a.total_cmp(b));
    let cost = Cost {
        solve: motion.seconds,
        total: clock.elapsed().as_secs_f64(),
        worst,
        tenfold,
    };
    Ok(Report {
        mechanism,
        case,
        motion,
        curves,
        errors,
        start,
        extremes,
        places,
        published,
        multipliers,
        cost,
    })
}

/// The time of a place, with its name.
fn locate(case: &Case, place: Place) -> Result<(f64, String), Failure> {
    match place {
        Place::Time(time) => {
            let label = format!("time = {} s", number::short(time));
            case.reduce(time).map(|time| (time, label)).ok_or_else(|| {
                let (from, to) = case.task.limits();
                Failure::request(format!("the task does not reach time = {time} s"))
                    .place("--at")
                    .remedy(format!("it lasts from {from} s to {to} s"))
            })
        }
        Place::Driver(index, position) => {
            let label = driver_label(case, index, position);
            case.time_of(index, position)
                .map(|time| (time, label.clone()))
                .map_err(|(low, high)| {
                    Failure::request(format!("the task does not reach {label}"))
                        .place("--at")
                        .remedy(format!(
                            "it moves from {} to {}",
                            driver_label(case, index, low),
                            driver_label(case, index, high)
                        ))
                })
        }
    }
}

/// A position of a driver in words.
pub fn driver_label(case: &Case, index: usize, position: f64) -> String {
    let Some(driver) = case.scene.drivers.get(index) else {
        return String::new();
    };
    let value = number::short(position / driver.factor);
    format!("{} = {value} {}", driver.name, driver.unit)
        .trim_end()
        .to_owned()
}

/// A time in words: the position of the first driver, or the time where there is none.
pub fn place_label(case: &Case, time: f64) -> String {
    match case.drivers(time).first() {
        Some(position) => driver_label(case, 0, *position),
        None => format!("time = {} s", number::short(time)),
    }
}

/// All variables at a time.
pub fn snapshot(case: &Case, motion: &Motion, time: f64, label: String) -> Snapshot {
    Snapshot {
        label,
        time,
        drivers: case.drivers(time),
        values: case.sample(motion, time),
    }
}

/// Samples the task evenly, more finely where the solution took many steps.
pub fn sample(case: &Case, motion: &Motion) -> Curves {
    let (from, to) = case.task.limits();
    if case.task == Task::Open {
        return Curves::default();
    }
    let count = (motion.effort().steps * 4)
        .clamp(SAMPLES, MOST_SAMPLES)
        .next_multiple_of(SAMPLES);
    let times: Vec<_> = (0..=count)
        .map(|index| from + (to - from) * index as f64 / count as f64)
        .collect();
    Curves {
        drivers: times.iter().map(|time| case.drivers(*time)).collect(),
        values: times
            .iter()
            .map(|time| case.sample(motion, *time))
            .collect(),
        times,
    }
}

/// The global error of each variable by solving again with another tolerance, and the work of ten times more accuracy.
///
/// The error is proportional to the tolerance, so a solution with a tenth of it differs from the printed one by nine
/// tenths of the printed one's error. Where double precision leaves no room for a tenth, ten times the tolerance gives
/// an upper bound instead. Rounding is added as a floor.
fn estimate(
    case: &Case,
    motion: &Motion,
    curves: &Curves,
) -> Result<(Vec<f64>, Option<f64>), Failure> {
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
    let mut errors = vec![0.0; case.variables.len()];
    // Every third sample is enough for a largest value.
    for (time, values) in curves.times.iter().zip(&curves.values).step_by(3) {
        for ((error, a), b) in errors
            .iter_mut()
            .zip(values)
            .zip(case.sample(&check, *time))
        {
            *error = f64::max(*error, (a - b).abs() * share).max(4.0 * f64::EPSILON * a.abs());
        }
    }
    let work = motion.effort().evaluations;
    let tenfold = (finer && work > 0).then(|| check.effort().evaluations as f64 / work as f64);
    Ok((errors, tenfold))
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
