//! Derivatives against numbers, identities against numbers, and differences that must not cancel.

use super::function::{Function, Relation};
use super::graph::{Expression, Graph, Node, Symbol};
use super::hash::Map;

mod random;
mod stability;

const X: Symbol = Symbol::Parameter(0);
const Y: Symbol = Symbol::Parameter(1);
const Z: Symbol = Symbol::Parameter(2);

/// The value of an expression where the symbols have these values.
fn value(graph: &Graph, root: Expression, point: [f64; 3]) -> f64 {
    let given = |symbol| match symbol {
        X => point[0],
        Y => point[1],
        Z => point[2],
        _ => f64::NAN,
    };
    graph.evaluate(&[root], &given)[0]
}

/// The derivative of a function of one number by Ridders' extrapolation of central differences: to about 1e-11.
fn slope(function: impl Fn(f64) -> f64, x: f64) -> f64 {
    let mut step = 0.02_f64.min(x.abs() / 20.0 + 1e-4);
    let mut table: Vec<Vec<f64>> = Vec::new();
    for row in 0..7 {
        let mut next = vec![(function(x + step) - function(x - step)) / (2.0 * step)];
        for column in 1..=row {
            let weight = 4.0_f64.powi(column as i32);
            next.push((weight * next[column - 1] - table[row - 1][column - 1]) / (weight - 1.0));
        }
        table.push(next);
        step /= 2.0;
    }
    // The entry that differs least from its neighbours.
    let error = |row: usize, column: usize| {
        (table[row][column] - table[row][column - 1])
            .abs()
            .max((table[row][column] - table[row - 1][column - 1]).abs())
    };
    let places = (1..7).flat_map(|row| (1..=row).map(move |column| (row, column)));
    let (row, column) = places.min_by(|a, b| error(a.0, a.1).total_cmp(&error(b.0, b.1))).unwrap();
    table[row][column]
}

/// Every function of one argument with points of its domain.
const UNARY: &[(Function, &[f64])] = &[
    (Function::Sin, &[-2.0, 0.3, 1.0]),
    (Function::Cos, &[-2.0, 0.3, 1.0]),
    (Function::Tan, &[-1.0, 0.3, 1.2]),
    (Function::Asin, &[-0.8, 0.1, 0.6]),
    (Function::Acos, &[-0.8, 0.1, 0.6]),
    (Function::Atan, &[-3.0, 0.1, 0.9]),
    (Function::Sinh, &[-2.0, 0.3, 1.0]),
    (Function::Cosh, &[-2.0, 0.3, 1.0]),
    (Function::Tanh, &[-1.0, 0.3, 2.0]),
    (Function::Exp, &[-2.0, 0.3, 1.0]),
    (Function::ExpM1, &[-2.0, 0.3, 1.0]),
    (Function::Ln, &[0.2, 1.0, 30.0]),
    (Function::Ln1p, &[-0.5, 0.3, 30.0]),
    (Function::Log10, &[0.2, 1.0, 30.0]),
    (Function::Sqrt, &[0.2, 1.0, 30.0]),
    (Function::Erf, &[-1.5, 0.0, 0.3, 2.5]),
    (Function::NormalCdf, &[-3.0, 0.0, 0.3, 2.5]),
    (Function::Floor, &[-1.5, 0.3, 2.7]),
    (Function::Abs, &[-1.5, 0.3]),
    (Function::Sign, &[-1.5, 0.3]),
];

/// Every function of two arguments with points of its domain.
const BINARY: &[(Function, &[(f64, f64)])] = &[
    (Function::Atan2, &[(0.3, 1.2), (-0.4, -2.0), (1.5, -0.2)]),
    (Function::Hypot, &[(3.0, 4.0), (-0.2, 0.5)]),
    (Function::Max, &[(1.0, 2.0), (2.0, 1.0)]),
    (Function::Min, &[(1.0, 2.0), (2.0, 1.0)]),
    (Function::Power, &[(2.0, 0.5), (0.3, -1.7), (4.0, 3.0)]),
];

