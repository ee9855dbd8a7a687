//! The transition of the straight path between the straight part and the plate: which one presses most at its least?
//!
//! Without separation the force depends linearly on the three numbers of the shape, so its smallest value is a concave
//! function of them: a shape that no neighbour betters is the best of all.

use super::foot::{Drive, Foot::*};

/// Of a fall from 1 to 0; the numbers of the file are bounded by this.
const BOUND: f64 = 6.0;
const SPEED: f64 = 300.0;

/// Slope of the transition, by the part of its angle.
fn slope([p1, p2, p3]: [f64; 3], u: f64) -> f64 {
    // In powers of u.
    let [q1, q2, q3] = [p1 - p2 + p3, 2.0 * p2 - 6.0 * p3, 6.0 * p3];
    let bump = 2.0 * q1 * u + 3.0 * (q2 - q1) * u.powi(2) + 4.0 * (q3 - q2) * u.powi(3);
    4.0 * u.powi(3) - 6.0 * u.powi(2) + bump - 5.0 * q3 * u.powi(4)
}

/// Whether the rack falls all the way, and the numbers are within their bounds.
fn is_allowed(shape: [f64; 3]) -> bool {
    let falls = (1..=200).all(|k| slope(shape, f64::from(k) / 200.0) <= 0.0);
    falls && shape.iter().all(|q| q.abs() <= BOUND)
}

/// Smallest force of the working stroke, in N; nothing for what is not allowed.
fn smallest(shape: [f64; 3]) -> f64 {
    match is_allowed(shape) {
        true => Shaped(shape).outcome(Drive::at(SPEED)).smallest,
        false => f64::NEG_INFINITY,
    }
}

/// Three directions at right angles, others each time: a ridge that one set cannot climb another one can.
fn directions(number: u32) -> [[f64; 3]; 3] {
    // A quaternion of irrational turns.
    let angle = |step: f64| (f64::from(number) * step).fract() * std::f64::consts::TAU;
    let (a, b, c) = (angle(0.754_877_666), angle(0.569_840_290), angle(0.618_033_989));
    let [x, y, z, w] = [a.cos() * c.cos(), a.sin() * c.cos(), b.cos() * c.sin(), b.sin() * c.sin()];
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
        [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
        [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// Goes uphill as long as there is a way up: in the direction that led up last, then in others, with steps that grow
/// where there is one and shrink where there is none.
fn search() -> ([f64; 3], f64, u32) {
    let (mut shape, mut step, mut tried) = ([0.0; 3], 1.0, 0);
    let (mut best, mut last) = (smallest(shape), [1.0, 0.0, 0.0]);
    let mut number = 0;
    while step > 1e-4 {
        let around = directions(number);
        number += 1;
        let mirrored = around.into_iter().flat_map(|one| [one, one.map(|x| -x)]);
        let found = std::iter::once(last).chain(mirrored).find_map(|one| {
            let next: [f64; 3] = std::array::from_fn(|i| shape[i] + step * one[i]);
            tried += 1;
            let value = smallest(next);
            (value > best).then_some((next, value, one))
        });
        match found {
            Some(better) => {
                (shape, best, last) = better;
                step *= 1.5;
            }
            // No set of directions sees all: it shrinks slowly.
            None => step *= 0.9,
        }
    }
    (shape, best, tried)
}

/// The shape that presses most at its least, against that of the file and the ellipse of the same rise.
pub fn transition() {
    let (shape, best, tried) = search();
    println!(
        "\nsmallest force on the working stroke at {SPEED} 1/s, rise 0.5 mm, straight during 60 degrees"
    );
    let ellipse = Ellipse(0.5).outcome(Drive::at(SPEED)).smallest;
    let before = smallest([0.0; 3]);
    println!("{:44}{before:7.3} N", "transition without jumps (q = 0)");
    println!("{:44}{ellipse:7.3} N", "ellipse of the same rise");
    let [q1, q2, q3] = shape;
    let text = format!("best transition, q = {q1:.3}, {q2:.3}, {q3:.3}");
    println!("{text:44}{best:7.3} N, after {tried} trials");
    let slopes = [0.1, 0.25, 0.5, 0.75, 1.0].map(|u| format!("{:7.2}", slope(shape, u)));
    println!("  its slope at 0.1, 0.25, 0.5, 0.75 and all of the way:{}", slopes.concat());
    for omega in [200.0, 250.0, 350.0, 400.0] {
        let [one, other] = [[0.0; 3], shape].map(|q| Shaped(q).outcome(Drive::at(omega)).smallest);
        println!("  at {omega} 1/s {other:7.3} N, before {one:.3} N");
    }
    // A linear programme, tests/reference/presser_foot.json, has 14.97084 N.
    assert!((best - 14.97084).abs() < 0.01 && best > ellipse && ellipse > before);
    assert!(shape.iter().all(|q| q.abs() < BOUND), "no bound is reached");
}
