//! Files that are cut off or garbled: there is a message or a model, never a panic, and it does not take long.

use std::time::{Duration, Instant};

use assur_model::lexer::lex_file;
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
    assert!(
        start.elapsed() < PATIENCE,
        "{what} takes {:?}",
        start.elapsed()
    );
    let last = tokens.len().saturating_sub(1) as u32;
    for one in &compiled.diagnostics {
        assert!(
            one.span.first <= one.span.last && one.span.last <= last,
            "{what}: {one:?}"
        );
        assert!(
            one.related
                .as_ref()
                .is_none_or(|(span, _)| span.last <= last),
            "{what}: {one:?}"
        );
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
    assert!(
        compiled.diagnostics.is_empty(),
        "{:?}",
        compiled.diagnostics
    );
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
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
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
        let mut garbled: Vec<Token> = (0..40)
            .map(|_| tokens[roll(&mut state, tokens.len())].clone())
            .collect();
        garbled.insert(
            0,
            Token {
                kind: TokenKind::Punctuation {
                    character: ';',
                    joint: false,
                },
                text: String::new(),
            },
        );
        garbled.insert(
            0,
            Token {
                kind: TokenKind::Word,
                text: "Sample".into(),
            },
        );
        endure(&garbled, &format!("round {round}"));
    }
}
