//! How long the compiler takes for large mechanisms: a chain of pendulums, four-bars in a row, windows with masses in a row.
//!
//! The text is derived to a program and printed as Rust, as the macro does it inside rustc. What rustc does with the
//! printed code afterwards is not in these times.

use std::time::Instant;

use assur_model::checked::{Compiled, SceneModel};
use assur_model::lexer;
use assur_model::program::Stage;

use crate::table::{Table, number};

/// Seconds that the longest chain may take.
const GOAL: f64 = 2.0;
/// Links of the chains.
const LINKS: [usize; 3] = [3, 10, 30];
/// Seconds that the most loops may take.
const LOOPS_GOAL: f64 = 0.005;
/// Numbers of loops.
const LOOPS: [usize; 3] = [4, 8, 15];
/// Seconds that the longest row of windows may take.
const ROW_GOAL: f64 = 1.0;
/// Windows of the rows.
const WINDOWS: [usize; 3] = [10, 20, 40];
/// The row of windows, of which there are 40.
const ROW: &str = include_str!("../../equations/src/four_bar_row.eqn");
/// Times that each chain is derived.
const ROUNDS: usize = 5;

/// A chain of links with their masses at their ends, by its energies.
fn chain(links: usize) -> String {
    format!(
        "assur::mechanism! {{
            Chain from \"the double pendulum, continued\";
            parameter m = 0.3 kg, l = 0.25 m, g = 9.81 [m/s^2];
            let x[0] = 0 m, y[0] = 0 m;
            for k in 1..{links} {{
                coordinate q[k]: rad = 0.1;
                let x[k] = x[k - 1] + l*sin(q[k]);
                let y[k] = y[k - 1] - l*cos(q[k]);
                kinetic m*(dot(x[k])^2 + dot(y[k])^2)/2;
                potential m*g*y[k];
            }}
            output q[1];
            scene swing {{ run time 0 s .. 1 s; }}
        }}"
    )
}

/// Four-bars in a row, the crank of each fixed to the rocker of the one before, and all their angles.
fn loops(count: usize) -> String {
    let angles = |name: &str| (1..=count).map(|k| format!("{name}[{k}]")).collect::<Vec<_>>();
    let outputs = [angles("theta"), angles("psi")].concat().join(", ");
    format!(
        "assur::mechanism! {{
            Loops from \"the four-bar, continued\";
            driver turn ~ 60 deg in 0 deg .. 360 deg;
            let psi[0] = turn;
            for k in 1..{count} {{
                dimension a[k] = 20 mm, b[k] = 70 mm, c[k] = 50 mm, x[k] = 60 mm, y[k] = 1 mm, beta[k] = 10 deg;
                dependent theta[k] ~ 30 deg, psi[k] ~ 80 deg;
                closure a[k]*dir(psi[k - 1] + beta[k]) + b[k]*dir(theta[k]) = [x[k], y[k]] + c[k]*dir(psi[k]);
            }}
            output {outputs};
            scene turning {{ sweep turn; }}
        }}"
    )
}

/// The parts of the work, shortest times in seconds, and what came out.
struct Derived {
    lexing: f64,
    compiling: f64,
    emitting: f64,
    printing: f64,
    bytes: usize,
    compiled: Compiled,
}

impl Derived {
    /// Seconds from the text to Rust.
    fn sum(&self) -> f64 {
        self.lexing + self.compiling + self.emitting + self.printing
    }

    /// The cells of a table that say how long each part took.
    fn times(&self) -> [String; 5] {
        let cells = [self.lexing, self.compiling, self.emitting, self.printing, self.sum()];
        cells.map(|seconds| format!("{seconds:.4}"))
    }

    /// The only scene.
    fn scene(&self) -> &SceneModel {
        &self.compiled.model.as_ref().expect("the text is right").scenes[0]
    }
}

