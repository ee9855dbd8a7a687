//! Messages of the language as messages of rustc, underlined in the equation file.
//!
//! rustc gives a macro one place and one text for each message. So the second place, and the hint, are part of the
//! text. A macro cannot warn, so a warning is an expectation that rustc finds unfulfilled: of all that rustc warns of, the
//! one that claims nothing about the equations. A note is left to the command.

use std::path::PathBuf;

use assur_model::diagnostic::{Diagnostic, Severity};
use assur_model::texts::Location;
use assur_model::token::Span;
use proc_macro2::{Delimiter, Group, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use crate::tokens::Source;

/// All messages as items.
pub fn items(diagnostics: &[Diagnostic], source: &Source) -> TokenStream {
    diagnostics
        .iter()
        .map(|diagnostic| {
            let (first, last) = source.places(diagnostic.span);
            let text = text(diagnostic, source);
            match diagnostic.severity {
                Severity::Error => error(first, last, &text),
                Severity::Warning => warning(first, &text),
                Severity::Note => TokenStream::new(),
            }
        })
        .collect()
}

/// `::core::compile_error! { "…" }`; its path has the first place and its braces the last, and rustc underlines from
/// one to the other.
pub fn error(first: proc_macro2::Span, last: proc_macro2::Span, text: &str) -> TokenStream {
    let mut literal = Literal::string(text);
    literal.set_span(last);
    let mut group = Group::new(Delimiter::Brace, TokenStream::from(TokenTree::from(literal)));
    group.set_span(last);
    let mut exclamation = Punct::new('!', Spacing::Alone);
    exclamation.set_span(first);
    let path = quote_spanned!(first=> ::core::compile_error);
    quote!(#path #exclamation #group)
}

/// A lint that cannot occur here is expected, and rustc gives the text as the reason why it was. The name of the lint has
/// the place as rustc gave it: a place of the expansion would make this a lint of a foreign macro, which rustc drops.
fn warning(place: proc_macro2::Span, text: &str) -> TokenStream {
    let lint = quote_spanned!(place=> while_true);
    quote! {
        #[expect(#lint, reason = #text)]
        const _: () = ();
    }
}

/// What was found and expected, the place if rustc does not know it, the second place, the hint.
fn text(diagnostic: &Diagnostic, source: &Source) -> String {
    let mut text = diagnostic.message.clone();
    if let Some(place) = source.part(diagnostic.span) {
        text += &format!("\n{}", in_part(&place, source));
    }
    if let Some((span, words)) = &diagnostic.related {
        text += &match excerpt(*span, source) {
            Some(excerpt) => format!("\nnote: {words}\n{excerpt}"),
            None => format!("\nnote: {words}"),
        };
    }
    if let Some(hint) = &diagnostic.hint {
        text += &format!("\nhelp: {hint}");
    }
    text
}

/// The place, `FILE:LINE:COLUMN`, and the line there with the place underlined. Nothing outside of rustc.
fn excerpt(span: Span, source: &Source) -> Option<String> {
    if let Some(place) = source.part(span) {
        return Some(in_part(&place, source));
    }
    if !proc_macro::is_available() {
        return None;
    }
    let (first, last) = source.places(span);
    let (first, last) = (first.unwrap(), last.unwrap());
    let (line, column) = (first.line(), first.column());
    let text = first.local_file().and_then(|path| std::fs::read_to_string(path).ok());
    let end = last.end();
    let width = if end.line() == line { end.column().saturating_sub(column) } else { 0 };
    let text = text.unwrap_or_default();
    Some(underlined(&first.file(), &text, (line, column), width))
}

/// A place in the file of a part.
fn in_part(place: &Location<'_>, source: &Source) -> String {
    let main = match proc_macro::is_available() {
        true => PathBuf::from(source.places(place.part).1.unwrap().file()),
        false => PathBuf::new(),
    };
    let file = main.with_file_name(place.path);
    let meant = place.text.get(place.range.clone()).unwrap_or_default();
    let width = match meant.contains('\n') {
        true => 0,
        false => meant.chars().count(),
    };
    let file = file.display().to_string();
    underlined(&file, place.text, (place.line, place.column), width)
}

/// A line of a text with so many characters of it underlined; only where it is when the text is not at hand.
fn underlined(file: &str, text: &str, (line, column): (usize, usize), width: usize) -> String {
    let place = format!("   --> {file}:{line}:{column}");
    let Some(shown) = text.lines().nth(line.wrapping_sub(1)) else {
        return place;
    };
    let width = width.clamp(1, shown.chars().count().max(1));
    let margin = " ".repeat(line.to_string().len());
    let under = format!("{}{}", " ".repeat(column.saturating_sub(1)), "^".repeat(width));
    format!("{place}\n{margin} |\n{line} | {shown}\n{margin} | {under}")
}
