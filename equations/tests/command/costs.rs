//! `assur cost`: what accuracy costs.

use serde_json::Value;

use super::{answer, check_refused, folder};

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

#[test]
fn wrong_questions_are_refused() {
    let directory = folder("wrong_costs");
    for (words, expected) in [
        (&["cost", "heald_linkage"][..], "nothing is integrated"),
        (&["cost", "batten", "--of", "F3"], "`F3`"),
        (&["cost", "batten", "--for", "F2=0N"], "above 0"),
        (&["cost", "batten", "--for", "F2=-1N"], "above 0"),
        (&["cost", "batten", "--for", "F2=1mm"], "wrong unit"),
        (&["cost", "batten", "--for", "1K"], "has the unit of `1K`"),
        (&["cost", "batten", "--for", "x%"], "no share"),
        (&["cost", "batten", "--rtol", "1e-20..1e-3"], "out of range"),
        (&["cost", "batten", "--rtol", "3"], "between 0 and 1"),
        (&["cost", "batten", "--method", "euler"], "euler"),
        (&["scenes", "batten", "--against", "nope"], "--against nope"),
    ] {
        check_refused(words, &[expected], &directory);
    }
}
