//! Tokens of an equation file: the language knows neither rustc's tokens nor characters beyond this page.

/// A range of tokens, by index, both ends included. Whoever made the tokens knows where they stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Index of the first token.
    pub first: u32,
    /// Index of the last token.
    pub last: u32,
}

impl Span {
    /// The span of one token.
    pub fn token(index: u32) -> Self {
        Self { first: index, last: index }
    }

    /// From the beginning of this span to the end of the other.
    pub fn to(self, other: Span) -> Self {
        Self { first: self.first, last: other.last }
    }
}

/// One token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What kind of token.
    pub kind: TokenKind,
    /// The text of a word, number (with its suffix, `75mm`), string (unquoted) or documentation line; else empty.
    pub text: String,
}

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// Identifier or keyword.
    Word,
    /// Number literal.
    Number,
    /// String literal.
    Text,
    /// One line of `///` documentation.
    Documentation,
    /// A punctuation character; `joint` when the next character is punctuation and follows at once.
    Punctuation {
        /// The character.
        character: char,
        /// Whether it may form one operator with the next token.
        joint: bool,
    },
    /// `(`, `[` or `{`.
    Open(char),
    /// `)`, `]` or `}`.
    Close(char),
    /// Anything that the language has no use for (a character literal, a lifetime); `text` shows it.
    Other,
}
