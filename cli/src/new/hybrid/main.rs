//! Name: `cargo run` shows some numbers of it, `cargo test` runs the tests that its equations bring along.

use assur::prelude::*;
use mechanism::Fall;

assur::equations! { "mechanism.eqn" }

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let motion = Fall::default().ask().run()?;
    println!("h after 1 s: {:.4} mm", 1e3 * motion.value("h", 1.0)?);
    Ok(())
}
