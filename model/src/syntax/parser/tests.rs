//! What the parser makes of texts: trees as they are printed, and messages with the text that they point at.

use super::{parse, parse_term};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::lexer::{Lexed, lex_plain};
use crate::syntax::print;
use crate::syntax::tree::{
    Distribution, ExpectAt, File, SceneItem, Statement, StatementKind, Term,
};

mod expressions;
mod wrong;

/// A file whose header needs no words.
fn file(statements: &str) -> String {
    format!("Sample; {statements}")
}

/// The tree of a file with its messages.
fn read(text: &str) -> (Option<File>, Vec<Diagnostic>, Lexed) {
    let lexed = lex_plain(text).unwrap();
    let mut diagnostics = Diagnostics::default();
    let tree = parse(&lexed.tokens, 0, &mut diagnostics);
    (tree, diagnostics.into_sorted(), lexed)
}

/// The statements of a text without mistakes.
#[track_caller]
fn statements(text: &str) -> Vec<Statement> {
    let (tree, messages, _) = read(&file(text));
    assert!(messages.is_empty(), "{text}: {messages:?}");
    tree.unwrap().statements
}

#[track_caller]
fn statement(text: &str) -> StatementKind {
    let mut all = statements(text);
    assert_eq!(all.len(), 1, "{text}");
    all.remove(0).kind
}

/// An expression without mistakes.
#[track_caller]
fn term(text: &str) -> Term {
    let lexed = lex_plain(text).unwrap();
    let mut diagnostics = Diagnostics::default();
    let tree = parse_term(&lexed.tokens, &mut diagnostics);
    let messages = diagnostics.into_sorted();
    assert!(messages.is_empty(), "{text}: {messages:?}");
    tree.unwrap()
}

/// Statements that are printed as they are written.
#[test]
fn statements_are_printed_as_they_are_written() {
    for text in [
        "motion rotor: J*ddot(phi) = M - c*phi",
        "motion m*ddot(x) + c*x = 0",
        "kinetic m*dot(x)^2/2",
        "potential c*x^2/2 - m*g*x",
        "dissipation d*dot(x)^2/2",
        "force F*sin(omega*time) on x",
        "force [Fx, Fy] on [x, y]",
        "require l1 + l4 < l2 + l3",
        "require a < b && !(c >= d) || e == 0",
        "let x = a*b + c/d",
        "let x[3] = x[2] + l*sin(q[3])",
    ] {
        let all = statements(&format!("{text};"));
        assert_eq!(all.iter().map(print::statement).collect::<Vec<_>>(), [text]);
    }
}

#[track_caller]
fn check_output(text: &str, printed: &str, has_unit: bool) {
    let kind = statement(&format!("for k in 1..3 {{ output {text}; }}"));
    let StatementKind::For { body, .. } = kind else { panic!("{text}") };
    let StatementKind::Output(output) = &body[0].kind else { panic!("{text}") };
    let value = output.value.as_ref().map(print::term);
    let name = output.name.as_ref().map(print::target);
    assert_eq!(value.or(name).as_deref(), Some(printed), "{text}");
    assert_eq!(output.unit.is_some(), has_unit, "{text}");
}

#[test]
fn a_bracket_behind_an_output_is_an_index_or_a_unit() {
    check_output("x", "x", false);
    check_output("x[1]", "x[1]", false);
    check_output("x[k]", "x[k]", false);
    check_output("x[k + 1] [mm]", "x[k + 1]", true);
    check_output("feed.x", "feed.x", false);
    check_output("feed.x [mm]", "feed.x", true);
    check_output("feed.x[k] [mm]", "feed.x[k]", true);
    check_output("feed.f(x)", "feed.f(x)", false);
    check_output("F [N]", "F", true);
    check_output("F [1/s]", "F", true);
    check_output("dot(x) [mm/s]", "dot(x)", true);
    check_output("dot(x[k]) [mm/s]", "dot(x[k])", true);
    check_output("p = a*b [kW]", "a*b", true);
    check_output("p = x[k] [kW]", "x[k]", true);
}

#[test]
fn ranges_and_tolerances_follow_a_value() {
    for (text, half_width, distribution, range) in [
        ("= 75 mm", None, Distribution::Normal, false),
        ("= 75 mm +- 0.05 mm", Some("0.05 mm"), Distribution::Normal, false),
        ("= 75 mm +- 0.05 mm normal", Some("0.05 mm"), Distribution::Normal, false),
        (
            "= 75 mm +- 0.05 mm uniform in 60 mm .. 90 mm",
            Some("0.05 mm"),
            Distribution::Uniform,
            true,
        ),
        (
            "= 75 mm in 60 mm .. 90 mm +- 0.05 mm truncated",
            Some("0.05 mm"),
            Distribution::Truncated,
            true,
        ),
        ("= 3*2 in 1..9", None, Distribution::Normal, true),
    ] {
        let StatementKind::Constant(constant) = statement(&format!("dimension R {text};")) else {
            panic!("{text}")
        };
        assert_eq!(
            constant.tolerance.as_ref().map(|one| print::term(&one.half_width)).as_deref(),
            half_width,
            "{text}"
        );
        assert_eq!(
            constant.tolerance.map(|one| one.distribution).unwrap_or_default(),
            distribution,
            "{text}"
        );
        assert_eq!(constant.range.is_some(), range, "{text}");
    }
}

