//! Four coupled coordinates: the mass matrix is factored, its solution is read by outputs too.

use super::{check, outputs, rate};
use assur::problem::{Phase, Reports, Scene};

assur::mechanism! {
    /// Four links that hang on each other, each with its mass at its end.
    Chain from "any textbook";
    dimension l = 0.5 m;
    parameter m = 1.5 kg, g = 9.81 [m/s^2];
    coordinate a: rad = 0.3, b: rad = 0.2, c: rad = 0.1, d: rad = 0;
    let p1 = l*dir(a);
    let p2 = p1 + l*dir(b);
    let p3 = p2 + l*dir(c);
    let p4 = p3 + l*dir(d);
    kinetic m*(inner(dot(p1), dot(p1)) + inner(dot(p2), dot(p2)) + inner(dot(p3), dot(p3)) + inner(dot(p4), dot(p4)))/2;
    potential -m*g*l*(4*cos(a) + 3*cos(b) + 2*cos(c) + cos(d));
    output ddot(a), ddot(d);
    scene fall { run time 0 s .. 0.5 s; }
}

/// Mass matrix and forces by hand: entry i, j is m l² times the number of masses that both links carry.
fn residual(state: &[f64], rate: &[f64]) -> Vec<f64> {
    let (m, g, l) = (1.5, 9.81, 0.5);
    let carried = |link: usize| (4 - link) as f64;
    let row = |i: usize| {
        let inertia = |j: usize| {
            let angle = state[i] - state[j];
            let speed = state[4 + j];
            carried(i.max(j)) * (angle.cos() * rate[4 + j] + angle.sin() * speed * speed)
        };
        let sum: f64 = (0..4).map(inertia).sum();
        m * l * l * sum + m * g * l * carried(i) * state[i].sin()
    };
    (0..4).map(row).collect()
}

#[test]
fn the_accelerations_balance() {
    let state = [0.3, -0.7, 1.1, 2.0, 0.4, -1.0, 0.3, 2.0];
    let rate = rate::<Fall>(0.0, &state);
    check(&rate[..4], &state[4..]);
    for force in residual(&state, &rate) {
        assert!(force.abs() < 1e-11, "{force}");
    }
    check(&outputs::<Fall>(0.0, &state), &[rate[4], rate[7]]);
}

#[test]
fn the_mass_matrix_is_symmetric() {
    let equations = Fall::default().prepare::<f64>();
    let (state, mut mass) = ([0.3, -0.7, 1.1, 2.0, 0.0, 0.0, 0.0, 0.0], [f64::NAN; 16]);
    assert!(equations.mass(Phase::of(0), 0.0, &state, &mut mass));
    let matrix = mass.as_chunks::<4>().0;
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert_eq!(*entry, matrix[j][i]);
        }
    }
    check(&[matrix[0][0], matrix[3][3]], &[1.5, 0.375]);
}
