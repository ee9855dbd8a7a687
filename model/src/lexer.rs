//! The text of an equation file as tokens, the same that rustc makes of it.

use std::ops::Range;

use crate::token::{Token, TokenKind};

/// Largest equation file, in bytes.
pub const LARGEST_FILE: usize = 1 << 20;

/// Characters that Rust counts as punctuation.
const PUNCTUATION: &str = "=<>!~+-*/%^&|@.,;:#$?";

/// Tokens with the bytes that they come from.
#[derive(Clone, Debug, Default)]
pub struct Lexed {
    /// The tokens.
    pub tokens: Vec<Token>,
    /// Where each stands in the text.
    pub ranges: Vec<Range<usize>>,
}

/// Why a text has no tokens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The place, in bytes.
    pub range: Range<usize>,
    /// What was found and what was expected.
    pub message: String,
    /// What to do.
    pub hint: Option<String>,
}

impl Unreadable {
    fn new(range: Range<usize>, message: impl Into<String>, hint: &str) -> Self {
        Self { range, message: message.into(), hint: (!hint.is_empty()).then(|| hint.to_string()) }
    }
}

/// The text of a file, if it is one: UTF-8, not empty, not binary, of a sensible size.
///
/// # Errors
/// What the file is instead.
pub fn text(bytes: &[u8]) -> Result<&str, Unreadable> {
    let whole = |message: String, hint| Err(Unreadable::new(0..0, message, hint));
    if bytes.len() > LARGEST_FILE {
        let size = bytes.len() as f64 / f64::from(1 << 20);
        return whole(
            format!("the file has {size:.1} MiB; an equation file has at most 1 MiB"),
            "is this the right file?",
        );
    }
    if bytes.iter().take(1024).any(|byte| *byte == 0) {
        return whole(
            "the file is binary, not text".into(),
            "an equation file is text that begins with `assur::mechanism! {`",
        );
    }
    match std::str::from_utf8(bytes) {
        Ok(text) if text.trim().is_empty() => {
            whole("the file is empty".into(), "an equation file is one `assur::mechanism! { … }`")
        }
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(error) => whole(
            format!(
                "the file is not UTF-8 text: byte {} does not belong there",
                error.valid_up_to()
            ),
            "save it as UTF-8",
        ),
    }
}

/// The tokens inside the `assur::mechanism! { … }` that a file consists of.
///
/// # Errors
/// The first place that Rust's rules for tokens do not allow, or what is missing of the envelope.
pub fn lex_file(text: &str) -> Result<Lexed, Unreadable> {
    let mut lexed = lex_plain(text)?;
    let words: Vec<&str> = lexed.ranges.iter().take(5).map(|range| &text[range.clone()]).collect();
    let begin = match words.as_slice() {
        ["assur", ":", ":", "mechanism", "!"] => 5,
        ["mechanism", "!", ..] => 2,
        _ => {
            let place = lexed.ranges.first().cloned().unwrap_or(0..0);
            let hint = "put `assur::mechanism! {` before it and `}` behind it";
            return Err(Unreadable::new(
                place,
                "an equation file is one `assur::mechanism! { … }`",
                hint,
            ));
        }
    };
    let open = lexed.tokens.get(begin).map(|token| token.kind);
    let end = matching(&lexed.tokens, begin);
    let (Some(TokenKind::Open('{')), Some(end)) = (open, end) else {
        let place = lexed.ranges[begin - 1].clone();
        return Err(Unreadable::new(place, "`{` is expected after `mechanism!`", ""));
    };
    if let Some(more) = lexed.ranges.get(end + 1) {
        let hint = "put a second mechanism into a file of its own";
        return Err(Unreadable::new(more.clone(), "nothing is expected after the mechanism", hint));
    }
    lexed.tokens = lexed.tokens[begin + 1..end].to_vec();
    lexed.ranges = lexed.ranges[begin + 1..end].to_vec();
    Ok(lexed)
}

/// Where the bracket that opens at `begin` closes.
fn matching(tokens: &[Token], begin: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (index, token) in tokens.iter().enumerate().skip(begin) {
        match token.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) if depth <= 1 => return Some(index),
            TokenKind::Close(_) => depth -= 1,
            _ => {}
        }
    }
    None
}