#[test]
fn commas_make_several_statements() {
    for (text, count) in [
        ("dimension a = 1 m, b = 2 m;", 2),
        ("parameter a = 1, b = 2, c = 3;", 3),
        ("let f(x) = x, g(x, y) = x*y;", 2),
        ("driver a = time, b = 2*time;", 2),
        ("coordinate x: m = 0, rate = 1 [m/s], y: m = 0;", 2),
        ("coordinate rate: m = 0, x: m;", 2),
        ("state i: A = 0, u: V;", 2),
        ("force F on x, G on y;", 2),
        ("output x, y [mm], z = 2*x;", 3),
    ] {
        assert_eq!(statements(text).len(), count, "{text}");
    }
}

/// Any keyword may also name a quantity.
#[test]
fn keywords_are_names_too() {
    let all = statements(
        "let let = 1; let state = let; parameter effect = 1 m; output force, scene = mark [mm];",
    );
    assert_eq!(all.len(), 5);
}

#[test]
fn blocks_nest() {
    let kind = statement(
        "effect a \"text\" { let x = 1; if b { let y = 2; } else if c { let y = 3; } else { let y = 4; } } else { let x = 2; }",
    );
    let StatementKind::Effect { name, text, body, otherwise } = kind else { panic!() };
    assert_eq!(
        (name.text.as_str(), text.as_deref(), body.len(), otherwise.len()),
        ("a", Some("text"), 2, 1)
    );
    let kind = statement("choice c { /// First.\n a { let x = 1; } b \"second\" { } }");
    let StatementKind::Choice { alternatives, .. } = kind else { panic!() };
    let texts: Vec<_> = alternatives.iter().map(|one| one.text.as_deref()).collect();
    assert_eq!(texts, [Some("First."), Some("second")]);
}

#[test]
fn names_of_parts_have_dots() {
    let StatementKind::Scene(scene) =
        statement("scene s = a + b.c + d.e.f { sweep d.phi 0 .. 1; }")
    else {
        panic!()
    };
    let selected: Vec<_> = scene
        .selection
        .iter()
        .map(|one| {
            (one.name.text.as_str(), one.alternative.as_ref().map(|name| name.text.as_str()))
        })
        .collect();
    assert_eq!(selected, [("a", None), ("b", Some("c")), ("d.e", Some("f"))]);
    for text in [
        "mark \"top\" at feed.phi = 1;",
        "expect at feed.phi = 1, feed.psi = 2: feed.x = 1 +- 1;",
        "preset p { feed.e = 1; feed.h[2] = 3; }",
        "link feed.A - B - feed.C[2];",
        "part feed: Feed { lift.e_v = 6 mm +- 1 mm in 1 mm .. 9 mm; beta ~ 1; }",
    ] {
        assert_eq!(statements(text).len(), 1, "{text}");
    }
}

#[test]
fn scenes_say_what_they_show_and_do() {
    let text = "scene s \"text\" = a + c.d { periodic over 2*pi/n; preset p; output x, y = 1 [mm]; start x = 0, dot(x) = 1; }";
    let StatementKind::Scene(scene) = statement(text) else { panic!() };
    assert_eq!(scene.selection.len(), 2);
    assert_eq!(scene.selection[1].alternative.as_ref().map(|name| name.text.as_str()), Some("d"));
    assert_eq!(scene.items.len(), 5);
    assert!(matches!(&scene.items[4], SceneItem::Start { values } if values.len() == 2));
    let StatementKind::Scene(clock) = statement("scene s { periodic; }") else { panic!() };
    assert_eq!(clock.items, [SceneItem::Periodic { period: None }]);
    let StatementKind::Scene(short) = statement("scene s;") else { panic!() };
    assert!(short.items.is_empty() && short.selection.is_empty());
}

#[test]
fn facts_say_where_they_hold() {
    let text = "expect scene s preset p at theta = 110 deg: dot(x) = 1 mm +- 0.1 mm \"remark\";";
    let StatementKind::Expect(expect) = statement(text) else { panic!() };
    assert!(expect.scene.is_some() && expect.preset.is_some() && expect.remark.is_some());
    assert!(matches!(expect.at, ExpectAt::Value { .. }));
    let StatementKind::Expect(expect) = statement("expect at maximum: x = 1 +- 0.1;") else {
        panic!()
    };
    assert!(matches!(expect.at, ExpectAt::Extreme(_)));
}
