//! Wrong requests: one message with place, reason and remedy, exit code 2, nothing written.

use std::fs::OpenOptions;

use super::{check_refused, command, folder, run};

#[test]
fn wrong_names() {
    let directory = folder("wrong_names");
    let cases: &[(&[&str], &[&str])] = &[
        (&["run"], &["needs a mechanism", "batten", "assur run batten"]),
        (&["scenes"], &["needs a mechanism", "assur scenes batten"]),
        (&["expand"], &["needs a mechanism"]),
        (&["run", "baten"], &["no mechanism `baten`", "did you mean `batten`?"]),
        (&["scenes", "baten"], &["did you mean `batten`?"]),
        (&["expand", "baten"], &["did you mean `batten`?"]),
        (&["run", "gearbox"], &["there are: batten"]),
        (&["run", "batten", "--scene", "exakt"], &["--scene exakt", "did you mean `exact`?"]),
        (&["expand", "batten", "--scene", "exakt"], &["did you mean `exact`?"]),
        (&["run", "batten", "--scene", "coupling"], &["is an effect", "--scene elastic"]),
        (&["run", "batten", "--scene", "K2"], &["alternative", "--scene first_order"]),
        (&["run", "batten", "--set", "m5=3kg"], &["no parameter `m5`", "did you mean `m"]),
        (&["run", "batten", "--set", "beta_t=1ms"], &["--scene damped"]),
        (&["run", "batten", "--set", "theta=1rad"], &["is driven", "--at theta"]),
        (&["run", "batten", "--scene", "rigid", "--set", "c=1"], &["no parameter `c`"]),
        (&["scenes", "batten", "--set", "m5=3kg"], &["no parameter `m5`"]),
        (&["run", "batten", "--method", "dop583"], &["--method dop583", "did you mean `dop853`?"]),
        (
            &["run", "batten", "--method", "euler"],
            &["auto, dop853, tsit5, taylor, radau, rosenbrock"],
        ),
        (&["run", "batten_table", "--preset", "idenity"], &["did you mean `identity`?"]),
        (&["run", "batten", "--curves", "phi"], &["--curves phi", "did you mean `phi2`?"]),
        (&["run", "batten", "--format", "xml"], &["table, json, csv"]),
        (&["run", "batten", "--fromat", "json"], &["--format"]),
        (&["frobnicate"], &["frobnicate"]),
        (&["check"], &["FILE.eqn"]),
    ];
    for (arguments, words) in cases {
        check_refused(arguments, words, &directory);
    }
}

#[test]
fn wrong_values() {
    let directory = folder("wrong_values");
    let cases: &[(&str, &[&str])] = &[
        ("n", &["NAME=VALUE", "--set n=300rpm"]),
        ("n=", &["NAME=VALUE"]),
        ("=3", &["NAME=VALUE"]),
        ("n=300", &["`n` needs a unit", "like rpm"]),
        ("n=300kg", &["wrong unit", "like rpm"]),
        ("n=300rmp", &["write it as"]),
        ("n=fast", &["write it as"]),
        ("lambda=1mm", &["wrong unit", "a pure number"]),
        ("n=NaNrpm", &["finite"]),
        ("n=infrpm", &["finite"]),
        ("n=1e999rpm", &["finite"]),
        ("n=0rpm", &["`n` cannot be 0 rpm", "1 rpm to 2000 rpm"]),
        ("n=-300rpm", &["`n` cannot be -300 rpm"]),
        ("m1=0kg", &["`m1` cannot be 0 kg"]),
        ("m1=-1kg", &["`m1` cannot be -1 kg"]),
        ("m1=1e99kg", &["`m1` cannot be"]),
        ("R=0mm", &["`R` cannot be 0 mm"]),
        ("R=-75mm", &["`R` cannot be -75 mm"]),
        ("R=300mm", &["--set R", "connecting rod has to be longer", "help:"]),
        ("d34=5e-6[m/N]", &["positive definite"]),
    ];
    for (set, words) in cases {
        check_refused(&["run", "batten", "--set", set], words, &directory);
    }
    let twice = ["run", "batten", "--set", "n=300rpm", "--set", "n=200rpm"];
    check_refused(&twice, &["`n` is given twice"], &directory);
}

