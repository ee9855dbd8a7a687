//! A linkage as an object.

use std::path::Path;

use assur::closure;
use assur::closure::{Range, Sample};
use assur::problem::Span;
use assur::shape::Quantity;
use serde::Serialize;

use super::case::{Case, Task};
use super::influence::unit_of;
use super::reach::{self, Gap};
use super::report::{Report, Snapshot, is_refused};
use super::{group, search};
use crate::ask::variables::Variable;
use crate::run::{Found, Run};
use crate::show::json::{About, Amount, Number, Published, number, path};
use crate::show::measures::{self, Measure};
use crate::show::unit;

/// What is found of a linkage.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Linkage {
    drivers: Vec<Driver>,
    task: Duty,
    status: Status,
    /// Where the way ends.
    stopped: Vec<Stop>,
    /// That it is put together far from the start values of its file, or why its measures are missing, in words.
    note: Option<String>,
    /// The limits of every variable over the task.
    results: Vec<Limits>,
    /// Numbers of the whole task.
    measures: Vec<Measure>,
    /// At round positions.
    positions: Vec<Position>,
    /// For each group that has a transmission angle.
    transmission: Vec<Transmission>,
    /// How far each driver goes in this assembly mode.
    reach: Vec<Reach>,
    /// What was met on the way.
    events: Vec<Met>,
    /// Everything at each `--at`.
    at: Vec<Place>,
    statistics: Statistics,
}

/// A driver and its range.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Driver {
    name: &'static str,
    unit: &'static str,
    from: Number,
    to: Number,
    start: Number,
}

/// What is done.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Duty {
    /// Drivers go over their ranges.
    Sweep {
        /// Their names.
        over: Vec<&'static str>,
    },
    /// Drivers move in time, over one period.
    Periodic(Times),
    /// Drivers move in time.
    Run(Times),
    /// Nothing but the places that are asked for.
    Open,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Times {
    from: f64,
    to: f64,
    unit: &'static str,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
enum Status {
    Complete,
    /// Positions of the task are not reached; the exit code is 1.
    Stopped,
    /// A value of `positions` or `at` is null because it is not a finite number.
    Incomplete,
}

/// Why positions are not reached.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Stop {
    place: String,
    reason: String,
}

