//! Walks over tokens.

use super::{Parser, Read, Reported};
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::Name;
use crate::token::{Span, Token, TokenKind};

/// A place among the tokens.
pub struct Cursor<'a> {
    tokens: &'a [Token],
    /// What the first token is counted as: the files of a model are counted through.
    first: u32,
    /// Index of the next token.
    pub at: usize,
}

impl<'a> Cursor<'a> {
    pub fn new(tokens: &'a [Token], first: u32) -> Self {
        Self { tokens, first, at: 0 }
    }

    /// The token so many places ahead.
    pub fn ahead(&self, count: usize) -> Option<&'a Token> {
        self.tokens.get(self.at + count)
    }

    /// The token so many places before the next one.
    pub fn behind(&self, count: usize) -> Option<&'a Token> {
        self.tokens.get(self.at.checked_sub(count)?)
    }

    fn kind(&self, count: usize) -> Option<TokenKind> {
        self.ahead(count).map(|token| token.kind)
    }
}

impl Parser<'_> {
    /// Span of the next token; of the last one at the end.
    pub(super) fn here(&self) -> Span {
        let last = self.cursor.tokens.len().saturating_sub(1);
        Span::token(self.cursor.first + self.cursor.at.min(last) as u32)
    }

    /// Span of the token before.
    pub(super) fn before(&self) -> Span {
        Span::token(self.cursor.first + self.cursor.at.saturating_sub(1) as u32)
    }

    /// From a span to the token before.
    pub(super) fn since(&self, start: Span) -> Span {
        Span { first: start.first, last: self.before().last.max(start.first) }
    }

    pub(super) fn at_end(&self) -> bool {
        self.cursor.at >= self.cursor.tokens.len()
    }

    pub(super) fn advance(&mut self) {
        self.cursor.at += 1;
    }

    /// Whether the token so many places ahead is this word.
    pub(super) fn is_word_ahead(&self, count: usize, word: &str) -> bool {
        self.cursor
            .ahead(count)
            .is_some_and(|token| token.kind == TokenKind::Word && token.text == word)
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        self.is_word_ahead(0, word)
    }

    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.cursor.at += usize::from(found);
        found
    }

    pub(super) fn is_any_word(&self) -> bool {
        self.cursor.kind(0) == Some(TokenKind::Word)
    }

    /// Whether the tokens from so many places ahead are this operator, and nothing longer that begins with it.
    pub(super) fn is_operator_ahead(&self, count: usize, operator: &str) -> bool {
        let length = operator.chars().count();
        operator.chars().enumerate().all(|(index, wanted)| match self.cursor.kind(count + index) {
            Some(TokenKind::Punctuation { character, joint }) => {
                character == wanted && (joint || index + 1 == length)
            }
            _ => false,
        })
    }

    pub(super) fn is_operator(&self, operator: &str) -> bool {
        self.is_operator_ahead(0, operator)
    }

    pub(super) fn take_operator(&mut self, operator: &str) -> bool {
        let found = self.is_operator(operator);
        if found {
            self.cursor.at += operator.chars().count();
        }
        found
    }

    pub(super) fn is_open_ahead(&self, count: usize, bracket: char) -> bool {
        self.cursor.kind(count) == Some(TokenKind::Open(bracket))
    }

    pub(super) fn take_open(&mut self, bracket: char) -> bool {
        let found = self.is_open_ahead(0, bracket);
        self.cursor.at += usize::from(found);
        found
    }

    pub(super) fn is_close(&self, bracket: char) -> bool {
        self.cursor.kind(0) == Some(TokenKind::Close(bracket))
    }

    pub(super) fn take_close(&mut self, bracket: char) -> bool {
        let found = self.is_close(bracket);
        self.cursor.at += usize::from(found);
        found
    }

    /// How many tokens the index has that begins so many places ahead; none if there is none.
    pub(super) fn index_length(&self, count: usize) -> usize {
        if !self.is_open_ahead(count, '[') {
            return 0;
        }
        let mut depth = 0_usize;
        for (length, token) in self.cursor.tokens[self.cursor.at + count..].iter().enumerate() {
            match token.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) if depth == 1 => return length + 1,
                TokenKind::Close(_) => depth -= 1,
                _ => {}
            }
        }
        0
    }

    /// The next token in words.
    pub(super) fn found(&self) -> String {
        match self.cursor.ahead(0) {
            None => "the end".into(),
            Some(token) => match token.kind {
                TokenKind::Punctuation { character, .. } => format!("`{character}`"),
                TokenKind::Open(bracket) | TokenKind::Close(bracket) => format!("`{bracket}`"),
                TokenKind::Text => format!("the text \"{}\"", token.text),
                TokenKind::Documentation => "documentation".into(),
                _ => format!("`{}`", token.text),
            },
        }
    }

    /// Reports the next token, which is not what is expected.
    pub(super) fn expected<T>(&mut self, what: &str) -> Read<T> {
        let message = format!("found {}, expected {what}", self.found());
        self.wrong(message, self.slip())
    }

    /// Reports a mistake at the next token.
    pub(super) fn wrong<T>(&mut self, message: impl Into<String>, hint: Option<&str>) -> Read<T> {
        self.wrong_at(self.here(), message, hint)
    }

    pub(super) fn wrong_at<T>(
        &mut self,
        span: Span,
        message: impl Into<String>,
        hint: Option<&str>,
    ) -> Read<T> {
        let mut report = Diagnostic::error(span, message);
        if let Some(hint) = hint {
            report = report.hint(hint);
        }
        self.diagnostics.push(report);
        Err(Reported)
    }

    pub(super) fn operator(&mut self, operator: &str) -> Read<()> {
        if self.take_operator(operator) { Ok(()) } else { self.expected(&format!("`{operator}`")) }
    }

    pub(super) fn open(&mut self, bracket: char) -> Read<()> {
        if self.take_open(bracket) { Ok(()) } else { self.expected(&format!("`{bracket}`")) }
    }

    pub(super) fn close(&mut self, bracket: char) -> Read<()> {
        if self.take_close(bracket) { Ok(()) } else { self.expected(&format!("`{bracket}`")) }
    }

    /// Nothing may follow.
    pub(super) fn end(&mut self, what: &str) -> Read<()> {
        if self.at_end() { Ok(()) } else { self.expected(&format!("the end {what}")) }
    }

    /// A name.
    pub(super) fn name(&mut self, what: &str) -> Read<Name> {
        match self.cursor.ahead(0) {
            Some(token) if token.kind == TokenKind::Word => {
                let name = Name { text: token.text.clone(), span: self.here() };
                self.advance();
                Ok(name)
            }
            _ => self.expected(what),
        }
    }

    /// A name, perhaps of a part: `phi`, `feed.phi`, `feed.lift.l_v`.
    pub(super) fn path(&mut self, what: &str) -> Read<Name> {
        let mut path = self.name(what)?;
        while self.is_operator(".") && !self.is_operator("..") {
            self.advance();
            path = within(path, &self.name("a name after `.`")?);
        }
        Ok(path)
    }

    /// A text in quotation marks, if one follows.
    pub(super) fn text(&mut self) -> Option<String> {
        let token = self.cursor.ahead(0).filter(|token| token.kind == TokenKind::Text)?;
        self.advance();
        Some(token.text.clone())
    }

    /// Lines of documentation, if some follow.
    pub(super) fn documentation(&mut self) -> Vec<String> {
        let mut lines = Vec::new();
        while let Some(token) =
            self.cursor.ahead(0).filter(|token| token.kind == TokenKind::Documentation)
        {
            lines.push(token.text.clone());
            self.advance();
        }
        lines
    }

    /// Gives up the statement that begins at `begin`, in which a mistake was found at the next token. Goes on behind
    /// the `;` or the block that ends it; stops before the end of the block around.
    pub(super) fn skip_statement(&mut self, begin: usize) {
        let mistake = std::mem::replace(&mut self.cursor.at, begin);
        let mut depth = 0_usize;
        while let Some(token) = self.cursor.ahead(0) {
            let beyond = self.cursor.at >= mistake;
            match token.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) if depth == 0 => break,
                TokenKind::Close(bracket) => {
                    depth -= 1;
                    if beyond && depth == 0 && bracket == '}' && !self.is_word_ahead(1, "else") {
                        self.advance();
                        let _ = self.take_operator(";");
                        break;
                    }
                }
                TokenKind::Punctuation { character: ';', .. } if depth == 0 && beyond => {
                    self.advance();
                    break;
                }
                _ => {}
            }
            self.advance();
        }
        if self.cursor.at == begin {
            self.advance();
        }
        let skipped = self.cursor.tokens.get(begin..self.cursor.at).unwrap_or_default();
        let words = skipped.iter().filter(|token| token.kind == TokenKind::Word);
        self.unread.extend(words.map(|token| token.text.clone()));
    }
}

/// A name of a part as one name, `feed.phi`.
pub(super) fn within(base: Name, name: &Name) -> Name {
    Name { text: format!("{}.{}", base.text, name.text), span: base.span.to(name.span) }
}
