//! Written equations of which more than a few are coupled in their highest derivatives, with zeros on the diagonal.

use super::{check, rate};

/// A mechanism, and its text for the evaluator.
macro_rules! both {
    ($($token:tt)*) => {
        assur::mechanism! { $($token)* }
        const TEXT: &str = stringify!($($token)*);
    };
}

both! {
    DoublePendulum from "any textbook";
    parameter m = 2 kg, n = 3 kg, g = 9.81 [m/s^2];
    coordinate x: m = 1 m, y: m = 0 m, u: m = 1 m, v: m = -2 m;
    state p: [N s/m] = 0, q: [N s/m] = 0;
    let r = u - x;
    let s = v - y;
    motion upper: [m*ddot(x), m*ddot(y)] = [0, -m*g] - dot(p)*[x, y] + dot(q)*[r, s];
    motion lower: [n*ddot(u), n*ddot(v)] = [0, -n*g] - dot(q)*[r, s];
    motion arm: ddot(x^2 + y^2) = 0;
    motion rod: ddot(r^2 + s^2) = 0;
    output tension = dot(q)*norm([r, s]);
}

const STATE: [f64; 10] = [0.6, -0.8, 1.3, -1.5, 0.4, 0.3, -0.2, 1.1, 0.0, 0.0];

#[test]
fn all_equations_hold() {
    let rate = rate::<DoublePendulum>(0.0, &STATE);
    let [x, y, u, v, dx, dy, du, dv, ..] = STATE;
    let (r, s, dr, ds) = (u - x, v - y, du - dx, dv - dy);
    let [ax, ay, au, av, p, q] = rate[4..] else { panic!("{rate:?}") };
    check(
        &[2.0 * ax, 2.0 * ay + p * y, 3.0 * au, 3.0 * av],
        &[-p * x + q * r, -19.62 + q * s, -q * r, -29.43 - q * s],
    );
    check(&[x * ax + y * ay], &[-dx * dx - dy * dy]);
    check(&[r * (au - ax) + s * (av - ay)], &[-dr * dr - ds * ds]);
}

#[test]
fn the_evaluator_agrees() {
    let lexed = assur_model::lexer::lex_plain(TEXT).unwrap();
    let scene = assur_model::compile(&lexed.tokens).model.unwrap().scenes.remove(0);
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let computed = scene.program.evaluate(&values, 0.0, &STATE);
    let results = &scene.program.results;
    check(&rate::<DoublePendulum>(0.0, &STATE), &computed.all(&results.derivative));
    check(&super::outputs::<DoublePendulum>(0.0, &STATE), &computed.all(&results.outputs));
}

/// The Jacobian is that of differences: the solution is never differentiated, but solved for once more.
#[test]
fn the_jacobian_is_that_of_differences() {
    let lexed = assur_model::lexer::lex_plain(TEXT).unwrap();
    let scene = assur_model::compile(&lexed.tokens).model.unwrap().scenes.remove(0);
    let values: Vec<f64> = scene.constants.iter().map(|one| one.default).collect();
    let computed = scene.program.evaluate(&values, 0.0, &STATE);
    let step = 1e-5;
    for column in 0..8 {
        let at = |sign: f64| {
            let mut state = STATE;
            state[column] += sign * step;
            rate::<DoublePendulum>(0.0, &state)
        };
        let (above, below) = (at(1.0), at(-1.0));
        for row in 0..10 {
            let entries = scene.program.results.jacobian.iter();
            let mut entries =
                entries.filter(|entry| (entry.0, entry.1) == (row as u32, column as u32));
            let found = entries.next().map_or(0.0, |entry| computed.get(entry.2));
            let expected = (above[row] - below[row]) / (2.0 * step);
            assert!((found - expected).abs() < 1e-6, "{row} {column}: {found} {expected}");
        }
    }
}
