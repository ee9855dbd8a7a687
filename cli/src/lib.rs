//! The command `assur` for any mechanisms: [`main`] is what a program of four lines calls with those of its own crate,
//! as `examples/own.rs` does.
//!
//! It knows no mechanism. Everything that it says about one comes from the registry or from an equation file.
//!
//! | exit code | meaning |
//! |---|---|
//! | 0 | done |
//! | 1 | the numbers did not come out: resonance, no convergence, a step that became too small |
//! | 2 | the request cannot be carried out as it stands: a wrong name, value, unit, file |
//! | 130 | interrupted; nothing is left half written |

mod arguments;
mod asked;
mod case;
mod check;
mod constants;
mod csv;
mod curves;
mod draw;
mod effects;
#[path = "../../macros/src/emit/mod.rs"]
mod emit;
mod error;
mod events;
mod expand;
mod json;
mod linkage;
mod list;
mod lookup;
mod measures;
mod modes;
mod motion;
mod multipliers;
mod number;
mod output;
mod permitted;
mod plot;
mod progress;
mod published;
mod report;
mod round;
mod run;
mod scenes;
mod settings;
mod source;
mod structure;
mod study;
mod style;
mod table;
mod text;
mod tolerance;
mod turn;
mod unclosed;
mod unfollowed;
mod unit;
mod values;
mod variables;

use std::process::ExitCode;

use arguments::{Arguments, Command};
use assur::registry::Mechanism;
use clap::Parser;
use lookup::Registry;

/// Does what the arguments of the process ask for, about these mechanisms, `REGISTRY` of
/// [`equations!`](assur::equations).
pub fn main(mechanisms: &'static [Mechanism]) -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(refused) => return refuse(&refused),
    };
    output::clean_up_on_interrupt();
    let registry = Registry(mechanisms);
    let outcome = match &arguments.command {
        Command::List => list::execute(registry),
        Command::Run(options) => run::execute(options, registry),
        Command::Draw(options) => draw::execute(options, registry),
        Command::Structure(options) => structure::execute(options, registry),
        Command::Check(options) => check::execute(options),
        Command::Expand(options) => expand::execute(options, registry),
        Command::Scenes(options) => scenes::execute(options, registry),
        Command::Modes(options) => modes::execute(options, registry),
        Command::Study(options) => study::execute(options, registry),
        Command::Tolerance(options) => tolerance::execute(options, registry),
    };
    ended(outcome)
}

/// The exit code, with why it is another one than 0.
fn ended(outcome: Result<(), error::Failure>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            output::complain(&failure.render(style::stderr()));
            ExitCode::from(failure.code())
        }
    }
}

/// Prints the help that is asked for, or why the arguments are not understood.
fn refuse(refused: &clap::Error) -> ExitCode {
    if !refused.use_stderr() {
        return ended(output::printed(refused.print()));
    }
    let text = match style::stderr().is_coloured() {
        true => refused.render().ansi().to_string(),
        false => refused.render().to_string(),
    };
    let lines: Vec<String> = text.lines().map(error::shortened).collect();
    output::complain(&(lines.join("\n") + "\n"));
    ExitCode::from(2)
}
