//! The answer of `assur run --format json` about a linkage: one object, with the fields of [`crate::json`] as far as they
//! make sense, and these.
//!
//! | field | contents |
//! |---|---|
//! | `drivers` | each `name`, `unit`, `from`, `to`, `start` |
//! | `task` | `kind` (`sweep`, `periodic`, `run` or `open`); of a sweep `over`, the names of its drivers, else `from`, `to`, `unit` of the time |
//! | `status` | `"complete"`; `"stopped"` when positions of the task are not reached (`stopped` says why, the exit code is 1); or `"incomplete"` when a value below is null because it is not a finite number |
//! | `stopped` | each `place`, `reason` |
//! | `note` | that the linkage is put together far from the start values of its file, in words; or null |
//! | `results` | each `name`, `unit`, and `minimum` and `maximum` over the task, each with `value` and `at` (`drivers`; `time` if it runs; `unbounded` beside a null `value` at a pole), `stroke`, `limit_positions` where it turns round inside a task with one axis (each `kind`, `value`, `at`; null over a grid), and `breaks` (each `kind`: `jump`, `pole` or `end` of what has a value, `before`, `after`, `at`; `"inf"` or `"-inf"` beyond all bounds) |
//! | `positions` | at round positions, each `drivers` (`name`, `unit`, `value`), `time` if it runs, `results` (`name`, `unit`, `value`; null where the linkage does not get) |
//! | `transmission` | for each group that has one `loops`, `unknowns`, `kind`, `smallest_angle`, `unit`, `at` |
//! | `reach` | how far each driver goes in this assembly mode: `driver`, `unit`, `turns` (all round), `low` and `high` (`at`, `dead_point`: the loops, or null), or `reason` |
//! | `events` | each `place`, `event` in words |
//! | `at` | for each `--at`: `place` in words, `time`, `drivers`, `outside` (drivers outside of their ranges, in words), `results`, `transmission` (`loops`, `angle`, `unit`), `influence` (each `by`, `of`, `unit`, `value`) |
//! | `statistics` | `positions`, `reached`, `seconds`, `seconds_with_limits`, `largest_gap` (`loop`, `value`, `unit`) |

use std::path::Path;

use assur::closure::End;
use assur::problem::Span;
use assur::registry::Sample;
use serde_json::{Map, Value, json};

use super::case::{Case, Task};
use super::group;
use super::influence::unit_of;
use super::reach;
use super::report::{Report, Snapshot};
use super::search::Extreme;
use crate::json::{FORMAT, compared, mechanism, parameters, scene};
use crate::unit;
use crate::variables::Variable;

