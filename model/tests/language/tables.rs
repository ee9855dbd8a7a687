//! Sampled curves: values, derivatives and what else stands on them, against SciPy; files that make no curve.

use assur_model::checked::SceneModel;

use super::parts::{Files, check as check_files, scene as scene_of_files};
use super::{check, first_scene};

/// A progressive spring.
const SPRING: &str = "# measured\nlift [mm]; F [N]; n\n0; 0; 1\n1; 10.5; 2\n2; 22.4; 2\n4; 51; 5\n7; 110.2; 6\n10; 190; 1\n";

/// A lift over a turn.
const CAM: &str = "table(a; 0 deg: 0 mm, 60 deg: 3 mm, 120 deg: 10 mm, 180 deg: 12 mm, 250 deg: 7 mm, 300 deg: 2 mm, 360 deg: 0 mm; periodic)";

/// The last output of a formula sheet at `x = 3 mm`, `a` in degrees.
#[track_caller]
fn value(scene: &SceneModel, degrees: f64) -> f64 {
    let places = assur_model::program::Configuration { drivers: &[0.003], ..Default::default() };
    let values = scene.program.evaluate_linkage(&[degrees.to_radians()], 0.0, &places);
    values.get(*scene.program.results.outputs.last().unwrap())
}

fn sheet(output: &str) -> String {
    format!(
        "Sheet; parameter x = 3 mm, a = 30 deg; output x, a, z = {output}; scene s {{ sweep x 0 mm .. 10 mm; }}"
    )
}

#[track_caller]
fn near(output: &str, expected: f64) {
    near_at(output, 30.0, expected);
}

#[track_caller]
fn near_at(output: &str, degrees: f64, expected: f64) {
    let text = sheet(output);
    let files: &Files = &[("spring.csv", SPRING)];
    let found = value(&scene_of_files(&text, files), degrees);
    let error = (found - expected).abs();
    assert!(error <= 2e-14 * expected.abs(), "{output}: {found}, not {expected}: {error:e}");
}

#[test]
fn curves_have_their_values_and_derivatives() {
    // scipy.interpolate.CubicSpline, not-a-knot.
    near("table(\"spring.csv\", x, F)/(1 N)", 35.77619047619047);
    near("table(\"spring.csv\", x, \"F [N]\")/(1 N)", 35.77619047619047);
    near("diff(table(\"spring.csv\", x, F), x)/(1 [N/mm])", 14.225793650793651);
    near("integral(table(\"spring.csv\", s, F), s, 0 mm .. x)/(1 J)", 0.050419345238095235);
    near("solve(s in 0 mm .. 10 mm, table(\"spring.csv\", s, F) = 20 N)/(1 mm)", 1.807473409713621);
    near("table(3.0; 1: 2, 2: 4, 4: 8)", 6.0);
    near("table(2*x; 0 mm: 1, 10 mm: 2)", 1.6);
    assert!(value(&first_scene(&sheet("table(x; 0 mm: 1, 2 mm: 2)")), 0.0).is_nan());
}

#[test]
fn periods_go_on() {
    for turns in [-3.0, 0.0, 1.0, 7.0] {
        let text = sheet(&format!("{CAM}/(1 mm)"));
        let found = value(&first_scene(&text), 30.0 + 360.0 * turns);
        assert!((found - 0.8024770446295109).abs() < 1e-13, "{turns}: {found}");
    }
    near(&format!("diff({CAM}, a)/(1 mm)"), 2.7668592364870666);
    // The slope is continuous over the end of a period.
    let slope =
        |degrees: f64| value(&first_scene(&sheet(&format!("diff({CAM}, a)/(1 mm)"))), degrees);
    assert!((slope(-1e-9) - slope(1e-9)).abs() < 1e-7);
}

#[test]
fn smoothing_is_nearer_to_a_line_and_zero_error_is_none() {
    let noisy = "0 mm: 0.1, 1 mm: 0.9, 2 mm: 2.1, 3 mm: 2.9, 10 mm: 10";
    let bend = |options: &str| {
        value(
            &first_scene(&sheet(&format!(
                "diff(diff(table(x; {noisy}{options}), x), x)*(1 [mm^2])"
            ))),
            0.0,
        )
    };
    assert!(bend("").abs() > 0.1 && bend("; smooth 0.1").abs() < 0.02);
    assert!(bend("; smooth 10").abs() < 1e-9);
    check(
        &sheet("table(x; 0 mm: 1, 1 mm: 2, 2 mm: 3; smooth 0)"),
        &[(
            "the standard error of the ordinates has to be above zero",
            "table(x; 0 mm: 1, 1 mm: 2, 2 mm: 3; smooth 0)",
            "leave `smooth` out",
        )],
    );
}

