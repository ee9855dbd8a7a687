//! `assur tolerance`.

use super::{answer, check_refused, folder, run};
use serde_json::Value;

/// The JSON answer for the heald linkage with more arguments.
fn heald(arguments: &[&str], directory: &std::path::Path) -> Value {
    let all = [&["tolerance", "heald_linkage", "--format", "json"], arguments].concat();
    serde_json::from_str(&answer(&all, directory)).expect("one JSON object")
}

fn near(found: &Value, expected: f64, share: f64) -> bool {
    let found = found.as_f64().expect("a number");
    (found - expected).abs() <= share * expected.abs()
}

#[test]
fn the_bands_of_the_specification() {
    let folder = folder("tolerance_bands");
    let found = heald(&["--at", "phi4=90deg", "--output", "phi7"], &folder);
    let bands = &found["bands"];
    assert!(near(&bands["worst"], 2.0570, 3e-5), "{bands}");
    assert!(near(&bands["deviation"], 0.55949, 2e-5), "{bands}");
    assert!(near(&bands["monte_carlo"]["deviation"]["value"], 0.55949, 1e-2));
    assert_eq!(bands["monte_carlo"]["assembled"], bands["monte_carlo"]["drawn"]);
    assert_eq!(found["status"], "complete");
    assert_eq!(found["output"]["error_unit"], "mrad");
    let shares = found["contributions"].as_array().expect("a list").iter();
    let sum: f64 = shares.filter_map(|one| one["share"].as_f64()).sum();
    assert!((sum - 1.0).abs() < 1e-12);
}

#[test]
fn linkages_that_do_not_assemble_are_not_passed_over() {
    let folder = folder("tolerance_brink");
    let place = ["--at", "phi4=220.213deg", "--kind", "monte-carlo"];
    let found = heald(&[&place[..], &["--samples", "4000"]].concat(), &folder);
    assert_eq!(found["status"], "conditional");
    let failures = found["bands"]["monte_carlo"]["failures"]["value"].as_f64();
    assert!(failures.is_some_and(|share| share > 0.4 && share < 0.6));
    let table = answer(&[&["tolerance", "heald_linkage"], &place[..]].concat(), &folder);
    assert!(table.contains("do not assemble in this mode"), "{table}");
}

#[test]
fn scaled_tolerances_show_what_the_sum_misses() {
    let folder = folder("tolerance_scaled");
    let found = heald(&["--at", "phi4=90deg", "--scale", "20", "--kind", "second"], &folder);
    let second = &found["bands"]["second"];
    assert!(near(&found["bands"]["worst"], 41.140, 1e-3));
    assert!(near(&second["extremes_closed"]["greatest"], 41.793, 1e-3), "{second}");
}

#[test]
fn tolerances_of_least_cost_keep_the_band() {
    let folder = folder("tolerance_allocation");
    let found = heald(&["--allocate", "1mrad", "--limit", "s=0.05mm..0.2mm"], &folder);
    let chosen = &found["allocation"];
    assert!(near(&chosen["greatest"], 1.0, 1e-6), "{chosen}");
    let tolerances = chosen["tolerances"].as_array().expect("a list");
    let s = tolerances.iter().find(|one| one["name"] == "s").expect("it is there");
    assert!(near(&s["half_width"], 0.05, 1e-6), "{s}");
    let out_of_reach =
        ["tolerance", "heald_linkage", "--allocate", "0.1mrad", "--limit", "l5=0.1mm.."];
    let output = run(&out_of_reach, &folder);
    assert_eq!(output.status.code(), Some(1));
    let complaint = String::from_utf8_lossy(&output.stderr);
    for word in ["phi4 = 60 deg", "0.50", "`l5`"] {
        assert!(complaint.contains(word), "{complaint}");
    }
}

#[test]
fn figure_and_rows_over_the_range() {
    let folder = folder("tolerance_figure");
    let rows = answer(
        &[
            "tolerance",
            "heald_linkage",
            "--kind",
            "worst",
            "--format",
            "csv",
            "--places",
            "7",
            "--plot",
            "bands.svg",
            "--play",
            "l5=0.02mm",
        ],
        &folder,
    );
    assert_eq!(rows.lines().count(), 8);
    assert!(rows.starts_with("phi4 [deg],phi7 [deg],worst case [mrad]"), "{rows}");
    let drawn = std::fs::read_to_string(folder.join("bands.svg")).expect("a figure");
    assert!(drawn.contains("l₅ (play)") && drawn.ends_with("</svg>\n"));
}

#[test]
fn what_the_paper_leaves_out_is_a_fifth() {
    let folder = folder("tolerance_left_out");
    let without = ["--tolerance", "l6=0mm", "--tolerance", "s=0mm"];
    let at = ["--at", "phi4=90deg", "--kind", "worst"];
    let found = heald(&[&at[..], &without[..]].concat(), &folder);
    assert!(near(&found["bands"]["worst"], 1.604, 3e-4), "{found}");
    assert_eq!(found["contributions"].as_array().map(Vec::len), Some(6));
}

#[test]
fn parts_grids_and_motions_have_tolerances_too() {
    let folder = folder("tolerance_parts");
    let json = |arguments: &[&str]| -> Value {
        let all = [&["tolerance"], arguments, &["--format", "json"]].concat();
        serde_json::from_str(&answer(&all, &folder)).expect("one JSON object")
    };
    let found = json(&["sewing_feed", "--set", "lift.e_v=7mm", "--output", "tooth.y"]);
    assert_eq!(found["changed"], "lift.e_v = 7 mm");
    assert_eq!(found["output"]["error_unit"], "mm");
    // A grid of both drivers, not its diagonal.
    let found = json(&["feed_stitch", "--scene", "map", "--kind", "worst"]);
    assert_eq!(found["range"]["places"], 64);
    // A crank that turns in time is shown in degrees.
    let found = json(&["selvedge_linkage", "--scene", "turning", "--kind", "rss"]);
    assert_eq!(found["place"][0]["unit"], "deg");
    assert!(near(&found["place"][0]["value"], 180.0, 1e-9), "{found}");
}

