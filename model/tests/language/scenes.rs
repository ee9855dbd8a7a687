//! Effects, choices and scenes: what is wrong with them, and that a mistake in several scenes is said once.

use assur_model::asked::Asked;
use assur_model::lexer::lex_plain;

use super::{Expected, SPRING, check, compiled};

#[test]
#[rustfmt::skip]
fn scenes_select_what_there_is() {
    let cases: &[(&str, &[Expected])] = &[
        ("effect torsion { } scene s = torsoin; scene t = torsion;", &[("the scene `s` selects an unknown effect `torsoin`", "torsoin", "did you mean `torsion`?")]),
        ("scene s = torsion;", &[("unknown effect `torsion`", "torsion", "the file declares no effect")]),
        ("choice k { a { } b { } } scene s = k.d;", &[("the choice `k` has no alternative `d`", "d", "it has a, b")]),
        ("choice k { a { } b { } } scene s = k;", &[("`k` is a choice: say which alternative holds", "k", "`k.a`")]),
        ("choice k { a { } b { } } scene s = j.a;", &[("selects an unknown choice `j`", "j", "")]),
        ("scene s { preset p; }", &[("there is no preset `p`", "p", "declare it with")]),
        ("preset first { m = 1 kg; } scene s { preset frist; }", &[("there is no preset `frist`", "frist", "did you mean `first`?")]),
        ("scene s { periodic over 1 s; run time 0 .. 1 s; }", &[("a scene has one task, and this is its second", "0", "")]),
        ("scene s { run theta 0 .. 1 s; }", &[("a scene runs over `time`", "theta", "run time 0 s .. 3 s;")]),
        ("scene s { periodic over x/(1 [m/s]); }", &[("can depend on constants alone", "x/(1 [m/s])", "")]),
        ("scene s { run time 1 s .. 0 s; }", &[("the run ends before it begins", "1 s .. 0 s", "the earlier time first")]),
        ("scene s { run time 1 s .. 1 s; }", &[("the run ends where it begins", "1 s .. 1 s", "")]),
        ("scene s { periodic over 0 s; }", &[("a period is longer than nothing", "0 s", "`2*pi/n`")]),
        ("scene s { periodic over 2*pi*(-1 s); }", &[("a period is longer than nothing", "2*pi*(-1 s)", "")]),
        ("scene s { rest; run time 0 s .. 1 s; }", &[("a scene has one task, and this is its second", "0 s", "")]),
        ("scene s { run time 0 s .. 1 s; start x = 0 m; rest; }", &[("a scene has one task, and this is its second", "rest", "")]),
        ("force 1 N*sin(2 [1/s]*time) on x; scene s { rest; start x = 0 m; }", &[("this scene moves with the time and never rests", "s", "leave out what drives it")]),
        ("scene s { rest; start x = 0 m; } expect at time = 0 s: x = 0 m +- 1 m;", &[("the scene rests, and is at one place only", "time", "write `at rest`")]),
        ("scene s { run time 0 s .. 1 s; start x = 0 m; } expect at rest: x = 0 m +- 1 m;", &[("the scene does not rest", "rest", "its task is to be `rest;`")]),
        ("measure f = frequency(1); scene s { run time 0 s .. 1 s; start x = 0 m; }", &[("`frequency` is a number of a position of rest, and no scene of the file is one", "1", "write a scene with the task `rest;`")]),
        ("measure f = damping(x); scene s { rest; start x = 0 m; }", &[("a vibration has a whole number from 1 to 1000", "x", "number 1 is the slowest")]),
        ("measure f = frequency(1)*duration(x > 0 m); scene s { rest; start x = 0 m; }", &[("this is a number of a run and of a position of rest", "frequency(1)*duration(x > 0 m)", "make two measures of it")]),
        ("scene s { start x = 1 s; }", &[("the start value of a length (m) is a time (s)", "1 s", "give `x` a value in m")]),
        ("scene s { start x = 1 m; start x = 2 m; }", &[("`x` is started twice", "x", "take one of the two away")]),
        ("scene s { start 2*x = 1 m; }", &[("only a coordinate, its `dot`, or a state can be started", "2*x", "")]),
        ("scene s { start x = dot(x)*(1 s); }", &[("a start value can depend on constants alone", "dot(x)*(1 s)", "")]),
        ("if m < 1 kg { let a = 1; }", &[("statements can depend on effects and choices only", "m < 1 kg", "inside an expression")]),
        ("effect torsion { } if torsoin { } scene s = torsion;", &[("there is no effect `torsoin`", "torsoin", "did you mean `torsion`?")]),
        ("choice k { a { } b { } } if k.d { } scene s;", &[("the choice `k` has no alternative `d`", "d", "it has a, b")]),
        ("choice k { a { } b { } } output y = if k.d { 1 } else { 2 }; scene s;", &[("the choice `k` has no alternative `d`", "d", "it has a, b")]),
        ("effect e { scene s; }", &[("no scene shows the effect `e`", "e", "scene with_e = e { … }"), ("a scene stands outside every block", "scene s;", "")]),
        ("effect e { expect at maximum: x = 1 m +- 1 m; } scene s = e;", &[("a published fact stands outside every block", "expect at maximum: x = 1 m +- 1 m;", "")]),
        ("effect e { preset p { m = 1 kg; } } scene s = e;", &[("a preset stands outside every block", "preset p { m = 1 kg; }", "")]),
    ];
    for (text, expected) in cases {
        check(&format!("{SPRING}{text}"), expected);
    }
}

