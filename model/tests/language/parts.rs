//! Mechanisms inside others: what they come to, and what is said about wrong ones.

use std::cell::RefCell;

use assur_model::checked::{Compiled, SceneModel};
use assur_model::diagnostic::Severity;
use assur_model::lexer::{Lexed, Unreadable, lex_plain};
use assur_model::program::Input;
use assur_model::token::{Span, Token, TokenKind};

use super::{Expected, check_messages, words};

/// The files of parts and tables: path and text.
pub(super) type Files = [(&'static str, &'static str)];

/// A crank that swings a rocker by a rod.
const FOUR_BAR: &str = "FourBar;
    /// Length of the crank.
    dimension crank = 30 mm +- 0.05 mm in 10 mm .. 40 mm;
    dimension rod = 90 mm, rocker = 60 mm, base = 80 mm;
    driver phi ~ 60 deg in 0 deg .. 360 deg;
    dependent psi ~ 20 deg, chi ~ 80 deg;
    closure loop: crank*dir(phi) + rod*dir(psi) = [base, 0] + rocker*dir(chi);
    point A = [0, 0], B = crank*dir(phi), C = B + rod*dir(psi), D = [base, 0];
    link A - B \"crank\", B - C, C - D;
    let reach(x) = x + crank;
    require crank < rod \"the crank turns round\";
    output swing = chi - 90 deg;
    mark \"start\" at phi = 0;
    scene turn { sweep phi; }
    expect at phi = 60 deg: swing = 0 +- 100 deg;";

/// A slide that a four-bar moves.
const FEED: &str = "Feed;
    driver theta in 0 deg .. 360 deg;
    part lift: FourBar from \"../four_bar.eqn\" { phi = theta + lead; crank = 20 mm +- 0.1 mm; }
    parameter lead = 10 deg;
    let rise = lift.rod*sin(lift.swing);
    output tooth = rise;
    scene go { sweep theta; }";

/// Compiles a file with parts. Gives the model with the files that were read, texts and tokens.
#[track_caller]
pub(super) fn compiled<'a>(main: &'a str, files: &'a Files) -> (Compiled, Vec<(&'a str, Lexed)>) {
    let lexed = lex_plain(main).unwrap();
    let tokens = lexed.tokens.clone();
    let read = RefCell::new(vec![(main, lexed)]);
    let compiled = assur_model::compile_with(&tokens, &mut |wanted| {
        let Some((_, text)) = files.iter().find(|(path, _)| *path == wanted.path) else {
            return Err(Unreadable {
                range: 0..0,
                message: format!("there is no file `{}` beside this one", wanted.path),
                hint: None,
            });
        };
        let lexed = match wanted.is_sheet {
            true => Lexed {
                tokens: vec![Token { kind: TokenKind::Text, text: (*text).into() }],
                ranges: std::iter::once(0..text.len()).collect(),
            },
            false => lex_plain(text)?,
        };
        if !lexed.tokens.is_empty() {
            read.borrow_mut().push((text, lexed.clone()));
        }
        Ok(lexed.tokens)
    });
    let read = read.into_inner();
    assert_eq!(compiled.parts.len(), read.len() - 1);
    (compiled, read)
}

/// The words that a message points at, in whichever file.
fn words_of<'a>(read: &[(&'a str, Lexed)], span: Span) -> &'a str {
    let mut first = 0;
    for (text, lexed) in read {
        let next = first + lexed.tokens.len() as u32;
        if span.first < next {
            let span = Span { first: span.first - first, last: span.last - first };
            return words(text, lexed, span);
        }
        first = next;
    }
    ""
}

#[track_caller]
pub(super) fn check(main: &str, files: &Files, expected: &[Expected]) {
    let (compiled, read) = compiled(main, files);
    check_messages(main, &compiled, expected, |span| words_of(&read, span));
}

#[track_caller]
pub(super) fn scene(main: &str, files: &Files) -> SceneModel {
    let (compiled, _) = compiled(main, files);
    assert!(compiled.diagnostics.is_empty(), "{main}: {:#?}", compiled.diagnostics);
    compiled.model.unwrap().scenes.remove(0)
}

fn names<'a>(list: impl IntoIterator<Item = &'a String>) -> Vec<&'a str> {
    list.into_iter().map(String::as_str).collect()
}

