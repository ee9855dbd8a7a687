//! Equation files that nobody has compiled, where a mechanism is named; and scenes that no file states.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use serde_json::Value;

use crate::{answer, command, folder, json, run};

/// The equation file of a mechanism that comes with Assur.
fn shipped(name: &str) -> String {
    format!("{}/src/{name}.eqn", env!("CARGO_MANIFEST_DIR"))
}

/// What an answer says but for the name of the mechanism and the time that it took.
fn timeless(mut value: Value) -> Value {
    fn clean(value: &mut Value) {
        match value {
            Value::Object(map) => {
                map.retain(|key, _| !key.contains("seconds"));
                map.values_mut().for_each(clean);
            }
            Value::Array(list) => list.iter_mut().for_each(clean),
            _ => {}
        }
    }
    clean(&mut value);
    value["mechanism"]["name"] = Value::Null;
    value
}

/// A file answers bit for bit what the same compiled says.
#[test]
fn a_file_answers_as_the_compiled_mechanism_does() {
    let here = folder("files-as-compiled");
    for (name, options) in [
        ("batten", &["--scene", "elastic"][..]),
        ("batten", &["--scene", "exact", "--method", "taylor"]),
        ("table_drive", &[]),
        ("presser_foot", &["--set", "omega=300[1/s]"]),
        ("heald_linkage", &["--at", "phi4=75deg"]),
        ("sewing_feed", &[]),
        ("lamp_arm", &[]),
        ("simple_pendulum", &[]),
        ("cam", &[]),
        ("burnishing", &[]),
        ("gear_flank", &[]),
    ] {
        let file = shipped(name);
        let [compiled, read] =
            [name, &file].map(|name| timeless(json(&[&["run", name], options].concat(), &here)));
        assert_eq!(compiled, read, "{name} {options:?}");
    }
}

/// Every command takes a file, and calls what it writes after it.
#[test]
fn every_command_takes_a_file() {
    let here = folder("files-everywhere");
    answer(&["new", "press", "--like", "linkage"], &here);
    let says = |words: &[&str], expected: &str| {
        let text = answer(words, &here);
        assert!(text.contains(expected), "{words:?}: {text}");
    };
    says(&["run", "press.eqn"], "Figure: press-turn.svg");
    says(&["draw", "press.eqn"], "press-turn-moving.svg");
    says(&["structure", "press.eqn"], "RRR dyad");
    says(&["modes", "press.eqn", "--at", "phi=90deg"], "2 ");
    says(&["tolerance", "press.eqn", "--at", "phi=90deg"], "psi");
    says(&["scenes", "press.eqn"], "turn");
    says(&["expand", "press.eqn"], "pub struct Turn");
    says(&["check", "press.eqn"], "no error");
    says(&["list", "."], "./press.eqn");
    answer(&["new", "swing"], &here);
    says(&["study", "swing.eqn", "--over", "k=500..1000[N/m]:3"], "F_max");
}

/// What `assur new` writes runs as it is, whatever it is like, and is never written over.
#[test]
fn new_files_run() {
    let here = folder("files-new");
    for like in ["motion", "linkage", "hybrid", "formula"] {
        let file = format!("my_{like}.eqn");
        answer(&["new", &format!("my_{like}"), "--like", like], &here);
        let checked = run(&["check", &file], &here);
        let messages = String::from_utf8_lossy(&checked.stderr);
        assert!(checked.status.success() && !messages.contains("warning"), "{like}: {messages}");
        answer(&["run", &file], &here);
    }
    let before = fs::read_to_string(here.join("my_motion.eqn")).unwrap();
    let again = run(&["new", "MyMotion", "--like", "formula"], &here);
    assert_eq!(again.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&again.stderr).contains("is there already"));
    assert_eq!(fs::read_to_string(here.join("my_motion.eqn")).unwrap(), before);
    assert_eq!(run(&["new", "1st"], &here).status.code(), Some(2));
    answer(&["new", "hammer", "--like", "hybrid", "--crate"], &here);
    let program = fs::read_to_string(here.join("hammer/src/main.rs")).unwrap();
    assert!(program.contains("use hammer::Fall;") && program.contains("\"hammer.eqn\""));
    answer(&["new", "c_press"], &here);
    assert!(here.join("c_press.eqn").is_file());
    for file in ["Cargo.toml", "src/main.rs", "src/hammer.eqn"] {
        assert!(here.join("hammer").join(file).is_file(), "{file}");
    }
    assert_eq!(run(&["new", "hammer", "--crate"], &here).status.code(), Some(2));
}

