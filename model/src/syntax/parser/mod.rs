//! Tokens to tree, by recursive descent.
//!
//! Every statement begins with a keyword; keywords are contextual, so any of them may also name a quantity. After a
//! mistake the parser goes on behind the next `;` or block, so that all mistakes of a file are found at once.

mod choice;
mod cursor;
mod declaration;
mod event;
mod scene;
mod search;
mod slip;
mod statement;
mod table;
mod term;
mod unit;

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::syntax::tree::{File, Term, UnitTerm};
use crate::token::{Span, Token, TokenKind};
pub use choice::{Changes, parse_changes};
use cursor::Cursor;

/// Brackets, signs and branches may nest this deep.
const DEPTH: usize = 64;

/// A mistake that has been reported: whoever meets it gives up its statement.
struct Reported;

type Read<T> = Result<T, Reported>;

/// Reads the tokens of a mechanism, the first of which is counted as `first`. Reports every mistake; there is no tree
/// when not even the name can be read.
pub fn parse(tokens: &[Token], first: u32, diagnostics: &mut Diagnostics) -> Option<File> {
    refuse_words(tokens, first, diagnostics);
    let mut parser = Parser::new(tokens, first, diagnostics);
    let file = parser.file().ok()?;
    Some(file)
}

/// Reports words that cannot be names in emitted Rust: those that Rust keeps in every spelling, and those with an
/// underscore at an end, which mark what the printer adds.
fn refuse_words(tokens: &[Token], first: u32, diagnostics: &mut Diagnostics) {
    for (index, token) in tokens.iter().enumerate() {
        let (word, span) = (&token.text, Span::token(first + index as u32));
        let report = match word.as_str() {
            _ if token.kind != TokenKind::Word => continue,
            "self" | "Self" | "super" | "crate" => {
                let message = format!("`{word}` cannot be a name, because Rust keeps it");
                Diagnostic::error(span, message).hint("choose another name")
            }
            _ if word.starts_with('_') || word.ends_with('_') => {
                let message = format!("`{word}` begins or ends with an underscore");
                Diagnostic::error(span, message)
                    .hint("such names are kept for what the compiler adds; choose another name")
            }
            _ => continue,
        };
        diagnostics.push(report);
    }
}

/// Reads a unit without brackets, `N m/rad`, and nothing else.
pub fn parse_unit(tokens: &[Token], diagnostics: &mut Diagnostics) -> Option<UnitTerm> {
    let mut parser = Parser::new(tokens, 0, diagnostics);
    let unit = parser.unit_factors().ok()?;
    parser.end("of the unit").ok()?;
    Some(unit)
}

/// Reads an expression and nothing else.
pub fn parse_term(tokens: &[Token], diagnostics: &mut Diagnostics) -> Option<Term> {
    let mut parser = Parser::new(tokens, 0, diagnostics);
    let term = parser.term().ok()?;
    parser.end("of the expression").ok()?;
    Some(term)
}

struct Parser<'a> {
    cursor: Cursor<'a>,
    diagnostics: &'a mut Diagnostics,
    depth: usize,
    /// Indices of the repetitions around.
    indices: Vec<String>,
    /// Words of statements that could not be read.
    unread: BTreeSet<String>,
    /// Whether a bracket after a name may be the unit of an output.
    in_output: bool,
}

impl<'a> Parser<'a> {
    fn new(tokens: &'a [Token], first: u32, diagnostics: &'a mut Diagnostics) -> Self {
        Self {
            cursor: Cursor::new(tokens, first),
            diagnostics,
            depth: 0,
            indices: Vec::new(),
            unread: BTreeSet::new(),
            in_output: false,
        }
    }

    /// Goes one level deeper, if that is still allowed.
    fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth >= DEPTH {
            return self.wrong(
                format!("this is nested more than {DEPTH} deep"),
                Some("give an inner part a name with `let`"),
            );
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }
}

#[cfg(test)]
mod tests;
