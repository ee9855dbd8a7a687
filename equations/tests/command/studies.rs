//! Measures of runs, motions that repeat, and studies of many runs.

use serde_json::Value;

use super::{answer, check_refused, folder};

fn object(arguments: &[&str]) -> Value {
    let name = arguments.join("-").replace(['/', '=', '[', ']'], "-");
    let text = answer(arguments, &folder(&name));
    serde_json::from_str(&text).expect("one JSON object")
}

fn named<'a>(list: &'a Value, name: &str) -> &'a Value {
    let mut all = list.as_array().expect("a list").iter();
    all.find(|one| one["name"] == name).unwrap_or_else(|| panic!("no {name} in {list}"))
}

#[test]
fn a_motion_through_events_that_repeats_is_shown_over_all_its_periods() {
    let once = object(&["run", "presser_foot", "--set", "omega=300[1/s]", "--format", "json"]);
    let twice = object(&["run", "presser_foot", "--set", "omega=400[1/s]", "--format", "json"]);
    for (run, periods, omega) in [(&once, 1.0, 300.0), (&twice, 2.0, 400.0)] {
        assert_eq!(run["task"]["periods"], periods);
        let to = run["task"]["to"].as_f64().unwrap();
        assert!((to * omega / std::f64::consts::TAU - periods).abs() < 1e-12);
        let turns = named(&run["measures"], "turns")["value"].as_f64().unwrap();
        assert!((turns - periods).abs() < 1e-12);
        let leaves = run["events"].as_array().unwrap().iter();
        let leaves = leaves.filter(|event| event["to"] == "flight").count() as f64;
        assert_eq!(named(&run["measures"], "flights")["value"], leaves);
        let moduli = run["multipliers"].as_array().unwrap().iter();
        assert!(moduli.map(|one| one["modulus"].as_f64().unwrap()).all(|one| one < 1.0));
    }
}

#[test]
fn measures_have_an_estimated_error_or_say_why_there_are_none() {
    let run = object(&["run", "table_drive", "--scene", "table_1", "--format", "json"]);
    let twist = named(&run["measures"], "largest_twist");
    assert_eq!(twist["unit"], "mrad");
    let (value, error) =
        (twist["value"].as_f64().unwrap(), twist["estimated_error"].as_f64().unwrap());
    assert!(value > 0.0 && error > 0.0 && error < 1e-6 * value, "{twist}");
    // The largest sample of the curve is no larger, and not much smaller.
    let sampled = named(&run["results"], "twist");
    let largest = sampled["maximum"]["value"].as_f64().unwrap() * 1e3;
    assert!((largest - value).abs() < 1e-9 * value, "{largest} {value}");
    let blocked = object(&["run", "table_drive", "--scene", "blocked", "--format", "json"]);
    let never = named(&blocked["measures"], "start_of_table");
    assert!(never["value"].is_null());
    assert_eq!(never["missing"], "the mode `run` is never entered");
    let table = answer(&["run", "table_drive", "--scene", "blocked"], &folder("blocked_table"));
    assert!(
        table.contains("Measures of the whole task") && table.contains("never entered"),
        "{table}"
    );
}

const GRID: &[&str] = &[
    "study",
    "presser_foot",
    "--over",
    "omega=200..300[1/s]:3",
    "--over",
    "F10=20..60N:2",
    "--measure",
    "free,F_largest",
];

