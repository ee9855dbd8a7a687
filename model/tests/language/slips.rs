//! What newcomers write out of habit, and the answer that they need.

use assur_model::lexer::lex_plain;

use super::{Expected, SPRING, check, compiled, mistakes};

#[test]
#[rustfmt::skip]
fn notation_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("motion x'' = 0;", &[("found `'`, expected `=`", "'", "`ddot(x)`")]),
        ("output y = x**2;", &[("a power is written with `^`", "*", "`x^2`")]),
        ("output y = log(x/(1 m));", &[("there is no function `log`", "log", "`ln(x)` for the natural logarithm, `log10(x)`")]),
        ("output y = e^(x/(1 m));", &[("there is no `e` here", "e", "`exp(x)`")]),
        ("output y = arctan(x/(1 m));", &[("there is no function `arctan`", "arctan", "`atan`")]),
        ("output y = sgn(x);", &[("there is no function `sgn`", "sgn", "`sign(x)`")]),
        ("output y = pow(x, 2);", &[("there is no function `pow`", "pow", "`x^2`")]),
        ("output y = der(x);", &[("there is no function `der`", "der", "`dot(x)`")]),
        ("output y = t*x;", &[("there is no `t` here", "t", "called `time`")]),
        ("output y = PI*x;", &[("there is no `PI` here", "PI", "write `pi`")]),
        ("parameter M = 5 [Nm]; output M;", &[("`Nm` is not a unit", "Nm", "write `[N m]`")]),
        ("parameter p = 5 Ns; output p;", &[("`Ns` is not a unit", "Ns", "write `[N s]`")]),
        ("parameter A = 5 [mm2]; output A;", &[("`mm2` is not a unit", "mm2", "write `[mm^2]`")]),
        ("parameter k = 1,5 kg; output k;", &[("found `5`, expected a name", "5", "with a point: `1.5`")]),
        ("dimension l = 75 mm +/- 0.05 mm; output l;", &[("a tolerance begins with `+-`", "+", "75 mm +- 0.05 mm")]),
        ("parameter k = 2 kg output k;", &[("a `;` is missing before `output`", "output", "ends with `;`")]),
        ("output y = 2m*x;", &[("`m` is a quantity of the file here, and a unit as well", "2m", "`2 m` for the unit, or `2*m`")]),
        ("let l_ = x;", &[("`l_` begins or ends with an underscore", "l_", "another name")]),
        ("let _g = x;", &[("`_g` begins or ends with an underscore", "_g", "another name")]),
        ("let self = x;", &[("`self` cannot be a name, because Rust keeps it", "self", "another name")]),
        ("output y = sin(90);", &[("`90` are radians here, 14.3 turns", "90", "`90 deg`")]),
        ("output y = cos(45*2);", &[("`45*2` are radians here", "45*2", "`90 deg`")]),
        ("let a = dir(180); output a;", &[("`180` are radians here", "180", "`180 deg`")]),
        ("force sin(50 Hz*time)*(1 N) on x;", &[("`50 Hz*time` counts periods", "50 Hz*time", "2*pi*50 Hz*time")]),
        ("parameter f = 50 Hz; driver theta = f*time; output sin(theta);", &[("`f*time` counts periods", "f*time", "2*pi*f*time")]),
        ("parameter f = 50 Hz; let w = 2*pi*f; output sin(w*time), cos(2*pi*f*time), dir(3000 rpm*time), sin(3 [rad/s]*time), sin(6);", &[]),
        ("output y = .5*x + 2*(.25 m);", &[]),
        ("let v = [x, 2*x]; output dot(v).y, z = (v + v).x;", &[]),
    ];
    for (text, expected) in cases {
        check(&format!("{SPRING}{text}"), expected);
    }
}

/// Where Rust knows no such character the place is all that can be told.
#[test]
fn characters_of_elsewhere() {
    for (text, character, hint) in [
        ("parameter A = 5 mm²;", "²", "`5 [mm^2]`"),
        ("let a = x²;", "²", "`^2`"),
        ("parameter T = 20 °C;", "°", "`293.15 K`"),
        ("parameter a = 90°;", "°", "`deg`"),
        ("dimension l = 1 m ± 1 mm;", "±", "`+-`"),
    ] {
        let error = lex_plain(text).unwrap_err();
        assert!(error.message.contains(character), "{error:?}");
        let hint_found = error.hint.unwrap_or_default();
        assert!(hint_found.contains(hint), "{text}: {hint_found}");
    }
}

/// The loops are wrong, and that is all that there is to say.
#[test]
fn a_mistake_in_a_loop_is_reported_once() {
    let text = "Sample; parameter m = 1 kg, l = 1 m; coordinate a: rad = 0; dependent b ~ 0 deg, s ~ 1 m; \
                closure loop: l*cos(a) = s; kinetic m*dot(s)^2/2; kinetic m*l^2*dot(b)^2/2; potential m*(1 [m/s^2])*s; \
                output b; scene go { run time 0 s .. 1 s; }";
    let (compiled, _) = compiled(text);
    assert_eq!(mistakes(&compiled).len(), 1, "{:#?}", compiled.diagnostics);
}

/// What holds in all modes gives way to what a mode holds, whether it is written or derived.
#[test]
fn hold_takes_the_place_of_an_equation() {
    for moves in [
        "motion m*ddot(x) = F;",
        "kinetic m*dot(x)^2/2; force F on x;",
    ] {
        check(
            &format!(
                "Sample; parameter m = 1 kg, F = 3 N; coordinate x: m = 0 m; {moves} \
                 mode go {{ when x - 1 m rises -> stay {{ set dot(x) = 0; }} }} mode stay {{ hold x; }} \
                 output x; scene s {{ run time 0 s .. 3 s; }}"
            ),
            &[],
        );
    }
}
