//! The texts of the files that parts are read from: their tokens for the compiler, and the places that it names later.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::ops::Range;
use std::path::Path;

use crate::checked::PartFile;
use crate::flatten::Wanted;
use crate::lexer::{self, LARGEST_FILE, Unreadable};
use crate::token::{Span, Token, TokenKind};

/// Texts by path, with the places of their tokens.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    files: BTreeMap<String, (String, Vec<Range<usize>>)>,
}

/// A place in the file of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location<'a> {
    /// Path of the file, relative to the main one.
    pub path: &'a str,
    /// The whole text.
    pub text: &'a str,
    /// The bytes meant.
    pub range: Range<usize>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Where the main file names the part.
    pub part: Span,
}

impl Texts {
    /// The tokens of a file that lies in or below a folder.
    ///
    /// # Errors
    /// It is not there, or is no equation file.
    pub fn read(&mut self, folder: &Path, wanted: &Wanted) -> Result<Vec<Token>, Unreadable> {
        let path = &wanted.path;
        let place = folder.join(path);
        let wrong = |message: String| Unreadable { range: 0..0, message, hint: None };
        let missing = || {
            let shown = place.display();
            wrong(format!("there is no file `{path}` beside this one (looked for `{shown}`)"))
        };
        let failed = |error: std::io::Error| match error.kind() {
            ErrorKind::NotFound => missing(),
            _ => wrong(format!("the file `{path}` cannot be read: {error}")),
        };
        // Whatever else bears the name, a folder or a pipe, is never opened.
        if !place.metadata().map_err(failed)?.is_file() {
            return Err(missing());
        }
        let mut bytes = Vec::new();
        File::open(&place)
            .and_then(|file| file.take(LARGEST_FILE as u64 + 1).read_to_end(&mut bytes))
            .map_err(failed)?;
        self.lex(wanted, &bytes)
    }

    /// The tokens of a file that is at hand.
    ///
    /// # Errors
    /// It is no equation file.
    pub fn lex(&mut self, wanted: &Wanted, bytes: &[u8]) -> Result<Vec<Token>, Unreadable> {
        let (path, what) = (&wanted.path, if wanted.is_sheet { "table" } else { "part" });
        let cannot = |error: Unreadable, place: String| Unreadable {
            range: 0..0,
            message: format!("the file of the {what} cannot be read: {place}: {}", error.message),
            hint: error.hint.filter(|_| !wanted.is_sheet),
        };
        let text = lexer::text(bytes).map_err(|error| cannot(error, path.to_string()))?;
        if wanted.is_sheet {
            let whole = std::iter::once(0..text.len()).collect();
            self.files.insert(path.to_string(), (text.to_string(), whole));
            return Ok(vec![Token { kind: TokenKind::Text, text: text.to_string() }]);
        }
        let lexed = lexer::lex_file(text).map_err(|error| {
            let (line, column) = line_and_column(text, error.range.start);
            cannot(error, format!("{path}:{line}:{column}"))
        })?;
        self.files.insert(path.to_string(), (text.to_string(), lexed.ranges));
        Ok(lexed.tokens)
    }

    /// The tokens of statements that are no file, kept under a path as if they were one.
    ///
    /// # Errors
    /// They are no tokens.
    pub fn lex_statements(&mut self, path: &str, text: &str) -> Result<Vec<Token>, Unreadable> {
        let lexed = lexer::lex_plain(text)?;
        self.files.insert(path.to_owned(), (text.to_owned(), lexed.ranges));
        Ok(lexed.tokens)
    }

    /// The text of a file that has been read.
    pub fn text(&self, path: &str) -> Option<&str> {
        self.files.get(path).map(|(text, _)| text.as_str())
    }

    /// Where a range of tokens stands, if in the file of a part.
    pub fn place(&self, parts: &[PartFile], span: Span) -> Option<Location<'_>> {
        let part = parts.iter().rfind(|part| part.first <= span.first)?;
        let (path, (text, ranges)) = self.files.get_key_value(&part.path)?;
        let of = |index: u32| ranges.get((index - part.first) as usize).cloned();
        let first = of(span.first)?;
        let last = of(span.last.max(span.first)).unwrap_or(first.clone());
        let (line, column) = line_and_column(text, first.start);
        Some(Location {
            path,
            text,
            range: first.start..last.end.max(first.end),
            line,
            column,
            part: part.place,
        })
    }
}

/// Line and column of a byte, from 1.
fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.rsplit('\n').next().unwrap_or(before);
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIFT: &str = "assur::mechanism! {\n    Lift;\n    let µ = 2*a;\n}\n";

    fn wanted(path: &str) -> Wanted {
        Wanted { path: path.into(), place: Span::default(), is_sheet: false }
    }

    #[test]
    fn tokens_are_found_again() {
        let mut texts = Texts::default();
        assert_eq!(texts.lex(&wanted("lift.eqn"), LIFT.as_bytes()).unwrap().len(), 9);
        let part = Span { first: 3, last: 5 };
        let parts = [PartFile { path: "lift.eqn".into(), first: 20, place: part }];
        assert_eq!(texts.place(&parts, Span::token(19)), None);
        let found = texts.place(&parts, Span { first: 25, last: 27 }).unwrap();
        assert_eq!((found.line, found.column, found.part), (3, 13, part));
        assert_eq!(&LIFT[found.range], "2*a");
    }

    #[test]
    fn what_is_no_file_of_tokens_says_where() {
        let mut texts = Texts::default();
        let error = texts.lex(&wanted("a/lift.eqn"), LIFT.replace("2*a", "2*(a").as_bytes());
        assert_eq!(
            error.unwrap_err().message,
            "the file of the part cannot be read: a/lift.eqn:4:1: found `}`, but `)` is expected first"
        );
        let error = texts.lex(&wanted("lift.eqn"), b"\0");
        assert_eq!(
            error.unwrap_err().message,
            "the file of the part cannot be read: lift.eqn: the file is binary, not text"
        );
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        for path in ["no_such.eqn", "src"] {
            let message = texts.read(folder, &wanted(path)).unwrap_err().message;
            let start = format!("there is no file `{path}` beside this one (looked for `");
            assert!(message.starts_with(&start), "{message}");
        }
    }
}
