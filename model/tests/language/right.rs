//! Files that compile, with what they come to.

use assur_model::checked::{Distribution, ExpectPlace, SceneModel, SpanKind, Subject};
use assur_model::program::Values;

use super::{SPRING, check, compiled, first_scene};

/// The scenes of a file without mistakes.
#[track_caller]
fn scenes(text: &str) -> Vec<SceneModel> {
    let (compiled, _) = compiled(text);
    assert!(compiled.diagnostics.is_empty(), "{text}: {:#?}", compiled.diagnostics);
    compiled.model.unwrap().scenes
}

/// The values of the program of a scene at its defaults.
fn values(scene: &SceneModel, time: f64, state: &[f64]) -> Values {
    let parameters: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    scene.program.evaluate(&parameters, time, state)
}

/// The last output of the first scene of the spring and more, at x = 0.5 m, dx/dt = 2 m/s.
#[track_caller]
fn check_output(statements: &str, expected: f64) {
    let scene = &scenes(&format!("{SPRING}{statements}"))[0];
    let found = values(scene, 3.0, &[0.5, 2.0]).get(*scene.program.results.outputs.last().unwrap());
    assert!(
        (found - expected).abs() <= 1e-14 * (1.0 + expected.abs()),
        "{statements}: {found} instead of {expected}"
    );
}

#[test]
#[rustfmt::skip]
fn expressions_have_their_values() {
    for (statements, expected) in [
        ("output y = 2*x;", 1.0),
        ("output y = 75 mm + x;", 0.575),
        ("output y = -x^2;", -0.25),
        ("output y = 2^3^2;", 512.0),
        ("output y = 2^-1;", 0.5),
        ("output y = 12/3/2;", 2.0),
        ("output y = 7 - 2 - 1;", 4.0),
        ("output y = ddot(x);", -2.0),
        ("output y = dot(x^2);", 2.0),
        ("output y = dot(time^2);", 6.0),
        ("output y = dot(abs(-x));", 2.0),
        ("output y = dot(max(x, 3 m) + min(-x, 1 m));", -2.0),
        ("output y = dot(if x < 1 m { x^2 } else { x*(1 m) });", 2.0),
        ("output y = dot(-x*sign(-x));", 2.0),
        ("output y = ddot(x*abs(x));", 6.0),
        ("output y = dot(sin(x/(1 m)));", 2.0 * 0.5_f64.cos()),
        ("output y = diff(x^3, x);", 0.75),
        ("let f(a) = a^2*x; output y = diff(f(x), x);", 0.75),
        ("let f(a) = diff(a^3, a); output y = f(x);", 0.75),
        ("let f(a, b) = a - 2*b; output y = f(x, m*(1 [m/kg]));", -3.5),
        ("output y = sum(k in 1..4, k*x);", 5.0),
        ("output y = sum(k in 3..2, k*x) + x;", 0.5),
        ("for k in 0..3 { let z[k] = x^k/(1 [m])^k; } output y = z[0] + z[2] + z[3];", 1.375),
        ("output y = sum(i in 1..3, sum(j in 1..i, j));", 10.0),
        ("output y = if x < 1 m && time > 1 s { 3 } else { 4 };", 3.0),
        ("output y = if x >= 1 m || x == 0 { 3 } else if x != 2 m { 5 } else { 4 };", 5.0),
        ("output y = max(x, 3 m, 1 m) - min(x, 1 m);", 2.5),
        ("output y = abs(-x) + hypot(3*x, 4*x);", 3.0),
        ("output y = sign(-x);", -1.0),
        ("output y = mod(3.5*x, 1 m);", 0.75),
        ("output y = floor(-2.5);", -3.0),
        ("output y = atan2(x, x);", std::f64::consts::FRAC_PI_4),
        ("output y = inner([x, 2*x], [x, x]);", 0.75),
        ("output y = cross([x, 2*x], [x, x]);", -0.25),
        ("output y = norm([3*x, 4*x]);", 2.5),
        ("output y = inner(dir(60 deg), [1, 0]);", 0.5),
        ("output y = inner(rot(90 deg)*[x, 0 m], [0 m, x]);", 0.25),
        ("output y = inner(rotz(90 deg)*[x, 0, 0], [0, x, 0]);", 0.25),
        ("output y = inner(roty(90 deg)*[0, 0, x], [x, 0, 0]);", 0.25),
        ("output y = inner(rotx(90 deg)*[0, x, 0], [0, 0, x]);", 0.25),
        ("output y = (x/(1 mm))^0.5;", 500.0_f64.sqrt()),
        ("output y = 30 rpm/(1 [rad/s]);", std::f64::consts::PI),
        ("output y = 180 deg;", std::f64::consts::PI),
        ("output y = 0 + x;", 0.5),
        ("parameter if1 = 3; output y = if1;", 3.0),
    ] {
        check_output(statements, expected);
    }
}

