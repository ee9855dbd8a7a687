//! Mechanisms inside others: what they come to, and what is said about wrong ones.

use std::cell::RefCell;

use assur_model::checked::{Compiled, SceneModel};
use assur_model::lexer::{Lexed, Unreadable, lex_plain};
use assur_model::program::Input;
use assur_model::token::Span;

use super::{Expected, check_messages, words};

/// The files of parts: path and text.
type Files = [(&'static str, &'static str)];

/// A crank that swings a rocker by a rod.
const FOUR_BAR: &str = "FourBar;
    /// Length of the crank.
    dimension crank = 30 mm +- 0.05 mm in 10 mm .. 40 mm;
    dimension rod = 90 mm, rocker = 60 mm, base = 80 mm;
    driver phi ~ 60 deg in 0 deg .. 360 deg;
    dependent psi ~ 20 deg, chi ~ 80 deg;
    closure loop: crank*dir(phi) + rod*dir(psi) = [base, 0] + rocker*dir(chi);
    point A = [0, 0], B = crank*dir(phi), C = B + rod*dir(psi), D = [base, 0];
    link A - B \"crank\", B - C, C - D;
    let reach(x) = x + crank;
    require crank < rod \"the crank turns round\";
    output swing = chi - 90 deg;
    mark \"start\" at phi = 0;
    scene turn { sweep phi; }
    expect at phi = 60 deg: swing = 0 +- 100 deg;";

/// A slide that a four-bar moves.
const FEED: &str = "Feed;
    driver theta in 0 deg .. 360 deg;
    part lift: FourBar from \"../four_bar.eqn\" { phi = theta + lead; crank = 20 mm +- 0.1 mm; }
    parameter lead = 10 deg;
    let rise = lift.rod*sin(lift.swing);
    output tooth = rise;
    scene go { sweep theta; }";

/// Compiles a file with parts. Gives the model with the files that were read, texts and tokens.
#[track_caller]
fn compiled<'a>(main: &'a str, files: &'a Files) -> (Compiled, Vec<(&'a str, Lexed)>) {
    let lexed = lex_plain(main).unwrap();
    let tokens = lexed.tokens.clone();
    let read = RefCell::new(vec![(main, lexed)]);
    let compiled = assur_model::compile_with(&tokens, &mut |wanted| {
        let Some((_, text)) = files.iter().find(|(path, _)| *path == wanted.path) else {
            return Err(Unreadable {
                range: 0..0,
                message: format!("there is no file `{}` beside this one", wanted.path),
                hint: None,
            });
        };
        let lexed = lex_plain(text)?;
        read.borrow_mut().push((text, lexed.clone()));
        Ok(lexed.tokens)
    });
    let read = read.into_inner();
    assert_eq!(compiled.parts.len(), read.len() - 1);
    (compiled, read)
}

/// The words that a message points at, in whichever file.
fn words_of<'a>(read: &[(&'a str, Lexed)], span: Span) -> &'a str {
    let mut first = 0;
    for (text, lexed) in read {
        let next = first + lexed.tokens.len() as u32;
        if span.first < next {
            let span = Span {
                first: span.first - first,
                last: span.last - first,
            };
            return words(text, lexed, span);
        }
        first = next;
    }
    ""
}

#[track_caller]
fn check(main: &str, files: &Files, expected: &[Expected]) {
    let (compiled, read) = compiled(main, files);
    check_messages(main, &compiled, expected, |span| words_of(&read, span));
}

#[track_caller]
fn scene(main: &str, files: &Files) -> SceneModel {
    let (compiled, _) = compiled(main, files);
    assert!(
        compiled.diagnostics.is_empty(),
        "{main}: {:#?}",
        compiled.diagnostics
    );
    compiled.model.unwrap().scenes.remove(0)
}

fn names<'a>(list: impl IntoIterator<Item = &'a String>) -> Vec<&'a str> {
    list.into_iter().map(String::as_str).collect()
}

#[test]
fn a_part_of_a_part_is_flattened() {
    let main = "Machine; parameter n = 60 rpm; driver phi ~ 0 in 0 .. 1;
        part feed: Feed from \"parts/feed.eqn\" { theta = phi; lift.rocker = 61 mm; }
        output feed.tooth [mm], feed.lift.swing, speed = diff(feed.tooth, phi) [mm], n, span = feed.lift.reach(1 mm);
        point O = [0, 0]; link O - feed.lift.A;
        scene go { sweep phi; }
        expect at phi = 0.5: feed.tooth = 0 +- 1 m;";
    let scene = scene(
        main,
        &[("four_bar.eqn", FOUR_BAR), ("parts/feed.eqn", FEED)],
    );
    let linkage = scene.linkage.as_ref().unwrap();
    let constants = names(scene.constants.iter().map(|one| &one.quantity.name));
    assert_eq!(
        constants,
        [
            "n",
            "feed.lift.crank",
            "feed.lift.rod",
            "feed.lift.rocker",
            "feed.lift.base",
            "feed.lead"
        ]
    );
    let [_, crank, _, rocker, ..] = scene.constants.as_slice() else {
        panic!()
    };
    let close = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-15, "{found}");
    close(crank.default, 0.02);
    close(crank.tolerance, 1e-4);
    close(crank.range.1, 0.04);
    assert_eq!(crank.quantity.summary, "Length of the crank.");
    assert_eq!(crank.quantity.unit, "mm");
    close(rocker.default, 0.061);
    assert_eq!(names(scene.drivers.iter().map(|one| &one.name)), ["phi"]);
    let dependents = linkage.dependents.iter().map(|one| &one.quantity.name);
    assert_eq!(names(dependents), ["feed.lift.psi", "feed.lift.chi"]);
    let outputs = names(scene.outputs.iter().map(|one| &one.name));
    assert_eq!(
        outputs,
        ["feed.tooth", "feed.lift.swing", "speed", "n", "span"]
    );
    assert_eq!(
        names(linkage.loops.iter().map(|one| &one.name))[0],
        "feed.lift.loop.x"
    );
    assert_eq!(
        scene.requirements[0].text,
        "feed.lift.crank < feed.lift.rod"
    );
    assert_eq!(scene.equations.len(), 1);
    assert!(scene.marks.is_empty());
    assert_eq!(scene.expectations.len(), 1);
    assert!(names(&linkage.points).contains(&"feed.lift.C"));
    assert_eq!(linkage.links.len(), 4);
    let inputs = |input| scene.program.operations.iter().any(|one| one.kind == input);
    assert!(inputs(assur_model::program::OperationKind::Input(
        Input::Driver(0)
    )));
}
