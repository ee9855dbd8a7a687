//! Name: `cargo run` shows some numbers of it, `cargo test` runs the tests that its equations bring along.

use assur::prelude::*;
use mechanism::Turn;

assur::equations! { "mechanism.eqn" }

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (phi, psi) in Turn::default().sweep(0.0..=6.2, 7)?.output("psi")? {
        println!("phi {:6.1} deg, psi {:8.3} deg", phi.to_degrees(), psi.to_degrees());
    }
    Ok(())
}