/// The tokens of a text.
///
/// # Errors
/// The first place that Rust's rules for tokens do not allow.
pub fn lex_plain(text: &str) -> Result<Lexed, Unreadable> {
    let mut lexer = Lexer { text, at: 0, lexed: Lexed::default(), open: Vec::new() };
    while lexer.at < text.len() {
        lexer.next()?;
    }
    match lexer.open.pop() {
        None => Ok(lexer.lexed),
        Some((bracket, at)) => Err(Unreadable::new(
            at..at + 1,
            format!("this `{bracket}` is never closed"),
            "add the missing bracket",
        )),
    }
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    lexed: Lexed,
    open: Vec<(char, usize)>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn push(&mut self, kind: TokenKind, text: impl Into<String>, length: usize) {
        self.lexed.tokens.push(Token { kind, text: text.into() });
        self.lexed.ranges.push(self.at..self.at + length);
        self.at += length;
    }

    fn next(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        let Some(first) = rest.chars().next() else {
            return Ok(());
        };
        match first {
            _ if first.is_whitespace() => self.at += first.len_utf8(),
            _ if rest.starts_with("//") => self.line_comment(),
            _ if rest.starts_with("/*") => return self.block_comment(),
            '"' => return self.string(),
            '0'..='9' => self.number(),
            '(' | '[' | '{' => {
                self.open.push((first, self.at));
                self.push(TokenKind::Open(first), "", 1);
            }
            ')' | ']' | '}' => return self.close(first),
            '\'' => self.push(TokenKind::Other, "'", 1),
            _ if PUNCTUATION.contains(first) => {
                let joint = rest[1..].chars().next().is_some_and(|next| PUNCTUATION.contains(next));
                self.push(TokenKind::Punctuation { character: first, joint }, "", 1);
            }
            _ if first.is_alphabetic() || first == '_' => {
                let raw = if rest.starts_with("r#") { 2 } else { 0 };
                let length = raw + word_length(&rest[raw..]);
                self.push(TokenKind::Word, &rest[raw..length], length);
            }
            _ => {
                let hint = match first {
                    '°' if rest.starts_with("°C") => "write a temperature in kelvin: `293.15 K`",
                    '°' => "write `deg`",
                    '²' | '³' => "write a power as `^2`, that of a unit in brackets: `5 [mm^2]`",
                    '≤' | '≥' => "write `<=` or `>=`",
                    '·' | '×' => "write a product as `*`",
                    '−' | '–' => "write a minus as `-`",
                    '±' => "write a tolerance as `+-`",
                    '…' => "write a range as `..`",
                    _ => "",
                };
                let place = self.at..self.at + first.len_utf8();
                return Err(Unreadable::new(
                    place,
                    format!("the character `{first}` has no meaning here"),
                    hint,
                ));
            }
        }
        Ok(())
    }

    fn close(&mut self, bracket: char) -> Result<(), Unreadable> {
        let expected = match self.open.pop() {
            Some(('(', _)) => ')',
            Some(('[', _)) => ']',
            Some(_) => '}',
            None => {
                let message = format!("this `{bracket}` closes nothing");
                return Err(Unreadable::new(self.at..self.at + 1, message, "take it away"));
            }
        };
        if bracket != expected {
            let message = format!("found `{bracket}`, but `{expected}` is expected first");
            return Err(Unreadable::new(
                self.at..self.at + 1,
                message,
                "brackets close in the opposite order",
            ));
        }
        self.push(TokenKind::Close(bracket), "", 1);
        Ok(())
    }

    fn line_comment(&mut self) {
        let rest = self.rest();
        let line = rest.lines().next().unwrap_or(rest);
        match line.strip_prefix("///") {
            Some(text) if !text.starts_with('/') => {
                self.push(
                    TokenKind::Documentation,
                    text.strip_prefix(' ').unwrap_or(text).trim_end(),
                    line.len(),
                );
            }
            _ if line.starts_with("//!") => self.push(TokenKind::Other, line, line.len()),
            _ => self.at += line.len(),
        }
    }

    /// Block comments nest.
    fn block_comment(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        let (mut depth, mut index) = (0_usize, 0);
        while index < rest.len() {
            match rest.as_bytes()[index..] {
                [b'/', b'*', ..] => (depth, index) = (depth + 1, index + 2),
                [b'*', b'/', ..] => (depth, index) = (depth - 1, index + 2),
                _ => index += 1,
            }
            if depth == 0 {
                self.at += index;
                return Ok(());
            }
        }
        Err(Unreadable::new(
            self.at..self.at + 2,
            "this comment is never closed",
            "end it with `*/`",
        ))
    }

    fn string(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        let mut text = String::new();
        let mut characters = rest.char_indices().skip(1);
        while let Some((index, character)) = characters.next() {
            match character {
                '"' => {
                    self.push(TokenKind::Text, text, index + 1);
                    return Ok(());
                }
                '\\' => match characters.next() {
                    Some((_, 'n')) => text.push('\n'),
                    Some((_, 't')) => text.push('\t'),
                    Some((_, other)) => text.push(other),
                    None => break,
                },
                other => text.push(other),
            }
        }
        Err(Unreadable::new(self.at..self.at + 1, "this text is never closed", "end it with `\"`"))
    }

    /// Digits, a fraction, an exponent and whatever word follows at once: `75mm`, `1e-3`, but `1` of `1..30`.
    fn number(&mut self) {
        let rest = self.rest();
        let digits = |from: usize| {
            rest[from..]
                .find(|c: char| !c.is_ascii_digit() && c != '_')
                .map_or(rest.len(), |n| from + n)
        };
        let mut end = digits(0);
        let after = &rest[end..];
        let mut beyond = after.chars().skip(1);
        let fraction = after.starts_with('.')
            && !beyond
                .next()
                .is_some_and(|next| next == '.' || next == '_' || next.is_alphabetic());
        if fraction {
            end = digits(end + 1);
        }
        let exponent = rest[end..]
            .strip_prefix(['e', 'E'])
            .map(|after| after.strip_prefix(['+', '-']).unwrap_or(after));
        if let Some(after) =
            exponent.filter(|after| after.starts_with(|c: char| c.is_ascii_digit()))
        {
            end = digits(rest.len() - after.len());
        }
        end += word_length(&rest[end..]);
        self.push(TokenKind::Number, &rest[..end], end);
    }
}

