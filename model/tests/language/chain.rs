//! Chains of pendulums: the motion against an independent computation, and how the operations grow.

use std::time::{Duration, Instant};

use assur_model::checked::SceneModel;
use assur_model::program::{OperationKind, Stage, Value, Values};

use super::compiled;

const MASS: f64 = 0.3;
const LENGTH: f64 = 0.25;
const GRAVITY: f64 = 9.81;

/// A chain of links with their masses at their ends, by its energies.
fn text(links: usize) -> String {
    format!(
        "Chain from \"the double pendulum, continued\";
        parameter m = {MASS} kg, l = {LENGTH} m, g = {GRAVITY} [m/s^2];
        let x[0] = 0 m, y[0] = 0 m;
        for k in 1..{links} {{
            coordinate q[k]: rad = 0.1;
            let x[k] = x[k - 1] + l*sin(q[k]);
            let y[k] = y[k - 1] - l*cos(q[k]);
            kinetic m*(dot(x[k])^2 + dot(y[k])^2)/2;
            potential m*g*y[k];
        }}
        output q[1];
        scene swing {{ run time 0 s .. 1 s; }}"
    )
}

#[track_caller]
fn chain(links: usize) -> SceneModel {
    let (mut compiled, _) = compiled(&text(links));
    assert!(compiled.diagnostics.is_empty(), "{:?}", compiled.diagnostics);
    compiled.model.as_mut().unwrap().scenes.remove(0)
}

/// Angles and speeds without symmetry.
fn state(links: usize) -> Vec<f64> {
    let angles = (0..links).map(|k| (1.7 * k as f64 + 0.4).sin());
    angles.chain((0..links).map(|k| 2.0 * (0.9 * k as f64 + 1.1).cos())).collect()
}

fn values(scene: &SceneModel, state: &[f64]) -> Values {
    let parameters: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    scene.program.evaluate(&parameters, 0.0, state)
}

/// Entry of the mass matrix: all links outside of both hang on both.
fn mass(links: usize, state: &[f64], i: usize, j: usize) -> f64 {
    (links - i.max(j)) as f64 * MASS * LENGTH * LENGTH * (state[i] - state[j]).cos()
}

/// Angular accelerations from `M·q'' + C·q'^2 + G = 0` by Gauss's elimination.
fn accelerations(links: usize, state: &[f64]) -> Vec<f64> {
    let mut rows: Vec<Vec<f64>> = (0..links)
        .map(|i| {
            let centrifugal: f64 = (0..links)
                .map(|j| {
                    let share = (links - i.max(j)) as f64 * MASS * LENGTH * LENGTH;
                    share * (state[i] - state[j]).sin() * state[links + j].powi(2)
                })
                .sum();
            let weight = (links - i) as f64 * MASS * GRAVITY * LENGTH * state[i].sin();
            (0..links).map(|j| mass(links, state, i, j)).chain([-centrifugal - weight]).collect()
        })
        .collect();
    for pivot in 0..links {
        let largest = (pivot..links)
            .max_by(|a, b| rows[*a][pivot].abs().total_cmp(&rows[*b][pivot].abs()))
            .unwrap();
        rows.swap(pivot, largest);
        for row in pivot + 1..links {
            let (above, below) = rows.split_at_mut(row);
            let (above, below) = (&above[pivot], &mut below[0]);
            let factor = below[pivot] / above[pivot];
            for (entry, eliminated) in below.iter_mut().zip(above) {
                *entry -= factor * eliminated;
            }
        }
    }
    let mut solution = vec![0.0; links];
    for row in (0..links).rev() {
        let known: f64 = (row + 1..links).map(|column| rows[row][column] * solution[column]).sum();
        solution[row] = (rows[row][links] - known) / rows[row][row];
    }
    solution
}

#[track_caller]
fn check_close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance * (1.0 + expected.abs()),
        "{what}: {found} instead of {expected}"
    );
}

