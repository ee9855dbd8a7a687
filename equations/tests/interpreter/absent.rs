//! What a scene does not show costs it nothing: it is the same, token for token, where the file says nothing about the effects
//! that are absent.

use assur::registry::Mechanism;
use assur_emit::Origin;
use assur_equations::REGISTRY;
use assur_model::asked::Asked;
use assur_model::checked::SceneModel;
use assur_model::lexer;
use assur_model::texts::Texts;

/// A text without what stands in the bodies of some effects; its lines stay where they are.
fn emptied(text: &str, is_absent: impl Fn(&str) -> bool) -> String {
    let lexed = lexer::lex_file(text).expect("tokens");
    let words: Vec<&str> = lexed.ranges.iter().map(|range| &text[range.clone()]).collect();
    let mut bytes = text.as_bytes().to_vec();
    let mut begin = 0;
    while let Some(at) = words[begin..].iter().position(|word| *word == "effect") {
        begin += at + 1;
        let open = begin + words[begin..].iter().position(|word| *word == "{").expect("a body");
        if !is_absent(words[begin]) || open > begin + 2 {
            continue;
        }
        let mut depth = 0;
        let close = words[open..].iter().position(|word| {
            depth += i32::from(*word == "{") - i32::from(*word == "}");
            depth == 0
        });
        let close = open + close.expect("the end of a body");
        // Names that other statements ask for stay.
        if words[open..close].iter().any(|word| ["effect", "choice"].contains(word)) {
            continue;
        }
        begin = close;
        for byte in &mut bytes[lexed.ranges[open].end..lexed.ranges[begin].start] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
    }
    String::from_utf8(bytes).expect("text")
}

/// What the compiler makes of one scene: the Rust text of all of it, and the program that the interpreter reads; or why it refuses
/// it.
fn compiled(of: &Mechanism, text: &str, scene: &str) -> Result<(String, String), String> {
    let lexed = lexer::lex_file(text).expect("tokens");
    let mut texts = Texts::default();
    let asked = Asked::Some(&[scene]);
    let compiled = assur_model::compile_asked(&lexed.tokens, asked, &mut |wanted| {
        let part = of.parts.iter().find(|(path, _)| *path == wanted.path);
        texts.lex(wanted, part.map_or("", |(_, text)| text).as_bytes())
    });
    let refused = || format!("{} {scene}: {:?}", of.name, compiled.diagnostics);
    let mut model = compiled.model.ok_or_else(refused)?;
    // The tables of the whole file name all effects.
    (model.effects, model.choices, model.presets) = (Vec::new(), Vec::new(), Vec::new());
    model.documentation = String::new();
    let origin = Origin {
        file: of.file.to_owned(),
        has_file: false,
        line_of: &|_| 0,
        part_of: &|_| None,
        parts: Vec::new(),
    };
    Ok((assur_emit::mechanism(&model, &origin).to_string(), program(&model.scenes[0])))
}

/// A scene as text, without places in the file.
fn program(scene: &SceneModel) -> String {
    let text = format!("{scene:?}");
    let mut pieces = text.split("Span {");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| text + piece.split_once('}').map_or(piece, |parts| parts.1))
}

#[test]
fn a_scene_has_nothing_of_effects_that_are_absent() {
    let (mut same, mut other) = (0, 0);
    for of in REGISTRY.iter().filter(|of| !of.effects.is_empty()) {
        for scene in of.scenes {
            let whole = compiled(of, of.text, scene.name).expect("a scene of the file");
            let is_absent = |name: &str| !scene.effects.contains(&name);
            let without = emptied(of.text, is_absent);
            if without != of.text {
                let rest = compiled(of, &without, scene.name).expect("nothing of it is missing");
                assert!(whole.0 == rest.0, "{} {}: emitted code", of.name, scene.name);
                assert!(whole.1 == rest.1, "{} {}: program", of.name, scene.name);
                same += 1;
            }
        }
        // And what is there counts: the comparison would tell.
        let scene = of.scenes.iter().find(|scene| scene.effects.len() == 1);
        if let Some(scene) = scene {
            let without = emptied(of.text, |name| scene.effects.contains(&name));
            if without == of.text {
                continue;
            }
            let whole = compiled(of, of.text, scene.name);
            other += usize::from(compiled(of, &without, scene.name) != whole);
        }
    }
    assert!(same > 100 && other > 5, "{same} {other}");
}
