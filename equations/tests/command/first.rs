//! `docs/first-mechanism.md`: every command that it types, and every line that it shows.

use std::fs;
use std::path::Path;

use crate::{folder, run};

/// A command with the lines that are shown of what it prints.
struct Typed {
    command: String,
    shown: Vec<String>,
}

/// The commands of a page, in their order.
fn typed(page: &str) -> Vec<Typed> {
    let mut all: Vec<Typed> = Vec::new();
    let mut inside = false;
    for line in page.lines() {
        match (inside, line) {
            (false, "```console") => inside = true,
            (true, "```") => inside = false,
            (true, line) => match (line.strip_prefix("$ "), all.last_mut()) {
                (Some(command), _) => {
                    all.push(Typed { command: command.to_owned(), shown: Vec::new() });
                }
                (None, Some(last)) => last.shown.push(line.to_owned()),
                (None, None) => panic!("a line without a command: {line}"),
            },
            (false, _) => {}
        }
    }
    all
}

#[test]
fn a_first_mechanism_is_as_its_page_shows_it() {
    let here = folder("first-mechanism");
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/first-mechanism.md");
    let typed = typed(&fs::read_to_string(page).expect("the page"));
    assert!(typed.len() > 7, "{} commands", typed.len());
    for Typed { command, shown } in typed {
        let words: Vec<&str> = command.split(' ').collect();
        assert_eq!(words[0], "assur", "{command}");
        let output = run(&words[1..], &here);
        let [printed, said] =
            [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text"));
        let mut lines = printed.lines().chain(said.lines());
        for wanted in shown.iter().filter(|line| *line != "…") {
            let found = lines.any(|line| line.trim_end() == wanted.trim_end());
            assert!(found, "{command}: no line `{wanted}` in\n{printed}{said}");
        }
    }
}