fn with<'a>(more: &[&'a str], words: &[&'a str]) -> Vec<&'a str> {
    more.iter().chain(words).copied().collect()
}

#[test]
fn a_grid_has_a_run_for_each_pair_of_values_whatever_the_number_of_threads() {
    let json = with(GRID, &["--format", "json", "--threads", "1"]);
    let study = object(&json);
    let free = named(&study["measures"], "free")["values"].as_array().unwrap();
    assert_eq!(free.len(), 6);
    // The first range changes fastest: run 4 is omega = 250 with F10 = 60 N.
    let single = object(&[
        "run",
        "presser_foot",
        "--set",
        "omega=250[1/s]",
        "--set",
        "F10=60N",
        "--format",
        "json",
    ]);
    assert_eq!(named(&single["measures"], "free")["value"], free[4]);
    let two = object(&with(GRID, &["--format", "json", "--threads", "2"]));
    assert_eq!(two["measures"], study["measures"]);
    let csv = answer(&with(GRID, &["--format", "csv"]), &folder("study_csv"));
    assert_eq!(csv.lines().count(), 7, "{csv}");
    assert!(csv.starts_with("omega [1/s],F10 [N],free,F_largest [N],failure\n"), "{csv}");
    let directory = folder("study_map");
    let table = answer(&with(GRID, &["--plot", "map.svg"]), &directory);
    assert!(table.contains("F10, N \\ omega, 1/s") && table.contains("Figure: map.svg"), "{table}");
    let drawn = std::fs::read_to_string(directory.join("map.svg")).unwrap();
    assert!(drawn.contains("<svg") && drawn.contains("free"), "{drawn}");
}

#[test]
fn counterweights_are_chosen_by_a_study() {
    let study = object(&[
        "study",
        "balanced_four_bar",
        "--scene",
        "balanced_cycle",
        "--over",
        "m_1=0.4..1.6kg:7",
        "--over",
        "m_3=0.6..2.4kg:7",
        "--format",
        "json",
    ]);
    let values = |name: &str| {
        let values = named(&study["measures"], name)["values"].as_array().unwrap();
        values.iter().map(|one| one.as_f64().unwrap()).collect::<Vec<_>>()
    };
    let (force, moment) = (values("force"), values("moment"));
    // Balance of Berkof and Lowen: 1 kg and 1.5 kg, in the middle of the grid.
    let least = force.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)).unwrap();
    assert_eq!(least.0, 24);
    assert!(*least.1 < 1e-9 && force.iter().filter(|one| **one < 50.0).count() == 1);
    // What it costs: the moment grows with the weight on the rocker, and does not feel the one on the crank.
    assert!(moment.chunks(7).is_sorted_by(|a, b| a[0] < b[0]));
    assert!(moment.chunks(7).all(|row| row.iter().all(|one| (one - row[0]).abs() < 1e-9 * row[0])));
}

#[test]
fn values_made_at_random_are_the_same_for_the_same_seed() {
    let runs = [
        "study",
        "table_drive",
        "--scene",
        "table_1",
        "--samples",
        "40",
        "--tolerance",
        "J2=10%",
        "--format",
        "json",
    ];
    let (one, same) = (object(&runs), object(&with(&runs, &["--threads", "1"])));
    assert_eq!(one["measures"], same["measures"]);
    let other = object(&with(&runs, &["--seed", "2"]));
    assert_ne!(one["measures"], other["measures"]);
    let peak = named(&one["measures"], "peak_torque");
    let (least, mean, greatest) = (&peak["least"], &peak["mean"]["value"], &peak["greatest"]);
    assert!(least.as_f64() < mean.as_f64() && mean.as_f64() < greatest.as_f64());
    assert_eq!(peak["values"].as_array().unwrap().len(), 40);
}

