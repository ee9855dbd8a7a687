//! The command `assur` for the mechanisms of this crate.

use std::process::ExitCode;

fn main() -> ExitCode {
    assur_cli::main(assur_equations::REGISTRY)
}
