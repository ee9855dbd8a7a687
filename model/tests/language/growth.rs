//! What a file costs: steps grow with its length and little faster, and what grows without measure is an error.

use std::fmt::Write;
use std::time::{Duration, Instant};

use super::{SPRING, compiled, mistakes};

/// Longest that one file may take, on a slow machine without optimisation.
const PATIENCE: Duration = Duration::from_secs(60);

/// A linkage without loops.
const LINKAGE: &str = "Sample; parameter l = 1 m; driver phi in 0 deg .. 10 deg; output l*phi; ";

/// What a file begins with, what is repeated in it for `k` from 0 (and `j = k + 1`), and what it ends with.
type Family = (&'static str, &'static str, &'static str);

/// Files of one statement repeated, or of many statements that build on each other.
#[rustfmt::skip]
const FAMILIES: &[Family] = &[
    (SPRING, "let y@k = @k*x;", ""),
    (SPRING, "let y@j = y@k + x;", "let y0 = x; output y1;"),
    (SPRING, "let y@k = y@j + x;", "let y1000 = x; output y0;"),
    (SPRING, "let y@j = if y@k > 1 m { y@k/2 } else { y@k + x };", "let y0 = x; output y1;"),
    (SPRING, "let y@j = y@k*sin(y@k/(1 m));", "let y0 = x; output y1;"),
    (SPRING, "parameter p@k = @k m; output o@k = p@k*x;", ""),
    (SPRING, "output o@k = @k*x;", ""),
    (SPRING, "output o@k = zz@k;", ""),
    (SPRING, "output o@k = x + 1 s;", ""),
    (SPRING, "state q@k: 1 = 0; motion e@k: (1 s)*dot(q@k) = sin(q@k);", ""),
    (SPRING, "point P@k = [x, @k*x]; link P@k - P@k;", ""),
    (SPRING, "require m > @k*1e-9 kg \"heavy\";", ""),
    (SPRING, "force @k N on x;", ""),
    (SPRING, "kinetic m*dot(x*sin(@k*x/(1 m)))^2;", ""),
    (SPRING, "when x - @j m falls { set dot(x) = -dot(x); }", "scene s { run time 0 s .. 1 s; }"),
    (SPRING, "measure M@k = peak(@k*x);", "scene s { run time 0 s .. 1 s; }"),
    (SPRING, "expect scene s at time = 0.@k s: x = 0 m +- 1 m;", "scene s { run time 0 s .. 1 s; }"),
    (SPRING, "mark \"here\" at time = 0.@k s;", "scene s { run time 0 s .. 1 s; }"),
    (SPRING, "preset p@k { m = @j kg; }", ""),
    (SPRING, "effect e@k { potential c*(x - @k m)^2; }", ""),
    (SPRING, "choice e@k { a { } b { } }", ""),
    (SPRING, "scene s@k;", ""),
    (SPRING, "effect e@k { } scene s@k = e@k;", ""),
    (LINKAGE, "dependent y@k ~ 1 m; closure c@k: y@k = @k*l*cos(phi) + l; output y@k;", ""),
    (LINKAGE, "dependent a@k ~ 50 deg, b@k ~ 120 deg; closure c@k: l*dir(a@k) = [l, l*sin(phi)/9] + l*dir(b@k);", ""),
];

/// A family with so many members.
fn member((begin, repeated, end): &Family, count: usize) -> String {
    let mut text = begin.to_string();
    for k in 0..count {
        text += &repeated.replace("@k", &k.to_string()).replace("@j", &(k + 1).to_string());
    }
    text + &end.replace("1000", &count.to_string())
}

#[track_caller]
fn steps(text: &str) -> u64 {
    let start = Instant::now();
    let steps = compiled(text).0.steps;
    assert!(start.elapsed() < PATIENCE, "{:?}: {}", start.elapsed(), &text[..300]);
    steps
}

#[test]
fn steps_grow_with_the_length_of_the_file() {
    for family in FAMILIES {
        let [few, many] = [50, 200].map(|count| (steps(&member(family, count)), count));
        let each = (many.0 - few.0) as f64 / few.0 as f64;
        // Three times as much is added: more than four and a half times the steps would be a power of 1.25.
        assert!(each < 4.5, "{} then {} steps: {}", few.0, many.0, family.1);
    }
}

/// Nested calls, `outer(… outer(inner) …)`.
fn nested(outer: (&str, &str), inner: &str, count: usize) -> String {
    format!("{}{inner}{}", outer.0.repeat(count), outer.1.repeat(count))
}

#[test]
fn what_grows_without_measure_is_named() {
    let sines = nested(("diff(sin(", "), a)"), "a", 18);
    let sines = format!("let f(a) = {sines}; output hot = f(time/(1 s));");
    let mut twice = "let f0(a) = sin(a);".to_string();
    for k in 0..30 {
        let _ = write!(twice, "let f{}(a) = f{k}(f{k}(a));", k + 1);
    }
    twice += "output hot = f30(time/(1 s));";
    let sum = "output hot = ddot(sum(i in 1..10000, sin(i*x/(1 m))*cos((i + 1)*x/(1 m))*sin((i + 2)*x/(1 m))));".to_string();
    let mut product = "output hot = ddot(sin(x/(1 m))".to_string();
    for k in 0..400 {
        let _ = write!(product, "*sin({k}*x/(1 m) + 1)");
    }
    product += ");";
    for text in [sines, twice, sum, product] {
        let head: String = text.chars().take(60).collect();
        let text = format!("{SPRING} output dot(x); {text} output x^2;");
        let start = Instant::now();
        let (compiled, lexed) = compiled(&text);
        assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
        let mistakes = mistakes(&compiled);
        assert_eq!(mistakes.len(), 1, "{head}: {mistakes:?}");
        assert!(mistakes[0].message.starts_with("this statement grows too large"));
        let place = super::words(&text, &lexed, mistakes[0].span);
        assert!(place.starts_with("hot = "), "{place}");
    }
}

#[test]
fn a_file_that_is_too_large_as_a_whole_is_refused() {
    let coordinates: String = (0..4000)
        .map(|k| format!("coordinate q{k}: m = 0; kinetic m*dot(q{k})^2; potential c*q{k}^2;"))
        .collect();
    super::check(
        &format!("{SPRING} {coordinates} scene all;"),
        &[("the file is too large: with this scene", "all", "divide it")],
    );
}

/// Names one behind the other, each of which asked for all before it.
#[test]
fn members_of_members_are_limited() {
    let text = format!("{SPRING} output x{};", ".x".repeat(4000));
    super::check(&text, &[("more than 64 names follow each other", ".", "")]);
}
