//! A record of all that the command answers, to be compared between two commits:
//!
//! ```text
//! ASSUR_RECORD=before cargo test --release -p assur-equations --test command record -- --ignored
//! ASSUR_RECORD=after  …
//! diff -r before after
//! ```
//!
//! A file an answer, named after what was asked, with exit code and messages; figures and drawings beside it. Times that
//! were measured are blanked.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use assur::registry::{Mechanism, SceneEntry};
use assur_equations::REGISTRY;

use super::run;

/// Something that is asked: the words of the command.
type Question = Vec<String>;

#[test]
#[ignore = "two minutes; ASSUR_RECORD=DIR cargo test --release -p assur-equations --test command record -- --ignored"]
fn everything() {
    let Some(folder) = std::env::var_os("ASSUR_RECORD").map(PathBuf::from) else {
        panic!("say where to: ASSUR_RECORD=DIR");
    };
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    let questions: Vec<Question> = REGISTRY.iter().flat_map(about).collect();
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(question) = questions.get(next.fetch_add(1, Ordering::Relaxed)) {
                    keep(question, &folder);
                }
            });
        }
    });
    assert!(questions.len() > 100, "{} questions", questions.len());
}

/// What is asked about a mechanism.
fn about(mechanism: &'static Mechanism) -> Vec<Question> {
    let name = mechanism.name;
    let scenes = mechanism.scenes.iter();
    let mut list: Vec<Question> = scenes
        .flat_map(|scene| of_scene(scene).into_iter().map(move |words| (scene, words)))
        .map(|(scene, words)| {
            let (command, options) = words.split_first().expect("a command");
            let start = [command, name, "--scene", scene.name];
            start.iter().chain(options).map(|word| word.to_string()).collect()
        })
        .collect();
    list.push(vec!["scenes".to_owned(), name.to_owned()]);
    list
}

/// Subcommands for a scene, with their options.
fn of_scene(scene: &SceneEntry) -> Vec<Vec<&'static str>> {
    let formats = |words: &[&'static str], formats: &[&'static str]| {
        let with = |format: &&'static str| [words, &["--format", format]].concat();
        formats.iter().map(with).collect::<Vec<_>>()
    };
    let all = ["table", "json", "csv"];
    let mut list = formats(&["run", "--plot", "figure.svg"], &all);
    list.push(vec!["expand"]);
    if scene.modes.iter().any(|mode| !mode.events.is_empty()) {
        list.push(vec!["run", "--format", "csv", "--rows", "events"]);
    }
    if !scene.measures.is_empty() {
        let toleranced = scene.constants.iter().any(|one| one.tolerance != 0.0);
        if toleranced {
            list.extend(formats(&["study", "--samples", "8"], &all));
        }
    }
    if scene.linkage.is_some() {
        list.push(vec!["run", "--format", "csv", "--rows", "limits"]);
        list.push(vec!["draw"]);
        list.extend(formats(&["structure"], &all[..2]));
        list.extend(formats(&["modes"], &all));
        list.extend(formats(&["tolerance", "--samples", "2000", "--plot", "figure.svg"], &all));
    }
    list
}

/// Asks, in a folder of the question's own, and keeps the answer there.
fn keep(question: &[String], folder: &Path) {
    let words: Vec<&str> = question.iter().map(String::as_str).collect();
    let folder = folder.join(words.join(" ").replace("--", "").replace("figure.svg", ""));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    let output = run(&words, &folder);
    let text = |bytes: &[u8]| blanked(&String::from_utf8_lossy(bytes), words[0] == "scenes");
    let answer = format!(
        "exit code {:?}\n{}{}",
        output.status.code(),
        text(&output.stderr),
        text(&output.stdout)
    );
    std::fs::write(folder.join("answer"), answer).expect("the folder is writable");
}

/// A text without the times that were measured: those behind "in", fields of seconds, and in a table of costs all.
fn blanked(text: &str, costs: bool) -> String {
    let line = |line: &str| {
        if line.trim_start().starts_with("\"seconds") {
            return line.split(':').next().unwrap_or("").to_owned() + ": …";
        }
        let words: Vec<&str> = line.split(' ').filter(|word| !costs || !word.is_empty()).collect();
        let measured = |at: usize| {
            let unit = words.get(at + 1).map(|word| word.trim_end_matches(['.', ';', ',', ':']));
            let is_time = matches!(unit, Some("ns" | "µs" | "ms" | "s"));
            is_time
                && words[at].parse::<f64>().is_ok()
                && (costs || at > 0 && words[at - 1] == "in")
        };
        let shown = (0..words.len()).map(|at| match measured(at) || at > 0 && measured(at - 1) {
            true => "…",
            false => words[at],
        });
        shown.collect::<Vec<_>>().join(" ")
    };
    text.lines().map(|one| line(one) + "\n").collect()
}

#[test]
fn measured_times_are_blanked() {
    assert_eq!(
        blanked("solved in 41 ms by dop853 with 2 ms in 3 steps\n  \"seconds\": 0.5,\n", false),
        "solved in … … by dop853 with 2 ms in 3 steps\n  \"seconds\": …\n"
    );
    assert_eq!(blanked("  elastic   54   26 ns   4.1 ms\n", true), "elastic 54 … … … …\n");
}
