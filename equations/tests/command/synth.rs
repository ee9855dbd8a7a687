//! `assur synth`.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use super::{answer, check_refused, command, folder, run};

/// A crank-rocker that is to swing by 40 degrees with the best transmission angle.
const SWINGER: &str = r#"assur::mechanism! {
    /// A crank-rocker.
    Swinger from "any textbook";
    dimension l1 = 15 mm in 5 mm .. 100 mm, l2 = 90 mm in 5 mm .. 150 mm, a = 100 mm in 5 mm .. 200 mm;
    parameter l3 = 50 mm;
    driver phi ~ 90 deg in 0 deg .. 360 deg;
    dependent gamma ~ 20 deg, psi ~ 100 deg;
    closure loop: l1*dir(phi) + l2*dir(gamma) = [a, 0] + l3*dir(psi);
    output psi, cos_mu = cos(psi - gamma);
    scene turn { sweep phi; }
    scene best {
        sweep phi;
        vary l1, l2 in 30 mm .. 150 mm, a;
        require l1 < a;
        require l1 + a < l2 + l3 "the crank turns";
        require peak(psi) - lowest(psi) > 40 deg;
        minimise peak(abs(cos_mu));
    }
    scene never {
        sweep phi;
        vary l1, l2, a;
        require l1 + a < l2 + l3;
        require peak(psi) - lowest(psi) > 400 deg;
        minimise peak(abs(cos_mu));
    }
}"#;

/// A folder with the file.
fn with_file(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::write(folder.join("swinger.eqn"), SWINGER).expect("the folder is writable");
    folder
}

fn sought(arguments: &[&str], folder: &Path) -> Value {
    let all = [&["synth", "swinger.eqn", "--format", "json"], arguments].concat();
    serde_json::from_str(&answer(&all, folder)).expect("one JSON object")
}

fn value(list: &Value, index: usize) -> f64 {
    list[index]["value"].as_f64().expect("a number")
}

/// Of rockers that swing by an angle without quick return the transmission angle is the better the longer the coupler: at its
/// bound `|cos mu| = sin(20 deg) sqrt(1 + (l3/l2)^2 cos(20 deg)^2)`. What returns quickly is no better.
#[test]
fn the_best_transmission_angle_of_a_swing() {
    let folder = with_file("synth_swing");
    let effort = ["--evaluations", "6000", "--searches", "1"];
    let found = sought(&effort, &folder);
    let best = &found["designs"][0];
    let half = 20f64.to_radians();
    let expected = half.sin() * (1.0 + (half.cos() / 3.0).powi(2)).sqrt();
    assert!((value(&best["measures"], 0) - expected).abs() < 1e-8, "{best}");
    assert!(best["keeps"].as_bool() == Some(true) && found["whole"].as_bool() == Some(true));
    let [l1, l2, a] = [0, 1, 2].map(|index| value(&best["values"], index));
    assert!((l2 - 150.0).abs() < 1e-6 && (l1 - 50.0 * half.sin()).abs() < 1e-5, "{best}");
    assert!((a * a + l1 * l1 - l2 * l2 - 2500.0).abs() < 1e-3, "{best}");
    // Of the last condition nothing is left.
    assert!((0.0..1e-6).contains(&value(&best["measures"], 3)), "{best}");
    // The angle is as bad where crank and frame lie in line, both ways: these places, the swing and the bound hold three lengths.
    let polish = &best["polish"];
    assert_eq!(polish["bounds"], serde_json::json!(["l2"]));
    assert!(polish["free"] == 0 && polish["settled"] == true, "{polish}");
    let held = polish["held"].as_array().expect("a list");
    let places: Vec<f64> = held.iter().filter_map(|one| one["at"]["value"].as_f64()).collect();
    assert!(places.iter().all(|at| (at / 180.0 - (at / 180.0).round()).abs() < 1e-6), "{polish}");
    assert!(places.len() >= 2 && held.len() == places.len() + 1, "{polish}");
    // The same designs for any number of threads.
    let designs = |more: &[&str]| {
        let short = ["--evaluations", "600", "--searches", "2"];
        sought(&[&short[..], more].concat(), &folder)["designs"].to_string()
    };
    let alone = designs(&["--threads", "1"]);
    assert_eq!(alone, designs(&["--threads", "3"]));
    assert_ne!(alone, designs(&["--seed", "2"]));
    // The preset is a statement of the file.
    let preset = best["preset"].as_str().expect("a statement");
    let file = SWINGER
        .replace("scene turn { sweep phi; }", &format!("{preset} scene turn {{ sweep phi; }}"));
    std::fs::write(folder.join("swinger.eqn"), file).expect("the folder is writable");
    let with = ["run", "swinger.eqn", "--scene", "best", "--preset", "found_1", "--format", "json"];
    let again: Value = serde_json::from_str(&answer(&with, &folder)).expect("one JSON object");
    let measures = again["measures"].as_array().expect("a list").iter();
    let small =
        measures.clone().find(|one| one["name"] == "peak(abs(cos_mu))").expect("it is there");
    assert_eq!(small["value"], best["measures"][0]["value"]);
}

