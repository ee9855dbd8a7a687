//! What scenes seek: what it is compiled to, and what is said about what is wrong.

use super::{check, first_scene};

/// A crank that drives a rocker.
const ROCKER: &str = "Sample; dimension l1 = 15 mm in 5 mm .. 100 mm, l2 = 90 mm, a = 100 mm in 5 mm .. 200 mm; \
                      parameter l3 = 50 mm, turn = 0 deg; driver phi ~ 90 deg in 0 deg .. 360 deg; \
                      dependent gamma ~ 20 deg, psi ~ 100 deg; \
                      closure loop: l1*dir(phi + turn) + l2*dir(gamma) = [a, 0] + l3*dir(psi); \
                      output psi; measure swing = peak(psi) - lowest(psi); ";

#[test]
fn what_is_sought_is_measures_and_constants() {
    let scene = first_scene(&format!(
        "{ROCKER} scene best {{ sweep phi; vary l1, l2 in 30 mm .. 150 mm; vary turn in 0 deg .. 360 deg; \
         require l1 + a < l2 + l3 \"the crank turns\"; require swing >= 40 deg; minimise peak(abs(cos(psi - gamma))); }}"
    ));
    let synthesis = scene.synthesis.expect("it seeks");
    let varied: Vec<_> = synthesis
        .varied
        .iter()
        .map(|one| (scene.constants[one.constant].quantity.name.as_str(), one.from, one.to))
        .collect();
    let turn = std::f64::consts::TAU;
    assert_eq!(varied, [("l1", 5e-3, 0.1), ("l2", 0.03, 0.15), ("turn", 0.0, turn)]);
    let name = |index: usize| scene.measures[index].quantity.name.as_str();
    let conditions: Vec<_> = synthesis.conditions.iter().map(|index| name(*index)).collect();
    assert_eq!(conditions, ["l1 + a < l2 + l3", "swing >= 40 deg"]);
    assert_eq!(name(synthesis.objective), "peak(abs(cos(psi - gamma)))");
    assert_eq!(scene.measures[synthesis.conditions[0]].quantity.summary, "the crank turns");
    assert_eq!(scene.measures[synthesis.conditions[1]].quantity.unit, "deg");
    assert_eq!(name(0), "swing");
}

#[test]
fn preferences_cost_what_they_are_missed_by() {
    let scene = first_scene(&format!(
        "{ROCKER} scene best {{ sweep phi; vary l1; prefer l1 > 7 mm weight 3 [deg/mm] \"long\"; prefer swing < 1; minimise swing; }}"
    ));
    let preferences = scene.synthesis.expect("it seeks").preferences;
    let name = |index: usize| scene.measures[index].quantity.name.as_str();
    let found: Vec<_> = preferences.iter().map(|(index, cost)| (name(*index), *cost)).collect();
    assert_eq!(found, [("l1 > 7 mm", 3f64.to_radians() * 1e3), ("swing < 1", 1.0)]);
}

/// A sum of squares is known term by term, however it is written; what is none stays one number.
#[test]
fn squares_are_known_one_by_one() {
    let misfits = |small: &str| {
        let scene = first_scene(&format!(
            "Sample; for k in 1..2 {{ parameter x[k] = 1 m in 0 m .. 9 m, w[k] = 1 in 0 .. 9; }} \
             let far = [x[1] - 1 m, x[2] - 2 m]; driver t in 0 .. 1; output y = t*x[1], apart = w[1]*w[2]*norm(far)*t; \
             scene best {{ sweep t; vary x[1], x[2] in 0 m .. 5 m; minimise {small}; }}"
        ));
        let synthesis = scene.synthesis.expect("it seeks");
        let names = synthesis.varied.iter().map(|one| one.name.as_str());
        assert_eq!(names.collect::<Vec<_>>(), ["x[1]", "x[2]"]);
        let all = synthesis.squares.iter().map(|index| &scene.measures[*index].quantity);
        all.map(|one| format!("{} [{}]", one.name, one.unit)).collect::<Vec<_>>()
    };
    let two = |name: &str| vec![format!("{name} 1 [m]"), format!("{name} 2 [m]")];
    assert_eq!(misfits("inner(far, far)"), two("misfit"));
    assert_eq!(misfits("off = sum(k in 1..2, 3*(x[k] - k*1 m)^2)"), two("off"));
    assert_eq!(misfits("2*(inner(far, far) + (x[1] - x[2])^4/(1 m)^2)").len(), 3);
    assert_eq!(misfits("peak(y)^2"), ["misfit 1 [m]"]);
    assert_eq!(misfits("x[1]^2 - x[2]^2"), [""; 0]);
    assert_eq!(misfits("w[1]*x[1]^2"), [""; 0]);
}