/// A file is named relative to the file that names it.
#[test]
fn a_part_has_tables_of_its_own() {
    let part = "Spring; parameter s = 1 mm; let F = table(\"data/spring.csv\", s, F);";
    let main = "Sheet; parameter x = 3 mm, a = 0.5; part spring: Spring from \"parts/spring.eqn\" { s = x; } output x, a, z = spring.F/(1 N); scene s { sweep x 0 mm .. 10 mm; }";
    let files: &Files = &[("parts/spring.eqn", part), ("parts/data/spring.csv", SPRING)];
    assert!((value(&scene_of_files(main, files), 0.0) - 35.77619047619047).abs() < 1e-12);
}

#[test]
fn points_that_make_no_curve_are_explained() {
    for (output, expected) in [
        ("table(x; 0 mm: 1)", ("there is one point only", "table(x; 0 mm: 1)", "at least two")),
        ("table(x; )", ("there are no points", "table(x; )", "at least two")),
        (
            "table(x; 0 mm: 1, 1 mm: 2, 1 mm: 3)",
            ("the abscissa is the same", "1 mm", "rising order"),
        ),
        ("table(x; 0 mm: 1, 2 mm: 2, 1 mm: 3)", ("is smaller", "1 mm", "rising order")),
        (
            "table(a; 0: 1, 3: 2, 6: 1.5; periodic)",
            (
                "the period does not end as it begins: it begins with 1.000000e0 and ends with 1.500000e0",
                "1",
                "repeat",
            ),
        ),
        (
            "table(x; 0 mm: 1, 2 s: 2)",
            ("the abscissas are a length (m) and a time (s)", "0 mm: 1, 2 s", ""),
        ),
        (
            "table(x; 0 mm: 1 N, 2 mm: 2 mm)",
            ("the ordinates are a force (N) and a length", "1 N, 2 mm: 2 mm", ""),
        ),
        (
            "table(a; 0 mm: 1, 2 mm: 2)",
            ("the abscissa of the table is a length (m), and this is a pure number", "a", ""),
        ),
        (
            "table(x; 0 mm: 1 N, 2 mm: 2 N; smooth 1 mm)",
            ("the points and their error are", "1 N, 2 mm: 2 N; smooth 1 mm", ""),
        ),
        ("table(x; 0 mm: a, 2 mm: 2)", ("a fixed value is expected", "a", "")),
        ("table(x; 0 mm: 1/0, 2 mm: 2)", ("this divides by zero", "0", "")),
        ("table(x; 0 mm 1)", ("expected `:`", "1", "a point is written")),
        ("table(x, 0 mm: 1)", ("expected `;`", ",", "spring.csv")),
        (
            "table(x; 0 mm: 1, 1 mm: 2; linear)",
            ("expected `periodic` or `smooth`", "linear", "standard error"),
        ),
    ] {
        check(&sheet(output), &[expected]);
    }
}

#[test]
fn files_that_make_no_curve_are_explained() {
    let file = |text: &'static str, output: &str, expected| {
        check_files(&sheet(output), &[("spring.csv", text)], &[expected]);
    };
    let named = "\"spring.csv\"";
    let table = "table(\"spring.csv\", x)/(1 N)";
    file(SPRING, table, ("has several columns: `F`, `n`", named, "table(\"spring.csv\", x, F)"));
    file(SPRING, "table(\"spring.csv\", x, f)", ("has no column `f`", "f", "did you mean `F`?"));
    file(
        SPRING,
        "table(\"spring.csv\", a, F)/(1 N)",
        ("the abscissa of the table is a length (m)", "a", ""),
    );
    file(
        "s [mm], F [N]\n0, 1\n",
        table,
        ("`spring.csv`: there is one point only", named, "at least two"),
    );
    file(
        "s [mm], F [N]\n0, 1\n1,\n",
        table,
        ("line 3: `F` has a gap here", named, "take the line away"),
    );
    file(
        "s [mm], F [N]\n0, 1\n1, nan\n",
        table,
        ("line 3: `nan` of `F` is no finite number", named, ""),
    );
    file(
        "s [mm], F [N]\n0, 1\n# no\n0, 2\n",
        table,
        ("line 4 of `spring.csv`: the abscissa is the same", named, "rising"),
    );
    file(
        "s [m/m m], F [N]\n0, 1\n",
        table,
        ("`spring.csv`: the unit of `s`: it is not clear", named, ""),
    );
    check_files(
        &sheet("table(\"none.csv\", x)"),
        &[],
        &[("there is no file `none.csv`", "\"none.csv\"", "")],
    );
}
