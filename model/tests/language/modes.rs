//! Modes and events: what they are compiled to, and what is said about wrong ones.

use assur_model::checked::{Direction, SceneModel};
use assur_model::program::Stage;

use super::{Expected, SPRING, check, compiled, first_scene, mistakes};

/// Two masses, of which the second is at rest until the first arrives.
const MASSES: &str = "Sample; parameter F = 1 N, m = 2 kg, l = 1 m; coordinate x: m = 0, y: m = 0; \
                      motion push: m*ddot(x) = F; output x, y, l; scene go { run time 0 s .. 1 s; } ";

#[track_caller]
fn check_all(cases: &[(&str, &[Expected])]) {
    for (text, expected) in cases {
        check(&format!("{MASSES}{text}"), expected);
    }
}

/// The only scene of a file that is right.
#[track_caller]
fn scene(text: &str) -> SceneModel {
    first_scene(&format!("{MASSES}{text}"))
}

#[test]
fn each_mode_has_equations_and_events_of_its_own() {
    let scene = scene(
        "mode alone \"The first mass.\" { hold y; when x - l rises -> both { set dot(y) = dot(x)/2, dot(x) = dot(x)/2; } } \
         mode both { motion follow: m*ddot(y) = -F; when y falls if dot(x) > 0 -> alone { set dot(y) = 0; } when x - y crosses { set x = y; } }",
    );
    let names: Vec<_> = scene.modes.iter().map(|mode| mode.name.as_str()).collect();
    assert_eq!((names, scene.first), (vec!["alone", "both"], 0));
    assert_eq!(scene.modes[0].summary, "The first mass.");
    let events: Vec<_> = scene.modes[1].events.iter().collect();
    assert_eq!(events[0].text, "when y falls if dot(x) > 0 -> alone { set dot(y) = 0; }");
    assert_eq!((events[0].direction, events[0].target), (Direction::Falls, 0));
    assert_eq!((events[1].direction, events[1].target), (Direction::Crosses, 1));
    assert_eq!((events[0].unit.as_str(), events[0].factor), ("m", 1.0));
    let equations: Vec<_> = scene.modes.iter().map(|mode| mode.equations.len()).collect();
    assert_eq!(equations, [1, 2]);
    for mode in &scene.modes {
        assert_eq!(mode.program.results.derivative.len(), 4);
        assert_eq!(mode.program.parameters, scene.constants.len());
    }
}

#[test]
fn a_mode_may_be_stated_in_several_places() {
    let (compiled, _) = compiled(&format!(
        "{MASSES} mode alone {{ hold y; }} effect stop {{ mode alone {{ when x - l rises {{ set dot(x) = -dot(x); }} }} }} scene stopped = stop;"
    ));
    assert!(mistakes(&compiled).is_empty(), "{:#?}", compiled.diagnostics);
    let scenes = compiled.model.unwrap().scenes;
    let counts: Vec<_> = scenes.iter().map(|scene| scene.modes[0].events.len()).collect();
    assert_eq!(counts, [0, 1]);
}

