//! A mechanism from texts that are at hand.

use assur_model::asked::Asked;
use assur_model::checked::{Compiled, Model};
use assur_model::lexer::{self, Unreadable};
use assur_model::texts::Texts;
use assur_model::token::Span;
use assur_registry::registry::Mechanism;

use crate::mechanism::{Origin, mechanism};

/// A mechanism once more, from the text that it was read or emitted from, with those of its scenes that are asked for; none
/// where it has errors, as what else is asked for may have.
///
/// # Errors
/// The text is none of an equation file.
pub fn again(of: &Mechanism, asked: Asked<'_>) -> Result<Option<Mechanism>, Unreadable> {
    with_model(of, asked, mechanism)
}

/// Does something with the model of a mechanism, likewise.
pub(crate) fn with_model<R>(
    of: &Mechanism,
    asked: Asked<'_>,
    work: impl FnOnce(&Model, &Origin<'_>) -> R,
) -> Result<Option<R>, Unreadable> {
    let lexed = lexer::lex_file(of.text)?;
    let mut texts = Texts::default();
    let compiled = assur_model::compile_asked(&lexed.tokens, asked, &mut |wanted| {
        let part = of.parts.iter().find(|(path, _)| *path == wanted.path);
        texts.lex(wanted, part.map_or("", |(_, text)| text).as_bytes())
    });
    let Compiled { model: Some(model), parts, .. } = compiled else {
        return Ok(None);
    };
    let lines = |span: Span| {
        let span = texts.place(&parts, span).map_or(span, |place| place.part);
        let start = lexed.ranges.get(span.first as usize).map_or(0, |range| range.start);
        of.text[..start].matches('\n').count() as u32 + 1
    };
    let (name, file, text) = (of.name, of.file, of.text);
    let origin = Origin { name, file, text, parts: of.parts.to_vec(), lines: &lines };
    Ok(Some(work(&model, &origin)))
}
