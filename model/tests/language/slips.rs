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
    check_all(cases);
}

#[test]
#[rustfmt::skip]
fn derivatives_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("output y = x'*2;", &[("found `'`, expected `;`", "'", "`dot(x)`, a second one `ddot(x)`")]),
        ("output y = x.dot;", &[("there is no choice `x`", "x", "a time derivative is `dot(x)`")]),
        ("output y = dx*m;", &[("there is no `dx` here", "dx", "written `dot(x)`")]),
        ("motion m*x_ddot + c*x = 0;", &[("there is no `x_ddot` here", "x_ddot", "written `ddot(x)`")]),
        ("output y = xdot;", &[("there is no `xdot` here", "xdot", "written `dot(x)`")]),
        ("output y = d(x);", &[("there is no function `d`", "d", "write `dot(x)`")]),
        ("output y = dot(x, 2);", &[("`dot` takes 1 argument", "dot(x, 2)", "a second derivative is `ddot(x)`")]),
        ("output y = diff(x);", &[("`diff` takes 2 arguments", "diff(x)", "one by the time `dot(f)`")]),
    ];
    check_all(cases);
}

#[test]
#[rustfmt::skip]
fn units_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("parameter g = 9.81 m/s^2; output g;", &[("the value of `g` is not made of numbers alone", "9.81 m/s^2", "in brackets: `9.81 [m/s^2]`")]),
        ("output y = 9.81 m/s^2*x;", &[("there is no `s` here", "s", "`s` is a unit")]),
        ("parameter w = 1500 1/min; output w;", &[("found `1`, expected `;`", "1", "`1500 [1/min]`")]),
        ("parameter J = 5 [kg m**2]; output J;", &[("found `*`, expected `]`", "*", "a power is written with `^`")]),
        ("parameter l = 5 meters; output l;", &[("`meters` is not a unit", "meters", "write `m`")]),
        ("parameter share = 10 %; output share;", &[("found `%`, expected `;`", "%", "`0.1`")]),
        ("parameter l: m = 3 m; output l;", &[("found `:`, expected `;`", ":", "its unit stands behind the number")]),
        ("output y = x in mm;", &[("found `in`, expected `;`", "in", "in brackets: `output y = x [mm];`")]),
        ("output y = 2 x;", &[("`x` is a quantity of the file, and no unit", "x", "`2*x`")]),
        ("output y = 1 000*x;", &[("found `000`, expected `;`", "000", "digits stand together")]),
        ("output y = (x/(1 m))^0,5;", &[("a number is reported here", "5", "with a point, `0.5`")]),
        ("scene s { run time 0 .. 1; }", &[("a time is expected here, and this is a pure number", "1", "a time has a unit")]),
    ];
    check_all(cases);
}

#[test]
#[rustfmt::skip]
fn expressions_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("output y = sin x;", &[("found `x`, expected `;`", "x", "in parentheses: `sin(x)`")]),
        ("output y = |x|;", &[("found `|`, expected an expression", "|", "`abs(x)`")]),
        ("output y = x > 0 ? 1 : 0;", &[("found `?`, expected `;`", "?", "`if c { x } else { y }`")]),
        ("output y = x if x > 0 else 0;", &[("found `if`, expected `;`", "if", "`if c { x } else { y }`")]),
        ("output y = if (x > 0) 1 else 0;", &[("found `1`, expected `{`", "1", "`if c { x } else { y }`")]),
        ("let b = x > 0 and x < 1 m;", &[("found `and`, expected `;`", "and", "`&&`")]),
        ("output y = π*x;", &[("there is no `π` here", "π", "write `pi`")]),
        ("output y = atan(x, x);", &[("`atan` takes 1 argument", "atan(x, x)", "`atan2(y, x)`")]),
        ("measure p = max(x); scene s { run time 0 s .. 1 s; }", &[("`max` takes 2 arguments", "max(x)", "`peak(x)`")]),
    ];
    check_all(cases);
}

