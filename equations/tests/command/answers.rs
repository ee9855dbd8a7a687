//! What the command answers to right requests.

use std::path::Path;

use serde_json::Value;

use super::{answer, entries, folder, json};
/// The result of this name.
#[track_caller]
fn result<'a>(list: &'a Value, name: &str) -> &'a Value {
    let list = list.as_array().expect("a list");
    let found = list.iter().find(|result| result["name"] == name);
    found.expect("a result of this name")
}

#[test]
fn everything_is_listed() {
    let text = answer(&["list"], &folder("list"));
    for word in ["batten\n", "batten_table\n", "elastic", "first_order", "assur run batten"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn the_default_run_prints_tables_and_draws_its_figure() {
    let directory = folder("default");
    let text = answer(&["run", "batten"], &directory);
    for word in [
        "Batten, scene elastic",
        "rpm",
        "Published values",
        "deviation",
        "Floquet multipliers",
        "never forgets its start",
        "Estimated global error",
        "ten times more accuracy",
        "batten-elastic.svg",
        "3.80e-6",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(!text.contains("OUTSIDE"), "{text}");
    assert_eq!(entries(&directory), [directory.join("batten-elastic.svg")]);
    let figure = std::fs::read_to_string(directory.join("batten-elastic.svg")).expect("a figure");
    for word in ["<svg", "rear dead centre", "front dead centre", "locks", "φ₂", "rad/s²"] {
        assert!(figure.contains(word), "{word}");
    }
}

/// A motion with modes says when it goes from one to another.
#[test]
fn events_are_listed() {
    let directory = folder("events");
    let object = json(&["run", "table_drive", "--at", "time=1ms"], &directory);
    assert_eq!(object["modes"][0]["name"], "wind");
    let [event] = object["events"].as_array().expect("events").as_slice() else {
        panic!("{}", object["events"]);
    };
    assert_eq!(event["from"], "wind");
    assert_eq!(event["to"], "run");
    let guard = event["guard"]["value"].as_f64().expect("a number");
    assert!(guard.abs() < 1e-12, "{guard}");
    let before = result(&event["before"], "twist");
    assert_eq!(before["value"], result(&event["after"], "twist")["value"]);
    assert_eq!(object["at"][0]["mode"], "run");
}

#[test]
fn json_has_its_documented_fields() {
    let directory = folder("json");
    let object = json(&["run", "batten", "--at", "theta=1.9198", "--at", "time=10ms"], &directory);
    let names: Vec<_> = object.as_object().expect("an object").keys().collect();
    let documented = [
        "format",
        "mechanism",
        "scene",
        "parameters",
        "task",
        "settings",
        "status",
        "results",
        "at",
        "modes",
        "first_mode",
        "events",
        "change_points",
        "measures",
        "multipliers",
        "vibrations",
        "conclusions",
        "statistics",
        "published",
        "figure",
    ];
    assert_eq!(names, documented);
    assert_eq!(object["format"], "assur-run/1");
    assert_eq!(object["mechanism"]["name"], "batten");
    assert_eq!(object["scene"]["choices"]["crank"], "two_term");
    assert_eq!(object["status"], "complete");
    assert_eq!(object["task"]["kind"], "periodic");
    assert_eq!(object["figure"], Value::Null);
    assert_eq!(result(&object["parameters"], "n")["value"], 250.0);
    assert!(object["statistics"]["evaluations"].as_u64() > Some(0));
    assert_eq!(object["multipliers"].as_array().map(Vec::len), Some(6));
    for result in object["results"].as_array().expect("results") {
        assert!(result["value"].is_number() && result["unit"].is_string(), "{result}");
        assert!(result["estimated_error"].is_number(), "{result}");
        assert!(result["maximum"]["value"].is_number(), "{result}");
    }
    let [place, later] = object["at"].as_array().expect("places").as_slice() else {
        panic!("two places");
    };
    let lag = result(&place["results"], "phi2")["value"].as_f64().expect("a number");
    assert!((lag + 0.000758).abs() < 1e-5, "{lag}");
    assert!(result(&place["results"], "F1")["unit"] == "N");
    assert_eq!(later["time"], 0.01);
    for published in object["published"].as_array().expect("facts") {
        assert_eq!(published["within"], true, "{published}");
        assert!(published["deviation"].is_number());
    }
    assert!(entries(&directory).is_empty(), "JSON draws no figure unasked");
}

#[test]
fn values_are_changed_with_their_units() {
    let directory = folder("set");
    let object = json(&["run", "batten", "--set", "n=300rpm", "--set", "R=7cm"], &directory);
    assert_eq!(result(&object["parameters"], "n")["value"], 300.0);
    assert_eq!(result(&object["parameters"], "n")["changed"], true);
    let crank = result(&object["parameters"], "R")["value"].as_f64();
    assert!((crank.expect("a number") - 70.0).abs() < 1e-12);
    let period = object["task"]["to"].as_f64().expect("a number");
    assert!((period - 0.2).abs() < 1e-12, "{period}");
    for published in object["published"].as_array().expect("facts") {
        assert_eq!(published["within"], Value::Null, "published for other values");
    }
}

#[test]
fn every_scene_comes_out() {
    let directory = folder("every");
    for (name, scenes) in [
        ("batten", &["rigid", "torsion", "bending", "uncoupled", "exact", "damped", "start"][..]),
        ("batten_table", &["table", "identity", "own"]),
    ] {
        for scene in scenes {
            let object = json(&["run", name, "--scene", scene, "--method", "tsit5"], &directory);
            assert_eq!(object["status"], "complete", "{name} {scene}");
            assert_eq!(object["settings"]["method"], "tsit5");
        }
    }
}

#[test]
fn csv_is_a_rectangle_of_numbers() {
    let text = answer(&["run", "batten", "--format", "csv"], &folder("csv"));
    let mut lines = text.lines();
    let heading: Vec<_> = lines.next().unwrap_or("").split(',').collect();
    assert_eq!(heading[..3], ["time [s]", "theta [rad]", "phi2 [rad]"]);
    assert!(heading.contains(&"drive_torque [N m]"));
    assert!(lines.clone().count() > 700);
    for line in lines {
        let cells: Vec<_> = line.split(',').map(str::parse::<f64>).collect();
        assert_eq!(cells.len(), heading.len());
        assert!(cells.iter().all(Result::is_ok), "{line}");
    }
}

#[test]
fn figures_go_where_they_are_asked_for() {
    let directory = folder("figures");
    answer(&["run", "batten", "--out", "new/folder"], &directory);
    assert!(directory.join("new/folder/batten-elastic.svg").is_file());
    let plot = ["run", "batten", "--curves", "F1,dot(x3)", "--plot", "chosen.svg"];
    answer(&plot, &directory);
    let chosen = std::fs::read_to_string(directory.join("chosen.svg")).expect("a figure");
    assert!(chosen.contains("F₁") && chosen.contains("Velocity") && !chosen.contains("φ"));
    answer(&["run", "batten", "--curves", "all", "--plot", "all.svg"], &directory);
    let all = std::fs::read_to_string(directory.join("all.svg")).expect("a figure");
    assert!(all.contains("Torque") && all.contains("Acceleration"));
    let parts = |path: &Path| path.to_string_lossy().contains(".part");
    assert!(!entries(&directory).iter().any(|path| parts(path)));
}

#[test]
fn scenes_are_compared() {
    let text = answer(&["scenes", "batten", "--set", "beta_t=2ms"], &folder("scenes"));
    for word in [
        "states",
        "equations",
        "operations",
        "evaluation",
        "cycle",
        "elastic",
        "whole run",
        "What the effect torsion changes",
        "What the effect damping changes",
        "What the choice crank changes",
        "phi2",
        "%",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let table = answer(&["scenes", "batten_table"], &folder("scenes_table"));
    assert!(table.contains("What the preset changes"), "{table}");
}

/// Samples even in time miss it: it lasts 50 µs.
#[test]
fn extremes_are_those_of_the_solution_and_not_of_samples() {
    let arguments = [
        "run",
        "presser_foot",
        "--scene",
        "yielding_straight",
        "--set",
        "c1=2904.6045207394354 [N/m]",
        "--rtol",
        "1e-12",
    ];
    let object = json(&arguments, &folder("extremes"));
    let lowest = &result(&object["results"], "ddot(w)")["minimum"];
    let number = |name: &str| lowest[name].as_f64().expect("a number");
    assert!((number("value") + 209.795_197).abs() < 1e-6, "{lowest}");
    assert!((number("time") - 0.013_990_933).abs() < 1e-9, "{lowest}");
    assert!(number("estimated_error") < 1e-6, "{lowest}");
    assert!(number("estimated_error_of_time") < 1e-9, "{lowest}");
}

/// The first steps grow as fast whatever the tolerance: two solutions with the same steps have the same error.
#[test]
fn solutions_that_agree_by_luck_do_not_make_an_error_small() {
    let start_of_table = |rtol: &str| {
        let arguments = [
            "run",
            "table_drive",
            "--scene",
            "table_2",
            "--set",
            "Ms=20.87415649141017 [N m]",
            "--rtol",
            rtol,
        ];
        let object = json(&arguments, &folder("luck"));
        let measure = result(&object["measures"], "start_of_table");
        let number = |name: &str| measure[name].as_f64().expect("a number");
        (number("value"), number("estimated_error"))
    };
    let (rough, fine) = (start_of_table("1e-6"), start_of_table("1e-12"));
    let wrong = (rough.0 - fine.0).abs();
    assert!(wrong <= rough.1 && rough.1 < 1e3 * wrong, "{wrong:e} {rough:?}");
}

/// Beside a change point what is left of 0/0 is noise. A tenth of this tolerance takes too long, and with ten times as much what is
/// 1e-3 off comes to within 3e-6 of the same: that alone told 6e-6.
#[test]
fn one_solution_that_agrees_is_not_enough() {
    let g = "g=8.950922943417709 [m/s^2]";
    let values = ["--set", "m=0.9826931579984657 kg", "--set", g];
    let motion = ["run", "four_bar_chain", "--scene", "two", "--method", "dop853"];
    let arguments = [&motion[..], &["--rtol", "1e-12"], &values].concat();
    let object = json(&arguments, &folder("one_solution"));
    let lowest = &result(&object["results"], "ddot(th[2])")["minimum"];
    let number = |name: &str| lowest[name].as_f64().expect("a number");
    // All links lie flat there and move side by side.
    let wrong = (number("value") + (3.5 / 3.0 * 8.950_922_943_417_709f64).to_degrees()).abs();
    assert!(wrong < 10.0 * number("estimated_error"), "{wrong:e} {lowest}");
}

/// Values are SI inside and printed in the unit of their file: what was declared or is round as it was written.
#[test]
fn declared_and_round_values_are_printed_as_they_are_written() {
    let directory = folder("declared");
    let set = ["run", "heald_linkage", "--set", "l4=90.3mm"];
    let object = json(&set, &directory);
    assert_eq!(result(&object["parameters"], "l4")["value"], 90.3);
    let driver = result(&object["drivers"], "phi4");
    assert_eq!((&driver["from"], &driver["to"]), (&60.0.into(), &120.0.into()));
    let facts = object["published"].as_array().expect("a list");
    let fact = facts.iter().find(|fact| fact["published"] == -58.60509);
    assert!(fact.is_some(), "{facts:?}");
    let text = answer(&["run", "heald_linkage", "--format", "csv"], &directory);
    let places: Vec<&str> = text.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert!(places.contains(&"60.2") && places.contains(&"119.9"), "{places:?}");
    assert!(places.iter().all(|place| place.len() <= 5), "{places:?}");
}