#[test]
fn a_part_of_a_part_is_flattened() {
    let main = "Machine; parameter n = 60 rpm; driver phi ~ 0 in 0 .. 1;
        part feed: Feed from \"parts/feed.eqn\" { theta = phi; lift.rocker = 61 mm; }
        output feed.tooth [mm], feed.lift.swing, feed.lift.C.x [mm], speed = diff(feed.tooth, phi) [mm], n, span = feed.lift.reach(1 mm);
        point O = [0, 0]; link O - feed.lift.A;
        scene go { sweep phi; }
        expect at phi = 0.5: feed.tooth = 0 +- 1 m;";
    let scene = scene(main, &[("four_bar.eqn", FOUR_BAR), ("parts/feed.eqn", FEED)]);
    let linkage = scene.linkage.as_ref().unwrap();
    let constants = names(scene.constants.iter().map(|one| &one.quantity.name));
    assert_eq!(
        constants,
        [
            "n",
            "feed.lift.crank",
            "feed.lift.rod",
            "feed.lift.rocker",
            "feed.lift.base",
            "feed.lead"
        ]
    );
    let [_, crank, _, rocker, ..] = scene.constants.as_slice() else { panic!() };
    let close = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-15, "{found}");
    close(crank.default, 0.02);
    close(crank.tolerance, 1e-4);
    close(crank.range.1, 0.04);
    assert_eq!(crank.quantity.summary, "Length of the crank.");
    assert_eq!(crank.quantity.unit, "mm");
    close(rocker.default, 0.061);
    assert_eq!(names(scene.drivers.iter().map(|one| &one.name)), ["phi"]);
    let dependents = linkage.dependents.iter().map(|one| &one.quantity.name);
    assert_eq!(names(dependents), ["feed.lift.psi", "feed.lift.chi"]);
    let outputs = names(scene.outputs.iter().map(|one| &one.name));
    let expected = ["feed.tooth", "feed.lift.swing", "feed.lift.C.x", "speed", "n", "span"];
    assert_eq!(outputs, expected);
    assert_eq!(names(linkage.loops.iter().map(|one| &one.name))[0], "feed.lift.loop.x");
    assert_eq!(scene.requirements[0].text, "feed.lift.crank < feed.lift.rod");
    assert_eq!(scene.equations.len(), 1);
    assert!(scene.marks.is_empty());
    assert_eq!(scene.expectations.len(), 1);
    assert!(names(&scene.points).contains(&"feed.lift.C"));
    assert_eq!(scene.links.len(), 4);
    let inputs = |input| scene.program.operations.iter().any(|one| one.kind == input);
    assert!(inputs(assur_model::program::OperationKind::Input(Input::Driver(0))));
}

/// What a part comes to is what the same statements come to when they are written out.
#[test]
fn a_part_is_what_it_says_written_out() {
    let part = scene(
        "Machine; driver theta ~ 60 deg in 0 deg .. 360 deg;
        part bar: FourBar from \"four_bar.eqn\" { phi = 2*theta; psi ~ 25 deg; }
        output swing = bar.swing, diff(bar.swing, bar.rod); scene go { sweep theta; }",
        &[("four_bar.eqn", FOUR_BAR)],
    );
    let whole = scene(
        "Machine; driver theta ~ 60 deg in 0 deg .. 360 deg;
        dimension crank = 30 mm +- 0.05 mm in 10 mm .. 40 mm, rod = 90 mm, rocker = 60 mm, base = 80 mm;
        let phi = 2*theta; dependent psi ~ 25 deg, chi ~ 80 deg;
        closure loop: crank*dir(phi) + rod*dir(psi) = [base, 0] + rocker*dir(chi);
        point A = [0, 0], B = crank*dir(phi), C = B + rod*dir(psi), D = [base, 0];
        link A - B \"crank\", B - C, C - D;
        require crank < rod \"the crank turns round\";
        output swing = chi - 90 deg, diff(swing, rod); scene go { sweep theta; }",
        &[],
    );
    let kinds = |scene: &SceneModel| {
        let operations = scene.program.operations.iter();
        operations.map(|one| one.kind.clone()).collect::<Vec<_>>()
    };
    assert_eq!(kinds(&part), kinds(&whole));
    assert_eq!(part.links.len(), whole.links.len());
    assert_eq!(part.program.results.start, whole.program.results.start);
}

