//! What a method costs and what it gives: ten revolutions of the batten from rest, the relative error of the state at the end
//! beside the time, by DOP853 and by Taylor series.
//!
//!     cargo run --release --example methods

use assur::ode;
use assur::prelude::*;
use assur_equations::batten::{Elastic, Start};
use std::time::Instant;

/// Runs of which the fastest counts.
const RUNS: usize = 20;
/// Ten revolutions.
const TIMES: (f64, f64) = (0.0, 2.4);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("scene    rtol   method  steps   time, us  relative error");
    table("elastic", &Elastic::default())?;
    table("start", &Start::default())?;
    Ok(())
}

/// The rows of a scene.
fn table<C: Smooth>(name: &str, scene: &C) -> Result<(), ode::OdeError> {
    let rest = vec![0.0; scene.shape().states.len()];
    let run = |method, rtol| ode::march(scene, TIMES, &rest, &Settings::new(method).rtol(rtol));
    let exact = run(Method::Taylor, 1e-14)?;
    for rtol in [1e-6, 1e-9, 1e-12] {
        for method in [Method::Dop853, Method::Taylor] {
            let mut fastest = f64::INFINITY;
            for _ in 0..RUNS {
                let clock = Instant::now();
                std::hint::black_box(run(method, rtol)?);
                fastest = fastest.min(clock.elapsed().as_secs_f64());
            }
            let motion = run(method, rtol)?;
            let ends = motion.end().iter().zip(exact.end());
            let off = ends.map(|(one, other)| (one - other).abs());
            let error = off.fold(0.0, f64::max) / largest(exact.end());
            let (method, steps) = (format!("{method:?}"), motion.statistics.steps);
            let time = fastest * 1e6;
            println!("{name:<7}  {rtol:.0e}  {method:<6}  {steps:>5}  {time:>9.0}  {error:.1e}");
        }
    }
    Ok(())
}

fn largest(state: &[f64]) -> f64 {
    state.iter().fold(0.0, |most, one| most.max(one.abs()))
}