#[test]
fn wrong_places() {
    let directory = folder("wrong_places");
    let cases: &[(&str, &[&str])] = &[
        ("theta", &["NAME=VALUE", "--at theta=110deg"]),
        ("thta=1", &["did you mean `theta`?"]),
        ("theta=1kg", &["wrong unit"]),
        ("theta=NaN", &["finite"]),
        ("time=1", &["needs a unit"]),
    ];
    for (at, words) in cases {
        check_refused(&["run", "batten", "--at", at], words, &directory);
    }
    let late = ["run", "batten", "--scene", "start", "--at", "time=100s"];
    check_refused(&late, &["from 0 s to 2.4 s"], &directory);
}

#[test]
fn tolerances_out_of_range() {
    let directory = folder("tolerances");
    for rtol in ["0", "-1e-9", "1", "1e-20", "nan", "inf", "small"] {
        let words = ["--rtol", "1e-14 to 1e-2", "help:"];
        check_refused(&["run", "batten", "--rtol", rtol], &words, &directory);
    }
}

#[test]
fn absolute_tolerances_that_cannot_be() {
    let directory = folder("absolute");
    let cases: [(&str, &[&str]); 6] = [
        ("phi2", &["--atol takes NAME=VALUE", "--atol 'phi2=1e-12[rad]'"]),
        ("phy2=1 rad", &["`phy2` is no state of scene `start`", "did you mean"]),
        ("phi2=1mm", &["`1mm` has the wrong unit for `phi2`"]),
        ("phi2=0", &["a tolerance of `phi2` is a number above 0"]),
        ("phi2=-1 rad", &["a tolerance of `phi2` is a number above 0"]),
        ("phi2=nan", &["help:"]),
    ];
    for (atol, words) in cases {
        let asked = ["run", "batten", "--scene", "start", "--atol", atol];
        check_refused(&asked, words, &directory);
    }
    let twice =
        ["run", "batten", "--scene", "start", "--atol", "phi2=1e-9 rad", "--atol", "phi2=1e-8 rad"];
    check_refused(&twice, &["the tolerance of `phi2` is given twice"], &directory);
    let linkage = ["run", "heald_linkage", "--atol", "phi4=1 deg"];
    check_refused(&linkage, &["a linkage takes no --atol"], &directory);
}

#[test]
fn outputs_that_cannot_be_written() {
    let directory = folder("outputs");
    std::fs::write(directory.join("file"), "kept").expect("writable");
    std::fs::create_dir(directory.join("folder")).expect("writable");
    for (option, path, words) in [
        ("--plot", "folder", "is a directory"),
        ("--plot", ".", "does not name a file"),
        ("--plot", "file/figure.svg", "is not a directory"),
        ("--out", "file", "is not a directory"),
    ] {
        check_refused(&["run", "batten", option, path], &[words, "help:"], &directory);
    }
    let both = ["run", "batten", "--plot", "a.svg", "--out", "b"];
    check_refused(&both, &["cannot be used with"], &directory);
    assert_eq!(std::fs::read(directory.join("file")).expect("there"), b"kept");
}

#[test]
fn a_wrong_request_keeps_the_figure_of_the_last_run() {
    let directory = folder("keeps");
    std::fs::write(directory.join("batten-elastic.svg"), "old").expect("writable");
    check_refused(&["run", "batten", "--set", "n=0rpm"], &["cannot be 0 rpm"], &directory);
    let kept = std::fs::read(directory.join("batten-elastic.svg"));
    assert_eq!(kept.expect("there"), b"old");
}

