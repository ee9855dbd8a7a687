//! Files that are cut off or garbled: there is a message or a model, never a panic, and it does not take long.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use assur_model::lexer::{lex_file, lex_plain};
use assur_model::token::{Token, TokenKind};

const BATTEN: &str = include_str!("../../../equations/src/batten.eqn");

/// Longest that one garbled file may take, on a slow machine without optimisation.
const PATIENCE: Duration = Duration::from_secs(20);

fn batten() -> Vec<Token> {
    lex_file(BATTEN).unwrap().tokens
}

/// Compiles what may be no file at all.
#[track_caller]
fn endure(tokens: &[Token], what: &str) {
    let start = Instant::now();
    let compiled = assur_model::compile(tokens);
    assert!(start.elapsed() < PATIENCE, "{what} takes {:?}", start.elapsed());
    let last = tokens.len().saturating_sub(1) as u32;
    for one in &compiled.diagnostics {
        assert!(one.span.first <= one.span.last && one.span.last <= last, "{what}: {one:?}");
        assert!(one.related.as_ref().is_none_or(|(span, _)| span.last <= last), "{what}: {one:?}");
    }
    let wrong = compiled
        .diagnostics
        .iter()
        .any(|one| one.severity == assur_model::diagnostic::Severity::Error);
    assert_eq!(wrong, compiled.model.is_none(), "{what}");
}

#[test]
fn the_batten_compiles() {
    let compiled = assur_model::compile(&batten());
    assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
}

#[test]
fn every_beginning_of_a_file_is_endured() {
    let tokens = batten();
    for length in (0..tokens.len()).step_by(7) {
        endure(&tokens[..length], &format!("the first {length} tokens"));
    }
}

/// Numbers that are the same every time; multiplier and increment are Knuth's.
fn roll(state: &mut u64, limit: usize) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    ((*state >> 33) % limit as u64) as usize
}

#[test]
fn a_file_with_a_token_missing_or_misplaced_is_endured() {
    let tokens = batten();
    let mut state = 1;
    for round in 0..300 {
        let mut garbled = tokens.clone();
        let place = roll(&mut state, tokens.len());
        if round % 2 == 0 {
            garbled.remove(place);
        } else {
            garbled.swap(place, roll(&mut state, tokens.len()));
        }
        endure(&garbled, &format!("round {round}, token {place}"));
    }
}

#[test]
fn tokens_in_any_order_are_endured() {
    let tokens = batten();
    let mut state = 2;
    for round in 0..300 {
        let mut garbled: Vec<Token> =
            (0..40).map(|_| tokens[roll(&mut state, tokens.len())].clone()).collect();
        garbled.insert(
            0,
            Token {
                kind: TokenKind::Punctuation { character: ';', joint: false },
                text: String::new(),
            },
        );
        garbled.insert(0, Token { kind: TokenKind::Word, text: "Sample".into() });
        endure(&garbled, &format!("round {round}"));
    }
}

/// The text of every equation file of the workspace, with its folder.
fn files() -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../equations/src");
    let mut paths: Vec<PathBuf> = folder
        .read_dir()
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "eqn"))
        .collect();
    paths.sort();
    let read = |path: PathBuf| (folder.clone(), std::fs::read_to_string(path).unwrap());
    paths.into_iter().map(read).collect()
}

/// What is put into texts: words and signs that mean much, and characters that mean nothing.
const SCRAPS: &[&str] = &[
    "dot(",
    "ddot(",
    "diff(",
    "sum(k in 1..50, ",
    "for k in 1..9 { ",
    "if x > 0 { ",
    "} else { ",
    "mode a { ",
    "effect e { ",
    "when x falls -> a { set ",
    "hold ",
    "driver ",
    "dependent ",
    "closure ",
    "coordinate ",
    "motion ",
    "choice c { a { ",
    "part p: Batten from \"batten.eqn\" { ",
    "output ",
    "measure M = peak(",
    "scene s { run time 0 s .. 1 s; } ",
    "expect at run: ",
    "((((((((((((((((((((",
    "))))))))))",
    "----------",
    "[[[[[[",
    "]]]",
    "}}}",
    "^^",
    "..",
    "....",
    "1e308",
    "-1e-320",
    "0x",
    "\"",
    "'",
    "//",
    "/*",
    "*/",
    "µ",
    "°",
    "²",
    "x''",
    "\u{202e}",
    "\u{feff}",
    "\u{0}",
    "𝛑",
    "é",
    ";",
    ";;",
    ",",
    "=",
    "~",
    "+-",
    "self",
    "_",
    "r#",
    "#",
];

