//! The examples of GRAMMAR.md do what the text says.

use assur_model::flatten::Wanted;
use assur_model::lexer::{Unreadable, lex_file};
use assur_model::token::Token;

use super::{check, compiled};

const GRAMMAR: &str = include_str!("../../GRAMMAR.md");

/// The fenced blocks, in order.
fn blocks() -> Vec<&'static str> {
    let blocks: Vec<_> = GRAMMAR.split("```").skip(1).step_by(2).collect();
    blocks
        .into_iter()
        .map(|block| block.strip_prefix("text\n").unwrap_or_else(|| panic!("not ```text: {block}")))
        .collect()
}

#[test]
fn it_begins_with_its_heading() {
    assert!(GRAMMAR.starts_with("# The language\n"));
}

/// Blocks with the envelope are whole files.
#[test]
fn whole_files_compile() {
    let mut count = 0;
    for block in blocks().into_iter().filter(|block| block.starts_with("assur::mechanism! {")) {
        count += 1;
        let lexed = lex_file(block).unwrap_or_else(|error| panic!("{error:?}: {block}"));
        let compiled = assur_model::compile_with(&lexed.tokens, &mut file);
        assert!(compiled.diagnostics.is_empty(), "{block}\n{:#?}", compiled.diagnostics);
    }
    assert!(count >= 1, "{count} whole files");
}

/// The file of values is one.
#[test]
fn files_of_values_are_read() {
    let file = blocks().into_iter().find(|block| block.contains("lift [mm], F [N]\n"));
    let sheet = assur_model::sheet::Sheet::read(file.expect("the spring")).unwrap();
    assert_eq!((sheet.columns.len(), sheet.lines.len()), (2, 3));
}

/// The files of parts are examples before.
fn file(wanted: &Wanted) -> Result<Vec<Token>, Unreadable> {
    assert_eq!(wanted.path, "crank_rocker.eqn");
    let text = blocks().into_iter().find(|block| block.contains("\n    CrankRocker from"));
    lex_file(text.expect("the crank-rocker")).map(|lexed| lexed.tokens)
}

/// Blocks of statements compile behind this file; those that begin with `// not` do not.
const BEFORE: &str = "Sample; parameter m = 2 kg, c = 8 [N/m], F = 3 N, n = 60 rpm, l = 1 m; driver theta = n*time; \
    coordinate x: m = 0; kinetic m*dot(x)^2/2; potential c*x^2/2; output x, F, l;";

#[test]
fn statements_compile() {
    let mut count = 0;
    for block in blocks()
        .into_iter()
        .filter(|block| block.trim_end().ends_with([';', '}']) && !block.starts_with("assur"))
    {
        count += 1;
        let (compiled, _) = compiled(&format!("{BEFORE}{block}"));
        let wrong = compiled.model.is_none();
        assert_eq!(wrong, block.starts_with("// not"), "{block}\n{:#?}", compiled.diagnostics);
    }
    assert!(count >= 15, "{count} blocks of statements");
}

#[test]
fn the_file_before_the_examples_is_right() {
    check(BEFORE, &[]);
}