#[test]
fn designs_as_tables_and_rows() {
    let folder = with_file("synth_shown");
    let effort = ["--evaluations", "1200", "--searches", "1"];
    let table = answer(&[&["synth", "swinger.eqn"], &effort[..]].concat(), &folder);
    for words in [
        "Made small: peak(abs(cos_mu))",
        "Kept:       l1 + a < l2 + l3, the crank turns",
        "preset found_1 \"by synthesis\" { l1 = ",
        "no neighbour is better: held in all directions",
        "l2 at its upper bound",
        "left of peak(psi) - lowest(psi) > 40 deg",
        " designs were judged in ",
    ] {
        assert!(table.contains(words), "no {words:?} in\n{table}");
    }
    let figures = ["--plot", "best.svg", "--draw", "positions.svg", "--format", "csv"];
    let rows = answer(&[&["synth", "swinger.eqn"], &figures[..], &effort[..]].concat(), &folder);
    for file in ["best.svg", "positions.svg"] {
        let figure = std::fs::read_to_string(folder.join(file)).expect("the figure is there");
        assert!(figure.contains("<svg") && figure.contains("Scene best"), "{figure}");
    }
    assert_eq!(rows.lines().count(), 2, "{rows}");
    assert!(rows.starts_with("l1 [mm],l2 [mm],a [mm],peak(abs(cos_mu))"), "{rows}");
}

/// A search that is stopped, whenever that is, goes on from its file and comes to the same designs, bit for bit.
#[test]
fn a_search_goes_on_from_its_file() {
    let folder = with_file("synth_resume");
    let designs = |more: &[&str]| {
        let short = ["--evaluations", "1500", "--searches", "2"];
        let found = sought(&[&short[..], more].concat(), &folder);
        (found["designs"].to_string(), found["evaluations"].to_string())
    };
    let whole = designs(&[]);
    assert_eq!(designs(&["--resume", "a.search"]), whole);
    // All of it is in the file.
    assert_eq!(designs(&["--resume", "a.search"]), whole);
    let long = ["--evaluations", "12000", "--searches", "1"];
    let arguments = ["synth", "swinger.eqn", "--resume", "b.search"];
    let child = command(&[&arguments[..], &long].concat(), &folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    std::thread::sleep(Duration::from_secs(1));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("kill is there").success());
    let output = child.wait_with_output().expect("it ends");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{complaint}");
    let stored = std::fs::read_to_string(folder.join("b.search")).expect("the file is there");
    assert!(stored.contains("\"over\":0"), "{stored}");
    let again = sought(&[&long[..], &["--resume", "b.search"]].concat(), &folder);
    assert_eq!(again["designs"], sought(&long, &folder)["designs"]);
    // What belongs to another search, or is none, is refused.
    for (arguments, words) in [
        (&["--seed", "2"][..], "another search"),
        (&["--set", "l3=60mm"], "another search"),
        (&["--scene", "never"], "another search"),
    ] {
        let short = ["synth", "swinger.eqn", "--evaluations", "1500", "--searches", "2"];
        let all = [&short[..], &["--resume", "a.search"], arguments].concat();
        check_refused(&all, &[words, "--resume"], &folder);
    }
    std::fs::write(folder.join("c.search"), "{}").expect("the folder is writable");
    let all = ["synth", "swinger.eqn", "--resume", "c.search"];
    check_refused(&all, &["is not the file of a search"], &folder);
}