#[test]
fn numbers_that_are_none() {
    let directory = folder("numbers");
    let linkage: &[(&[&str], &[&str])] = &[
        (&["--places", "-1"], &["--places -1", "from 2 to 10000"]),
        (&["--places", "1e3"], &["--places 1e3", "whole number"]),
        (&["--places", ""], &["--places"]),
        (&["--samples", "nan"], &["--samples nan", "from 2 to"]),
        (&["--seed", "-7"], &["--seed -7", "from 0 to"]),
        (&["--allocate", "-1mrad"], &["positive"]),
    ];
    for (options, words) in linkage {
        let arguments = [&["tolerance", "heald_linkage"], *options].concat();
        check_refused(&arguments, words, &directory);
    }
    for (option, value) in [("--threads", "-1"), ("--samples", "-5"), ("--seed", "1.5")] {
        let mut arguments = vec!["study", "needle_impact", "--scene", "made", option, value];
        if option != "--samples" {
            arguments.extend(["--samples", "10"]);
        }
        let place = format!("{option} {value}");
        check_refused(&arguments, &[&place, "whole number", "choose from"], &directory);
    }
    let study = |over: &'static str| ["study", "presser_foot", "--over", over];
    let example = "--over 'omega=200..400[1/s]:41'";
    check_refused(&study("omega=1..2:2"), &["needs a unit", example], &directory);
    check_refused(&study("omega=400..nan[1/s]:2"), &["finite number", "`nan[1/s]`"], &directory);
}

#[test]
fn angles_that_are_no_angles() {
    let directory = folder("angles");
    for (at, words) in [
        ("phi4=90 deg deg", &["product of angles", "phi4=90deg"][..]),
        ("phi4=90 deg rad", &["product of angles"]),
        ("phi4=1e17deg", &["rounded to 0.02 turns", "within a turn"]),
        ("phi4=-1e300deg", &["within a turn"]),
    ] {
        for subcommand in ["run", "modes", "tolerance", "draw"] {
            let arguments = [subcommand, "heald_linkage", "--at", at];
            check_refused(&arguments, words, &directory);
        }
    }
    let far = ["run", "batten", "--at", "time=1e17s"];
    check_refused(&far, &["rounded to", "periods"], &directory);
}

#[test]
fn a_place_is_printed_once() {
    let directory = folder("place_once");
    for at in ["", "phi4", "phi4=90deg,,", ",phi4=90deg"] {
        let output = run(&["run", "heald_linkage", "--at", at], &directory);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(complaint.matches(" where: ").count(), 1, "{complaint}");
        assert!(complaint.contains(&format!("--at {at}\n")), "{complaint}");
    }
}

/// Whatever is typed, the message about it can be read.
#[test]
fn long_and_strange_words() {
    let directory = folder("long_words");
    let long = "x".repeat(100_000);
    let [set, option, at] = [format!("n={long}"), format!("--{long}"), format!("{long}=1deg")];
    let cases: [&[&str]; 9] = [
        &["run", &long],
        &["run", "batten", &option],
        &["run", "batten", "--scene", &long],
        &["run", "batten", "--set", &set],
        &["run", "batten", "--at", &at],
        &["run", "batten", "--curves", &long],
        &["run", "batten", "--format", &long],
        &["run", "batten", "--plot", &long],
        &["check", &long],
    ];
    for arguments in cases {
        check_refused(arguments, &["error: "], &directory);
        let complaint = run(arguments, &directory).stderr;
        assert!(complaint.len() < 6000, "{} bytes", complaint.len());
    }
    for name in ["", "  "] {
        check_refused(&["run", name], &["name of the mechanism is empty"], &directory);
    }
    check_refused(&["run", "b\u{e4}tten"], &["did you mean `batten`?"], &directory);
    check_refused(&["run", "bat\u{1b}[31mten"], &["`bat\\u{1b}[31mten`"], &directory);
}

/// Every subcommand says when its answer could not be printed.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let directory = folder("full_disk");
    for arguments in [
        &["list"][..],
        &["--help"],
        &["run", "--help"],
        &["--version"],
        &["run", "batten", "--format", "csv"],
        &["structure", "heald_linkage"],
        &["expand", "batten"],
    ] {
        let full = OpenOptions::new().write(true).open("/dev/full");
        let output = command(arguments, &directory)
            .stdout(full.expect("a device"))
            .output()
            .expect("the command starts");
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {complaint}");
        assert!(complaint.contains("standard output"), "{complaint}");
    }
}

/// What is around the command does not matter to it.
#[test]
fn bare_surroundings() {
    let directory = folder("surroundings");
    for columns in ["20", "0", "-1", "x"] {
        let output = command(&["run", "batten", "--format", "json"], &directory)
            .env_clear()
            .envs([("TERM", "dumb"), ("COLUMNS", columns)])
            .output()
            .expect("the command starts");
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{complaint}");
        assert_eq!(complaint, "");
    }
}