#[test]
fn a_spring_swings() {
    let scene = &scenes(&format!("{SPRING}scene s \"It swings.\" {{ run time 0 s .. 1 s; }}"))[0];
    assert_eq!(scene.summary, "It swings.");
    assert_eq!((scene.span, scene.conservative, scene.program.linear), (SpanKind::Run, true, true));
    let all = values(scene, 0.0, &[0.5, 2.0]);
    let results = &scene.program.results;
    assert_eq!(all.all(&results.derivative), [2.0, -2.0]);
    assert_eq!(all.all(&results.energy), [4.0, 1.0]);
    assert_eq!(all.all(&results.mass), [2.0]);
    assert_eq!(all.all(&results.span), [0.0, 1.0]);
    assert_eq!(all.all(&results.start), [0.1, 0.0]);
}

#[test]
fn equations_may_be_written_or_derived() {
    let written = "Sample; parameter m = 2 kg, c = 8 [N/m]; coordinate x: m = 0.1 m; motion m*ddot(x) + c*x = 0; output x;";
    let pushed = "Sample; parameter m = 2 kg, c = 8 [N/m]; coordinate x: m = 0.1 m; kinetic m*dot(x)^2/2; force -c*x on x; output x;";
    for text in [written, pushed] {
        let scene = &scenes(text)[0];
        let found = values(scene, 0.0, &[0.5, 2.0]).all(&scene.program.results.derivative);
        assert_eq!(found, [2.0, -2.0], "{text}");
        assert!(!scene.conservative, "{text}");
    }
}

#[test]
fn states_of_first_order_and_coordinates_couple() {
    let text = "Sample; parameter L = 2 H, r = 4 ohm, k = 3 [N/A], m = 0.5 kg; \
        coordinate x: m = 0; state i: A = 0; \
        motion current: L*dot(i) + r*i + k*dot(x) = 1 V; motion push: m*ddot(x) = k*i; output i;";
    let scene = &scenes(text)[0];
    let found = values(scene, 0.0, &[0.0, 2.0, 3.0]).all(&scene.program.results.derivative);
    assert_eq!(found, [2.0, 18.0, -8.5]);
}

#[test]
fn a_scene_has_what_its_effects_have() {
    let text = format!(
        "{SPRING} effect friction \"It rubs.\" {{ parameter d = 0.5 [N s/m]; dissipation d*dot(x)^2/2; }} \
         choice support {{ fixed {{ let u = 0 m; }} shaken {{ let u = 1 mm*sin(time*(1 [1/s])); }} }} \
         output y = x + u; output z = if friction {{ 1 }} else {{ 2 }}; output w = if support.shaken {{ 3 }} else {{ 4 }}; \
         scene plain; scene rubbing = friction + support.shaken {{ output z, w; }}"
    );
    let scenes = scenes(&text);
    let names = |scene: &SceneModel| {
        scene.constants.iter().map(|one| one.quantity.name.clone()).collect::<Vec<_>>()
    };
    assert_eq!(names(&scenes[0]), ["m", "c"]);
    assert_eq!(names(&scenes[1]), ["m", "c", "d"]);
    assert_eq!(scenes[1].effects, ["friction"]);
    assert_eq!(scenes[1].choices, [("support".to_string(), "shaken".to_string())]);
    assert_eq!(scenes[0].outputs.len(), 4);
    let outputs: Vec<_> = scenes[1].outputs.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(outputs, ["z", "w"]);
    assert_eq!(
        values(&scenes[0], 0.0, &[0.5, 2.0]).all(&scenes[0].program.results.outputs)[2..],
        [2.0, 4.0]
    );
    assert_eq!(
        values(&scenes[1], 0.0, &[0.5, 2.0]).all(&scenes[1].program.results.outputs),
        [1.0, 3.0]
    );
    assert!(scenes[0].conservative && !scenes[1].conservative);
}