/// Changes become a scene without a name, for mechanisms that are compiled and for files.
#[test]
fn scenes_are_changed_at_the_command_line() {
    let here = folder("files-changes");
    answer(&["new", "swing"], &here);
    let of = |words: &[&str]| json(&[&["run", "swing.eqn"], words].concat(), &here);
    let found = of(&["--with", "damping", "--run", "0s..1s", "--start", "x=3mm"]);
    assert_eq!(found["scene"]["name"], "unnamed");
    assert_eq!(found["scene"]["effects"], serde_json::json!(["damping"]));
    let changes = ["with damping;", "start x = 3 mm;", "run time 0 s .. 1 s;"];
    assert_eq!(found["scene"]["changes"], serde_json::json!(changes));
    // The same as the steady scene of the file without its task, and the other way round.
    // Another kind of scene is looked for where the first one is none.
    answer(&["new", "press", "--like", "linkage"], &here);
    let modes = answer(&["modes", "press.eqn", "--sweep", "phi", "--at", "phi=90deg"], &here);
    assert!(modes.contains("2 assembly modes"), "{modes}");
    let study = ["study", "swing.eqn", "--with", "damping", "--over", "k=500..1000[N/m]:3"];
    assert_eq!(json(&study, &here)["scene"]["name"], "unnamed");
    let steady = of(&["--with", "damping", "--periodic", "0.5s"]);
    let stated = of(&["--scene", "steady"]);
    assert_eq!(steady["measures"], stated["measures"]);
    let bare = of(&["--scene", "steady", "--without", "damping", "--run", "0s..3s"]);
    assert_eq!(bare["measures"], of(&["--scene", "start"])["measures"]);
    let shipped = |words: &[&str]| json(&[&["run", "batten"], words].concat(), &here);
    let exact = shipped(&["--scene", "nonlinear", "--choose", "crank=exact"]);
    let stated = shipped(&["--scene", "exact"]);
    assert_eq!(exact["motion"], stated["motion"]);
    assert_eq!(exact["multipliers"], stated["multipliers"]);
    let swept = json(&["run", "heald_linkage", "--sweep", "phi4=70deg..80deg"], &here);
    assert_eq!(swept["scene"]["name"], "unnamed");
}

/// An assembly mode is picked by its number, or by where something starts; tolerances have their distribution.
#[test]
fn modes_and_tolerances_are_chosen_at_the_command_line() {
    let here = folder("files-modes");
    let modes = json(&["modes", "heald_linkage"], &here);
    let listed = modes["places"][0]["modes"].as_array().expect("a list");
    assert_eq!(listed.len(), 4);
    let value = |of: &Value, name: &str| {
        let all = of["results"].as_array().expect("a list");
        let found = all.iter().find(|one| one["name"] == name).expect("a value");
        found["value"].as_f64().expect("a number")
    };
    for number in ["1", "2", "3", "4"] {
        let words = ["run", "heald_linkage", "--mode", number, "--at", "phi4=90deg"];
        let found = json(&words, &here);
        let index: usize = number.parse().unwrap();
        for name in ["phi5", "phi6", "phi7"] {
            let [found, listed] = [&found["at"][0], &listed[index - 1]].map(|one| value(one, name));
            assert!((found - listed).abs() < 1e-9, "{number}: {name} = {found}, not {listed}");
        }
    }
    let drawn = answer(&["draw", "heald_linkage", "--mode", "3"], &here);
    assert!(drawn.contains("Changed:   start phi5"), "{drawn}");
    let words = ["tolerance", "heald_linkage", "--mode", "3", "--at", "phi4=90deg"];
    let other = json(&[&words[..], &["--tolerance", "l4=1% lognormal"]].concat(), &here);
    let l4 = other["contributions"].as_array().expect("a list").iter();
    let l4 = l4.clone().find(|one| one["name"] == "l4").expect("a contribution");
    assert_eq!((&l4["distribution"], &l4["half_width"]), (&"lognormal".into(), &0.9.into()));
    let study = ["study", "swing.eqn", "--samples", "50", "--tolerance", "k=30% lognormal"];
    answer(&["new", "swing"], &here);
    let made = json(&study, &here);
    assert!(made.to_string().contains("lognormal"), "{made}");
}

