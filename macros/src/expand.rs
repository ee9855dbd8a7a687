//! `mechanism!`: equations in, items out. Broken equations give their messages and empty items.

use std::path::Path;

use assur_emit::Origin;
use assur_model::checked::{Compiled, Model, SceneModel};
use assur_model::diagnostic::{Diagnostic, Diagnostics, Severity};
use proc_macro2::TokenStream;
use quote::quote;

use crate::parts::Parts;
use crate::report;
use crate::tokens::Source;

/// Expands the macro.
pub fn mechanism(input: TokenStream) -> TokenStream {
    let mut source = Source::read(input);
    let mut parts = Parts::default();
    let Compiled { name, scene_names, model, diagnostics, parts: files, .. } =
        assur_model::compile_with(&source.tokens, &mut |wanted| parts.load(wanted, &source));
    let mut all = Diagnostics::default();
    all.extend(diagnostics);
    (source.parts, source.texts) = (files, parts.texts);
    let diagnostics: Vec<Diagnostic> = all.into_sorted();
    let broken = diagnostics.iter().any(|one| one.severity == Severity::Error);
    let model = model.filter(|_| !broken).unwrap_or_else(|| stub(&name, &scene_names));
    let (file, has_file) = file(&source);
    let line_of = |span| line(&source, span);
    let part_of = |span| {
        let place = source.part(span)?;
        Some((place.path.to_owned(), place.line as u32))
    };
    let origin = Origin {
        file,
        has_file,
        line_of: &line_of,
        part_of: &part_of,
        parts: source.parts.iter().map(|part| part.path.clone()).collect(),
    };
    let items = assur_emit::mechanism(&model, &origin);
    let report = report::items(&diagnostics, &source);
    let used = parts.used;
    quote!(#report #used #items)
}

/// Name of the file that the equations stand in, and whether it is an equation file.
fn file(source: &Source) -> (String, bool) {
    if !proc_macro::is_available() {
        return (String::new(), false);
    }
    let file = source.places(Default::default()).0.unwrap().file();
    let name = Path::new(&file)
        .file_name()
        .map_or(String::new(), |name| name.to_string_lossy().into_owned());
    let has_file = name.ends_with(".eqn");
    (name, has_file)
}

/// The line of a place, from 1.
fn line(source: &Source, span: assur_model::token::Span) -> u32 {
    match proc_macro::is_available() {
        true => source.places(span).0.unwrap().line() as u32,
        false => 0,
    }
}

/// A mechanism with nothing in it, so that what uses a broken one reports nothing of its own.
fn stub(name: &str, scenes: &[String]) -> Model {
    let name = if name.is_empty() { "Mechanism" } else { name };
    let empty = |scene: &String| SceneModel { name: scene.clone(), ..SceneModel::default() };
    Model {
        name: name.to_owned(),
        documentation: String::new(),
        source: String::new(),
        effects: Vec::new(),
        choices: Vec::new(),
        presets: Vec::new(),
        scenes: scenes.iter().map(empty).collect(),
    }
}