#[track_caller]
fn check_close(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() <= 1e-9 * (1.0 + expected.abs()),
        "{what}: {found} instead of {expected}"
    );
}

#[test]
fn every_function_of_one_number_has_its_derivative() {
    for (function, points) in UNARY {
        let mut graph = Graph::new();
        let x = graph.symbol(X);
        let call = graph.call(*function, &[x]);
        let one = graph.one();
        let derivative = graph.tangent(&[call], &Map::from_iter([(X, one)]))[0];
        for x in *points {
            assert!(
                (value(&graph, call, [*x, 0.0, 0.0]) - function.apply(&[*x])).abs() < 1e-15,
                "{function:?} at {x}"
            );
            let found = value(&graph, derivative, [*x, 0.0, 0.0]);
            check_close(
                found,
                slope(|x| function.apply(&[x]), *x),
                &format!("{function:?} at {x}"),
            );
        }
    }
}

#[test]
fn every_function_of_two_numbers_has_its_derivatives() {
    for (function, points) in BINARY {
        let mut graph = Graph::new();
        let (x, y) = (graph.symbol(X), graph.symbol(Y));
        let call = graph.call(*function, &[x, y]);
        let one = graph.one();
        let gradient = graph.gradient(&[(call, one)], &[X, Y]);
        for (x, y) in *points {
            let point = [*x, *y, 0.0];
            let by_x = slope(|x| function.apply(&[x, *y]), *x);
            let by_y = slope(|y| function.apply(&[*x, y]), *y);
            check_close(
                value(&graph, gradient[0], point),
                by_x,
                &format!("{function:?} by the first at {point:?}"),
            );
            check_close(
                value(&graph, gradient[1], point),
                by_y,
                &format!("{function:?} by the second at {point:?}"),
            );
        }
    }
}

/// The slope of a branch that does not hold is no number beyond its domain, and counts for nothing there.
#[test]
fn a_branch_that_does_not_hold_has_no_slope() {
    let mut graph = Graph::new();
    let (x, y) = (graph.symbol(X), graph.symbol(Y));
    let (one, two) = (graph.one(), graph.number(2.0));
    let inside = graph.compare(Relation::Less, x, one);
    let arc = graph.call(Function::Acos, &[x]);
    let product = graph.mul(arc, y);
    let branch = graph.select(inside, product, two);
    let gradient = graph.gradient(&[(branch, two)], &[X, Y]);
    let at = |graph: &Graph, x: f64| [0, 1].map(|i| value(graph, gradient[i], [x, 3.0, 0.0]));
    assert_eq!(at(&graph, 1.5), [0.0, 0.0]);
    let [by_x, by_y] = at(&graph, 0.5);
    check_close(by_x, -6.0 / 0.75f64.sqrt(), "by x");
    check_close(by_y, 2.0 * 0.5f64.acos(), "by y");
}

#[test]
fn all_functions_are_tested() {
    let tested = UNARY.iter().map(|one| one.0).chain(BINARY.iter().map(|one| one.0));
    // The last variant of the enumeration is `Ln1p`.
    assert_eq!(tested.collect::<std::collections::HashSet<_>>().len(), Function::Ln1p as usize + 1);
}

#[test]
fn products_powers_and_branches_have_their_derivatives() {
    let mut graph = Graph::new();
    let (x, y, z) = (graph.symbol(X), graph.symbol(Y), graph.symbol(Z));
    let product = graph.product(&[x, y, z, x]);
    let quotient = graph.div(x, y);
    let power = graph.pow(x, y);
    let root = graph.sqrt(z);
    let less = graph.compare(Relation::Less, x, y);
    let branch = graph.select(less, product, quotient);
    let total = graph.sum(&[product, quotient, power, root, branch]);
    let one = graph.one();
    let gradient = graph.gradient(&[(total, one)], &[X, Y, Z]);
    for point in [[0.7, 1.3, 2.1], [1.9, 0.4, 0.3]] {
        for (index, symbol) in gradient.iter().enumerate() {
            let along = |moved: f64| {
                let mut other = point;
                other[index] = moved;
                value(&graph, total, other)
            };
            check_close(
                value(&graph, *symbol, point),
                slope(along, point[index]),
                &format!("{index} at {point:?}"),
            );
        }
    }
}

