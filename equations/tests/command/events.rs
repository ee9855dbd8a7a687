//! The events of motions: as rows, in the object, and how exact the start is.

use serde_json::Value;

use super::{answer, check_refused, folder, run};

/// What a command prints, in a directory of its own.
fn printed(arguments: &[&str], more: &[&str]) -> String {
    let all = [arguments, more].concat();
    let name = format!("events-{}", all.join("-").replace(['/', '=', '[', ']'], "-"));
    answer(&all, &folder(&name))
}

fn object(arguments: &[&str]) -> Value {
    let text = printed(arguments, &["--format", "json"]);
    serde_json::from_str(&text).expect("one JSON object")
}

/// The rows of comma-separated values without quotes, the heading first.
fn rows(arguments: &[&str]) -> Vec<Vec<String>> {
    let text = printed(arguments, &["--format", "csv", "--rows", "events"]);
    let cells = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(cells).collect()
}

/// A cell and a value of the object, which is not read to the last digit.
#[track_caller]
fn check_same(cell: &str, value: &Value) {
    let cell: f64 = cell.parse().expect("a number");
    let value = value.as_f64().expect("a number");
    assert!((cell - value).abs() <= 1e-15 * value.abs(), "{cell} {value}");
}

/// The rows say what the object says.
#[track_caller]
fn check_rows(arguments: &[&str]) {
    let (object, rows) = (object(arguments), rows(arguments));
    let events = object["events"].as_array().expect("a list");
    assert!(!events.is_empty() && rows.len() == events.len() + 1);
    let states = events[0]["before"].as_array().expect("a list");
    let state = |index: usize, when: &str| match (&states[index]["name"], &states[index]["unit"]) {
        (Value::String(name), Value::String(unit)) => format!("{name} {when} [{unit}]"),
        _ => panic!("a state has a name and a unit"),
    };
    assert_eq!(rows[0][..4], ["time [s]", "event", "from", "to"]);
    assert_eq!(rows[0][4..6], [state(0, "before"), state(0, "after")]);
    assert_eq!(rows[0][rows[0].len() - 2..], ["guard", "guard unit"]);
    for (row, event) in rows[1..].iter().zip(events) {
        assert_eq!(row.len(), 4 + 2 * states.len() + 2, "{row:?}");
        for (cell, name) in row[1..4].iter().zip(["event", "from", "to"]) {
            assert_eq!(event[name], cell.as_str());
        }
        check_same(&row[0], &event["time"]);
        for (index, pair) in row[4..row.len() - 2].chunks(2).enumerate() {
            for (cell, when) in pair.iter().zip(["before", "after"]) {
                check_same(cell, &event[when][index]["value"]);
            }
        }
        check_same(&row[row.len() - 2], &event["guard"]["value"]);
        assert_eq!(event["guard"]["unit"], row[row.len() - 1].as_str());
    }
}

#[test]
fn events_of_a_run_are_rows() {
    check_rows(&["run", "table_drive", "--scene", "loose_switched"]);
}

#[test]
fn events_of_a_motion_that_repeats_are_rows() {
    check_rows(&["run", "presser_foot", "--set", "omega=400[1/s]"]);
}

#[test]
fn rows_of_events_need_events_and_csv() {
    let directory = folder("events_refused");
    let linkage = ["run", "heald_linkage", "--format", "csv", "--rows", "events"];
    check_refused(&linkage, &["states no events", "--rows events"], &directory);
    let table = ["run", "table_drive", "--rows", "events"];
    check_refused(&table, &["only --format csv has rows"], &directory);
}

#[test]
fn the_mode_at_the_beginning_is_named_without_any_event() {
    let blocked = object(&["run", "table_drive", "--scene", "blocked"]);
    assert_eq!(blocked["events"].as_array().map(Vec::len), Some(0));
    assert_eq!(blocked["first_mode"], "wind");
    // A measure that is missing is a value that is missing.
    assert_eq!(blocked["status"], "incomplete");
    let loose = object(&["run", "table_drive", "--scene", "loose"]);
    assert_eq!(loose["first_mode"], "gap");
    assert_eq!(loose["status"], "complete");
}

