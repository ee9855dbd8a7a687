//! Derivatives that do not exist, behind the spring of [`SPRING`](super::SPRING): what is said of them, and what is let
//! pass.

use super::{SPRING, check, compiled, words};

/// What stands behind the spring; the message; the words that it points at, and those that asked for the derivative; a
/// part of the hint.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// Checks that each file gives its one message.
#[track_caller]
fn check_all(cases: &[Case]) {
    for (text, message, place, asked, hint) in cases {
        let text = format!("{SPRING}{text}");
        check(&text, &[(message, place, hint)]);
        let (compiled, lexed) = compiled(&text);
        let found = &compiled.diagnostics[0];
        assert_eq!(found.message, *message, "{text}");
        let related = found.related.as_ref().expect("it says what asked for it");
        assert_eq!(words(&text, &lexed, related.0), *asked, "{text}");
    }
}

#[track_caller]
fn check_right(files: &[&str]) {
    for text in files {
        check(&format!("{SPRING}{text}"), &[]);
    }
}

#[test]
#[rustfmt::skip]
fn of_what_jumps() {
    check_all(&[
        ("output y = dot(sign(x));", "`sign(x)` has no derivative: it jumps where `x` passes zero", "sign(x)", "dot(sign(x))", "`tanh(x/eps)`"),
        ("output y = dot(x*sign(1 m - x));", "`sign(1 m - x)` has no derivative: it jumps where `1 m - x` passes zero", "sign(1 m - x)", "dot(x*sign(1 m - x))", "`tanh((1 m - x)/eps)`"),
        ("output y = dot(floor(x/(1 m)));", "`floor(x/1 m)` has no derivative: it jumps where `x/1 m` passes a whole number", "floor(x/(1 m))", "dot(floor(x/(1 m)))", "leave it out"),
        ("output y = ddot(mod(time, 2 s));", "`mod(time, 2 s)` has no derivative: it jumps where `time` passes a multiple of `2 s`", "mod(time, 2 s)", "ddot(mod(time, 2 s))", "take `time` instead"),
        ("output y = diff(sign(x)*time, x);", "`sign(x)` has no derivative: it jumps where `x` passes zero", "sign(x)", "diff(sign(x)*time, x)", "the branches of an `if`"),
        ("output y = dot(if x > 0 { 1 } else { 2 });", "this `if` has no derivative: it jumps where `x > 0` begins or ceases to hold", "if x > 0 { 1 } else { 2 }", "dot(if x > 0 { 1 } else { 2 })", "let its branches meet there"),
        ("output y = dot(if x > 1 m { 1 } else if x > 0 { 2 } else { m/(1 kg) });", "this `if` has no derivative: it jumps where `x > 1 m` begins or ceases to hold", "if x > 1 m { 1 } else if x > 0 { 2 } else { m/(1 kg) }", "dot(if x > 1 m { 1 } else if x > 0 { 2 } else { m/(1 kg) })", ""),
    ]);
}

#[test]
#[rustfmt::skip]
fn of_what_bends_for_the_second_time() {
    check_all(&[
        ("output y = ddot(abs(x));", "`abs(x)` has no second derivative: the first one jumps where `x` passes zero", "abs(x)", "ddot(abs(x))", "`sqrt(x^2 + eps^2)`"),
        ("let a = abs(x); let v = dot(a); output y = dot(v);", "`abs(x)` has no second derivative: the first one jumps where `x` passes zero", "abs(x)", "dot(v)", ""),
        ("output y = ddot(max(x, 1 m, 2*x));", "`max(x, 1 m, 2*x)` has no second derivative: the first one jumps where another argument becomes the largest", "max(x, 1 m, 2*x)", "ddot(max(x, 1 m, 2*x))", "(a + b + sqrt((a - b)^2 + eps^2))/2"),
        ("output y = ddot(min(x, 1 m));", "`min(x, 1 m)` has no second derivative: the first one jumps where another argument becomes the smallest", "min(x, 1 m)", "ddot(min(x, 1 m))", "(a + b - sqrt((a - b)^2 + eps^2))/2"),
        ("output y = ddot(sqrt(x^2));", "`sqrt(x^2)` has no second derivative: the first one jumps where it is zero", "sqrt(x^2)", "ddot(sqrt(x^2))", ""),
        ("let f(a) = diff(max(a, 0), a); output y = dot(f(x));", "`max(a, 0)` has no second derivative: the first one jumps where another argument becomes the largest", "max(a, 0)", "dot(f(x))", ""),
        ("driver theta = abs(time - 1 s); output y = ddot(theta);", "`abs(time - 1 s)` has no second derivative: the first one jumps where `time - 1 s` passes zero", "abs(time - 1 s)", "ddot(theta)", "`sqrt((time - 1 s)^2 + eps^2)`"),
    ]);
}