/// Derives and prints a text several times.
fn derive(text: &str) -> Derived {
    let mut best: Option<Derived> = None;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let lexed = lexer::lex_file(text).expect("the text has tokens");
        let lexing = start.elapsed().as_secs_f64();

        let start = Instant::now();
        let compiled = assur_model::compile(&lexed.tokens);
        let compiling = start.elapsed().as_secs_f64();
        assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
        let model = compiled.model.as_ref().expect("the chain is right");

        let start = Instant::now();
        let origin = assur_emit::Origin {
            file: "chain.eqn".to_owned(),
            has_file: false,
            line_of: &|_| 1,
            part_of: &|_| None,
            parts: Vec::new(),
        };
        let items = assur_emit::mechanism(model, &origin);
        let emitting = start.elapsed().as_secs_f64();

        let start = Instant::now();
        let bytes = items.to_string().len();
        let printing = start.elapsed().as_secs_f64();

        let least = |found: f64, get: fn(&Derived) -> f64| {
            best.as_ref().map_or(found, |best| found.min(get(best)))
        };
        best = Some(Derived {
            lexing: least(lexing, |best| best.lexing),
            compiling: least(compiling, |best| best.compiling),
            emitting: least(emitting, |best| best.emitting),
            printing: least(printing, |best| best.printing),
            bytes,
            compiled,
        });
    }
    best.expect("there is a round")
}

/// Operations of the derivative and of the Jacobian at every evaluation.
fn operations(scene: &SceneModel) -> (usize, usize) {
    let results = &scene.program.results;
    let entries: Vec<_> = results.jacobian.iter().map(|entry| entry.2).collect();
    let count = |values| scene.program.count(values, Stage::State);
    (count(&results.derivative), count(&entries))
}

/// Measures and prints.
pub fn report() {
    const PARTS: [&str; 5] = ["tokens, s", "derive, s", "emit, s", "to text, s", "sum, s"];
    let columns = |first, last: [&'static str; 3]| [&[first], &PARTS[..], &last].concat();
    let last = ["derivative, operations", "Jacobian, operations", "text, bytes"];
    let mut table = Table::new("Chains of pendulums, text to Rust", &columns("links", last));
    let mut longest = 0.0;
    for links in LINKS {
        let derived = derive(&chain(links));
        let (derivative, jacobian) = operations(derived.scene());
        let counts = [derivative, jacobian, derived.bytes].map(|count| number(Some(count as f64)));
        table.row([&[links.to_string()], &derived.times()[..], &counts].concat());
        longest = derived.sum();
    }
    table.print();
    verdict("a chain of thirty pendulums", longest, GOAL);

    let last = ["unknowns", "coefficients", "text, bytes"];
    let mut table = Table::new("Four-bars in a row, text to Rust", &columns("loops", last));
    for count in LOOPS {
        let derived = derive(&loops(count));
        let linkage = derived.scene().linkage.as_ref().expect("it has loops");
        let coefficients = 2 * count * linkage.variables.len();
        let counts = [linkage.dependents.len(), coefficients, derived.bytes];
        let counts = counts.map(|count| number(Some(count as f64)));
        table.row([&[count.to_string()], &derived.times()[..], &counts].concat());
        longest = derived.sum();
    }
    table.print();
    verdict("fifteen loops", longest, LOOPS_GOAL);

    let last = ["coordinates", "unreduced", "text, bytes"];
    let mut table = Table::new("Windows in a row, text to Rust", &columns("windows", last));
    for count in WINDOWS {
        let derived = derive(&ROW.replace("40", &count.to_string()));
        let scene = derived.scene();
        let unreduced = scene.unreduced.as_ref().map_or(0, |scene| scene.states.len());
        let counts = [scene.states.len() / 2, unreduced / 2, derived.bytes];
        let counts = counts.map(|count| number(Some(count as f64)));
        table.row([&[count.to_string()], &derived.times()[..], &counts].concat());
        longest = derived.sum();
    }
    table.print();
    verdict("forty windows with masses", longest, ROW_GOAL);
}

fn verdict(what: &str, seconds: f64, goal: f64) {
    let word = if seconds < goal { "pass" } else { "FAIL" };
    println!("- {what}: {seconds:.3} s (goal {goal} s) {word}");
}
