//! The tableaus against the order conditions of all rooted trees (Hairer, Nørsett, Wanner, theorem II.2.13), and
//! measured orders.

use super::super::Explicit::{Dop853, Tsit5};
use super::super::{Explicit, Options, Row, Tableau};
use super::{end, march};

/// A rooted tree: its branches, as numbers of trees listed before it.
struct Tree {
    order: usize,
    branches: Vec<usize>,
    density: f64,
}

/// All rooted trees up to an order.
fn trees(order: usize) -> Vec<Tree> {
    let mut all: Vec<Tree> = Vec::new();
    for size in 1..=order {
        let mut found = Vec::new();
        choose(&all, size - 1, all.len(), &mut Vec::new(), &mut found);
        for branches in found {
            let density =
                size as f64 * branches.iter().map(|&branch| all[branch].density).product::<f64>();
            all.push(Tree { order: size, branches, density });
        }
    }
    all
}

/// All sets of trees with `size` knots in total, each at most number `limit - 1`.
fn choose(
    all: &[Tree],
    size: usize,
    limit: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if size == 0 {
        found.push(chosen.clone());
    }
    for number in (0..limit).filter(|&number| all[number].order <= size) {
        chosen.push(number);
        choose(all, size - all[number].order, number + 1, chosen, found);
        chosen.pop();
    }
}

/// The rows of all slopes of a method.
fn rows(method: &Tableau) -> Vec<Row> {
    let mut rows: Vec<Row> = vec![&[]];
    rows.extend(method.rows);
    rows.push(method.weights);
    rows.extend(method.extra_rows);
    rows
}

/// For each tree the elementary weights of all stages.
fn stage_weights(rows: &[Row], trees: &[Tree]) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = Vec::new();
    for tree in trees {
        let branch = |number: usize, stage: usize| {
            rows[stage].iter().map(|&(j, a)| a * all[number][j]).sum::<f64>()
        };
        let weights = (0..rows.len())
            .map(|stage| tree.branches.iter().map(|&number| branch(number, stage)).product())
            .collect();
        all.push(weights);
    }
    all
}

/// Largest violation of the conditions up to an order.
fn violation(weights: &[f64], trees: &[Tree], stages: &[Vec<f64>], order: usize, part: f64) -> f64 {
    let conditions = trees.iter().zip(stages).filter(|(tree, _)| tree.order <= order);
    let error = |(tree, stages): (&Tree, &Vec<f64>)| {
        let sum: f64 = weights.iter().zip(stages).map(|(weight, stage)| weight * stage).sum();
        (sum - part.powi(tree.order as i32) / tree.density).abs()
    };
    conditions.map(error).fold(0.0, f64::max)
}

/// A row with its zeros.
fn full(row: Row, slopes: usize) -> Vec<f64> {
    let mut full = vec![0.0; slopes];
    for &(number, value) in row {
        full[number] = value;
    }
    full
}

/// The weights `b(θ)` of the continuous solution.
fn dense_weights(method: &Tableau, part: f64) -> Vec<f64> {
    let slopes = rows(method).len();
    let change = full(method.weights, slopes);
    let mut polynomial = vec![change.clone(), vec![0.0; slopes], vec![0.0; slopes]];
    for slope in 0..slopes {
        let begin = if slope == 0 { 1.0 } else { 0.0 };
        let end = if slope == method.stages { 1.0 } else { 0.0 };
        polynomial[1][slope] = begin - change[slope];
        polynomial[2][slope] = 2.0 * change[slope] - begin - end;
    }
    polynomial.extend(method.dense_rows.iter().map(|row| full(row, slopes)));
    let mut sum = vec![0.0; slopes];
    for (number, row) in polynomial.iter().enumerate().rev() {
        let factor = if number % 2 == 0 { part } else { 1.0 - part };
        for (sum, value) in sum.iter_mut().zip(row) {
            *sum = (*sum + value) * factor;
        }
    }
    sum
}

