//! `docs/language.md`: its files run, its commands answer, its mistakes give the messages that it shows.

use std::fs;
use std::path::Path;

use crate::questions::{page, run_all};
use crate::{answer, folder, run};

/// Writes the whole files of the page, each called after its mechanism as a part is; gives their names.
fn write(page: &str, here: &Path) -> Vec<String> {
    let blocks = page.split("```text\n").skip(1).filter_map(|rest| rest.split("```").next());
    let files = blocks.filter(|block| block.starts_with("assur::mechanism! {"));
    files
        .map(|text| {
            let title = text.lines().find_map(|line| line.split_once(" from \"")).expect("a title");
            let name = format!("{}.eqn", title.0.trim().to_lowercase());
            fs::write(here.join(&name), text).expect("a file");
            name
        })
        .collect()
}

#[test]
fn whole_files_run_and_commands_answer() {
    let here = folder("language");
    let page = page("language.md");
    let files = write(&page, &here);
    assert!(files.len() >= 7, "{files:?}");
    for file in &files {
        answer(&["check", file.as_str()], &here);
        let text = answer(&["run", file.as_str()], &here);
        assert!(!text.contains("OUTSIDE"), "{file}: {text}");
    }
    let count = run_all(&page, &here);
    assert!(count >= 10, "{count} commands");
}

/// What a cell of a table shows as code.
fn code(cell: &str) -> Option<&str> {
    let cell = cell.trim();
    let inside = cell.trim_matches('`');
    (inside.len() < cell.len()).then(|| inside.trim())
}

/// A row of the table of mistakes: what is written, and what is said. Three or more backticks stand around a message that has
/// some itself.
fn mistake(row: &str) -> Option<(&str, &str)> {
    let mut cells = row.strip_prefix("| `")?.split(" | ");
    let written = cells.next()?.strip_suffix('`')?;
    let said = cells.next()?;
    let said = match said.strip_prefix("``` ") {
        Some(said) => said.strip_suffix(" ```")?,
        None => code(said)?,
    };
    Some((written, said))
}

#[test]
fn mistakes_are_told_as_the_page_says() {
    let here = folder("language_mistakes");
    let page = page("language.md");
    write(&page, &here);
    let right = fs::read_to_string(here.join("lowering.eqn")).expect("a file");
    let right = right.trim_end().strip_suffix('}').expect("a closing brace");
    let (_, mistakes) = page.split_once("## Common mistakes").expect("the mistakes");
    let mut count = 0;
    for (written, said) in mistakes.lines().filter_map(mistake) {
        count += 1;
        fs::write(here.join("mistake.eqn"), format!("{right}    {written}\n}}\n")).expect("a file");
        let output = run(&["check", "mistake.eqn"], &here);
        let printed = [output.stdout, output.stderr].concat();
        let printed = String::from_utf8(printed).expect("text");
        assert!(printed.contains(said), "{written}: no `{said}` in\n{printed}");
    }
    assert!(count >= 20, "{count} mistakes");
}
