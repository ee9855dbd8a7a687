//! How long the compiler takes for a large mechanism: a chain of pendulums.
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
/// Times that each chain is derived.
const ROUNDS: usize = 5;

/// A chain of links with their masses at their ends, by its energies.
fn text(links: usize) -> String {
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

/// The parts of the work, shortest times in seconds, and what came out.
struct Derived {
    lexing: f64,
    compiling: f64,
    emitting: f64,
    printing: f64,
    bytes: usize,
    compiled: Compiled,
}

/// Derives and prints a chain several times.
fn derive(links: usize) -> Derived {
    let text = text(links);
    let mut best: Option<Derived> = None;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let lexed = lexer::lex_file(&text).expect("the text has tokens");
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
    let columns = [
        "links",
        "tokens, s",
        "derive, s",
        "emit, s",
        "to text, s",
        "sum, s",
        "derivative, operations",
        "Jacobian, operations",
        "text, bytes",
    ];
    let mut table = Table::new("Chains of pendulums, text to Rust", &columns);
    let mut longest = 0.0;
    for links in LINKS {
        let derived = derive(links);
        let model = derived.compiled.model.as_ref();
        let (derivative, jacobian) = operations(&model.expect("the chain is right").scenes[0]);
        let sum = derived.lexing + derived.compiling + derived.emitting + derived.printing;
        longest = sum;
        table.row([
            links.to_string(),
            format!("{:.4}", derived.lexing),
            format!("{:.3}", derived.compiling),
            format!("{:.3}", derived.emitting),
            format!("{:.3}", derived.printing),
            format!("{sum:.3}"),
            number(Some(derivative as f64)),
            number(Some(jacobian as f64)),
            number(Some(derived.bytes as f64)),
        ]);
    }
    table.print();
    let word = if longest < GOAL { "pass" } else { "FAIL" };
    println!("- the longest chain: {longest:.2} s (goal {GOAL} s) {word}");
}