/// Length of the word at the beginning, in bytes.
fn word_length(text: &str) -> usize {
    // Raised and lowered digits are numbers to Unicode and no part of a name to Rust.
    text.find(|c: char| !c.is_alphabetic() && !c.is_ascii_digit() && c != '_').unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        let lexed = lex_plain(text).unwrap();
        lexed.ranges.iter().map(|range| text[range.clone()].to_string()).collect()
    }

    #[test]
    fn numbers_take_their_suffix_and_leave_ranges_alone() {
        assert_eq!(
            words("75mm 1e-3 1..30 2.5e3 0.1 [kg]"),
            ["75mm", "1e-3", "1", ".", ".", "30", "2.5e3", "0.1", "[", "kg", "]"]
        );
    }

    #[test]
    fn comments_are_skipped_and_documentation_is_kept() {
        let lexed = lex_plain("// no\n/// yes\n/* no /* no */ */ φ2").unwrap();
        assert_eq!(lexed.tokens[0].kind, TokenKind::Documentation);
        assert_eq!(lexed.tokens[0].text, "yes");
        assert_eq!(lexed.tokens[1].text, "φ2");
        assert_eq!(lexed.tokens.len(), 2);
    }

    #[track_caller]
    fn check_error(text: &str, expected: &str) {
        let error = lex_file(text).unwrap_err();
        assert!(error.message.contains(expected), "{error:?}");
    }

    #[test]
    fn what_is_no_token_is_an_error() {
        check_error("assur::mechanism! { x = 90°; }", "`°`");
        check_error("assur::mechanism! { ( }", "`)` is expected first");
        check_error("assur::mechanism! { ", "never closed");
        check_error("assur::mechanism! { \"x }", "never closed");
        check_error("assur::mechanism! { } }", "closes nothing");
        check_error("fn main() {}", "one `assur::mechanism! { … }`");
        check_error("assur::mechanism! { } assur::mechanism! { }", "nothing is expected after");
    }

    #[test]
    fn files_that_are_no_text_are_refused() {
        assert!(text(b"").unwrap_err().message.contains("empty"));
        assert!(text(b" \n").unwrap_err().message.contains("empty"));
        assert!(text(&[0x7f, b'E', 0, 0]).unwrap_err().message.contains("binary"));
        assert!(text(&[b'a', 0xff, b'b']).unwrap_err().message.contains("byte 1"));
        assert!(text(&vec![b' '; 10 << 20]).unwrap_err().message.contains("10.0 MiB"));
    }
}