#[test]
fn an_effect_in_no_scene_is_a_warning_and_is_checked() {
    check(
        &format!("{SPRING} effect e {{ let a = x; output a; }} scene s;"),
        &[("no scene shows the effect `e`", "e", "scene with_e = e { … }")],
    );
    check(
        &format!("{SPRING} effect e {{ output a = x + m; }} scene s;"),
        &[("no scene shows the effect `e`", "e", ""), ("this adds or subtracts", "x + m", "")],
    );
    check(
        &format!("{SPRING} choice k {{ a {{ }} b {{ output a = x + m; }} }} scene s;"),
        &[("this adds or subtracts", "x + m", "")],
    );
    // An effect inside another one is checked together with it.
    check(
        &format!("{SPRING} effect e {{ effect f {{ output a = x + m; }} }} scene s = e;"),
        &[("no scene shows the effect `f`", "f", ""), ("this adds or subtracts", "x + m", "")],
    );
    check(
        &format!("{SPRING} effect e {{ coordinate y: m = 0; }} scene s;"),
        &[
            ("no scene shows the effect `e`", "e", ""),
            ("with `e` nothing determines `ddot(y)`", "y", ""),
        ],
    );
}

#[test]
#[rustfmt::skip]
fn a_mistake_in_several_scenes_is_said_once() {
    let scenes = "effect e { } effect f { } scene s { run time 0 .. 1 s; } scene t = e; scene u = e + f { periodic over 1 s; }";
    for (text, expected) in [
        ("output y = x + m;", ("this adds or subtracts", "x + m", "")),
        ("coordinate y: furlong = 0; kinetic m*dot(y)^2/2;", ("`furlong` is not a unit", "furlong", "")),
        ("coordinate y: m = 0; kinetic m*dot(z)^2/2;", ("there is no `z` here", "z", "")),
        ("motion extra: c*x = 0;", ("in the scene `s` 1 equation (`extra`)", "motion extra: c*x = 0;", "")),
        ("coordinate y: m = 0;", ("in the scene `s` nothing determines", "y", "")),
        ("let a = a;", ("defined by itself", "a", "")),
        ("parameter k = 1, k = 2;", ("declared twice", "k", "")),
        ("require x < 1 m;", ("a condition on moving quantities", "x < 1 m", "")),
    ] {
        check(&format!("{SPRING}{text}{scenes}"), &[expected]);
    }
}

#[test]
fn what_is_missing_without_an_effect_is_said_for_that_scene() {
    let text =
        format!("{SPRING} effect e {{ let a = 2*x; }} output b = 3*a; scene s; scene t = e;");
    check(&text, &[("there is no `a` here", "a", "say in `else` what takes its place")]);
}

#[test]
fn a_run_needs_start_values() {
    let file = |start: &str, scene: &str| {
        format!(
            "Sample; parameter m = 2 kg; coordinate x: m{start}; kinetic m*dot(x)^2/2; state i: A; motion dot(i) = 0; output x, i; scene s {{ {scene} }}"
        )
    };
    check(
        &file("", "run time 0 .. 1 s;"),
        &[
            ("`x` has no start value, from which a scene runs", "x", "coordinate x: m = 0;"),
            ("`i` has no start value", "i", ""),
        ],
    );
    check(&file(" = 0", "run time 0 .. 1 s;"), &[("`i` has no start value", "i", "")]);
    check(&file("", "run time 0 .. 1 s; start x = 0, i = 1 A;"), &[]);
    check(&file("", "periodic over 1 s;"), &[]);
    check(&file(" = 0", "rest;"), &[("`i` has no start value", "i", "")]);
}