/// The message points at the function, wherever the derivative finds it.
#[test]
#[rustfmt::skip]
fn through_names() {
    let sign = "`sign(x)` has no derivative: it jumps where `x` passes zero";
    check_all(&[
        ("let f = 3*sign(x); output y = dot(f);", sign, "sign(x)", "dot(f)", ""),
        ("let f(a) = 3*sign(a); output y = dot(f(x));", "`sign(a)` has no derivative: it jumps where `a` passes zero", "sign(a)", "dot(f(x))", ""),
        ("let f(a) = diff(sign(a), a); output y = f(x), z = f(2), w = f(m);", "`sign(a)` has no derivative: it jumps where `a` passes zero", "sign(a)", "diff(sign(a), a)", ""),
        ("let f(a) = dot(a); output y = f(sign(x));", sign, "sign(x)", "dot(a)", ""),
        ("driver theta = mod(time, 2 s); output y = dot(2*theta);", "`mod(time, 2 s)` has no derivative: it jumps where `time` passes a multiple of `2 s`", "mod(time, 2 s)", "dot(2*theta)", ""),
        ("let y[1] = sign(x)*(1 m); output z = dot([x, y[1]]);", sign, "sign(x)", "dot([x, y[1]])", ""),
        // What is equal and not differentiated is let alone.
        ("force -1 N*sign(x) on x; output y = ddot(abs(x));", "`abs(x)` has no second derivative: the first one jumps where `x` passes zero", "abs(x)", "ddot(abs(x))", ""),
        ("output s = sign( x ); output y = dot(sign(x));", sign, "sign(x)", "dot(sign(x))", ""),
    ]);
}

#[test]
#[rustfmt::skip]
fn energies() {
    check_all(&[
        ("potential c*(if x > 1 m { 1 } else { 2 })*x^2/2;", "this `if` has no derivative: it jumps where `x > 1 m` begins or ceases to hold", "(if x > 1 m { 1 } else { 2 })", "potential c*(if x > 1 m { 1 } else { 2 })*x^2/2;", "state the forces themselves by `force` or `motion`"),
        ("dissipation 3 W*sign(dot(x) - 1 [mm/s]);", "`sign(dot(x) - 1 [mm s^-1])` has no derivative: it jumps where `dot(x) - 1 [mm s^-1]` passes zero", "sign(dot(x) - 1 [mm/s])", "dissipation 3 W*sign(dot(x) - 1 [mm/s]);", ""),
        ("kinetic m*sign(x)*dot(x)^2/2;", "`sign(x)` has no derivative: it jumps where `x` passes zero", "sign(x)", "kinetic m*sign(x)*dot(x)^2/2;", ""),
        ("kinetic m*sign(time - 1 s)*dot(x)^2/2;", "`sign(time - 1 s)` has no derivative: it jumps where `time - 1 s` passes zero", "sign(time - 1 s)", "kinetic m*sign(time - 1 s)*dot(x)^2/2;", ""),
        ("kinetic m*abs(dot(x))*(1 [m/s]);", "`abs(dot(x))` has no second derivative: the first one jumps where `dot(x)` passes zero", "abs(dot(x))", "kinetic m*abs(dot(x))*(1 [m/s]);", ""),
        ("kinetic m*dot(x + abs(x))^2/2;", "`abs(x)` has no second derivative: the first one jumps where `x` passes zero", "abs(x)", "kinetic m*dot(x + abs(x))^2/2;", ""),
        ("force 1 N on sign(x)*(1 m);", "`sign(x)` has no derivative: it jumps where `x` passes zero", "sign(x)", "force 1 N on sign(x)*(1 m);", ""),
    ]);
}

