//! The language from outside: files that compile, files that do not and what is said about them, files that are cut or
//! garbled, and chains of pendulums against an independent computation.

mod arrows;
mod chain;
mod derivatives;
mod documentation;
mod fuzz;
mod grammar;
mod growth;
mod labels;
mod literals;
mod measures;
mod mechanics;
mod modes;
mod parts;
mod programs;
mod right;
mod scenes;
mod searches;
mod slips;
mod synthesis;
mod tables;
mod wrong;

use std::fmt::Write;

use assur_model::checked::{Compiled, SceneModel};
use assur_model::diagnostic::{Diagnostic, Severity};
use assur_model::lexer::{Lexed, lex_plain};
use assur_model::token::Span;

/// A mass on a spring: what most files here begin with.
const SPRING: &str = "Sample; parameter m = 2 kg, c = 8 [N/m]; coordinate x: m = 0.1 m; \
                      kinetic m*dot(x)^2/2; potential c*x^2/2; output x; ";

/// A message that is expected: a part of it, the words that it points at, and a part of the hint (or nothing).
type Expected = (&'static str, &'static str, &'static str);

/// Compiles the tokens of a file.
#[track_caller]
fn compiled(text: &str) -> (Compiled, Lexed) {
    let lexed = lex_plain(text).unwrap();
    (assur_model::compile(&lexed.tokens), lexed)
}

/// The words that a message points at.
fn words<'a>(text: &'a str, lexed: &Lexed, span: Span) -> &'a str {
    let range = |index: u32| lexed.ranges.get(index as usize).cloned().unwrap_or(0..0);
    &text[range(span.first).start..range(span.last).end]
}

/// The messages of a file that are more than notes.
fn mistakes(compiled: &Compiled) -> Vec<&Diagnostic> {
    let all = compiled.diagnostics.iter();
    all.filter(|one| one.severity != Severity::Note).collect()
}

/// The first scene of a file without mistakes.
#[track_caller]
fn first_scene(text: &str) -> SceneModel {
    let (compiled, _) = compiled(text);
    let problems = mistakes(&compiled);
    assert!(problems.is_empty(), "{problems:#?}");
    compiled.model.unwrap().scenes.remove(0)
}

/// Checks that a file gives these messages and no others, notes apart.
#[track_caller]
fn check(text: &str, expected: &[Expected]) {
    let (compiled, lexed) = compiled(text);
    check_messages(text, &compiled, expected, |span| words(text, &lexed, span));
}

/// Checks the messages of a file; `words` gives what one points at.
#[track_caller]
fn check_messages<'a>(
    text: &str,
    compiled: &Compiled,
    expected: &[Expected],
    words: impl Fn(Span) -> &'a str,
) {
    let mut shown = String::new();
    let mistakes = mistakes(compiled);
    for one in &mistakes {
        let place = words(one.span);
        let _ = writeln!(shown, "  {:?}: {} [{place}] {:?}", one.severity, one.message, one.hint);
    }
    assert_eq!(mistakes.len(), expected.len(), "{text}\n{shown}");
    for (found, (message, place, hint)) in mistakes.iter().zip(expected) {
        assert!(found.message.contains(message), "no {message:?}: {text}\n{shown}");
        assert_eq!(words(found.span), *place, "{text}\n{shown}");
        assert!(
            found.hint.as_deref().unwrap_or("").contains(hint),
            "no hint {hint:?}: {text}\n{shown}"
        );
    }
}
