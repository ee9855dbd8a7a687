//! Masses that the time alone changes: their matrix is factored at each evaluation, since its factors are no numbers that an
//! instant could keep.

use assur::prelude::*;
use nalgebra::{Matrix4, Vector4};

assur::mechanism! {
    /// Four masses with a full mass matrix of the time.
    Coupled from "made up";
    parameter m = 2 kg, w = 5 [1/s], k = 100 [N/m];
    coordinate a: m = 10 mm, b: m = 20 mm, c: m = -30 mm, d: m = 40 mm;
    kinetic m*(1 + sin(w*time)/20)*dot(a)^2/2 + m*dot(b)^2/2 + m*(2 + cos(w*time))*dot(c)^2/2 + m*dot(d)^2/2;
    kinetic m*cos(w*time)*(dot(a)*dot(b)/13 + dot(a)*dot(c)/14 + dot(a)*dot(d)/15);
    kinetic m*sin(w*time)*(dot(b)*dot(c)/15 + dot(b)*dot(d)/16 + dot(c)*dot(d)/17);
    potential k*(a^2 + b^2 + c^2 + d^2)/2;
    output a;
    scene go { run time 0 s .. 2 s; }
}

/// The mass matrix at a time, or its time derivative.
fn masses(time: f64, is_rate: bool) -> Matrix4<f64> {
    let (m, w) = (2.0, 5.0);
    let (sin, cos) = (w * time).sin_cos();
    let (one, sin, cos) = match is_rate {
        true => (0.0, w * cos, -w * sin),
        false => (1.0, sin, cos),
    };
    let beside = [cos / 13.0, cos / 14.0, cos / 15.0, sin / 15.0, sin / 16.0, sin / 17.0];
    let [ab, ac, ad, bc, bd, cd] = beside;
    let (a, c) = (one + sin / 20.0, 2.0 * one + cos);
    m * Matrix4::new(a, ab, ac, ad, ab, one, bc, bd, ac, bc, c, cd, ad, bd, cd, one)
}

/// `M q'' + M' q' = -k q`, against a general solver.
#[test]
fn masses_of_the_time_are_factored() {
    let equations = Go::default().prepare::<f64>();
    let state = [0.01, 0.02, -0.03, 0.04, 0.5, -0.4, 0.3, 0.2];
    let place = Vector4::from_row_slice(&state[..4]);
    let speed = Vector4::from_row_slice(&state[4..]);
    for time in [0.0, 0.3, 1.7] {
        let mut row = vec![0.0; equations.instant()];
        equations.instants(Phase::of(0), &[time], &mut row);
        let mut rates = [0.0; 8];
        equations.rates(Phase::of(0), &row, &state, &mut rates);
        let force = -100.0 * place - masses(time, true) * speed;
        let expected = masses(time, false).lu().solve(&force).expect("a regular matrix");
        let off = (Vector4::from_row_slice(&rates[4..]) - expected).amax();
        assert!(off < 1e-13 * expected.amax(), "{off:e}");
    }
}
