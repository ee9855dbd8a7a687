//! rustc's tokens as the language's own: a flat list, and beside it the table of their places.

use assur_model::checked::PartFile;
use assur_model::texts::{self, Texts};
use assur_model::token::{Span, Token, TokenKind};
use proc_macro2::{Delimiter, Group, Literal, Spacing, TokenStream, TokenTree};
use syn::Lit;

/// A place as rustc knows it.
type RustSpan = proc_macro2::Span;

/// The tokens of an equation file with their places.
#[derive(Default)]
pub struct Source {
    /// The tokens.
    pub tokens: Vec<Token>,
    places: Vec<RustSpan>,
    /// The files of parts that were read.
    pub parts: Vec<PartFile>,
    /// Their texts.
    pub texts: Texts,
}

impl Source {
    /// Reads the input of the macro.
    pub fn read(input: TokenStream) -> Self {
        let mut source = Self::default();
        source.all(input);
        source
    }

    /// Where a span stands, if in the file of a part: rustc knows nothing of those.
    pub fn part(&self, span: Span) -> Option<texts::Location<'_>> {
        self.texts.place(&self.parts, span)
    }

    /// The places of the first and the last token of a span; of the part that is meant, if it stands in its file.
    pub fn places(&self, span: Span) -> (RustSpan, RustSpan) {
        let span = self.part(span).map_or(span, |place| place.part);
        let at = |index: u32| {
            let last = self.places.len().saturating_sub(1);
            self.places.get((index as usize).min(last)).copied().unwrap_or_else(RustSpan::call_site)
        };
        (at(span.first), at(span.last.max(span.first)))
    }

    fn all(&mut self, input: TokenStream) {
        let mut trees = input.into_iter().peekable();
        while let Some(tree) = trees.next() {
            let is_hash = matches!(&tree, TokenTree::Punct(punct) if punct.as_char() == '#');
            match trees.peek() {
                Some(TokenTree::Group(group)) if is_hash => match documentation(group) {
                    Some(text) => {
                        let place = tree.span();
                        // An empty line between paragraphs is a line, of which `lines` knows nothing.
                        text.split('\n')
                            .for_each(|line| self.push(TokenKind::Documentation, line, place));
                        trees.next();
                    }
                    None => self.one(tree),
                },
                _ => self.one(tree),
            }
        }
    }

    fn one(&mut self, tree: TokenTree) {
        let place = tree.span();
        match tree {
            TokenTree::Ident(word) => {
                let word = word.to_string();
                self.push(TokenKind::Word, word.strip_prefix("r#").unwrap_or(&word), place);
            }
            TokenTree::Punct(punct) => {
                let joint = punct.spacing() == Spacing::Joint;
                self.push(TokenKind::Punctuation { character: punct.as_char(), joint }, "", place);
            }
            TokenTree::Literal(literal) => {
                let (kind, text) = read_literal(literal);
                self.push(kind, &text, place);
            }
            TokenTree::Group(group) => match group.delimiter() {
                Delimiter::Parenthesis => self.group(&group, '(', ')'),
                Delimiter::Bracket => self.group(&group, '[', ']'),
                Delimiter::Brace => self.group(&group, '{', '}'),
                Delimiter::None => self.all(group.stream()),
            },
        }
    }

    fn group(&mut self, group: &Group, open: char, close: char) {
        self.push(TokenKind::Open(open), "", group.span_open());
        self.all(group.stream());
        self.push(TokenKind::Close(close), "", group.span_close());
    }

    fn push(&mut self, kind: TokenKind, text: &str, place: RustSpan) {
        self.tokens.push(Token { kind, text: text.to_owned() });
        self.places.push(place);
    }
}

/// The text of `[doc = "…"]`, which is what rustc makes of `/// …`.
fn documentation(group: &Group) -> Option<String> {
    let mut inner = group.stream().into_iter();
    match (group.delimiter(), inner.next(), inner.next(), inner.next(), inner.next()) {
        (
            Delimiter::Bracket,
            Some(TokenTree::Ident(word)),
            Some(TokenTree::Punct(equals)),
            Some(TokenTree::Literal(text)),
            None,
        ) if word == "doc" && equals.as_char() == '=' => match read_literal(text) {
            (TokenKind::Text, text) => {
                Some(text.strip_prefix(' ').map(str::to_owned).unwrap_or(text))
            }
            _ => None,
        },
        _ => None,
    }
}

fn read_literal(literal: Literal) -> (TokenKind, String) {
    let text = literal.to_string();
    match Lit::new(literal) {
        Lit::Str(string) => (TokenKind::Text, string.value()),
        Lit::Int(_) | Lit::Float(_) => (TokenKind::Number, text),
        _ if text.starts_with(|first: char| first.is_ascii_digit()) => (TokenKind::Number, text),
        _ => (TokenKind::Other, text),
    }
}
