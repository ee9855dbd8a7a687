//! Linkages that have mass: what is refused, and which coordinates are picked.

use super::*;

/// A file with some statements and a scene that runs.
fn file(statements: &str) -> String {
    format!(
        "Sample; parameter m = 2 kg, r = 1 m, J = 1 [kg m^2]; output m, r, J; {statements} \
         scene s {{ run time 0 s .. 1 s; }}"
    )
}

#[track_caller]
fn check_wrong(statements: &str, message: &'static str, words: &'static str, hint: &'static str) {
    check(&file(statements), &[(message, words, hint)]);
}

/// The independent coordinates, and how many loops may come to a dead point.
#[track_caller]
fn check_independent(statements: &str, expected: &[&str], carried: usize) {
    let scene = first_scene(&file(statements));
    let names: Vec<&str> = scene.states.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names[..scene.coordinates], *expected, "{statements}");
    assert_eq!(scene.carried.len(), carried, "{statements}");
}

const BEAD: &str = "coordinate a: rad = 0.5; dependent x ~ 1 m; closure l: r*cos(a) = x; output a;";

#[test]
#[rustfmt::skip]
fn what_does_not_move() {
    check_wrong("coordinate a: rad = 0, b: rad = 0.1 rad; closure l: r*dir(a) = r*dir(b); kinetic J*dot(a)^2/2;",
        "no coordinate is left that can move", "a", "prescribe a motion with `driver`");
    check_wrong("coordinate a: rad = 0; closure l: r*dir(a) = [r, 0 m]; kinetic J*dot(a)^2/2;",
        "only 1 of the 2 scalar closures are independent: `l.x` says what the others say", "closure l: r*dir(a) = [r, 0 m];", "leave the redundant one out");
    check_wrong(BEAD, "nothing determines `ddot(a)`", "a", "energy with this unknown");
    check_wrong(&format!("{BEAD} kinetic J*dot(a)^2/2; closure p: 9*r*dir(a) = [u, 0 m] + r*dir(b); dependent u ~ 8 m, b ~ 0 rad;"),
        "the loop `p.y` does not close where the motion begins", "closure p: 9*r*dir(a) = [u, 0 m] + r*dir(b);", "start values");
}

#[test]
#[rustfmt::skip]
fn starts_that_closures_contradict() {
    let line = |y: &str, rates: [&str; 2]| format!(
        "coordinate x: m = 0.5 m{}, y: m = {y}{}; closure c: x + y = r; kinetic m*(dot(x)^2 + dot(y)^2)/2; output x, y;", rates[0], rates[1]);
    check(&file(&line("0.5 m", ["", ""])), &[]);
    check(&file(&line("0.500000001 m", ["", ""])), &[]);
    let (compiled, _) = compiled(&file(&line("0.500000001 m", ["", ""])));
    let note = compiled.diagnostics.iter().find(|one| one.message.contains("does not quite start"));
    assert!(note.is_some_and(|note| note.message.contains("1.0e-9 m away")), "{:#?}", compiled.diagnostics);
    check_wrong(&line("0.501 m", ["", ""]), "`y` cannot start at 0.501000000 m: the closures say 0.500000000 m, 1.0e-3 m away", "0.501 m", "`dependent` with a rough value");
    check_wrong(&line("0.5 m", [", rate = 1 [m/s]", ", rate = 1 [m/s]"]), "`dot(y)` cannot start at 1.000000000 m/s", "1 [m/s]", "correct it");
    check(&file(&line("0.5 m", [", rate = 1 [m/s]", ", rate = -1 [m/s]"])), &[]);
}

#[test]
#[rustfmt::skip]
fn forces_that_are_none() {
    let bead = format!("{BEAD} kinetic J*dot(a)^2/2;");
    let wrong = |statements: &str, message: &'static str, words: &'static str, hint: &'static str| {
        check_wrong(&format!("{bead} {statements}"), message, words, hint);
    };
    wrong("output f = reaction(spring);", "there is no closure `spring`", "spring", "`closure pin: A = B;`");
    wrong("closure pin: r*sin(a) = y; dependent y ~ 0 m; output f = reaction(pinn);", "there is no closure `pinn`", "pinn", "did you mean `pin`?");
    wrong("output f = effort(a);", "`a` moves freely", "a", "`reaction(closure)`");
    wrong("output f = effort(zz);", "`zz` is no driver", "zz", "`effort(phi)`");
    wrong("output f = energy(heat);", "there is no energy `heat`", "heat", "`energy(kinetic)`");
    wrong("output f = dot(reaction(l));", "have no derivative here", "dot(reaction(l))", "report the quantity itself");
    wrong("force 1 [N]*sign(reaction(l)) on x;", "a force jumps or bends where that of a closure changes its sign", "1 [N]*sign(reaction(l))", "take `abs` or `norm` of it");
    wrong("potential reaction(l)*x;", "cannot depend on an `effort` or an `energy`", "potential reaction(l)*x;", "friction is a `force` that depends on a `reaction`");
}