/// One mistake, one message: in repetitions, in scenes, in all that depends on it.
#[test]
#[rustfmt::skip]
fn each_is_said_once() {
    let jump = |passes: &'static str| (passes, "sign(x - k*(1 m))", "");
    check(&format!("{SPRING} for k in 1..3 {{ let y[k] = sign(x - k*(1 m)); output z[k] = dot(y[k]); }}"), &[jump("it jumps where `x - 1*1 m` passes zero")]);
    check(&format!("{SPRING} output y = dot(sum(k in 1..3, sign(x - k*(1 m))));"), &[jump("it jumps where `x - 1*1 m` passes zero")]);
    check_all(&[
        ("let f = sign(x); let v = dot(f); output y = dot(v), z = 2*v, w = diff(f, x); scene s; scene t;", "`sign(x)` has no derivative: it jumps where `x` passes zero", "sign(x)", "dot(f)", ""),
        ("potential c*x*(1 m)*sign(x - 1 m); scene s { run time 0 s .. 1 s; } scene t;", "`sign(x - 1 m)` has no derivative: it jumps where `x - 1 m` passes zero", "sign(x - 1 m)", "potential c*x*(1 m)*sign(x - 1 m);", ""),
    ]);
}

#[test]
fn what_is_not_differentiated_may_jump() {
    check_right(&[
        // Nothing moves in the jump, or nothing by which is differentiated.
        "output y = dot(sign(m - 1 kg)*x), z = diff(sign(m - 1 kg)*x, m);",
        "output y = diff(sign(x)*time, time);",
        "driver theta = mod(time, 2 s); output y = theta, z = diff(x*theta, x);",
        "potential c*(if time > 1 s { 1 } else { 2 })*x^2/2;",
        "dissipation 1 [N s/m]*sign(x - 1 m)*dot(x)^2/2;",
        // Equations and forces.
        "force -1 N*sign(dot(x)) on x;",
        "coordinate y: m = 0; motion m*ddot(y) = 1 N*sign(y)*floor(x/(1 m));",
        // A branch says what holds on each side.
        "output y = dot(if x > 0 { x } else { 2*x });",
        "output y = dot(if sign(x) > 0 { mod(time, 2 s) } else { 2 s });",
        "output y = ddot(if x > 0 { abs(x) } else { -x });",
    ]);
}

#[test]
fn what_bends_may_be_differentiated_once() {
    check_right(&[
        "output y = dot(abs(x)), z = dot(max(x, 1 m, 2*x)), w = dot(sqrt(x^2));",
        "potential c*max(0, x - 1 m)^2/2;",
        "dissipation 3 N*abs(dot(x));",
        "kinetic m*abs(x)*dot(x)^2/(2 m);",
        "force 1 N on abs(x);",
    ]);
}

/// Where the jump is, a factor vanishes, or the power is even.
#[test]
fn what_does_not_jump_after_all() {
    check_right(&[
        "output y = dot(x*sign(x)), z = ddot(x*abs(x)), w = ddot(max(x, 0)^2);",
        "output y = dot(sign(1 m - x)*(x - 1 m)^2);",
        "potential c*(if x > 0 { 1 } else { 2 })*x^2/2;",
        "potential c*(if x > 1 m { 1 } else { 2 })*(x - 1 m)^2/2;",
        "kinetic m*dot(abs(x))^2/2;",
        "kinetic m*max(dot(x), 0)^2/2;",
    ]);
}