/// The derivative of a solution is that of the system: small ones are written out, large ones are operations.
#[test]
fn solutions_have_their_derivatives() {
    for size in 1..=6_usize {
        let mut graph = Graph::new();
        let (x, y) = (graph.symbol(X), graph.symbol(Y));
        let mut lower = Vec::new();
        for row in 0..size {
            for column in 0..=row {
                let share = graph.number(if row == column { 4.0 + row as f64 } else { 0.0 });
                let angle = graph.scale((1 + row + 2 * column) as f64, x);
                let sine = graph.call(Function::Sin, &[angle]);
                lower.push(graph.sum(&[share, sine]));
            }
        }
        let right: Vec<_> = (0..size).map(|row| graph.powi(y, row as i32 + 1)).collect();
        let solution = graph.solve_symmetric(&lower, &right);
        let one = graph.one();
        let point = [0.4, 0.8, 0.0];
        // The solution solves the system.
        for row in 0..size {
            let products: Vec<_> = (0..size)
                .map(|column| lower[row.max(column) * (row.max(column) + 1) / 2 + row.min(column)])
                .zip(&solution)
                .map(|(entry, element)| graph.mul(entry, *element))
                .collect();
            let left = graph.sum(&products);
            check_close(
                value(&graph, left, point),
                value(&graph, right[row], point),
                &format!("row {row} of {size}"),
            );
        }
        for (row, element) in solution.iter().enumerate() {
            let forward = [X, Y]
                .map(|symbol| graph.tangent(&[*element], &Map::from_iter([(symbol, one)]))[0]);
            let backward = graph.gradient(&[(*element, one)], &[X, Y]);
            for index in 0..2 {
                let along = |moved: f64| {
                    let mut other = point;
                    other[index] = moved;
                    value(&graph, *element, other)
                };
                let expected = slope(along, point[index]);
                check_close(
                    value(&graph, forward[index], point),
                    expected,
                    &format!("forward, {row} of {size}"),
                );
                check_close(
                    value(&graph, backward[index], point),
                    expected,
                    &format!("backward, {row} of {size}"),
                );
            }
        }
    }
}

#[test]
fn equal_expressions_have_equal_handles() {
    let mut graph = Graph::new();
    let (x, y) = (graph.symbol(X), graph.symbol(Y));
    let (a, b) = (graph.add(x, y), graph.add(y, x));
    assert_eq!(a, b);
    assert_eq!(graph.sub(a, b), graph.zero());
    assert_eq!(graph.div(a, b), graph.one());
    let twice = graph.add(x, x);
    assert_eq!(twice, graph.scale(2.0, x));
    let square = graph.mul(x, x);
    assert_eq!(square, graph.powi(x, 2));
    let root = graph.sqrt(square);
    assert!(matches!(graph.node(root), Node::Call(Function::Abs, _)), "√(x²) is |x|");
}

#[test]
fn substitution_is_simultaneous_and_leaves_the_rest_alone() {
    let mut graph = Graph::new();
    let (x, y, z) = (graph.symbol(X), graph.symbol(Y), graph.symbol(Z));
    let quotient = graph.div(x, y);
    let untouched = graph.call(Function::Sin, &[z]);
    let total = graph.sum(&[quotient, untouched]);
    // x and y change places.
    let swapped = graph.substitute(&[total, untouched], &Map::from_iter([(X, y), (Y, x)]));
    let expected = graph.div(y, x);
    assert_eq!(swapped, [graph.sum(&[expected, untouched]), untouched]);
    let (two, zero) = (graph.number(2.0), graph.zero());
    let fixed = graph.substitute(&swapped, &Map::from_iter([(X, two), (Y, two), (Z, zero)]));
    assert_eq!(graph.as_number(fixed[0]), Some(1.0));
}