#[test]
fn forces_of_what_has_none() {
    check(
        "Sample; parameter r = 1 m; driver a in 0 deg .. 90 deg; dependent x ~ 1 m; \
         closure l: r*cos(a) = x; output f = reaction(l); scene s { sweep a; }",
        &[("nothing has mass or force", "s", "state the inertia by `kinetic`")],
    );
}

#[test]
fn forces_of_an_equation_that_is_written_out() {
    check_wrong(
        "coordinate a: rad = 0.5; dependent x ~ 1 m; closure l: r*cos(a) = x; \
         motion q: J*ddot(a) + m*ddot(x)*diff(x, a) = 0; output f = reaction(l);",
        "`q` is an equation of motion that is written out",
        "motion q: J*ddot(a) + m*ddot(x)*diff(x, a) = 0;",
        "by `kinetic`",
    );
}

#[test]
#[rustfmt::skip]
fn quantities_may_be_called_after_what_they_are() {
    check(&file(&format!("{BEAD} kinetic J*dot(a)^2/2; output energy = energy(kinetic), reaction = reaction(l);")), &[]);
}

#[test]
#[rustfmt::skip]
fn independent_coordinates_are_those_that_are_declared_first() {
    let bodies = "coordinate a: rad = 0, rate = 1 [rad/s], x1: m = 1 m, y1: m = 0, b: rad = 0, x: m = 3 m; \
        let C = [x1, y1]; closure p: r/2*dir(a) = C - r/2*dir(b); closure q: C + 3*r/2*dir(b) = [x, 0 m]; \
        kinetic J*dot(a)^2/2 + m*inner(dot(C), dot(C))/2 + m*dot(x)^2/2; output a, x;";
    check_independent(&bodies.replace("x: m = 3 m", "x: m = 2.5 m"), &["a"], 1);
    // A distance: of its two coordinates that which it determines well where the motion begins.
    let pendulum = |start: &str| format!("coordinate {start}; closure rope: x^2 + y^2 = r^2; \
        kinetic m*(dot(x)^2 + dot(y)^2)/2; potential m*(9.81 [m/s^2])*y; output x, y, reaction(rope);");
    check_independent(&pendulum("x: m = 0, y: m = -1 m"), &["x"], 1);
    check_independent(&pendulum("x: m = -1 m, y: m = 0"), &["y"], 1);
}

/// Angles that count from each other are directions of links.
#[test]
#[rustfmt::skip]
fn relative_angles_are_closed_like_directions() {
    let chain = |second: &str, guess: &str| format!("coordinate a: rad = 0.3; dependent b ~ {guess}, c ~ -0.9; \
        closure l: r*dir(a) + r*dir({second}) = [1.5*r, 0 m] + 1.2*r*dir(c); kinetic J*dot(a)^2/2; output a, b, c;");
    check_independent(&chain("b", "-1.2"), &["a"], 1);
    check_independent(&chain("a + b", "-1.5"), &["a"], 1);
    check_independent(&chain("b + c", "-0.3"), &["a"], 1);
    check_independent(&chain("c - b", "0.3"), &["a"], 1);
}

/// Start values that follow from constants pick the assembly mode by the values of the file, which a motion then keeps: others
/// that pick another one are refused.
#[test]
fn start_values_of_what_is_carried_follow_from_constants() {
    let file = |rest: &str| {
        format!("Rocker; dimension a = 25 mm, b = 90 mm, c = 60 mm, d = 100 mm; parameter mode = -1, J = 1 [kg m^2];
        coordinate phi: rad = 0.5, rate = 2 [rad/s]; kinetic J*dot(phi)^2/2 + J*dot(psi)^2/2;
        let e = [d, 0] - a*dir(phi), gamma_0 = atan2(e.y, e.x) + mode*acos((b^2 + norm(e)^2 - c^2)/(2*b*norm(e)));
        dependent gamma ~ gamma_0, psi: rad;
        closure loop: a*dir(phi) + b*dir(gamma) = [d, 0] + c*dir(psi); output psi, gamma, gamma_0;
        scene go {{ run time 0 s .. 1 s; {rest} }}")
    };
    let scene = first_scene(&file(""));
    let place = scene.constants.iter().position(|one| one.quantity.name == "mode");
    let mode = place.expect("the constant is there");
    assert_eq!(scene.requirements.len(), 1);
    assert_eq!(scene.requirements[0].names, [mode]);
    assert_eq!(scene.requirements[0].message, "loop.x, loop.y");
    let held = |sign: f64| {
        let mut parameters: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
        parameters[mode] = sign;
        let found = scene.program.evaluate(&parameters, 0.0, &[0.5, 2.0]);
        (
            found.all(&scene.program.results.requirements)[0],
            found.all(&scene.program.results.outputs),
        )
    };
    let ((kept, outputs), (other, _)) = (held(-1.0), held(1.0));
    assert!(kept != 0.0 && other == 0.0, "{kept} {other}");
    assert!((outputs[1] - outputs[2]).abs() < 1e-14, "{outputs:?}");
    check(
        &file("vary mode in {-1, 1}, a in 20 mm .. 30 mm; minimise peak(psi);"),
        &[("`mode` picks the assembly mode of loop.x, loop.y", "mode", "for each mode")],
    );
}