#[test]
#[rustfmt::skip]
fn statements_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("equation m*ddot(x) = 0;", &[("`equation` begins no statement", "equation", "begins with `motion`")]),
        ("constraint x = 0;", &[("`constraint` begins no statement", "constraint", "begins with `closure`")]),
        ("energy m*dot(x)^2/2;", &[("`energy` begins no statement", "energy", "`kinetic` and `potential`")]),
        ("const a = 3;", &[("`const` begins no statement", "const", "a `parameter`")]),
        ("var y;", &[("`var` begins no statement", "var", "a `coordinate`")]),
        ("y := 3;", &[("`y` begins no statement", "y", "`let y = …;`")]),
        ("motion m*ddot(x) == 0;", &[("found `;`, expected `=`", ";", "two sides and one `=`")]),
        ("kinetic T = m*dot(x)^2/2;", &[("found `T`, expected an energy", "T", "no name and no `=`")]),
        ("for i = 1 to 3 { let q[i] = i; }", &[("found `=`, expected `in`", "=", "`for k in 1..5 { … }`")]),
        ("for i in 1:3 { let q[i] = i; }", &[("found `:`, expected `..`", ":", "`for k in 1..5 { … }`")]),
        ("scene s { run 0 s .. 1 s; }", &[("found `0`, expected `time`", "0", "`run time 0 s .. 1 s;`")]),
        ("scene s { run time 0 s to 1 s; }", &[("found `to`, expected `..`", "to", "`run time 0 s .. 1 s;`")]),
        ("expect at time = 1 s, x = 1 m +- 1 m;", &[("found `+`, expected `:`", "+", "a colon stands between")]),
        ("expect at time = 1 s: x == 1 m +- 1 m;", &[("found `+`, expected `=`", "+", "a fact has one `=`")]),
        ("# a comment", &[("found `#`, expected a statement", "#", "`//`")]),
    ];
    check_all(cases);
}

#[test]
#[rustfmt::skip]
fn declarations_of_elsewhere() {
    let cases: &[(&str, &[Expected])] = &[
        ("potential c*x;", &[("this has to be an energy (J)", "c*x", "of a spring it is `c*x^2/2`")]),
        ("kinetic m*x^2/2;", &[("this has to be an energy (J)", "m*x^2/2", "`m*dot(x)^2/2`")]),
        ("force 3 kg on x;", &[("a force times its position has to be an energy (J)", "force 3 kg on x;", "a force in N works on a position in m")]),
        ("dimension l = 75 mm +- 0.05; output l;", &[("the toleranced size is a length (m)", "0.05", "give it in m")]),
        ("dimension l = 75 mm in 80 mm .. 90 mm; output l;", &[("the default lies outside the permitted range", "75 mm", "make the range wider")]),
        ("parameter n = 3000 rpm; output sin(n);", &[("a pure number or an angle is expected here", "n", "`n*time`")]),
        ("choice rod { long, real }", &[("found `,`, expected `{`", ",", "each alternative has a block")]),
        ("let v = [x, x]; output v.w;", &[("there is no choice `v`", "v", "`.x`, `.y` and `.z`")]),
        ("let v = [x, x]; output abs(v);", &[("a number is expected here, and this is a vector", "v", "`norm(v)`")]),
        ("state v: m/s = 0;", &[("found `/` after a unit", "/", "in brackets: `v: [m/s]`")]),
        ("coordinate y: m = 0, speed = 2 [m/s]; motion ddot(y) = 0;", &[("found `=`, expected `:` and a unit", "=", "called `rate`")]),
        ("coordinate y, z: m = 0;", &[("found `,`, expected `:` and a unit", ",", "a unit of its own")]),
        ("point P = [x, x], Q = [0, 0]; link \"rod\" P - Q;", &[("a link begins with a point", "\"rod\"", "behind the points")]),
        ("start x = 1 m;", &[("`start` begins no statement", "start", "stand in a scene")]),
        ("measure p = peak(x) \"far\" [m]; scene s { run time 0 s .. 1 s; }", &[("found `[`, expected `;`", "[", "the unit stands before the text")]),
    ];
    check_all(cases);
}

#[track_caller]
fn check_all(cases: &[(&str, &[Expected])]) {
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
    for moves in ["motion m*ddot(x) = F;", "kinetic m*dot(x)^2/2; force F on x;"] {
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
