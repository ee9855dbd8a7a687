//! `docs/questions.md`: every command of the page answers.

use std::fs;
use std::path::Path;

use crate::{answer, folder};

/// The words of a command as a shell reads them: what stands between single quotes is one word.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quoted = false;
    for letter in command.chars() {
        match (letter, words.last_mut()) {
            ('\'', _) => quoted = !quoted,
            (' ', _) if !quoted => words.push(String::new()),
            (letter, Some(last)) => last.push(letter),
            (_, None) => {}
        }
    }
    assert!(!quoted, "a quote is open: {command}");
    words
}

/// A page of `docs/`.
pub fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name);
    fs::read_to_string(path).expect("the page")
}

/// Runs every command of a page, in its order and in one folder.
pub fn run_all(page: &str, here: &Path) -> usize {
    let mut count = 0;
    for command in page.lines().filter_map(|line| line.strip_prefix("$ ")) {
        count += 1;
        let words = words(command);
        assert_eq!(words[0], "assur", "{command}");
        let asked: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        assert!(!answer(&asked, here).trim().is_empty(), "{command}: no answer");
    }
    count
}

#[test]
fn each_question_is_answered() {
    let count = run_all(&page("questions.md"), &folder("questions"));
    assert!(count >= 40, "{count} commands");
}