/// A text with some of it cut, doubled, swapped or overwritten.
fn mutate(text: &str, state: &mut u64) -> String {
    let mut pieces: Vec<String> = Vec::new();
    let is_word = |character: char| character.is_alphanumeric() || "_.".contains(character);
    for character in text.chars() {
        match pieces.last_mut() {
            Some(last) if is_word(character) && last.chars().all(is_word) => last.push(character),
            _ => pieces.push(character.to_string()),
        }
    }
    for _ in 0..=roll(state, 4) {
        let place = roll(state, pieces.len().max(1));
        let length = 1 + roll(state, 12);
        let end = (place + length).min(pieces.len());
        match roll(state, 6) {
            0 => drop(pieces.drain(place.min(end)..end)),
            1 => {
                let copy = pieces[place.min(end)..end].to_vec();
                pieces.splice(end..end, copy);
            }
            2 if !pieces.is_empty() => {
                let other = roll(state, pieces.len());
                pieces.swap(place, other);
            }
            3 => {
                let copies =
                    SCRAPS[roll(state, SCRAPS.len())].repeat(1 + roll(state, 3) * roll(state, 40));
                pieces.insert(place.min(pieces.len()), copies);
            }
            4 if !pieces.is_empty() => {
                pieces[place] = pieces[roll(state, pieces.len())].clone();
            }
            _ if !pieces.is_empty() => {
                // Half a word, half a character's meaning.
                let piece = &mut pieces[place];
                let keep = roll(state, piece.chars().count() + 1);
                *piece = piece.chars().take(keep).collect();
            }
            _ => {}
        }
    }
    pieces.concat()
}

/// Compiles a text that may be no equation file, with the files of its parts.
#[track_caller]
fn endure_text(folder: &Path, text: &str, what: &str) {
    let Ok(lexed) = lex_file(text).or_else(|_| lex_plain(text)) else {
        return;
    };
    let start = Instant::now();
    let mut texts = assur_model::texts::Texts::default();
    let compiled =
        assur_model::compile_with(&lexed.tokens, &mut |wanted| texts.read(folder, wanted));
    let took = start.elapsed();
    assert!(took < PATIENCE, "{what} takes {took:?}:\n{text}");
    let has_error = compiled
        .diagnostics
        .iter()
        .any(|one| one.severity == assur_model::diagnostic::Severity::Error);
    assert_eq!(has_error, compiled.model.is_none(), "{what}:\n{text}");
}

/// Some mutations of every equation file; for as many seconds as `ASSUR_FUZZ_SECONDS` says, from the seed
/// `ASSUR_FUZZ_SEED`.
#[test]
fn mutated_texts_of_all_files_are_endured() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let seconds = number("ASSUR_FUZZ_SECONDS");
    let mut state = number("ASSUR_FUZZ_SEED").unwrap_or(3);
    let files = files();
    let start = Instant::now();
    for round in 0.. {
        let is_over = match seconds {
            Some(seconds) => start.elapsed() > Duration::from_secs(seconds),
            None => round == 60,
        };
        if is_over {
            println!("{round} texts in {:?}", start.elapsed());
            return;
        }
        let (folder, text) = &files[roll(&mut state, files.len())];
        let seed = state;
        let text = mutate(text, &mut state);
        // Where it goes wrong for good, nothing but the seed is left.
        if seconds.is_some() {
            eprintln!("{round} {seed}");
        }
        endure_text(folder, &text, &format!("round {round}, seed {seed}"));
    }
}