#[test]
fn presets_marks_and_facts_reach_the_scene() {
    let text = format!(
        "{SPRING} driver theta = 60 rpm*time; preset heavy \"A heavy one.\" {{ m = 20 kg; }} \
         mark \"top\" at theta = 90 deg; mark \"end\" at time = 1 s; \
         scene s {{ preset heavy; start dot(x) = 1 [m/s]; run time 0 .. 1 s; }} \
         expect at theta = 180 deg: x = 1 mm +- 0.5 mm \"figure 1\"; expect scene s preset heavy at amplitude: dot(x) = 2 [m/s] +- 1 [m/s];"
    );
    let scene = &scenes(&text)[0];
    let mass = scene.constants.iter().find(|one| one.quantity.name == "m").unwrap();
    assert_eq!((scene.preset.as_str(), mass.default), ("heavy", 20.0));
    let places: Vec<_> = scene.marks.iter().map(|mark| mark.at.clone()).collect();
    assert_eq!(
        places,
        [ExpectPlace::Driver(0, std::f64::consts::FRAC_PI_2), ExpectPlace::Time(1.0)]
    );
    let facts: Vec<_> = scene
        .expectations
        .iter()
        .map(|fact| (fact.at.clone(), fact.quantity, fact.value, fact.preset.as_str()))
        .collect();
    assert_eq!(
        facts[0],
        (ExpectPlace::Driver(0, std::f64::consts::PI), Subject::Output(0), 1e-3, "")
    );
    assert_eq!(facts[1], (ExpectPlace::Amplitude, Subject::State(1), 2.0, "heavy"));
    assert_eq!(values(scene, 0.0, &[0.0, 0.0]).all(&scene.program.results.start), [0.1, 1.0]);
}

#[test]
fn constants_have_ranges_and_tolerances() {
    let text = "Sample; dimension R = 75 mm +- 0.05 mm in 60 mm .. 90 mm; parameter n = 250 rpm; output R, n;";
    let scene = &scenes(text)[0];
    let radius = &scene.constants[0];
    assert_eq!(
        (radius.is_dimension, radius.default, radius.tolerance, radius.range),
        (true, 0.075, 5e-5, (0.06, 0.09))
    );
    assert_eq!(
        (
            radius.quantity.unit.as_str(),
            scene.outputs[0].unit.as_str(),
            scene.outputs[1].unit.as_str()
        ),
        ("mm", "mm", "rpm")
    );
}

/// `2` and `2 m` are the same number, but not the same quantity.
#[test]
fn a_function_keeps_the_units_of_its_arguments_apart() {
    let text = format!("{SPRING} let f(a) = 3*a; output p = f(2), q = f(2 m), r = f(2 [m/s]);");
    let scene = &scenes(&text)[0];
    let units: Vec<_> = scene.outputs.iter().map(|one| one.unit.as_str()).collect();
    assert_eq!(units[1..], ["", "m", "m/s"]);
}

/// Each function is applied to the same arguments once, so that this does not take for ever.
#[test]
fn functions_that_call_each_other_twice_are_quick() {
    for argument in ["x", "[x, 2*x]"] {
        let functions: String =
            (0..40).map(|k| format!("let f{k}(v) = f{}(v) + f{}(v); ", k + 1, k + 1)).collect();
        scenes(&format!("{SPRING} {functions} let f40(v) = 2*v; output y = f0({argument});"));
    }
}

/// An effect inside a repetition belongs to each of its copies.
#[test]
fn blocks_inside_a_repetition_see_the_index() {
    let text = format!(
        "{SPRING} for k in 1..3 {{ effect e {{ let z[k] = k*x; }} else {{ let z[k] = 2*k*x; }} }} output y = z[3]; scene s; scene t = e;"
    );
    let scenes = scenes(&text);
    let last =
        |scene: &SceneModel| values(scene, 0.0, &[0.5, 2.0]).get(scene.program.results.outputs[1]);
    assert_eq!((last(&scenes[0]), last(&scenes[1])), (3.0, 1.5));
}

#[test]
fn components_of_rates_are_reported_measured_and_published() {
    let scene = &scenes(
        &format!(
            "{SPRING} point P = [0 m, 2*x]; output dot(P) [mm/s], speed = dot(P).y; measure top = peak(dot(P).y); \
         scene s {{ run time 0 s .. 1 s; }} expect at time = 0 s: dot(P).y = 0 [m/s] +- 1 [mm/s]; \
         expect at maximum: dot(P).x = 0 [m/s] +- 1 [mm/s]; expect at run: top = 0.4 [m/s] +- 1 [mm/s];"
        )[..],
    )[0];
    let names: Vec<_> = scene.outputs.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["x", "dot(P).x", "dot(P).y", "speed"]);
    let facts: Vec<_> = scene.expectations.iter().map(|one| one.quantity).collect();
    let expected = [Subject::Output(2), Subject::Output(1), Subject::Measure(0)];
    assert_eq!(facts, expected);
    let found = values(scene, 0.0, &[0.5, 2.0]).all(&scene.program.results.outputs);
    assert_eq!(found, [0.5, 0.0, 4.0, 4.0]);
}

