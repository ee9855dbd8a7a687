//! Golden files: the emitted Rust as people read it. `ASSUR_BLESS=1 cargo test -p assur-macros` writes them anew.

use std::path::Path;

use assur_emit::Origin;
use assur_model::checked::Model;
use assur_model::lexer::{self, Lexed};

/// A mechanism and the text between its braces.
fn compiled(text: &str) -> (Model, Lexed) {
    let lexed = lexer::lex_file(text).expect("the file can be read");
    let compiled = assur_model::compile(&lexed.tokens);
    let model = compiled.model;
    (model.unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics)), lexed)
}

/// The emitted items of some scenes of a mechanism.
fn emitted(text: &str, file: &str, is_kept: impl Fn(&str) -> bool) -> syn::File {
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
        part_of: &|_| None,
        parts: Vec::new(),
    };
    let items = assur_emit::mechanism(&model, &origin);
    syn::parse2(items).expect("the emitted items are Rust")
}

/// The types of the scenes, each with the implementations that follow it and named after it, so that a long module is
/// reviewed in pieces. The table and the tests are left out: those of a short mechanism show as much.
fn pieces(file: syn::File) -> Vec<(String, String)> {
    let content = file.items.into_iter().find_map(|item| match item {
        syn::Item::Mod(module) => module.content,
        _ => None,
    });
    let mut pieces: Vec<(String, syn::File)> = Vec::new();
    for item in content.expect("the items stand in a module").1 {
        match (&item, pieces.last_mut()) {
            (syn::Item::Struct(one), _) => {
                let name = assur_emit::names::snake(&one.ident.to_string());
                pieces.push((name, syn::parse_quote!(#item)));
            }
            (syn::Item::Mod(one), _) if one.ident == "shapes_" => {
                pieces.push(("shapes".to_owned(), syn::parse_quote!(#item)));
            }
            // What a position says, and events, are pieces of their own.
            (syn::Item::Impl(one), Some((name, _))) if layer(one).is_some() => {
                let stem = name.trim_end_matches("_equations").trim_end_matches("_reports");
                let name = format!("{stem}_{}", layer(one).unwrap_or_default());
                pieces.push((name, syn::parse_quote!(#item)));
            }
            (syn::Item::Impl(_) | syn::Item::Type(_) | syn::Item::Macro(_), Some((_, piece))) => {
                piece.items.push(item);
            }
            _ => {}
        }
    }
    let formatted = |(name, piece)| (name, prettyplease::unparse(&piece));
    pieces.into_iter().map(formatted).collect()
}

/// The layer that an implementation is of, if that has a piece of its own.
fn layer(implementation: &syn::ItemImpl) -> Option<&'static str> {
    let text = quote::quote!(#implementation).to_string();
    let is_of = |name: &str| text.contains(&format!(":: problem :: {name} < S > for"));
    [("Reports", "reports"), ("Events", "events")]
        .into_iter()
        .find(|(name, _)| is_of(name))
        .map(|(_, name)| name)
}

/// Compares with a golden file, or writes it.
#[track_caller]
fn check(name: &str, emitted: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/golden").join(name);
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

const BATTEN: &str = include_str!("../../equations/src/batten.eqn");

/// Compares a folder of golden files with the pieces of a module.
#[track_caller]
fn check_pieces(folder: &str, emitted: syn::File) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/golden");
    let pieces = pieces(emitted);
    for (name, rust) in &pieces {
        check(&format!("{folder}/{name}.rs"), rust);
    }
    let files = std::fs::read_dir(path.join(folder)).expect("the golden files can be listed");
    assert_eq!(files.count(), pieces.len(), "one file is not emitted");
}

#[test]
fn pendulum() {
    let text = include_str!("golden/pendulum.eqn");
    let emitted = emitted(text, "pendulum.eqn", |_| true);
    check("pendulum.rs", &prettyplease::unparse(&emitted));
}

#[test]
fn a_motion_with_modes_and_a_linkage() {
    let ball = include_str!("golden/ball.eqn");
    check_pieces("ball", emitted(ball, "ball.eqn", |_| true));
    let four_bar = include_str!("golden/four_bar.eqn");
    check_pieces("four_bar", emitted(four_bar, "four_bar.eqn", |_| true));
}

#[test]
fn batten_elastic() {
    let elastic = |name: &str| name == "elastic";
    check_pieces("batten_elastic", emitted(BATTEN, "batten.eqn", elastic));
}

#[test]
fn unary_signs_and_numbers_are_rust() {
    assert_eq!(assur_emit::names::identifier("2x").to_string(), "v2x_");
    assert_eq!(assur_emit::names::identifier("dot(x[3])").to_string(), "dot_x_3");
    assert_eq!(assur_emit::names::identifier("type").to_string(), "r#type");
    assert_eq!(assur_emit::names::identifier("φ2").to_string(), "φ2");
    assert_eq!(assur_emit::names::pascal("two_term"), "TwoTerm");
    assert_eq!(assur_emit::names::snake("HealdLinkage"), "heald_linkage");
}

#[test]
fn a_scene_with_a_number_of_its_own_is_not_stated_in_other_units() {
    let text = "assur::mechanism! {
        Spring from \"a textbook\";
        parameter m = 2 kg, c = 8 [N/m];
        coordinate x: m = 0.1 m;
        kinetic m*dot(x)^2/2;
        potential c*x^2/2;
        scene plain { output x; }
        scene far { output y = x + 3 mm; }
    }";
    let rust = prettyplease::unparse(&emitted(text, "spring.eqn", |_| true));
    assert_eq!(rust.matches("check::scaling(").count(), 1, "{rust}");
    assert!(rust.contains("Plain::from_values(values.try_into()"), "{rust}");
    let line = "/// Units: `3 mm` in spring.eqn:8 is no constant, so no test states the scene in other units.";
    assert_eq!(rust.matches(line).count(), 1, "{rust}");
}

/// A walk that visits a shared value once for each way to it never comes to an end here.
#[test]
fn the_time_to_emit_a_long_chain_does_not_explode() {
    let text = "assur::mechanism! {
        Chain from \"a textbook\";
        parameter l = 0.1 m, m = 0.2 kg, g = 9.81 [m/s^2];
        let x[0] = 0 m, y[0] = 0 m;
        for k in 1..16 {
            coordinate q[k]: rad = 0.1;
            let x[k] = x[k - 1] + l*sin(q[k]);
            let y[k] = y[k - 1] - l*cos(q[k]);
            kinetic m*(dot(x[k])^2 + dot(y[k])^2)/2;
            potential m*g*y[k];
        }
        output x[16], y[16];
        scene swing { run time 0 s .. 1 s; }
    }";
    let rust = prettyplease::unparse(&emitted(text, "chain.eqn", |_| true));
    assert!(rust.contains("pub struct Swing"), "{}", &rust[..rust.len().min(2000)]);
}
