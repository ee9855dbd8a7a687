//! The command `assur` for any mechanisms: [`main`] is what a program of four lines calls with those of its own crate,
//! as `examples/own.rs` does.
//!
//! It knows no mechanism. Everything that it says about one comes from the registry or from an equation file.
//!
//! A request is read (`ask`), answered by the module of its subcommand, and shown in the format that is asked for
//! (`answer`, which is the way of every request; `show` and `plot`). What `run` says of scenes stands in `motion` and
//! `linkage`.
//!
//! | exit code | meaning |
//! |---|---|
//! | 0 | done |
//! | 1 | the numbers did not come out: resonance, no convergence, a step that became too small |
//! | 2 | the request cannot be carried out as it stands: a wrong name, value, unit, file |
//! | 130 | interrupted; nothing is left half written |

mod answer;
mod arguments;
mod ask;
mod check;
mod cost;
mod draw;
mod error;
mod expand;
mod gallery;
mod linkage;
mod list;
mod modes;
mod motion;
mod new;
mod plot;
mod published;
mod run;
mod scenes;
mod schema;
mod show;
mod source;
mod structure;
mod study;
mod synth;
mod test;
mod tolerance;
mod watch;

use std::error::Error;
use std::process::ExitCode;

use arguments::{Arguments, Command};
use ask::lookup::Registry;
use assur::registry::Mechanism;
use clap::Parser;
use clap::error::{ContextKind, ContextValue};
use show::{output, style};

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
        Command::List(options) => list::execute(options, registry),
        Command::Run(options) => run::execute(options, registry),
        Command::New(options) => new::execute(options),
        Command::Cost(options) => cost::execute(options, registry),
        Command::Draw(options) => draw::execute(options, registry),
        Command::Structure(options) => structure::execute(options, registry),
        Command::Check(options) => check::execute(options),
        Command::Test(options) => test::execute(options, registry),
        Command::Gallery(options) => gallery::execute(options, registry),
        Command::Expand(options) => expand::execute(options, registry),
        Command::Scenes(options) => scenes::execute(options, registry),
        Command::Modes(options) => modes::execute(options, registry),
        Command::Study(options) => study::execute(options, registry),
        Command::Synth(options) => synth::execute(options, registry),
        Command::Tolerance(options) => tolerance::execute(options, registry),
        Command::Schema(options) => schema::execute(options),
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
    let given = |kind| match refused.get(kind) {
        Some(ContextValue::String(text)) => text.as_str(),
        _ => "",
    };
    let failure = refused.source().and_then(|source| source.downcast_ref::<error::Failure>());
    if let Some(failure) = failure {
        let option = given(ContextKind::InvalidArg).split(' ').next().unwrap_or_default();
        let place = format!("{option} {}", given(ContextKind::InvalidValue));
        return ended(Err(failure.clone().place(place)));
    }
    let text = match style::stderr().is_coloured() {
        true => refused.render().ansi().to_string(),
        false => refused.render().to_string(),
    };
    let lines: Vec<String> = text.lines().map(error::shortened).collect();
    output::complain(&(lines.join("\n") + "\n"));
    ExitCode::from(2)
}