#[test]
#[rustfmt::skip]
fn facts_name_what_is_reported() {
    let cases: &[(&str, &[Expected])] = &[
        ("expect scene t at maximum: x = 1 m +- 1 m; scene s;", &[("there is no scene `t`", "t", "")]),
        ("expect preset q at maximum: x = 1 m +- 1 m; scene s;", &[("there is no preset `q`", "q", "")]),
        ("expect at maximum: speed = 1 m +- 1 m; scene s;", &[("the scene `s` does not report `speed`", "speed", "add it to the outputs")]),
        ("expect at middle: x = 1 m +- 1 m; scene s;", &[("`middle` is no place in a motion", "middle", "`maximum`, `minimum`, `amplitude`")]),
        ("expect at x = 1 m: x = 1 m +- 1 m; scene s;", &[("`x` is neither a driver nor the time", "x", "a value of time")]),
        ("expect at time = 5 s: x = 0 m +- 1 m; scene s { run time 0 s .. 1 s; }", &[("the scene `s` runs from 0 s to 1 s, and this is outside", "5 s", "let the scene run longer")]),
        ("expect at time = 1 s: x = 0 m +- 1 m; scene s { run time 0 s .. 1 s; }", &[]),
        ("expect at time = 5 s: x = 0 m +- 1 m; scene s { periodic over 1 s; }", &[]),
        ("parameter T = 1 s; expect at time = 5 s: x = 0 m +- 1 m; scene s { run time 0 s .. T; }", &[("the scene `s` runs from 0 s to 1 s", "5 s", "")]),
        ("parameter T = 1 s; preset long { T = 9 s; } expect preset long at time = 5 s: x = 0 m +- 1 m; scene s { run time 0 s .. T; }", &[]),
        ("expect at maximum: x = 1 m +- -1 m; scene s;", &[("a tolerance cannot be negative", "-1 m", "")]),
        ("expect at maximum: x = m +- 1 m; scene s;", &[("a fixed value is expected here", "m", "is a `let`")]),
    ];
    for (text, expected) in cases {
        check(&format!("{SPRING}{text}"), expected);
    }
}

#[test]
fn the_order_of_statements_does_not_matter() {
    let statements = [
        "parameter m = 2 kg;",
        "let a = 2*b;",
        "let b = m*dot(x);",
        "coordinate x: m = 0;",
        "kinetic m*dot(x)^2/2;",
        "output a;",
        "effect e { let f(y) = 2*y; } else { let f(y) = y; }",
        "output q = f(a);",
        "scene s;",
        "scene t = e;",
    ];
    let forward = format!("Sample; {}", statements.join(" "));
    let backward =
        format!("Sample; {}", statements.iter().rev().copied().collect::<Vec<_>>().join(" "));
    let (forward, backward) = (compiled(&forward).0, compiled(&backward).0);
    assert!(forward.diagnostics.is_empty() && backward.diagnostics.is_empty());
    let names = |compiled: &assur_model::checked::Compiled| {
        let scenes = compiled.model.as_ref().map(|model| &model.scenes).into_iter().flatten();
        let mut names: Vec<_> = scenes
            .map(|scene| {
                (scene.name.clone(), scene.outputs.len(), scene.states.len(), scene.constants.len())
            })
            .collect();
        names.sort();
        names
    };
    assert_eq!(names(&forward), names(&backward));
}

/// Effects inside effects, and choices inside them, are only there together; what does not balance is no combination.
#[test]
fn all_combinations_of_a_scene() {
    const TEXT: &str = "choice path { straight { let p = 1; } bent { let p = 2; } }
        effect a { effect inner { force 1 N on x; } choice c { one { } two { } } }
        effect b { force p*1 N on x; }
        effect missing { let q = unknown; output q; }
        scene whole = a + inner + b + missing { start x = 1 m; }";
    let tokens = lex_plain(&format!("{SPRING}{TEXT}")).expect("tokens").tokens;
    let names = |among: &[&str]| {
        let asked = Asked::Combinations(Some("whole"), among);
        let compiled = assur_model::compile_asked(&tokens, asked, &mut |_| unreachable!());
        let model = compiled.model.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        model.scenes.into_iter().map(|scene| scene.name).collect::<Vec<_>>()
    };
    let all = names(&[]);
    // Two paths, with b or not; without a one way, with it inner or not and one or two.
    assert_eq!(all.len(), 2 * 2 * (1 + 2 * 2), "{all:?}");
    assert!(all.iter().all(|name| !name.contains("missing")), "{all:?}");
    assert!(all.iter().filter(|name| name.contains("inner")).all(|name| name.contains("a + ")));
    assert!(all.contains(&"a + inner + c.two + path.bent".to_owned()), "{all:?}");
    // What is not named stays, and `missing` with it.
    assert_eq!(names(&["b", "path"]), Vec::<String>::new());
}
