//! Measures: what they are compiled to, and what is said about wrong ones.

use assur_model::checked::{Moment, Primitive, PrimitiveKind, SceneModel};

use super::{Expected, check, first_scene};

/// A mass that is pushed until it meets a wall.
const MASS: &str = "Sample; parameter F = 1 N, m = 2 kg, l = 1 m; coordinate x: m = 0; driver phi = 2*pi*time/(1 s); \
                    mode push { let N = 0; motion m*ddot(x) = F; when x - l rises -> rest { set dot(x) = 0; } } \
                    mode rest { let N = F; hold x; } output x, phi, N; scene go { run time 0 s .. 3 s; } ";

#[track_caller]
fn scene(text: &str) -> SceneModel {
    first_scene(&format!("{MASS}{text}"))
}

fn primitive(kind: PrimitiveKind, argument: usize, window: Option<usize>) -> Primitive {
    Primitive { kind, argument, window }
}

#[test]
fn a_measure_names_what_is_looked_at_and_what_is_found() {
    let scene = scene(
        "measure top = peak(x) [mm] \"how far\", early = mean(dot(x), time < 1 s), hits = count(enter(rest)); \
         measure speed = value(dot(x), last(leave(push))), ratio = (speed/early)^2; \
         measure first = amplitude(x, phi, 1);",
    );
    let names: Vec<_> = scene.measures.iter().map(|one| one.quantity.name.as_str()).collect();
    assert_eq!(names, ["top", "early", "hits", "speed", "ratio", "first"]);
    let top = &scene.measures[0].quantity;
    assert_eq!((top.unit.as_str(), top.factor, top.summary.as_str()), ("mm", 1e-3, "how far"));
    assert_eq!(scene.measures[1].quantity.unit, "m/s");
    use PrimitiveKind as Is;
    let leave = Moment::Leave(0, true);
    assert_eq!(
        scene.primitives,
        [
            primitive(Is::Peak, 0, None),
            primitive(Is::Mean, 1, Some(2)),
            primitive(Is::Count(Moment::Enter(1, false)), 0, None),
            primitive(Is::Value(leave), 3, None),
            primitive(Is::Cosine(5, 6, 1), 4, None),
            primitive(Is::Sine(5, 6, 1), 4, None),
        ]
    );
    let uses: Vec<_> = scene.measures.iter().map(|one| one.uses.clone()).collect();
    assert_eq!(uses, [vec![0], vec![1], vec![2], vec![3], vec![1, 3], vec![4, 5]]);
    for mode in &scene.modes {
        let results = &mode.program.results;
        assert_eq!((results.measured.len(), results.measures.len()), (7, 6));
    }
}

#[test]
fn a_quantity_that_is_zero_in_one_mode_has_its_unit_and_its_place() {
    let scene = scene("measure a = peak(x), N_max = peak(N), b = lowest(x);");
    assert_eq!(scene.measures[1].quantity.unit, "N");
    let places: Vec<_> = scene.primitives.iter().map(|one| one.argument).collect();
    assert_eq!(places, [0, 1, 2]);
    let looked_at = |mode: usize| {
        let program = &scene.modes[mode].program;
        let values = program.evaluate(&[1.0, 2.0, 1.0], 0.5, &[0.25, 0.0]);
        values.all(&program.results.measured)
    };
    assert_eq!(looked_at(0), [0.25, 0.0, 0.25]);
    assert_eq!(looked_at(1), [0.25, 1.0, 0.25]);
}