/// A part may ask for the force of its closure, for energies, and for what moves its driver; a function of the file around
/// does not take their place.
#[test]
fn a_part_asks_for_forces_and_energies() {
    let crank = "parameter r = 40 mm, l = 140 mm, m = 0.5 kg, n = 50 [rad/s];
        driver phi = n*time ~ 90 deg in 0 deg .. 360 deg; dependent psi ~ -15 deg, x ~ 135 mm;
        closure pin: r*dir(phi) + l*dir(psi) = [x, 0]; kinetic m*dot(x)^2/2;
        let side = reaction(pin).y; let moving = energy(kinetic); let M = effort(phi);";
    let written =
        format!("Whole; {crank} output side, moving, M, twice = 2*1; scene go {{ sweep phi; }}");
    let file = format!("Crank; {crank}").leak();
    let part = scene(
        "Machine; part crank: Crank from \"crank.eqn\" { } let effort(a) = 2*a;
        output crank.side, crank.moving, crank.M, twice = effort(1); scene go { sweep crank.phi; }",
        &[("crank.eqn", file)],
    );
    let whole = scene(&written, &[]);
    let kinds = |scene: &SceneModel| {
        let operations = scene.program.operations.iter();
        operations.map(|one| one.kind.clone()).collect::<Vec<_>>()
    };
    assert_eq!(kinds(&part), kinds(&whole));
    assert_eq!(part.program.results.outputs.len(), 4);
    check(
        "Machine; part crank: Crank from \"crank.eqn\" { } output other = energy(crank.kinetic);",
        &[("crank.eqn", file)],
        &[(
            "there is no energy `crank.kinetic`",
            "crank.kinetic",
            "it is `energy(kinetic)`, `energy(potential)`, or the lost power `energy(dissipation)`",
        )],
    );
}

/// A motor with an effect and a choice, which moves by itself.
const MOTOR: &str = "Motor;
    parameter J = 0.1 [kg m^2], k = 2 [N m], load = 0 [N m];
    coordinate phi: rad = 0;
    kinetic J*dot(phi)^2/2;
    choice characteristic { constant { let M = k; } falling { let M = k*(1 - dot(phi)/(10 [rad/s])); } }
    effect friction \"the bearings rub\" { parameter c = 0.1 [N m s]; let R = c*dot(phi); } else { let R = 0 [N m]; }
    force M - R - load on phi;
    output power = M*dot(phi), stalled = if characteristic.falling && !friction { 1 } else { 0 };
    scene alone { run time 0 s .. 1 s; }";

#[test]
fn scenes_select_effects_and_choices_of_parts() {
    let main = "Machine; parameter r = 10 mm, m = 2 kg, g = 9.81 [m/s^2];
        part left: Motor from \"motor.eqn\" { J = 0.2 [kg m^2]; load = m*g*r; phi ~ 1 deg; }
        part right: Motor from \"motor.eqn\" { }
        let both = if left.friction && right.characteristic.falling { 2 } else { 1 };
        if right.friction { let z = 2; } else { let z = 3; }
        output left.power, total = left.power + right.power, both, z, right.stalled;
        preset heavy { m = 3 kg; left.J = 0.3 [kg m^2]; }
        scene plain { run time 0 s .. 1 s; preset heavy; start right.phi = 2 deg; }
        scene full = left.friction + right.characteristic.falling;";
    let (compiled, _) = compiled(main, &[("motor.eqn", MOTOR)]);
    assert!(compiled.diagnostics.is_empty(), "{:#?}", compiled.diagnostics);
    let [plain, full] = compiled.model.unwrap().scenes.try_into().unwrap();
    assert_eq!(
        names(plain.constants.iter().map(|one| &one.quantity.name)),
        ["r", "m", "g", "left.J", "left.k", "right.J", "right.k", "right.load"]
    );
    assert_eq!(plain.constants[3].default, 0.3);
    assert_eq!(full.constants[3].default, 0.2);
    assert_eq!(full.effects, ["left.friction"]);
    let states = names(plain.states.iter().map(|one| &one.name));
    assert_eq!(states[..2], ["left.phi", "right.phi"]);
    let parameters: Vec<f64> = full.constants.iter().map(|one| one.default).collect();
    let values = full.program.evaluate(&parameters, 0.0, &[0.0, 0.0, 4.0, 5.0]);
    let outputs = full.program.results.outputs.iter().map(|one| values.get(*one));
    assert_eq!(outputs.collect::<Vec<_>>(), [8.0, 13.0, 2.0, 3.0, 1.0]);
    let start = full.program.results.start.iter().map(|one| values.get(*one));
    assert_eq!(start.collect::<Vec<_>>(), [1_f64.to_radians(), 0.0, 0.0, 0.0]);
}

