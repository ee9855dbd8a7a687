//! `assur cost`: what accuracy costs.

use serde_json::Value;

use super::{answer, check_refused, folder, run};

fn object(arguments: &[&str]) -> Value {
    let name = arguments.join("-").replace(['/', '=', '%', '.', ','], "-");
    let text = answer(&[arguments, &["--format", "json"]].concat(), &folder(&name));
    serde_json::from_str(&text).expect("one JSON object")
}

/// Errors shrink with the tolerance down to what the reference is known by, and what is cheapest reaches what is asked for.
#[test]
fn smaller_tolerances_err_less() {
    for name in ["batten", "presser_foot", "table_drive"] {
        let words = ["cost", name, "--rtol", "1e-9..1e-4", "--seconds", "0", "--for", "0.01%"];
        let found = object(&words);
        let trials = found["trials"].as_array().unwrap();
        assert_eq!(trials.len(), 36);
        for of_method in trials.chunks(6) {
            let [loose, tight] = [&of_method[0], &of_method[5]];
            assert_eq!((loose["rtol"].as_f64(), tight["rtol"].as_f64()), (Some(1e-4), Some(1e-9)));
            let number = |of: &Value, name: &str| of[name].as_f64().unwrap_or(f64::NAN);
            assert!(
                number(tight, "largest") < 1e-2 * number(loose, "largest"),
                "{name}: {loose} {tight}"
            );
        }
        let cheapest = &trials[found["cheapest"].as_u64().unwrap() as usize];
        assert!(cheapest["largest"].as_f64().unwrap() <= 1e-4, "{name}: {cheapest}");
        let quicker = trials.iter().filter(|one| {
            one["largest"].as_f64().is_some_and(|error| error <= 1e-4)
                && one["seconds"].as_f64() < cheapest["seconds"].as_f64()
        });
        assert_eq!(quicker.count(), 0, "{name}");
    }
}

/// Linkages made at random err by one over the root of their number; what is told of the orders is what many of them say.
#[test]
fn spreads_of_linkages_have_their_price() {
    for name in ["heald_linkage", "dwell_six_bar", "gear_flank"] {
        let found = object(&["cost", name, "--seconds", "0", "--for", "1%"]);
        let spread = &found["spread"];
        let number = |of: &Value, name: &str| of[name].as_f64().expect("a number");
        let deviation = number(spread, "standard_deviation");
        let ways = spread["ways"].as_array().unwrap();
        let [first, second] = [&ways[0], &ways[1]];
        assert!(number(second, "error") < number(first, "error"), "{name}: {spread}");
        assert!(number(first, "error") < 0.01 * deviation, "{name}: {spread}");
        let (few, many) = (&ways[4], &ways[6]);
        assert_eq!(
            (few["linkages"].as_u64(), many["linkages"].as_u64()),
            (Some(10_000), Some(1_000_000))
        );
        let ratio = number(few, "error") / number(many, "error");
        assert!((8.0..12.5).contains(&ratio), "{name}: {ratio}");
        let off = (number(many, "standard_deviation") - deviation).abs();
        assert!(off < 1.5 * number(many, "error"), "{name}: {many}");
        let cheapest = &ways[spread["cheapest"].as_u64().expect("a way") as usize];
        assert!(number(cheapest, "error") <= 0.01 * deviation, "{name}: {cheapest}");
        assert!(number(&found, "position") > 0.0, "{name}");
    }
}

/// An accuracy beyond what mechanisms as they are made have is said to be of no use.
#[test]
fn dimensions_as_they_are_made_limit_what_accuracy_is_for() {
    let words = ["cost", "engine", "--scene", "run", "--method", "auto", "--rtol", "1e-9..1e-6"];
    let words = [&words[..], &["--of", "irregularity", "--seconds", "0", "--for"]].concat();
    let text = answer(&[&words[..], &["1%"]].concat(), &folder("made_loosely"));
    assert!(text.contains("r, l, e, bore make irregularity differ by 0."), "{text}");
    // Nor does anything that is tried reach it.
    let output = run(&[&words[..], &["1e-6%"]].concat(), &folder("made_finely"));
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("such an accuracy is of no use"), "{text}");
    // A bore that is larger by one standard deviation, and so on.
    let found = object(&[&words[..], &["1%"]].concat());
    let told = found["quantities"][0]["spread"].as_f64().expect("a spread");
    let at = |set: &str| {
        let words = ["run", "engine", "--scene", "run", "--format", "json", "--set", set];
        let found: Value = serde_json::from_str(&answer(&words, &folder("made_run"))).unwrap();
        let measures = found["measures"].as_array().expect("measures").clone();
        let one = measures.iter().find(|one| one["name"] == "irregularity").expect("the measure");
        one["value"].as_f64().expect("a number")
    };
    let third = 1.0 / 3.0;
    let (base, wide) = (
        at("bore=80mm"),
        [("r", 40.0, 0.02), ("l", 140.0, 0.02), ("e", 0.0, 0.02), ("bore", 80.0, 0.01)],
    );
    let squares = wide.map(|(name, value, width)| {
        (at(&format!("{name}={}mm", value + third * width)) - base).powi(2)
    });
    let root = squares.iter().sum::<f64>().sqrt();
    assert!((told - root).abs() < 0.01 * root, "{told} {root}");
}

