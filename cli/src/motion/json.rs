//! A motion as an object.

use std::path::Path;

use assur::answer::End;
use assur::hybrid::Happened;
use assur::problem::Span;
use assur::shape::{EventEntry, Quantity};
use serde::Serialize;

use super::report::{Report, Snapshot};
use super::{events, rest};
use crate::run::{Found, Run};
use crate::show::json::{About, Amount, Number, Published, Reading, Settings, number, path, text};
use crate::show::measures::{self, Measure};
use crate::show::unit;

/// What is found of a scene that moves by its equations of motion.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Motion {
    task: Task,
    settings: Settings,
    status: Status,
    /// Every variable at the beginning of the task, and its extremes over the task.
    results: Vec<Result>,
    /// Everything at each `--at`.
    at: Vec<Place>,
    /// Of a motion with modes or events.
    modes: Vec<Mode>,
    /// The mode at the beginning of the task; null where there are none.
    first_mode: Option<&'static str>,
    /// What happened, in order.
    events: Vec<Event>,
    /// Times in seconds at which closures that hold the coordinates depend on each other for an instant: the motion goes on
    /// by its momentum.
    change_points: Vec<f64>,
    /// Numbers of the whole task.
    measures: Vec<Measure>,
    /// Floquet multipliers over all periods of the task; none unless it is periodic.
    multipliers: Vec<Multiplier>,
    /// How small disturbances of a position of rest move, those that vibrate first; none of what moves.
    vibrations: Vec<Vibration>,
    /// What multipliers or vibrations say, a sentence each.
    conclusions: Vec<String>,
    statistics: Statistics,
}

/// What is done.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Task {
    kind: TaskKind,
    from: f64,
    to: f64,
    unit: &'static str,
    /// After how many of them it repeats.
    periods: usize,
    /// Null unless it is a result: nothing drives the motion.
    period: Option<Period>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum TaskKind {
    /// A steady state.
    Periodic,
    /// From one time to another.
    Run,
    /// A position of rest.
    Rest,
    /// No motion: places alone.
    Open,
}

/// The time after which a motion repeats by itself.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Period {
    value: f64,
    estimated_error: Number,
}

/// How far the answer can be trusted.
#[derive(Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
enum Status {
    Complete,
    /// A value of `results`, `at` or `measures` is null because it is not a finite number or a measure is missing.
    Incomplete,
    /// Free motions repeat after the same period and nothing drives them, so that any amount could be added.
    #[serde(rename = "not unique")]
    NotUnique,
    /// A position of rest about which small disturbances grow: it does not stay there.
    Unstable,
    /// Solutions with other tolerances differ by more than a hundredth of the amplitude, as where errors grow without
    /// bound; the exit code is 1.
    Inaccurate,
}

/// A variable over the task.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Result {
    #[serde(flatten)]
    start: Reading,
    #[serde(skip_serializing_if = "Option::is_none")]
    minimum: Option<Extreme>,
    #[serde(skip_serializing_if = "Option::is_none")]
    maximum: Option<Extreme>,
}

/// The smallest or the largest value over the task.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Extreme {
    value: Number,
    estimated_error: Number,
    /// The first time at which it is reached.
    time: Number,
    /// Within how much later the value comes so near again that it cannot be told from it.
    estimated_error_of_time: Number,
}

/// Everything at a place that was asked for.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Place {
    /// In words.
    place: String,
    time: Number,
    /// Null where there are no modes.
    mode: Option<&'static str>,
    drivers: Vec<Amount>,
    results: Vec<Reading>,
}

/// A mode.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Mode {
    /// Empty where there are events and no modes.
    name: &'static str,
    summary: &'static str,
}

/// Something that happened.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Event {
    time: Number,
    /// Null where other tolerances lead to other events.
    estimated_error: Number,
    /// Name of the mode before it.
    from: &'static str,
    /// Name of the mode after it.
    to: &'static str,
    /// The statement of the equation file.
    event: &'static str,
    line: usize,
    /// What is left of the guard.
    guard: Guard,
    /// The state right before it.
    before: Vec<Amount>,
    /// The state right after it.
    after: Vec<Amount>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Guard {
    value: Number,
    unit: &'static str,
}

/// A Floquet multiplier.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Multiplier {
    re: Number,
    im: Number,
    modulus: Number,
    angle: Number,
    angle_unit: &'static str,
    /// Of `re` and `im` together.
    estimated_error: Number,
    /// What it does to a disturbance.
    meaning: String,
}