/// A driver that is not bound stays one, and names of the language stay too.
#[test]
fn what_is_not_bound_stays() {
    let scene = scene(
        "Machine; parameter n = 3;
        part a: Shaft { n = 2; } part b: Shaft { r = 2*n*(1 mm); }
        output total = a.y + b.y;",
        &[(
            "shaft.eqn",
            "Shaft; parameter n = 1; dimension r = 5 mm; driver phi = 2*pi*n*time/(1 s);
            let y = sum(n in 1..3, n*r)*sin(phi), f(r) = 2*r;",
        )],
    );
    assert_eq!(names(scene.drivers.iter().map(|one| &one.name)), ["a.phi", "b.phi"]);
    assert_eq!(
        names(scene.constants.iter().map(|one| &one.quantity.name)),
        ["n", "a.n", "a.r", "b.n"]
    );
    let parameters: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let values = scene.program.evaluate(&parameters, 0.125, &[]);
    let sum = values.get(scene.program.results.outputs[0]);
    let expected = 0.03 + 0.036 * 0.5_f64.sqrt();
    assert!((sum - expected).abs() < 1e-12, "{sum}");
}

/// What stands behind a crank that is given to a four-bar, and the messages.
#[track_caller]
pub(super) fn check_all(cases: &[(&str, &[Expected])]) {
    let files = [
        ("four_bar.eqn", FOUR_BAR),
        ("a.eqn", "A; part next: B from \"b.eqn\";"),
        ("b.eqn", "B; part next: A from \"./a.eqn\";"),
        ("own.eqn", "Own; part own: Own from \"own.eqn\";"),
        ("missing.eqn", "Missing; part core: Lost from \"lost.eqn\"; output core.x;"),
        (
            "units.eqn",
            "Units; parameter a = 1 s; dimension b = 1 m; let wrong = a + b; output good = a;",
        ),
        ("blind.eqn", "Blind; parameter gain = 1; let y = gian*theta; let z = mass;"),
        (
            "broken.eqn",
            "Broken; parameter a = ; driver phi in 0 .. 1; let b = a*phi; output c = b + ;",
        ),
        ("sine.eqn", "Sine; let sin = 1;"),
        ("per.eqn", "Per; parameter m = 2 kg; let p = 5 N/m;"),
        ("list.eqn", "List; for k in 1..2 { dimension l[k] = 1 mm; }"),
        ("empty.eqn", ""),
        ("nothing.eqn", "%"),
        ("plain.eqn", "Plain; parameter gain = 2;"),
    ];
    for (text, expected) in cases {
        check(
            &format!(
                "Machine; driver theta in 0 deg .. 360 deg; dimension l = 80 mm; dependent z ~ 0; closure z = 2*theta; output z, l; {text}"
            ),
            &files,
            expected,
        );
    }
}

