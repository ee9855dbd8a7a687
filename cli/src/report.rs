//! Everything that `assur run` has to say, as numbers in SI units; how it is printed is decided elsewhere.

use std::time::Instant;

use assur::problem::Span;
use assur::registry::{Mechanism, Settings};

use crate::case::Case;
use crate::curves::{self, Curves, Extreme};
use crate::error::Failure;
use crate::measures::Measured;
use crate::motion::Motion;
use crate::multipliers::{self, Multiplier};
use crate::number;
use crate::published::{self, Comparison};
use crate::values::Place;

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
    /// Numbers of the whole task.
    pub measures: Vec<Measured>,
    /// Everything at the places that were asked for.
    pub places: Vec<Snapshot>,
    /// Published values beside the computed ones.
    pub published: Vec<Comparison>,
    /// Floquet multipliers of a steady state.
    pub multipliers: Vec<Multiplier>,
    /// Estimated error of the time after which the motion repeats, in seconds; zero where that is given.
    pub period_error: f64,
    /// What it cost.
    pub cost: Cost,
}

impl Report {
    /// Number of free motions that nothing determines.
    pub fn free(&self) -> usize {
        self.motion.closing().map_or(0, |closing| closing.2)
    }

    /// What the multipliers say, a sentence each.
    pub fn conclusions(&self) -> Vec<String> {
        let (turn, followed) = (self.case.turn(), self.motion.followed());
        multipliers::conclusions(&self.multipliers, turn, self.free(), followed)
    }

    /// The period with its estimated error, where it is a result.
    pub fn period(&self) -> Option<(f64, f64)> {
        let (_, to) = self.case.task.limits();
        (self.case.run().span() == Span::Autonomous).then_some((to, self.period_error))
    }

    /// Whether the task is a steady state that repeats.
    pub fn is_cycle(&self) -> bool {
        matches!(self.case.task, Span::Periodic(_))
    }
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
    /// Their estimated errors.
    pub errors: Vec<f64>,
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
    mut case: Case,
    settings: Settings,
    places: &[Place],
) -> Result<Report, Failure> {
    let clock = Instant::now();
    let motion = case.solve(settings)?;
    case.repeat(&motion);
    let times: Vec<_> = places
        .iter()
        .map(|place| locate(&case, *place))
        .collect::<Result<_, _>>()?;
    let curves = curves::sample(&case, &motion);
    let mut measures = motion.measures(&case);
    let estimate = curves::estimate(&case, &motion, &curves, &measures)?;
    for (measure, error) in measures.iter_mut().zip(&estimate.measures) {
        measure.error = *error;
    }
    let errors = estimate.errors.clone();
    let extremes = curves::extremes(&case, &motion, &curves);
    let (from, _) = case.task.limits();
    let snapshot = |time: f64, label: String| Snapshot {
        label,
        time,
        drivers: case.drivers(time),
        values: case.sample(&motion, time),
        errors: match time == from {
            true => estimate.start.clone(),
            false => errors.clone(),
        },
    };
    let start = snapshot(from, place_label(&case, from));
    let places = times.into_iter();
    let places = places.map(|(time, label)| snapshot(time, label)).collect();
    let published = published::compare(mechanism, &case, &motion, &extremes, &errors)?;
    let multipliers = multipliers::read(motion.multipliers());
    let worst = (0..errors.len())
        .map(|index| errors[index] / size(&case, &extremes, index))
        .enumerate()
        .filter(|(_, share)| share.is_finite())
        .max_by(|(_, a), (_, b)| a.total_cmp(b));
    let cost = Cost {
        solve: motion.seconds,
        total: clock.elapsed().as_secs_f64(),
        worst,
        tenfold: estimate.tenfold,
    };
    Ok(Report {
        mechanism,
        case,
        motion,
        curves,
        errors,
        start,
        extremes,
        measures,
        places,
        published,
        multipliers,
        period_error: estimate.period,
        cost,
    })
}

/// What the error of a variable is compared with: its amplitude; where that is nothing beside other variables of the
/// same unit, as a difference that vanishes, a billionth of theirs.
fn size(case: &Case, extremes: &[Extreme], index: usize) -> f64 {
    let variables = case.variables.iter().zip(extremes);
    let alike = variables.filter(|(other, _)| other.dimension == case.variables[index].dimension);
    let largest = alike
        .map(|(_, extreme)| extreme.amplitude())
        .fold(0.0, f64::max);
    extremes[index].amplitude().max(1e-9 * largest)
}

/// The time of a place, with its name.
fn locate(case: &Case, place: Place) -> Result<(f64, String), Failure> {
    match place {
        Place::Time(time) => {
            let label = format!("time = {} s", number::short(time));
            let reached = case.task.reduce(time).map(|time| (time, label));
            reached.ok_or_else(|| {
                let (from, to) = case.task.limits();
                Failure::request(format!("the task does not reach time = {time} s"))
                    .place("--at")
                    .remedy(format!("it lasts from {from} s to {to} s"))
            })
        }
        Place::Driver(index, position) => {
            let label = driver_label(case, index, position);
            case.run()
                .time_of(index, position)
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