#[test]
fn a_constant_may_have_certain_values_only() {
    let scene = first_scene(&format!(
        "{ROCKER} scene best {{ sweep phi; vary turn in {{2 deg, -1 deg, 2 deg}}, l1; minimise swing; }}"
    ));
    let varied = scene.synthesis.expect("it seeks").varied;
    let [low, high] = [-1.0, 2.0].map(f64::to_radians);
    assert_eq!(
        (varied[0].from, varied[0].to, &varied[0].values[..]),
        (low, high, &[low, high][..])
    );
    assert_eq!(varied[1].values, []);
}

#[test]
fn a_measure_of_the_file_or_a_named_one_may_be_made_small() {
    for (what, name, unit) in [("swing", "swing", ""), ("all = 2*swing [deg]", "all", "deg")] {
        let text = format!("{ROCKER} scene best {{ sweep phi; vary l1; minimise {what}; }}");
        let scene = first_scene(&text);
        let objective = scene.synthesis.expect("it seeks").objective;
        let quantity = &scene.measures[objective].quantity;
        assert_eq!((quantity.name.as_str(), quantity.unit.as_str()), (name, unit));
    }
}

#[test]
fn what_is_wrong_is_told() {
    for (items, message, place, hint) in [
        ("vary l1;", "does not say what is to be small", "l1", "add `minimise"),
        ("require swing > 1 rad;", "does not say what is to be small", "swing > 1 rad", "outside"),
        ("minimise swing;", "nothing is varied", "swing", "vary l1 in"),
        ("vary l1; minimise swing; minimise 2*swing;", "one number small", "2*swing", "add the"),
        ("vary l2; minimise swing;", "which values `l2` is varied", "l2", "vary l2 in lowest"),
        ("vary l1, l1; minimise swing;", "`l1` is varied twice", "l1", ""),
        (
            "vary l9 in 1 mm .. 2 mm; minimise swing;",
            "no dimension or parameter `l9`",
            "l9",
            "did you mean",
        ),
        ("vary psi in 0 deg .. 9 deg; minimise swing;", "parameter `psi`", "psi", ""),
        (
            "vary l1 in {6 mm, 6 mm}; minimise swing;",
            "nothing to choose from",
            "6 mm, 6 mm",
            "vary l1 in {",
        ),
        ("vary l1 in {6 mm, 6 m}; minimise swing;", "not permitted", "6 mm, 6 m", ""),
        ("vary l1 in {6 mm, 6 deg}; minimise swing;", "`l1`", "6 deg", "give it in m"),
        ("vary l1 in 9 mm .. 6 mm; minimise swing;", "the range is empty", "9 mm .. 6 mm", ""),
        ("vary l1 in 1 deg .. 2 deg; minimise swing;", "`l1`", "1 deg", "give it in m"),
        (
            "vary l1 in 1 mm .. 20 mm; minimise swing;",
            "not permitted everywhere",
            "1 mm .. 20 mm",
            "",
        ),
        ("vary l1; require swing; minimise swing;", "between two numbers", "swing", "of its own"),
        (
            "vary l1; prefer a < 1 m; minimise swing;",
            "missed by a length",
            "a < 1 m",
            "weight 0.2 [1/m]",
        ),
        ("vary l1; prefer swing < 1 weight -2; minimise swing;", "above zero", "-2", ""),
        ("vary l1; prefer swing < 1 weight l1; minimise swing;", "a fixed value", "l1", ""),
        (
            "vary l1; require swing < 1; prefer swing < 1; minimise swing;",
            "preferred as well",
            "swing < 1",
            "leave one",
        ),
        (
            "prefer swing > 1 rad;",
            "does not say what is to be small",
            "swing > 1 rad",
            "add `minimise",
        ),
        ("vary l1; minimise far;", "no measure `far`", "far", ""),
    ] {
        let text = format!("{ROCKER} scene best {{ sweep phi; {items} }}");
        check(&text, &[(message, place, hint)]);
    }
}

#[test]
fn what_changes_nothing_is_not_varied() {
    let text = "Sample; parameter a = 1 mm, b = 2 mm; coordinate x: m = 0; motion ddot(x) = a/(1 [s^2]); output x; \
                let y = b; scene go { run time 0 s .. 1 s; vary b in 1 mm .. 3 mm; minimise peak(x); }";
    check(text, &[("nothing in the scene `go` depends on `b`", "b", "leave it out")]);
}

/// A line through a curve.
const LINE: &str = "Line; parameter a = 0 in -5 .. 5, b = 0 in -5 .. 5, c = 1 in 0 .. 5, k = 1 in 0 .. 2; driver x in 0 .. 1; \
                    output y = a + b*x + c*k; measure off = peak(abs(a + b*x + c*k - exp(k*x))); ";

