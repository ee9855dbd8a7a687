//! Wrong requests: one message with place, reason and remedy, exit code 2, nothing written.

use super::{check_refused, folder};

#[test]
fn wrong_names() {
    let directory = folder("wrong_names");
    let cases: &[(&[&str], &[&str])] = &[
        (
            &["run"],
            &["needs a mechanism", "batten", "assur run batten"],
        ),
        (&["scenes"], &["needs a mechanism", "assur scenes batten"]),
        (&["expand"], &["needs a mechanism"]),
        (
            &["run", "baten"],
            &["no mechanism `baten`", "did you mean `batten`?"],
        ),
        (&["scenes", "baten"], &["did you mean `batten`?"]),
        (&["expand", "baten"], &["did you mean `batten`?"]),
        (&["run", "gearbox"], &["there are: batten"]),
        (
            &["run", "batten", "--scene", "exakt"],
            &["--scene exakt", "did you mean `exact`?"],
        ),
        (
            &["expand", "batten", "--scene", "exakt"],
            &["did you mean `exact`?"],
        ),
        (
            &["run", "batten", "--scene", "coupling"],
            &["is an effect", "--scene elastic"],
        ),
        (
            &["run", "batten", "--scene", "K2"],
            &["alternative", "--scene first_order"],
        ),
        (
            &["run", "batten", "--set", "m5=3kg"],
            &["no parameter `m5`", "did you mean `m"],
        ),
        (
            &["run", "batten", "--set", "beta_t=1ms"],
            &["--scene damped"],
        ),
        (
            &["run", "batten", "--set", "theta=1rad"],
            &["is driven", "--at theta"],
        ),
        (
            &["run", "batten", "--scene", "rigid", "--set", "c=1"],
            &["no parameter `c`"],
        ),
        (
            &["scenes", "batten", "--set", "m5=3kg"],
            &["no parameter `m5`"],
        ),
        (
            &["run", "batten", "--method", "dop583"],
            &["--method dop583", "did you mean `dop853`?"],
        ),
        (
            &["run", "batten", "--method", "euler"],
            &["dop853, tsit5, taylor, radau, rosenbrock, auto"],
        ),
        (
            &["run", "batten_table", "--preset", "idenity"],
            &["did you mean `identity`?"],
        ),
        (
            &["run", "batten", "--curves", "phi"],
            &["--curves phi", "did you mean `phi2`?"],
        ),
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
        (
            "R=300mm",
            &["--set R", "connecting rod has to be longer", "help:"],
        ),
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
        check_refused(
            &["run", "batten", option, path],
            &[words, "help:"],
            &directory,
        );
    }
    let both = ["run", "batten", "--plot", "a.svg", "--out", "b"];
    check_refused(&both, &["cannot be used with"], &directory);
    assert_eq!(
        std::fs::read(directory.join("file")).expect("there"),
        b"kept"
    );
}

#[test]
fn a_wrong_request_keeps_the_figure_of_the_last_run() {
    let directory = folder("keeps");
    std::fs::write(directory.join("batten-elastic.svg"), "old").expect("writable");
    check_refused(
        &["run", "batten", "--set", "n=0rpm"],
        &["cannot be 0 rpm"],
        &directory,
    );
    let kept = std::fs::read(directory.join("batten-elastic.svg"));
    assert_eq!(kept.expect("there"), b"old");
}
