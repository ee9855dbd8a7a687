//! Name: `cargo run` shows some numbers of it, `cargo test` runs the tests that its equations bring along.

use assur::prelude::*;
use mechanism::Turn;

assur::equations! { "mechanism.eqn" }

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (phi, torque) in Turn::default().sweep(0.0..=6.2, 7)?.output("T")? {
        println!("phi {:6.1} deg, T {torque:8.3} N m", phi.to_degrees());
    }
    Ok(())
}