#[test]
fn the_start_of_a_run_is_known_to_rounding() {
    let run = object(&["run", "table_drive", "--at", "time=0s", "--at", "time=50ms"]);
    let results = |list: &Value| list.as_array().expect("a list").clone();
    let starts = [&run["results"], &run["at"][0]["results"]].map(results);
    for result in starts.concat() {
        let [value, error] = ["value", "estimated_error"].map(|name| result[name].as_f64());
        let limit = 1e-15 * value.expect("a number").abs();
        assert!(error.expect("a number") <= limit, "{result}");
    }
    let mut later = results(&run["at"][1]["results"]).into_iter();
    assert!(later.any(|result| result["estimated_error"].as_f64() > Some(1e-15)));
}

#[test]
fn a_decay_rate_may_be_zero_where_its_range_begins_there() {
    let free = ["run", "table_drive", "--scene", "switched"];
    let run = object(&[&free[..], &["--set", "lambda1=0[1/s]"]].concat());
    let mut parameters = run["parameters"].as_array().expect("a list").iter();
    let rate = parameters.find(|one| one["name"] == "lambda1");
    assert_eq!(rate.expect("a rate")["value"], 0.0);
    let bare = object(&[&free[..], &["--set", "lambda1=0"]].concat());
    assert_eq!(bare["parameters"], run["parameters"], "zero needs no unit");
    let below = [&free[..], &["--set", "lambda1=-1[1/s]"]].concat();
    check_refused(&below, &["the file permits from 0 1/s"], &folder("rate"));
}

#[test]
fn hints_do_not_change_the_value() {
    let directory = folder("hints");
    for (value, hint) in [
        ("1e3", "write it as 'c=1e3 [N m/rad]'"),
        ("1e300", "write it as 'c=1e300 [N m/rad]'"),
        ("0x10", "a number looks like"),
        ("1,5[N m/rad]", "a number looks like"),
        ("2*355[N m/rad]", "a number looks like"),
    ] {
        let set = format!("c={value}");
        check_refused(&["run", "table_drive", "--set", &set], &[hint], &directory);
    }
}

#[test]
fn a_figure_names_every_mode_once_beside_its_colour() {
    let directory = folder("events_figure");
    let run = ["run", "table_drive", "--scene", "loose_switched", "--curves", "twist"];
    answer(&[&run[..], &["--plot", "bands.svg"]].concat(), &directory);
    let figure = std::fs::read_to_string(directory.join("bands.svg")).expect("a figure");
    // The first two last too short for a name in the strip and stand in the legend alone.
    for (name, count) in [("gap", 1), ("wind", 1), ("run", 2)] {
        assert_eq!(figure.matches(&format!(">{name}<")).count(), count, "{name}");
    }
    let pixels = [&run[..], &["--plot", "bands.png"]].concat();
    check_refused(&pixels, &[".svg only", "bands.svg"], &directory);
}

#[test]
fn multipliers_over_two_periods_count_by_two_periods() {
    let twice = ["run", "presser_foot", "--set", "omega=400[1/s]"];
    let table = answer(&twice, &folder("turns"));
    for words in [
        "what one turn of 2 periods does to a disturbance",
        "Over the turn of 2 periods",
        "every second turn of 2 periods",
    ] {
        assert!(table.contains(words), "no {words:?} in\n{table}");
    }
    let once = answer(&["run", "presser_foot"], &folder("turns_once"));
    assert!(once.contains("what one period does") && !once.contains("turn of"));
}

#[test]
fn a_carried_loop_that_stays_open_is_named_with_its_gap() {
    // E_v and D come as near as 72.528 mm to each other, and the link between them is the only one that changes.
    for (length, gap) in [("60mm", "a gap of up to 12.53 mm"), ("70mm", "2.528 mm")] {
        let value = format!("machine.lift.l_v={length}");
        let arguments = ["run", "presser_foot", "--scene", "machine", "--set", &value];
        let output = run(&arguments, &folder("open_loop"));
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{complaint}");
        let words = ["the links do not meet", gap, "machine.lift.lift.x"];
        for word in words {
            assert!(complaint.contains(word), "no {word:?} in\n{complaint}");
        }
    }
}