#[test]
#[rustfmt::skip]
fn wrong_measures() {
    let cases: &[(&str, &[Expected])] = &[
        ("measure a = 2*x;", &[("this changes during the run", "2*x", "`peak(x)`")]),
        ("output y = peak(x);", &[("`peak` is a number of a whole run", "peak(x)", "belong in a `measure`")]),
        ("measure a = peak(x); output y = 2*a;", &[("`a` is a number of a whole run", "a", "")]),
        ("measure a = peak(mean(x));", &[("`mean` is a number of a whole run", "mean(x)", "")]),
        ("measure a = peak(x, x, x);", &[("`peak` does not take 3 arguments", "peak(x, x, x)", "`peak(x), or peak(x, y > z)")]),
        ("measure a = duration(x);", &[("a condition is expected here", "x", "compare two quantities")]),
        ("measure a = duration(x == l);", &[("how long two quantities are exactly equal", "x == l", "`<` or `>`")]),
        ("measure a = value(x, enter(rst));", &[("a mode of this scene is expected here", "rst", "did you mean `rest`?")]),
        ("measure a = value(x, 3 s);", &[("a moment of the run is expected here", "3 s", "`enter(mode)`")]),
        ("measure a = amplitude(x, l, 1);", &[("an angle is expected here", "l", "")]),
        ("measure a = amplitude(x, phi, 1.5);", &[("a harmonic has a whole number", "1.5", "")]),
        ("measure a = peak(x) [N];", &[("`a` is a length (m), which cannot be printed in N", "[N]", "")]),
        ("measure a = b; measure b = a;", &[("`a` is defined by itself: a -> b -> a", "a", "")]),
        ("measure peak(x);", &[("a measure has a name and a value", "peak(x)", "`measure F_max = peak(F);`")]),
        ("measure x = peak(x);", &[("`x` is declared twice", "x", "")]),
        ("measure a = peak(x); expect at maximum: a = 1 m +- 1 m;", &[("`a` is a measure, a number of the whole run", "a", "write `at run`")]),
        ("measure peak = peak(x);", &[("`peak` is a function of measures", "peak", "another name")]),
        ("let mean = 2*x; measure a = mean(x); output mean;", &[("`mean` is a quantity here, which hides the function of measures", "mean", "another name")]),
        ("measure a = dot(peak(x));", &[("a number of the whole run has no derivative", "dot(peak(x))", "`peak(dot(x))`")]),
        ("measure a = straightness(x);", &[("`straightness` does not take 1 arguments", "straightness(x)", "`straightness(y, x)")]),
        ("measure a = value(x, l == 2*l);", &[("nothing in this changes during the run", "l == 2*l", "")]),
        ("measure a = value(x, x == 1 kg);", &[("", "x == 1 kg", "")]),
        ("measure a = multiplier(1);", &[("`multiplier` is a number of a motion that repeats", "1", "periodic")]),
        ("measure a = detuning(0);", &[("a multiplier has a whole number", "0", "nearest to 1")]),
        ("measure a = peak(x); measure b = diff(2*a, l);", &[("a number of the whole run has no derivative", "diff(2*a, l)", "")]),
        ("measure a = dot(x);", &[("this changes during the run", "dot(x)", "")]),
        ("expect at run: w = 1 m +- 1 m;", &[("`w` has to be a measure", "w", "declare a `measure`")]),
        ("measure far = peak(x); expect at run: fra = 1 m +- 1 m;", &[("`fra` has to be a measure", "fra", "did you mean `far`?")]),
        ("expect at run: x = 1 m +- 1 m;", &[("`x` is no measure", "x", "write where")]),
        ("mode rest { measure a = peak(x); }", &[("a measure stands outside every mode", "measure a = peak(x);", "each mode defines")]),
    ];
    for (text, expected) in cases {
        check(&format!("{MASS}{text}"), expected);
    }
}

/// A crank that turns evenly.
const CRANK: &str = "Crank; dimension r = 1 m; parameter w = 2 [rad/s]; driver phi = w*time ~ 0 deg in 0 deg .. 360 deg; \
                     dependent x ~ 1 m, y ~ 0 m; closure pin: r*dir(phi) = [x, y]; output x; ";

#[test]
fn what_drivers_move_in_time_and_positions_have_measures() {
    let timed = |measure: &str| {
        let text = format!("{CRANK} measure far = {measure}; scene s {{ periodic over 2*pi/w; }}");
        let scene = first_scene(&text);
        (scene.linkage.is_some(), scene.measures.len())
    };
    // Positions have all that is asked for, or a motion alone has.
    assert_eq!(timed("rms(x)"), (true, 1));
    assert_eq!(timed("total(x)"), (false, 1));
    let swept = |measure: &str, task: &str| {
        let text = format!("{CRANK} measure far = {measure}; scene s {{ {task} }}");
        let scene = first_scene(&text);
        (scene.measures.len(), scene.primitives.len(), scene.program.results.measured.len())
    };
    assert_eq!(swept("rms(x)", "sweep phi;"), (1, 1, 1));
    assert_eq!(swept("value(x, last(y == 0.5 m))", "sweep phi;"), (1, 1, 2));
    assert_eq!(swept("travel(phi, y > 0 m)/(1 rad) + count(x == y)", "sweep phi;"), (1, 2, 3));
    assert_eq!(swept("straightness(y, x, phi < 1)", "sweep phi;"), (1, 1, 3));
    assert_eq!(swept("total(x)", "sweep phi;"), (0, 0, 0));
    let shown = first_scene(&format!("{CRANK} scene s {{ periodic over 2*pi/w; }}"));
    assert!(shown.linkage.is_some());
    let facts = "scene s { sweep phi; } expect at run: far = 1 m +- 1 m;";
    first_scene(&format!("{CRANK} measure far = rms(x); {facts}"));
    let total = "measure far = total(x)/(1 s);";
    check(
        &format!("{CRANK}{total}{facts}"),
        &[("the scene `s` does not have the measure `far`", "far", "let the scene run")],
    );
}
