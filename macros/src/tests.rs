//! Golden files: the emitted Rust as people read it. `ASSUR_BLESS=1 cargo test -p assur-macros` writes them anew.

use std::path::Path;

use assur_model::checked::Model;
use assur_model::lexer::{self, Lexed};

use crate::emit::{self, Origin};

/// A mechanism and the text between its braces.
fn compiled(text: &str) -> (Model, Lexed) {
    let lexed = lexer::lex_file(text).expect("the file can be read");
    let compiled = assur_model::compile(&lexed.tokens);
    let model = compiled.model;
    (
        model.unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics)),
        lexed,
    )
}

/// The emitted items of some scenes of a mechanism, formatted.
fn emitted(text: &str, file: &str, is_kept: impl Fn(&str) -> bool) -> String {
    let (mut model, lexed) = compiled(text);
    model.scenes.retain(|scene| is_kept(&scene.name));
    let line_of = |span: assur_model::token::Span| {
        let start = lexed.ranges[span.first as usize].start;
        1 + text[..start].matches('\n').count() as u32
    };
    let origin = Origin {
        file: file.to_owned(),
        has_file: false,
        line_of: &line_of,
    };
    let items = emit::mechanism(&model, &origin);
    let file = syn::parse2(items).expect("the emitted items are Rust");
    prettyplease::unparse(&file)
}

/// Compares with a golden file, or writes it.
#[track_caller]
fn check(name: &str, emitted: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("src/golden")
        .join(name);
    if std::env::var_os("ASSUR_BLESS").is_some() {
        std::fs::write(&path, emitted).expect("the golden file can be written");
    }
    let golden = std::fs::read_to_string(&path).unwrap_or_default();
    let mut pairs = golden.lines().zip(emitted.lines()).enumerate();
    if let Some((index, (old, new))) = pairs.find(|(_, (old, new))| old != new) {
        panic!(
            "{name}:{}: emitted code has changed\n  from {old}\n  to   {new}\nif that is right, run with ASSUR_BLESS=1",
            index + 1
        );
    }
    assert_eq!(golden.lines().count(), emitted.lines().count(), "{name}");
}

const PENDULUM: &str = include_str!("golden/pendulum.eqn");
const BATTEN: &str = include_str!("../../equations/src/batten.eqn");

#[test]
fn pendulum() {
    check("pendulum.rs", &emitted(PENDULUM, "pendulum.eqn", |_| true));
}

#[test]
fn batten_elastic() {
    let emitted = emitted(BATTEN, "batten.eqn", |name| name == "elastic");
    check("batten_elastic.rs", &emitted);
}

#[test]
fn unary_signs_and_numbers_are_rust() {
    assert_eq!(emit::names::identifier("2x").to_string(), "v2x_");
    assert_eq!(emit::names::identifier("dot(x[3])").to_string(), "dot_x_3");
    assert_eq!(emit::names::identifier("type").to_string(), "r#type");
    assert_eq!(emit::names::identifier("φ2").to_string(), "φ2");
    assert_eq!(emit::names::pascal("two_term"), "TwoTerm");
    assert_eq!(emit::names::snake("HealdLinkage"), "heald_linkage");
}