/// The limits of a variable over the task.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Limits {
    name: String,
    unit: String,
    minimum: Option<Extreme>,
    maximum: Option<Extreme>,
    stroke: Number,
    /// Where it turns round inside a task with one axis; null over a grid.
    limit_positions: Option<Vec<Turn>>,
    /// Where it jumps, goes beyond all bounds or has no value; null over a grid.
    breaks: Option<Vec<Break>>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Extreme {
    /// Null beyond all bounds.
    value: Number,
    /// How far it may be off by rounding; null where that is not known.
    estimated_error: Number,
    unbounded: bool,
    at: Drivers,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Turn {
    /// `highest` or `lowest`.
    kind: &'static str,
    value: Number,
    /// How far it may be off by rounding; null where that is not known.
    estimated_error: Number,
    at: Drivers,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Break {
    /// `jump`, `pole` or `end` of what has a value.
    kind: &'static str,
    before: Side,
    after: Side,
    at: Drivers,
}

/// What a variable tends to.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(untagged)]
enum Side {
    Value(Number),
    /// Beyond all bounds: `inf` or `-inf`.
    Infinite(&'static str),
}

/// Where the drivers stand.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Drivers {
    drivers: Vec<Amount>,
    /// Where they move in time.
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<f64>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Position {
    #[serde(flatten)]
    place: Drivers,
    /// Values are null where the linkage does not get.
    results: Vec<Amount>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Transmission {
    loops: String,
    unknowns: String,
    kind: &'static str,
    smallest_angle: Number,
    unit: &'static str,
    at: Drivers,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Reach {
    driver: &'static str,
    unit: &'static str,
    /// Whether it turns all round.
    turns: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    low: Option<End>,
    #[serde(skip_serializing_if = "Option::is_none")]
    high: Option<End>,
    /// Why the ends are not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct End {
    at: Number,
    /// The loops whose dead point it is; null where it goes farther.
    dead_point: Option<String>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Met {
    place: String,
    /// In words.
    event: String,
}

/// Everything at a place that was asked for.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Place {
    /// In words.
    place: String,
    #[serde(flatten)]
    at: Drivers,
    /// Drivers outside of their ranges, in words.
    outside: Vec<String>,
    results: Vec<Amount>,
    /// How far each of the results may be off by rounding; null where that is not known.
    estimated_errors: Vec<Number>,
    transmission: Vec<Angle>,
    influence: Vec<Influence>,
}

/// A transmission angle.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Angle {
    loops: String,
    angle: Number,
    unit: &'static str,
}

/// What a driver or dimension does to an output.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Influence {
    by: &'static str,
    of: String,
    unit: String,
    value: Number,
    /// How far it may be off by rounding; null where that is not known.
    estimated_error: Number,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct Statistics {
    positions: usize,
    reached: usize,
    seconds: f64,
    seconds_with_limits: f64,
    /// By which share of the size of what is integrated an integral may be wrong; none where nothing is.
    integral_error: Option<f64>,
    /// What is left of the loop equation that is closed worst.
    largest_gap: Option<Residual>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Residual {
    r#loop: &'static str,
    value: Number,
    unit: &'static str,
}

/// The object.
pub fn run(report: &Report, figure: Option<&Path>) -> Run {
    Run::new(
        About::of(&report.case.constants),
        Found::Linkage(Box::new(Linkage::of(report))),
        Published::all(&report.published),
        path(figure),
    )
}

impl Linkage {
    fn of(report: &Report) -> Self {
        let case = &report.case;
        let stations = report.rows.iter().flat_map(|line| line.stations.iter().zip(&line.samples));
        let position = |(station, sample): (&Vec<f64>, &Option<Sample>)| Position {
            place: Drivers::of(case, station, &case.place(station)),
            results: results(case, sample.as_ref()),
        };
        let positions: Vec<_> = stations.map(position).collect();
        let at: Vec<_> = report.places.iter().map(|place| Place::of(case, place)).collect();
        let all = positions.iter().map(|one| &one.results).chain(at.iter().map(|one| &one.results));
        let swept = report.rows.iter().flat_map(|line| line.samples.iter().map(Option::as_ref));
        let samples = swept.chain(report.places.iter().map(|place| Some(&place.sample)));
        // Where a condition does not hold there is nothing to be had.
        let is_had = |(results, sample): (&Vec<_>, Option<&Sample>)| {
            sample.is_some_and(|sample| is_refused(case, sample))
                || results.iter().all(|one: &Amount| one.value.is_some())
        };
        let status = match (report.is_complete(), all.zip(samples).all(is_had)) {
            (false, _) => Status::Stopped,
            (true, false) => Status::Incomplete,
            (true, true) => Status::Complete,
        };
        let stop = |(place, reason): (&String, &String)| Stop {
            place: place.clone(),
            reason: reason.clone(),
        };
        let met =
            |(place, event): &(String, String)| Met { place: place.clone(), event: event.clone() };
        Self {
            drivers: Driver::all(case),
            task: Duty::of(case),
            status,
            stopped: report.stops.iter().map(|one| stop((&one.place, &one.reason))).collect(),
            note: report.note.clone(),
            results: Limits::all(report),
            measures: measures::objects(case.scene, &report.measures),
            positions,
            transmission: transmissions(report),
            reach: reaches(report),
            events: report.met.iter().map(met).collect(),
            at,
            statistics: Statistics::of(report),
        }
    }
}

impl Driver {
    /// All drivers with their ranges.
    pub fn all(case: &Case) -> Vec<Self> {
        let starts = case.standing().into_iter().map(Some);
        Self::starting((&case.drivers, &case.moved.ranges), starts)
    }

    /// All drivers with their ranges, each starting at a position, SI units.
    pub fn starting(
        (drivers, ranges): (&[Quantity], &[Range]),
        starts: impl Iterator<Item = Option<f64>>,
    ) -> Vec<Self> {
        let drivers = drivers.iter().zip(ranges).zip(starts);
        let one = drivers.map(|((driver, range), start)| {
            let stated = |value: f64| number(unit::stated(value, driver.factor));
            Self {
                name: driver.name,
                unit: driver.unit,
                from: stated(range.from),
                to: stated(range.to),
                start: start.and_then(stated),
            }
        });
        one.collect()
    }
}

impl Duty {
    fn of(case: &Case) -> Self {
        let times = |span: &Span| {
            let (from, to) = span.limits();
            Times { from, to, unit: "s" }
        };
        match &case.moved.task {
            Task::Sweep(drivers) => {
                let names = drivers.iter().map(|&index| case.drivers[index].name);
                Self::Sweep { over: names.collect() }
            }
            Task::Time(span @ Span::Periodic(_)) => Self::Periodic(times(span)),
            Task::Time(span) => Self::Run(times(span)),
            Task::Open => Self::Open,
        }
    }
}

impl Drivers {
    /// The drivers at a station of the task.
    fn of(case: &Case, station: &[f64], independents: &[f64]) -> Self {
        let is_timed = matches!(case.moved.task, Task::Time(_));
        Self {
            drivers: Amount::all(&case.drivers, independents),
            time: station.first().copied().filter(|_| is_timed),
        }
    }

    fn at(case: &Case, extreme: &search::Extreme) -> Self {
        Self::of(case, &extreme.station, &extreme.independents)
    }
}

fn results(case: &Case, sample: Option<&Sample>) -> Vec<Amount> {
    let values = sample.map(|sample| case.values(sample));
    Amount::results(&case.variables, values.as_deref())
}

impl Limits {
    fn all(report: &Report) -> Vec<Self> {
        let variables = report.case.variables.iter().zip(&report.limits).zip(&report.errors);
        let one = variables.enumerate().map(|(index, ((variable, limits), errors))| {
            Self::of(report, (index, variable), limits.as_ref(), *errors)
        });
        one.collect()
    }

    fn of(
        report: &Report,
        (index, variable): (usize, &Variable),
        limits: Option<&(search::Extreme, search::Extreme)>,
        errors: (f64, f64),
    ) -> Self {
        let case = &report.case;
        let end = |one: &search::Extreme, error: f64| Extreme {
            value: number(variable.in_unit(one.value)),
            estimated_error: number(variable.in_unit(error)),
            unbounded: one.value.is_infinite(),
            at: Drivers::at(case, one),
        };
        let stroke = reach::stroke(case, report.strokes.as_ref(), variable);
        let turn = |turn: reach::Turn| Turn {
            kind: turn.kind(),
            value: number(variable.in_unit(turn.place.value)),
            estimated_error: number(variable.in_unit(report.error(&turn.place, index))),
            at: Drivers::at(case, &turn.place),
        };
        let gap = |gap: Gap| Break {
            kind: gap.kind(),
            before: Side::of(variable, gap.place.value),
            after: Side::of(variable, gap.after),
            at: Drivers::at(case, &gap.place),
        };
        Self {
            name: variable.name.clone(),
            unit: variable.unit.clone(),
            minimum: limits.map(|(low, _)| end(low, errors.0)),
            maximum: limits.map(|(_, high)| end(high, errors.1)),
            stroke: limits.and_then(|(low, high)| number(variable.in_unit(high.value - low.value))),
            limit_positions: stroke
                .map(|stroke| reach::turns(case, stroke).into_iter().map(turn).collect()),
            breaks: stroke.map(|stroke| reach::gaps(case, stroke).into_iter().map(gap).collect()),
        }
    }
}

impl Side {
    fn of(variable: &Variable, value: f64) -> Self {
        match value {
            f64::INFINITY => Self::Infinite("inf"),
            f64::NEG_INFINITY => Self::Infinite("-inf"),
            value => Self::Value(number(variable.in_unit(value))),
        }
    }
}

fn reaches(report: &Report) -> Vec<Reach> {
    let case = &report.case;
    let one = report.reach.iter().map(|reach| {
        let driver = &case.drivers[reach.driver];
        let end = |end: &closure::End| {
            let dead = end.dead.and_then(|index| case.moved.entry.groups.get(index));
            End {
                at: number(unit::stated(end.at, driver.factor)),
                dead_point: dead.map(|of_group| group::equations(case.moved.entry, of_group)),
            }
        };
        let found = reach.stretch.as_ref();
        Reach {
            driver: driver.name,
            unit: driver.unit,
            turns: reach.turns,
            low: found.ok().map(|found| end(&found.low)),
            high: found.ok().map(|found| end(&found.high)),
            reason: found.err().map(|told| told.reason.clone()),
        }
    });
    one.collect()
}

fn transmissions(report: &Report) -> Vec<Transmission> {
    let entry = report.case.moved.entry;
    let one = report.transmissions.iter().map(|(index, worst)| {
        let of_group = &entry.groups[*index];
        Transmission {
            loops: group::equations(entry, of_group),
            unknowns: group::unknowns(entry, of_group),
            kind: group::kind(of_group.kind),
            smallest_angle: number(group::transmission(worst.value)),
            unit: "deg",
            at: Drivers::at(&report.case, worst),
        }
    });
    one.collect()
}

impl Place {
    fn of(case: &Case, snapshot: &Snapshot) -> Self {
        let time: Vec<_> = snapshot.place.time.into_iter().collect();
        let entry = case.moved.entry;
        let groups = entry.groups.iter().zip(&snapshot.sample.sines);
        let angles = groups.filter(|(of_group, _)| group::transmits(of_group));
        let angles = angles.map(|(of_group, sine)| Angle {
            loops: group::equations(entry, of_group),
            angle: number(group::transmission(*sine)),
            unit: "deg",
        });
        let coefficients = snapshot.influence.iter().flat_map(|row| {
            let outputs = case.variables.iter().zip(&row.values).enumerate();
            outputs.map(|(index, (output, value))| {
                let (unit, factor) = unit_of(output, &row.variable);
                let (by, of) = (row.variable.name, output.name.clone());
                let error = row.errors.get(index).and_then(|error| number(error / factor));
                let value = number(unit::stated(*value, factor));
                Influence { by, of, unit, value, estimated_error: error }
            })
        });
        Self {
            place: snapshot.place.label.clone(),
            at: Drivers::of(case, &time, &snapshot.place.independents),
            outside: snapshot.place.outside.clone(),
            results: results(case, Some(&snapshot.sample)),
            estimated_errors: { case.variables.iter().zip(&snapshot.errors) }
                .map(|(variable, error)| number(variable.in_unit(*error)))
                .collect(),
            transmission: angles.collect(),
            influence: coefficients.collect(),
        }
    }
}

impl Residual {
    /// What is left of a loop equation, SI units.
    pub fn of(case: &Case, index: usize, left: f64) -> Self {
        let of = &case.moved.entry.loops[index];
        Self { r#loop: of.name, value: number(unit::stated(left, of.factor)), unit: of.unit }
    }
}

impl Statistics {
    fn of(report: &Report) -> Self {
        let cost = &report.cost;
        Self {
            positions: cost.positions,
            reached: cost.reached,
            seconds: cost.closing,
            seconds_with_limits: cost.total,
            integral_error: (cost.doubt > 0.0).then_some(cost.doubt),
            largest_gap: cost.gap.map(|(index, gap)| Residual::of(&report.case, index, gap)),
        }
    }
}