#[test]
fn what_cannot_be_kept_is_told_with_what_is_missed() {
    let folder = with_file("synth_never");
    let output = run(
        &["synth", "swinger.eqn", "--scene", "never", "--evaluations", "2000", "--searches", "1"],
        &folder,
    );
    assert_eq!(output.status.code(), Some(1));
    let complaint = String::from_utf8_lossy(&output.stderr);
    for words in ["keeps all conditions", "lowest(psi) > 400 deg` is missed by", "--evaluations"] {
        assert!(complaint.contains(words), "no {words:?} in\n{complaint}");
    }
}

#[test]
fn wrong_requests_are_refused() {
    let folder = with_file("synth_refused");
    for (arguments, words) in [
        (&["swinger.eqn", "--scene", "turn"][..], &["varies nothing", "minimise"][..]),
        (&["heald_linkage"], &["varies nothing"]),
        (&["swinger.eqn", "--set", "l1=12mm"], &["`l1` is varied"]),
        (&["swinger.eqn", "--population", "3"], &["4"]),
        (&["swinger.eqn", "--evaluations", "0"], &["1"]),
        (&["swinger.eqn", "--rtol", "1e-9"], &["--rtol"]),
    ] {
        check_refused(&[&["synth"], arguments].concat(), words, &folder);
    }
}

/// More searches follow while there is time; that is no interruption, and what they come to is kept.
#[test]
fn a_search_goes_on_for_a_time() {
    let folder = with_file("synth_more");
    let effort = ["--evaluations", "300", "--searches", "1", "--more", "2s"];
    let found = sought(&[&effort[..], &["--resume", "more.search"]].concat(), &folder);
    let judged = found["evaluations"].as_u64().expect("a number");
    assert!(judged > 600 && found["whole"] == true, "{judged}");
    // It goes on from there.
    let again = sought(&[&effort[..], &["--resume", "more.search"]].concat(), &folder);
    assert!(again["evaluations"].as_u64().is_some_and(|more| more > judged + 300), "{again}");
    let (first, second) = (&found["designs"][0], &again["designs"][0]);
    assert!(value(&second["measures"], 0) <= value(&first["measures"], 0) + 1e-9);
    for (time, words) in [("2kg", "wrong unit"), ("60", "needs a unit"), ("0s", "is no duration")] {
        let all = ["synth", "swinger.eqn", "--more", time];
        check_refused(&all, &[words, "--more 60s"], &folder);
    }
}

/// What is made small errs by the tolerances: to first order, `|cos mu|` where it is worst and the root of the sum of the squares.
#[test]
fn designs_are_ranked_as_they_are_made() {
    let folder = with_file("synth_robust");
    let effort = ["--evaluations", "2000", "--searches", "2", "--robust"];
    check_refused(
        &[&["synth", "swinger.eqn"], &effort[..]].concat(),
        &["has a tolerance", "+- 0.02 mm"],
        &folder,
    );
    let made = |half: &str| {
        let text = SWINGER.replace("a = 100 mm in", &format!("a = 100 mm +- {half} mm in"));
        std::fs::write(folder.join("swinger.eqn"), text).expect("the folder is writable");
        let found = sought(&effort, &folder);
        let best = &found["designs"][0];
        let own = best["made"].as_f64().expect("it has tolerances");
        let [l1, l2, a] = [0, 1, 2].map(|index| value(&best["values"], index));
        // At both ends of the line of crank and frame, by a: cos mu = (l2² + l3² - (a ± l1)²)/(2 l2 l3).
        let slopes = [l1, -l1].map(|crank| ((a + crank) / (l2 * 50.0)).abs());
        (own - value(&best["measures"], 0), slopes[0].max(slopes[1]))
    };
    let ((once, slope), (twice, _)) = (made("0.05"), made("0.1"));
    assert!((twice - 2.0 * once).abs() < 1e-6 * once, "{once} {twice}");
    assert!((once - 0.05 * slope).abs() < 0.02 * once, "{once} {slope}");
}