/// A scene puts a linkage together elsewhere than its file says; units stay those of the declaration.
#[test]
fn scenes_start_dependent_coordinates_elsewhere() {
    let text = "Rocker from \"made up\";
        dimension a = 25 mm +- 1 mm lognormal, b = 90 mm, c = 60 mm, d = 100 mm;
        driver phi ~ 90 deg in 0 deg .. 360 deg;
        dependent gamma ~ 21 deg, psi ~ 106 deg;
        closure loop: a*dir(phi) + b*dir(gamma) = [d, 0] + c*dir(psi);
        output psi;
        scene open { sweep phi; }
        scene crossed { sweep phi; start gamma = -0.9 rad, psi = 3.9 rad, phi = 1 rad; }";
    let scenes = scenes(text);
    let linkage = |index: usize| scenes[index].linkage.as_ref().expect("a linkage");
    let start = |index: usize| -> Vec<f64> {
        let scene = &scenes[index];
        let dependents = values(scene, 0.0, &[]).all(&scene.program.results.start);
        dependents.into_iter().chain([linkage(index).ranges[0].start]).collect()
    };
    let degrees = |angles: [f64; 3]| angles.map(f64::to_radians).to_vec();
    assert_eq!(start(0), degrees([21.0, 106.0, 90.0]));
    assert_eq!(start(1), [-0.9, 3.9, 1.0]);
    assert_eq!(linkage(1).dependents[1].quantity.unit, "deg");
    assert_eq!(scenes[0].constants[0].distribution, Distribution::Lognormal);
}

/// Start values follow from constants, and from where drivers start: of one that moves, at the begin of its task.
#[test]
fn start_values_follow_from_what_is_given() {
    let text = |phi: &str, rest: &str| {
        format!(
            "Rocker; dimension a = 25 mm, b = 90 mm, c = 60 mm, d = 100 mm; parameter mode = -1; let side = mode*90 deg;
            dependent gamma ~ phi + 2*side, psi: rad; {phi}
            closure loop: a*dir(phi) + b*dir(gamma) = [d, 0] + c*dir(psi); output psi; scene go {{ {rest} }}"
        )
    };
    let start = |phi: &str, rest: &str| {
        let scene = first_scene(&text(phi, rest));
        values(&scene, 0.0, &[]).all(&scene.program.results.start)
    };
    let swept = start("driver phi ~ 30 deg in 0 deg .. 360 deg;", "sweep phi;");
    assert!((swept[0] + 150f64.to_radians()).abs() < 1e-15 && swept[1].is_nan(), "{swept:?}");
    let moved = start("driver phi = 2 [rad/s]*time;", "run time 1 s .. 2 s;");
    assert_eq!(moved[0], 2.0 - std::f64::consts::PI);
    let swept = "driver phi in 0 deg .. 360 deg;";
    let wrong = text(swept, "sweep phi;").replace("phi + 2*side", "psi");
    check(&wrong, &[("a start value is expected here", "psi", "how the links are put together")]);
    check(&text(swept, "sweep phi; start gamma = d;"), &[("`gamma` is a pure number", "d", "")]);
}

/// A driver that a scene holds is a parameter in it, with the value, range and tolerance that it has.
#[test]
fn scenes_hold_drivers() {
    let text = "Slide from \"made up\";
        driver phi ~ 0 deg in 0 deg .. 90 deg, nu ~ 20 deg in -30 deg .. 30 deg +- 0.1 deg, chi ~ 1 deg in 0 deg .. 2 deg;
        dimension r = 2 m;
        output x = r*cos(phi + nu)*cos(chi);
        measure far = peak(x) [m];
        scene grid { sweep phi, nu, chi; }
        scene turn { sweep phi; hold nu, chi; }";
    let scenes = scenes(text);
    let names = |scene: &SceneModel| -> (Vec<String>, Vec<String>) {
        let drivers = scene.drivers.iter().map(|one| one.name.clone());
        let constants = scene.constants.iter().map(|one| one.quantity.name.clone());
        (drivers.collect(), constants.collect())
    };
    let all = |list: &[&str]| -> Vec<String> { list.iter().map(|one| one.to_string()).collect() };
    assert_eq!(names(&scenes[0]), (all(&["phi", "nu", "chi"]), all(&["r"])));
    assert_eq!(names(&scenes[1]), (all(&["phi"]), all(&["r", "nu", "chi"])));
    assert_eq!((scenes[0].measures.len(), scenes[1].measures.len()), (0, 1));
    let held = &scenes[1].constants[1];
    assert_eq!((held.default, held.quantity.unit.as_str()), (20f64.to_radians(), "deg"));
    assert_eq!(held.tolerance, 0.1f64.to_radians());
    assert_eq!(held.range, (-30f64.to_radians(), 30f64.to_radians()));
}