/// Scenes beside the one with most effects, or one that is named.
#[test]
fn scenes_are_compared_with_the_fullest() {
    let directory = folder("cost_of_scenes");
    let text = answer(&["scenes", "batten", "--plot", "effects.svg"], &directory);
    let at = text.find("how far they are from damped").expect("a table");
    let row = |name: &str| {
        let line = text[at..].lines().find(|line| line.trim_start().starts_with(name));
        let words: Vec<_> = line.expect("a row").split_whitespace().map(str::to_owned).collect();
        words
    };
    // Losses that are left out are felt less than a shaft that is rigid.
    let off = |name: &str| row(name)[4].parse::<f64>().expect("a share");
    assert!(off("damped_linear") < off("elastic") && off("elastic") < off("bending"));
    assert!(std::fs::read_to_string(directory.join("effects.svg")).unwrap().contains("elastic"));
    let text = answer(&["scenes", "batten", "--against", "exact"], &folder("cost_against"));
    assert!(text.contains("how far they are from exact"));
}

/// The cells of a row of a table below a heading, by the start of the row.
fn row(text: &str, heading: &str, begin: &str) -> Vec<String> {
    let at = text.find(heading).unwrap_or_else(|| panic!("no {heading} in {text}"));
    let line = text[at..].lines().find(|line| line.trim_start().starts_with(begin));
    line.expect("a row").split_whitespace().map(str::to_owned).collect()
}

/// A rigid shaft suffices for five per cent of a force; for what only the shaft can do it does not; and what it takes depends
/// on the speed.
#[test]
fn the_cheapest_combination_that_suffices_is_found_among_all() {
    let directory = folder("within");
    let ask = |words: &[&str]| answer(&[&["scenes", "batten"], words].concat(), &directory);
    let text = ask(&["--within", "F2=5%", "--plot", "within.svg"]);
    assert!(text.contains("all 72 combinations"), "{text}");
    let command = text.lines().find(|line| line.contains("assur run batten")).expect("a command");
    assert!(
        command.contains("--scene rigid") || command.contains("--without torsion"),
        "{command}"
    );
    assert!(directory.join("within.svg").exists());
    // A torque of the shaft needs the shaft, and its losses.
    let text = ask(&["--within", "phi2=1%", "--within", "F2=1%"]);
    assert!(row(&text, "Combinations", "*").len() > 4);
    let enough = text.lines().filter(|line| line.starts_with("  *"));
    assert!(enough.clone().count() > 1);
    for line in enough {
        assert!(line.contains("torsion") && line.contains("damping"), "{line}");
    }
    // Fewer may differ: damping, or not.
    let text = ask(&["--within", "F2=5%", "--among", "damping"]);
    assert!(text.contains("all 2 combinations"), "{text}");
    // The faster it turns, the more counts.
    let text = ask(&["--within", "F2=2N", "--over", "n=150..400rpm:3"]);
    let shares = row(&text, "What leaving an effect out", "torsion");
    let shares: Vec<f64> = shares[1..].iter().map(|cell| cell.parse().expect("a share")).collect();
    assert!(shares[0] < shares[1] && shares[1] < shares[2] && shares[2] > 100.0, "{shares:?}");
    // Which of those that suffice is the cheapest, clocks decide; all of them have the shaft.
    for speed in ["150", "275", "400"] {
        let effects = row(&text, "What suffices at each value", speed).join(" ");
        assert!(effects.contains("torsion"), "{effects}");
    }
    let fastest = row(&text, "What suffices at each value", "400").join(" ");
    assert!(fastest.contains("bending + coupling + damping + torsion"), "{fastest}");
}