/// What it cost, and how good it is.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Statistics {
    steps: usize,
    rejected: usize,
    evaluations: usize,
    jacobians: usize,
    /// Steps by a stiff method.
    stiff_steps: usize,
    /// Steps by the Taylor series.
    series_steps: usize,
    /// Steps whose error is that of rounding, above the tolerance.
    rounded_steps: usize,
    /// Where the method `auto` changed.
    switches: Vec<Switch>,
    /// Condition number of the steady state.
    condition: Number,
    /// What the steady state misses after a period, over the scales of the states.
    residual: Number,
    seconds: f64,
    seconds_with_error_estimate: f64,
    largest_estimated_error: Option<Worst>,
    /// How many times the work ten times more accuracy takes.
    work_for_ten_times_more_accuracy: Number,
    /// Whether ten times more accuracy took too long to be tried.
    error_estimate_cut_off: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Switch {
    time: f64,
    /// The method that goes on.
    to: &'static str,
}

/// How a small disturbance of a position of rest moves: as `e^(rate t) cos(angular t)`, in a shape.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Vibration {
    /// Zero where it does not vibrate.
    frequency: Number,
    frequency_unit: &'static str,
    /// Share of critical damping, less than zero where the disturbance grows.
    damping: Number,
    rate: Number,
    angular: Number,
    rate_unit: &'static str,
    /// Of `rate` and `angular`.
    estimated_error: Number,
    meaning: String,
    /// The amplitudes, the largest first, which is one of its unit.
    shape: Vec<Amplitude>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Amplitude {
    name: String,
    unit: String,
    value: Number,
    /// By how much it leads.
    angle: Number,
    angle_unit: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Worst {
    name: String,
    relative_to_amplitude: Number,
}

/// The object.
pub fn run(report: &Report, figure: Option<&Path>) -> Run {
    let case = &report.case;
    Run::new(
        About::of(&case.constants),
        Found::Motion(Box::new(Motion::of(report))),
        Published::all(&report.published),
        path(figure),
    )
}

impl Motion {
    fn of(report: &Report) -> Self {
        let case = &report.case;
        let results = results(report);
        let at: Vec<_> = report.places.iter().map(|place| Place::of(report, place)).collect();
        let measures = measures::objects(report.case.scene, &report.measures);
        let places = at.iter().flat_map(|place| &place.results);
        let start = results.iter().map(|result| &result.start);
        let mut values = start.chain(places).chain(measures.iter().map(|one| &one.found));
        let status = match (values.all(|one| one.value.is_some()), report.free()) {
            (false, _) => Status::Incomplete,
            (true, 1..) => Status::NotUnique,
            _ if report.is_inaccurate() => Status::Inaccurate,
            _ if report.motion.rest().is_some_and(|rest| rest.growing().is_some()) => {
                Status::Unstable
            }
            _ => Status::Complete,
        };
        let modes = case.scene.modes.iter();
        Self {
            task: Task::of(report),
            settings: Settings::of(&report.motion.settings, case.scene),
            status,
            results,
            at,
            modes: modes.map(|mode| Mode { name: mode.name, summary: mode.summary }).collect(),
            first_mode: text(events::first_mode(report)),
            events: events::happened(report).map(|event| Event::of(report, event)).collect(),
            change_points: report.changes.clone(),
            measures,
            multipliers: multipliers(report),
            vibrations: Vibration::all(report),
            conclusions: report.conclusions(),
            statistics: Statistics::of(report),
        }
    }
}

impl Task {
    fn of(report: &Report) -> Self {
        let task = report.case.moved.task;
        let (kind, (from, to)) = match task {
            Span::Periodic(_) => (TaskKind::Periodic, task.limits()),
            Span::Run(..) => (TaskKind::Run, task.limits()),
            Span::Rest => (TaskKind::Rest, (0.0, 0.0)),
            // They last no time; the limits of such a span are those of a search.
            Span::Open | Span::Autonomous => (TaskKind::Open, (0.0, 0.0)),
        };
        let period = report.period();
        let period = period.map(|(value, error)| Period { value, estimated_error: number(error) });
        Self { kind, from, to, unit: "s", periods: report.case.moved.repeats, period }
    }
}

fn results(report: &Report) -> Vec<Result> {
    let variables = &report.case.variables;
    let end = |index: usize, end: End| Extreme {
        value: number(variables[index].in_unit(end.value)),
        estimated_error: number(variables[index].in_unit(end.error)),
        time: number(end.time),
        estimated_error_of_time: number(end.reach),
    };
    let readings = readings(report, &report.start).into_iter().enumerate();
    let result = |(index, start): (usize, Reading)| {
        let extremes = report.extremes.get(index);
        Result {
            start,
            minimum: extremes.map(|extremes| end(index, extremes.lowest)),
            maximum: extremes.map(|extremes| end(index, extremes.highest)),
        }
    };
    readings.map(result).collect()
}

fn readings(report: &Report, snapshot: &Snapshot) -> Vec<Reading> {
    let variables = report.case.variables.iter().zip(&snapshot.values).zip(&snapshot.errors);
    variables.map(|((variable, value), error)| Reading::of(variable, *value, *error)).collect()
}

impl Place {
    fn of(report: &Report, snapshot: &Snapshot) -> Self {
        let (mode, _) = report.motion.place(snapshot.time);
        Self {
            place: snapshot.label.clone(),
            time: number(snapshot.time),
            mode: text(report.case.mode(mode)),
            drivers: Amount::all(&report.case.drivers, &snapshot.drivers),
            results: readings(report, snapshot),
        }
    }
}

impl Event {
    fn of(report: &Report, (event, entry, error): (&Happened, &'static EventEntry, f64)) -> Self {
        let states = report.case.scene.states;
        Self {
            time: number(event.time),
            estimated_error: number(error),
            from: report.case.mode(event.from),
            to: report.case.mode(event.to),
            event: entry.text,
            line: entry.line as usize,
            guard: Guard {
                value: number(unit::stated(event.guard, entry.factor)),
                unit: entry.unit,
            },
            before: Amount::all(states, &event.before),
            after: Amount::all(states, &event.after),
        }
    }
}

fn multipliers(report: &Report) -> Vec<Multiplier> {
    let signs = |pair: bool| if pair { &[1.0, -1.0][..] } else { &[1.0][..] };
    let one = report.multipliers.iter().flat_map(|multiplier| {
        signs(multiplier.pair).iter().map(|sign| Multiplier {
            re: number(multiplier.re),
            im: number(sign * multiplier.im),
            modulus: number(multiplier.modulus()),
            angle: number(sign * multiplier.angle()),
            angle_unit: "deg",
            estimated_error: number(multiplier.error),
            meaning: multiplier.meaning(report.case.turn()),
        })
    });
    one.collect()
}

impl Vibration {
    fn all(report: &Report) -> Vec<Self> {
        let shape = report.motion.shape();
        let vibrations = report.motion.rest().into_iter().flat_map(|rest| &rest.vibrations);
        let vibration = |one: &assur::rest::Vibration| Self {
            frequency: number(one.frequency()),
            frequency_unit: "Hz",
            damping: number(one.damping()),
            rate: number(one.rate),
            angular: number(one.angular),
            rate_unit: "1/s",
            estimated_error: number(one.error),
            meaning: rest::meaning(one),
            shape: rest::amplitudes(shape, one).into_iter().map(Amplitude::of).collect(),
        };
        vibrations.map(vibration).collect()
    }
}

impl Amplitude {
    fn of((quantity, size, lead): (&Quantity, f64, f64)) -> Self {
        Self {
            name: quantity.name.to_owned(),
            unit: quantity.unit.to_owned(),
            value: number(size),
            angle: number(lead),
            angle_unit: "deg",
        }
    }
}

impl Statistics {
    fn of(report: &Report) -> Self {
        let (effort, cost) = (report.motion.statistics(), &report.cost);
        let repeats = report.motion.repeats();
        let switches = report.motion.switches().into_iter();
        Self {
            steps: effort.steps,
            rejected: effort.rejected,
            evaluations: effort.evaluations,
            jacobians: effort.jacobians,
            stiff_steps: effort.stiff_steps,
            series_steps: effort.series_steps,
            rounded_steps: effort.rounded_steps,
            switches: switches.map(|one| Switch { time: one.time, to: one.to.name() }).collect(),
            condition: repeats.and_then(|repeats| number(repeats.condition)),
            residual: repeats.and_then(|repeats| number(repeats.residual)),
            seconds: cost.solve,
            seconds_with_error_estimate: cost.total,
            largest_estimated_error: cost.worst.map(|(index, share)| Worst {
                name: report.case.variables[index].name.clone(),
                relative_to_amplitude: number(share),
            }),
            work_for_ten_times_more_accuracy: cost.tenfold.and_then(number),
            error_estimate_cut_off: cost.is_cut_off,
        }
    }
}