/// Checks row sums, order of the step and order of the continuous solution.
fn check_tableau(method: Explicit, dense_order: usize) {
    let method = method.tableau();
    let rows = rows(method);
    let mut nodes = vec![0.0];
    nodes.extend(method.nodes);
    nodes.push(1.0);
    nodes.extend(method.extra_nodes);
    assert_eq!(nodes.len(), rows.len());
    for (row, node) in rows.iter().zip(&nodes) {
        let sum: f64 = row.iter().map(|(_, value)| value).sum();
        assert!((sum - node).abs() < 1e-14, "{sum} {node}");
    }
    assert_eq!(method.nodes[method.stages - 2], 1.0);
    let trees = trees(method.order + 1);
    let stages = stage_weights(&rows, &trees);
    let weights = full(method.weights, rows.len());
    // Coefficients of up to 13 that cancel, rounded to 16 digits, do not permit less.
    let error = violation(&weights, &trees, &stages, method.order, 1.0);
    assert!(error < 2e-14, "{error:e}");
    assert!(violation(&weights, &trees, &stages, method.order + 1, 1.0) > 1e-8);
    for part in [0.1, 0.25, 0.5, 0.77, 0.95, 1.0] {
        let weights = dense_weights(method, part);
        let error = violation(&weights, &trees, &stages, dense_order, part);
        assert!(error < 2e-14, "{part} {error:e}");
    }
    let error = violation(&dense_weights(method, 0.5), &trees, &stages, dense_order + 1, 0.5);
    assert!(error > 1e-8, "{error:e}");
    // The error estimates vanish for the orders below that of the embedded solution.
    let error = full(method.error, rows.len());
    for (tree, stages) in trees.iter().zip(&stages).filter(|(tree, _)| tree.order <= 4) {
        let sum: f64 = error.iter().zip(stages).map(|(weight, stage)| weight * stage).sum();
        assert!(sum.abs() < 2e-14, "order {} {sum:e}", tree.order);
    }
}

#[test]
fn there_are_as_many_trees_as_published() {
    let trees = trees(8);
    let counts: Vec<usize> =
        (1..=8).map(|order| trees.iter().filter(|tree| tree.order == order).count()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn tsit5_meets_the_order_conditions() {
    check_tableau(Tsit5, 4);
}

#[test]
fn dop853_meets_the_order_conditions() {
    check_tableau(Dop853, 7);
}

/// A pendulum whose support is shaken.
fn pendulum(time: f64, [angle, speed]: [f64; 2]) -> [f64; 2] {
    let torque = -(1.0 + 0.5 * (2.0 * time).cos()) * angle.sin() - 0.1 * speed;
    [speed, torque]
}

/// Distance of two states.
fn distance(first: &[f64], second: &[f64]) -> f64 {
    (first[0] - second[0]).hypot(first[1] - second[1])
}

/// Errors at the end and within steps, for equal steps of two lengths, as measured orders.
fn measured_orders(method: Explicit, span: f64, steps: f64) -> (f64, f64) {
    let fixed = |steps: f64| Options { fixed_step: Some(span / steps), ..Options::default() };
    let exact = march(Dop853, pendulum, (0.0, span), [1.0, 0.3], &fixed(1000.0)).unwrap();
    let errors = |steps: f64| {
        let end = end(method, pendulum, (0.0, span), [1.0, 0.3], &fixed(steps));
        let motion = march(method, pendulum, (0.0, span), [1.0, 0.3], &fixed(steps)).unwrap();
        assert_eq!(motion.statistics.steps, steps as usize);
        let error = |time: f64| distance(&motion.at(time), &exact.at(time));
        // Within the first step the error is that of the interpolant, one order above its own.
        let inside = (1..20)
            .map(|number| error(f64::from(number) / 20.0 * span / steps))
            .fold(0.0, f64::max);
        (distance(&end, exact.end()), inside)
    };
    let (coarse, fine) = (errors(steps), errors(2.0 * steps));
    ((coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2())
}

#[test]
fn measured_orders_are_the_stated_ones() {
    // Tsitouras made the leading error terms small: over longer motions the measured order is nearer 6.
    let (step, dense) = measured_orders(Tsit5, 1.0, 32.0);
    assert!((step - 5.0).abs() < 0.3, "{step}");
    assert!((dense - 5.0).abs() < 0.3, "{dense}");
    let (step, dense) = measured_orders(Dop853, 3.0, 16.0);
    assert!((step - 8.0).abs() < 0.3, "{step}");
    assert!((dense - 8.0).abs() < 0.3, "{dense}");
}
