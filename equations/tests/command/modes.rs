//! `assur modes`, and how far drivers go.

use serde_json::Value;

use super::{answer, check_refused, folder, json};
/// A quantity of a list of results.
#[track_caller]
fn value(list: &Value, name: &str) -> f64 {
    let mut list = list.as_array().expect("a list").iter();
    let found = list.find(|one| one["name"] == name).expect(name);
    found["value"].as_f64().expect("a number")
}

#[track_caller]
fn check_near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() <= tolerance, "{value} {expected}");
}

/// The real roots of the specification's polynomial of degree 8, found without it: zeros of `X^2 + Y^2 - l5^2` along
/// `phi7`, for both signs of `B`.
fn roots(phi4: f64) -> Vec<f64> {
    let [l4, l5, l6, l7, a, b, s] = [0.09, 0.23, 0.18, 0.12, 0.08, 0.105, 0.04_f64];
    let f = |phi7: f64, sign: f64| {
        let across = s + l7 * phi7.cos();
        let up = sign * (l6 * l6 - across * across).sqrt();
        let x = b + across + l7 * phi7.cos() - l4 * phi4.cos();
        let y = a + up + l7 * phi7.sin() - l4 * phi4.sin();
        x * x + y * y - l5 * l5
    };
    let count = 100_000;
    let angle = |index: usize| std::f64::consts::TAU * (index as f64 / count as f64 - 0.5);
    let mut found = Vec::new();
    for sign in [1.0, -1.0] {
        for index in 0..count {
            let (low, high) = (f(angle(index), sign), f(angle(index + 1), sign));
            if low * high < 0.0 {
                found.push(angle(index).to_degrees());
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn the_modes_are_the_roots_of_the_polynomial() {
    let directory = folder("modes_roots");
    for (at, count) in [("90", 4), ("60", 4), ("120", 4), ("230", 2)] {
        let option = format!("phi4={at}deg");
        let found = json(&["modes", "heald_linkage", "--at", &option], &directory);
        assert_eq!(found["status"], "complete");
        let modes = found["places"][0]["modes"].as_array().expect("a list");
        let angles = modes.iter().map(|mode| value(&mode["results"], "phi7"));
        let mut angles: Vec<f64> = angles.collect();
        angles.sort_by(f64::total_cmp);
        let expected = roots(at.parse::<f64>().expect("a number").to_radians());
        assert_eq!((angles.len(), expected.len()), (count, count), "{at}");
        for (found, expected) in angles.iter().zip(&expected) {
            assert!((found - expected).abs() < 0.01, "{found} {expected}");
        }
    }
}

#[test]
fn each_mode_is_closed_and_one_is_declared() {
    let directory = folder("modes_declared");
    let found = json(&["modes", "heald_linkage"], &directory);
    let place = &found["places"][0];
    let declared = place["declared"].as_u64().expect("one is declared") as usize;
    let mode = &place["modes"][declared];
    assert_eq!(mode["declared"], true);
    assert!((value(&mode["results"], "phi7") + 70.06145).abs() < 1e-5);
    assert_eq!(mode["groups"][0]["loops"], "loop.x, loop.y, guide");
    let mut signs: Vec<_> = Vec::new();
    for mode in place["modes"].as_array().expect("a list") {
        signs.push(mode["groups"][0]["sign"].as_i64());
        for residual in mode["residuals"].as_array().expect("a list") {
            check_near(&residual["value"], 0.0, 1e-15);
        }
    }
    assert_eq!(signs.iter().filter(|sign| **sign == Some(1)).count(), 2);
}

#[test]
fn a_mode_that_does_not_get_there_is_told() {
    let directory = folder("modes_unreached");
    let table = answer(&["modes", "heald_linkage", "--at", "phi4=230deg"], &directory);
    for word in ["2 assembly modes", "There is no other.", "dead point at phi4 = 220.223 deg"] {
        assert!(table.contains(word), "{word} is missing in\n{table}");
    }
    let none = ["--scene", "straight", "--at", "phi4=180deg"];
    let table = answer(&[&["modes", "heald_linkage"], &none[..]].concat(), &directory);
    assert!(table.contains("no assembly mode"), "{table}");
}

#[test]
fn dyads_have_two_modes_each() {
    let directory = folder("modes_dyads");
    let rows = answer(&["modes", "dwell_six_bar", "--format", "csv"], &directory);
    assert_eq!(rows.lines().count(), 5, "{rows}");
    assert_eq!(rows.lines().filter(|row| row.ends_with(",1")).count(), 1);
    // Outputs that are speeds need the motion of the drivers.
    let turning = ["modes", "selvedge_linkage", "--scene", "turning", "--at", "time=0.02s"];
    let found = json(&turning, &directory);
    let modes = found["places"][0]["modes"].as_array().expect("a list");
    assert_eq!(modes.len(), 2);
    let speeds: Vec<f64> = modes.iter().map(|mode| value(&mode["results"], "dot(chi)")).collect();
    assert!(speeds.iter().all(|speed| speed.abs() > 1000.0), "{speeds:?}");
}

#[test]
fn wrong_requests_are_refused() {
    let directory = folder("modes_refused");
    for (arguments, words) in [
        (&["modes"][..], &["needs a linkage", "assur modes heald_linkage"][..]),
        (&["modes", "batten"], &["no linkage"]),
        (&["modes", "heald_linkage", "--at", "phi5=1deg"], &["positions of drivers"]),
        (&["modes", "sewing_feed", "--set", "feed.e_v=7mm"], &["did you mean `lift.e_v`?"]),
        (&["run", "batten", "--rows", "limits"], &["only a linkage"]),
        (&["run", "heald_linkage", "--rows", "limits"], &["--format csv"]),
    ] {
        check_refused(arguments, words, &directory);
    }
}

#[test]
fn drivers_go_from_dead_point_to_dead_point() {
    let directory = folder("modes_reach");
    let found = json(&["run", "heald_linkage"], &directory);
    let reach = &found["reach"][0];
    assert_eq!(reach["turns"], false);
    check_near(&reach["low"]["at"], -65.330, 5e-4);
    check_near(&reach["high"]["at"], 220.223, 5e-4);
    assert_eq!(reach["low"]["dead_point"], "loop.x, loop.y, guide");
    let table = answer(&["run", "selvedge_linkage"], &directory);
    for word in ["beta  turns all round", "Limit positions", "stroke", "38.62483287"] {
        assert!(table.contains(word), "{word} is missing in\n{table}");
    }
}

#[test]
fn limit_positions_of_a_four_bar_are_exact() {
    let directory = folder("modes_limits");
    let found = json(&["run", "selvedge_linkage"], &directory);
    let results = found["results"].as_array().expect("a list").iter();
    let chi = results.clone().find(|one| one["name"] == "chi").expect("chi");
    // Crank and rod in line, by the cosine law: rod less crank, rod and crank.
    let [l1, l2, l3, a_w] = [25.0, 90.0, 60.0, 100.0_f64];
    let exact =
        |reach: f64| ((a_w * a_w + l3 * l3 - reach * reach) / (2.0 * a_w * l3)).acos().to_degrees();
    let turns = chi["limit_positions"].as_array().expect("a list");
    assert_eq!(turns.len(), 2);
    check_near(&turns[0]["value"], exact(l2 + l1), 1e-11);
    check_near(&turns[1]["value"], exact(l2 - l1), 1e-11);
    check_near(&chi["stroke"], exact(l2 + l1) - exact(l2 - l1), 1e-11);
    let rows =
        answer(&["run", "selvedge_linkage", "--format", "csv", "--rows", "limits"], &directory);
    assert!(rows.starts_with("name,unit,what,value,beta [deg]\n"), "{rows}");
    assert!(rows.lines().any(|row| row.starts_with("chi,deg,lowest,38.6248328")), "{rows}");
}

#[test]
fn what_stands_for_a_moment_does_not_turn() {
    let directory = folder("modes_standing");
    let found = json(&["run", "feed_rack"], &directory);
    let mut results = found["results"].as_array().expect("a list").iter();
    let height = results.find(|one| one["name"] == "tooth.y").expect("tooth.y");
    assert_eq!(height["limit_positions"].as_array().map(Vec::len), Some(0));
}

#[test]
fn a_grid_shows_the_reach_of_both_drivers() {
    let directory = folder("modes_grid");
    let found =
        json(&["run", "sewing_feed", "--scene", "map", "--set", "lift.e_v=6.5mm"], &directory);
    assert_eq!(found["task"]["over"].as_array().map(Vec::len), Some(2));
    let reach = found["reach"].as_array().expect("a list");
    assert_eq!((&reach[0]["driver"], &reach[0]["turns"]), (&"phi".into(), &true.into()));
    assert_eq!(reach[1]["driver"], "nu");
    let dead = reach[1]["high"]["dead_point"].as_str();
    assert_eq!(dead, Some("stitch.regulator.x, stitch.regulator.y"));
    let mut parameters = found["parameters"].as_array().expect("a list").iter();
    let set = parameters.find(|one| one["name"] == "lift.e_v").expect("a part's");
    assert_eq!(set["changed"], true);
}

#[test]
fn figures_show_coefficients_with_their_units() {
    let directory = folder("modes_figure");
    answer(&["run", "heald_linkage", "--plot", "all.svg"], &directory);
    let figure = std::fs::read_to_string(directory.join("all.svg")).expect("a figure");
    for word in ["Kinematic coefficients by φ₄", "Influence on φ₇, mrad/mm", "l₄", ">s<"] {
        assert!(figure.contains(word), "{word}");
    }
    let few = ["run", "heald_linkage", "--plot", "few.svg", "--curves", "diff(phi7, l5),phi7"];
    answer(&few, &directory);
    let figure = std::fs::read_to_string(directory.join("few.svg")).expect("a figure");
    assert!(figure.contains("Influence on φ₇") && !figure.contains("φ₅"));
}

#[test]
fn names_of_points_lack_their_parts() {
    let directory = folder("modes_names");
    answer(&["draw", "sewing_feed"], &directory);
    let drawn = directory.join("sewing_feed-cycle-positions.svg");
    let drawn = std::fs::read_to_string(drawn).expect("a picture");
    assert!(drawn.contains(">K₀<") && drawn.contains("stitch: eccentric"));
    assert!(!drawn.contains("stitch.K"), "names have their part");
}