/// What a table says an effect does is what two runs differ by.
#[test]
fn shares_are_those_of_two_runs() {
    let text = answer(&["scenes", "batten", "--within", "peak_rod2=1%"], &folder("within_shares"));
    let peak = |scene: &[&str]| {
        let words = [&["run", "batten", "--format", "json"], scene].concat();
        let found: Value = serde_json::from_str(&answer(&words, &folder("within_run"))).unwrap();
        let measures = found["measures"].as_array().expect("measures").clone();
        let one = measures.iter().find(|one| one["name"] == "peak_rod2").expect("the measure");
        one["value"].as_f64().expect("a number")
    };
    let whole = peak(&["--scene", "damped"]);
    let without = peak(&["--scene", "damped", "--without", "torsion"]);
    let heads = row(&text, "all the rest being there", "bending");
    let place = heads.iter().position(|head| head == "torsion").expect("a column") + 1;
    let told: f64 = row(&text, "all the rest being there", "peak_rod2")[place].parse().unwrap();
    let share = 100.0 * (whole - without).abs() / whole.abs();
    assert!((told - share).abs() < 0.02 * share, "{told} {share}");
}

/// What comes nearest is said, and what keeps it from more; a file has the ways of which nothing came.
#[test]
fn an_accuracy_that_nothing_reaches_is_an_error() {
    let words = ["cost", "batten", "--of", "F2", "--method", "dop853", "--seconds", "0", "--rtol"];
    let asked = |more: &[&str]| {
        let output = run(&[&words[..], more].concat(), &folder("cost_unreached"));
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), String::from_utf8(output.stdout).expect("text"), told)
    };
    let (code, text, told) = asked(&["1e-8..1e-6", "--for", "F2=1e-15N"]);
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("is not reached"), "{told}");
    assert!(text.contains("nothing reaches F2 to 1e-15N; nearest comes dop853"), "{text}");
    assert!(text.contains("no smaller tolerance was tried"), "{text}");
    let (code, text, _) = asked(&["1e-8..1e-6", "--for", "F2=1e-15N", "--format", "json"]);
    let found: Value = serde_json::from_str(&text).expect("one JSON object");
    assert_eq!((code, &found["cheapest"]), (Some(1), &Value::Null));
    assert_eq!(found["nearest"]["limited_by"], "tolerances", "{}", found["nearest"]);
    // Down to rounding nothing smaller helps.
    let (_, text, _) = asked(&["1e-13..1e-10", "--for", "F2=1e-15N"]);
    assert!(text.contains("At best") && text.contains("rounding limits it"), "{text}");
    // There is but one way to a position.
    let words = ["cost", "balanced_four_bar", "--scene", "turn", "--for"];
    let words = |accuracy: &'static str| [&words[..], &[accuracy]].concat();
    let text = answer(&words("1e-9%"), &folder("cost_of_a_position"));
    assert!(text.contains("every value, at the cost above"), "{text}");
    let output = run(&words("1e-14%"), &folder("cost_of_a_position"));
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn wrong_questions_are_refused() {
    let directory = folder("wrong_costs");
    for (words, expected) in [
        (&["cost", "heald_linkage", "--method", "radau"][..], "nothing is integrated"),
        (&["cost", "heald_linkage", "--of", "phi9"], "`phi9`"),
        (&["cost", "heald_linkage", "--for", "0rad"], "above 0"),
        (&["cost", "heald_linkage", "--for", "1mm"], "has the unit of `1mm`"),
        (&["cost", "batten", "--of", "F3"], "`F3`"),
        (&["cost", "batten", "--for", "F2=0N"], "above 0"),
        (&["cost", "batten", "--for", "F2=-1N"], "above 0"),
        (&["cost", "batten", "--for", "F2=1mm"], "wrong unit"),
        (&["cost", "batten", "--for", "1K"], "has the unit of `1K`"),
        (&["cost", "batten", "--for", "x%"], "no share"),
        (&["cost", "batten", "--rtol", "1e-20..1e-3"], "out of range"),
        (&["cost", "batten", "--rtol", "3e-6..4e-6"], "no power of ten"),
        (&["cost", "batten", "--rtol", "3"], "between 0 and 1"),
        (&["cost", "batten", "--method", "euler"], "euler"),
        (&["scenes", "batten", "--against", "nope"], "--against nope"),
        (&["scenes", "batten", "--within", "F3=1%"], "`F3`"),
        (&["scenes", "batten", "--within", "F2=1mm"], "wrong unit"),
        (&["scenes", "batten", "--within", "F2=0N"], "above 0"),
        (&["scenes", "batten", "--within", "1%", "--among", "wobble"], "`wobble`"),
        (&["scenes", "batten", "--within", "1%", "--over", "n=1..2mm"], "wrong unit"),
        (&["scenes", "batten", "--within", "1%", "--over", "n=9rpm"], "NAME=FROM..TO[:COUNT]"),
        (&["scenes", "batten", "--over", "n=150..400rpm"], "--within"),
        (&["scenes", "needle_impact", "--within", "1%"], "combinations or more"),
    ] {
        check_refused(words, &[expected], &directory);
    }
}
