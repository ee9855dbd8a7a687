//! The arrows between the packages. See section 1 of the design.

mod graph;
mod paths;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The packages, their folders and all that they may depend on.
const ARROWS: [(&str, &str, Allowed); 10] = [
    ("assur-functions", "functions", Allowed::Nothing),
    ("assur-model", "model", Allowed::Only(&["assur-functions"])),
    ("assur-solvers", "solvers", Allowed::Only(&["assur-functions", "nalgebra", "clarabel"])),
    ("assur-emit", "emit", Allowed::Only(&["assur-model", "proc-macro2", "quote"])),
    ("assur-macros", "macros", Allowed::Of(&["assur-emit", "assur-model"])),
    ("assur-registry", "registry", Allowed::Only(&["assur-solvers"])),
    (
        "assur-interpreter",
        "interpreter",
        Allowed::Only(&["assur-model", "assur-registry", "assur-solvers"]),
    ),
    ("assur", "", Allowed::Only(&["assur-macros", "assur-registry", "assur-solvers"])),
    ("assur-equations", "equations", Allowed::Only(&["assur", "assur-cli"])),
    ("assur-cli", "cli", Allowed::Of(&["assur", "assur-emit", "assur-interpreter", "assur-model"])),
];

/// What a package may depend on.
enum Allowed {
    Nothing,
    /// On these packages alone.
    Only(&'static [&'static str]),
    /// On exactly these packages of ours, and on any of others.
    Of(&'static [&'static str]),
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The names under `[dependencies]`, `[build-dependencies]` and those of a target; those of tests and of the workspace
/// are free.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut inside = false;
    for line in manifest.lines().map(str::trim) {
        if let Some(section) = line.strip_prefix('[') {
            let section = section.trim_end_matches(']');
            let (kind, name) = match section.split_once("dependencies.") {
                Some((before, name)) => (format!("{before}dependencies"), Some(name)),
                None => (section.to_owned(), None),
            };
            let is_free = kind.ends_with("dev-dependencies") || kind.starts_with("workspace");
            let is_kind = kind.ends_with("dependencies") && !is_free;
            inside = is_kind && name.is_none();
            if let Some(name) = name.filter(|_| is_kind) {
                names.insert(name.to_owned());
            }
        } else if inside && !line.starts_with('#') {
            let name = line.split(['=', '.', ' ']).next().unwrap_or_default();
            if !name.is_empty() {
                names.insert(name.trim_matches('"').to_owned());
            }
        }
    }
    names
}

#[track_caller]
fn check_dependencies(manifest: &str, expected: &[&str]) {
    let expected: BTreeSet<String> = expected.iter().map(|it| it.to_string()).collect();
    assert_eq!(dependencies(manifest), expected);
}

#[test]
fn dependencies_are_read_from_all_their_sections() {
    check_dependencies("[package]\nname = \"a\"\n[dependencies]\n\n[lints]\nb = 1", &[]);
    check_dependencies(
        "[dependencies]\n# c = \"1\"\nsyn = { version = \"1\" }\nd.workspace = true\n[dev-dependencies]\ne = \"1\"",
        &["syn", "d"],
    );
    check_dependencies(
        "[dependencies.f]\nversion = \"1\"\n[target.'cfg(unix)'.dependencies]\ng = \"1\"\n[build-dependencies]\nh = \"1\"",
        &["f", "g", "h"],
    );
}

#[test]
fn arrows_do_not_turn() {
    for (package, folder, allowed) in ARROWS {
        let manifest = read(&root().join(folder).join("Cargo.toml"));
        assert!(manifest.contains(&format!("name = \"{package}\"")), "{folder}");
        let found = dependencies(&manifest);
        let found: BTreeSet<&str> = found.iter().map(String::as_str).collect();
        match allowed {
            Allowed::Nothing => assert!(found.is_empty(), "{package} -> {found:?}"),
            Allowed::Only(names) => {
                let extra: Vec<_> = found.iter().filter(|it| !names.contains(it)).collect();
                assert!(extra.is_empty(), "{package} -> {extra:?}");
            }
            Allowed::Of(names) => {
                let ours: Vec<&str> =
                    found.into_iter().filter(|it| it.starts_with("assur")).collect();
                assert_eq!(ours, names, "{package}");
            }
        }
    }
}

#[test]
fn every_member_has_its_arrows() {
    let manifest = read(&root().join("Cargo.toml"));
    let members = manifest.lines().find(|line| line.starts_with("members"));
    let members: BTreeSet<&str> = members.unwrap().split('"').skip(1).step_by(2).collect();
    let known = ARROWS.map(|(_, folder, _)| if folder.is_empty() { "." } else { folder });
    assert_eq!(members, BTreeSet::from(known));
}