#[test]
#[rustfmt::skip]
fn wrong_modes() {
    check_all(&[
        ("mode a { hold y; } mode b { hold y; }", &[("the mode `b` is never entered", "b", "`when … rises -> b;`")]),
        ("mode a { hold y; when x - l rises -> c; }", &[("there is no mode `c` here", "c", "the scene has a")]),
        ("mode alone { hold y; when x - l rises -> alne; }", &[("there is no mode `alne` here", "alne", "did you mean `alone`?")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises -> a;", &[("there is no mode `a` here", "a", "`mode a { … }`")]),
        ("mode a { motion f: m*ddot(y) = F; when x - l rises -> b; } mode b { hold y; }", &[("the mode `b` holds `y`, which moves before", "when x - l rises -> b;", "{ set dot(y) = 0; }")]),
        ("mode a { motion f: m*ddot(y) = F; when x - l rises -> b { set dot(y) = dot(x); } } mode b { hold y; }", &[("the mode `b` holds `y`, which moves before", "dot(y)", "it stops")]),
        ("mode a { hold y; motion f: m*ddot(y) = F; }", &[("mode `a`, 2 equations (`f`, `hold y`) would have to determine 1 unknown (`ddot(y)`)", "y", "take an equation away")]),
        ("mode a { hold y; when x - l rises -> wind; }", &[("there is no mode `wind` here", "wind", "the scene has a")]),
        ("mode a { hold y; } scene s { start wind; }", &[("there is no mode `wind` here", "wind", "the scene has a")]),
        ("mode a { hold y, z; }", &[("there is no `z` here", "z", "")]),
        ("mode a { hold F; hold y; }", &[("only a coordinate or a state can be held", "F", "")]),
        ("mode a { hold y; mode b { } }", &[("a mode stands outside every mode", "mode b { }", "move it out")]),
        ("mode a { hold y; output z = x; }", &[("an output stands outside every mode", "output z = x;", "each mode defines")]),
        ("mode a { hold y; let z = x; when x - l rises -> b; } mode b { hold y; } output z;", &[("there is no `z` here", "z", "")]),
        ("mode a { hold y; when x - l rises -> b; } mode b { hold y; coordinate q: m; motion r: m*ddot(q) = F; }",
            &[("nothing says where `q` begins in the mode `b`", "when x - l rises -> b;", "{ set q = …; }")]),
        ("mode a { hold y; coordinate q: m = 0; motion r: m*ddot(q) = F; when x - l rises -> b { set q = 0; } } mode b { hold y; }",
            &[("`q` belongs to the mode `a`, and this event leads to `b`", "q", "leave it out here")]),
        ("mode a { hold y; coordinate q: m = 0; motion r: m*ddot(q) = F; when x - l rises -> b; } mode b { hold y; when q rises -> a { set q = 0; } }",
            &[("only the mode `a` has `q`", "q", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn wrong_events() {
    check_all(&[
        ("motion rest: m*ddot(y) = 0; when x - l rises;", &[("this event changes nothing", "when x - l rises;", "")]),
        ("motion rest: m*ddot(y) = 0; when l rises { set x = 0; }", &[("this never changes", "l", "")]),
        ("motion rest: m*ddot(y) = 0; when x - m rises { set x = 0; }", &[("a length (m) and a mass (kg)", "x - m", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises if x { set x = 0; }", &[("a condition is expected here", "x", "compare two quantities")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set l = 2 m; }", &[("only a coordinate, its `dot`, or a state can be set", "l", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set ddot(x) = 0; }", &[("only a coordinate, its `dot`, or a state can be set", "ddot(x)", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set z = 0; }", &[("there is no `z` here", "z", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set dot(z) = 0; }", &[("there is no `z` here", "z", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set dot(x) = 1 m; }", &[("`dot(x)` is a velocity (m/s), and this is a length (m)", "dot(x)", "give `dot(x)` a value in m/s")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set x = 0, x = l; }", &[("`x` is set twice", "x", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn guards_that_do_not_pass_zero() {
    let jumps = "jumps, and an event is where a quantity passes zero without a jump";
    let touches = "it touches zero and does not pass it";
    for (guard, message, hint) in [
        ("sign(x - l)", jumps, "`when x - l rises`"),
        ("-sign(x - l)", jumps, "`when x - l falls`"),
        ("floor(x/l)", jumps, "where `x/l` passes a whole number, `sin(pi*(x/l))` crosses zero"),
        ("mod(x, l)", jumps, "where `x` passes a multiple of `l`, `sin(pi*x/l)` crosses zero"),
        ("if x > l { 1 } else { -1 }", jumps, "the quantity that is zero where this jumps"),
        ("abs(x - l)", touches, "`when x - l crosses`"),
        ("-F*abs(x - l)", touches, "`when x - l crosses`"),
        ("(x - l)^2", touches, "`when x - l crosses`"),
    ] {
        let text = format!("motion rest: m*ddot(y) = 0; when {guard} rises {{ set x = 0; }}");
        check_all(&[(&text, &[(message, guard, hint)])]);
    }
    for guard in ["abs(x) - l", "mod(x, l) - l/2", "x*abs(x)", "x^3", "max(0, x - l)", "sign(y)*(x - l)"] {
        let text = format!("motion rest: m*ddot(y) = 0; when {guard} rises {{ set x = 0; }}");
        check_all(&[(&text, &[])]);
    }
}

#[test]
#[rustfmt::skip]
fn events_that_are_never_carried_out() {
    let never = |condition: &str| format!("mode a {{ hold y; when x - l rises if {condition} -> b; }} mode b {{ hold y; when x falls -> a; }}");
    let second = |first: &str, second: &str| format!(
        "mode a {{ hold y; {first} {second} }} mode b {{ hold y; when x falls -> a; }} mode d {{ hold y; when x falls -> a; }}");
    let unreachable = ("the mode `d` is never entered", "d", "");
    let late = ("at the same instant another one leads to the mode `b` first", "when x - l rises -> d;", "give the first one a condition");
    check_all(&[
        (&never("1 > 2"), &[("this never holds", "1 > 2", "take the event away"), ("the mode `b` is never entered", "b", "")]),
        (&never("2 > 1"), &[]),
        (&second("when x - l rises -> b;", "when x - l rises -> d;"), &[late, unreachable]),
        (&second("when x - l crosses -> b;", "when x - l rises -> d;"), &[late, unreachable]),
        (&second("when x - l rises if dot(x) > 0 -> b;", "when x - l rises -> d;"), &[]),
        (&second("when x - l rises { set x = 0; } when y rises -> b;", "when x - l rises -> d;"), &[]),
        (&second("when x - l falls -> b;", "when x - l rises -> d;"), &[]),
    ]);
    // Of two events outside the modes the second is one of the mode that follows, too.
    check_all(&[("when x - l rises -> b { set x = 0; } when x - l rises -> d { set x = 0; } mode a { hold y; } mode b { hold y; } mode d { hold y; when x falls -> a; }", &[])]);
    // A condition on effects may hold in another scene.
    check_all(&[("effect e { } mode a { hold y; when x - l rises if e -> b; } mode b { hold y; when x falls -> a; } scene s = e { run time 0 s .. 1 s; }", &[])]);
}

/// The notes of a file that has no mistake.
#[track_caller]
fn notes(text: &str) -> Vec<String> {
    let (compiled, _) = compiled(&format!("{MASSES}{text}"));
    assert!(
        compiled.model.is_some() && mistakes(&compiled).is_empty(),
        "{:#?}",
        compiled.diagnostics
    );
    compiled.diagnostics.into_iter().map(|one| one.message).collect()
}

#[test]
fn a_mode_without_a_way_out_is_noted() {
    let both = "mode a { hold y; when x - l rises -> b; } mode b { hold y; ";
    let found = notes(&format!("{both}}}"));
    assert_eq!(found, ["in the scene `go` nothing leads out of the mode `b`"]);
    let found = notes(&format!("{both} when x - l falls {{ set x = 0; }} }}"));
    assert_eq!(found.len(), 1);
    // It is said once, whatever the scenes.
    let found = notes(&format!("{both}}} scene too {{ run time 0 s .. 2 s; }}"));
    assert_eq!(found.len(), 1);
    for quiet in ["mode a { hold y; }".to_string(), format!("{both} when x falls -> a; }}")] {
        assert_eq!(notes(&quiet), [""; 0]);
    }
}

#[test]
#[rustfmt::skip]
fn starts_in_modes() {
    let modes = "mode a { hold y; when x - l rises -> b { set dot(y) = 1 [m/s]; } } mode b { motion follow: m*ddot(y) = -F; when y falls -> a { set dot(y) = 0; } }";
    let scene = |start: &str| format!("{modes} scene s {{ run time 0 s .. 1 s; {start} }}");
    check_all(&[
        (&scene("start a; start b;"), &[("the motion begins in one mode, and this is the second", "b", "take one of the two away")]),
        (&scene("start y = 0 m, y = 1 m;"), &[("`y` is started twice", "y", "take one of the two away")]),
        (&scene("start y = 0 m; start dot(y) = 0, dot(y) = 0;"), &[("`dot(y)` is started twice", "dot(y)", "")]),
        (&scene("start dot(y) = 1 [m/s];"), &[("`y` cannot start with a speed", "1 [m/s]", "`start dot(y) = 0;`")]),
        (&scene("start b, dot(y) = 1 [m/s];").replace("b, ", "b; start "), &[]),
        (&scene("").replace("mode b {", "mode b { coordinate q: m = 0, rate = 1 [m/s]; motion r: m*ddot(q) = F;").replace("set dot(y) = 1 [m/s]", "set dot(y) = 1 [m/s], q = 0"), &[]),
        (&scene("start dot(y) = 0, dot(x) = 1 [m/s];"), &[]),
    ]);
}

/// What bends a guard is a surface where the rates see it too, and else a kink.
#[test]
fn kinks_of_guards_are_told_from_surfaces() {
    let count = |text: &str| {
        let scene = scene(text);
        let program = &scene.modes[0].program;
        assert_eq!(scene.modes[0].events.len(), 1 + program.surfaces.len());
        assert_eq!(program.results.events.len(), 1 + program.surfaces.len() + program.kinks);
        (program.surfaces.len(), program.kinks)
    };
    let guard = "when max(0 m, x - l) - abs(x - y) rises { set x = 0 m; }";
    assert_eq!(count(&format!("mode go {{ hold y; {guard} }}")), (0, 2));
    let pushed = "motion follow: m*ddot(y) = F*sign(x - y);";
    assert_eq!(count(&format!("mode go {{ {pushed} {guard} }}")), (1, 1));
    assert_eq!(count("mode go { hold y; when x - max(l, 2 m) rises { set x = 0 m; } }"), (0, 0));
}

/// On the side of a surface where nothing of the time is felt nothing of it has to be computed.
#[test]
fn a_side_says_what_is_not_needed() {
    let scene = scene(
        "parameter omega = 3 [rad/s]; \
         mode go { motion follow: m*ddot(y) = F*(if x > y { cos(omega*time) } else { -1 }); \
                   when sin(omega*time) rises { set x = 0 m; } }",
    );
    let program = &scene.modes[0].program;
    assert_eq!(program.surfaces.len(), 1);
    let is_felt = |side: Option<f64>| {
        let side = side.map(|side| (0, side));
        let resting = program.resting(&program.results.derivative, side);
        let mut operations = resting.iter().map(|value| &program.operations[value.0 as usize]);
        operations.any(|operation| operation.stage == Stage::Instant)
    };
    let felt = [None, Some(1.0), Some(-1.0)].map(is_felt);
    assert!(felt[0] && felt[1] != felt[2], "{felt:?}");
}

/// What is shared in the graph is a tree as text, which doubles with each `let` here: texts are the words of the file.
#[test]
fn the_text_of_a_surface_is_that_of_the_file() {
    let lets: String =
        (1..40).map(|k| format!("let y[{k}] = y[{}]*sin(y[{}]/(1 m));", k - 1, k - 1)).collect();
    let text = |force: &str| {
        let text = format!(
            "{SPRING} let y[0] = x + 1 m; {lets} let f(a) = abs(a - 2 m); {force} output f(x), y[39]; \
             scene go {{ run time 0 s .. 1 s; }}"
        );
        let (compiled, _) = compiled(&text);
        assert!(mistakes(&compiled).is_empty(), "{:?}", compiled.diagnostics);
        let mut scene = compiled.model.unwrap().scenes.remove(0);
        let events = scene.modes.remove(0).events;
        events.into_iter().map(|event| event.text).collect::<Vec<_>>()
    };
    for (force, expected) in [
        ("force -c*abs(y[39] - 1 m) on x;", "y[39] - 1 m passes zero"),
        ("force -c*max(0, y[39]) on x;", "y[39] passes zero"),
        ("potential c*max(y[2], 1 m)^2;", "y[2] - 1 m passes zero"),
        ("force if y[3] > 1 m { c*x } else { 0 N } on x;", "y[3] - 1 m passes zero"),
        ("force -c*f(y[39]) on x;", "y[39] - 2 passes zero"),
    ] {
        assert_eq!(text(force), [expected]);
    }
}

#[test]
fn modes_of_a_linkage_are_influenced_by_the_same_constants() {
    let scene = first_scene(
        "Sample; dimension a = 20 mm +- 0.1 mm, b = 70 mm, c = 50 mm, d = 75 mm, h = 3 mm +- 0.1 mm; \
         parameter n = 60 rpm, t = 3 +- 0.1; driver theta = n*time; dependent u ~ 30 deg, v ~ 90 deg; \
         closure loop: a*dir(theta) + b*dir(u) = [d, 0] + c*dir(v); output o; scene s { run time 0 s .. 1 s; } \
         mode one { when sin(theta) rises -> two; let o = v*t; } mode two { when cos(theta) rises -> one; let o = v*h/(1 mm); }",
    );
    let variables = &scene.linkage.as_ref().unwrap().variables;
    assert_eq!((scene.constants.len(), variables.len()), (7, 7));
    for mode in &scene.modes {
        let influence = &mode.program.results.closing.influence;
        assert_eq!((mode.program.parameters, influence.len()), (7, 7));
    }
}
