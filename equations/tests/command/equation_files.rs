//! `assur check` and `assur expand` on files, right and wrong.

use super::{answer, check_refused, folder, run};

/// An oscillator that is right.
const RIGHT: &str = "assur::mechanism! {
    /// A mass on a spring.
    Oscillator from \"a test\";
    /// The mass.
    parameter m = 2 kg in 1 g .. 1 t;
    /// The spring.
    parameter k = 50 [N/m] in 1 [N/m] .. 1e6 [N/m];
    coordinate x: m = 10 mm;
    motion swing: m*ddot(x) + k*x = 0 N;
    output x;
    /// Free swinging.
    scene free { run time 0 s .. 1 s; }
}
";

/// The right file with one piece replaced.
#[track_caller]
fn with(piece: &str, replacement: &str) -> Vec<u8> {
    assert!(RIGHT.contains(piece));
    RIGHT.replace(piece, replacement).into_bytes()
}

#[test]
fn a_right_file_is_summed_up() {
    let directory = folder("right");
    std::fs::write(directory.join("right.eqn"), RIGHT).expect("writable");
    let text = answer(&["check", "right.eqn"], &directory);
    assert!(text.starts_with("right.eqn: no error\n"), "{text}");
    let row = text.lines().last().unwrap_or("");
    let cells: Vec<_> = row.split_whitespace().collect();
    assert_eq!(cells[..3], ["free", "2", "1"], "{text}");
}

#[test]
fn a_file_is_tested_without_being_compiled() {
    let directory = folder("tested");
    let file = with("    output x;", "    output x;\n    expect at time = 0 s: x = 10 mm +- 1 um;");
    std::fs::write(directory.join("right.eqn"), &file).expect("writable");
    let text = answer(&["test", "right.eqn"], &directory);
    let tests = "free: jacobian ... ok\nfree: scaling ... ok\nfree: x at time = 0 s ... ok\n";
    assert_eq!(text, format!("{tests}\n3 tests, all passed\n"));
    let wrong = String::from_utf8(file).expect("text").replace("x = 10 mm +-", "x = 11 mm +-");
    std::fs::write(directory.join("wrong.eqn"), wrong).expect("writable");
    let output = run(&["test", "wrong.eqn", "--scene", "free"], &directory);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("x at time = 0 s ... FAILED\n"), "{text}");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(complaint.starts_with("error: 1 of 3 tests failed"), "{complaint}");
}

#[test]
fn a_warning_is_no_error() {
    let directory = folder("warning");
    let file = with("    output x;", "    let unused = 2*x;\n    output x;");
    std::fs::write(directory.join("warned.eqn"), file).expect("writable");
    let output = run(&["check", "warned.eqn"], &directory);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{complaint}");
    assert!(complaint.contains("warned.eqn:10:"), "{complaint}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("1 warning"));
}

#[test]
fn wrong_files_are_refused_with_their_place() {
    let directory = folder("wrong");
    let deep = format!("k = {}50{} [N/m]", "(".repeat(100_000), ")".repeat(100_000));
    let mut large = with("m*ddot(x)", "m*ddot(x) // ");
    large.resize(10_000_000, b'x');
    let cases: &[(&str, Vec<u8>, &[&str])] = &[
        ("syntax", with("m = 2 kg", "m = = kg"), &["syntax.eqn:5:", "error"]),
        ("units", with("k*x", "k*m"), &["units.eqn:9:"]),
        ("name", with("k*x", "q*x"), &["name.eqn:9:", "`q`"]),
        ("unknown_unit", with("2 kg", "2 kgg"), &["unknown_unit.eqn:5:", "kgg"]),
        ("empty", Vec::new(), &["empty.eqn", "the file is empty"]),
        ("blank", b" \n\n".to_vec(), &["the file is empty"]),
        ("comment", b"// nothing\n".to_vec(), &["assur::mechanism!"]),
        ("binary", vec![0, 159, 146, 150, 0, 1], &["binary.eqn", "is binary"]),
        ("latin", b"assur::mechanism! { \xe9 }".to_vec(), &["UTF-8"]),
        ("large", large, &["large.eqn", "9.5 MiB", "1 MiB"]),
        ("deep", with("k = 50 [N/m]", &deep).to_vec(), &["deep.eqn:7:", "nested"]),
        ("open", RIGHT.trim_end().trim_end_matches('}').into(), &["never closed"]),
        (
            "effect",
            with("scene free {", "scene free = friction {"),
            &["effect.eqn:12:", "friction"],
        ),
        (
            "itself",
            with("    output x;", "    let y = y + 1;\n    output y;"),
            &["itself.eqn:10:", "`y`"],
        ),
        (
            "unbalanced",
            with("    motion swing", "    coordinate z: m = 0;\n    motion swing"),
            &["unbalanced.eqn:", "ddot(z)"],
        ),
    ];
    for (name, contents, words) in cases {
        let file = format!("{name}.eqn");
        std::fs::write(directory.join(&file), contents).expect("writable");
        check_refused(&["check", &file], words, &directory);
        check_refused(&["expand", &file], words, &directory);
    }
    check_refused(&["check", "nowhere.eqn"], &["cannot read `nowhere.eqn`"], &directory);
    check_refused(&["check", "."], &["cannot read `.`"], &directory);
}

#[test]
fn one_wrong_file_of_two_is_enough() {
    let directory = folder("two");
    std::fs::write(directory.join("right.eqn"), RIGHT).expect("writable");
    std::fs::write(directory.join("wrong.eqn"), with("k*x", "q*x")).expect("writable");
    let output = run(&["check", "wrong.eqn", "right.eqn"], &directory);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("wrong.eqn: 1 error"));
    assert!(String::from_utf8_lossy(&output.stdout).contains("right.eqn: no error"));
}