#[test]
fn a_place_beyond_a_dead_point_is_told_by_name() {
    let folder = folder("tolerance_beyond");
    let output = run(&["tolerance", "heald_linkage", "--at", "phi4=230deg"], &folder);
    assert_eq!(output.status.code(), Some(1));
    let complaint = String::from_utf8_lossy(&output.stderr);
    for word in ["dead point at phi4 = 220.223 deg", "loop.x, loop.y, guide", "mm would be left"] {
        assert!(complaint.contains(word), "{complaint}");
    }
}

#[test]
fn wrong_questions_are_refused() {
    let folder = folder("tolerance_refused");
    for (arguments, words) in [
        (&["batten"][..], &["no linkage"][..]),
        (&["heald_linkage", "--samples", "0"], &["choose from 2"]),
        (&["heald_linkage", "--samples", "1000000000000"], &["choose from 2"]),
        (&["heald_linkage", "--output", "phi9"], &["phi9", "did you mean"]),
        (&["heald_linkage", "--play", "l5=-1mm"], &["less than nothing"]),
        (&["heald_linkage", "--play", "l5=1kg"], &["wrong unit"]),
        (&["heald_linkage", "--tolerance", "l9=1mm"], &["nothing that can err"]),
        (&["heald_linkage", "--scale", "0"], &["--scale"]),
        (&["heald_linkage", "--allocate", "0mrad"], &["positive"]),
        (&["heald_linkage", "--allocate", "1mrad", "--limit", "s=2mm..1mm"], &["`s`", "nothing"]),
        (&["heald_linkage", "--allocate", "1mrad", "--cost", "s=-1"], &["`s`"]),
        (&["heald_linkage", "--places", "1"], &["choose from 2"]),
        (&["heald_linkage", "--samples", "-5"], &["-5", "--samples"]),
        (&["heald_linkage", "--tolerance", "l5=-0.1mm"], &["is no tolerance of `l5`"]),
        (&["heald_linkage", "--allocate", "1mm"], &["no band", "1mrad"]),
        (
            &["heald_linkage", "--tolerance", "l5=1mm", "--tolerance", "l5=2mm"],
            &["the tolerance of `l5` is given twice", "--tolerance l5=2mm"],
        ),
        (
            &["heald_linkage", "--allocate", "1mrad", "--cost", "s=2", "--cost", "s=3"],
            &["the weight of `s` is given twice"],
        ),
        (
            &[
                "heald_linkage",
                "--allocate",
                "1mrad",
                "--limit",
                "s=1mm..2mm",
                "--limit",
                "s=1mm..3mm",
            ],
            &["limits of `s` is given twice"],
        ),
        (&["sewing_feed", "--set", "feed.e_v=7mm"], &["`lift.e_v`"]),
        (&["sewing_feed", "--tolerance", "e_v=1mm"], &["`lift.e_v`"]),
        (&[], &["needs a linkage", "assur tolerance heald_linkage"]),
    ] {
        check_refused(&[&["tolerance"], arguments].concat(), words, &folder);
    }
}

#[test]
fn the_answer_says_which_output_it_is_about() {
    let folder = folder("tolerance_output");
    let short = ["--samples", "2000"];
    let found = heald(&short, &folder);
    assert_eq!(found["output"]["name"], "phi7");
    assert_eq!(found["output"]["named"], false);
    assert_eq!(found["output"]["others"][0], "phi5");
    let table = |more: &[&str]| {
        let all = [&["tolerance", "heald_linkage"], &short[..], more].concat();
        answer(&all, &folder)
    };
    let unasked = "phi7 is the last output of the scene; for another one: --output phi5";
    assert!(table(&[]).contains(unasked));
    let named = table(&["--output", "phi5", "--plot", "bands.svg"]);
    assert!(!named.contains("last output") && named.contains("Other outputs: --output phi6"));
    let figure = std::fs::read_to_string(folder.join("bands.svg")).expect("a figure");
    assert!(figure.contains("the error of φ₅") && !figure.contains("phi"));
}

#[test]
fn beside_a_dead_point_the_orders_are_not_trusted_and_what_is_closed_is_no_turns_away() {
    let folder = folder("tolerance_dead_point");
    let place = ["--at", "phi4=-65.3297deg", "--kind", "second"];
    let second = &heald(&place, &folder)["bands"]["second"];
    assert_eq!(second["trusted"], false);
    let greatest = second["extremes_closed"]["greatest"].as_f64();
    assert!(greatest.is_some_and(|one| one > 50.0 && one < 60.0), "{second}");
    let usual = &heald(&["--at", "phi4=90deg", "--kind", "second"], &folder)["bands"]["second"];
    assert_eq!(usual["trusted"], true);
}

#[test]
fn a_tolerance_that_leaves_the_range_of_its_dimension_is_told() {
    let folder = folder("tolerance_range");
    let wide = ["--at", "phi4=90deg", "--kind", "rss", "--tolerance", "l5=300mm"];
    let found = heald(&wide, &folder);
    let note = found["notes"][0].as_str().expect("a note");
    assert!(note.contains("`l5` cannot be -70 mm"), "{note}");
    let usual = heald(&wide[..4], &folder);
    assert_eq!(usual["notes"], Value::Array(Vec::new()));
    let huge = ["tolerance", "heald_linkage", "--at", "phi4=90deg", "--scale", "1e308"];
    check_refused(&huge, &["too large to compute", "--scale"], &folder);
}
