//! Random expressions: the normal form, simplification, substitution and derivatives keep their values.

use super::{Expression, Function, Graph, Map, Relation, X, Y, Z, check_close, slope, value};

/// A small generator of numbers that are the same every time.
struct Dice(u64);

impl Dice {
    /// A number below `limit`. Multiplier and increment are Knuth's.
    fn roll(&mut self, limit: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}

const POINTS: [[f64; 3]; 3] = [[0.3, 0.7, 1.1], [1.4, 0.2, 0.6], [0.9, 1.7, 0.4]];

/// A random expression with its values at the points, computed beside it without the graph's rules. Functions are
/// applied where they exist and are smooth.
fn grow(graph: &mut Graph, dice: &mut Dice, depth: usize) -> (Expression, [f64; 3]) {
    if depth == 0 || dice.roll(6) == 0 {
        let column = dice.roll(4) as usize;
        if column == 3 {
            let number = [-2.0, -1.0, 0.0, 0.5, 1.0, 3.0][dice.roll(6) as usize];
            return (graph.number(number), [number; 3]);
        }
        return (graph.symbol([X, Y, Z][column]), POINTS.map(|point| point[column]));
    }
    let (a, p) = grow(graph, dice, depth - 1);
    let pair = |q: [f64; 3], combine: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|index| combine(p[index], q[index]))
    };
    match dice.roll(12) {
        0..=2 => {
            let (b, q) = grow(graph, dice, depth - 1);
            (graph.add(a, b), pair(q, |x, y| x + y))
        }
        3 => {
            let (b, q) = grow(graph, dice, depth - 1);
            (graph.sub(a, b), pair(q, |x, y| x - y))
        }
        4..=5 => {
            let (b, q) = grow(graph, dice, depth - 1);
            (graph.mul(a, b), pair(q, |x, y| x * y))
        }
        6 => {
            // Divided by 2 + b², which is never zero.
            let (b, q) = grow(graph, dice, depth - 1);
            let (square, two) = (graph.powi(b, 2), graph.number(2.0));
            let divisor = graph.sum(&[square, two]);
            (graph.div(a, divisor), pair(q, |x, y| x / (2.0 + y * y)))
        }
        7 => (graph.powi(a, 2), p.map(|x| x * x)),
        8 => {
            let (square, one) = (graph.powi(a, 2), graph.one());
            let sum = graph.add(one, square);
            (graph.sqrt(sum), p.map(|x| (1.0 + x * x).sqrt()))
        }
        9 => {
            let (b, q) = grow(graph, dice, depth - 1);
            let condition = graph.compare(Relation::Less, a, b);
            (graph.select(condition, a, b), pair(q, f64::min))
        }
        _ => {
            let bounded = [
                Function::Sin,
                Function::Cos,
                Function::Tanh,
                Function::Atan,
                Function::Erf,
                Function::Abs,
            ];
            let function = bounded[dice.roll(6) as usize];
            (graph.call(function, &[a]), p.map(|x| function.apply(&[x])))
        }
    }
}

/// Values of some size whose neighbourhood is harmless.
fn tame(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite() && value.abs() < 1e4)
}

#[track_caller]
fn check_values(graph: &Graph, root: Expression, expected: [f64; 3], what: &str) {
    for (point, expected) in POINTS.iter().zip(expected) {
        check_close(value(graph, root, *point), expected, what);
    }
}

#[test]
fn values_are_kept() {
    let mut dice = Dice(1);
    let mut tested = 0;
    for round in 0..3000 {
        let mut graph = Graph::new();
        let (root, expected) = grow(&mut graph, &mut dice, 6);
        if !tame(&expected) {
            continue;
        }
        tested += 1;
        check_values(&graph, root, expected, &format!("normal form {round}"));
        let simple = graph.simplify(&[root], 1)[0];
        check_values(&graph, simple, expected, &format!("simplified {round}"));
        let again = graph.simplify(&[simple], 1)[0];
        check_values(&graph, again, expected, &format!("simplified twice {round}"));
    }
    assert!(tested > 2000, "{tested}");
}

#[test]
fn substituting_and_evaluating_is_evaluating_elsewhere() {
    let mut dice = Dice(2);
    for round in 0..1000 {
        let mut graph = Graph::new();
        let (root, _) = grow(&mut graph, &mut dice, 5);
        let (inner, values) = grow(&mut graph, &mut dice, 3);
        let replaced = graph.substitute(&[root], &Map::from_iter([(X, inner)]))[0];
        for (point, x) in POINTS.iter().zip(values) {
            let expected = value(&graph, root, [x, point[1], point[2]]);
            if tame(&[expected]) {
                check_close(
                    value(&graph, replaced, *point),
                    expected,
                    &format!("substituted {round}"),
                );
            }
        }
    }
}

#[test]
fn gradient_and_tangent_agree_with_each_other_and_with_differences() {
    let mut dice = Dice(3);
    let mut compared = 0;
    for round in 0..1000 {
        let mut graph = Graph::new();
        let (root, expected) = grow(&mut graph, &mut dice, 5);
        let one = graph.one();
        let gradient = graph.gradient(&[(root, one)], &[X, Y, Z]);
        for (index, symbol) in [X, Y, Z].into_iter().enumerate() {
            let tangent = graph.tangent(&[root], &Map::from_iter([(symbol, one)]))[0];
            let simple = graph.simplify(&[tangent], 1)[0];
            for point in POINTS {
                let (forward, backward) =
                    (value(&graph, tangent, point), value(&graph, gradient[index], point));
                if !tame(&expected) || !tame(&[forward]) {
                    continue;
                }
                check_close(backward, forward, &format!("gradient {round}"));
                check_close(
                    value(&graph, simple, point),
                    forward,
                    &format!("simplified tangent {round}"),
                );
                let along = |moved: f64| {
                    let mut other = point;
                    other[index] = moved;
                    value(&graph, root, other)
                };
                // Only where the function is smooth: two ways to take the difference agree.
                let (near, far) = (
                    (along(point[index] + 1e-6) - along(point[index] - 1e-6)) / 2e-6,
                    slope(along, point[index]),
                );
                if (near - far).abs() < 1e-5 * (1.0 + far.abs()) {
                    compared += 1;
                    assert!(
                        (forward - far).abs() < 1e-5 * (1.0 + far.abs()),
                        "difference {round}: {forward} and {far}"
                    );
                }
            }
        }
    }
    assert!(compared > 3000, "{compared}");
}

#[test]
fn a_derivative_along_several_symbols_is_their_sum() {
    let mut dice = Dice(4);
    for round in 0..300 {
        let mut graph = Graph::new();
        let (root, expected) = grow(&mut graph, &mut dice, 5);
        let (two, three) = (graph.number(2.0), graph.number(3.0));
        let along = graph.tangent(&[root], &Map::from_iter([(X, two), (Z, three)]))[0];
        let one = graph.one();
        let gradient = graph.gradient(&[(root, one)], &[X, Z]);
        for point in POINTS {
            let expected_slope =
                2.0 * value(&graph, gradient[0], point) + 3.0 * value(&graph, gradient[1], point);
            if tame(&expected) && tame(&[expected_slope]) {
                check_close(value(&graph, along, point), expected_slope, &format!("{round}"));
            }
        }
    }
}
