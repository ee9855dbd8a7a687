//! Files that are wrong behind the spring of [`SPRING`](super::SPRING): what is said, and about which words.

use super::{Expected, SPRING, check, compiled};

/// What stands behind the spring, and the messages.
type Case<'a> = (&'a str, &'a [Expected]);

#[track_caller]
fn check_all(cases: &[Case<'_>]) {
    for (text, expected) in cases {
        check(&format!("{SPRING}{text}"), expected);
    }
}

#[test]
#[rustfmt::skip]
fn names() {
    check_all(&[
        ("output y = speeed; let speed = dot(x);", &[("there is no `speeed` here", "speeed", "did you mean `speed`?")]),
        ("output y = clearance;", &[("there is no `clearance` here", "clearance", "declare it with `parameter`")]),
        ("output y = coss(x/(1 m));", &[("there is no function `coss`", "coss", "did you mean `cos`?")]),
        ("output y = springs(x);", &[("there is no function `springs`", "springs", "let f(x) = …;")]),
        ("output y = sin;", &[("there is no `sin` here", "sin", "is a function")]),
        ("let f(a) = 2*a; output y = f;", &[("`f` is a function", "f", "`f(a)`")]),
        ("let f(a) = 2*a; output y = f(1, 2);", &[("`f` takes 1 argument, and this gives it 2", "f(1, 2)", "")]),
        ("output y = atan2(1);", &[("`atan2` takes 2 arguments, and this gives it 1", "atan2(1)", "")]),
        ("output y = x(2);", &[("`x` is not a function", "x", "a product needs `*`")]),
        ("parameter k = 1; parameter k = 2; output k;", &[("`k` is declared twice", "k", "another name")]),
        ("let x = 1;", &[("`x` is declared twice", "x", "another name")]),
        ("let sin = 1;", &[("`sin` belongs to the language", "sin", "another name")]),
        ("parameter time = 1 s;", &[("`time` belongs to the language", "time", "another name")]),
        ("effect a { } effect a { } scene s = a;", &[("there is already an effect or choice `a`", "a", "another name")]),
        ("scene s; scene s;", &[("there is already a scene `s`", "s", "another name")]),
        ("choice k { a { } a { } } scene s;", &[("there is already an alternative `a`", "a", "another name")]),
        ("for k in 1..3 { let y[k] = k*x; } output z = y;", &[("there is no `y` here", "y", "`y[1]`")]),
        ("for k in 1..3 { let y[k] = k*x; } output y[4];", &[("there is no `y[4]` here", "y", "")]),
        ("for k in 1..3 { let y[1] = k*x; } output y[1];", &[("`y[1]` is declared twice", "y", "")]),
        ("output y = crank.exact;", &[("there is no choice `crank`", "crank", "choice.alternative")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn units() {
    check_all(&[
        ("output y = x + m;", &[("this adds or subtracts a length (m) and a mass (kg)", "x + m", "factor in m/kg")]),
        ("output y = x - 3;", &[("a length (m) and a pure number", "x - 3", "a bare number has no unit")]),
        ("output y = sin(x);", &[("a pure number or an angle is expected here, and this is a length (m)", "x", "divide its unit out")]),
        ("output y = exp(time);", &[("and this is a time (s)", "time", "exp(-time/(1 s))")]),
        ("output y = atan2(x, m);", &[("the arguments are a length (m) and a mass (kg)", "x, m", "")]),
        ("output y = max(x, 2*x, m);", &[("the arguments are", "2*x, m", "")]),
        ("output y = x^m;", &[("an exponent has to be a pure number, and this is a mass (kg)", "m", "")]),
        ("output y = x^(1/7.3);", &[("a length (m) can be raised only to a fixed power", "x^(1/7.3)", "(S/(1 mm))^0.88")]),
        ("output y = if x < 1 s { 1 } else { 2 };", &[("this compares a length (m) and a time (s)", "x < 1 s", "")]),
        ("output y = if x < 1 m { 1 m } else { 2 s };", &[("the two branches give a length (m) and a time (s)", "1 m } else { 2 s", "")]),
        ("output y = [x, m];", &[("the components are a length (m) and a mass (kg)", "x, m", "")]),
        ("output y = x [kg];", &[("`y` is a length (m), which cannot be printed in kg", "[kg]", "")]),
        ("output dot(x) [mm];", &[("`dot(x)` is a velocity (m/s), which cannot be printed in mm", "[mm]", "")]),
        ("require m < c;", &[("this compares a mass (kg) and a stiffness (N/m)", "m < c", "")]),
        ("kinetic m*x^2;", &[("this has to be an energy (J)", "m*x^2", "")]),
        ("dissipation m*dot(x)^2/2;", &[("a dissipation function is a power", "m*dot(x)^2/2", "")]),
        ("force 1 [N m] on x;", &[("a force times its position has to be an energy (J)", "force 1 [N m] on x;", "")]),
        ("state i: A = 0 s; motion dot(i) = 0;", &[("the start value of a quantity in A is a time (s)", "0 s", "")]),
        ("state i: A = 0; motion dot(i) = i;", &[("the two sides of the equation are a quantity in A/s and a quantity in A", "dot(i) = i", "")]),
        ("parameter k = 1 mm +- 1 s; output k;", &[("the toleranced size is a length (m), and this is a time (s)", "1 s", "")]),
        ("parameter k = 1 mm in 0 .. 1 s; output k;", &[("the bounded value is a length (m), and this is a time (s)", "1 s", "")]),
        ("parameter k = 1 furlong; output k;", &[("`furlong` is not a unit", "furlong", "")]),
        ("parameter k = 5 rmp; output k;", &[("`rmp` is not a unit", "rmp", "did you mean `rpm`?")]),
        ("parameter k = 5 [kg inches]; output k;", &[("`inches` is not a unit", "inches", "write `inch`")]),
        ("coordinate y: metre = 0;", &[("`metre` is not a unit", "metre", "write `m`")]),
        ("preset p { m = 3 s; }", &[("`m` is a mass (kg), and this is a time (s)", "3 s", "")]),
        ("scene s { run time 0 .. x; }", &[("a time is expected here, and this is a length (m)", "x", "`run time 0 s .. 3 s;`")]),
        ("expect at maximum: x = 1 s +- 1 mm;", &[("the quantity is a length (m), and this is a time (s)", "1 s", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn a_unit_that_is_also_a_quantity() {
    check_all(&[
        ("output y = 5 N/m;", &[("`m` is a quantity of the file here, and a unit as well", "5 N/m", "`5 [N/m]` for the unit N/m, or `(5 N)/m`")]),
        ("output y = 2*5 N/m;", &[("and a unit as well", "2*5 N/m", "(5 N)/m")]),
        ("output y = -5N/m;", &[("and a unit as well", "-5N/m", "(5 N)/m")]),
        ("let f(s) = 1 m/s; output y = f(2);", &[("and a unit as well", "1 m/s", "`1 [m/s]`")]),
        ("output y = 5 m/s;", &[("there is no quantity `s` here", "s", "`5 [m/s]` for the unit m/s")]),
        ("output y = (5 N)/m + 5 [N]/m + c*x/m + 1 N/(m);", &[]),
    ]);
}

#[test]
#[rustfmt::skip]
fn values() {
    check_all(&[
        ("parameter k; output k;", &[("`k` has no value", "k", "= 75 mm")]),
        ("parameter k = 2*m; output k;", &[("the value of `k` is not made of numbers alone", "2*m", "let k = …;")]),
        ("parameter k = sqrt(-1); output k;", &[("the value of this is NaN", "sqrt(-1)", "")]),
        ("parameter k = 5 in 6 .. 7; output k;", &[("the default lies outside the permitted range", "5", "")]),
        ("parameter k = 5 in 7 .. 3; output k;", &[("the range is empty", "7 .. 3", "")]),
        ("parameter k = 5 +- -1; output k;", &[("a tolerance cannot be negative", "-1", "")]),
        ("output y = x/0;", &[("this divides by zero", "0", "")]),
        ("preset p { k = 3 s; }", &[("there is no dimension or parameter `k`", "k", "")]),
        ("preset p { mm = 3 kg; }", &[("there is no dimension or parameter `mm`", "mm", "did you mean `m`?")]),
        ("require x < 1 m;", &[("a condition on moving quantities is not available", "x < 1 m", "dimensions and parameters")]),
        ("require m;", &[("a condition is expected here, and this is a mass (kg)", "m", "a < b")]),
        ("driver t = x/(1 m);", &[("a driver is prescribed", "x/(1 m)", "is a `let`")]),
        ("driver t = 2*s; driver s = time;", &[("a driver is prescribed", "2*s", "is a `let`")]),
        ("driver t = time; driver s = t;", &[("a driver is prescribed", "t", "is a `let`")]),
        ("driver t = t + time;", &[("a driver is prescribed", "t + time", "is a `let`")]),
        ("driver t = dot(2*time)*time; output t;", &[]),
        ("driver t;", &[("the motion of the driver `t` is not stated", "t", "driver t = n*time;")]),
        ("mark \"a\" at x = 1 m; scene s;", &[("`x` is neither a driver nor the time", "x", "")]),
        ("output y = [x, x, x, x];", &[("a vector has two or three components, and this has 4", "[x, x, x, x]", "")]),
        ("output y = [x, x]*[x, x];", &[("`*` cannot multiply", "[x, x]*[x, x]", "`inner(u, v)`")]),
        ("output y = norm(x);", &[("a vector is expected here", "x", "[x, y]")]),
        ("output y = if x { 1 } else { 2 };", &[("`if` needs a condition, and this is a length (m)", "x", "a < b")]),
        ("output y = !x;", &[("`!` needs a condition", "x", "")]),
        ("output y = x < 1 m;", &[("a quantity is reported, and this is a condition", "y = x < 1 m", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn ranges_and_tolerances() {
    let empty = "the range is empty: its lower end is not below its upper end";
    let check_dimension = |text: &str, expected: Expected| {
        check(&format!("{SPRING}dimension l = 1 m {text}; output l;"), &[expected]);
    };
    check_dimension("in 2 m .. 0.5 m", (empty, "2 m .. 0.5 m", ""));
    check_dimension("in 1 m .. 1 m", (empty, "1 m .. 1 m", ""));
    check_dimension("in sqrt(-1)*(1 m) .. 2 m", ("the value of this is NaN", "sqrt(-1)*(1 m)", ""));
    check_dimension("+- -1 mm", ("a tolerance cannot be negative", "-1 mm", ""));
    check_dimension("+- sqrt(-1)*(1 m)", ("the value of this is NaN", "sqrt(-1)*(1 m)", ""));
    check_dimension("+- 1 m/0", ("this divides by zero", "0", ""));
    check_dimension("+- 1e999 m", ("`1e999` is too large for a number", "1e999", ""));
    check_dimension("+- 5 deg", ("the toleranced size is a length (m), and this is a pure number", "5 deg", ""));
    check_dimension("+- 0.1*dot(x)*(1 s)", ("a fixed value is expected here, made of numbers alone", "0.1*dot(x)*(1 s)", "is a `let`"));
    check_dimension("+- 0.1*m", ("a fixed value is expected here, made of numbers alone", "0.1*m", "is a `let`"));
    check_dimension("+- 0.6 m in 0.5 m .. 2 m", ("sizes within this tolerance leave the permitted range", "0.6 m", ""));
    let outside = "Crank; driver phi ~ 95 deg in 0 deg .. 90 deg; dependent psi ~ 0; closure psi = 2*phi; output psi;";
    check(outside, &[("`phi` starts outside its range", "95 deg", "what stands after `~`")]);
    let check_driver = |text: &str, expected: Expected| {
        let crank = format!("Crank; driver phi in {text}; dependent psi ~ 0; closure psi = 2*phi; output psi;");
        check(&crank, &[expected]);
    };
    check_driver("90 deg .. 0 deg", (empty, "90 deg .. 0 deg", "a `sweep` may run backwards"));
    check_driver("90 deg .. 90 deg", (empty, "90 deg .. 90 deg", ""));
    check_driver("0 deg .. 90 mm", ("`phi` is a pure number, and this is a length (m)", "90 mm", ""));
    check_driver("0 deg .. 90 deg +- -1 deg", ("a tolerance cannot be negative", "-1 deg", ""));
    check_driver("0 deg .. 90 deg +- sqrt(-1)", ("the value of this is NaN", "sqrt(-1)", ""));
    check_driver("0 deg .. 90 deg +- 1 mm", ("the toleranced size is a pure number, and this is a length (m)", "1 mm", ""));
    check_driver("0 deg .. 90 deg +- 0.1*phi", ("a fixed value is expected here, made of numbers alone", "0.1*phi", "is a `let`"));
}

#[test]
#[rustfmt::skip]
fn definitions_in_a_circle() {
    check_all(&[
        ("let a = b; let b = 2*e; let e = a + x; output a;", &[("`a` is defined by itself: a -> b -> e -> a", "a", "")]),
        ("let a = a; output a;", &[("`a` is defined by itself: a -> a", "a", "")]),
        ("let f(y) = f(y - x); output z = f(x);", &[("`f` calls itself: f -> f", "f(y - x)", "`for` or `sum`")]),
        ("let f(y) = g(y + x); let g(y) = 2*f(y - x); output z = f(x);", &[("`f` calls itself: f -> g -> f", "f(y - x)", "`for` or `sum`")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn derivatives() {
    check_all(&[
        ("output y = dot(ddot(x));", &[("a derivative of an acceleration", "dot(ddot(x))", "at most the second derivative")]),
        ("output y = diff(x^2, 2*x);", &[("`diff` needs something given as its variable", "2*x", "a coordinate, a driver")]),
        ("output y = diff(x);", &[("`diff` takes 2 arguments, and this gives it 1", "diff(x)", "")]),
        ("motion ddot(x)^2 = 1 [m^2/s^4];", &[("this is not linear in `ddot(x)`", "motion ddot(x)^2 = 1 [m^2/s^4];", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn balance() {
    check_all(&[
        ("motion extra: m*ddot(x) = -c*x;", &[(
            "2 equations (`extra`, `Lagrange's equation of x`) would have to determine 1 unknown (`ddot(x)`)",
            "kinetic m*dot(x)^2/2;",
            "take an equation away",
        )]),
        ("motion extra: c*x = 0;", &[("1 equation (`extra`) would have to determine 0 unknowns", "motion extra: c*x = 0;", "take an equation away")]),
        ("coordinate y: m = 0;", &[("nothing determines `ddot(y)`", "y", "add a `motion` equation")]),
        ("coordinate y: m = 0; potential c*y^2/2;", &[
            ("1 equation (`Lagrange's equation of y`) would have to determine 0 unknowns", "kinetic m*dot(x)^2/2;", ""),
            ("nothing determines `ddot(y)`", "y", "a coordinate without mass is a `state`"),
        ]),
        ("state a: 1 = 0, b: 1 = 0; motion total: dot(a) + dot(b) = 1 [1/s];", &[(
            "2 unknowns (`dot(a)`, `dot(b)`) have to be determined by 1 equation (`total`)",
            "a",
            "add a `motion` equation",
        )]),
    ]);
}

#[test]
#[rustfmt::skip]
fn masses() {
    let lagrange = |mass: &str| format!("parameter k = {mass}; coordinate y: m = 0; kinetic k*dot(y)^2/2; potential c*y^2/2; output y;");
    let written = |mass: &str| format!("parameter k = {mass}; coordinate y: m = 0; motion -c*y = k*ddot(y); output y;");
    check_all(&[
        (&lagrange("0 kg"), &[("`ddot(y)` is multiplied by zero", "y", "give `k` a value above zero")]),
        (&lagrange("-1 kg"), &[("the mass that `y` moves is negative", "y", "give `k` a value above zero")]),
        (&written("0 kg"), &[("`ddot(y)` is multiplied by zero", "motion -c*y = k*ddot(y);", "give `k` a value above zero")]),
        (&written("-1 kg"), &[("`ddot(y)` is multiplied by a negative mass", "motion -c*y = k*ddot(y);", "give `k` a value above zero")]),
        (&written("1 kg").replace("k*ddot", "(m - 2*k)*ddot"), &[("`ddot(y)` is multiplied by zero", "motion -c*y = (m - 2*k)*ddot(y);", "is a `state`")]),
        (&written("-1 kg").replace("k*ddot", "(m + k)*ddot"), &[]),
        (&format!("{} preset p {{ k = 1 kg; }} scene s {{ preset p; }}", written("0 kg")), &[]),
    ]);
}

#[test]
#[rustfmt::skip]
fn repetitions() {
    check_all(&[
        ("for k in 1..20000 { let y[k] = k*x; }", &[("the repetition runs over 20000 values; at most 10000 are written out", "1..20000", "")]),
        ("output y = sum(k in 1..1000000, k*x);", &[("runs over 1000000 values", "1..1000000", "")]),
        ("output y = sum(k in 1..90000000*90000000*900, k*x);", &[("runs over", "1..90000000*90000000*900", "")]),
        ("for k in 1..200 { for j in 1..200 { let y[200*k + j] = x; } }", &[("come to more than 20000 statements", "for j in 1..200 { let y[200*k + j] = x; }", "")]),
        ("for k in 1..9999 { for j in 1..9999 { } }", &[("come to more than 20000 statements", "for k in 1..9999 { for j in 1..9999 { } }", "")]),
        ("output y = sum(k in 1..9999, sum(j in 1..9999, k*j));", &[("come to more than 100000 terms", "sum(j in 1..9999, k*j)", "")]),
        ("for k in 1..m { let y[k] = x; }", &[("has to be a whole number", "m", "")]),
        ("output y = sum(k in 1..2.5, x);", &[("has to be a whole number", "2.5", "the index of a `for`")]),
        ("for k in 1..3 { let y[x] = 1; }", &[("has to be a whole number", "x", "")]),
        ("for k in 1..3 { let y[k] = k*z; }", &[("there is no `z` here", "z", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn several_mistakes_are_all_reported() {
    check_all(&[
        ("let a = x + m; let b = sinn(x); let e = a + 1 s; let = 3; output a, b, e;", &[
            ("this adds or subtracts", "x + m", ""),
            ("there is no function `sinn`", "sinn", ""),
            ("found `=`, expected a name", "=", ""),
        ]),
        // Whatever uses a wrong declaration says no more.
        ("parameter k = 1 furlong; let a = 2*k; motion k*a = 0; kinetic k*dot(x)^2; output a [m], k [s];", &[
            ("`furlong` is not a unit", "furlong", ""),
        ]),
        ("coordinate y: furlong = 0; kinetic m*dot(y)^2/2; potential c*(x - y)^2/2; output y, dot(y);", &[
            ("`furlong` is not a unit", "furlong", ""),
        ]),
    ]);
}

#[test]
#[rustfmt::skip]
fn what_could_not_be_read_is_not_missed() {
    check_all(&[
        ("let a = 2*; output b = a, e = 3*a;", &[("found `;`, expected an expression", ";", "")]),
        ("let f(y) = 2*; output b = f(x);", &[("found `;`, expected an expression", ";", "")]),
        ("coordinate y = 0; kinetic m*dot(y)^2/2; output y;", &[("expected `:` and a unit", "=", "")]),
        ("coordinate y: m = 0; motion m*ddot(y); output y;", &[("found `;`, expected `=`", ";", "")]),
        ("for k in 1..3 { let y[k] = ; } output z = y[2];", &[("found `;`, expected an expression", ";", "")]),
        ("effect e f { let a = 1; } scene s = e; scene t;", &[("found `f`, expected `{`", "f", "")]),
        ("choice e f { } if e.a { } output y = if e.b { 1 } else { 2 }; scene s = e.a; scene t;", &[("found `f`, expected `{`", "f", "")]),
        ("scene s = ; expect scene s at maximum: x = 1 m +- 1 m;", &[("expected an effect or a choice", ";", "")]),
        ("parameter k 3; preset p { k = 3; } output k;", &[("found `3`, expected `;`", "3", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn warnings() {
    check_all(&[
        ("let a = 2*x;", &[("nothing uses `a`", "a", "report it with `output`")]),
        ("parameter k = 1; let f(y) = 2*y;", &[("nothing uses `k`", "k", ""), ("nothing uses `f`", "f", "")]),
        ("output x;", &[("`x` is reported twice", "x", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn files_that_are_no_mechanism() {
    for (text, expected) in [
        ("", ("found the end, expected the name of the mechanism", "", "")),
        ("%", ("found `%`, expected the name of the mechanism", "%", "")),
        ("Sample; %", ("found `%`, expected a statement", "%", "")),
        ("Sample; 'a; output y = 1;", ("found `'`, expected a statement", "'", "")),
    ] {
        check(text, &[expected]);
    }
}

/// Loops beside coordinates that move by themselves.
#[test]
#[rustfmt::skip]
fn loops_that_a_motion_cannot_carry() {
    let carried = |start: &str, loops: &str| format!(
        "Shaker; dimension r = 20 mm, l = 60 mm; parameter n = 1 [1/s], m = 1 kg, c = 1 [N/m]; driver theta = n*time {start}; \
         {loops} coordinate x: m = 0; motion m*ddot(x) = c*(s - x); output x; scene go {{ run time 0 s .. 1 s; }}");
    let crank = "dependent psi ~ 0 deg, s ~ 80 mm; closure crank: r*dir(theta) + l*dir(psi) = [s, 0 m];";
    let right = compiled(&carried("~ 0 deg", crank)).0;
    assert!(right.diagnostics.is_empty(), "{:#?}", right.diagnostics);
    check(&carried("", &crank.replace("psi ~ 0 deg, s ~ 80 mm", "psi ~ 0 deg, s: m")),
        &[("nothing says where `s` starts", "s", "write roughly where")]);
    check(&carried("", &crank.replace("r*dir(theta)", "5*r*dir(theta) + [0 m, 7*r]")),
        &[("the loop `crank.y` does not close where the motion begins", "closure crank: 5*r*dir(theta) + [0 m, 7*r] + l*dir(psi) = [s, 0 m];", "say with `~` where the drivers start")]);
    // What has no closed form is held together by its forces.
    let iterated = "dependent psi ~ 0 deg, s ~ 80 mm; closure crank: r*dir(theta)*cos(psi) + l*dir(psi) = [s, s*psi];";
    let right = compiled(&carried("", iterated)).0;
    assert!(right.diagnostics.is_empty(), "{:#?}", right.diagnostics);
}