/// What is wrong at the command line is told with an excerpt of it.
#[test]
fn wrong_changes_are_told() {
    let here = folder("files-wrong");
    answer(&["new", "swing"], &here);
    answer(&["new", "press", "--like", "linkage"], &here);
    fs::write(here.join("binary.eqn"), b"\0\x01").unwrap();
    fs::write(here.join("long.eqn"), vec![b' '; 10 << 20]).unwrap();
    fs::write(
        here.join("ring.eqn"),
        "assur::mechanism! { Ring; part r: Ring from \"ring.eqn\" {} }",
    )
    .unwrap();
    fs::write(
        here.join("lone.eqn"),
        "assur::mechanism! {
            Lone from \"made up\";
            parameter m = 1 kg;
            coordinate x: m = 0 m;
            kinetic m*dot(x)^2/2;
            effect more \"a coordinate without an equation\" { coordinate y: m = 0 m; output y; }
            output x;
            scene alone { run time 0 s .. 1 s; }
        }",
    )
    .unwrap();
    for (words, expected) in [
        (&["run", "swing.eqn", "--with", "dampng"][..], "did you mean `damping`"),
        (&["run", "swing.eqn", "--without", "coupling"], "there is no effect `coupling`"),
        (&["run", "swing.eqn", "--choose", "spring=soft"], "unknown choice `spring`"),
        (&["run", "swing.eqn", "--choose", "soft"], "takes NAME=VALUE"),
        (&["run", "swing.eqn", "--start", "y=3mm"], "`y`"),
        (&["run", "swing.eqn", "--start", "x=3kg"], "kg"),
        (&["run", "swing.eqn", "--start", "x"], "takes NAME=VALUE"),
        (&["run", "swing.eqn", "--run", "2s"], "is no range"),
        (&["run", "swing.eqn", "--run", "0s..2mm"], "mm"),
        (&["run", "swing.eqn", "--scene", "nix"], "has no scene `nix`"),
        (&["run", "press.eqn", "--sweep", "chi=1deg..2deg"], "`chi`"),
        (&["run", "none.eqn"], "cannot read `none.eqn`"),
        (&["run", "."], "is a directory"),
        (&["run", "swing"], "a file is named with its ending"),
        (&["run", "swing.eqn", "--scene", "nix", "--with", "damping"], "has no scene `nix`"),
        (&["run", "swing.eqn", "--scene", "start", "--set", "d=3"], "it belongs to --scene steady"),
        (&["run", "lone.eqn", "--with", "more"], "nothing determines `ddot(y)`"),
        (&["run", "simple_pendulum", "--start", "x=0.5m"], "the closures say"),
        (&["run", "simple_pendulum", "--mode", "1"], "where start values pick the assembly mode"),
        (&["run", "heald_linkage", "--mode", "5"], "there are 4 at phi4 = 90 deg"),
        (&["run", "heald_linkage", "--mode", "0"], "choose from 1"),
        (&["run", "heald_linkage", "--start", "l4=3mm"], "can be started"),
        (&["tolerance", "heald_linkage", "--tolerance", "l4=1mm odd"], "is not a value of `l4`"),
        (&["tolerance", "heald_linkage", "--tolerance", "l4=-1%"], "is no tolerance of `l4`"),
        (&["new", "loop"], "is no word of Rust"),
        (&["run", "binary.eqn"], "binary"),
        (&["run", "long.eqn"], "at most 1 MiB"),
        (&["run", "ring.eqn"], "ring"),
        (&["run", "batten", "--watch"], "only a file can be watched"),
        (&["list", "nowhere"], "nowhere"),
    ] {
        let output = run(words, &here);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {complaint}");
        assert!(complaint.contains(expected), "{words:?}: {complaint}");
        assert!(!complaint.contains("panicked"), "{words:?}: {complaint}");
    }
}

