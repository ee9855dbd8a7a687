//! Modes and events: what they are compiled to, and what is said about wrong ones.

use assur_model::checked::{Direction, SceneModel};

use super::{Expected, check, compiled};

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
    let (compiled, _) = compiled(&format!("{MASSES}{text}"));
    assert!(
        compiled.diagnostics.is_empty(),
        "{:#?}",
        compiled.diagnostics
    );
    compiled.model.unwrap().scenes.remove(0)
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
    assert_eq!(
        events[0].text,
        "when y falls if dot(x) > 0 -> alone { set dot(y) = 0; }"
    );
    assert_eq!(
        (events[0].direction, events[0].target),
        (Direction::Falls, 0)
    );
    assert_eq!(
        (events[1].direction, events[1].target),
        (Direction::Crosses, 1)
    );
    assert_eq!((events[0].unit.as_str(), events[0].factor), ("m", 1.0));
    let equations: Vec<_> = scene
        .modes
        .iter()
        .map(|mode| mode.equations.len())
        .collect();
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
    assert!(
        compiled.diagnostics.is_empty(),
        "{:#?}",
        compiled.diagnostics
    );
    let scenes = compiled.model.unwrap().scenes;
    let counts: Vec<_> = scenes
        .iter()
        .map(|scene| scene.modes[0].events.len())
        .collect();
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
        ("mode a { hold F; hold y; }", &[("only a coordinate or a state can be held", "F", "")]),
        ("mode a { hold y; mode b { } }", &[("a mode stands outside every mode", "mode b { }", "move it out")]),
        ("mode a { hold y; output z = x; }", &[("an output stands outside every mode", "output z = x;", "each mode defines")]),
        ("mode a { hold y; let z = x; when x - l rises -> b; } mode b { hold y; } output z;", &[("there is no `z` here", "z", "")]),
        ("mode a { hold y; when x - l rises -> b; } mode b { hold y; coordinate q: m; motion r: m*ddot(q) = F; }",
            &[("nothing says where `q` begins in the mode `b`", "when x - l rises -> b;", "{ set q = …; }")]),
        ("mode a { hold y; coordinate q: m = 0; motion r: m*ddot(q) = F; when x - l rises -> b { set q = 0; } } mode b { hold y; }",
            &[("`q` belongs to the mode `a`, and this event leads to `b`", "q", "")]),
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
        ("motion rest: m*ddot(y) = 0; when ddot(x) rises { set x = 0; }", &[("cannot watch an acceleration", "ddot(x)", "the force")]),
        ("motion rest: m*ddot(y) = 0; when x - m rises { set x = 0; }", &[("a length (m) and a mass (kg)", "x - m", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises if x { set x = 0; }", &[("a condition is expected here", "x", "compare two quantities")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set l = 2 m; }", &[("only a coordinate, its `dot`, or a state can be set", "l", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set ddot(x) = 0; }", &[("only a coordinate, its `dot`, or a state can be set", "ddot(x)", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set dot(x) = 1 m; }", &[("`dot(x)` is a velocity (m/s), and this is a length (m)", "dot(x)", "")]),
        ("motion rest: m*ddot(y) = 0; when x - l rises { set x = 0, x = l; }", &[("`x` is set twice", "x", "")]),
    ]);
}