#[test]
#[rustfmt::skip]
fn bindings() {
    check_all(&[
        ("part bar: FourBar { phi = theta; crnk = 3 mm; }", &[("the part `bar` has no `crnk`", "crnk", "did you mean `crank`?")]),
        ("part bar: FourBar { phi = theta; gear = 3 mm; }", &[("the part `bar` has no `gear`", "gear", "`FourBar` declares crank, rod, rocker, base, phi, psi, chi")]),
        ("part bar: FourBar { phi = theta; crank = 3 s; }", &[("`bar.crank` is a length (m), and this is a time (s)", "3 s", "")]),
        ("part bar: FourBar { phi = theta; crank = theta; }", &[("`bar.crank` is a length (m), and this is a pure number", "theta", "")]),
        ("part bar: FourBar { phi = l; }", &[("`bar.phi` is a pure number, and this is a length (m)", "l", "")]),
        ("part bar: FourBar { phi = theta; psi ~ 1 mm; }", &[("`bar.psi` is a pure number, and this is a length (m)", "1 mm", "")]),
        ("part bar: FourBar { phi ~ 1 mm; }", &[("`bar.phi` is a pure number, and this is a length (m)", "1 mm", "")]),
        ("part bar: FourBar { phi = theta; crank = 30 mm +- 1 s; }", &[("the toleranced size is a length (m), and this is a time (s)", "1 s", "")]),
        ("part bar: FourBar { phi = theta; crank = 50 mm; }", &[("the default lies outside the permitted range", "50 mm", "")]),
        ("part bar: FourBar { phi = theta; crank = l/3 +- 1 mm; }", &[("`bar.crank` follows from other quantities, so it has no tolerance", "1 mm", "leave them out")]),
        ("part bar: FourBar { phi = theta in 0 .. 1; }", &[("`bar.phi` is driven from outside, so it has no tolerance", "0", "leave them out")]),
        ("part bar: FourBar { phi = theta; crank ~ 30 mm; }", &[("`bar.crank` is a constant, and `~` states where something starts", "30 mm", "`crank = …;`")]),
        ("part bar: FourBar { phi = theta; psi = 3; }", &[("`bar.psi` cannot be given: closures determine it", "3", "`psi ~ …;`")]),
        ("part bar: FourBar { phi = theta; swing = 3; }", &[("`bar.swing` follows from other quantities of `FourBar`", "swing", "its drivers, dimensions, parameters and start values")]),
        ("part bar: FourBar { phi = theta; rod; }", &[("nothing is said of `bar.rod`", "rod", "`rod = …;`")]),
        ("part bar: FourBar { phi = theta; rod = 90 mm; rod = 91 mm; }", &[("`bar.rod` is bound twice", "rod", "")]),
        ("part bar: FourBar { phi = theta; rod = rodd; }", &[("there is no `rodd` here", "rodd", "")]),
        ("part bar: FourBar { phi = theta; rod = bar.rod + 1 mm; }", &[("`bar.rod` is defined by itself: bar.rod -> bar.rod", "bar.rod", "")]),
        ("part list: List from \"list.eqn\" { l = 3 mm; }", &[("a quantity with an index cannot be bound", "l", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn names_of_parts() {
    check_all(&[
        ("part bar: FourBar { phi = theta; } output y = bar.swign;", &[("there is no `bar.swign` here", "bar.swign", "did you mean `bar.swing`?")]),
        ("part bar: FourBar { phi = theta; } output y = bar.gear;", &[("there is no `bar.gear` here", "bar.gear", "the names that its file declares")]),
        ("part bar: FourBar { phi = theta; } output y = bra.swing;", &[("there is no choice `bra`", "bra", "did you mean `bar`?")]),
        ("part bar: FourBar { phi = theta; } output y = bar;", &[("`bar` is a part, a `FourBar`", "bar", "`bar.…`")]),
        ("part bar: FourBar { phi = theta; } output y = bar.reach(1 s);", &[("this adds or subtracts a time (s) and a length (m)", "x + crank", "")]),
        ("part bar: FourBar { phi = theta; } output y = bar.raech(1 m);", &[("there is no function `bar.raech`", "bar.raech", "did you mean `bar.reach`?")]),
        ("part bar: FourBar { phi = theta; } link bar.A - bar.E;", &[("there is no point `bar.E`", "bar.E", "")]),
        ("part bar: FourBar; scene s { sweep bar.ph; }", &[("there is no driver `bar.ph`", "bar.ph", "did you mean `bar.phi`?")]),
        ("part bar: FourBar; scene s { hold bar.ph; }", &[("there is no driver `bar.ph`", "bar.ph", "did you mean `bar.phi`?")]),
        ("part bar: FourBar; scene s { hold bar.phi; sweep bar.phi; }", &[("`bar.phi` is held and swept", "bar.phi", "leave one of the two out")]),
        ("part bar: FourBar { phi = theta; } preset p { bar.crnk = 3 mm; }", &[("there is no dimension or parameter `bar.crnk`", "bar.crnk", "did you mean `bar.crank`?")]),
        ("part plain: Plain { } scene s = plain.friction;", &[("the scene `s` selects an unknown effect `plain.friction`", "plain.friction", "")]),
        ("part plain: Plain { } output plain.gain = 3;", &[("a name is expected before `=`", "plain.gain", "")]),
        ("part plain: Plain { } part plain: Plain { }", &[("there is already a part `plain`", "plain", "another name")]),
        ("part plain: Plain { } let plain = 2;", &[("`plain` is declared twice", "plain", "")]),
        ("for k in 1..2 { part plain: Plain { } }", &[("a part in a repetition is not available", "plain", "a `part` statement for each")]),
        ("part bar: FourBar { phi = theta; } output y = bar.crank.x;", &[("a vector is expected here, and this is a length (m)", "bar.crank", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn files_of_parts() {
    check_all(&[
        ("part lost: Lost from \"lost.eqn\"; output lost.x; link lost.A - lost.B; scene s = lost.e { sweep lost.phi; }", &[("there is no file `lost.eqn` beside this one", "\"lost.eqn\"", "")]),
        ("part lost: TheLost { x = 3; } output lost.x[3], y = lost.f(3);", &[("there is no file `the_lost.eqn`", "TheLost", "")]),
        ("part m: Missing { }", &[("there is no file `lost.eqn`", "\"lost.eqn\"", "")]),
        ("part a: A { }", &[("the parts stand in a circle: a.eqn -> b.eqn -> a.eqn", "\"./a.eqn\"", "cannot be a part of itself")]),
        ("part a: Own { }", &[("the parts stand in a circle: own.eqn -> own.eqn", "\"own.eqn\"", "")]),
        ("part plain: Plane from \"plain.eqn\";", &[("`plain.eqn` holds the mechanism `Plain`, not `Plane`", "Plane", "write `part plain: Plain from …`")]),
        ("part e: Empty { } output e.x;", &[("`empty.eqn` holds no mechanism", "Empty", "")]),
        ("part e: Nothing { } output e.x;", &[("found `%`, expected the name of the mechanism", "%", "")]),
    ]);
}

#[test]
#[rustfmt::skip]
fn mistakes_in_files_of_parts() {
    check_all(&[
        ("part u: Units { }", &[("this adds or subtracts a time (s) and a length (m)", "a + b", "")]),
        ("part u: Units { } part v: Units { }", &[("this adds or subtracts a time (s) and a length (m)", "a + b", "")]),
        // What the file around declares is not seen by the part.
        ("parameter mass = 1 kg; output mass; part blind: Blind { }", &[
            ("there is no `blind.gian` here", "gian", "did you mean `blind.gain`?"),
            ("there is no `blind.theta` here", "theta", "what comes from outside is bound"),
            ("there is no `blind.mass` here", "mass", "what comes from outside is bound"),
        ]),
        ("part broken: Broken { a = 3; d = 4; } output broken.b, y = broken.a, broken.c;", &[
            ("the part `broken` has no `d`", "d", ""),
            ("found `;`, expected an expression", ";", ""),
            ("found `;`, expected an expression", ";", ""),
        ]),
        ("part sine: Sine { }", &[("`sine.sin` belongs to the language", "sin", "")]),
        ("part per: Per { }", &[("`m` is a quantity of the file here, and a unit as well", "5 N/m", "")]),
    ]);
}

#[test]
fn parts_are_limited() {
    let files: Vec<(&str, &str)> = (0..20)
        .map(|index| {
            let next = index + 1;
            let text = format!("P{index}; part a: P{next} {{ }} part b: P{next} {{ }}");
            let path = format!("p{index}.eqn");
            (&*path.leak(), &*text.leak())
        })
        .collect();
    let deep = ("parts stand in each other more than 16 deep", "P16", "");
    let many = ("the parts up to here come to more than 20000 statements", "first: P0", "");
    check("Machine; part first: P0 { }", &files, &[many, deep, deep]);
}

#[test]
fn files_of_parts_that_are_cut_off_are_endured() {
    let main = lex_plain(
        "Machine; driver phi ~ 0 in 0 .. 1; part feed: Feed from \"feed.eqn\" { theta = phi; lift.rod = 91 mm; }
        output feed.tooth, feed.lift.C; link feed.lift.C - feed.lift.D; scene go { sweep phi; }",
    );
    let main = main.unwrap().tokens;
    let [feed, bar] = [FEED, FOUR_BAR].map(|text| lex_plain(text).unwrap().tokens);
    let endure = |main: &[Token], feed: &[Token], bar: &[Token]| {
        let compiled = assur_model::compile_with(main, &mut |wanted| {
            Ok(match wanted.path.as_str() {
                "feed.eqn" => feed.to_vec(),
                _ => bar.to_vec(),
            })
        });
        let errors = compiled.diagnostics.iter();
        let wrong = errors.filter(|one| one.severity == Severity::Error).count();
        assert_eq!(wrong > 0, compiled.model.is_none());
        let count = (main.len() + feed.len() + bar.len()) as u32;
        for one in &compiled.diagnostics {
            assert!(one.span.first <= one.span.last && one.span.last < count, "{one:?}");
        }
    };
    for length in 1..main.len() {
        endure(&main[..length], &feed, &bar);
    }
    for length in 0..feed.len() {
        endure(&main, &feed[..length], &bar);
        endure(&main, &[&feed[..length], &feed[length + 1..]].concat(), &bar);
    }
    for length in 0..bar.len() {
        endure(&main, &feed, &bar[..length]);
        endure(&main, &feed, &[&bar[..length], &bar[length + 1..]].concat());
    }
}
