//! The whole command for mechanisms of one's own: `cargo run --example own -- run swing`.

use std::process::ExitCode;

assur::equations! {
    "swing.eqn",
}

fn main() -> ExitCode {
    assur_cli::main(REGISTRY)
}
