//! Names of equations and of events.

use assur_model::checked::{Moment, PrimitiveKind};

use super::{Expected, check, first_scene};

/// Three rockers on one crank, each closed by a loop of its own.
const LEGS: &str = "Sample; dimension r = 20 mm, l = 90 mm, c = 60 mm, a = 80 mm; driver phi ~ 90 deg in 0 deg .. 360 deg; \
                    for k in 1..3 { dependent gamma[k] ~ 20 deg, psi[k] ~ 100 deg; \
                    closure leg[k]: r*dir(phi + k*(120 deg)) + l*dir(gamma[k]) = [a, 0] + c*dir(psi[k]); } \
                    output psi[1], psi[2], psi[3]; ";

/// A ball that jumps, in a scene without modes.
const BALL: &str = "Sample; parameter g = 9.81 [m/s^2], m = 1 kg; coordinate x: m = 1 m; kinetic m*dot(x)^2/2; \
                    potential m*g*x; output x; scene fall { run time 0 s .. 2 s; } ";
const HIT: &str = "when hit: x falls { set dot(x) = -dot(x); } ";
const MODES: &str =
    "mode up { when x - 1 m falls -> down; } mode down { when x - 1 m rises -> up; } ";

/// The equations of the first scene of a file without mistakes.
#[track_caller]
fn equations(text: &str) -> Vec<String> {
    let scene = first_scene(text);
    let linkage = scene.linkage.map(|linkage| linkage.loops);
    let of_linkage = linkage.into_iter().flatten().map(|one| one.name);
    of_linkage.chain(scene.equations.into_iter().map(|one| one.text)).collect()
}

#[test]
fn each_closure_of_a_repetition_has_a_name_of_its_own() {
    let found = equations(LEGS);
    assert_eq!(
        found[..6],
        ["leg[1].x", "leg[1].y", "leg[2].x", "leg[2].y", "leg[3].x", "leg[3].y"]
    );
    assert!(found[6].starts_with("closure leg[1]: "), "{found:?}");
}

#[test]
fn the_index_of_a_name_is_computed() {
    let found = equations(
        "Sample; parameter m = 2 kg; coordinate x[2]: m = 0, x[3]: m = 0; \
         for k in 1..2 { motion mass[k + 1]: m*ddot(x[k + 1]) = 1 N; } \
         output x[2]; scene go { run time 0 s .. 1 s; }",
    );
    assert!(found[0].starts_with("motion mass[2]: "), "{found:?}");
    // A bracket after a name begins a term as well.
    let found = equations(
        "Sample; parameter m = 2 kg; coordinate x[2]: m = 0; \
         motion ddot(x[2])*m = 1 N; output x[2]; scene go { run time 0 s .. 1 s; }",
    );
    assert!(found[0].starts_with("motion ddot(x[2])"), "{found:?}");
}

#[test]
fn the_index_of_a_name_is_a_whole_number() {
    let text = LEGS.replace("leg[k]:", "leg[k/2]:");
    check(&text, &[("has to be a whole number", "k/2", "the index of a `for` or `sum`")]);
}

#[test]
fn an_event_of_a_scene_without_modes_is_counted_by_its_name() {
    let text = format!(
        "{BALL}{HIT}measure hits = count(hit), speed = value(dot(x), last(before(hit))), top = value(x, after(hit));"
    );
    let scene = first_scene(&text);
    let event = || "hit".to_owned();
    let kinds: Vec<_> = scene.primitives.into_iter().map(|one| one.kind).collect();
    assert_eq!(
        kinds,
        [
            PrimitiveKind::Count(Moment::After(event(), false)),
            PrimitiveKind::Value(Moment::Before(event(), true)),
            PrimitiveKind::Value(Moment::After(event(), false)),
        ]
    );
    assert_eq!(scene.modes[0].events[0].label, Some(event()));
    assert!(scene.modes[0].events[0].text.starts_with("when hit: x falls"));
}

#[test]
fn events_of_a_repetition_are_counted_one_by_one() {
    check(
        &format!(
            "{BALL} for k in 1..3 {{ when pass[k]: x - k*(0.2 m) falls {{ set dot(x) = dot(x)/2; }} \
             measure passes[k] = count(pass[k]); }}"
        ),
        &[],
    );
}

#[test]
#[rustfmt::skip]
fn what_is_counted_is_an_event_with_a_name() {
    let cases: &[(String, &[Expected])] = &[
        ("when x falls { set dot(x) = -dot(x); } measure n = count(x);".into(), &[("the name of an event is expected here", "x", "`when hit: x falls …`, and write `count(hit)`")]),
        ("when x falls { set dot(x) = -dot(x); } measure n = count(x < 0);".into(), &[("the name of an event is expected here", "x < 0", "`when hit: x falls …`")]),
        ("when x falls { set dot(x) = -dot(x); } measure n = count(x falls);".into(), &[("found `falls`, expected `)`", "falls", "`count(hit)`")]),
        (format!("{HIT}measure n = count(hot);"), &[("the name of an event is expected here", "hot", "did you mean `hit`?")]),
        (format!("{HIT}measure n = count(enter(hit));"), &[("a mode of this scene is expected here", "hit", "this scene has no modes; an event is counted by its name")]),
        (format!("{HIT}measure n = value(x, hit);"), &[("a moment of the run is expected here", "hit", "write `before(hit)` or `after(hit)`")]),
        (format!("{HIT}measure n = value(x, 1 s);"), &[("a moment of the run is expected here", "1 s", "`before(event)`")]),
        (format!("{MODES}measure n = count(up);"), &[("the name of an event is expected here", "up", "`up` is a mode: write `enter(up)`")]),
        ("when hit[m]: x falls { set dot(x) = -dot(x); }".into(), &[("has to be a whole number", "m", "")]),
    ];
    for (text, expected) in cases {
        check(&format!("{BALL}{text}"), expected);
    }
}