#[test]
fn emitted_rust_is_laid_out() {
    let directory = folder("expand");
    std::fs::write(directory.join("right.eqn"), RIGHT).expect("writable");
    for arguments in [&["expand", "right.eqn"][..], &["expand", "batten", "--scene", "torsion"]] {
        let text = answer(arguments, &directory);
        syn::parse_file(&text).expect("Rust");
        assert!(text.contains("\n    "), "it is indented");
    }
    let whole = answer(&["expand", "batten"], &directory);
    assert!(whole.contains("pub struct Elastic") && whole.contains("MECHANISM"));
    let one = answer(&["expand", "batten", "--scene", "torsion"], &directory);
    assert!(one.contains("pub struct Torsion") && !one.contains("pub struct Elastic"));
}

/// Two springs of a file of their own.
const PAIR: &str = "assur::mechanism! {
    /// A mass between springs.
    Hung;
    parameter m = 2 kg;
    coordinate y: m = 10 mm;
    part first: Spring from \"parts/spring.eqn\" { x = y; }
    part second: Spring from \"parts/spring.eqn\" { x = 2*y; k = 9 [N/m]; }
    motion fall: m*ddot(y) = -first.force - 2*second.force;
    output first.force;
    scene free { run time 0 s .. 1 s; }
}
";

const SPRING: &str = "assur::mechanism! {
    /// A spring.
    Spring;
    parameter k = 8 [N/m];
    driver x = 0 m;
    output force = k*x;
}
";

#[test]
fn parts_are_read_from_beside_the_file() {
    let directory = folder("parts");
    std::fs::create_dir(directory.join("own")).expect("writable");
    std::fs::create_dir(directory.join("own/parts")).expect("writable");
    let [pair, spring] = ["own/pair.eqn", "own/parts/spring.eqn"].map(|path| directory.join(path));
    std::fs::write(&pair, PAIR).expect("writable");
    std::fs::write(&spring, SPRING).expect("writable");
    let text = answer(&["check", "own/pair.eqn"], &directory);
    assert!(text.starts_with("own/pair.eqn: no error\n"), "{text}");
    let text = answer(&["expand", "own/pair.eqn"], &directory);
    assert!(text.contains("pub second_k: f64"), "{text}");
    assert!(text.contains("include_str!(\"parts/spring.eqn\")"), "{text}");

    std::fs::write(&spring, SPRING.replace("k*x", "k*x + k")).expect("writable");
    let words = ["own/parts/spring.eqn:6:20", "6 |     output force = k*x + k;"];
    check_refused(&["check", "own/pair.eqn"], &words, &directory);
    std::fs::write(&spring, SPRING.replace("force", "power")).expect("writable");
    let words = ["own/pair.eqn:8:", "`first.force`"];
    check_refused(&["check", "own/pair.eqn"], &words, &directory);
    std::fs::write(&spring, SPRING.replace("8 [N/m]", "8 [N]")).expect("writable");
    let words = ["own/pair.eqn:7:", "own/parts/spring.eqn:4:", "what its file says"];
    check_refused(&["check", "own/pair.eqn"], &words, &directory);
    std::fs::write(&spring, SPRING.replace("k*x;", "(k*x;")).expect("writable");
    let words = ["own/pair.eqn:6:", "parts/spring.eqn:7:1: found `}`"];
    check_refused(&["check", "own/pair.eqn"], &words, &directory);
    std::fs::remove_file(&spring).expect("writable");
    let words = ["own/pair.eqn:6:", "there is no file `parts/spring.eqn`"];
    check_refused(&["check", "own/pair.eqn"], &words, &directory);
}