#[test]
fn the_motion_is_that_of_the_mass_matrix() {
    for links in [1, 2, 3, 4, 10] {
        let scene = chain(links);
        let state = state(links);
        let all = values(&scene, &state);
        let results = &scene.program.results;
        let derivative = all.all(&results.derivative);
        let expected = accelerations(links, &state);
        for k in 0..links {
            assert_eq!(derivative[k], state[links + k]);
            check_close(
                derivative[links + k],
                expected[k],
                1e-10,
                &format!("acceleration {k} of {links}"),
            );
        }
        let matrix = all.all(&results.mass);
        let entries = (0..links).flat_map(|i| (0..=i).map(move |j| (i, j)));
        assert_eq!(matrix.len(), links * (links + 1) / 2);
        for ((i, j), found) in entries.zip(matrix) {
            check_close(
                found,
                mass(links, &state, i, j),
                1e-13,
                &format!("mass {i}, {j} of {links}"),
            );
        }
        let kinetic: f64 = (0..links)
            .flat_map(|i| (0..links).map(move |j| (i, j)))
            .map(|(i, j)| mass(links, &state, i, j) * state[links + i] * state[links + j] / 2.0)
            .sum();
        let potential: f64 = (0..links)
            .map(|k| -((links - k) as f64) * MASS * GRAVITY * LENGTH * state[k].cos())
            .sum();
        let energy = all.all(&results.energy);
        check_close(energy[0], kinetic, 1e-12, "kinetic energy");
        check_close(energy[1], potential, 1e-12, "potential energy");
        assert!(scene.conservative);
    }
}

#[test]
fn the_jacobian_is_that_of_differences() {
    for links in [1, 2, 5] {
        let scene = chain(links);
        let state = state(links);
        let results = &scene.program.results;
        let all = values(&scene, &state);
        for column in 0..2 * links {
            let moved = |step: f64| {
                let mut other = state.clone();
                other[column] += step;
                values(&scene, &other).all(&results.derivative)
            };
            let (above, below) = (moved(1e-6), moved(-1e-6));
            for row in 0..2 * links {
                let entries = results
                    .jacobian
                    .iter()
                    .filter(|entry| (entry.0 as usize, entry.1 as usize) == (row, column));
                let found: f64 = entries.map(|entry| all.get(entry.2)).sum();
                let expected = (above[row] - below[row]) / 2e-6;
                check_close(
                    found,
                    expected,
                    1e-6,
                    &format!("row {row}, column {column} of {links} links"),
                );
            }
        }
    }
}

/// Operations at every evaluation: of the whole derivative, of the forces, and of the mass matrix. The rest solves the
/// linear system.
fn counts(links: usize) -> [usize; 3] {
    let scene = chain(links);
    let program = &scene.program;
    let kind = |value: Value| &program.operations[value.0 as usize].kind;
    let OperationKind::Element { solution, .. } = kind(program.results.derivative[links]) else {
        panic!("no solution")
    };
    let OperationKind::Solve { factor, right } = kind(*solution) else { panic!("no solution") };
    let OperationKind::Factor { entries, .. } = kind(*factor) else { panic!("no factors") };
    [&program.results.derivative, right, entries].map(|values| program.count(values, Stage::State))
}

#[test]
fn the_operations_are_counted() {
    let (ten, thirty) = (counts(10), counts(30));
    assert_eq!((ten, thirty), ([1059, 167, 272], [14779, 507, 2612]));
    // Three times the links: three times the operations of the forces, nine times those of the matrix.
    assert!(thirty[1] <= 4 * ten[1] && thirty[2] <= 10 * ten[2]);
}

#[test]
fn a_long_chain_is_derived_in_good_time() {
    let start = Instant::now();
    let scene = chain(30);
    assert_eq!(scene.states.len(), 60);
    println!("30 links in {:?}", start.elapsed());
    assert!(start.elapsed() < Duration::from_secs(60), "{:?}", start.elapsed());
}