#[test]
fn wrong_studies_are_refused() {
    let directory = folder("wrong_studies");
    let cases: &[(&[&str], &[&str])] = &[
        (&["study", "andrews"], &["has no measures", "measure x_max = peak(x);"]),
        (&["study", "presser_foot"], &["--over NAME=FROM..TO:COUNT"]),
        (&["study", "presser_foot", "--over", "omga=1..2:3"], &["`omga`", "omega"]),
        (&["study", "presser_foot", "--over", "omega=200..300"], &["NAME=FROM..TO:COUNT"]),
        (&["study", "presser_foot", "--over", "omega=200..300[1/s]:1"], &["from 2 to"]),
        (&["study", "presser_foot", "--over", "omega=200..200[1/s]:5"], &["no length"]),
        (&["study", "presser_foot", "--over", "omega=200mm..300mm:5"], &["wrong unit"]),
        (
            &["study", "presser_foot", "--over", "omega=-5..300[1/s]:5"],
            &["--over omega=-5..300[1/s]:5"],
        ),
        (
            &[
                "study",
                "presser_foot",
                "--over",
                "omega=200..300[1/s]:5000",
                "--over",
                "F10=1..2N:5000",
            ],
            &["too many"],
        ),
        (
            &["study", "presser_foot", "--samples", "100"],
            &["has a tolerance", "--tolerance NAME=10%"],
        ),
        (
            &["study", "presser_foot", "--samples", "0", "--tolerance", "m=1%"],
            &["--samples", "choose from 2"],
        ),
        (
            &["study", "presser_foot", "--samples", "1e12", "--tolerance", "m=1%"],
            &["--samples", "choose from 2"],
        ),
        (
            &["study", "presser_foot", "--samples", "10", "--tolerance", "m=-1%"],
            &["not below zero"],
        ),
        (
            &["study", "presser_foot", "--samples", "10", "--tolerance", "m=0"],
            &["nothing in scene `elliptic` has a tolerance"],
        ),
        (
            &[
                "study",
                "presser_foot",
                "--samples",
                "10",
                "--tolerance",
                "m=10%",
                "--tolerance",
                "m=5%",
            ],
            &["given twice", "--tolerance m=5%"],
        ),
        (
            &[
                "study",
                "presser_foot",
                "--over",
                "omega=200..300[1/s]:3",
                "--set",
                "omega=250[1/s]",
            ],
            &["given twice, with --over and --set"],
        ),
        (
            &["study", "presser_foot", "--over", "omega=200..300[1/s]:3", "--plot", "lift_off.png"],
            &[".svg only", "lift_off.svg"],
        ),
        (
            &["study", "presser_foot", "--over", "omega=200..300[1/s]:3", "--measure", "fre"],
            &["did you mean `free`?"],
        ),
    ];
    for (arguments, words) in cases {
        check_refused(arguments, words, &directory);
    }
}

/// Measures of a linkage over its sweep, over a value and made at random.
#[test]
fn linkages_are_studied_by_the_measures_of_their_sweep() {
    let words = ["study", "selvedge_linkage", "--scene", "crank", "--format", "json"];
    let over = ["--over", "l1=20..30mm:3", "--measure", "swing"];
    let over = object(&[&words[..], &over].concat());
    // The limits by the cosine theorem.
    let swing = |l1: f64| {
        let chi = |side: f64| {
            let (l3, a) = (60.0, 100.0);
            let cosine: f64 = (a * a + l3 * l3 - side * side) / (2.0 * a * l3);
            cosine.acos().to_degrees()
        };
        chi(90.0 + l1) - chi(90.0 - l1)
    };
    let found = named(&over["measures"], "swing")["values"].as_array().unwrap().clone();
    for (found, l1) in found.iter().zip([20.0, 25.0, 30.0]) {
        assert!((found.as_f64().unwrap() - swing(l1)).abs() < 1e-9, "{found} at {l1}");
    }
    let by = object(&[&words[..], &["--sensitivity", "--measure", "swing"]].concat());
    let by = named(&by["measures"], "swing")["by"].clone();
    let l1 = named(&by, "l1");
    let slope = (swing(25.0 + 1e-4) - swing(25.0 - 1e-4)) / 2e-4;
    assert!((l1["value"].as_f64().unwrap() - slope).abs() < 1e-6, "{l1}, not {slope}");
    assert_eq!((l1["unit"].as_str(), by[0]["name"].as_str()), (Some("deg/mm"), Some("l1")));
    let made = object(&[&words[..], &["--samples", "40", "--measure", "swing"]].concat());
    let made = named(&made["measures"], "swing");
    assert!((made["mean"]["value"].as_f64().unwrap() - swing(25.0)).abs() < 0.2, "{made}");
}