#[test]
fn constants_follow_from_a_condition() {
    let solved = |text: &str| {
        let scene = first_scene(text);
        let synthesis = scene.synthesis.expect("it seeks");
        let count = scene.program.results.measured.len();
        let solved = synthesis.solved.expect("it solves");
        assert!(solved.terms.iter().all(|term| term.quantity < count));
        let terms =
            solved.terms.into_iter().map(|term| (term.powers, term.moves)).collect::<Vec<_>>();
        (solved.unknowns, terms, solved.scanned, solved.free, solved.groups)
    };
    let line = solved(&format!(
        "{LINE} scene best {{ sweep x; vary k; solve for a, b in 0 .. 4: a + b*x = exp(k*x); minimise off; }}"
    ));
    let terms = vec![(vec![0, 0], true), (vec![0, 1], true), (vec![1, 0], false)];
    assert_eq!(line, (vec![1, 2], terms, None, Some(0), vec![]));
    // The point on the coupler of a crank-rocker that keeps its distance from another: the loop is closed for it.
    let point = solved(&format!(
        "{ROCKER} parameter u = 0 m in -1 m .. 1 m, v = 0 m in -1 m .. 1 m, r = 1 m in 0 m .. 2 m, q = 0 m in -1 m .. 1 m; \
         point P = l1*dir(phi + turn) + rot(gamma)*[u, v], Q = [q, 2*q]; output far = norm(P - Q) - r; \
         scene best {{ sweep phi; vary l1; solve for u, v, r, q: inner(P - Q, P - Q) = r^2; minimise swing; }}"
    ));
    assert_eq!((point.0, point.2, point.3, point.4), (vec![1, 2, 3, 4], Some(3), Some(2), vec![0]));
}

#[test]
#[rustfmt::skip]
fn conditions_that_constants_do_not_follow_from() {
    let wrong = |solve: &str, message: &'static str, words: &'static str, hint: &'static str| {
        check(&format!("{LINE} scene best {{ sweep x; vary k; {solve} minimise off; }}"), &[(message, words, hint)]);
    };
    wrong("solve a: a*x = 1;", "found `a`, expected `for`", "a", "`solve for x, y: left = right;`");
    wrong("solve for a: sin(a)*x = 1;", "this is no polynomial in the constants", "sin(a)*x = 1", "lengths and angles are not");
    wrong("solve for a: x^a = 1;", "this is no polynomial in the constants", "x^a = 1", "");
    wrong("solve for a, b: a^2*x + b^2*x^3 = 1;", "more than one constant enters this in powers", "a^2*x + b^2*x^3 = 1", "vary one of them");
    wrong("solve for a, b: a + b = x;", "`b` does not follow from the condition", "b", "vary it");
    wrong("solve for a, b, c: a*x + b^2 + b*c = x;", "`b` does not follow from the condition", "b", "vary it");
    wrong("solve for a, b: a*x = exp(x);", "`b` does not follow from the condition", "b", "vary it");
    wrong("solve for a: a*x + a^2 = exp(x);", "a term with `a` does not move", "a*x + a^2 = exp(x)", "makes up for it");
    wrong("solve for a: [a*x, x] = [1, 2];", "a condition to be solved is between two numbers", "[a*x, x] = [1, 2]", "the square of their distance");
    wrong("solve for a: a*x = 1 m;", "the two sides of the equation are", "a*x = 1 m", "");
    wrong("solve for a: a*x = 1; solve for b: b*x = 1;", "constants follow from one condition", "b*x", "");
    wrong("solve for a in {1, 2}: a*x = 1;", "`a` is solved for, and so has a range", "a", "chosen from single values");
    wrong("solve for k: k*x = 1;", "`k` is varied twice", "k", "");
    wrong("solve for z: z*x = 1;", "`z`", "z", "");
    wrong("solve for a, b, c: (a + b*x + c*x^2 + a*b)^12 = 1;", "this is no polynomial in the constants that are solved for, or a long one", "(a + b*x + c*x^2 + a*b)^12 = 1", "");
    check("Moves; parameter a = 0 in -5 .. 5, k = 1 in 0 .. 2; state x: 1 = 0; motion m: 1 s*dot(x) = k - x; output y = a*x; \
           scene best { run time 0 s .. 1 s; vary k; solve for a: a*time/1 s = 1; minimise peak(x) + a; }",
        &[("this scene moves by itself", "a*time/1 s = 1", "vary them")]);
    check(&format!("{ROCKER} scene best {{ sweep phi; vary a; solve for l1: l1*cos(psi) = 1 m; minimise swing; }}"),
        &[("this depends on `l1` through the loops as well", "l1*cos(psi) = 1 m", "where it has to be")]);
}
