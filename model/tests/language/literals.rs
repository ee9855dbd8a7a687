//! Which numbers keep a scene from being stated in other units.

use super::{SPRING, compiled, words};

/// Checks for each scene of a file which number it is, `None` for no number.
#[track_caller]
fn check(statements: &str, expected: &[Option<&str>]) {
    let text = format!("{SPRING}{statements}");
    let (compiled, lexed) = compiled(&text);
    let model = compiled.model.unwrap_or_else(|| panic!("{text}\n{:#?}", compiled.diagnostics));
    let literals = model.scenes.iter().map(|scene| scene.literal.as_ref());
    for literal in literals.clone().flatten() {
        let number = literal.text.split(' ').next().unwrap_or_default();
        assert!(words(&text, &lexed, literal.span).contains(number), "{text}");
    }
    let found: Vec<_> = literals.map(|literal| literal.map(|one| one.text.as_str())).collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn numbers_in_equations_and_outputs_depend_on_the_units() {
    for (statements, literal) in [
        ("output y = x + 3 mm;", "3 mm"),
        ("output y = (x/(1 mm))^0.88;", "1 mm"),
        ("output y = if x < 2 mm { 1 } else { 2 };", "2 mm"),
        ("output y = max(x, 3 m);", "3 m"),
        ("driver theta = 250 rpm*time;", "250 rpm"),
        ("potential (5 [N/m])*x^2/2;", "5 [N m^-1]"),
        ("force -(1 N)*sign(x) on x;", "1 N"),
        ("coordinate y: m = 0; motion m*ddot(y) = 4 N;", "4 N"),
        // An abbreviation brings its numbers along, however often and wherever it is used.
        ("let a = 2*b; let b = 3 mm; output y = x + a;", "3 mm"),
        ("let f(u) = u + 3 mm; output y = f(x);", "3 mm"),
        ("let f(u) = u + x; output y = f(3 mm);", "3 mm"),
        ("let a = 3 mm; let b = a; output y = x + a; output z = x + b;", "3 mm"),
        // The first in the file, not the first that is used.
        ("output y = x + a; output z = x + 2 mm; let a = 3 mm;", "2 mm"),
    ] {
        check(statements, &[Some(literal)]);
    }
}

#[test]
fn other_numbers_are_the_same_in_all_units() {
    for statements in [
        "",
        "output y = x + 0 mm;",
        "output y = 3*x*sin(20 deg + 1 rad);",
        "parameter k = 2 mm in 1 mm .. 1 m; output y = x + k;",
        "dimension k = 2 mm +- 0.1 mm; output y = x + k;",
        "parameter heat = 3 K; output y = heat + 20 K;",
        "require m < 5 kg \"light\";",
        "preset heavy { m = 9 kg; } scene s { preset heavy; }",
        "coordinate y: m = 3 mm; kinetic m*dot(y)^2/2;",
        "scene s { run time 0 s .. 3 s; start x = 2 mm; }",
        "scene s { periodic over 1 s; } expect at maximum: x = 1 m +- 1 m; mark \"here\" at time = 1 s;",
    ] {
        check(statements, &[None]);
    }
}

#[test]
fn each_scene_has_its_own_numbers() {
    check(
        "let gap = 3 mm; output gap; \
         effect stop { potential c*(x - gap)^2/2; } \
         choice support { fixed { let u = 0 m; } shaken { let u = 1 mm; } } \
         scene plain { output x; } scene hit = stop { output x; } \
         scene still { output z = x + u; } scene shaken = support.shaken { output w = x + u; }",
        &[None, Some("3 mm"), None, Some("1 mm")],
    );
}
