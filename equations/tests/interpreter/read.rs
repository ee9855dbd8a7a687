//! A mechanism from the text that it was emitted from.

use assur::registry::Mechanism;
use assur_interpreter::{Origin, mechanism as interpret};
use assur_model::lexer;
use assur_model::texts::Texts;
use assur_model::token::Span;

/// The mechanism, interpreted.
pub fn mechanism(emitted: &Mechanism) -> &'static Mechanism {
    let lexed = lexer::lex_file(emitted.text).expect("tokens");
    let mut texts = Texts::default();
    let compiled = assur_model::compile_with(&lexed.tokens, &mut |wanted| {
        let part = emitted.parts.iter().find(|(path, _)| *path == wanted.path);
        texts.lex(wanted, part.map_or("", |(_, text)| text).as_bytes())
    });
    let model = compiled.model.expect("a file without errors");
    let lines = |span: Span| {
        let span = texts.place(&compiled.parts, span).map_or(span, |place| place.part);
        let start = lexed.ranges.get(span.first as usize).map_or(0, |range| range.start);
        emitted.text[..start].matches('\n').count() as u32 + 1
    };
    let origin = Origin {
        name: emitted.name,
        file: emitted.file,
        text: emitted.text,
        parts: emitted.parts.to_vec(),
        lines: &lines,
    };
    Box::leak(Box::new(interpret(&model, &origin)))
}
