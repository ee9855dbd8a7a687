//! Callers that must not compile, and one that is warned, each with the messages of rustc beside it. `ASSUR_BLESS=1` writes them anew.
//!
//! rustc is called directly with the libraries that cargo has just built: no second workspace, nothing to download.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// Where cargo put the libraries that this test was linked with.
fn libraries() -> PathBuf {
    let own = std::env::current_exe().expect("the test has a path");
    own.parent().expect("it lies in a folder").to_owned()
}

/// The facade that cargo built last. The one of this build is newer than its sources, and so is every newer one.
fn facade(folder: &Path) -> PathBuf {
    let entries = folder.read_dir().expect("the folder can be read");
    let built = entries.flatten().filter(|entry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        name.starts_with("libassur-") && name.ends_with(".rlib")
    });
    let age = |entry: &std::fs::DirEntry| {
        let data = entry.metadata().and_then(|data| data.modified());
        data.unwrap_or(SystemTime::UNIX_EPOCH)
    };
    built.max_by_key(age).expect("cargo has built the facade").path()
}

/// What rustc writes.
fn output(name: &str, extension: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.{extension}"))
}

/// What rustc says about a file; whether it accepts it.
fn compile(name: &str) -> (String, bool) {
    compile_with(name, &[])
}

/// The same with further arguments of rustc.
fn compile_with(name: &str, arguments: &[&str]) -> (String, bool) {
    let libraries = libraries();
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui"))
        .args(["--edition=2024", "--crate-type=lib", "--color=never"])
        .arg(format!(
            "--emit=metadata={},dep-info={}",
            output(name, "rmeta").display(),
            output(name, "d").display()
        ))
        .arg("--extern")
        .arg(format!("assur={}", facade(&libraries).display()))
        .arg("-L")
        .arg(format!("dependency={}", libraries.display()))
        .args(arguments)
        .arg(format!("{name}.rs"))
        .output()
        .expect("rustc can be started");
    let said = String::from_utf8_lossy(&output.stderr).replace("\r\n", "\n");
    (said, output.status.success())
}

#[track_caller]
fn check(name: &str) {
    let (found, accepted) = compile(name);
    assert!(!accepted, "{name}.rs compiles\n{found}");
    check_messages(name, &found);
}

#[track_caller]
fn check_warned(name: &str) {
    let (found, accepted) = compile(name);
    assert!(accepted, "{name}.rs does not compile\n{found}");
    check_messages(name, &found);
}

#[track_caller]
fn check_messages(name: &str, found: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/ui/{name}.stderr"));
    if std::env::var_os("ASSUR_BLESS").is_some() {
        std::fs::write(&path, found).expect("the messages can be written");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(found == expected, "{name}.rs: rustc says\n{found}\nexpected\n{expected}");
}

#[test]
fn units_have_to_balance() {
    check("wrong_unit");
}

#[test]
fn what_would_not_see_events_does_not_take_a_scene_that_has_some() {
    check("unseen_events");
}

#[test]
fn a_name_has_to_be_declared() {
    check("unknown_name");
}

#[test]
fn a_scene_has_as_many_equations_as_unknowns() {
    check("unbalanced");
}

#[test]
fn a_file_has_to_be_there() {
    check("missing_file");
}

#[test]
fn a_scene_has_its_own_parameters() {
    check("foreign_parameter");
}

#[test]
fn mistakes_are_underlined_in_the_equation_file() {
    check("in_file");
}

#[test]
fn what_is_not_used_is_a_warning_in_the_equation_file() {
    check_warned("unused");
}

/// The `cfg`s that cargo declares are all that the crate of a user knows, and nothing that is emitted may ask for others.
#[test]
fn the_crate_of_a_user_sees_no_warning() {
    let declared = "--check-cfg=cfg(docsrs,test)";
    for arguments in [&[declared][..], &[declared, "--test"]] {
        let (found, accepted) = compile_with("right_crate", arguments);
        assert!(accepted && found.is_empty(), "{arguments:?}: {found}");
    }
}

/// A reader of equations has used nothing that is deprecated, and has expanded no macro.
#[test]
fn a_warning_does_not_speak_of_how_the_macro_gives_it() {
    let (said, accepted) = compile("unused");
    assert!(accepted, "{said}");
    for word in ["deprecated", "macro", "constant", "equation_file"] {
        assert!(!said.contains(word), "{said}");
    }
    assert!(said.contains("= note: nothing uses `spare`\n"), "{said}");
}

#[test]
fn mistakes_in_the_file_of_a_part_are_told_at_the_part() {
    check("in_part");
}

#[test]
fn an_edit_of_the_file_of_a_part_compiles_anew() {
    for name in ["right_part", "right_file"] {
        let (found, accepted) = compile(name);
        assert!(accepted && found.is_empty(), "{found}");
        let needed = std::fs::read_to_string(output(name, "d")).expect("rustc writes it");
        for file in ["pair.eqn", "spring.eqn"] {
            assert!(needed.contains(file), "no {file} in {needed}");
        }
    }
}