/// Standard input is a file too, and a part may lie in another folder.
#[test]
fn standard_input_and_parts_elsewhere() {
    let here = folder("files-input");
    let pendulum = fs::read(shipped("simple_pendulum")).unwrap();
    let mut child = command(&["run", "-", "--format", "json"], &here)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&pendulum).unwrap();
    let output = child.wait_with_output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let compiled = json(&["run", "simple_pendulum"], &here);
    assert_eq!(timeless(found), timeless(compiled));
    let parts = here.join("parts");
    fs::create_dir_all(&parts).unwrap();
    let mut text = fs::read_to_string(shipped("sewing_feed")).unwrap();
    for part in ["feed_rack", "feed_lift", "feed_stitch"] {
        fs::copy(shipped(part), parts.join(format!("{part}.eqn"))).unwrap();
        text = text.replace(&format!("\"{part}.eqn\""), &format!("\"parts/{part}.eqn\""));
    }
    fs::write(here.join("feed.eqn"), text).unwrap();
    let found = timeless(json(&["run", "feed.eqn"], &here));
    assert_eq!(found, timeless(json(&["run", "sewing_feed"], &here)));
}

/// What is no file is told at once: of a pipe nobody may ever write the end.
#[cfg(unix)]
/// A four-bar whose rocker swings between the two positions in which crank and coupler are in line.
const BAR: &str = "assur::mechanism! {
    Bar from \"a test\";
    dimension a = 20 mm, b = 60 mm, c = 50 mm, d = 70 mm;
    driver phi ~ 0 deg in -180 deg .. 180 deg;
    dependent theta ~ 30 deg, psi ~ 90 deg;
    closure loops: a*dir(phi) + b*dir(theta) = [d, 0 mm] + c*dir(psi);
    output psi;
    measure swing = peak(psi) - lowest(psi) [deg], last = value(psi, end) [deg];
    scene turn { sweep phi; }
}
";

#[test]
fn measures_of_parts_are_there_for_the_whole() {
    let directory = folder("measured_parts");
    fs::write(directory.join("bar.eqn"), BAR).expect("writable");
    let whole = "assur::mechanism! {
    Two from \"a test\";
    driver phi ~ 0 deg in -180 deg .. 180 deg;
    part first: Bar from \"bar.eqn\" { phi = phi; }
    part second: Bar from \"bar.eqn\" { phi = -phi; a = 15 mm; }
    output psi = first.psi;
    measure swing = first.swing [deg], ratio = first.swing/second.swing;
    scene turn { sweep phi; }
}
";
    fs::write(directory.join("two.eqn"), whole).expect("writable");
    let found = json(&["run", "two.eqn"], &directory);
    let measures = found["measures"].as_array().expect("measures");
    let [swing, ratio] = [0, 1].map(|index| measures[index]["value"].as_f64().expect("a number"));
    let swing_of = |a: f64| {
        let angle = |side: f64| ((7400.0 - side * side) / 7000.0).acos().to_degrees();
        angle(60.0 + a) - angle(60.0 - a)
    };
    assert!((swing - swing_of(20.0)).abs() < 1e-9, "{swing}");
    assert!((ratio - swing_of(20.0) / swing_of(15.0)).abs() < 1e-11, "{ratio}");
    assert_eq!(measures.len(), 2);
}

#[test]
fn pipes_are_no_files() {
    let here = folder("files-pipe");
    let made = std::process::Command::new("mkfifo").arg(here.join("pipe.eqn")).status();
    assert!(made.is_ok_and(|status| status.success()));
    let output = run(&["run", "pipe.eqn"], &here);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("it is no file"));
}

/// A watched file runs again at each change, and goes on after a mistake.
#[cfg(unix)]
#[test]
fn watched_files_run_again() {
    use std::io::{BufRead, BufReader};
    let here = folder("files-watch");
    answer(&["new", "swing"], &here);
    let path = here.join("swing.eqn");
    let right = fs::read_to_string(&path).unwrap();
    let mut child = command(&["run", "swing.eqn", "--watch"], &here)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map(Result::unwrap);
    let mut until = |wanted: &str| {
        let mut seen = Vec::new();
        for line in lines.by_ref() {
            let found = line.contains(wanted);
            seen.push(line);
            if found {
                return seen.join("\n");
            }
        }
        panic!("no `{wanted}` in {seen:?}");
    };
    assert!(until("watching swing.eqn").contains("Figure: swing-start.svg"));
    fs::write(&path, right.replace("m = 2 kg", "m = 2 s")).unwrap();
    assert!(!until("watching swing.eqn").contains("Figure"));
    fs::remove_file(&path).unwrap();
    assert!(!until("watching swing.eqn").contains("Figure"));
    fs::write(&path, right.replace("m = 2 kg", "m = 3 kg")).unwrap();
    assert!(until("watching swing.eqn").contains("Figure: swing-start.svg"));
    child.kill().unwrap();
    child.wait().unwrap();
}