/// The object, with its last line ended.
pub fn render(report: &Report, figure: Option<&Path>) -> String {
    let case = &report.case;
    let positions = positions(report);
    let places: Vec<_> = report.places.iter().map(|place| snapshot(case, place)).collect();
    let lacks = |one: &Value| {
        let results = one["results"].as_array();
        results.is_some_and(|list| list.iter().any(|result| result["value"].is_null()))
    };
    let status = match (report.is_complete(), positions.iter().chain(&places).any(lacks)) {
        (false, _) => "stopped",
        (true, true) => "incomplete",
        (true, false) => "complete",
    };
    let stopped = report.stops.iter();
    let stopped = stopped.map(|stop| json!({ "place": stop.place, "reason": stop.reason }));
    let events = report.met.iter();
    let events = events.map(|(place, event)| json!({ "place": place, "event": event }));
    let object = json!({
        "format": FORMAT,
        "mechanism": mechanism(report.mechanism),
        "scene": scene(&case.constants),
        "parameters": parameters(&case.constants),
        "drivers": drivers(case),
        "task": task(case),
        "status": status,
        "stopped": stopped.collect::<Vec<_>>(),
        "note": report.note,
        "results": limits(report),
        "positions": positions,
        "transmission": transmissions(report),
        "reach": reaches(report),
        "events": events.collect::<Vec<_>>(),
        "at": places,
        "published": report.published.iter().map(compared).collect::<Vec<_>>(),
        "statistics": statistics(report),
        "figure": figure.map(|path| path.display().to_string()),
    });
    // A `Value` has only text keys and finite numbers, so printing it cannot fail.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

fn drivers(case: &Case) -> Value {
    let drivers = case.drivers.iter().zip(&case.ranges);
    let one = drivers.map(|(driver, range)| {
        json!({
            "name": driver.name,
            "unit": driver.unit,
            "from": unit::stated(range.from, driver.factor),
            "to": unit::stated(range.to, driver.factor),
            "start": unit::stated(range.start, driver.factor),
        })
    });
    one.collect()
}

fn task(case: &Case) -> Value {
    match &case.task {
        Task::Sweep(drivers) => {
            let names = drivers.iter().map(|&index| case.drivers[index].name);
            json!({ "kind": "sweep", "over": names.collect::<Vec<_>>() })
        }
        Task::Time(span) => {
            let (from, to) = span.limits();
            let kind = if matches!(span, Span::Periodic(_)) { "periodic" } else { "run" };
            json!({ "kind": kind, "from": from, "to": to, "unit": "s" })
        }
        Task::Open => json!({ "kind": "open" }),
    }
}

fn positions(report: &Report) -> Vec<Value> {
    let case = &report.case;
    let stations = report.rows.iter().flat_map(|line| line.stations.iter().zip(&line.samples));
    let one = stations.map(|(station, sample)| {
        let mut object = place(case, station, &case.place(station));
        object.insert("results".to_owned(), results(case, sample.as_ref()));
        Value::Object(object)
    });
    one.collect()
}

/// Positions of the drivers, and the time if it runs.
fn place(case: &Case, station: &[f64], independents: &[f64]) -> Map<String, Value> {
    let drivers = case.drivers.iter().zip(independents).map(|(driver, position)| {
        json!({ "name": driver.name, "unit": driver.unit, "value": unit::stated(*position, driver.factor) })
    });
    let mut object = Map::new();
    object.insert("drivers".to_owned(), drivers.collect());
    if let Task::Time(_) = case.task {
        object.insert("time".to_owned(), json!(station.first()));
    }
    object
}

fn results(case: &Case, sample: Option<&Sample>) -> Value {
    let values = sample.map(|sample| case.values(sample));
    let variables = case.variables.iter().enumerate().map(|(index, variable)| {
        json!({
            "name": variable.name,
            "unit": variable.unit,
            "value": values.as_ref().map(|values| variable.in_unit(values[index])),
        })
    });
    variables.collect()
}

fn at(case: &Case, extreme: &Extreme) -> Value {
    Value::Object(place(case, &extreme.station, &extreme.independents))
}

fn limits(report: &Report) -> Value {
    let case = &report.case;
    let variables = case.variables.iter().zip(&report.limits);
    let one = variables.map(|(variable, limits)| {
        let end = |extreme: Option<&Extreme>| match extreme {
            Some(one) => json!({
                "value": variable.in_unit(one.value),
                "unbounded": one.value.is_infinite(),
                "at": at(case, one),
            }),
            None => Value::Null,
        };
        json!({
            "name": variable.name,
            "unit": variable.unit,
            "minimum": end(limits.as_ref().map(|limits| &limits.0)),
            "maximum": end(limits.as_ref().map(|limits| &limits.1)),
            "stroke": limits.as_ref().map(|(low, high)| variable.in_unit(high.value - low.value)),
            "limit_positions": turns(report, variable),
            "breaks": breaks(report, variable),
        })
    });
    one.collect()
}

/// Where a variable turns round, null unless the task has one axis.
fn turns(report: &Report, variable: &Variable) -> Value {
    let case = &report.case;
    let Some(stroke) = reach::stroke(case, report.strokes.as_ref(), variable) else {
        return Value::Null;
    };
    let turns = reach::turns(case, stroke).into_iter().map(|turn| {
        json!({
            "kind": turn.kind(),
            "value": variable.in_unit(turn.place.value),
            "at": at(case, &turn.place),
        })
    });
    turns.collect()
}

/// Where a variable jumps, goes beyond all bounds or has no value, null unless the task has one axis.
fn breaks(report: &Report, variable: &Variable) -> Value {
    let case = &report.case;
    let Some(stroke) = reach::stroke(case, report.strokes.as_ref(), variable) else {
        return Value::Null;
    };
    let side = |value: f64| match value {
        f64::INFINITY => json!("inf"),
        f64::NEG_INFINITY => json!("-inf"),
        value => json!(variable.in_unit(value)),
    };
    let gaps = reach::gaps(case, stroke).into_iter().map(|gap| {
        json!({
            "kind": gap.kind(),
            "before": side(gap.place.value),
            "after": side(gap.after),
            "at": at(case, &gap.place),
        })
    });
    gaps.collect()
}

fn reaches(report: &Report) -> Value {
    let case = &report.case;
    let one = report.reach.iter().map(|reach| {
        let driver = &case.drivers[reach.driver];
        let end = |end: &End| {
            let dead = end.dead.and_then(|index| case.entry.groups.get(index));
            json!({
                "at": unit::stated(end.at, driver.factor),
                "dead_point": dead.map(|of_group| group::equations(case.entry, of_group)),
            })
        };
        let mut object =
            json!({ "driver": driver.name, "unit": driver.unit, "turns": reach.turns });
        match &reach.stretch {
            Ok(found) => {
                object["low"] = end(&found.low);
                object["high"] = end(&found.high);
            }
            Err(told) => object["reason"] = json!(told.reason),
        }
        object
    });
    one.collect()
}

fn transmissions(report: &Report) -> Value {
    let entry = report.case.entry;
    let one = report.transmissions.iter().map(|(index, worst)| {
        let of_group = &entry.groups[*index];
        json!({
            "loops": group::equations(entry, of_group),
            "unknowns": group::unknowns(entry, of_group),
            "kind": group::kind(of_group.kind),
            "smallest_angle": group::transmission(worst.value),
            "unit": "deg",
            "at": at(&report.case, worst),
        })
    });
    one.collect()
}

fn snapshot(case: &Case, snapshot: &Snapshot) -> Value {
    let time: Vec<_> = snapshot.place.time.into_iter().collect();
    let mut object = Map::new();
    object.insert("place".to_owned(), json!(snapshot.place.label));
    object.extend(place(case, &time, &snapshot.place.independents));
    object.insert("outside".to_owned(), json!(snapshot.place.outside));
    object.insert("results".to_owned(), results(case, Some(&snapshot.sample)));
    let groups = case.entry.groups.iter().zip(&snapshot.sample.sines);
    let groups = groups.filter(|(of_group, _)| group::transmits(of_group));
    let angles = groups.map(|(of_group, sine)| {
        json!({
            "loops": group::equations(case.entry, of_group),
            "angle": group::transmission(*sine),
            "unit": "deg",
        })
    });
    object.insert("transmission".to_owned(), angles.collect());
    let coefficients = snapshot.influence.iter().flat_map(|row| {
        let outputs = case.variables.iter().zip(&row.values);
        outputs.map(|(output, value)| {
            let (unit, factor) = unit_of(output, &row.variable);
            json!({
                "by": row.variable.name,
                "of": output.name,
                "unit": unit,
                "value": unit::stated(*value, factor),
            })
        })
    });
    object.insert("influence".to_owned(), coefficients.collect());
    Value::Object(object)
}

fn statistics(report: &Report) -> Value {
    let cost = &report.cost;
    let gap = cost.gap.map(|(index, gap)| {
        let of = &report.case.entry.loops[index];
        json!({ "loop": of.name, "value": unit::stated(gap, of.factor), "unit": of.unit })
    });
    json!({
        "positions": cost.positions,
        "reached": cost.reached,
        "seconds": cost.closing,
        "seconds_with_limits": cost.total,
        "largest_gap": gap,
    })
}