/// Two motions attract at 500 1/s, as a computation in another language has it (the file's preset `fast` and its scene `let_fall`).
#[test]
fn coexisting_motions_are_found_over_a_range() {
    let words = ["study", "presser_foot", "--attractors", "--over", "omega=450..700[1/s]:11"];
    let found = object(&[&words[..], &["--measure", "F_largest", "--format", "json"]].concat());
    let last = &found["values"][2];
    let attractors = last["attractors"].as_array().unwrap();
    let mut forces: Vec<f64> =
        attractors.iter().map(|one| one["measures"][0]["value"].as_f64().unwrap()).collect();
    forces.sort_by(f64::total_cmp);
    assert_eq!(forces.len(), 2, "{last}");
    assert!(
        (forces[0] - 83.7458).abs() < 1e-3 && (forces[1] - 239.5672).abs() < 1e-3,
        "{forces:?}"
    );
    assert!(attractors.iter().all(|one| one["growth"].as_f64().unwrap() < 1.0), "{last}");
}

/// The speeds at 248.1683 and 252.98 rpm were computed outside, from the maps of half a turn, and that there are four.
#[test]
fn resonances_are_found_over_a_range() {
    let words =
        ["study", "batten", "--resonances", "--over", "n=240..260rpm:11", "--format", "json"];
    let found = object(&words);
    let all = found["resonances"].as_array().unwrap();
    let ones: Vec<f64> = { all.iter() }
        .filter(|one| one["meets"] == "1")
        .map(|one| one["value"].as_f64().unwrap())
        .collect();
    assert_eq!(ones.len(), 4, "{ones:?}");
    assert!((ones[1] - 248.1683).abs() < 5e-5 && (ones[2] - 252.98).abs() < 5e-4, "{ones:?}");
    assert!(all.iter().all(|one| one["distance"].as_f64().unwrap() < 1e-6), "{all:?}");
    assert!(found["unstable"].as_array().unwrap().is_empty());
}

#[test]
fn wrong_studies_of_attractors_and_sensitivities_are_refused() {
    for (words, expected) in [
        (&["study", "presser_foot", "--attractors"][..], "over one range"),
        (&["study", "presser_foot", "--attractors", "--sensitivity"], "cannot be used with"),
        (
            &["study", "presser_foot", "--starts", "3", "--over", "omega=3..4[1/s]:2"],
            "--attractors",
        ),
        (&["study", "batten", "--resonances"], "over one range"),
        (&["study", "table_drive", "--resonances", "--over", "c=1..2[N m/rad]:3"], "repeats"),
        (
            &["study", "batten", "--scene", "rigid", "--resonances", "--over", "n=3..4rpm:2"],
            "freely",
        ),
        (&["study", "selvedge_linkage", "--attractors", "--over", "l1=20..30mm:3"], "positions"),
        (
            &["study", "selvedge_linkage", "--rtol", "1e-8", "--sensitivity"],
            "a linkage takes no --rtol",
        ),
    ] {
        check_refused(words, &[expected], &folder("wrong_studies"));
    }
}

/// A linkage whose loops are solved together is looked at twice where parts of the way meet.
#[test]
fn measures_of_a_linkage_that_is_iterated() {
    let study = object(&["study", "heald_linkage", "--over", "s=39..41mm:3", "--format", "json"]);
    let twist = named(&study["measures"], "peak_twist")["values"].as_array().unwrap().clone();
    assert!(twist.len() == 3 && twist.iter().all(|one| one.as_f64().unwrap() > 0.0), "{study}");
    let run = object(&["run", "heald_linkage", "--scene", "loaded", "--format", "json"]);
    let alone = named(&run["measures"], "peak_twist")["value"].as_f64().unwrap();
    let middle = twist[1].as_f64().unwrap();
    assert!((alone - middle).abs() < 1e-9 * alone, "{alone} {middle}");
}
