//! The command as its users meet it: what it answers, what it refuses, and what it leaves behind.

mod answers;
mod classics;
mod costs;
mod dwell;
mod equation_files;
mod events;
mod files;
mod first;
mod gallery;
mod language;
mod linkages;
mod modes;
mod paths;
mod questions;
mod record;
mod refusals;
mod rests;
mod schema;
mod sheets;
mod shipped;
#[cfg(unix)]
mod signals;
mod studies;
mod surfaces;
mod synth;
mod tolerances;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// An empty directory of a test's own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a temporary directory");
    path
}

fn command(arguments: &[&str], directory: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.args(arguments).current_dir(directory);
    command
}

fn run(arguments: &[&str], directory: &Path) -> Output {
    let output = command(arguments, directory).output();
    output.expect("the command starts")
}

/// Runs a command that has to succeed, and gives what it prints.
#[track_caller]
fn answer(arguments: &[&str], directory: &Path) -> String {
    let output = run(arguments, directory);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {complaint}");
    String::from_utf8(output.stdout).expect("text")
}

/// The answer of a command as an object.
#[track_caller]
fn json(arguments: &[&str], directory: &Path) -> Value {
    let text = answer(&[arguments, &["--format", "json"]].concat(), directory);
    serde_json::from_str(&text).expect("one JSON object")
}

/// Runs a command that has to be refused with exit code 2 and these words, and to write nothing.
#[track_caller]
fn check_refused(arguments: &[&str], words: &[&str], directory: &Path) {
    let before = entries(directory);
    let output = run(arguments, directory);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {complaint}");
    assert!(output.stdout.is_empty(), "{arguments:?} prints an answer");
    for word in words {
        assert!(complaint.contains(word), "{arguments:?}: no {word:?} in\n{complaint}");
    }
    assert!(!complaint.contains("panicked"), "{complaint}");
    assert_eq!(entries(directory), before, "{arguments:?} leaves files");
}

/// Names of what is in a directory.
fn entries(directory: &Path) -> Vec<PathBuf> {
    let list = std::fs::read_dir(directory).expect("a directory");
    let mut names: Vec<_> = list.flatten().map(|entry| entry.path()).collect();
    names.sort();
    names
}
