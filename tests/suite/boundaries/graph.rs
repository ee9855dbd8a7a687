//! The graph of the modules of `solvers`: a module uses what is found below it, and no way leads back.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::{code, files, read, root};

/// For each module the modules that it names.
type Graph = BTreeMap<String, BTreeSet<String>>;

/// The modules that can be reached from each other. A linkage behind its pointer draws linkages made at random, which is
/// compiled for each: so what closes loops knows what is asked about tolerances.
const KNOTS: [&[&str]; 1] = [&["closure", "tolerance"]];

/// The module directly below the root of a crate that a file of it belongs to; none for the root and for tests.
fn module(file: &Path) -> Option<String> {
    let parts: Vec<_> = file.iter().map(|part| part.to_string_lossy()).collect();
    let is_test = parts.iter().any(|part| part == "tests" || part == "tests.rs");
    let first = parts.first()?.trim_end_matches(".rs");
    (!is_test && first != "lib").then(|| first.to_owned())
}

/// The name that a path begins with.
fn first_name(path: &str) -> &str {
    let end = path.find(|one: char| !one.is_alphanumeric() && one != '_').unwrap_or(path.len());
    &path[..end]
}

/// The names that stand behind `crate::` in a text.
fn named(text: &str) -> BTreeSet<String> {
    let text: String = code(text).collect::<Vec<_>>().join("\n");
    let mut names = BTreeSet::new();
    for rest in text.split("crate::").skip(1) {
        let Some(list) = rest.strip_prefix('{') else {
            names.insert(first_name(rest).to_owned());
            continue;
        };
        let mut depth = 1;
        let mut begins = true;
        for (at, one) in list.char_indices() {
            match one {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' => begins = true,
                _ if one.is_whitespace() => {}
                _ => {
                    if depth == 1 && begins {
                        names.insert(first_name(&list[at..]).to_owned());
                    }
                    begins = false;
                }
            }
            if depth == 0 {
                break;
            }
        }
    }
    names
}

/// The graph of files with their texts; what is no module of the crate is left out.
fn graph(sources: &[(&Path, String)]) -> Graph {
    let mut graph = Graph::new();
    for (file, text) in sources {
        if let Some(own) = module(file) {
            graph.entry(own).or_default().extend(named(text));
        }
    }
    let modules: BTreeSet<String> = graph.keys().cloned().collect();
    for (own, named) in &mut graph {
        named.retain(|name| name != own && modules.contains(name));
    }
    graph
}

/// The modules that can be reached from one.
fn reached(graph: &Graph, from: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from.to_owned()];
    while let Some(one) = open.pop() {
        let next = graph.get(&one).into_iter().flatten();
        open.extend(next.filter(|name| reached.insert((*name).clone())).cloned());
    }
    reached
}

/// The sets of modules that can be reached from each other.
fn knots(graph: &Graph) -> BTreeSet<Vec<String>> {
    let all: BTreeMap<&String, _> = graph.keys().map(|one| (one, reached(graph, one))).collect();
    let knot = |one: &String| -> Vec<String> {
        all[one].iter().filter(|other| all[other].contains(one)).cloned().collect()
    };
    graph.keys().map(knot).filter(|knot| !knot.is_empty()).collect()
}

#[test]
fn modules_of_the_solvers_stand_one_above_the_other() {
    let folder = root().join("solvers/src");
    let files = files(&folder);
    let sources: Vec<_> =
        files.iter().map(|file| (file.strip_prefix(&folder).unwrap(), read(file))).collect();
    let expected = KNOTS.map(|knot| knot.iter().map(|name| name.to_string()).collect());
    assert_eq!(knots(&graph(&sources)), BTreeSet::from(expected));
}

#[track_caller]
fn check(sources: &[(&str, &str)], expected: &[&[&str]]) {
    let sources: Vec<_> =
        sources.iter().map(|(file, text)| (Path::new(*file), text.to_string())).collect();
    let expected = expected.iter().map(|knot| knot.iter().map(|name| name.to_string()).collect());
    assert_eq!(knots(&graph(&sources)), expected.collect());
}

#[test]
fn a_way_that_leads_back_is_found() {
    let lists = "use crate::{\n    b::{c, D},\n    e,\n};";
    check(&[("a.rs", lists), ("b/mod.rs", ""), ("c.rs", "use crate::a;"), ("e/f.rs", "")], &[]);
    check(&[("a.rs", lists), ("b/g/h.rs", "fn f() { crate::a::f() }")], &[&["a", "b"]]);
    check(
        &[("a.rs", lists), ("b.rs", "use crate::e::E;"), ("e/f.rs", "use crate::a::A;")],
        &[&["a", "b", "e"]],
    );
    let tested = "#[cfg(test)]\nmod tests;\nuse crate::a::A;";
    check(&[("a.rs", lists), ("b.rs", tested)], &[&["a", "b"]]);
    let test =
        "/// [`A`](crate::a::A)\nfn f() {}\n\n#[cfg(test)]\nmod tests {\n    use crate::a::A;\n}";
    check(&[("a.rs", lists), ("b.rs", test), ("e/tests/t.rs", "use crate::a::A;")], &[]);
}
