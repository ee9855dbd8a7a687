//! What the command says about linkages.

use std::path::Path;

use serde_json::Value;

use super::{answer, check_refused, entries, folder, json, run};

const NAME: &str = "heald_linkage";
#[track_caller]
fn named<'a>(list: &'a Value, name: &str) -> &'a Value {
    let mut list = list.as_array().expect("a list").iter();
    list.find(|one| one["name"] == name).expect("one of this name")
}

#[track_caller]
fn check_near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() <= tolerance, "{value} {expected}");
}

/// Runs a linkage that does not come out, which is exit code 1.
#[track_caller]
fn check_numerical(arguments: &[&str], words: &[&str], directory: &Path) {
    let output = run(arguments, directory);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {complaint}");
    for word in words {
        assert!(complaint.contains(word), "no {word:?} in\n{complaint}");
    }
    assert!(!complaint.contains("group"), "a name is missing: {complaint}");
}

#[test]
fn a_run_prints_positions_limits_and_facts() {
    let directory = folder("linkage_run");
    let text = answer(&["run", NAME], &directory);
    for word in [
        "HealdLinkage, scene printed: positions over phi4",
        "60 deg",
        "120 deg",
        "phi4, deg",
        "-70.06145",
        "-81.96186",
        "Limits",
        "Transmission angle",
        "loop.x, loop.y, guide",
        "diff(phi7, l5)",
        "rad/mm",
        "Complete: 601 positions",
        "heald_linkage-printed.svg",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(!text.contains("OUTSIDE"), "{text}");
    assert_eq!(text.matches("within").count(), 15, "{text}");
    let figure = directory.join("heald_linkage-printed.svg");
    let figure = std::fs::read_to_string(figure).expect("a figure");
    for word in ["<svg", "φ₇", "φ₄", "Angle, °"] {
        assert!(figure.contains(word), "{word}");
    }
}

#[test]
fn json_has_its_documented_fields() {
    let directory = folder("linkage_json");
    let at = ["run", NAME, "--at", "phi4=90deg", "--at", "phi4=200deg"];
    let object = json(&at, &directory);
    let names: Vec<_> = object.as_object().expect("an object").keys().collect();
    let documented = [
        "format",
        "mechanism",
        "scene",
        "parameters",
        "drivers",
        "task",
        "status",
        "stopped",
        "note",
        "results",
        "measures",
        "positions",
        "transmission",
        "reach",
        "events",
        "at",
        "statistics",
        "published",
        "figure",
    ];
    assert_eq!(names, documented);
    assert_eq!(object["status"], "complete");
    assert_eq!(object["task"]["over"][0], "phi4");
    check_near(&named(&object["drivers"], "phi4")["start"], 90.0, 1e-12);
    let jack = named(&object["results"], "phi7");
    check_near(&jack["minimum"]["value"], -81.96186, 5e-6);
    check_near(&jack["minimum"]["at"]["drivers"][0]["value"], 120.0, 1e-9);
    // The rod is lowest where its angle does not change, at 86 degrees.
    let rod = named(&object["results"], "phi5");
    check_near(&rod["minimum"]["at"]["drivers"][0]["value"], 86.1764, 1e-3);
    let [inside, outside] = object["at"].as_array().expect("places").as_slice() else {
        panic!("two places");
    };
    check_near(&named(&inside["results"], "phi7")["value"], -70.06145, 5e-6);
    let influence = inside["influence"].as_array().expect("a list");
    let rod = influence.iter().find(|one| one["by"] == "l5" && one["of"] == "phi7");
    check_near(&rod.expect("one")["value"], 0.00454753, 5e-9);
    assert_eq!(inside["outside"].as_array().map(Vec::len), Some(0));
    let said = outside["outside"][0].as_str().expect("words");
    assert!(said.contains("60 deg to 120 deg"), "{said}");
    for published in object["published"].as_array().expect("facts") {
        assert_eq!(published["within"], true, "{published}");
    }
    assert!(entries(&directory).is_empty(), "JSON draws no figure unasked");
}

#[test]
fn csv_has_a_row_for_each_position() {
    let text = answer(&["run", NAME, "--format", "csv"], &folder("linkage_csv"));
    let mut lines = text.lines();
    let heading: Vec<_> = lines.next().unwrap_or("").split(',').collect();
    assert_eq!(heading[..2], ["phi4 [deg]", "phi5 [deg]"]);
    assert_eq!(lines.clone().count(), 601);
    for line in lines {
        let cells: Vec<_> = line.split(',').map(str::parse::<f64>).collect();
        assert!(cells.iter().all(Result::is_ok), "{line}");
    }
}

#[test]
fn dimensions_are_changed_and_facts_then_not_compared() {
    let directory = folder("linkage_set");
    let object = json(&["run", NAME, "--set", "l4=91mm"], &directory);
    assert_eq!(named(&object["parameters"], "l4")["changed"], true);
    for published in object["published"].as_array().expect("facts") {
        assert_eq!(published["within"], Value::Null);
    }
}

#[test]
fn what_cannot_be_closed_says_by_how_much() {
    let directory = folder("linkage_impossible");
    check_numerical(
        &["run", NAME, "--set", "l5=20mm"],
        &["cannot be put together", "phi4 = 90 deg", "63.58 mm", "loop.x, loop.y, guide", "--set"],
        &directory,
    );
    assert!(entries(&directory).is_empty(), "a figure of nothing");
    check_numerical(
        &["run", NAME, "--at", "phi4=230deg"],
        &["does not get to phi4 = 230 deg", "--at phi4=230deg", "dead point", "220.223 deg"],
        &directory,
    );
    assert!(entries(&directory).is_empty(), "a figure of nothing");
}

#[test]
fn wrong_requests_are_refused() {
    let directory = folder("linkage_refused");
    let cases: &[(&str, &str, &[&str])] = &[
        ("--at", "phi5=10deg", &["not `phi5`", "did you mean `phi4`?"]),
        ("--at", "l4=10mm", &["not `l4`", "--set l4"]),
        ("--at", "time=1s", &["not `time`", "phi4=90deg"]),
        ("--at", "phi4=1kg", &["wrong unit"]),
        ("--at", "phi4=NaN", &["finite"]),
        ("--at", "phi4=infdeg", &["finite"]),
        ("--at", "phi4", &["NAME=VALUE", "--at phi4=90deg"]),
        ("--at", "phi4=", &["NAME=VALUE"]),
        ("--at", "", &["NAME=VALUE"]),
        ("--at", "90deg=phi4", &["not `90deg`"]),
        ("--at", "phi4=70deg,phi4=80deg", &["given twice", "repeat --at"]),
        ("--set", "l4=0mm", &["`l4` cannot be 0 mm"]),
        ("--set", "phi4=70deg", &["is driven", "--at phi4"]),
        ("--curves", "phi8", &["did you mean `phi"]),
        ("--rtol", "1e-9", &["takes no --rtol", "rounding"]),
        ("--method", "tsit5", &["takes no --method"]),
        ("--scene", "strait", &["did you mean `straight`?"]),
    ];
    for (option, value, words) in cases {
        check_refused(&["run", NAME, option, value], words, &directory);
    }
    check_refused(&["structure", "batten"], &["is no linkage", NAME], &directory);
    check_refused(&["structure"], &["needs a linkage"], &directory);
    check_refused(&["draw", "batten"], &["has no points", "link A - B"], &directory);
    check_refused(&["draw"], &["needs a mechanism", NAME], &directory);
    check_refused(
        &["draw", "simple_pendulum", "--forces"],
        &["no forces to draw", "reaction(pin)"],
        &directory,
    );
    check_refused(
        &["run", "lamp_arm", "--scene", "still", "--rtol", "1e-9"],
        &["a position of rest takes no --rtol"],
        &directory,
    );
    for command in ["structure", "draw"] {
        check_refused(&[command, "heald"], &["no mechanism"], &directory);
    }
    check_refused(&["draw", NAME, "--at", "phi4=1kg"], &["wrong unit"], &directory);
}

#[test]
fn the_structure_is_told_in_words_and_as_data() {
    let directory = folder("linkage_structure");
    let text = answer(&["structure", NAME], &directory);
    for word in [
        "1 degree of freedom = 3 unknowns + 1 driver - 3 loop equations",
        "r6*cos(phi6) = s + play_s + r7*cos(phi7)",
        "iteration",
        "transmission angle",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let object = json(&["structure", NAME, "--scene", "straight"], &directory);
    assert_eq!(object["format"], "assur-structure/1");
    assert_eq!(object["degrees_of_freedom"], 1);
    assert_eq!(named(&object["loops"], "guide")["unit"], "m");
    check_near(&named(&object["unknowns"], "phi5")["start"], 50.91779, 5e-6);
    assert!(object["groups"][0]["transmission_angle"].is_number());
}

#[test]
fn drawings_show_all_points_and_move() {
    let directory = folder("linkage_draw");
    let text = answer(&["draw", NAME, "--scene", "straight", "--out", "new"], &directory);
    assert!(text.contains("heald_linkage-straight-moving.svg"), "{text}");
    let read = |name: &str| std::fs::read_to_string(directory.join("new").join(name)).expect(name);
    let still = read("heald_linkage-straight-positions.svg");
    for word in ["<svg", ">D<", ">E<", ">F<", ">J<", ">L<", "knife arm", "mm", "class=\"slide\""] {
        assert!(still.contains(word), "{word}");
    }
    assert_eq!(still.matches("class=\"ground\"").count(), 2, "D and L stand");
    let moving = read("heald_linkage-straight-moving.svg");
    let lengths: Vec<_> = moving
        .split("values=\"")
        .skip(1)
        .map(|values| values.split('"').next().unwrap_or("").split(';').count())
        .collect();
    assert!(lengths.len() > 8 && lengths.iter().all(|one| *one == lengths[0]), "{lengths:?}");
    let chosen = ["draw", NAME, "--at", "phi4=70deg", "--at", "phi4=200deg", "--out", "new"];
    assert!(answer(&chosen, &directory).contains("70, 200°"));
}

#[test]
fn scenes_and_files_are_summed_up() {
    let directory = folder("linkage_scenes");
    let text = answer(&["scenes", NAME], &directory);
    for word in
        ["loops", "unknowns", "position", "coupled", "positions over phi4", "guide.straight"]
    {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(answer(&["list"], &directory).contains("moved by phi4"));
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/src/heald_linkage.eqn");
    let text = answer(&["check", file], &directory);
    assert!(text.contains("unknowns"), "{text}");
    let text = answer(&["expand", NAME, "--scene", "straight"], &directory);
    syn::parse_file(&text).expect("Rust");
}

/// Positions of the first driver where an output turns round.
fn turns(object: &Value, name: &str) -> Vec<f64> {
    let turns = named(&object["results"], name)["limit_positions"].as_array();
    let at = |turn: &Value| turn["at"]["drivers"][0]["value"].as_f64();
    turns.expect("a list").iter().filter_map(at).collect()
}

#[test]
fn a_timed_run_knows_limit_positions_as_a_sweep_does() {
    let directory = folder("linkage_timed_limits");
    let run = |scene| json(&["run", "selvedge_linkage", "--scene", scene], &directory);
    let (timed, swept) = (run("turning"), run("crank"));
    for name in ["chi", "gamma2", "mu"] {
        let pairs: Vec<_> = turns(&timed, name).into_iter().zip(turns(&swept, name)).collect();
        assert!(pairs.len() >= 2, "{name}");
        for (one, other) in pairs {
            assert!((one - other).abs() < 1e-12 * 360.0, "{name}: {one} {other}");
        }
    }
    // Crank and rod in line.
    let stretched = (115f64.powi(2) + 100f64.powi(2) - 60f64.powi(2)) / (2.0 * 115.0 * 100.0);
    let expected = stretched.acos().to_degrees();
    let highest = &named(&timed["results"], "chi")["maximum"]["at"];
    check_near(&highest["drivers"][0]["value"], expected, 1e-10);
    check_near(&highest["time"], 0.1 * expected / 360.0, 1e-14);
    // How fast the lever turns, in degrees per second, is the speed of 600 rpm times the ratio.
    let speed = 600.0 * 360.0 / 60.0;
    let (fast, ratio) = (named(&timed["results"], "dot(chi)"), named(&swept["results"], "ratio"));
    for end in ["minimum", "maximum"] {
        let expected = ratio[end]["value"].as_f64().expect("a number") * speed;
        check_near(&fast[end]["value"], expected, 1e-11 * speed);
    }
}

#[test]
fn an_extreme_that_decides_has_its_own_kind_beside_a_pole() {
    // The least convex pitch radius, which decides about undercut, lies between poles and rests.
    let object = json(&["run", "selvedge_linkage", "--scene", "cam"], &folder("linkage_pole"));
    let radius = named(&object["results"], "pitch_radius");
    let turns = radius["limit_positions"].as_array().expect("a list");
    let convex = turns.iter().filter(|turn| turn["value"].as_f64() > Some(0.0));
    let least = convex.min_by(|a, b| {
        let value = |one: &Value| one["value"].as_f64().unwrap_or(f64::NAN);
        value(a).total_cmp(&value(b))
    });
    let least = least.expect("a turn");
    assert_eq!(least["kind"], "lowest");
    check_near(&least["value"], 28.192_205_69, 1e-8);
    // Where the profile is straight the radius is infinite: that is said, and where.
    for (end, expected) in [("minimum", Value::Null), ("maximum", Value::Null)] {
        assert_eq!(radius[end]["value"], expected);
        assert_eq!(radius[end]["unbounded"], true);
        check_near(&radius[end]["at"]["drivers"][0]["value"], 240.246_480_6, 1e-7);
    }
    let breaks = radius["breaks"].as_array().expect("a list");
    let kinds: Vec<_> = breaks.iter().map(|one| (&one["before"], &one["after"])).collect();
    let (up, down) = (Value::from("inf"), Value::from("-inf"));
    assert_eq!(kinds, [(&up, &down), (&down, &up)]);
}

#[test]
fn the_rod_and_the_lever_are_square_to_the_last_digit() {
    let object = json(&["run", "selvedge_linkage"], &folder("linkage_square"));
    check_near(&named(&object["results"], "mu")["maximum"]["value"], 90.0, 1e-12);
}

#[test]
fn an_output_that_stands_for_a_moment_does_not_turn() {
    let object = json(&["run", "feed_rack"], &folder("linkage_inflection"));
    assert_eq!(turns(&object, "tooth.y").len(), 0);
    assert_eq!(turns(&object, "gamma").len(), 1);
}

#[test]
fn start_values_far_from_the_position_are_told() {
    let directory = folder("linkage_far_start");
    let usual = json(&["run", "feed_lift"], &directory);
    assert_eq!(usual["note"], Value::Null);
    let far = ["feed_lift", "--set", "l_v=137mm", "--set", "r_D=49mm", "--set", "e_v=4mm"];
    let found = json(&[&["run"], &far[..]].concat(), &directory);
    let note = found["note"].as_str().expect("a note");
    assert!(note.contains("`assur modes feed_lift"), "{note}");
    let drawn = answer(&[&["draw"], &far[..]].concat(), &directory);
    assert!(drawn.contains("assur modes"), "{drawn}");
}

/// Where start values follow from the dimensions none is far from the position: the mode is the one that is meant, whatever they are.
#[test]
fn start_values_follow_from_the_dimensions() {
    let directory = folder("linkage_start_follows");
    let sizes = [
        "L2=95mm",
        "L3=58mm",
        "L4=86mm",
        "X_C=-11mm",
        "Y_C=87mm",
        "L6=109mm",
        "L7=24mm",
        "X_3=-38mm",
        "Y_3=-21mm",
    ];
    let sets = sizes.iter().flat_map(|size| ["--set", size]);
    let far: Vec<&str> = ["run", "dwell_six_bar"].into_iter().chain(sets).collect();
    let ends = ["1", "-1"].map(|mode| {
        let mode = format!("M2={mode}");
        let all = [&far[..], &["--set", &mode, "--at", "phi=0deg"]].concat();
        let found = json(&all, &directory);
        assert_eq!(found["note"], Value::Null, "{all:?}");
        named(&found["at"][0]["results"], "Psi")["value"].as_f64().expect("an angle")
    });
    assert!((ends[0] - ends[1]).abs() > 90.0, "{ends:?}");
}

#[test]
fn a_change_point_is_passed_and_what_has_no_value_there_is_left_out() {
    let directory = folder("linkage_change_point");
    let sizes = ["--set", "l1=40mm", "--set", "l2=100mm", "--set", "l3=40mm"];
    let object = json(&[&["run", "selvedge_linkage"], &sizes[..]].concat(), &directory);
    let events = object["events"].as_array().expect("a list");
    assert_eq!(events[0]["place"], "beta = 180 deg");
    assert!(events[0]["event"].as_str().is_some_and(|text| text.starts_with("change point")));
    let note = object["note"].as_str().expect("a note");
    assert!(
        note.starts_with("The measures of the task are missing: beyond beta = 0 deg"),
        "{note}"
    );
    // The open branch, chi = 180 deg - beta, all the way; its rate is zero over zero where the modes meet.
    for position in object["positions"].as_array().expect("a list") {
        let beta = position["drivers"][0]["value"].as_f64().expect("a number");
        let results = &position["results"];
        check_near(&named(results, "chi")["value"], 180.0 - beta, 1e-9);
        let ratio = &named(results, "ratio")["value"];
        match beta % 180.0 == 0.0 {
            true => assert_eq!(ratio, &Value::Null),
            false => check_near(ratio, -1.0, 1e-9),
        }
    }
}

/// Numbers of a linkage may be off by rounding, more beside a dead point, which the heald linkage has at 220.223 deg.
#[test]
fn roundings_are_told_and_grow_beside_a_dead_point() {
    let words = ["run", "heald_linkage", "--at", "phi4=90deg", "--at", "phi4=220.22deg"];
    let found = json(&words, &folder("roundings"));
    let number = |of: &Value| of.as_f64().expect("a number");
    for limits in found["results"].as_array().expect("a list") {
        for end in [&limits["minimum"], &limits["maximum"], &limits["limit_positions"][0]] {
            let error = &end["estimated_error"];
            assert!(end.is_null() || (1e-15..1e-12).contains(&number(error)), "{limits}");
        }
    }
    let [usual, beside] = [0, 1].map(|place| {
        let influence = found["at"][place]["influence"].as_array().expect("a list").iter();
        let errors = influence.map(|one| number(&one["estimated_error"]));
        let share = errors.fold(0.0, f64::max);
        (number(&found["at"][place]["estimated_errors"][2]), share)
    });
    assert!(beside.0 > 20.0 * usual.0 && beside.1 > 400.0 * usual.1, "{usual:?} {beside:?}");
}
