//! The batten of a shuttle loom beats the weft up. A crank at each end of one shaft swings it through a connecting rod
//! and a sword; between the swords lies an elastic bar, and the shaft twists between its cranks, so that the brake side
//! lags behind the drive side. At 110° the batten runs into the locks: how, and how unequally?
//!
//! Published by G. S. Egodurov, B. I. Zangeev, N. A. Khabaeva for a loom AT120-7 at 250 revolutions per minute.
//!
//!     cargo run --example batten

use assur::prelude::*;
use assur_equations::batten::Elastic;
use std::f64::consts::TAU;

/// The angle of the crank, the quantity, its published value, and by how much the reconstructed masses may miss it.
const PUBLISHED: [(f64, &str, f64, f64); 9] = [
    (0.0, "dot(phi2)", 0.078796, 0.02),
    (0.0, "x3", -0.00037819, 0.01),
    (0.0, "x4", -0.00037682, 0.01),
    (1.9198, "phi2", -0.000758, 0.01),
    (1.9198, "dot(phi2)", -0.210545, 0.02),
    (1.9198, "x3", 0.09156517, 0.001),
    (1.9198, "dot(x3)", 2.0326885, 0.001),
    (1.9198, "x4", 0.09166565, 0.001),
    (1.9198, "dot(x4)", 2.0608894, 0.001),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let batten = Elastic::default();
    let settings = Settings::new(Method::Dop853).rtol(1e-10);
    let period = TAU / batten.n;
    let steady = batten.solve(&settings)?;

    println!(" crank      quantity      computed     published  deviation");
    for (angle, name, published, allowed) in PUBLISHED {
        let computed = steady.value(name, angle / batten.n)?;
        let deviation = computed / published - 1.0;
        println!(
            "{:4.0}°  {name:>12} {computed:13.8} {published:13.8}  {:+7.2} %",
            angle.to_degrees(),
            100.0 * deviation
        );
        assert!(deviation.abs() < allowed);
    }

    println!("\nFree motions neither grow nor die, so that no march from rest ever arrives:");
    for multiplier in steady.multipliers() {
        println!("  multiplier {multiplier}, modulus {:.9}", multiplier.modulus());
        assert!((multiplier.modulus() - 1.0).abs() < 1e-6);
    }
    let march = batten.from([0.0; 6]).until(100.0 * period).solve(&settings)?;
    let (after, steady) = (march.at(100.0 * period), steady.at(0.0));
    let [after, steady] = [after[Elastic::PHI2], steady[Elastic::PHI2]];
    println!("  lag after 100 revolutions {after:.6} rad, in the steady state {steady:.6} rad");
    assert!((after - steady).abs() > 1e-5);
    Ok(())
}