/// The packages that a package of ours is built with: itself, those of ours below it, and theirs.
fn below(package: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::from([package.to_owned()]);
    if let Some((_, folder, _)) = ARROWS.iter().find(|(name, ..)| *name == package) {
        let own = dependencies(&read(&root().join(folder).join("Cargo.toml")));
        found.extend(own.iter().flat_map(|name| below(name)));
    }
    found
}

#[test]
fn what_macros_need_is_built_once() {
    let manifest = read(&root().join("Cargo.toml"));
    let (_, levels) = manifest.split_once("[profile.release.package]").expect("levels");
    let levels = levels.lines().filter_map(|line| line.split_once(" = {"));
    let levels: BTreeSet<&str> =
        levels.map(|(name, _)| name.trim_matches('"').split('@').next().unwrap()).collect();
    for package in below("assur-macros") {
        assert!(levels.contains(package.as_str()), "{package} has no level of its own");
    }
}

/// All files below a folder; what is built and what is hidden left out.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with('.') || name == "target" {
            continue;
        }
        match path.is_dir() {
            true => found.extend(files(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

#[test]
fn solvers_and_model_do_not_name_each_other() {
    for (folder, foreign) in [
        (
            "solvers/src",
            &["assur_model", "assur_emit", "assur_macros", "assur_registry", "proc_macro"][..],
        ),
        (
            "model/src",
            &[
                "assur_solvers",
                "assur_registry",
                "assur_emit",
                "assur_macros",
                "proc_macro",
                "syn::",
            ],
        ),
        ("emit/src", &["assur_solvers", "assur_registry", "assur_macros", "proc_macro::", "syn::"]),
        ("macros/src", &["assur_solvers", "assur_registry"]),
        ("registry/src", &["assur_model", "assur_emit", "assur_macros", "proc_macro"]),
        ("interpreter/src", &["assur_emit", "assur_macros", "proc_macro"]),
    ] {
        for path in files(&root().join(folder)) {
            for line in code(&read(&path)) {
                let named = foreign.iter().find(|name| line.contains(**name));
                assert!(named.is_none(), "{}: {line}", path.display());
            }
        }
    }
}

#[test]
fn the_list_of_equation_files_is_the_directory() {
    let folder = root().join("equations/src");
    let text = read(&folder.join("lib.rs"));
    let listed: BTreeSet<&str> =
        text.split('"').skip(1).step_by(2).filter(|name| name.ends_with(".eqn")).collect();
    let present: Vec<PathBuf> = files(&folder)
        .into_iter()
        .filter(|path| path.extension().is_some_and(|it| it == "eqn"))
        .collect();
    let present: BTreeSet<&str> =
        present.iter().map(|path| path.strip_prefix(&folder).unwrap().to_str().unwrap()).collect();
    assert_eq!(listed, present);
    let registered: BTreeSet<&str> = assur_equations::REGISTRY.iter().map(|it| it.file).collect();
    assert_eq!(registered, present);
}

/// The lines that are compiled into the program: no comments, no unit tests (which stand last in a file, unless they have
/// one of their own).
fn code(text: &str) -> impl Iterator<Item = &str> {
    let lines: Vec<&str> = text.lines().collect();
    let is_test = |pair: &[&str]| pair[0].starts_with("#[cfg(test)]") && !pair[1].ends_with(';');
    let end = lines.windows(2).position(is_test).unwrap_or(lines.len());
    lines.into_iter().take(end).filter(|line| !line.trim_start().starts_with("//"))
}

/// Whether a line shows the user how the command or the macro is called.
fn is_example(line: &str) -> bool {
    [
        "assur run ",
        "assur expand ",
        "assur scenes ",
        "assur structure ",
        "assur draw ",
        "assur modes ",
        "assur study ",
        "assur cost ",
        "assur tolerance ",
        "list of equation files",
    ]
    .iter()
    .any(|call| line.contains(call))
}

#[test]
fn no_crate_knows_a_mechanism() {
    let mut mechanisms = Vec::new();
    for mechanism in assur_equations::REGISTRY {
        mechanisms.extend([mechanism.name, mechanism.title]);
    }
    for folder in [
        "model/src",
        "emit/src",
        "macros/src",
        "solvers/src",
        "registry/src",
        "interpreter/src",
        "cli/src",
        "src",
    ] {
        for path in files(&root().join(folder)) {
            let is_test = path.ends_with("tests.rs")
                || path
                    .components()
                    .any(|it| it.as_os_str() == "tests" || it.as_os_str() == "golden");
            if is_test {
                continue;
            }
            for line in code(&read(&path)).filter(|line| !is_example(line)) {
                let is_word_in = |name: &str| {
                    line.split(|one: char| !one.is_alphanumeric() && one != '_')
                        .any(|it| it == name)
                };
                let named = mechanisms.iter().find(|name| is_word_in(name));
                assert!(named.is_none(), "{}: {line}", path.display());
            }
        }
    }
}
