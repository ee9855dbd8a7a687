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
