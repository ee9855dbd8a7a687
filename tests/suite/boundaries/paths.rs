//! No `#[path = "…"]` leads out of its own package: what two packages need is a third one.

use std::path::{Component, Path, PathBuf};

use super::{files, read, root};

/// The paths that attributes of modules give, in the order of the text.
fn given(text: &str) -> Vec<&str> {
    let lines = text.lines().map(str::trim_start).filter(|line| line.starts_with("#"));
    let attributes =
        lines.filter_map(|line| line.split_once("path = \"").or(line.split_once("path=\"")));
    attributes.filter_map(|(_, rest)| rest.split('"').next()).collect()
}

/// A path without `.` and `..`, whether there is such a file or not.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

/// The folder of the package that a file belongs to.
fn package(file: &Path) -> Option<&Path> {
    file.ancestors().skip(1).find(|folder| folder.join("Cargo.toml").is_file())
}

/// The paths of a file's attributes that lead into another package than its own.
fn leading_out<'a>(file: &Path, text: &'a str) -> Vec<&'a str> {
    let folder = file.parent().unwrap();
    let is_out = |path: &&str| package(&plain(&folder.join(path))) != package(file);
    given(text).into_iter().filter(is_out).collect()
}

#[test]
fn no_path_leads_out_of_its_package() {
    let sources = files(&root()).into_iter();
    for file in sources.filter(|file| file.extension().is_some_and(|it| it == "rs")) {
        let text = read(&file);
        let out = leading_out(&file, &text);
        assert!(out.is_empty(), "{}: {out:?}", file.display());
    }
}

#[track_caller]
fn check(file: &str, text: &str, expected: &[&str]) {
    assert_eq!(leading_out(&root().join(file), text), expected);
}

#[test]
fn a_path_that_leads_out_is_found() {
    let out = "../../macros/src/lib.rs";
    check("cli/src/lib.rs", &format!("mod a;\n#[path = \"{out}\"]\nmod b;"), &[out]);
    check("cli/src/lib.rs", &format!("    #[cfg_attr(test, path=\"{out}\")]\n    mod b;"), &[out]);
    check(
        "src/lib.rs",
        "#[path = \"../model/src/unit/mod.rs\"]\nmod unit;",
        &["../model/src/unit/mod.rs"],
    );
    check("cli/src/lib.rs", "#[path = \"./draw/../text.rs\"]\nmod text;", &[]);
    check("macros/tests/golden.rs", "#[path = \"../src/golden/pendulum.rs\"]\nmod pendulum;", &[]);
    check("cli/src/lib.rs", &format!("// #[path = \"{out}\"]\nlet path = \"{out}\";"), &[]);
}
